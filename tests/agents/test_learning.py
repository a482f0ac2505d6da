"""What the agents achieve: exact values in the limit, and what they are for, each claim with a control that fails."""

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
import pytest
from scipy.stats import binomtest

import edugym as eg
from tests.agents.walk import Walk, exact_values

NOTHING = 5e-324
"""A learning rate so small that nothing is learned: the smallest number above 0."""

LIMITS: dict[str, tuple[Any, dict[str, Any], float, float]] = {
    "Double Q-learning": (eg.DoubleQLearning, {"learning_rate": 0.005}, 1.0, 0.0),
    "Maxmin Q-learning, four tables": (eg.MaxminQLearning, {"learning_rate": 0.005}, 1.0, 0.0),
    "Tree backup": (eg.TreeBackup, {"learning_rate": 0.001}, 1.0, 0.0),
    "SARSA": (eg.SARSA, {}, 0.3, 0.3),
    "Q-learning": (eg.QLearning, {}, 0.3, 0.0),
    "Q(λ)": (eg.QLambda, {}, 0.3, 0.0),
    "Q(λ), Dutch": (eg.QLambda, {"traces": eg.Dutch()}, 0.3, 0.0),
    "Q(λ), accumulating": (eg.QLambda, {"traces": eg.Accumulating()}, 0.3, 0.0),
}
"""Agents and settings, the ε with which they act, and the ε of the policy whose values they learn."""
QUICK = ["SARSA"]


@pytest.mark.parametrize(
    ("kind", "settings", "acting", "learned"),
    [pytest.param(*case, id=name, marks=[pytest.mark.slow] * (name not in QUICK)) for name, case in LIMITS.items()],
)
def test_exact_values_in_the_limit(kind: Any, settings: dict[str, Any], acting: float, learned: float) -> None:
    """Of many small steps: those of the best ε-soft policy, and not those of another one."""
    settings = {"learning_rate": 0.002, "discount": 0.9, "exploration": eg.EpsilonGreedy(acting)} | settings
    agent = kind.create(Walk(), **settings)
    eg.train(Walk(), agent, 400_000, seed=1, evaluate_every=400_000)
    for table in (agent.Q1, agent.Q2, agent.Q) if hasattr(agent, "Q1") else (agent.Q,):
        assert pytest.approx(exact_values(Walk(), 0.9, epsilon=learned), abs=0.08) == table
        assert pytest.approx(exact_values(Walk(), 0.9, epsilon=learned + 0.5), abs=0.08) != table


def interval(run: Callable[[int], bool], n: int = 12) -> tuple[float, float]:
    """Between which shares of runs succeed, judged by `n` of them: exactly, by Clopper and Pearson at 95 %."""
    ends = binomtest(sum(map(run, range(n))), n).proportion_ci()
    return ends.low, ends.high


FAST: dict[str, Any] = {"learning_rate": 0.5, "discount": 0.9}
STILL = {"learning_rate": NOTHING}
CLIMBERS: list[tuple[int, int, Any, dict[str, Any], dict[str, Any]]] = [
    (5, 10_000, eg.QLearning, {}, STILL),
    (4, 50_000, eg.ActorCritic, FAST, STILL),
    (4, 50_000, eg.REINFORCE, FAST, STILL),
    (25, 100_000, eg.CountBased, FAST, {"bonus": 0.0}),  # where random climbing takes 67 million steps on average
    (100, 20_000, eg.GoExplore, {}, STILL),
]


@pytest.mark.parametrize(("height", "n_steps", "kind", "settings", "worse"), CLIMBERS)
def test_it_climbs_a_wall(height: int, n_steps: int, kind: Any, settings: Any, worse: dict[str, Any]) -> None:
    """Always, in the end, where it does not without what the method is about; layouts come from the seed."""

    def climbs(seed: int, **more: Any) -> bool:
        mdp = eg.make_mdp("Boulder", height=height, layout_seed=seed)
        agent = kind.create(mdp, **{**settings, **more})
        run = eg.train(mdp, agent, n_steps, seed=seed, evaluate_every=n_steps, evaluation_episodes=20)
        return bool(run.returns[-1] == 1.0)

    low, _ = interval(climbs)
    _, high = interval(lambda seed: climbs(seed, **worse))
    assert low > 0.7
    assert high < 0.3


