"""The probabilities that strategies know of themselves: those with which they choose."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import UCB, EpsilonGreedy, ExpectedSARSA, Greedy, LinearDecay, ScheduledEpsilonGreedy, Softmax
from edugym.exact.branching import branches
from tests.agents.cases import package_classes

KNOWN: dict[str, Callable[[], Any]] = {
    "greedy": Greedy,
    "epsilon-greedy": lambda: EpsilonGreedy(0.3),
    "always exploring": lambda: EpsilonGreedy(1.0),
    "schedule": lambda: ScheduledEpsilonGreedy(LinearDecay(1.0, 0.0, 10), np.array([4])),
    "softmax": lambda: Softmax(0.7),
    "softmax, almost greedy": lambda: Softmax(1e-300),
}
rows = st.lists(st.sampled_from([-1.0, 0.0, 0.5, 2.0]), min_size=1, max_size=5)


@given(rows)
@pytest.mark.parametrize("make", KNOWN.values(), ids=KNOWN)
def test_they_are_those_of_the_choices(make: Any, values: list[float]) -> None:
    """`probability` is how often `choose` gives each action, ties included, and `expected_value` the mean."""
    Q = np.array([[9.0] * len(values), values])
    chosen = [0.0] * len(values)
    for p, action in branches(lambda rng: make().choose(Q, 1, rng)):
        chosen[action] += p
    strategy = make()
    known = [strategy.probability(Q, 1, action) for action in range(len(values))]
    assert known == pytest.approx(chosen)
    assert strategy.expected_value(Q, 1) == pytest.approx(np.dot(chosen, values))


def test_a_schedule_tells_without_counting() -> None:
    """Only a choice is a step of the schedule."""
    strategy = ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.0, 10))
    strategy.probability(np.zeros((1, 2)), 0, 0)
    strategy.expected_value(np.zeros((1, 2)), 0)
    assert strategy.step[0] == 0


def test_all_strategies_but_ucb_are_here() -> None:
    """UCB's choice depends on counts that the choice itself changes."""
    known = {type(make()) for make in KNOWN.values()}
    assert known == set(package_classes("choose")) - {UCB}
    assert known == set(package_classes("expected_value")) == set(package_classes("probability"))


@pytest.mark.parametrize("exploration", [UCB.create((4, 2)), Greedy])
def test_what_has_no_probabilities_is_refused(exploration: Any) -> None:
    """The message names the strategy, and those that will do."""
    with pytest.raises(ValueError, match=r"exploration must be a strategy .*"):
        ExpectedSARSA.create((4, 2), exploration=exploration)


def test_the_message_says_what_will_do() -> None:
    """Not the arrays of the one that does not."""
    message = r"exploration must be a strategy that knows .*EpsilonGreedy\(0\.1\) \(.*or Softmax\), but is UCB$"
    with pytest.raises(ValueError, match=message):
        ExpectedSARSA.create((4, 2), exploration=UCB.create((4, 2)))
