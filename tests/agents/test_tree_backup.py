"""Tree backup against the box of section 7.5, and its one-step forms."""

from typing import Any

import numpy as np
import pytest

from edugym import (
    EpsilonGreedy,
    Greedy,
    Softmax,
    TreeBackup,
)
from edugym.mdp.protocol import Reals
from tests.agents.case import Case

CASES = {
    "TreeBackup": Case(TreeBackup, lambda env: TreeBackup.create(env, n=3, learning_rate=0.5, discount=0.5), True),
    "TreeBackup, soft target": Case(TreeBackup, lambda e: TreeBackup.create(e, target_policy=EpsilonGreedy(0.3))),
}
EPISODE = [(0, 1, 1.0, 1), (1, 0, 2.0, 0), (0, 1, 4.0, 2), (2, 0, 8.0, 3)]  # state, action, reward, next state


def box(Q: Reals, n: int, alpha: float, gamma: float, policy: Any, terminated: bool) -> Reals:
    """The box on `EPISODE`, with its lists; after truncation the last step has its leaves like any other."""
    Q = Q.copy()
    S = [s for s, _, _, _ in EPISODE] + [3]
    A = [a for _, a, _, _ in EPISODE]
    R = [0.0] + [r for _, _, r, _ in EPISODE]
    T = len(EPISODE)

    def pi(s: int) -> list[float]:
        return [policy.probability(Q, s, a) for a in range(Q.shape[1])]

    for t in range(T + n):
        tau = t + 1 - n
        if not 0 <= tau < T:
            continue
        end = min(t + 1, T)
        G = R[end] + (0.0 if end == T and terminated else gamma * float(np.dot(pi(S[end]), Q[S[end]])))
        for k in range(end - 1, tau, -1):
            leaves = sum(p * Q[S[k], a] for a, p in enumerate(pi(S[k])) if a != A[k])
            G = R[k] + gamma * leaves + gamma * pi(S[k])[A[k]] * G
        Q[S[tau], A[tau]] += alpha * (G - Q[S[tau], A[tau]])
    return Q


@pytest.mark.parametrize("terminated", [True, False])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 20])
@pytest.mark.parametrize("policy", [Greedy(), EpsilonGreedy(0.4), Softmax(1.0)])
def test_it_is_the_box(policy: Any, n: int, terminated: bool) -> None:
    """To rounding, with a pair that comes twice, at the end of the task and at truncation."""
    Q = np.random.default_rng(2).normal(size=(4, 2))
    agent = TreeBackup.create((4, 2), n=n, learning_rate=0.5, discount=0.9, target_policy=policy)
    agent.Q[...] = Q
    for t, step in enumerate(EPISODE):
        agent.learn(*step, terminated and t == 3, not terminated and t == 3)
    assert pytest.approx(box(Q, n, 0.5, 0.9, policy, terminated), rel=1e-12) == agent.Q
    assert pytest.approx(box(Q, n, 0.5, 0.9, policy, not terminated), rel=1e-3) != agent.Q


def test_two_steps_by_hand() -> None:
    """With n = 2, α = 1, γ = 1/2, Q(1, ·) = [4, 8] and a greedy target, G stops at action 0 of state 1.

    (0, 0) pays 1, (1, 0) pays 99 and ends: Q(0, 0) = 1 + 8/2 = 5, and Q(1, 0) = 99.
    With action 1 instead: Q(0, 0) = 1 + 99/2.
    """
    for action, value in ((0, 5.0), (1, 50.5)):
        agent = TreeBackup.create((3, 2), n=2, learning_rate=1, discount=0.5)
        agent.Q[1] = [4.0, 8.0]
        agent.learn(0, 0, 1.0, 1, False, False)
        agent.learn(1, action, 99.0, 2, True, False)
        assert agent.Q[0, 0] == value
        assert agent.Q[1, action] == 99.0
