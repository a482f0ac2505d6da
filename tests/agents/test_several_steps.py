"""The agents that learn from several steps at once, against the boxes of the textbook: n-step methods and traces."""

import math
from typing import Any

import numpy as np
import pytest

import edugym as eg
from edugym.checks.contract import is_on_policy
from edugym.mdp.protocol import Reals
from tests.agents.walk import Walk

S, A = [0, 1, 0, 2, 3], [1, 0, 1, 0, 1]  # an episode of four steps, and what comes after it is cut off
R = [0.0, 1.0, 2.0, 4.0, 8.0]  # R[t + 1] is the reward of step t, as in the textbook
T = 4
FIRST: Reals = np.random.default_rng(2).normal(size=(4, 2))


def told(agent: Any, terminated: bool, steps: int = T) -> Any:
    """The agent after some steps of the episode, which ends or is cut off after the last."""
    for t in range(steps):
        more = (A[t + 1],) if is_on_policy(agent) else ()
        last = t == T - 1
        agent.learn(S[t], A[t], R[t + 1], S[t + 1], *more, last and terminated, last and not terminated)
    return agent


def starting(agent: Any) -> Any:
    """The agent with first values that are all different."""
    agent.Q[...] = FIRST
    return agent


def n_step_sarsa(n: int, terminated: bool) -> Reals:
    """The box of section 7.2 on the episode, with its lists, α = 0.5 and γ = 0.9."""
    Q = FIRST.copy()
    for t in range(T + n):
        tau = t - n + 1
        if 0 <= tau < T:
            end = min(tau + n, T)
            G = sum(0.9 ** (i - tau - 1) * R[i] for i in range(tau + 1, end + 1))
            if tau + n < T or not terminated:
                G += 0.9 ** (end - tau) * Q[S[end], A[end]]
            Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
    return Q


@pytest.mark.parametrize("terminated", [True, False])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 50, math.inf])
def test_n_step_sarsa_is_the_box(n: float, terminated: bool) -> None:
    """To rounding, with a pair that comes twice, at the end of the task and at truncation."""
    agent = told(starting(eg.NStepSARSA.create((4, 2), n=n, learning_rate=0.5, discount=0.9)), terminated)
    expected, other = (n_step_sarsa(int(min(n, 1_000)), end) for end in (terminated, not terminated))
    assert pytest.approx(expected, rel=1e-13) == agent.Q
    assert not np.allclose(expected, other)


def test_nothing_is_learned_before_n_steps() -> None:
    """And with n = ∞ nothing before the end."""
    for n, learned in ((2, True), (3, True), (4, False), (math.inf, False)):
        assert told(eg.NStepSARSA.create((4, 2), n=n), False, steps=3).Q.any() == learned


def test_an_episode_longer_than_the_memory_is_learned_with_what_there_is() -> None:
    """Any n above 3 with a memory of 3 is n = 3."""
    agents = [eg.NStepSARSA.create((5, 2), n=n, longest=3) for n in (3, 7, math.inf)]
    for agent in agents:
        eg.train(Walk(), agent, 2_000, seed=4)
    assert all(np.array_equal(agents[0].Q, agent.Q) for agent in agents)


def tree_backup(n: int, policy: Any, terminated: bool) -> Reals:
    """The box of section 7.5 likewise; after truncation the last step has its leaves like any other."""
    Q = FIRST.copy()

    def pi(s: int) -> list[float]:
        return [policy.probability(Q, s, a) for a in range(2)]

    for t in range(T + n):
        tau = t + 1 - n
        if not 0 <= tau < T:
            continue
        end = min(t + 1, T)
        G = R[end] + (0.0 if end == T and terminated else 0.9 * float(np.dot(pi(S[end]), Q[S[end]])))
        for k in range(end - 1, tau, -1):
            leaves = sum(p * Q[S[k], a] for a, p in enumerate(pi(S[k])) if a != A[k])
            G = R[k] + 0.9 * leaves + 0.9 * pi(S[k])[A[k]] * G
        Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
    return Q


@pytest.mark.parametrize("terminated", [True, False])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 20])
@pytest.mark.parametrize("policy", [eg.Greedy(), eg.EpsilonGreedy(0.4), eg.Softmax(1.0)])
def test_tree_backup_is_the_box(policy: Any, n: int, terminated: bool) -> None:
    """To rounding, likewise."""
    agent = eg.TreeBackup.create((4, 2), n=n, learning_rate=0.5, discount=0.9, target_policy=policy)
    told(starting(agent), terminated)
    assert pytest.approx(tree_backup(n, policy, terminated), rel=1e-12) == agent.Q
    assert pytest.approx(tree_backup(n, policy, not terminated), rel=1e-3) != agent.Q


