"""The exercises of lesson 5: the size of a table, a window with actions, and notes of the doors that were opened."""

import math
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from itertools import product
from types import MappingProxyType
from typing import Annotated, Any

import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.envs.memory_corridor import MemoryCorridor
from edugym_course.grading.agents import require_class
from edugym_course.grading.challenge import Challenge
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import mistake_that_fits
from edugym_course.grading.own_numbers import Own, use_your_own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given, number
from edugym_course.lessons.memory.exercises.rows import exercise_1 as exercise_1
from edugym_course.lessons.memory.notes import MISTAKES, Notes, right, strided
from edugym_course.lessons.memory.players import DISCOUNT, Rememberer
from edugym_course.lessons.memory.secret import SECRET_STEPS, secret_corridor

Shift = Annotated[
    int | None,
    Own(
        tuple(range(1, 64)),
        "Your table begins elsewhere. In your version the number of a row is that of the hint, with the digits from"
        " left to right, plus {shift}; after the last row it goes on with row 0. So the answer is the remainder by the"
        " number of rows.",
    ),
]


def exercise_2(answer: Any, seed: int, shift: Shift = None) -> str:
    """Check the class of a window with actions; any numbering of the rows will do, unless there is a shift."""
    require_class("MyWindow", answer)
    rng = np.random.default_rng(seed)
    pushes: list[tuple[Any, int, int, Any]] = []
    for k, n, m in ((4, 4, 3), (3, 3, 2), (2, 5, 4)):
        with student_code("MyWindow(...)"):
            made = answer(MemoryCorridor.create(m), k=k, n_observations=n, n_actions=m)
        for _ in range(4):
            window = _some_window(k, n, m, rng)
            while len(window) > 3 and np.array_equal(window[:-2], window[2:]):
                window = _some_window(k, n, m, rng)
            action, seen = int(rng.integers(m)), int(rng.integers(n))
            pushes.append((window, action, seen, _pushed(made, window, action, seen)))
    _compare_pushes(pushes)
    for k, n, m in ((2, 3, 2), (2, 2, 3), (3, 3, 2), (3, 2, 3)):
        _check_rows(answer(MemoryCorridor.create(m), k=k, n_observations=n, n_actions=m), k, n, m, shift)
    return "Right: the history includes the actions. See it race:"


def _some_window(k: int, n: int, m: int, rng: np.random.Generator) -> Any:
    """Make a window up: observations at even places, actions between them, and no two neighbours alike."""
    window = np.zeros(2 * k - 1, np.int64)
    window[::2], window[1::2] = rng.integers(n, size=k), rng.integers(m, size=k - 1)
    return window


PUSHES: Mapping[str, Callable[[Any, int, int], Any]] = MappingProxyType(
    {
        "the action comes before the observation that it leads to": lambda w, a, o: [*w[2:], o, a],
        "the latest ones stand at the end of the window, not at its beginning": lambda w, a, o: [a, o, *w[:-2]],
        "the latest ones stand at the *end* of the window": lambda w, a, o: [o, a, *w[:-2]],
        "nothing moves: the last two entries are overwritten, and the oldest ones stay for ever": lambda w, a, o: [
            *w[:-2],
            a,
            o,
        ],
        "nothing changes; does it return the old window?": lambda w, a, o: [*w],
        "the new action is missing; the old one stands in its place": lambda w, a, o: [*w[2:], w[-2], o],
        "the old observation stands where the new action should: the window moves by *two* entries": lambda w, a, o: [
            *w[2:],
            w[-1],
            o,
        ],
        "the new action is missing: 0 stands in its place": lambda w, a, o: [*w[2:], 0, o],
        "the new observation is missing: 0 stands in its place": lambda w, a, o: [*w[2:], a, 0],
        "the new observation is missing; the old one stands in its place": lambda w, a, o: [*w[2:], a, w[-1]],
        "it moves by one entry only; an action *and* an observation are new": lambda w, a, o: [*w[1:-1], a, o],
        "it moves the wrong way: the oldest ones should go": lambda w, a, o: [*np.roll(w, 2)[:-2], a, o],
        "only the observations move; the actions should move with them": lambda w, a, o: _only(w, a, o, 0),
        "only the actions move; the observations should move with them": lambda w, a, o: _only(w, a, o, 1),
        "everything else in the window is lost": lambda w, a, o: [0] * (len(w) - 2) + [a, o],
    }
)


