"""The update of lesson 5's notebook, right and with the usual mistakes. All are judged by exercise 3."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

Notes = tuple[Any, int]
MISTAKES: Mapping[str, Callable[[Any, int, int, int, int], Notes]] = MappingProxyType(
    {
        "it notes what was *seen*, and at an unmarked place that is no door: note the door that was opened": (
            lambda notes, place, seen, action, n: (_noted(notes, place, seen), place + 1 if seen == n else 0)
        ),
        "after the marked door the corridor starts again, so the next place is 0": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1)
        ),
        "the two cases have changed places: after a *marked* door the corridor starts again": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), 0 if seen == n else place + 1)
        ),
        "the next place is one further, place + 1, where no door is marked": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place if seen == n else 0)
        ),
        "the next place is always 0: compare what was *seen* with num_doors": lambda notes, place, seen, action, n: (
            _noted(notes, place, action),
            0,
        ),
        "the first place is 0, not 1": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if seen == n else 1)
        ),
        "the door belongs to the place where it was opened: write the note before you move on": (
            lambda notes, place, seen, action, n: _moved_first(notes, place, seen, action, n)
        ),
        "the door belongs to `notes[place]`, not to `notes[place + 1]`": (
            lambda notes, place, seen, action, n: (_noted(notes, place + 1, action), place + 1 if seen == n else 0)
        ),
        "the door belongs to `notes[place]`, not to `notes[place - 1]`": (
            lambda notes, place, seen, action, n: (_noted(notes, place - 1, action), place + 1 if seen == n else 0)
        ),
        "all notes are wiped out where the corridor starts again, and they are needed there": (
            lambda notes, place, seen, action, n: (
                (_noted(notes, place, action), place + 1)
                if seen == n
                else (np.full_like(_noted(notes, place, action), n), 0)
            )
        ),
        "the marked door is not noted: write every door into `notes[place]`, marked or not (with `=`, not `==`, and"
        " into `notes` itself, not into a copy)": (
            lambda notes, place, seen, action, n: (notes, place + 1 if seen == n else 0)
        ),
        "it notes the place instead of the door": (
            lambda notes, place, seen, action, n: (_noted(notes, place, place), place + 1 if seen == n else 0)
        ),
        "it writes the note to `notes[action]`; the index is the place": (
            lambda notes, place, seen, action, n: (_noted(notes, action, action), place + 1 if seen == n else 0)
        ),
        "it writes the note to `notes[seen]`; the index is the place": (
            lambda notes, place, seen, action, n: (_noted(notes, seen, action), place + 1 if seen == n else 0)
        ),
        "the present place is compared with the number of doors; compare what was *seen* with it": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if place == n else 0)
        ),
        "it writes the place to `notes[action]`: index and value have changed places": (
            lambda notes, place, seen, action, n: (_noted(notes, action, place), place + 1 if seen == n else 0)
        ),
        "it notes the door plus 1; doors count from 0, and N stands for nothing": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action + 1), place + 1 if seen == n else 0)
        ),
        "`if seen` is true for every door but 0; compare with self.num_doors": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if seen else 0)
        ),
        "`if seen` is true for every door but 0, and for no mark as well; compare with self.num_doors": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), 0 if seen else place + 1)
        ),
        "the finger stays at the marked place; there the corridor starts again, so the next place is 0": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if seen == n else place)
        ),
        "a corridor may be longer than its number of doors: no remainder is needed, a mark shows the last place": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), (place + 1) % n)
        ),
        "the first place is 0; −1 is the last line of an array": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if seen == n else -1)
        ),
        "doors are 0 to N - 1, and N itself is no mark: compare with self.num_doors, not with one less": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if seen == n - 1 else 0)
        ),
        "the other notes are wiped out, and they are still needed: write into `notes[place]` alone": (
            lambda notes, place, seen, action, n: (
                _noted(np.full_like(notes, n), place, action),
                place + 1 if seen == n else 0,
            )
        ),
        "the lines before the place are written as well: the index is the place alone": (
            lambda notes, place, seen, action, n: (
                np.where(np.arange(len(notes)) <= place, action, notes),
                place + 1 if seen == n else 0,
            )
        ),
        "all lines are written: the index is the place alone": (
            lambda notes, place, seen, action, n: (np.full_like(notes, action), place + 1 if seen == n else 0)
        ),
        "the door is added to the note that stands there: set it, with = and not with +=": (
            lambda notes, place, seen, action, n: (
                _noted(notes, place, notes[place] + action),
                place + 1 if seen == n else 0,
            )
        ),
        "that the next line is empty does not make this the last place: in a first walk it is empty everywhere. Only a"
        " mark tells": (
            lambda notes, place, seen, action, n: (
                _noted(notes, place, action),
                0 if notes[place + 1] == n else place + 1,
            )
        ),
        "the lines behind the place are written as well: the index is the place alone": (
            lambda notes, place, seen, action, n: (
                np.where(np.arange(len(notes)) >= place, action, notes),
                place + 1 if seen == n else 0,
            )
        ),
        "3 stands where self.num_doors should": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if seen == 3 else 0)
        ),
        "3 stands where self.num_doors should: where there are more doors, 3 is one of them": (
            lambda notes, place, seen, action, n: (_noted(notes, place, action), place + 1 if seen >= 3 else 0)
        ),
    }
)


def _noted(notes: Any, place: int, door: int) -> Any:
    """Return notes with one more door."""
    new = notes.copy()
    new[place] = door
    return new


def _moved_first(notes: Any, place: int, seen: int, action: int, n: int) -> Notes:
    """Move on, and then write."""
    place = place + 1 if seen == n else 0
    return _noted(notes, place, action), place


def right(notes: Any, place: int, seen: int, action: int, n: int) -> Notes:
    """Write the door, and move on."""
    return _noted(notes, place, action), place + 1 if seen == n else 0


def strided(rule: Callable[..., Notes], case: Any, stride: int) -> Notes:
    """Apply a rule to a case; where it moves on by a place, move on by a stride, after the last line anew."""
    notes, place, *_ = case
    after, then = rule(*case)
    return after, (place + stride) % len(notes) if then == place + 1 and stride != 1 else then
