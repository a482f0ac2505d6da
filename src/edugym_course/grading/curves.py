"""The learning curve of a program from a blank file, against the curves of ours over seeds."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.contract import learns_from
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import (
    Environment,
    Policy,
    Program,
    Run,
    Step,
    learn_from,
    returns_of,
    run_program,
    shape_of,
)

SEEDS = 5
"""How many runs of a program are compared with ours."""
OUR_SEEDS = range(1000, 1008)
WHAT = {
    "late": "the last quarter of its training episodes brings",
    "played": "the policy that it returns brings",
}


@dataclass(frozen=True)
class Race:
    """An environment in which a program should learn as well as ours.

    Attributes:
        make: makes the environment.
        n_steps: the training steps.
        ours: our program.
        episodes: how many episodes the policy plays in the end.
        judged: what counts, of `Result`.
        remembers: whether the policy is told all that came before in the episode.
    """

    make: Callable[[], Environment]
    n_steps: int
    ours: Program
    episodes: int = 1
    judged: tuple[str, ...] = ("late", "played")
    remembers: bool = False


class Result(NamedTuple):
    """How well a program did.

    Attributes:
        run: its run.
        late: the mean return of its last training episodes.
        played: the mean return of the policy that it returned.
    """

    run: Run
    late: float
    played: float


def result_of(race: Race, program: Program, seed: int) -> Result:
    """Run a program, and play its policy."""
    run = run_program(program, race.make(), race.n_steps, seed)
    played = returns_of(run.policy, race.make(), race.episodes, seed + 1, race.remembers)
    return Result(run, run.late(), float(played.mean()))


@cache
def our_results(race: Race) -> tuple[Result, ...]:
    """Return what ours does, over seeds."""
    return tuple(result_of(race, race.ours, seed) for seed in OUR_SEEDS)


def compare_with_ours(program: Any, race: Race, seed: int) -> str:
    """Check that a program learns as well as ours, or better.

    Returns:
        The figures of both.

    Raises:
        WrongAnswer: it does not, or it breaks the contract.
    """
    found = [result_of(race, program, SEEDS * seed + number) for number in range(SEEDS)]
    figures = []
    for name in race.judged:
        ours, yours = ([float(getattr(one, name)) for one in results] for results in (our_results(race), found))
        middle = float(np.median(yours))
        places = 1 if round(middle, 1) != round(min(ours), 1) else 2
        figures.append(f"{WHAT[name]} {middle:.{places}f} (ours {min(ours):.{places}f} to {max(ours):.{places}f})")
        if not middle >= lowest(ours):  # also when no episode ended
            worst = min(found, key=lambda result: result.played)
            has_learned = name == "played" and "late" in race.judged  # that was judged before
            why = "" if nobody_asks_why() else symptom(worst.run, worst.played, has_learned)
            raise WrongAnswer(f"in the middle one of {SEEDS} runs, {figures[-1]}, which is too low: {why}")
        if middle < min(ours):
            figures[-1] = f"{figures[-1][:-1]}; that is near enough)"
    return f"In the middle one of {SEEDS} runs, {' and '.join(figures)}."


def lowest(ours: Sequence[float]) -> float:
    """Return how low the middle run of a program may be: a standard deviation below the worst of ours.

    Returns have long tails, so neither hangs on one bad run of the program.
    """
    return min(ours) - float(np.std(ours, ddof=1))


def symptom(run: Run, played: float, has_learned: bool = False) -> str:
    """Return what the curve of a run that is too low looks like, and the likely cause.

    Args:
        run: the run.
        played: the mean return of its policy.
        has_learned: whether the last training episodes were as good as ours.
    """
    returns = run.returns
    if len(returns) < 4:
        return "hardly an episode ended: does the state that your program chooses from change after each step?"
    quarter = max(1, len(returns) // 4)
    means = [float(part.mean()) for part in np.array_split(returns, 4)]
    noise = 2 * float(returns.std()) / math.sqrt(quarter) + 1e-9
    if played < means[-1] - 2 * noise:
        return (
            f"while it learned, its last episodes brought {means[-1]:.1f}, and the policy that it returns brings"
            f" {played:.1f}: does this policy look up the state that it is given, and take the *best* action?"
        )
    if has_learned:
        return (
            "while it learned, its last episodes were as good as ours, so look at the policy that it returns: does it"
            " take the *best* action, and never a random one?"
        )
    if max(means) > means[-1] + noise:
        return (
            f"the returns rise to {max(means):.1f} and then fall to {means[-1]:.1f}: likely values that grow without"
            " end, or a target that goes on after the end of an episode"
        )
    if means[-1] > means[0] + noise:
        return (
            f"the returns rise from {means[0]:.1f} to {means[-1]:.1f}, but slowly: likely a learning rate that is too"
            " small, too much exploration, or steps that are learned from only when the episode is over"
        )
    return (
        f"the returns do not rise ({means[0]:.1f} in the first quarter, {means[-1]:.1f} in the last): likely an update"
        " that changes nothing, or actions that are not chosen by what was learned"
    )


def program_of(make: Callable[[tuple[int, int]], Any]) -> Program:
    """Return our program: the plain loop with an agent of the package, made for the shape of a table."""

    def program(environment: Environment, n_steps: int, seed: int) -> Policy:
        agent = make(shape_of(environment))
        names, rng = learns_from(agent), np.random.default_rng(seed)
        state, _ = environment.reset(seed=seed)
        action = agent.act(state, rng)
        for _ in range(n_steps):
            next_state, reward, terminated, truncated, _ = environment.step(action)
            on_policy = "next_action" in names and not terminated
            next_action = agent.act(next_state, rng) if on_policy else action
            step = Step(state, action, float(reward), next_state, terminated, truncated)
            learn_from(agent, names, step, next_action)
            state, over = next_state, terminated or truncated
            if over:
                state, _ = environment.reset()
            action = next_action if on_policy and not over else agent.act(state, rng)
        return lambda state: agent.greedy(state, rng)

    return program
