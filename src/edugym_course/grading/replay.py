"""Which equation explains the actions that a program chose: its own steps are learned from once more.

What a tabular method has learned follows from its steps. So the steps of a program are given to an agent of ours, which
says before each of them which actions look best. A program with the same equation takes one of these, but for ε of its
steps. Every other one is a surprise, and of these there must not be too many. The same is tried with agents that make
the usual mistakes: one that makes the actions much more probable than the right equation does is the likely cause.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any

from edugym.agents.tables import tied
from edugym.checks.contract import learns_from
from edugym.mdp.protocol import Reals
from edugym_course.grading.learners import Learner
from edugym_course.grading.programs import Step, learn_from
from edugym_course.grading.surprises import Row


def replay(runs: Sequence[Sequence[Step]], learner: Learner, shape: tuple[int, int], epsilon: float) -> Iterator[Row]:
    """Let new agents learn from the steps of a program, one from each run, and yield what each step was to them."""
    epsilon = 1 - epsilon if learner.swaps else epsilon
    for steps in runs:
        for agent, step in learning(steps, learner, shape):
            values = _values(agent, step.state)
            best = looks_best(values)
            share = (1 - epsilon) * best[step.action] / sum(best)
            log = math.log(epsilon / len(best) + share)
            yield not best[step.action], epsilon * (1 - sum(best) / len(best)), log, *_rank(values, best, step.action)


def learning(steps: Sequence[Step], learner: Learner, shape: tuple[int, int]) -> Iterator[tuple[Any, Step]]:
    """Let a new agent learn from the steps of a run; yield it before each, with the step as it takes it."""
    agent = learner.make(shape)
    names = learns_from(agent)
    waiting: Step | None = None
    before: Step | None = None
    for real, after in zip(steps, [*steps[1:], None], strict=True):
        restarted = real._replace(next_state=after.state) if learner.restarts and after and real.truncated else real
        step = before = learner.alter(restarted, before)
        yield agent, step
        step = step._replace(state=step.next_state) if learner.stale else step
        if waiting is not None:
            learn_from(agent, names, waiting, step.action)
        waiting = None
        if learner.skips(real):
            getattr(agent, "forget_episode", bool)()  # its list of steps, if it has one
        elif "next_action" in names and not (real.terminated or real.truncated):
            waiting = step
        else:
            learn_from(agent, names, step, step.action)


def _values(agent: Any, state: Any) -> list[float]:
    row: Reals = agent.values(state) if hasattr(agent, "values") else agent.Q[state]
    return [float(value) for value in row]


def best_of(agent: Any, state: Any) -> list[bool]:
    """Which actions look best to an agent."""
    return looks_best(_values(agent, state))


def looks_best(values: Sequence[float]) -> list[bool]:
    """Which of some values are the highest."""
    highest = max(values)
    return [tied(value, highest) for value in values]


def _rank(values: Sequence[float], best: Sequence[bool], action: int) -> tuple[float, float]:
    """Return how many actions look worse less how many look better, among those that do not look best.

    Its mean is 0 if one of them is drawn at random; its variance then is the second number.
    """
    if best[action]:
        return 0.0, 0.0
    others = [value for value, looks in zip(values, best, strict=True) if not looks]

    def rank(value: float) -> int:
        return sum((value > other) - (value < other) for other in others if not tied(value, other))

    return rank(values[action]), sum(rank(value) ** 2 for value in others) / len(others)


def histories(steps: Sequence[Step]) -> list[tuple[Any, ...]]:
    """Return for each step of a run what came before it in its episode: O_0, A_0, O_1, ..., O_t."""
    found, history = [], tuple[Any, ...]()
    for step in steps:
        history = (*history, step.state)
        found.append(history)
        history = () if step.terminated or step.truncated else (*history, step.action)
    return found
