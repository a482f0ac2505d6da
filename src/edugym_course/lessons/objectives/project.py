"""The project of lesson 12: the best dive within a limit, from a blank file.

The program is put to the test in seas with drawn treasures. In each the best treasure within the limit is another one,
deeper ones are worth more, and mostly no price of time prefers the best one. So which treasures it picks up tells what
it has learned.
"""

from collections.abc import Callable, Collection, Mapping
from functools import partial
from typing import Any

import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.envs.diver import N_COLUMNS, Diver
from edugym.mdp.protocol import Random, Reals
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import POLICY, Environment, Recorder, run_program
from edugym_course.grading.repeats import require_reproducible
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.objectives.methods import LIMIT, PRICES

N_STEPS, LONG = 10_000, 16_000
"""The second where the best treasure is little better: a value must come all the way back, with a small α too."""
BEST = (3, 1, 2, 0, 3, 2)
"""Which treasure is the best within the limit, in each sea."""
POOR = (1, 3, 4)
"""In these seas all treasures within the limit are worth little, so who thinks a late one worth anything takes it."""
DISCOUNTS = (0.9, 0.95, 0.99)
ODD_ONES = 1
"""In so many seas a mistake may bring up another treasure than it mostly does."""
FIFTH = (LIMIT + 1) // 2
N_DIVES = 10
"""So many dives of a policy have to end alike."""
NONE = -1
"""Stands for a treasure where a dive does not end."""
STEPS_TO = 2 * np.arange(N_COLUMNS) + 1.0


def sea(best: int, rng: np.random.Generator, is_poor: bool = False) -> Reals:
    """Draw treasures, of which `best` is worth most within the limit."""
    values = np.zeros(N_COLUMNS)
    values[:4] = rng.uniform(5.0, 15.0, 4)
    values[best] = rng.uniform(20.0, 25.0)
    if best == 3:  # it is not by far the best: who discounts takes the first one, who stops early the second
        values[:2] = 0.972 * values[best], 0.982 * values[best]
    if is_poor:
        values *= 0.02
    values[4:] = np.sort(rng.uniform(60.0, 95.0, 5))
    return values.round(4 if is_poor else 2)


class OneFartherOut(Diver):
    """The same sea for a diver who begins in the second column: each treasure takes a step less, so an even number."""

    __slots__ = ()

    def initial(self, rng: Random) -> int:
        """At the surface, a cell away from the shore."""
        return 1


class TwoFartherOut(Diver):
    """The same sea for a diver who begins in the third column: the fifth treasure takes seven steps from there."""

    __slots__ = ()

    def initial(self, rng: Random) -> int:
        """At the surface, two cells away from the shore."""
        return 2


def environment_of(values: Reals, kind: type[Diver] = Diver) -> Environment:
    """Make the environment of a sea: its reward is the value of a treasure, and steps cost nothing."""
    mdp = kind.create(weights=(1.0, 0.0))._replace(treasures=values)
    environment: Environment = MDPEnv(mdp)
    return environment


def _best_of(values: Reals, most_steps: float) -> int:
    within = most_steps >= STEPS_TO
    return int(np.where(within, values, -np.inf).argmax())


MISTAKES: Mapping[str, Callable[[Reals], int]] = {
    "that is the most valuable treasure of all, however long it takes: does a dive that takes more than seven steps"
    " count for nothing in what your program learns?": lambda values: int(values.argmax()),
    "that is the best one of those nearer than seven steps, and exactly seven are allowed; if your program allows them,"
    " is γ 1, and is α large enough for their values to come all the way back?": lambda values: _best_of(
        values, LIMIT - 1
    ),
    "that is the best one with nine steps: are the steps counted from the first on, and anew in each dive, and is a"
    " dive that takes too long worth less than the poorest of the others?": lambda values: _best_of(values, LIMIT + 2),
    "that is always the treasure at the shore: are there random dives, does each begin in the state that reset gives,"
    " with the steps counted anew? Does the *largest* of the next values (no mean) come back to the state that was"
    " left, and does the policy look it up in the state that it is given?": lambda values: 0,
    "that is always the deepest treasure within seven steps; a nearer one may be worth more": lambda values: 3,
    "that is the poorest treasure within seven steps: is there an `argmin`, or a minus sign too many?": (
        lambda values: int(np.where(STEPS_TO <= LIMIT, values, np.inf).argmin())
    ),
}
"""Which treasure is picked up by mistake."""
DISCOUNTED = (
    "a treasure seems to count less the later it comes: is γ below 1, is α too small for its value to come all the way"
    " back, does a target count random actions, as that of SARSA does, or does the table hold whole numbers, so that a"
    " part of the value is lost in each update?"
)


def _discounted(discount: float, values: Reals) -> int:
    """Return the treasure within the limit that is best if its value is discounted."""
    return _best_of(values * discount**STEPS_TO, LIMIT)


def picked_up(policy: Any, environment: Environment, seed: int) -> int:
    """Return the treasure that a policy picks up; `NONE` if its dive does not end."""
    recorder = Recorder(environment, np.inf, seed, POLICY)
    state, _ = recorder.reset()
    while True:
        with student_code(POLICY):
            action = policy(state)
        state, _, terminated, truncated, _ = recorder.step(action)
        if terminated:
            return int(state) % N_COLUMNS
        if truncated:
            return NONE


