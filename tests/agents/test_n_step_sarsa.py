"""n-step SARSA against the box of section 7.2, and its two ends: SARSA and Monte Carlo."""

import math
from typing import Any

import numpy as np
import pytest

from edugym import NStepSARSA, train
from edugym.mdp.protocol import Reals
from tests.agents.case import Case
from tests.agents.walk import Walk

CASES = {
    "NStepSARSA": Case(NStepSARSA, lambda env: NStepSARSA.create(env, n=3, learning_rate=0.5, discount=0.5), True),
    "Monte Carlo": Case(NStepSARSA, lambda env: NStepSARSA.create(env, n=math.inf, longest=25)),
}

EPISODE = [(0, 1, 1.0), (1, 0, 2.0), (0, 1, 4.0), (2, 0, 8.0)]  # state, action, reward; then state 3, action 1


def told(agent: Any, terminated: bool, truncated: bool, episode: Any = EPISODE) -> Any:
    """The agent after the episode."""
    following = [*[(s, a) for s, a, _ in episode[1:]], (3, 1)]
    for t, ((s, a, r), (next_s, next_a)) in enumerate(zip(episode, following, strict=True)):
        last = t == len(episode) - 1
        agent.learn(s, a, r, next_s, next_a, terminated and last, truncated and last)
    return agent


def box(Q: Reals, n: int, alpha: float, gamma: float, terminated: bool) -> Reals:
    """The box of section 7.2 on `EPISODE`, with its lists; a truncated episode has the value of (3, 1) after it."""
    Q = Q.copy()
    S, A = [s for s, _, _ in EPISODE] + [3], [a for _, a, _ in EPISODE] + [1]
    R = [0.0] + [r for _, _, r in EPISODE]
    T = len(EPISODE)
    for t in range(T + n):
        tau = t - n + 1
        if 0 <= tau < T:
            G = sum(gamma ** (i - tau - 1) * R[i] for i in range(tau + 1, min(tau + n, T) + 1))
            if tau + n < T or not terminated:
                end = min(tau + n, T)
                G += gamma ** (end - tau) * Q[S[end], A[end]]
            Q[S[tau], A[tau]] += alpha * (G - Q[S[tau], A[tau]])
    return Q


@pytest.mark.parametrize("terminated", [True, False])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 50, math.inf])
def test_it_is_the_box(n: float, terminated: bool) -> None:
    """To rounding, with a pair that comes twice, at the end of the task and at truncation."""
    Q = np.random.default_rng(2).normal(size=(4, 2))
    agent = NStepSARSA.create((4, 2), n=n, learning_rate=0.5, discount=0.9)
    agent.Q[...] = Q
    told(agent, terminated, not terminated)
    expected = box(Q, int(min(n, 1_000)), 0.5, 0.9, terminated)
    assert pytest.approx(expected, rel=1e-13) == agent.Q
    assert not np.allclose(expected, box(Q, int(min(n, 1_000)), 0.5, 0.9, not terminated))


def test_two_steps_by_hand() -> None:
    """With n = 2, α = 1/2, γ = 1/2, Q = 0: each pair in turn.

    (0, 1): G = 1 + 2/2 + Q(0, 1)/4 = 2            Q = 1
    (1, 0): G = 2 + 4/2 + Q(2, 0)/4 = 4            Q = 2
    (0, 1): G = 4 + 8/2 = 8                        Q = 1 + (8 - 1)/2 = 4.5
    (2, 0): G = 8                                  Q = 4
    """
    agent = told(NStepSARSA.create((4, 2), n=2, learning_rate=0.5, discount=0.5), True, False)
    assert agent.Q.tolist() == [[0, 4.5], [2, 0], [4, 0], [0, 0]]


def test_nothing_is_learned_before_n_steps() -> None:
    """And with n = ∞ nothing before the end."""
    for n, learned in ((3, True), (5, False), (math.inf, False)):
        agent = told(NStepSARSA.create((4, 2), n=n), False, False)
        assert agent.Q.any() == learned


def test_with_n_infinite_it_is_monte_carlo() -> None:
    """At γ = 1 and α = 1/k for the k-th visit the value is the mean return; here α = 1: the last return."""
    agent = told(NStepSARSA.create((4, 2), n=math.inf, learning_rate=1, discount=1), True, False)
    assert agent.Q.tolist() == [[0, 12], [14, 0], [8, 0], [0, 0]]


def test_an_episode_longer_than_the_memory_is_learned_with_what_there_is() -> None:
    """Any n above 3 with a memory of 3 is n = 3."""
    agents = [NStepSARSA.create((5, 2), n=n, longest=3) for n in (3, 7, math.inf)]
    for agent in agents:
        train(Walk(), agent, 2_000, seed=4)
    assert all(np.array_equal(agents[0].Q, agent.Q) for agent in agents)
