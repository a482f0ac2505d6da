"""The agents of the course, on any finite problem, and how what they learned is judged by another reward."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from edugym.agents.count_based import CountBased
from edugym.agents.dyna_q import DynaQ
from edugym.agents.n_step_sarsa import NStepSARSA
from edugym.agents.q_learning import QLearning
from edugym.agents.sarsa import SARSA
from edugym.agents.strategies import EpsilonGreedy
from edugym.exact.model import finite_model
from edugym.exact.policies import policy_of
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.mdp.task import task_of
from edugym_course.lessons.own_problem.exact import DISCOUNT, MOST_STEPS, worth

N_STEPS = 10_000
REPETITIONS = 20
EPSILON = 0.1
LEARNING_RATE = 0.1

Maker = Callable[..., Any]


def methods_with(
    epsilon: float = EPSILON, learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT
) -> dict[str, Maker]:
    """Return the methods: by label, functions that make the agent for an environment."""
    settings: dict[str, Any] = {
        "learning_rate": learning_rate,
        "discount": discount,
        "exploration": EpsilonGreedy(epsilon),
    }
    return {
        "Q-learning": partial(QLearning.create, **settings),
        "SARSA": partial(SARSA.create, **settings),
        "Dyna-10": partial(DynaQ.create, planning_steps=10, **settings),
        "3-step SARSA": partial(NStepSARSA.create, n=3, **settings),
        "novelty reward": partial(CountBased.create, **settings),
    }


def learn(mdp: Any, methods: Mapping[str, Maker] | None = None, n_steps: int = N_STEPS, **how: Any) -> Results:
    """Train methods on an MDP; further arguments as in `repeat`. A point of a curve is a mean of 20 episodes.

    An MDP without a step limit gets one of `MOST_STEPS`, since a greedy policy may walk in a circle.
    """
    how = {"max_steps": task_of(mdp).max_steps or MOST_STEPS, **how}
    how = {"repetitions": REPETITIONS, "evaluate_every": max(n_steps // 20, 1), "evaluation_episodes": 20, **how}
    return repeat(mdp, methods or methods_with(), n_steps, **how)


def true_returns(results: Results, method: str, judge: Any) -> Reals:
    """Return what the greedy policies that were learned are worth by the reward of `judge`, exactly: one per run.

    Args:
        results: the runs; their tasks may have other rewards than `judge`, but the same states and observations.
        method: the label of the method.
        judge: the MDP with the reward that counts.
    """
    model, limit = finite_model(judge), task_of(judge).max_steps
    agents = results.complete_agents(method).values()
    return np.array([worth(model, policy_of(agent, model, greedy=True), limit) for agent in agents])


def started_at(phi: Reals, environment: Any) -> QLearning:
    """Return Q-learning whose action values start at φ(s) in place of 0, with the settings of the lesson.

    Args:
        phi: the number at which the values of a state start, by time and depth.
        environment: the morning.
    """
    agent: QLearning = methods_with()["Q-learning"](environment)
    agent.Q[:] = phi.reshape(-1, 1)
    return agent


def as_meant(
    tasks: Mapping[str, Any],
    judge: Any,
    budgets: Sequence[int],
    *,
    make: Maker | None = None,
    repetitions: int = REPETITIONS,
    **how: Any,
) -> dict[str, Reals]:
    """Return what Q-learning's policies are worth by the reward of `judge`, when it learned from those of `tasks`.

    Args:
        tasks: by label, MDPs that differ from `judge` in the reward alone.
        judge: the MDP with the reward that counts.
        budgets: the training steps after which to look, in ascending order.
        make: makes the agent for an environment; by default Q-learning with the settings of the lesson.
        repetitions: the runs of each.
        **how: more arguments of `repeat`, such as `seed`.

    Returns:
        By label, shape (n_budgets, n_repetitions).
    """
    method = {"Q-learning": make or methods_with()["Q-learning"]}
    how = {"evaluate_every": budgets[-1], "repetitions": repetitions, **how}
    return {
        label: np.array([true_returns(repeat(task, method, budget, **how), "Q-learning", judge) for budget in budgets])
        for label, task in tasks.items()
    }
