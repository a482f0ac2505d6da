"""What the agents achieve: exact values in the limit, and what they are for, each claim with a control that fails."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.stats import binomtest

from edugym import (
    REINFORCE,
    SARSA,
    Accumulating,
    ActorCritic,
    CountBased,
    DoubleQLearning,
    Dutch,
    DynaQ,
    EpsilonGreedy,
    ExponentialDecay,
    GoExplore,
    NStepSARSA,
    PrioritisedSweeping,
    QLambda,
    QLearning,
    RMax,
    SARSALambda,
    ScheduledEpsilonGreedy,
    TreeBackup,
    make_mdp,
    mean_interval,
)
from edugym.training.train import train
from tests.agents.walk import Walk, exact_values

NOTHING = 5e-324
"""A learning rate so small that nothing is learned: the smallest number above 0."""

LIMITS: dict[str, tuple[Any, dict[str, Any], float, float]] = {
    "Double Q-learning": (DoubleQLearning, {"learning_rate": 0.005}, 1.0, 0.0),
    "Tree backup": (TreeBackup, {"learning_rate": 0.001}, 1.0, 0.0),
    "SARSA": (SARSA, {}, 0.3, 0.3),
    "Q-learning": (QLearning, {}, 0.3, 0.0),
    "Q(λ)": (QLambda, {}, 0.3, 0.0),
    "Q(λ), Dutch": (QLambda, {"traces": Dutch()}, 0.3, 0.0),
    "Q(λ), accumulating": (QLambda, {"traces": Accumulating()}, 0.3, 0.0),
}
"""Agents and settings, the ε with which they act, and the ε of the policy whose values they learn."""


@pytest.mark.parametrize(
    ("kind", "settings", "acting", "learned"),
    [pytest.param(*case, id=name, marks=pytest.mark.slow if "," in name else ()) for name, case in LIMITS.items()],
)
def test_exact_values_in_the_limit(kind: Any, settings: dict[str, Any], acting: float, learned: float) -> None:
    """Of many small steps: those of the best ε-soft policy, and not those of another one."""
    settings = {"learning_rate": 0.002, "discount": 0.9, "exploration": EpsilonGreedy(acting)} | settings
    agent = kind.create(Walk(), **settings)
    train(Walk(), agent, 400_000, seed=1, evaluate_every=400_000)
    for table in (agent.Q1, agent.Q2, agent.Q) if hasattr(agent, "Q1") else (agent.Q,):
        assert pytest.approx(exact_values(Walk(), 0.9, epsilon=learned), abs=0.08) == table
        assert pytest.approx(exact_values(Walk(), 0.9, epsilon=learned + 0.5), abs=0.08) != table


def interval(run: Callable[[int], bool], n: int = 12) -> tuple[float, float]:
    """Between which shares of runs succeed, judged by `n` of them: exactly, by Clopper and Pearson at 95 %."""
    ends = binomtest(sum(map(run, range(n))), n).proportion_ci()
    return ends.low, ends.high


def on_boulder(height: int, n_steps: int, create: Callable[[Any], Any]) -> Callable[[int], bool]:
    """A run on a wall, whose layout and random streams come from the seed: does it always climb it in the end?"""

    def climbs(seed: int) -> bool:
        mdp = make_mdp("Boulder", height=height, layout_seed=seed)
        run = train(mdp, create(mdp), n_steps, seed=seed, evaluate_every=n_steps, evaluation_episodes=20)
        return bool(run.returns[-1] == 1.0)

    return climbs


FAST: dict[str, Any] = {"learning_rate": 0.5, "discount": 0.9}
CLIMBERS: dict[str, tuple[int, int, Callable[..., Any], dict[str, Any]]] = {
    "Q-learning": (5, 10_000, QLearning.create, {"learning_rate": NOTHING}),
    "actor-critic": (4, 50_000, lambda mdp, **s: ActorCritic.create(mdp, **{**FAST, **s}), {"learning_rate": NOTHING}),
    "REINFORCE": (4, 50_000, lambda mdp, **s: REINFORCE.create(mdp, **{**FAST, **s}), {"learning_rate": NOTHING}),
    # where random climbing takes 67 million steps on average
    "counting": (25, 100_000, lambda mdp, **s: CountBased.create(mdp, **{**FAST, **s}), {"bonus": 0.0}),
    "Go-Explore": (100, 20_000, GoExplore.create, {"learning_rate": NOTHING}),
}


@pytest.mark.parametrize(("height", "n_steps", "create", "worse"), CLIMBERS.values(), ids=CLIMBERS)
def test_it_climbs_a_wall(height: int, n_steps: int, create: Any, worse: dict[str, Any]) -> None:
    """Where it does not without what the method is about."""
    low, _ = interval(on_boulder(height, n_steps, create))
    _, high = interval(on_boulder(height, n_steps, lambda mdp: create(mdp, **worse)))
    assert low > 0.7
    assert high < 0.3


def test_exploration_that_fades_earns_more_while_it_learns() -> None:
    """With ε falling to 0 the training episodes become perfect; with a constant ε = 0.5 they stay long."""

    def last_returns(exploration: Callable[[], Any]) -> list[float]:
        returns = []
        for seed in range(10):
            mdp = make_mdp("Boulder", height=5, max_steps=10, layout_seed=seed)
            agent = QLearning.create(mdp, exploration=exploration(), initial_value=1.0)
            returns.append(float(train(mdp, agent, 20_000, seed=seed, evaluate_every=2_000).training_returns[-1]))
        return returns

    assert min(last_returns(lambda: ScheduledEpsilonGreedy.create(ExponentialDecay(0.5, 0.0, 0.999)))) > 0.99
    assert max(last_returns(lambda: EpsilonGreedy(0.5))) < 0.6


SHOPPERS: dict[str, tuple[int, Callable[[Any], Any], Callable[[Any], Any]]] = {
    "planning": (2_000, lambda mdp: DynaQ.create(mdp, learning_rate=1), lambda mdp: QLearning.create(mdp, **FAST)),
    "sweeping": (
        500, lambda mdp: PrioritisedSweeping.create(mdp, learning_rate=1), lambda mdp: DynaQ.create(mdp, **FAST)
    ),
    "hope": (2_000, RMax.create, lambda mdp: RMax.create(mdp, highest_return=-100)),
    "traces": (8_000, SARSALambda.create, lambda mdp: SARSALambda.create(mdp, trace_decay=0)),
    "traces, off-policy": (8_000, QLambda.create, lambda mdp: QLambda.create(mdp, trace_decay=0)),
    "several steps": (8_000, NStepSARSA.create, SARSA.create),
    "several steps, off-policy": (8_000, lambda mdp: TreeBackup.create(mdp, n=8), QLearning.create),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("n_steps", "better", "worse"), SHOPPERS.values(), ids=SHOPPERS)
def test_what_a_method_is_for_saves_steps(n_steps: int, better: Any, worse: Any) -> None:
    """Supermarket: its mean return over the first steps is higher than without, over seeds."""
    mdp = make_mdp("Supermarket")

    def returns(create: Any) -> Any:
        runs = [train(mdp, create(mdp), max(n_steps, 5_000), seed=s, evaluate_every=250).returns for s in range(10)]
        return np.array(runs)[:, 1 : n_steps // 250 + 1].mean(axis=1)

    assert mean_interval(returns(better) - returns(worse)).low > 0
