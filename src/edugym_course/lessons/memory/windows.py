"""What a window of the last observations can tell: the laws, and the best play that a window allows, computed."""

from collections.abc import Iterator
from functools import cache
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.frame_stack import stack_size
from edugym.mdp.protocol import Reals

DOORS = 3
MOST_SEQUENCES = 20_000
"""How many sequences of doors are tried to find the best play with a window."""
LONGEST = 9
"""The longest corridor that is looked at for it."""


class Moment(NamedTuple):
    """A step of perfect play.

    Attributes:
        doors: the right doors, as far as they have been met.
        step: the number of the step, from 0.
    """

    doors: tuple[int, ...]
    step: int


class BestPlay(NamedTuple):
    """What the best policy that was found does with a window.

    Attributes:
        value: its expected return.
        through: the share of episodes in which it gets through corridor 1, 2, ...
    """

    value: float
    through: tuple[float, ...]


def perfect_play(doors: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    """Yield observation and right door at each step of perfect play, through the corridor with all these doors."""
    for length in range(1, len(doors) + 1):
        for position in range(length):
            yield (doors[position] if position == length - 1 else DOORS), doors[position]


def twins(k: int, length: int, actions: bool = False) -> tuple[Moment, Moment] | None:
    """Return two moments of perfect play that look the same in a window, and need different doors.

    Args:
        k: the number of observations in the window.
        length: perfect play goes through the corridor of this length.
        actions: whether the window also shows the actions between the observations.

    Returns:
        The first two that are found; None if there are none, so that the window is enough.
    """
    known: dict[Any, tuple[int, Moment]] = {}
    for doors in product(range(DOORS), repeat=length):
        seen, opened = [doors[0]] * (k - 1), [0] * (k - 1)  # as a stack starts
        for step, (observation, door) in enumerate(perfect_play(doors)):
            seen.append(observation)
            stack = (*seen[-k:], *opened[len(opened) - k + 1 :]) if actions else (*seen[-k:],)
            other, moment = known.setdefault(stack, (door, Moment(doors, step)))
            if other != door:
                return moment, Moment(doors, step)
            opened.append(door)
    return None


def is_enough(k: int, length: int, actions: bool = False) -> bool:
    """Whether a stack of k tells the right door at every step of perfect play through the corridor of this length."""
    return twins(k, length, actions) is None


def smallest_window(length: int, actions: bool = False) -> int:
    """Return the smallest stack that allows perfect play through the corridor of a length, by trying all doors."""
    k = 1
    while not is_enough(k, length, actions):
        k += 1
    return k


def window_law(length: int) -> int:
    """Return L(L-1)/2 + 1: the observations from the first mark to the first door of corridor L, and one."""
    return length * (length - 1) // 2 + 1


def action_law(length: int) -> int:
    """Return the window that is enough with the actions: the larger of L and 2L - 3.

    The right door was opened L - 1 steps ago, on the last walk. To look it up, the agent must also tell corridor L from
    L - 1, by the second last mark, which lies up to 2L - 4 steps back in corridor L - 1.
    """
    return max(length, 2 * length - 3)


def never_errs(k: int, actions: bool = False) -> int:
    """Return the longest corridor through which a window allows perfect play, by the law."""
    law = action_law if actions else window_law
    length = 1
    while law(length + 1) <= k:
        length += 1
    return length


def dense_table(k: int) -> int:
    """Return the bytes of a dense table of action values over stacks of k observations."""
    return 8 * DOORS * stack_size(DOORS + 1, k)


@cache
def best_play(k: int, actions: bool = False, num_doors: int = DOORS) -> BestPlay:
    """Return what the best policy does that looks at a window alone, and may err.

    All sequences of doors are played at once. An agent that has not erred yet has opened the right doors, so the window
    at each step is known. For every window the policy opens the door that adds most to the return, given what it does
    in all other windows; that is repeated until the return no longer grows. (No better policy was found. That there is
    none is not proved.)

    Args:
        k: the number of observations in the window.
        actions: whether it also shows the actions between them.
        num_doors: the number of doors at every place.
    """
    longest = max(n for n in range(1, LONGEST + 1) if num_doors**n <= MOST_SEQUENCES)
    doors = np.array([*product(range(num_doors), repeat=longest)])
    rows, right = _rows(doors, k, actions, num_doors)
    n, n_steps = right.shape
    n_rows = int(rows.max()) + 1
    alive, ahead, value = np.ones(right.shape), np.ones(right.shape), -1.0
    while True:
        gain = np.bincount((rows * num_doors + right).ravel(), (alive * ahead).ravel(), n_rows * num_doors)
        hits = gain.reshape(-1, num_doors).argmax(axis=1)[rows] == right
        alive = np.hstack([np.ones((n, 1)), np.cumprod(hits[:, :-1], axis=1)])
        last, value = value, float((alive * hits).sum() / n)
        if value <= last:
            break
        through = tuple(float((alive * hits)[:, i * (i + 1) // 2 - 1].mean()) for i in range(1, longest + 1))
        later = np.zeros(n)
        for t in range(n_steps - 1, -1, -1):  # what a right door is worth: 1, and what follows
            ahead[:, t] = 1.0 + later
            later = np.where(hits[:, t], ahead[:, t], 0.0)
        alive = np.maximum(alive, 1e-3)  # so that windows that are not reached are not forgotten
    return BestPlay(last, through)


def _rows(doors: Any, k: int, actions: bool, num_doors: int) -> tuple[Any, Any]:
    """Return the number of the window and the right door at every step, shape (n_sequences, n_steps)."""
    n, longest = doors.shape
    places = [(length, place) for length in range(1, longest + 1) for place in range(length)]
    right = doors[:, [place for _, place in places]]
    unmarked = np.array([place < length - 1 for length, place in places])
    seen = np.where(unmarked, num_doors, right)
    seen = np.hstack([np.repeat(seen[:, :1], k - 1, axis=1), seen])
    opened = np.hstack([np.zeros((n, k - 1), int), right])
    codes = np.zeros_like(right)
    for i in range(k):
        codes = codes * (num_doors + 1) + seen[:, i : i + len(places)]
        if actions and i < k - 1:
            codes = codes * num_doors + opened[:, i : i + len(places)]
    rows = np.unique(codes, return_inverse=True)[1].reshape(codes.shape)
    return rows, right


def best_values(windows: int, actions: bool = False) -> Reals:
    """Return the values of the best play for windows of 1, 2, ... observations."""
    return np.array([best_play(k, actions).value for k in range(1, windows + 1)])
