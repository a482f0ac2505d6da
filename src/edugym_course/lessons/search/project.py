"""The project of lesson 18: UCT, from a blank file.

A program is given the model as a function, which counts what is asked of it and knows what may be asked. It is set
riddles: tiny tasks, each of which cannot be solved if one part of the search is missing.
"""

from collections.abc import Callable, Mapping
from math import log, sqrt
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Integers, Random
from edugym_course.grading.agents import require_function
from edugym_course.grading.choices import action_of
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import NAME
from edugym_course.grading.student_code import student_code

DEPTH, RUNS = 10, 7
N_SIMULATIONS, FEW, N_ACTIONS = 400, 100, 3
ROOT, END = 0, -1
MOST_SLIPS = 1
"""How many of the runs of a riddle may go wrong: the search draws random numbers."""
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
    """

    told: str
    why: str
    step: Callable[[int, int, Random], Step]
    right: tuple[int, ...] = (0,)
    n_simulations: int = N_SIMULATIONS


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
    " if its bound were infinite?"
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
        "it looks as if all later actions were random: in the tree, choose them by their upper bounds, too",
        written({ROOT: ((0.0, 1), (2.4, END), (2.4, END)), 1: ((10.0, END), (-3.0, END), (-3.0, END))}),
    ),
    Riddle(
        "what follows the best action is good only if one goes on well two steps later",
        "the tree has too few levels: does each simulation add a node, also below those that it has added before?",
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
        "is the action with the highest *value* returned, and not the one that was simulated most often?",
        ONE_PAYS_MOST,
        n_simulations=N_ACTIONS,
    ),
    Riddle(
        "two losses come before a gain",
        "do all rewards of a simulation count, those in the tree and those of the roll-out, and not only the last one?",
        written({ROOT: ((1.0, END), (-5.0, 1), (-5.0, 1)), **line(-5.0, 9.0, 2)}),
        n_simulations=N_ACTIONS,
    ),
    ROUND,
    Riddle(
        "a larger reward comes eight steps later",
        "is what follows a step discounted by γ = 0.9, in the tree and in the roll-outs? (The shop has another γ.)",
        written({ROOT: ((10.0, END), (0.0, 1), (0.0, 1)), **line(0.0, 22.0, 8)}),
    ),
    Riddle(
        "a reward comes nine steps later that is worth waiting for",
        f"does each simulation look {DEPTH} steps ahead, roll-out included, and is γ not below 0.9?",
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
        "is the return of the simulation passed on to the node before, and not the highest value of the node after?",
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


BEFORE_COUNTS = 2
"""After so many riddles the simulations are counted: the others would blame the tree for a wrong bound."""
PAY = (10.0, 9.0, 5.0)
"""What the actions pay, for certain, in the task in which the simulations are counted."""
COUNTED = Riddle("every action ends the task", "", written({ROOT: tuple((reward, END) for reward in PAY)}))
BONUSES: Mapping[str, Callable[[float, float], float]] = {
    "c is 10, as in the shop; here it is 5": lambda of_node, n: 10 * sqrt(log(of_node) / n),
    "the logarithm is missing": lambda of_node, n: 5 * sqrt(of_node / n),
    "ln is the natural logarithm, not that of base 10": lambda of_node, n: 5 * sqrt(log(of_node, 10) / n),
    "some books have a 2 before the logarithm; here c takes its place": lambda of_node, n: (
        5 * sqrt(2 * log(of_node) / n)
    ),
    "c stands under the root; it is outside": lambda of_node, n: sqrt(5 * log(of_node) / n),
    "only the logarithm is under the root; N(node, a) belongs there, too": lambda of_node, n: (
        5 * sqrt(log(of_node)) / n
    ),
    "the root is missing": lambda of_node, n: 5 * log(of_node) / n,
}
"""By mistake, what it adds to a value, given N(node) and N(node, a)."""
NEAR = 2
"""How far the counts may be from those of the rule: equal bounds are in any order, and N(node) may count one more."""


class Model:
    """A model as a program sees it: a function of a state and an action, with states and actions in a new order.

    Attributes:
        from_root: how often each action was simulated from the root, by its number in the riddle.
        asked: all actions that it was asked for, in order.
        first: the action that was asked for first, by its number for the program; None at the beginning.
        slip: the sentence of the first thing that was refused, "" if there is none.
        n_simulations: how many there are to be; a few more in each run, so that it is not always the same one that a
            bonus would choose.
    """

    def __init__(self, riddle: Riddle, seed: int) -> None:
        """Deal out the numbers anew."""
        rng = np.random.default_rng([seed, 18])
        self.from_root = np.zeros(N_ACTIONS, int)
        self.asked: list[int] = []
        self.first: int | None = None
        self.slip = ""
        few = riddle.n_simulations < N_SIMULATIONS
        self.n_simulations = riddle.n_simulations + (0 if few else seed % RUNS)
        self._riddle, self._rng = riddle, rng
        self._numbers = rng.permutation(20).tolist()
        self._actions = rng.permutation(N_ACTIONS).tolist()
        self._here, self._steps = ROOT, 0

    def __call__(self, state: Any, action: Any) -> tuple[float, int, bool]:
        """Return what follows: the reward, the next state, and whether it is the end."""
        place = self._place(state)
        given = action_of("the action that is given to the model", action, N_ACTIONS)
        self.first, taken = given if self.first is None else self.first, self.meant(given)
        self.asked.append(taken)
        if place == ROOT:
            self._begin(taken)
        elif self._here == END:
            self._refuse(
                f"goes on after the end, from the state {state}: where the model says that it ends, the simulation is"
                " over"
            )
        elif place != self._here:
            self._refuse(
                f"asks for a step from the state {state}, but its simulation is in {self.number(self._here)}: go on"
                " from the state that the model gave"
            )
        if self._steps == DEPTH:
            self._refuse(f"simulates more than {DEPTH} steps in a row: each simulation looks {DEPTH} steps ahead")
        reward, following = self._riddle.step(place, taken, self._rng)
        self._here, self._steps = following, self._steps + 1
        return reward, self.number(following), following == END

    def number(self, place: int) -> int:
        """Return the number of a place."""
        return int(self._numbers[place])

    def meant(self, action: int) -> int:
        """Return what an action is in the riddle."""
        return int(self._actions[action])

    def _place(self, state: Any) -> int:
        if state not in self._numbers[-1:] + self._numbers[:10]:
            self._refuse(f"asks for a step from {state!r}, which is no state that the model gave")
        place = self._numbers.index(state)
        return END if place == len(self._numbers) - 1 else place

    def _begin(self, taken: int) -> None:
        self._here, self._steps = ROOT, 0
        self.from_root[taken] += 1
        if self.from_root.sum() > self.n_simulations:
            self._refuse(
                f"begins more than {self.n_simulations} simulations, which is n_simulations: a search is a loop"
                " of so many, each from the root"
            )

    def _refuse(self, what: str) -> Any:
        self.slip = self.slip or f"{NAME} {what}"
        raise WrongAnswer(self.slip)


class Found(NamedTuple):
    """What a search came to.

    Attributes:
        action: the action, by its number in the riddle.
        from_root: how often each was simulated from the root.
        asked: all actions that were simulated, in order.
        first: the first of them, by its number for the program.
    """

    action: int
    from_root: Integers
    asked: list[int]
    first: int | None


def search(program: Any, riddle: Riddle, seed: int) -> Found:
    """Let a program search.

    Raises:
        WrongAnswer: it breaks the contract, raises an error or does not end.
    """
    model = Model(riddle, seed)
    state = model.number(ROOT)
    call = f"{NAME}(model, {N_ACTIONS}, {state}, {model.n_simulations}, {seed})"
    try:
        with student_code(call):
            action = program(model, N_ACTIONS, state, model.n_simulations, seed)
    except WrongAnswer:
        if model.slip:
            raise WrongAnswer(model.slip) from None
        raise
    if model.slip:  # the program caught it, and went on
        raise WrongAnswer(model.slip)
    taken = model.meant(action_of(f"what {call} returns", action, N_ACTIONS))
    begun = int(model.from_root.sum())
    if begun < model.n_simulations:
        raise WrongAnswer(
            f"{call} simulates from the root {begun} times, and it should {model.n_simulations} times: a search is a"
            " loop of n_simulations, each from the root to its end"
        )
    return Found(taken, model.from_root, model.asked, model.first)


def solved(riddle: Riddle, found: Found) -> bool:
    """Whether the right action was chosen, and one that was simulated."""
    return found.action in riddle.right and found.from_root[found.action] > 0


def counts_by(bonus: Callable[[float, float], float], n_simulations: int) -> Integers:
    """Return how often each action of the counted task is simulated, if it is chosen by a value and a bonus."""
    counts = np.ones(N_ACTIONS, int)
    for of_node in range(N_ACTIONS, n_simulations):
        counts[np.argmax([pay + bonus(of_node, n) for pay, n in zip(PAY, counts, strict=True)])] += 1
    return counts


def require_bound(program: Any, seed: int) -> None:
    """Refuse a program that does not simulate the actions of the counted task as often as UCT does."""
    found = search(program, COUNTED, seed).from_root
    n = int(found.sum())
    right = counts_by(lambda of_node, n: 5 * sqrt(log(of_node) / n), n)
    if np.abs(found - right).max() <= NEAR:
        return
    fitting = (why for why, bonus in BONUSES.items() if np.abs(found - counts_by(bonus, n)).max() <= NEAR)
    otherwise = "is the action in a node the one with the highest Q(node, a) + 5 √(ln N(node) / N(node, a))?"
    why = "" if nobody_asks_why() else f": {next(fitting, otherwise)}"
    raise WrongAnswer(
        f"in a task in which {COUNTED.told}, with {', '.join(f'{pay:g}' for pay in PAY)}, the actions should be"
        f" simulated about {right.tolist()} times, but are {found.tolist()} times{why}"
    )


def require_repeatable(program: Any, seed: int) -> None:
    """Refuse a program that simulates something else with the same seed."""
    first, again = (search(program, ROUND, seed).asked for _ in range(2))
    if first != again:
        raise WrongAnswer(
            f"{NAME} does not repeat itself: two searches with seed {seed} simulate different actions. Draw every"
            " random number from rng = np.random.default_rng(seed)"
        )


def project_18(answer: Any, seed: int) -> str:
    """Check a program that searches: in every riddle it must find the right action, in nearly all runs."""
    require_function(NAME, answer, "model, n_actions, state, n_simulations and seed")
    begun = set()
    for number_of_riddle, riddle in enumerate(RIDDLES):
        if number_of_riddle == BEFORE_COUNTS:
            require_bound(answer, seed)
        runs = [search(answer, riddle, RUNS * seed + number) for number in range(RUNS)]
        right = sum(solved(riddle, found) for found in runs)
        begun |= {found.first for found in runs}
        if right < RUNS - MOST_SLIPS:
            why = "" if nobody_asks_why() else f": {riddle.why}"
            raise WrongAnswer(
                f"in a task in which {riddle.told}, it finds the right action in {right} of {RUNS} searches{why}"
            )
    if len(begun) == 1:
        raise WrongAnswer(
            f"{NAME} begins every search with the action {begun.pop()}, though none was tried yet: among equals draw"
            " one at random"
        )
    require_repeatable(answer, seed)
    return f"Right: it solves all {len(RIDDLES)} riddles, and asks of the model what a search may ask."
