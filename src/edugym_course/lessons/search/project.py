"""The project of lesson 18: UCT, from a blank file.

A program is given the model as a function, which counts what is asked of it and knows what may be asked. It is set
riddles: tiny tasks, each of which needs one part of the search.
"""

from collections.abc import Callable, Mapping
from math import log, sqrt
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Integers
from edugym_course.grading.agents import require_function
from edugym_course.grading.choices import action_of
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import NAME
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.search.exercises.riddles import (
    ALIKE,
    DEPTH,
    END,
    ENDLESS,
    N_ACTIONS,
    N_SIMULATIONS,
    RIDDLES,
    ROOT,
    ROUND,
    Riddle,
    written,
)
from edugym_course.lessons.search.replay import FAR_OFF, TREE, Taken, means, mistake_in, surprises

RUNS = 7
MOST_ALIKE = 0.2
"""The share of the simulations that may end with the same three actions; by chance it is about 0.06."""
FEWEST_DRAWN = 0.1
"""The smallest share of an action in these; by chance it is about 0.33."""
MOST_SLIPS = 1
"""How many of the runs of a riddle may go wrong: the search draws random numbers."""
BEFORE_COUNTS = 2
"""After so many riddles the simulations are counted: the others would blame the tree for a wrong bound."""
PAY = (10.0, 9.0, 5.0)
"""What the actions pay, for certain, in the task in which the simulations are counted."""
COUNTED = Riddle("every action ends the task", "", written({ROOT: tuple((reward, END) for reward in PAY)}))
LUCKY = COUNTED._replace(told="every action ends the task, and one has a very lucky return near the end", luck=1_000.0)
LATE = 12
"""Among so many of the last simulations is the lucky one: too few for its action to become the most frequent."""
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
    "the square root is missing": lambda of_node, n: 5 * log(of_node) / n,
}
"""By mistake, what it adds to a value, given N(node) and N(node, a)."""
NEAR = 2
"""How far the counts may be from those of the rule: equal bounds are in any order, and N(node) may count one more."""


class Model:
    """A model as a program sees it: a function of a state and an action, with states and actions in a new order.

    Attributes:
        from_root: how often each action was simulated from the root, by its number in the riddle.
        asked: all actions that it was asked for, in order.
        simulations: the steps of each simulation.
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
        self.simulations: list[list[Taken]] = []
        self.first: int | None = None
        self.slip = ""
        few = riddle.n_simulations < N_SIMULATIONS
        self.n_simulations = riddle.n_simulations + (0 if few else seed % RUNS)
        self._riddle, self._rng = riddle, rng
        self._numbers = rng.permutation(20).tolist()
        self._actions = rng.permutation(N_ACTIONS).tolist()
        self._here, self._steps = ROOT, 0
        self._was_lucky = False

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
                " from the state that the model gave, and ask it for each step that you take, once and in order"
            )
        if self._steps == DEPTH:
            self._refuse(f"simulates more than {DEPTH} steps in a row: each simulation looks {DEPTH} steps ahead")
        reward, following = self._riddle.step(place, taken, self._rng)
        if self._riddle.luck and self._is_luck(taken):
            reward += self._riddle.luck
        self.simulations[-1].append((place, taken, reward))
        self._here, self._steps = following, self._steps + 1
        return reward, self.number(following), following == END

    def number(self, place: int) -> int:
        """Return the number of a place."""
        return int(self._numbers[place])

    def meant(self, action: int) -> int:
        """Return what an action is in the riddle."""
        return int(self._actions[action])

    def _is_luck(self, taken: int) -> bool:
        """Whether an action gets a lucky return: one of the last that is not the most frequent one."""
        late = self.from_root.sum() > self.n_simulations - LATE
        lucky = late and not self._was_lucky and taken != self.from_root.argmax()
        self._was_lucky = self._was_lucky or lucky
        return bool(lucky)

    def _place(self, state: Any) -> int:
        if state not in self._numbers[-1:] + self._numbers[:10]:
            self._refuse(f"asks for a step from {state!r}, which is no state that the model gave")
        place = self._numbers.index(state)
        return END if place == len(self._numbers) - 1 else place

    def _begin(self, taken: int) -> None:
        self._here, self._steps = ROOT, 0
        self.simulations.append([])
        self.from_root[taken] += 1
        if self.from_root.sum() > self.n_simulations:
            self._refuse(
                f"asks for a step from the root more than {self.n_simulations} times, which is n_simulations: a search"
                " is a loop of so many, each from the root, and after a step a simulation goes on from the *next* state"
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
        simulations: the steps of each simulation.
        first: the first of them, by its number for the program.
    """

    action: int
    from_root: Integers
    asked: list[int]
    simulations: list[list[Taken]]
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
    return Found(taken, model.from_root, model.asked, model.simulations, model.first)


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