def _only(window: Any, action: int, seen: int, start: int) -> Any:
    """Return a window in which every second entry moves."""
    moved = np.array(window)
    moved[start:-2:2] = window[start + 2 :: 2]
    moved[-2:] = action, seen
    return moved


def _pushed(made: Any, window: Any, action: int, seen: int) -> Any:
    """Return what a student's `push` gives: as many entries as before."""
    call, mine = _push(window, action, seen), window.copy()
    with student_code(call):
        found = made.push(mine, action, seen)
    given(call, found)
    if not np.array_equal(mine, window):
        raise WrongAnswer(
            f"{call} changes the window that it is given, which still belongs to the state before: make a new one, with"
            " window.copy() or np.concatenate"
        )
    told = f"{call} should give {_moved(window, action, seen)}, but gives"
    if not isinstance(found, np.ndarray | list | tuple):
        raise WrongAnswer(f"{told} {found!r}: the window is an array")
    entries = np.asarray(found)
    if entries.shape != window.shape:
        raise WrongAnswer(
            f"{told} {entries.tolist()}: the window should stay {len(window)} entries long, so two go and two come"
        )
    return found


def _push(window: Any, action: int, seen: int) -> str:
    return f"push({window.tolist()}, {action}, {seen})"


def _moved(window: Any, action: int, seen: int) -> list[int]:
    """Return the window that is right."""
    return [*window[2:].tolist(), action, seen]


def _compare_pushes(pushes: list[tuple[Any, int, int, Any]]) -> None:
    """Compare all windows with those that are right; a mistake is named if it explains them all."""
    why = mistake_that_fits(
        PUSHES,
        lambda rule: all(np.array_equal(rule(*case), mine) for *case, mine in pushes),
        otherwise="the first two entries should go, and action and observation come at the end",
    )
    for *case, found in pushes:
        call, right, entries = _push(*case), _moved(*case), np.asarray(found)
        if not np.array_equal(entries, right):
            raise WrongAnswer(f"{call} should give {right}, but gives {entries.tolist()}: {why}")
        if not isinstance(found, np.ndarray):
            raise WrongAnswer(f"{call} gives a {type(found).__name__}: give a NumPy array, as the window is one")
        if found.dtype.kind not in "iu" or found.dtype.itemsize < 4:  # rows have up to eight digits
            raise WrongAnswer(
                f"{call} gives {found.dtype} numbers, but whole numbers of 64 bits are needed, so start from"
                " window.copy(), or np.zeros(len(window), np.int64)"
            )


DIGITS = (
    "multiply by the number of values of the digit that you add, and then add it: n_observations at even indices,"
    " n_actions at odd ones"
)


ROWS: Mapping[str, Callable[[Any, int, int], int]] = MappingProxyType(
    {
        "the number starts from 1; start from 0": lambda w, n, m: _in_digits(w, n, m, start=1),
        "1 is added to the number: the rows begin with 0": lambda w, n, m: _in_digits(w, n, m) + 1,
        "the first entry counts twice: start from 0, or go on with the second": lambda w, n, m: _in_digits(
            w, n, m, start=int(w[0])
        ),
        "the last entry is left out: range(len(window)) goes through all of them": lambda w, n, m: _in_digits(
            w[:-1], n, m
        ),
        "the first entry is left out: indices begin with 0": lambda w, n, m: _in_digits(w[1:], m, n),
        "only the first entry counts: is the `return` inside the loop?": lambda w, n, m: int(w[0]),
        "only the last entry counts: is something overwritten in the loop?": lambda w, n, m: int(w[-1]),
        "that is the sum of the entries, which many windows share": lambda w, n, m: int(np.sum(w)),
        "each digit is multiplied as well: multiply the number so far, and add the digit after that": (
            lambda w, n, m: _in_digits(w, n, m, late=True)
        ),
        "the two numbers of values have changed places: n_observations belongs to even indices": (
            lambda w, n, m: _in_digits(w, m, n)
        ),
        "an action has n_actions values, not n_observations": lambda w, n, m: _in_digits(w, n, n),
        "an observation has n_observations values, not n_actions": lambda w, n, m: _in_digits(w, m, m),
        "the digits are those of a decimal number: 10 is no number of values here": lambda w, n, m: _in_digits(
            w, 10, 10
        ),
        "use self.n_observations and self.n_actions in place of 4 and 3: the check takes others": (
            lambda w, n, m: _in_digits(w, 4, 3)
        ),
    }
)
"""By sentence, what each mistake makes of a window with `n` observations and `m` actions."""


