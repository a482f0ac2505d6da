"""The riddles of the project of lesson 18: tiny tasks, each of which cannot be solved if one part of UCT is missing."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

from edugym.mdp.protocol import Random

DEPTH = 10
N_SIMULATIONS, FEW, N_ACTIONS = 400, 100, 3
ROOT, END = 0, -1
Step = tuple[float, int]
"""A reward and a next place; `END` for the end."""


class Riddle(NamedTuple):
    """A tiny task.

    Attributes:
        told: what it is like, for the sentence.
        why: what is missing in a program that does not solve it.
        step: says of a place, an action and a generator what follows: a reward and the next place.
        right: the actions from the root that are right.
        n_simulations: how many there are.
        luck: what one action gains once, near the end, that is not the most frequent one.
    """

    told: str
    why: str
    step: Callable[[int, int, Random], Step]
    right: tuple[int, ...] = (0,)
    n_simulations: int = N_SIMULATIONS
    luck: float = 0.0


def written(table: Mapping[int, tuple[Step, ...]]) -> Callable[[int, int, Random], Step]:
    """Return the steps of a task without chance, from what follows on each action in each place."""
    return lambda place, action, rng: table[place][action]


def line(first: float, last: float, length: int) -> dict[int, tuple[Step, ...]]:
    """Return places 1, 2, ... in a row, where all actions do the same: rewards of 0, but for the first and last."""
    rewards = [first, *[0.0] * (length - 2), last]
    return {
        place: ((reward, place + 1 if place < length else END),) * N_ACTIONS
        for place, reward in enumerate(rewards, start=1)
    }


def gamble(place: int, action: int, rng: Random) -> Step:
    """Pay 12 with probability 0.3 for action 0, and nothing else; 1 for any other."""
    return (12.0 if rng.random() < 0.3 else 0.0) if action == 0 else 1.0, END


def crossing(place: int, action: int, rng: Random) -> Step:
    """Lead from the root to one of two places by chance, for action 0; each place pays for another action."""
    if place == ROOT:
        return (0.0, int(rng.integers(1, 3))) if action == 0 else (7.0, END)
    return 10.0 if action == place - 1 else 4.0, END


def losses(place: int, action: int, rng: Random) -> Step:
    """Lose 6 by every action, and 5 by action 0."""
    return -5.0 if action == 0 else -6.0, END


def changing(place: int, action: int, rng: Random) -> Step:
    """Pay 1 for each action that is another than the one before, after action 0 from the root; 1.2 once for any other.

    Whoever rolls out by one action again and again gets at most 0.9.
    """
    if place == ROOT:
        return (0.0, 1) if action == 0 else (1.2, END)
    return float(action != place - 1), action + 1


BASICS = (
    "is the action with the highest value returned, and does an action that was never tried come first in its node, as"
    " if its bound were infinite? Is each reward in G, also in the tree?"
)
ROUND = Riddle(
    "two actions are nearly as good as the best one",
    "is the action in the end the one with the highest value, without the exploration term?",
    written({ROOT: ((10.0, END), (9.7, 1), (9.7, 1)), 1: ((0.0, 2),) * 3, 2: ((0.0, 1),) * 3}),  # round for ever
)
"""Here roll-outs are long, so that searches with other random numbers ask other things."""
ONE_PAYS_MOST = written({ROOT: ((90.0, END), (50.0, END), (50.0, END))})
RIDDLES = (
    Riddle(
        "every action gains, and one gains most",
        BASICS,
        ONE_PAYS_MOST,
    ),
    Riddle(
        "the best action seldom pays, but then much",
        "is there an exploration term, c √(ln N(node) / N(node, a)), and is a value the *mean* of all returns? Else one"
        " bad try is the last one",
        gamble,
    ),
    Riddle(
        "what follows the best action is good only if one goes on well",
        "it looks as if all later actions were random: in the tree, choose them by their upper bounds, too, and pass on"
        " the whole return, R + γ G, to the node before",
        written({ROOT: ((0.0, 1), (2.4, END), (2.4, END)), 1: ((10.0, END), (-3.0, END), (-3.0, END))}),
    ),
    Riddle(
        "what follows the best action is good only if one goes on well two steps later",
        "the tree has too few levels, or a return does not come back: does each simulation add a node, also below those"
        " that it has added before, and pass on R + γ G, and not R alone?",
        written(
            {ROOT: ((0.0, 1), (2.6, END), (2.6, END)), 1: ((0.0, 2),) * 3, 2: ((7.0, END), (0.0, END), (0.0, END))}
        ),
    ),
    Riddle(
        "chance says where the best action leads, and each place wants another action",
        "is a node a state with the way to it? After one action two states may follow, and each is a node of its own",
        crossing,
    ),
    Riddle(
        "one action pays most, and each is simulated once",
        "is the action with the highest *value* returned, and not the one that was simulated most often? Is the root in"
        " the tree from the start, so that the first simulation takes an action there?",
        ONE_PAYS_MOST,
        n_simulations=N_ACTIONS,
    ),
    Riddle(
        "two losses come before a gain",
        "do all rewards of a simulation count, those in the tree and those of the roll-out, and not only the last one?",
        written({ROOT: ((0.5, END), (-5.0, 1), (-5.0, 1)), **line(0.0, 20.0, 9), 8: ((-15.0, 9),) * N_ACTIONS}),
    ),
    ROUND,
    Riddle(
        "a larger reward comes eight steps later",
        "is what follows a step discounted by γ = 0.9, in the tree and in the roll-outs? (The shop has another γ.)",
        written({ROOT: ((10.0, END), (0.0, 1), (0.0, 1)), **line(0.0, 22.0, 8)}),
    ),
    Riddle(
        "a reward comes nine steps later that is worth waiting for",
        f"does each simulation look {DEPTH} steps ahead, with a roll-out after the tree, and is γ not below 0.9?",
        written({ROOT: ((0.0, 1), (8.0, END), (8.0, END)), **line(0.0, 22.0, 9)}),
    ),
    Riddle(
        "one action seldom pays much, and the others pay more on average",
        "is a value the *mean* of all returns, and not the highest of them?",
        lambda place, action, rng: (gamble(place, 0, rng)[0] if action == 0 else 6.0, END),
        (1, 2),
    ),
    Riddle(
        "each later action that differs from the one before is paid, and there is one simulation for each action",
        "is each action of a roll-out drawn anew?",
        changing,
        n_simulations=N_ACTIONS,
    ),
    Riddle(
        f"{FEW} simulations are too few to forget the bad tries after an action",
        "is the return of the simulation passed on to the node before, and not the highest value of the node after, and"
        " is c the same in every node?",
        written({ROOT: ((0.0, 1), (2.2, END), (2.2, END)), 1: ((3.0, END), (0.0, END), (0.0, END))}),
        (1, 2),
        FEW,
    ),
    Riddle(
        "all actions lose, and there are fewer simulations than actions",
        "an action that was not simulated from the root has no value: choose among those that were",
        losses,
        (0, 1, 2),
        N_ACTIONS - 1,
    ),
)
ENDLESS = Riddle(
    "", "", written({place: ((20.0, 1 + place % 2), (-20.0, END), (-20.0, END)) for place in (ROOT, 1, 2)})
)
"""The best action goes on for ever: a tree without a last step grows deeper than a simulation may look."""
ALIKE = Riddle("", "", lambda place, action, rng: (float(rng.random()), place + 1 if place + 1 < DEPTH else END))
"""All actions pay alike, and every simulation has all its steps."""
