"""The probabilities that strategies know of themselves: those with which they choose."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import UCB, ExpectedSARSA, LinearDecay, ScheduledEpsilonGreedy
from edugym.exact.branching import branches
from tests.agents.cases import STRATEGIES, package_classes

KNOWN = {name: make for name, make in STRATEGIES.items() if hasattr(make((2, 2)), "probability")}
rows = st.lists(st.sampled_from([-1.0, 0.0, 0.5, 2.0]), min_size=1, max_size=5)


@given(rows)
@pytest.mark.parametrize("make", KNOWN.values(), ids=KNOWN)
def test_they_are_those_of_the_choices(make: Any, values: list[float]) -> None:
    """`probability` is how often `choose` gives each action, ties included, and `expected_value` the mean."""
    Q = np.array([[9.0] * len(values), values])
    chosen = [0.0] * len(values)
    for p, action in branches(lambda rng: make(Q.shape).choose(Q, 1, rng)):
        chosen[action] += p
    strategy = make(Q.shape)
    known = [strategy.probability(Q, 1, action) for action in range(len(values))]
    assert known == pytest.approx(chosen)
    assert strategy.expected_value(Q, 1) == pytest.approx(np.dot(chosen, values))


def test_a_schedule_tells_without_counting() -> None:
    """By the ε of the next choice; only a choice is a step of the schedule."""
    strategy, Q = ScheduledEpsilonGreedy(LinearDecay(1.0, 0.0, 10), np.array([5])), np.array([[0.0, 1.0]])
    assert strategy.probability(Q, 0, 1) == pytest.approx(0.75)
    assert strategy.expected_value(Q, 0) == pytest.approx(0.75)
    assert strategy.step[0] == 5


def test_who_knows_one_knows_the_other() -> None:
    """UCB knows neither: its choice depends on counts that the choice itself changes."""
    known = {type(make((2, 2))) for make in KNOWN.values()}
    assert known == set(package_classes("expected_value")) == set(package_classes("probability"))
    assert UCB not in known


def test_what_has_no_probabilities_is_refused() -> None:
    """The message names the strategy (not its arrays), and those that will do."""
    message = r"exploration must be a strategy that knows .*EpsilonGreedy\(0\.1\) \(.*or Softmax\), but is UCB$"
    with pytest.raises(ValueError, match=message):
        ExpectedSARSA.create((4, 2), exploration=UCB.create((4, 2)))
