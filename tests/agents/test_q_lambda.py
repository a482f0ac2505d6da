"""Q(λ): its traces by hand, where they are cut, and what they are worth."""

from typing import Any

import numpy as np
import pytest

from edugym import Accumulating, Dutch, QLambda, QLearning, Replacing, make_mdp, mean_interval, train
from tests.agents.case import Case
from tests.agents.walk import Walk, exact_values

CASES = {
    "QLambda": Case(QLambda, lambda e: QLambda.create(e, learning_rate=0.5, discount=0.5), True),
    "QLambda, accumulating": Case(QLambda, lambda e: QLambda.create(e, traces=Accumulating())),
    "QLambda, Dutch": Case(QLambda, lambda e: QLambda.create(e, traces=Dutch())),
}


def after_two_steps(next_action: int, truncated: bool = False) -> QLambda:
    """From 0 to 1, where Q = [4, 8]; there it takes `next_action`, gets 10 and ends. α = 1/2, γ = 1."""
    agent = QLambda.create((3, 2), learning_rate=0.5, discount=1, trace_decay=0.5)
    agent.Q[1] = [4.0, 8.0]
    agent.learn(0, 0, 2.0, 1, next_action, False, truncated)
    agent.learn(1, next_action, 10.0, 2, 0, True, False)
    return agent


def test_two_steps_by_hand() -> None:
    """The greedy action: δ = 2 + 8, so Q(0, 0) = 5; then δ = 10 - 8 with a trace of 1/2: Q(0, 0) = 5.5, Q(1, 1) = 9.

    Another action: its 10 - 4 says nothing about the greedy policy, and Q(0, 0) stays at 5.
    """
    assert after_two_steps(1).Q.tolist() == [[5.5, 0], [4, 9], [0, 0]]
    assert after_two_steps(0).Q.tolist() == [[5.0, 0], [7, 8], [0, 0]]


def test_truncation_bootstraps_and_cuts() -> None:
    """The first step still learned from 8."""
    assert after_two_steps(1, truncated=True).Q[0, 0] == 5.0


def test_a_tie_is_greedy() -> None:
    """Either of two best actions leaves the traces."""
    agent = QLambda.create((3, 2), learning_rate=0.5)
    agent.learn(0, 0, 1.0, 1, 1, False, False)
    assert agent.Z.n[0] == 1


@pytest.mark.parametrize("traces", [Accumulating(), Replacing(), Dutch()])
def test_without_lambda_it_is_q_learning(traces: Any) -> None:
    """The same updates on the same steps, to rounding."""
    agents: list[Any] = [QLearning.create((5, 2)), QLambda.create((5, 2), trace_decay=0, traces=traces)]
    rng = np.random.default_rng(0)
    for _ in range(500):
        s, a, n, b = int(rng.integers(5)), int(rng.integers(2)), int(rng.integers(5)), int(rng.integers(2))
        reward, end = float(rng.normal()), bool(rng.random() < 0.1)
        agents[0].learn(s, a, reward, n, end)
        agents[1].learn(s, a, reward, n, b, end, False)
    assert pytest.approx(agents[1].Q, rel=1e-9) == agents[0].Q


@pytest.mark.parametrize("traces", [Accumulating(), Replacing(), Dutch()])
def test_it_learns_the_values_of_the_greedy_policy(traces: Any) -> None:
    """Though it explores; the exact ones in the limit."""
    agent = QLambda.create(Walk(), traces=traces, discount=0.9, learning_rate=0.002)
    for seed in range(4):
        train(Walk(), agent, 200_000, seed=seed, evaluate_every=200_000)
    assert pytest.approx(exact_values(Walk(), 0.9), abs=0.08) == agent.Q


def test_traces_learn_faster() -> None:
    """Supermarket over the first 8 000 steps and over seeds: λ = 0.9 is ahead of λ = 0."""
    mdp = make_mdp("Supermarket")

    def returns(trace_decay: float) -> Any:
        agents = [QLambda.create(mdp, trace_decay=trace_decay) for _ in range(10)]
        runs = [train(mdp, agent, 8_000, seed=s, evaluate_every=500).returns for s, agent in enumerate(agents)]
        return np.array(runs)[:, 1:].mean(axis=1)

    assert mean_interval(returns(0.9) - returns(0.0)).low > 0


@pytest.mark.parametrize(
    ("setting", "value", "allowed"),
    [("trace_decay", 1.1, "from 0 to 1"), ("traces", Dutch, "Accumulating")],
)
def test_settings_out_of_range_are_refused(setting: str, value: Any, allowed: str) -> None:
    """The message names the parameter, its value and what is allowed."""
    with pytest.raises(ValueError, match=rf"{setting} must be .*{allowed}.*, but is {value!r}"):
        QLambda.create((4, 2), **{setting: value})
