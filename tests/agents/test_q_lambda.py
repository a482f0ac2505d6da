"""Q(λ): its traces by hand, where they are cut, and what they are worth."""

from edugym import Accumulating, Dutch, QLambda
from tests.agents.case import Case

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
