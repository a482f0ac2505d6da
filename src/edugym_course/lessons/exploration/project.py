"""The project of lesson 1: a program that finds the way up a high wall, from a blank file."""

from collections import Counter
from collections.abc import Sequence
from functools import partial
from typing import Any

import gymnasium

from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import APART, Environment, Run, require_reproducible, returns_of, run_program

HEIGHT, N_STEPS, TRIAL = 30, 3_000, 200
WALLS = ((HEIGHT, 2), (HEIGHT, 2), (HEIGHT, 3), (HEIGHT, 2))
"""The height and the number of grips of each wall."""
LOW = 3
"""Places below this one are the foot of a wall."""
OFTEN = 20
"""How often a wrong grip is tried again before it is told."""


def wall(height: int, n_grips: int, layout_seed: int) -> Environment:
    """Make a wall. Its grips must not be the random numbers of a program that has the same seed."""
    return gymnasium.make("edugym/Boulder-v0", height=height, n_grips=n_grips, layout_seed=APART + layout_seed)


def project_1(answer: Any, seed: int) -> str:
    """Check a program that explores: its policy must reach the top of every wall."""
    require_reproducible(answer, partial(wall, HEIGHT, 2, 1000 * seed), TRIAL, seed)
    found: list[int] = []
    for number, (height, n_grips) in enumerate(WALLS, start=1000 * seed):
        run = run_program(answer, wall(height, n_grips, number), N_STEPS, number)
        name = f"on a wall of height {height} with {n_grips} grips"
        firsts = [t for t, step in enumerate(run.steps, start=1) if step.terminated]
        if not firsts:
            raise WrongAnswer(f"{name}, {N_STEPS} steps do not reach the top: {_why(run)}")
        if returns_of(run.policy, wall(height, n_grips, number), 1, number).sum() < 1:
            raise WrongAnswer(
                f"{name}, the program reached the top {len(firsts)} times while it learned, but the policy that it"
                " returns does not: does it remember the way, and go it without trying anything?"
            )
        found.append(firsts[0])
    told = ", ".join(map(str, found))
    return f"Right: it reached the tops for the first time after {told} steps; a random climber needs two billion."


def _why(run: Run) -> str:
    """Return what the steps look like of a program that never reached the top, and the likely cause."""
    if nobody_asks_why():
        return ""
    highest = max(step.next_state for step in run.steps)
    (place, grip), times = _wrong_grips(run.steps).most_common(1)[0]
    low = sum(step.state < LOW for step in run.steps) / len(run.steps)
    seen = f"the highest place is {highest}"
    if place >= LOW and times > OFTEN:
        return (
            f"{seen}, and at place {place} grip {grip} was tried {times} times, though it sends the climber to the"
            " ground every time: remember what did not hold, and try something else there"
        )
    return (
        f"{seen}, and {low:.0%} of the steps begin below place {LOW}: likely it also tries actions at random where it"
        " knows the way, and falls; go the known way without trying, and try at its end"
    )


def _wrong_grips(steps: Sequence[Any]) -> Counter[tuple[int, int]]:
    """Return how often each wrong grip was taken, by place and grip, the highest place first where as often."""
    taken = Counter((int(step.state), int(step.action)) for step in steps if step.next_state == 0)
    return Counter(dict(sorted(taken.items(), reverse=True)))
