"""The count-based agent: its bonus and its update, worked out by hand."""

import pytest

from edugym import CountBased
from tests.agents.case import Case

CASES = {
    "CountBased": Case(CountBased, lambda e: CountBased.create(e, bonus=0.0, learning_rate=0.5, discount=0.5), True),
    "CountBased with its bonus": Case(CountBased, CountBased.create),
}


def test_the_first_updates_by_hand() -> None:
    """Three times from state 0 to state 1, with β = 2, α = 1/2, γ = 1/2 and max Q(1, ·) = 4.

    Visit 1: R+ = 1 + 2/√1 = 3,      target 3 + 4/2 = 5:      Q = 0 + (5 - 0)/2 = 5/2.
    Visit 2: R+ = 1 + 2/√2 = 2.4142, target 4.4142:           Q = 5/2 + (4.4142 - 5/2)/2 = 3.4571.
    Visit 3: an end: nothing comes after, but the bonus is paid:
             R+ = 1 + 2/√3 = 2.1547, target 2.1547:           Q = 3.4571 + (2.1547 - 3.4571)/2 = 2.8059.
    """
    agent = CountBased.create((2, 2), bonus=2.0, learning_rate=0.5, discount=0.5)
    agent.Q[1] = [-1.0, 4.0]
    learned = []
    for terminated in (False, False, True):
        agent.learn(0, 1, 1.0, 1, terminated)
        learned.append(agent.Q[0, 1])
    assert learned == pytest.approx([2.5, 3.4571, 2.8059], abs=5e-5)
    assert agent.visits.tolist() == [0, 3]
    assert agent.Q[0, 0] == 0.0
