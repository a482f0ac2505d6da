"""Tree backup against the box of section 7.5, and its one-step forms."""

from typing import Any

import numpy as np
import pytest

from edugym import (
    UCB,
    EpsilonGreedy,
    ExpectedSARSA,
    Greedy,
    QLearning,
    Softmax,
    TreeBackup,
    make_mdp,
    mean_interval,
    train,
)
from edugym.mdp.protocol import Reals
from tests.agents.case import Case
from tests.agents.walk import Walk, exact_values

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


@pytest.mark.parametrize(
    ("other", "target"), [(QLearning, Greedy()), (ExpectedSARSA, EpsilonGreedy(0.1))], ids=["greedy", "soft"]
)
def test_with_one_step_it_is(other: Any, target: Any) -> None:
    """Q-learning for a greedy target, expected SARSA for one that explores likewise; bit for bit."""
    agents = [other.create((5, 2)), TreeBackup.create((5, 2), n=1, target_policy=target)]
    for agent in agents:
        train(Walk(), agent, 2_000, seed=4, max_steps=7)
    assert np.array_equal(agents[0].Q, agents[1].Q)
    assert agents[0].Q.any()


def test_it_learns_the_values_of_its_target_whatever_is_done() -> None:
    """Acting at random it finds the values of the greedy policy, with several steps and without weights."""
    agent = TreeBackup.create(Walk(), n=4, discount=0.9, learning_rate=0.001, exploration=EpsilonGreedy(1))
    train(Walk(), agent, 300_000, seed=0, evaluate_every=300_000)
    assert pytest.approx(exact_values(Walk(), 0.9), abs=0.05) == agent.Q
    assert pytest.approx(exact_values(Walk(), 0.9, epsilon=0.5), abs=0.05) != agent.Q


def test_more_steps_learn_faster() -> None:
    """Supermarket after 4 000 steps, over seeds: eight steps are ahead of one; the same against itself is not."""
    mdp = make_mdp("Supermarket")

    def returns(n: int) -> Any:
        runs = [train(mdp, TreeBackup.create(mdp, n=n), 8_000, seed=s, evaluate_every=500).returns for s in range(10)]
        return np.array(runs)[:, 1:].mean(axis=1)

    one, eight = returns(1), returns(8)
    assert mean_interval(eight - one).low > 0


@pytest.mark.parametrize(
    ("setting", "value", "message"),
    [
        ("n", 0, "n must be .*1 or more.*, but is 0"),
        ("n", 1.5, "n must be a whole number.*, but is 1.5"),
        ("target_policy", UCB.create((4, 2)), "target_policy must be a strategy that knows .*, but is UCB"),
    ],
)
def test_settings_out_of_range_are_refused(setting: str, value: Any, message: str) -> None:
    """The message names the parameter, its value and what is allowed."""
    with pytest.raises(ValueError, match=message):
        TreeBackup.create((4, 2), **{setting: value})