def _in_digits(entries: Any, even: int, odd: int, *, start: int = 0, late: bool = False) -> int:
    """Return the number with these digits, of so many values at even and at odd indices."""
    row = start
    for i, digit in enumerate(map(int, entries)):
        values = odd if i % 2 else even
        row = (row + digit) * values if late else row * values + digit
    return row


def _whole(call: str, found: Any) -> int:
    """Return a whole number as an int.

    Raises:
        WrongAnswer: it is something else, such as 2.0.
    """
    value = number(call, found)
    if not isinstance(found, int | np.integer):
        told = np.asarray(found).item()
        raise WrongAnswer(f"{call} should be a whole number, but is {told!r}: use `//` for `/`, and 0 for 0.0")
    return int(value)


def _check_rows(made: Any, k: int, n: int, m: int, shift: int | None) -> None:
    """Check that `row` numbers the windows: all numbers differ and fit the table, and begin with a shift, if any."""
    size, what = n**k * m ** (k - 1), f"with {n} observations and {m} actions"
    windows = [np.array(entries) for entries in product(*(range(m if i % 2 else n) for i in range(2 * k - 1)))]
    rows = [_row(made, window, what) for window in windows]
    why = mistake_that_fits(
        ROWS,
        lambda rule: all(rule(window, n, m) == row for window, row in zip(windows, rows, strict=True)),
        otherwise=DIGITS,
    )
    known: dict[int, list[int]] = {}
    for window, row in zip(windows, rows, strict=True):
        if not 0 <= row < size:
            raise WrongAnswer(
                f"row({window.tolist()}) {what} should be from 0 to {size - 1}, but is {row}: an observation is a digit"
                f" with {n} values and an action one with {m}; {why}"
            )
        other = known.setdefault(row, window.tolist())
        if other != window.tolist():
            if why == DIGITS and np.array_equal(other[::2], window[::2]):
                why = "they differ in an action only, so the action makes no difference to the row"
            raise WrongAnswer(
                f"row({other}) and row({window.tolist()}) are both {row} {what}, but different windows need different"
                f" rows: {why}"
            )
        expected = row if shift is None else (_in_digits(window, n, m) + shift) % size
        if row != expected:
            raise WrongAnswer(use_your_own(f"row({window.tolist()}) {what} should be {expected}, but is {row}"))


def _row(made: Any, window: Any, what: str) -> int:
    """Return the number that a student's `row` gives a window."""
    call, mine = f"row({window.tolist()}) {what}", window.copy()
    with student_code(call):
        found = made.row(mine)
    row = _whole(call, found)
    if not np.array_equal(mine, window):
        raise WrongAnswer(f"{call} changes the window that it is given, and that is still needed: only read it")
    return row


LONGEST = 45
"""The corridors up to length 44 take 990 steps."""


def _walk(n: int, rng: np.random.Generator, stride: int) -> Iterator[tuple[Any, int, int, int, int]]:
    """Yield the arguments of `update`, and the number of doors, on the right way through some corridors.

    The last is as long as any in an episode of 1 000 steps: what stops at a later place would pass the short ones.
    """
    doors = rng.integers(n, size=LONGEST).tolist()
    notes, place = np.full(1_001, n), 0
    for length in (1, 2, 3, 4, 5, LONGEST):
        for p in range(length):
            case = notes, place, doors[p] if p == length - 1 else n, doors[p], n
            yield case
            notes, place = strided(right, case, stride)


Stride = Annotated[
    int,
    Own(
        tuple(k for k in range(2, 65) if math.gcd(k, 1_001) == 1),
        "Your finger takes long strides: in your version the next place is {stride} lines further, not one, and after"
        " the last line the book begins again. So it is `(place + {stride}) % len(notes)`.",
    ),
]


