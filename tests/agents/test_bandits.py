"""The agents for bandits: their updates by hand, against a second implementation, and what Thompson sampling draws."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import GradientBandit, Greedy, SampleAverage, ThompsonSampling, make_mdp, train
from edugym.mdp.protocol import Reals

PULLS = st.lists(st.tuples(st.integers(0, 1), st.integers(0, 2), st.floats(-10, 10)), min_size=1, max_size=30)
"""State, action and reward of each."""


def test_sample_averages_by_hand() -> None:
    """Rewards 4, 0 and 5 of one action have the means 4, 2 and 3; the first replaces the initial value."""
    agent, means = SampleAverage.create((2, 2), initial_value=9), []
    for reward in (4.0, 0.0, 5.0):
        agent.learn(0, 1, reward)
        means.append(agent.Q[0, 1])
    assert means == [4, 2, 3]
    assert agent.Q.tolist() == [[9, 3], [9, 9]]
    assert agent.counts.tolist() == [[0, 3], [0, 0]]


@given(PULLS)
def test_a_sample_average_is_the_mean_of_the_rewards(pulls: list[tuple[int, int, float]]) -> None:
    """Of each action in each state."""
    agent = SampleAverage.create((2, 3))
    for pull in pulls:
        agent.learn(*pull)
    for state in range(2):
        for action in range(3):
            rewards = [reward for s, a, reward in pulls if (s, a) == (state, action)]
            assert agent.counts[state, action] == len(rewards)
            assert agent.Q[state, action] == pytest.approx(np.mean(rewards) if rewards else 0.0, rel=1e-12, abs=1e-12)


def test_the_gradient_bandit_by_hand() -> None:
    """Two actions, α = 0.5. The first reward is its own baseline, so it changes nothing; then 3 against a mean of 1.

    H = ±0.5 (3 - 1) 0.5 = ±0.5, and the baseline is 2; then 0 for the rarer action, which makes it rarer still.
    """
    agent = GradientBandit.create((1, 2), learning_rate=0.5)
    agent.learn(0, 0, 1.0)
    assert agent.preferences.tolist() == [[0, 0]]
    agent.learn(0, 0, 3.0)
    assert agent.preferences.tolist() == [[0.5, -0.5]]
    assert agent.baseline.tolist() == [2]
    agent.learn(0, 1, 0.0)
    p = math.e / (1 + math.e)  # of the first action, whose preference is larger by 1
    assert agent.preferences[0] == pytest.approx([0.5 + p, -0.5 - p], abs=1e-12)


def box(pulls: list[tuple[int, int, float]], alpha: float) -> Reals:
    """The preferences of equation 2.12, written with NumPy."""
    H, before = np.zeros((2, 3)), {0: [], 1: []}  # type: tuple[Reals, dict[int, list[float]]]
    for state, action, reward in pulls:
        pi = np.exp(H[state]) / np.exp(H[state]).sum()
        baseline = np.mean(before[state] or [reward])
        H[state] -= alpha * (reward - baseline) * pi
        H[state, action] += alpha * (reward - baseline)
        before[state].append(reward)
    return H


@given(PULLS, st.floats(0.01, 1))
def test_the_gradient_bandit_is_the_textbooks(pulls: list[tuple[int, int, float]], alpha: float) -> None:
    """To 1e-12 of the largest preference."""
    agent = GradientBandit.create((2, 3), learning_rate=alpha)
    for pull in pulls:
        agent.learn(*pull)
    expected = box(pulls, alpha)
    assert np.abs(agent.preferences - expected).max() <= 1e-12 * max(1.0, np.abs(expected).max())


def chosen(values: list[float], counts: list[int], spread: float, seed: int, n: int = 4_000) -> Reals:
    """How often Thompson sampling chooses each action, with these counts at every choice."""
    Q, rng, found = np.array([values]), np.random.default_rng(seed), np.zeros(len(values))
    for _ in range(n):
        strategy = ThompsonSampling(np.array([counts]), np.zeros((1, len(values))), spread)
        found[strategy.choose(Q, 0, rng)] += 1
    return found / n


@pytest.mark.parametrize("seed", [0, 7])
@pytest.mark.parametrize(
    ("difference", "counts", "spread"), [(0.3, [4, 9], 0.5), (0.3, [400, 900], 0.5), (1.0, [1, 1], 2.0)]
)
def test_how_often_thompson_sampling_chooses(difference: float, counts: list[int], spread: float, seed: int) -> None:
    """Two actions: the difference of the draws is normal, with the variance σ² (1/N₁ + 1/N₂)."""
    deviation = spread * math.sqrt(1 / counts[0] + 1 / counts[1])
    p = 0.5 * (1 + math.erf(difference / deviation / math.sqrt(2)))
    share = chosen([difference, 0.0], counts, spread, seed)[0]
    assert abs(share - p) < 4 * math.sqrt(p * (1 - p) / 4_000) + 1e-3


@pytest.mark.parametrize("seed", [0, 7])
def test_what_is_new_comes_first_and_without_spread_nothing_is_drawn(seed: int) -> None:
    """Among new actions one at random; with spread 0 the best value, ties at random."""
    assert np.abs(chosen([9.0, 0.0, 0.0], [3, 0, 0], 1.0, seed) - [0, 0.5, 0.5]).max() < 0.05
    assert np.abs(chosen([1.0, 1.0, 0.0], [3, 1, 1], 0.0, seed) - [0.5, 0.5, 0]).max() < 0.05


def test_thompson_sampling_counts_its_choices() -> None:
    """Each in its own state."""
    strategy = ThompsonSampling.create((2, 2), spread=0.5)
    for _ in range(5):
        strategy.choose(np.zeros((2, 2)), 1, np.random.default_rng(0))
    assert strategy.counts.sum(axis=1).tolist() == [0, 5]
    assert (strategy.counts[1] > 0).all()


@pytest.mark.parametrize("seed", range(5))
def test_they_find_the_best_arm(seed: int) -> None:
    """In a bandit with a gap of 0.5, as greedy sample averages do not in every layout."""
    mdp = make_mdp("Bandit", gap=0.5, layout_seed=seed)
    thompson = SampleAverage.create(mdp, exploration=ThompsonSampling.create(mdp, spread=0.5))
    for agent in (thompson, SampleAverage.create(mdp), GradientBandit.create(mdp)):
        table = train(mdp, agent, 10_000, seed=seed, evaluate_every=10_000).agent[0]
        assert table[0].argmax() == mdp.first_best


def test_greedy_sample_averages_do_not() -> None:
    """The negative control: whoever never explores keeps the first arm that has paid."""
    found = 0
    for seed in range(20):
        mdp = make_mdp("Bandit", gap=0.5, layout_seed=seed)
        agent = train(mdp, SampleAverage.create(mdp, exploration=Greedy()), 10_000, seed=seed).agent
        found += agent.Q[0].argmax() == mdp.first_best
    assert found < 15
