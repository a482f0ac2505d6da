"""What the agents achieve, over seeds, each claim with a control that fails.

A claim is about a share of runs, and its interval is the exact one of Clopper and Pearson at 95 %.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.stats import binomtest

from edugym import CountBased, EpsilonGreedy, ExponentialDecay, GoExplore, QLearning, ScheduledEpsilonGreedy, make_mdp
from edugym.envs.boulder import Boulder
from edugym.training.train import train

SEEDS = 20
NOTHING = 5e-324
"""A learning rate so small that nothing is learned: the smallest number above 0."""


def climbs(agent: QLearning | CountBased, mdp: Boulder) -> bool:
    """Whether the right grip is the only best one at every height."""
    best = agent.Q[:-1].max(axis=1, keepdims=True) == agent.Q[:-1]
    return bool((best.sum(axis=1) == 1).all() and (agent.Q[:-1].argmax(axis=1) == mdp.grips).all())


def interval(run: Callable[[int], bool], n: int = SEEDS) -> tuple[float, float]:
    """Between which shares of runs succeed, judged by `n` of them."""
    ends = binomtest(sum(map(run, range(n))), n).proportion_ci()
    return ends.low, ends.high


def on_boulder(height: int, n_steps: int, create: Callable[[Any], Any]) -> Callable[[int], bool]:
    """A run on a wall, whose layout and random streams come from the seed: does the agent climb it?"""

    def run(seed: int) -> bool:
        mdp = make_mdp("Boulder", height=height, layout_seed=seed)
        agent = create(mdp)
        train(mdp, agent, n_steps, seed=seed, evaluate_every=n_steps)
        return climbs(agent, mdp)

    return run


def test_q_learning_climbs_a_low_wall() -> None:
    """Height 5 in 10 000 steps; without learning it does not."""
    low, _ = interval(on_boulder(5, 10_000, QLearning.create))
    _, high = interval(on_boulder(5, 10_000, lambda mdp: QLearning.create(mdp, learning_rate=NOTHING)))
    assert low > 0.8
    assert high < 0.2


def test_counting_climbs_where_epsilon_greedy_does_not() -> None:
    """Height 25, where random climbing takes 67 million steps on average: the bonus does it in 100 000."""
    settings = {"learning_rate": 0.5, "discount": 0.9}
    low, _ = interval(on_boulder(25, 100_000, lambda mdp: CountBased.create(mdp, **settings)))
    _, high = interval(on_boulder(25, 100_000, QLearning.create))
    _, without_bonus = interval(on_boulder(25, 100_000, lambda mdp: CountBased.create(mdp, bonus=0.0, **settings)))
    assert low > 0.8
    assert high < 0.2
    assert without_bonus < 0.2


def test_go_explore_climbs_a_high_wall() -> None:
    """Height 100 in 20 000 steps, which is beyond Q-learning."""

    def solved(create: Callable[[Any], Any]) -> Callable[[int], bool]:
        def run(seed: int) -> bool:
            mdp = make_mdp("Boulder", height=100, layout_seed=seed)
            return bool(train(mdp, create(mdp), 20_000, seed=seed, evaluate_every=20_000).returns[-1] == 1.0)

        return run

    low, _ = interval(solved(GoExplore.create))
    _, high = interval(solved(QLearning.create))
    assert low > 0.8
    assert high < 0.2


def test_exploration_that_fades_earns_more_while_it_learns() -> None:
    """With ε falling to 0 the training episodes become perfect; with a constant ε = 0.5 they stay long."""

    def last_return(exploration: Callable[[], Any]) -> np.ndarray[Any, Any]:
        returns = []
        for seed in range(SEEDS):
            mdp = make_mdp("Boulder", height=5, max_steps=10, layout_seed=seed)
            agent = QLearning.create(mdp, exploration=exploration(), initial_value=1.0)
            returns.append(train(mdp, agent, 20_000, seed=seed, evaluate_every=2_000).training_returns[-1])
        return np.array(returns)

    fading = last_return(lambda: ScheduledEpsilonGreedy.create(ExponentialDecay(0.5, 0.0, 0.999)))
    constant = last_return(lambda: EpsilonGreedy(0.5))
    assert fading.min() > 0.99
    assert constant.max() < 0.6