@pytest.mark.parametrize(("traces", "trace"), [(eg.Accumulating(), 1.25), (eg.Replacing(), 1.0), (eg.Dutch(), 1.125)])
def test_the_trace_of_a_pair_that_comes_again(traces: Any, trace: float) -> None:
    """γλ = 1/2 and two steps after the first visit: 1/4 is left of it; α = 1/2."""
    agent = eg.SARSALambda.create((4, 2), traces=traces, learning_rate=0.5, discount=1, trace_decay=0.5)
    told(agent, True, steps=3)
    assert [agent.Z.value(*pair) for pair in ((0, 1), (1, 0), (2, 0))] == [trace / 2, 0.25, 0.0]  # faded once more
    agent.learn(S[3], A[3], R[4], S[4], A[4], True, False)
    assert agent.Z.n[0] == 0
    assert not agent.Z.places.any()


def test_negligible_traces_are_dropped() -> None:
    """And the others stay with their pairs."""
    agent = eg.SARSALambda.create((40, 1), discount=1, trace_decay=0.1)
    for state in range(30):
        agent.learn(state, 0, 0.0, state + 1, 0, False, False)
    assert agent.Z.n[0] == 9
    left = [0.0] + [0.1 ** (30 - s) for s in range(21, 30)]
    assert [agent.Z.value(state, 0) for state in range(20, 30)] == pytest.approx(left, rel=1e-6)


def online_lambda_return(lam: float, terminated: bool) -> Reals:
    """Section 12.4 for action values: at every horizon all updates again from the first Q on, with cut λ-returns."""
    final = [FIRST]  # final[h]: the table after horizon h

    def cut(t: int, n: int) -> float:
        """The n-step return from t, with the table that there was at t + n - 1."""
        G = sum(0.9 ** (i - t - 1) * R[i] for i in range(t + 1, t + n + 1))
        last = t + n
        bootstrap = 0.0 if last == T and terminated else float(final[last - 1][S[last], A[last]])
        return float(G + 0.9**n * bootstrap)

    for h in range(1, T + 1):
        table = FIRST.copy()
        for t in range(h):
            G = (1 - lam) * sum(lam ** (n - 1) * cut(t, n) for n in range(1, h - t))
            G += lam ** (h - t - 1) * cut(t, h - t)
            table[S[t], A[t]] += 0.5 * (G - table[S[t], A[t]])
        final.append(table)
    return final[T]


@pytest.mark.parametrize("terminated", [True, False])
@pytest.mark.parametrize("trace_decay", [0.0, 0.4, 1.0])
def test_dutch_traces_are_the_online_lambda_return(trace_decay: float, terminated: bool) -> None:
    """To rounding; the other traces are not, unless λ = 0."""
    exact = online_lambda_return(trace_decay, terminated)
    for traces in (eg.Dutch(), eg.Accumulating(), eg.Replacing()):
        agent = eg.SARSALambda.create((4, 2), traces=traces, learning_rate=0.5, discount=0.9, trace_decay=trace_decay)
        told(starting(agent), terminated)
        assert np.allclose(agent.Q, exact, rtol=1e-12) == (isinstance(traces, eg.Dutch) or trace_decay == 0)


@pytest.mark.parametrize(
    ("kind", "action", "truncated", "Q"),
    [
        (eg.QLambda, 1, False, [[5.5, 0], [4, 9], [0, 0]]),  # δ = 2 + 8, Q(0, 0) = 5; then δ = 10 - 8, and half a trace
        (eg.QLambda, 0, False, [[5.0, 0], [7, 8], [0, 0]]),  # 10 - 4 says nothing about the greedy policy
        (eg.QLambda, 1, True, [[5.0, 0], [4, 9], [0, 0]]),  # the first step still learned from 8
        (eg.SARSALambda, 0, False, [[4.5, 0], [7, 8], [0, 0]]),  # δ = 2 + 4, Q(0, 0) = 3; then δ = 10 - 4
        (eg.SARSALambda, 1, True, [[5.0, 0], [4, 9], [0, 0]]),
    ],
)
def test_two_steps_with_traces_by_hand(kind: Any, action: int, truncated: bool, Q: Any) -> None:
    """From 0 to 1, where Q = [4, 8]; there it takes an action, gets 10 and ends. α = λ = 1/2, γ = 1."""
    agent = kind.create((3, 2), learning_rate=0.5, discount=1, trace_decay=0.5)
    agent.Q[1] = [4.0, 8.0]
    agent.learn(0, 0, 2.0, 1, action, False, truncated)
    agent.learn(1, action, 10.0, 2, 0, True, False)
    assert agent.Q.tolist() == Q


def test_a_tie_is_greedy() -> None:
    """Either of two best actions leaves the traces."""
    agent = eg.QLambda.create((3, 2), learning_rate=0.5)
    agent.learn(0, 0, 1.0, 1, 1, False, False)
    assert agent.Z.n[0] == 1