def exercise_3(answer: Any, seed: int, stride: Stride = 1) -> str:
    """Check the class of a corridor with a notebook, in which the finger moves on by a stride."""
    require_class("Notebook", answer)
    rng = np.random.default_rng(seed)
    cases, outcomes = [], []
    for n in (3, 4, 6):
        with student_code("Notebook(...)"):
            made = answer(MemoryCorridor.create(n), num_doors=n)
        walk = [*_walk(n, rng, stride)]
        cases += walk
        outcomes += [_updated(made, *case) for case in walk]
    for case, (mine, place) in zip(cases, outcomes, strict=True):
        notes, expected = strided(right, case, stride)
        if place == expected and np.array_equal(mine, notes):
            continue
        why = mistake_that_fits(
            MISTAKES,
            lambda rule: all(map(partial(_agree, rule, stride), cases, outcomes)),
            otherwise=_half_that_is_wrong(cases, outcomes, stride),
        )
        at = int(np.flatnonzero(np.append(mine != notes, True))[0])  # the first line that is wrong, if any
        what = (
            f"should leave the notes {_short(notes, at)}, but leaves {_short(mine, at)}"
            if not np.array_equal(mine, notes)
            else f"should return {expected}, but returns {place}"
        )
        raise WrongAnswer(f"{_call(*case)} {what}: {why}")
    return "Right: with three doors a table of 16 rows is enough. See it race:"


def _half_that_is_wrong(cases: list[Any], outcomes: list[Notes], stride: int) -> str:
    """Return where to look: at the note, or at the next place, if the other one is right in all cases."""
    expected = [strided(right, case, stride) for case in cases]
    both = [*zip(expected, outcomes, strict=True)]
    if all(np.array_equal(mine[0], notes) for (notes, _), mine in both):
        return "what is noted is right. The next place is `place + 1`, or 0 if `seen` is a door"
    if all(mine[1] == place for (_, place), mine in both):
        return "the next place is right. The note is the door that was opened, `action`, at the index `place` alone"
    return "that is none of the usual mistakes, so follow this step by hand"


def _call(notes: Any, place: int, seen: int, action: int, n: int) -> str:
    marked = "no mark" if seen == n else "marked"
    call = f"update(notes, place={place}, seen={seen}, action={action})"
    return f"{call} with {n} doors ({marked}), notes {_short(notes, place)},"


def _short(notes: Any, line: int) -> str:
    """Show six lines of the notes: the first ones, or those around a line that is not among them."""
    if line < 6 or line >= len(notes):
        return "[" + ", ".join(str(int(note)) for note in notes[:6]) + ", ...]"
    shown = ", ".join(str(int(note)) for note in notes[line - 3 : line + 3])
    return f"[..., {shown}, ...] (from line {line - 3} on)"


def _updated(made: Any, notes: Any, place: int, seen: int, action: int, n: int) -> Notes:
    """Run a student's update on a copy of the notes."""
    mine, call = notes.copy(), _call(notes, place, seen, action, n)
    with student_code(call):
        found = made.update(mine, place, seen, action)
    if isinstance(found, np.ndarray) and found.ndim == 0:
        raise WrongAnswer(f"{call} should return a whole number, but returns an array: write int(...) around it")
    if isinstance(found, tuple | np.ndarray):
        raise WrongAnswer(
            f"{call} should return the next place alone, but returns a {type(found).__name__}; the notes are changed in"
            " place, so they need not be returned"
        )
    return mine, _whole(f"update(notes, {place}, {seen}, {action})", found)


def _agree(rule: Callable[..., Notes], stride: int, case: Any, outcome: Notes) -> bool:
    """Whether a rule gives the same in a case; one that would write outside of the notes does not."""
    try:
        notes, place = strided(rule, case, stride)
    except IndexError:
        return False
    return place == outcome[1] and np.array_equal(notes, outcome[0])


CHALLENGE = Challenge(
    environment=secret_corridor,
    parameters=MappingProxyType({}),
    n_steps=5_000,
    baselines=MappingProxyType(
        {"Q-learning": partial(QLearning.create, discount=DISCOUNT), "the lesson's notes": Rememberer.create}
    ),
    optimum=float(SECRET_STEPS),
    best_average=64.0,
    column="training_return",
    best_label="good play, on average",
)
"""The open challenge: the highest return of all training episodes in 5 000 steps, where marks are signs to be learned.

64 is the mean, over 1 000 runs, of an agent that notes its doors and knows that it should repeat them, and that never
tries a door for a sign that is already known to be another one.
"""