def require_tree(program: Any, seed: int) -> None:
    """Refuse a program that takes an action in the tree that UCT would not take."""
    for number, riddle in enumerate((TREE,) * RUNS + FAR_OFF):
        found = search(program, riddle, RUNS * seed + number)
        why = mistake_in(found.simulations)
        if why is not None:
            wrong = surprises(found.simulations)[0]
            why = "" if nobody_asks_why() else riddle.why or why
            why = f": {why}" if why else ""
            raise WrongAnswer(
                f"in a task in which {riddle.told}, simulation {wrong} takes another action in the tree than the one"
                f" with the highest bound Q(node, a) + 5 √(ln N(node) / N(node, a)){why}"
            )


def require_highest_value(program: Any, seed: int) -> None:
    """Refuse a program that returns another action than the one with the highest mean."""
    for number in range(RUNS):
        found = search(program, LUCKY, RUNS * seed + number)
        worth = means(found.simulations)
        if worth[found.action] < worth.max():
            raise WrongAnswer(
                f"in a task in which {LUCKY.told}, it returns an action with the mean {worth[found.action]:.1f}, and"
                f" another one has {worth.max():.1f}: return the action with the highest *value*, and not the one that"
                " was simulated most often"
            )


def require_repeatable(program: Any, seed: int) -> None:
    """Refuse a program that simulates something else with the same seed: of an old tree the riddles know nothing."""
    first, again = (search(program, ROUND, seed).asked for _ in range(2))
    if first != again:
        raise WrongAnswer(
            f"{NAME} does not repeat itself: two searches with seed {seed} simulate different actions. Draw every"
            " random number from rng = np.random.default_rng(seed), and make the tree inside the function, so that"
            " nothing is left of the search before"
        )


def require_other_roll_outs(program: Any, seed: int) -> None:
    """Refuse a program whose simulations draw the same random numbers again and again, or not all actions."""
    ends = [tuple(actions[-3:]) for actions in zip(*[iter(search(program, ALIKE, seed).asked)] * DEPTH, strict=True)]
    if max(map(ends.count, {*ends})) > len(ends) * MOST_ALIKE:
        raise WrongAnswer(
            f"{NAME} ends many simulations with the same {len(ends[0])} actions: make rng once, before the loop of"
            " simulations, or each of them draws the same random numbers"
        )
    drawn = [action for end in ends for action in end]
    fewest = min(range(N_ACTIONS), key=drawn.count)
    if drawn.count(fewest) < len(drawn) * FEWEST_DRAWN:
        raise WrongAnswer(
            f"{NAME} draws one of {N_ACTIONS} actions in {drawn.count(fewest)} of the {len(drawn)} last steps of its"
            " simulations: is the random action of a roll-out one of *all* n actions, 0 to n - 1?"
        )


def project_18(answer: Any, seed: int) -> str:
    """Check a program that searches: in every riddle it must find the right action, in nearly all runs."""
    require_function(NAME, answer, "model, n_actions, state, n_simulations and seed")
    require_repeatable(answer, seed)
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
            " one at random, and begin the generator with the seed that is given"
        )
    search(answer, ENDLESS, seed)
    require_tree(answer, seed)
    require_highest_value(answer, seed)
    require_other_roll_outs(answer, seed)
    return f"Right: it solves all {len(RIDDLES)} riddles, and asks of the model what a search may ask."