def test_exploration_that_fades_earns_more_while_it_learns() -> None:
    """With ε falling to 0 the training episodes become perfect; with a constant ε = 0.5 they stay long."""

    def last_returns(exploration: Callable[[], Any]) -> list[float]:
        returns = []
        for seed in range(10):
            mdp = eg.make_mdp("Boulder", height=5, max_steps=10, layout_seed=seed)
            agent = eg.QLearning.create(mdp, exploration=exploration(), initial_value=1.0)
            returns.append(float(eg.train(mdp, agent, 20_000, seed=seed, evaluate_every=2_000).training_returns[-1]))
        return returns

    assert min(last_returns(lambda: eg.ScheduledEpsilonGreedy.create(eg.ExponentialDecay(0.5, 0.0, 0.999)))) > 0.99
    assert max(last_returns(lambda: eg.EpsilonGreedy(0.5))) < 0.6


SHOPPERS: list[tuple[int, tuple[Any, dict[str, Any]], tuple[Any, dict[str, Any]]]] = [
    (2_000, (eg.DynaQ, {"learning_rate": 1}), (eg.QLearning, FAST)),
    (500, (eg.PrioritisedSweeping, {"learning_rate": 1}), (eg.DynaQ, FAST)),
    (2_000, (eg.RMax, {}), (eg.RMax, {"highest_return": -100})),
    (8_000, (eg.SARSALambda, {}), (eg.SARSALambda, {"trace_decay": 0})),
    (8_000, (eg.QLambda, {}), (eg.QLambda, {"trace_decay": 0})),
    (8_000, (eg.NStepSARSA, {}), (eg.SARSA, {})),
    (8_000, (eg.TreeBackup, {"n": 8}), (eg.QLearning, {})),
]


@pytest.mark.slow
@pytest.mark.parametrize(("n_steps", "better", "worse"), SHOPPERS)
def test_what_a_method_is_for_saves_steps(n_steps: int, better: Any, worse: Any) -> None:
    """Supermarket: its mean return over the first steps is higher than without, over seeds."""
    mdp, n = eg.make_mdp("Supermarket"), max(n_steps, 5_000)

    def returns(kind: Any, settings: dict[str, Any]) -> Any:
        runs = [eg.train(mdp, kind.create(mdp, **settings), n, seed=s, evaluate_every=250).returns for s in range(10)]
        return np.array(runs)[:, 1 : n_steps // 250 + 1].mean(axis=1)

    assert eg.mean_interval(returns(*better) - returns(*worse)).low > 0


ONE_HOT = {"features": eg.Identity.create((48, 4), constant=0.0)}
WALKERS: list[tuple[Any, int, dict[str, Any]]] = [
    (eg.QLearning, 15_000, {}),
    (eg.DynaQ, 3_000, {}),
    (eg.PrioritisedSweeping, 3_000, {}),
    (eg.RMax, 3_000, {"highest_return": 0.0, "lowest_return": -1_000.0}),
    (eg.LinearQLearning, 15_000, ONE_HOT),
]


@pytest.mark.parametrize(
    ("kind", "n_steps", "settings"),
    [pytest.param(*case, marks=() if case[1] < 10_000 else pytest.mark.slow) for case in WALKERS],
)
def test_along_the_cliff(kind: Any, n_steps: int, settings: dict[str, Any]) -> None:
    """CliffWalking: 13 steps along the edge (Sutton and Barto, example 6.6)."""
    newest = max(key for key in gymnasium.registry if key.startswith("CliffWalking-v"))
    env: Any = gymnasium.make(newest, disable_env_checker=True)
    rate = {} if kind is eg.RMax else {"learning_rate": 0.5}
    for seed in range(2):
        agent = kind.create(env, discount=1.0, **rate, **settings)
        how: dict[str, Any] = {"evaluate_every": n_steps, "evaluation_episodes": 1, "max_steps": 200}
        assert eg.train(env, agent, n_steps, seed=seed, **how).returns[-1] == -13


@pytest.mark.parametrize(("settings", "top"), [({}, 0.0), ({"discount": 0.9}, 1.0), ({"bonus": 0.01}, 1.0)])
def test_a_large_bonus_outweighs_the_reward(settings: dict[str, float], top: float) -> None:
    """At its defaults, count-based exploration does not end the climb; it does with less of the bonuses to come."""
    for seed in range(5):
        wall = eg.make_mdp("Boulder", height=8, layout_seed=seed)
        run = eg.train(wall, eg.CountBased.create(wall, **settings), 20_000, seed=seed)
        assert run.returns[-1] == top