def _always_picked_up(policy: Any, environment: Environment, seed: int) -> int:
    """Return the treasure that a policy picks up, dive after dive; `NONE` if its dives do not end.

    Raises:
        WrongAnswer: it is not always the same one.
    """
    ends = {picked_up(policy, environment, seed) for _ in range(N_DIVES)}
    if len(ends) > 1:
        names = ", now ".join("none" if end == NONE else f"the {_ordinal(end)} treasure" for end in sorted(ends))
        raise WrongAnswer(
            f"{POLICY} draws its actions: from the same start it picks up now {names}. It should take the *best* action"
            " by what was learned, and never a random one; and if there are many equal values, has it learned enough?"
        )
    return ends.pop()


def project_12(answer: Any, seed: int) -> str:
    """Check a program that learns the best dive within a limit."""
    rng = np.random.default_rng([seed, 12])
    seas = [sea(best, rng, number in POOR) for number, best in enumerate(BEST)]
    require_reproducible(answer, lambda: environment_of(seas[0]), 200, seed)
    found = []
    for number, values in enumerate(seas):
        n_steps = LONG if BEST[number] == 3 else N_STEPS
        run = run_program(answer, environment_of(values), n_steps, len(BEST) * seed + number)
        found.append(_always_picked_up(run.policy, environment_of(values), seed))
    missed = [i for i, best in enumerate(BEST) if found[i] != best]
    if not missed:
        _require_steps_counted(answer, sea(2, rng), seed)
        return (
            f"Right: in all {len(BEST)} seas it brings home the best treasure within {LIMIT} steps, and most of these"
            " lie where no price finds them."
        )
    why, fits = ("", missed) if nobody_asks_why() else _why(seas, found)
    told_of = next(i for i in missed if i in fits)
    values, mine, best = seas[told_of], found[told_of], BEST[told_of]
    told = f"with the treasures {', '.join(f'{value:g}' for value in values)} the policy"
    should = f"it should pick up the {_ordinal(best)} one, worth {values[best]:g}"
    if mine == NONE:
        raise WrongAnswer(
            f"{told} comes to no treasure, and {should}: does it look up the state that it is given, and take the best"
            " action, does each step after the seventh bring nothing, and are the first values not too high?"
        )
    takes = (
        f"picks up the {_ordinal(mine)} one, worth {values[mine]:g}, after {STEPS_TO[mine]:g} step{'s' if mine else ''}"
    )
    raise WrongAnswer(f"{told} {takes}, and {should}: {why}")


def _require_steps_counted(answer: Any, values: Reals, seed: int) -> None:
    """Refuse a program that takes eight steps where the fifth treasure takes eight, or does not where it takes seven.

    Raises:
        WrongAnswer: it does, or does not.
    """
    seas = [environment_of(values, kind) for kind in (OneFartherOut, TwoFartherOut)]
    one, two = (picked_up(run_program(answer, where, LONG, seed).policy, where, seed) for where in seas)
    if one == FIFTH:
        raise WrongAnswer(
            "where the diver begins one cell away from the shore, the policy picks up the fifth treasure, after"
            f" {LIMIT + 1} steps: at most seven are allowed. Is the step under way counted, too, or are eight allowed?"
        )
    if two != FIFTH:
        raise WrongAnswer(
            "where the diver begins two cells away from the shore, the fifth treasure is the best one: it is worth"
            f" {values[FIFTH]:g}, and exactly seven steps away. The policy"
            f" {'brings up none' if two == NONE else f'brings up the {_ordinal(two)} one'}: are the steps counted"
            " from `reset` on, and not computed from the cell, and does each update belong to the state that was left?"
        )


def _ordinal(treasure: int) -> str:
    return ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth")[treasure]


def _for_a_price(price: float, values: Reals) -> int:
    """Return the treasure that is best if each step costs a price."""
    return int((values - price * STEPS_TO).argmax())


def _priced(price: float) -> str:
    """Return the sentence of a price."""
    return (
        f"in nearly all seas that is what a price of about {price:g} for each step prefers; a price cannot find every"
        " compromise, so let the limit itself say what a dive is worth"
    )


def _why(seas: list[Reals], found: list[int]) -> tuple[str, Collection[int]]:
    """Return what explains the treasures in all seas but one, or what to look at, and in which seas it does."""
    rules: list[tuple[str, Callable[[Reals], int]]] = [
        *MISTAKES.items(),
        *((DISCOUNTED, partial(_discounted, discount)) for discount in DISCOUNTS),
        *((_priced(price), partial(_for_a_price, price)) for price in PRICES),
    ]
    for most_missed in range(ODD_ONES + 1):
        for sentence, rule in rules:
            places = [i for i, mine in enumerate(found) if rule(seas[i]) == mine]
            if len(places) >= len(found) - most_missed:
                return sentence, places
    late = [i for i, mine in enumerate(found) if mine > max(BEST)]
    if late:
        return (
            f"in {len(late)} of {len(found)} seas the dive takes too long; what is a dive worth that does? It must be"
            " less than the poorest of the others"
        ), late
    missed = [i for i, mine in enumerate(found) if mine != BEST[i]]
    if set(missed) <= {*POOR}:
        return (
            "only where all treasures are worth less than 1 it goes wrong: are values rounded or whole numbers, as in a"
            " table with dtype=int, or is a dive that takes too long worth more than these?"
        ), missed
    why = (
        "each dive is short enough, but not the best: does the update belong to the state that was left and the action"
        " that was taken there, and does your program try all dives often enough?"
    )
    return why, range(len(found))
