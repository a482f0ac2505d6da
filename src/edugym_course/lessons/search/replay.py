"""Replay of the simulations of a program in a small tree, to see whether UCT would have taken the same actions.

In this task no state can be reached in two ways, so it does not matter by what a program knows its nodes. Nothing is
random but the roll-outs. So in every node of the tree it is known which action has the highest bound.
"""

from collections.abc import Sequence
from math import log
from typing import NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.lessons.search.exercises.riddles import END, N_ACTIONS, ROOT, Riddle, written

GAMMA, C = 0.9, 5.0
ROUNDING = 1e-6
"""Bounds that are as close as this count as equal."""
SIMULATIONS = 150
TABLE = {
    ROOT: ((0.0, 1), (0.3, 2), (0.1, 3)),
    1: ((0.0, 4), (1.1, 5), (4.3, END)),
    2: ((0.2, 6), (0.0, 7), (5.2, END)),
    3: ((6.1, END), (5.4, END), (2.3, END)),
    4: ((0.0, 8), (0.4, 9), (3.1, END)),
    5: ((7.3, END), (2.2, END), (0.7, END)),
    6: ((8.1, END), (1.3, END), (0.9, END)),
    7: ((6.6, END), (6.3, END), (0.2, END)),
    8: ((12.3, END), (0.5, END), (0.1, END)),
    9: ((5.7, END), (6.8, END), (0.6, END)),
}
TREE = Riddle("each state is reached in one way only", "", written(TABLE), n_simulations=SIMULATIONS)


def with_ends_worth(more: float, told: str, why: str) -> Riddle:
    """Return the same tree, where every end pays so much more."""
    table = {
        place: tuple((reward + more * (after == END), after) for reward, after in row) for place, row in TABLE.items()
    }
    return Riddle(told, why, written(table), n_simulations=SIMULATIONS)


FAR_OFF = (
    with_ends_worth(
        -60.0,
        "every return is far below 0",
        "does the search for the highest bound begin at 0? Begin it at −∞, or take `max`",
    ),
    with_ends_worth(
        5_000.0,
        "returns are in the thousands",
        "is an action that was never tried always taken first? Its bound is ∞, and not a large number",
    ),
)
"""Tasks in which the bounds of all actions are far from 0."""
Taken = tuple[int, int, float]
"""A step of a simulation: the place, the action, and the reward."""


class Rule(NamedTuple):
    """How a program may do it: as UCT, or with one mistake.

    Attributes:
        of_simulations: whether the logarithm is that of the number of the simulation, in every node.
        passes_mean: whether a node passes on its new mean, not the return of the simulation.
        from_root: whether the return at a node is discounted once more, by the steps from the root.
        adds_all: whether all states of the roll-out become nodes.
        counts_first: whether the first action of a roll-out counts in the new node.
        below: c below the root, over c.
    """

    of_simulations: bool = False
    passes_mean: bool = False
    from_root: bool = False
    adds_all: bool = False
    counts_first: bool = False
    below: float = 1.0


UCT = Rule()
RIGHT = (UCT, Rule(counts_first=True))
"""Both are right: who has made a node may take the first action in it."""
MISTAKES = {
    "in ln N(node), N(node) counts the choices in *this* node, and not all simulations": Rule(of_simulations=True),
    "what is passed on to the node before is the return of *this* simulation, and not the new mean of the node": Rule(
        passes_mean=True
    ),
    "in a node returns are discounted from this node on, and not once more from the root": Rule(from_root=True),
    "each simulation adds *one* node, and not every state of its roll-out": Rule(adds_all=True),
    "c is 5 below the root, too; it looks as if it were 10 there": Rule(below=2.0),
}
"""By mistake, how it is done with it."""


def surprises(simulations: Sequence[Sequence[Taken]], rule: Rule = UCT) -> list[int]:
    """Replay simulations, and return the numbers of those with a choice in the tree that the rule would not make.

    N(node) may count the present choice or not.
    """
    counts, values = {ROOT: np.zeros(N_ACTIONS)}, {ROOT: np.zeros(N_ACTIONS)}
    found = []
    for number, steps in enumerate(simulations, start=1):
        inside = 0
        while inside < len(steps) and steps[inside][0] in counts:
            place, action, _ = steps[inside]
            c = C * (rule.below if place != ROOT else 1.0)
            if not _fits(counts[place], values[place], action, c, number if rule.of_simulations else None):
                found.append(number)
            inside += 1
        for place, *_ in steps[inside:] if rule.adds_all else steps[inside : inside + 1]:
            counts[place], values[place] = np.zeros(N_ACTIONS), np.zeros(N_ACTIONS)
        G = 0.0
        for t, (place, action, reward) in reversed([*enumerate(steps)]):
            G = reward + GAMMA * G
            if t < inside + rule.counts_first or rule.adds_all:
                counts[place][action] += 1
                told = G * GAMMA**t if rule.from_root else G
                values[place][action] += (told - values[place][action]) / counts[place][action]
                G = float(values[place][action]) if rule.passes_mean else G
    return found


def _fits(n: Reals, Q: Reals, action: int, c: float, simulation: int | None) -> bool:
    """Whether an action has the highest bound in a node, or was never tried, where one was not."""
    if (n == 0).any():
        return bool(n[action] == 0)
    for total in (n.sum(), n.sum() + 1) if simulation is None else (simulation - 1, simulation):
        bounds = Q + c * np.sqrt(log(max(total, 1)) / n)
        if bounds[action] >= bounds.max() - ROUNDING:
            return True
    return False


def mistake_in(simulations: Sequence[Sequence[Taken]]) -> str | None:
    """Return which mistake explains every choice, "" if none does, and None if there is nothing to explain."""
    if not all(surprises(simulations, rule) for rule in RIGHT):
        return None
    return next((why for why, rule in MISTAKES.items() if not surprises(simulations, rule)), "")


def means(simulations: Sequence[Sequence[Taken]]) -> Reals:
    """Return the mean of the returns of each action from the root; −∞ where there is none."""
    returns: list[list[float]] = [[] for _ in range(N_ACTIONS)]
    for steps in simulations:
        returns[steps[0][1]].append(sum(GAMMA**t * reward for t, (*_, reward) in enumerate(steps)))
    return np.array([np.mean(one) if one else -np.inf for one in returns])
