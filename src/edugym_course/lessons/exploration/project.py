"""The project of lesson 1: a program that finds the way up a high wall, from a blank file."""

from collections import Counter
from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.envs.boulder import Boulder
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import APART, Environment, Run, actions_of, returns_of, run_program
from edugym_course.grading.repeats import require_reproducible

HEIGHT, N_STEPS, TRIAL = 30, 3_000, 200
LONG, SHORT = 10 * HEIGHT, 35
"""After how many steps an episode is truncated. Where that is often, who goes on from the old state learns wrong
grips; the five right programs tried need 2025 steps at most (40 walls, three grips; 20 with the short limit)."""
WALLS = ((2, LONG), (2, SHORT), (3, LONG), (3, SHORT))
"""The number of grips of each wall, and its step limit."""
CUT = (
    "where no episode is truncated they do. Does it go on from the state that reset() gives, after each episode, is"
    " what was learned kept, and is a step that is truncated learned as any other, with the value of its next state? If"
    " so,"
)
LOW = 3
"""Places below this one are the foot of a wall."""
CLIMBS = 20
"""How often a policy must climb without a fall: one that tries something in 1 of 100 steps most likely falls."""
OFTEN = 20
"""How often a wrong grip is tried again before it is told."""
BY_CHANCE = 0.8
"""From which share of the wrong grips of a random climber on it looks like one."""


def wall(n_grips: int, layout_seed: int, max_steps: int) -> Environment:
    """Make a wall. Its grips must not be the random numbers of a program that has the same seed.

    Its last grip is not 0, so that a policy must know that one, too.
    """
    boulder = Boulder.create(HEIGHT, n_grips, layout_seed=APART + layout_seed, max_steps=max_steps)
    return MDPEnv(boulder._replace(grips=np.append(boulder.grips[:-1], max(1, boulder.grips[-1]))))


def project_1(answer: Any, seed: int) -> str:
    """Check a program that explores: its policy must reach the top of every wall."""
    # One that tries grip after grip, or breaks ties by argmax, needs no random numbers.
    require_reproducible(answer, partial(wall, 2, 1000 * seed, LONG), TRIAL, seed, draws=False)
    found: list[int] = []
    for number, (n_grips, max_steps) in enumerate(WALLS, start=1000 * seed):
        run = run_program(answer, wall(n_grips, number, max_steps), N_STEPS, number)
        name = f"on a wall of height {HEIGHT} with {n_grips} grips"
        if max_steps == SHORT:
            name += f", where an episode is truncated after {SHORT} steps"
        firsts = [t for t, step in enumerate(run.steps, start=1) if step.terminated]
        if not firsts:
            why = "" if nobody_asks_why() else f"{_cut(answer, n_grips, number)}{_why(run, n_grips)}"
            raise WrongAnswer(f"{name}, {N_STEPS} steps do not reach the top: {why}")
        without_a_fall = wall(n_grips, number, max_steps=HEIGHT)
        actions_of(run.policy, range(HEIGHT), n_grips)
        climbs = returns_of(run.policy, without_a_fall, CLIMBS, number)
        if climbs.min() < 1:
            raise WrongAnswer(
                f"{name}, the program reached the top {len(firsts)} times while it learned, but the policy that it"
                f" returns does so in {(climbs >= 1).sum()} of {CLIMBS} climbs of {HEIGHT} steps: does it remember the"
                " way, and go it without trying anything? Did it learn fast enough (with α = 1 one try is enough), from"
                " the state that reset gives in each episode, and are all first values and bonuses below what the top"
                " brings?"
            )
        found.append(firsts[0])
    told = ", ".join(map(str, found))
    return (
        f"Right: it reached the tops for the first time after {told} steps; a random climber needs two billion with 2"
        " grips, and 300 trillion with 3."
    )


def _cut(answer: Any, n_grips: int, number: int) -> str:
    """Return a sentence on truncated steps, if the program reaches the top where there are none; else ""."""
    uncut = run_program(answer, wall(n_grips, number, N_STEPS + 1), N_STEPS, number)
    return f"{CUT} " if any(step.terminated for step in uncut.steps[:N_STEPS]) else ""


def _why(run: Run, n_grips: int) -> str:
    """Return what the steps look like of a program that never reached the top, and the likely cause."""
    seen = f"the highest place is {max(step.next_state for step in run.steps)}"
    (place, grip), times = _wrong_grips(run.steps).most_common(1)[0]
    low = sum(step.state < LOW for step in run.steps) / len(run.steps)
    if place >= LOW and times > OFTEN:
        return (
            f"{seen}, and at place {place} grip {grip} was tried {times} times, though it sends the climber to the"
            " ground every time: remember what did not hold, and try something else there (count a try where"
            " it *began*)"
        )
    untried = _never_taken(run.steps, n_grips)
    if untried:
        return f"{seen}, and {untried}"
    if _wrong_where_known(run.steps) > BY_CHANCE * (1 - 1 / n_grips):
        return (
            f"{seen}, and at the foot of the wall it takes wrong grips as often as by chance, though it has seen which"
            " ones hold: below the top there is no reward to learn from, so remember what was tried and what held (is"
            " `state = next_state` missing?). With optimistic first values: is γ below 1, does the target have the"
            " value of the *next* state, and can the table hold fractions?"
        )
    return (
        f"{seen}, and {low:.0%} of the steps begin below place {LOW}: likely it still tries where it knows the way, at"
        " random or by a bonus, and falls; go the known way without trying, and try at its end. Or it loses the way: is"
        " what was learned kept from one episode to the next, and is a step that is truncated learned as any other?"
    )


def _never_taken(steps: Sequence[Any], n_grips: int) -> str:
    """Return a sentence on a grip that was never tried at a place from which nothing led up, "" if there is none."""
    left = {step.state for step in steps if step.next_state > step.state}
    visits = Counter(int(step.state) for step in steps if step.state not in left)
    taken = {(int(step.state), int(step.action)) for step in steps}
    for place, times in visits.items():
        missing = [grip for grip in range(n_grips) if (place, grip) not in taken]
        if missing and times > OFTEN * n_grips:
            return (
                f"at place {place}, in {times} visits, grip {missing[0]} was never tried, and no other one holds: is"
                f" what was tried first preferred for ever, are the {n_grips} grips not all counted, or does the update"
                " move another value than that of the grip taken, at the place that was left?"
            )
    return ""


def _wrong_where_known(steps: Sequence[Any]) -> float:
    """Return the share of wrong grips at the foot of the wall, where a right one had been taken before."""
    known: set[int] = set()
    wrong: list[bool] = []
    for step in steps:
        if step.state in known:
            wrong.append(step.next_state == 0)
        elif step.state < LOW and step.next_state > step.state:
            known.add(step.state)
    return sum(wrong) / max(1, len(wrong))


def _wrong_grips(steps: Sequence[Any]) -> Counter[tuple[int, int]]:
    """Return how often each wrong grip was taken, by place and grip, the highest place first where as often."""
    taken = Counter((int(step.state), int(step.action)) for step in steps if step.next_state == 0)
    return Counter(dict(sorted(taken.items(), reverse=True)))
