"""SARSA(λ): its traces by hand, the online λ-return that Dutch traces compute exactly, and what traces are worth."""

from typing import Any

import numpy as np
import pytest

from edugym import Accumulating, Dutch, Replacing, SARSALambda
from edugym.mdp.protocol import Reals
from tests.agents.case import Case

CASES = {
    "SARSALambda": Case(SARSALambda, lambda e: SARSALambda.create(e, learning_rate=0.5, discount=0.5), True),
    "SARSALambda, accumulating": Case(SARSALambda, lambda e: SARSALambda.create(e, traces=Accumulating())),
    "SARSALambda, Dutch": Case(SARSALambda, lambda e: SARSALambda.create(e, traces=Dutch())),
}
EPISODE = [(0, 1, 1.0, 1, 0), (1, 0, 2.0, 0, 1), (0, 1, 4.0, 2, 0), (2, 0, 8.0, 3, 1)]


def learned(agent: Any, terminated: bool = True) -> Any:
    """The agent after the episode."""
    for t, step in enumerate(EPISODE):
        agent.learn(*step, terminated and t == 3, not terminated and t == 3)
    return agent


@pytest.mark.parametrize(("traces", "trace"), [(Accumulating(), 1.25), (Replacing(), 1.0), (Dutch(), 1.125)])
def test_the_trace_of_a_pair_that_comes_again(traces: Any, trace: float) -> None:
    """γλ = 1/2 and two steps after the first visit: 1/4 is left of it; α = 1/2."""
    agent = SARSALambda.create((4, 2), traces=traces, learning_rate=0.5, discount=1, trace_decay=0.5)
    for step in EPISODE[:3]:
        agent.learn(*step, False, False)
    assert agent.Z.value(0, 1) == trace / 2  # faded once more
    assert agent.Z.value(1, 0) == 0.25
    assert agent.Z.value(2, 0) == 0.0
    agent.learn(*EPISODE[3], True, False)
    assert agent.Z.n[0] == 0
    assert not agent.Z.places.any()


def test_two_steps_by_hand() -> None:
    """α = 1/2, γ = 1, λ = 1/2: δ = 2 gives Q(0, 0) = 1; then δ = 8 gives it 8/2 · 1/2 more, and Q(1, 0) = 4."""
    agent = SARSALambda.create((3, 1), learning_rate=0.5, discount=1, trace_decay=0.5)
    agent.learn(0, 0, 2.0, 1, 0, False, False)
    assert agent.Q[:, 0].tolist() == [1, 0, 0]
    agent.learn(1, 0, 8.0, 2, 0, True, False)
    assert agent.Q[:, 0].tolist() == [3, 4, 0]


def online_lambda_return(Q: Reals, alpha: float, gamma: float, lam: float, terminated: bool) -> Reals:
    """Section 12.4 for action values: at every horizon all updates again from the first Q on, with cut λ-returns."""
    S, A = [s for s, *_ in EPISODE] + [3], [a for _, a, *_ in EPISODE] + [1]
    R = [0.0] + [r for _, _, r, *_ in EPISODE]
    T = len(EPISODE)
    final = [Q]  # final[h]: the table after horizon h

    def cut(t: int, n: int) -> float:
        """The n-step return from t, with the table that there was at t + n - 1."""
        G = sum(gamma ** (i - t - 1) * R[i] for i in range(t + 1, t + n + 1))
        last = t + n
        bootstrap = 0.0 if last == T and terminated else float(final[last - 1][S[last], A[last]])
        return float(G + gamma**n * bootstrap)

    for h in range(1, T + 1):
        table = Q.copy()
        for t in range(h):
            G = (1 - lam) * sum(lam ** (n - 1) * cut(t, n) for n in range(1, h - t)) + lam ** (h - t - 1) * cut(
                t, h - t
            )
            table[S[t], A[t]] += alpha * (G - table[S[t], A[t]])
        final.append(table)
    return final[T]


@pytest.mark.parametrize("terminated", [True, False])
@pytest.mark.parametrize("trace_decay", [0.0, 0.4, 1.0])
def test_dutch_traces_are_the_online_lambda_return(trace_decay: float, terminated: bool) -> None:
    """To rounding; the other traces are not, unless λ = 0."""
    Q = np.random.default_rng(2).normal(size=(4, 2))
    exact = online_lambda_return(Q, 0.5, 0.9, trace_decay, terminated)
    for traces in (Dutch(), Accumulating(), Replacing()):
        agent = SARSALambda.create((4, 2), traces=traces, learning_rate=0.5, discount=0.9, trace_decay=trace_decay)
        agent.Q[...] = Q
        learned(agent, terminated)
        assert np.allclose(agent.Q, exact, rtol=1e-12) == (isinstance(traces, Dutch) or trace_decay == 0)


def test_negligible_traces_are_dropped() -> None:
    """And the others stay with their pairs."""
    agent = SARSALambda.create((40, 1), discount=1, trace_decay=0.1)
    for state in range(30):
        agent.learn(state, 0, 0.0, state + 1, 0, False, False)
    assert agent.Z.n[0] == 9
    assert [agent.Z.value(state, 0) for state in range(20, 30)] == pytest.approx(
        [0.0] + [0.1 ** (30 - s) for s in range(21, 30)], rel=1e-6
    )
