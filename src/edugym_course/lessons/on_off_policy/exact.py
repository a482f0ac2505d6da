"""What is possible on a road, by planning on its exact model: the best runs, their slips, and where they change."""

from typing import Any

import numpy as np

from edugym.envs.roadrunner import Roadrunner, Runner
from edugym.exact.model import finite_model
from edugym.exact.policies import soft
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Reals
from edugym_course.lessons.on_off_policy.methods import DISCOUNT

HORIZON = 50
"""The step limit of an episode at the defaults; it hardly matters, since no good run takes so long."""
FAST, SAFE = -2.0, -3.0
"""The returns of the shortest run to the target, and of one that takes a step more."""


def best_soft_return(model: FiniteModel, epsilon: float) -> float:
    """Return the expected return of the best policy among those that act at random with probability ε."""
    return value_iteration(model, DISCOUNT, epsilon=epsilon, horizon=HORIZON).start


def soft_return_of(model: FiniteModel, epsilon: float, planned_for: float) -> float:
    """Return what the best policy for ε = `planned_for` earns when it acts at random with probability `epsilon`."""
    return policy_evaluation(model, _soft(model, epsilon, planned_for), DISCOUNT, horizon=HORIZON).start


def share_lost(model: FiniteModel, epsilon: float, planned_for: float) -> float:
    """Return how likely an episode of that policy is to end in a fall or a stall.

    Raises:
        ValueError: the model is not that of a Roadrunner.
    """
    task = model.mdp
    if not isinstance(task, Roadrunner):
        raise ValueError(f"model must be that of a road, but is {model!r}")
    lost = np.array([task.has_failed(state) for state in model.states])
    counting = model._replace(rewards=np.where(model.terminal[:, np.newaxis, np.newaxis], 0.0, lost[model.successors]))
    return policy_evaluation(counting, _soft(model, epsilon, planned_for), 1.0, horizon=HORIZON).start


def _soft(model: FiniteModel, epsilon: float, planned_for: float) -> Reals:
    return soft(value_iteration(model, DISCOUNT, epsilon=planned_for, horizon=HORIZON).greedy_policy(), epsilon)


def switch(model: FiniteModel, low: float = 0.0, high: float = 0.2, tolerance: float = 1e-4) -> float:
    """Return the ε from which on the longer, safer run is the better one, by bisection on the exact model."""
    fastest = best_soft_return(model, 0.0)
    while high - low > tolerance:
        middle = (low + high) / 2
        if soft_return_of(model, 0.0, planned_for=middle) < fastest:  # the best run for this ε, when nothing slips
            high = middle
        else:
            low = middle
    return (low + high) / 2


def best_run(epsilon: float, *, start: Runner | None = None, **parameters: Any) -> list[Runner]:
    """Return the states of the run that is best for an agent which slips with probability ε, played without a slip.

    Args:
        epsilon: ε, from 0 to 1.
        start: the state in which it begins; None is that of an episode.
        parameters: those of the road, such as `negative_reward`.
    """
    task = Roadrunner.create(**parameters)
    model = finite_model(task)
    policy = value_iteration(model, DISCOUNT, epsilon=epsilon, horizon=HORIZON).greedy_policy()
    rng = np.random.default_rng(0)  # the road draws nothing
    states = [task.initial(rng) if start is None else start]
    while not task.terminal(states[-1]) and len(states) <= task.max_steps:
        states.append(task.transition(states[-1], int(policy[model.row(states[-1])].argmax()), rng))
    return states


def deadly_actions(task: Roadrunner, top_speed: int = 3) -> Reals:
    """Return in how many of the three actions a runner falls or stalls, shape (top_speed + 1, size): [dx, x].

    NaN where no run can be, and at the target.
    """
    rng = np.random.default_rng(0)  # the road draws nothing
    deadly = np.full((top_speed + 1, task.size), np.nan)
    for state in finite_model(task).states:
        if not task.terminal(state) and state.dx <= top_speed:
            deadly[state.dx, state.x] = sum(task.has_failed(task.transition(state, a, rng)) for a in range(3))
    return deadly


ROAD = Roadrunner.create()
