"""The exploration strategies: the exact probability of every action, from closed forms and from drawing."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import (
    UCB,
    CountBased,
    EpsilonGreedy,
    ExponentialDecay,
    Greedy,
    LinearDecay,
    QLearning,
    ScheduledEpsilonGreedy,
    Softmax,
)
from edugym.exact.branching import branches
from edugym.mdp.protocol import Integers, Random

STRATEGIES: dict[str, Callable[[Any], Any]] = {
    "greedy": lambda environment: Greedy(),
    "epsilon-greedy": lambda environment: EpsilonGreedy(0.2),
    "linear decay": lambda environment: ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.1, 500)),
    "exponential decay": lambda environment: ScheduledEpsilonGreedy.create(ExponentialDecay(1.0, 0.05, 0.99)),
    "softmax": lambda environment: Softmax(0.3),
    "ucb": lambda environment: UCB.create(environment, 0.5),
}

# Values from so few numbers that ties are frequent.
rows = st.lists(st.sampled_from([-1.0, 0.0, 0.5, 2.0]), min_size=1, max_size=6)


def exact(make: Callable[[], Any], values: list[float]) -> list[float]:
    """The probability of each action, by following every way that the strategy's random numbers can send it."""
    Q = np.array([values])
    probabilities = [0.0] * len(values)
    for probability, action in branches(lambda rng: make().choose(Q, 0, rng)):
        probabilities[action] += probability
    return probabilities


def uniform_on_best(values: list[float]) -> list[float]:
    """The greedy policy with ties broken at random."""
    best = [value == max(values) for value in values]
    return [is_best / sum(best) for is_best in best]


def epsilon_greedy(values: list[float], epsilon: float) -> list[float]:
    """ε/n for every action, and the rest evenly for the best."""
    return [epsilon / len(values) + (1 - epsilon) * share for share in uniform_on_best(values)]


def softmax(values: list[float], temperature: float) -> list[float]:
    """Equation 2.11."""
    weights = [math.exp(value / temperature) for value in values]
    return [weight / sum(weights) for weight in weights]


@given(rows)
def test_greedy_breaks_ties_uniformly(values: list[float]) -> None:
    """Every best action with the same probability, every other never."""
    assert exact(Greedy, values) == pytest.approx(uniform_on_best(values))


@given(rows, st.floats(0.0, 1.0))
def test_epsilon_greedy_has_its_closed_form(values: list[float], epsilon: float) -> None:
    """An exploring step may hit the best action too."""
    assert exact(lambda: EpsilonGreedy(epsilon), values) == pytest.approx(epsilon_greedy(values, epsilon))


@given(rows, st.sampled_from([0.1, 1.0, 7.0]))
def test_softmax_has_its_closed_form(values: list[float], temperature: float) -> None:
    """Equation 2.11 for action values."""
    assert exact(lambda: Softmax(temperature), values) == pytest.approx(softmax(values, temperature))


@pytest.mark.parametrize("temperature", [1e-3, 1e-300, 5e-324])
def test_softmax_is_greedy_at_tiny_temperatures(temperature: float) -> None:
    """In the limit only the best are chosen, evenly."""
    assert exact(lambda: Softmax(temperature), [1.0, 3.0, 2.0, 3.0]) == [0.0, 0.5, 0.0, 0.5]


@pytest.mark.parametrize("temperature", [1e12, math.inf])
def test_softmax_is_uniform_at_huge_temperatures(temperature: float) -> None:
    """In the other limit all are alike."""
    assert exact(lambda: Softmax(temperature), [1.0, 3.0, -2.0]) == pytest.approx([1 / 3] * 3)


def test_softmax_does_not_overflow() -> None:
    """Values whose exponentials or whose differences are too large for a float (a warning would be an error here)."""
    assert exact(Softmax, [1e6, 1e6 - 1.0]) == pytest.approx(softmax([1.0, 0.0], 1.0))
    assert exact(Softmax, [-1e6, -1e6 - 1.0]) == pytest.approx(softmax([1.0, 0.0], 1.0))
    assert exact(Softmax, [1.7e308, -1.7e308]) == [1.0, 0.0]


def test_linear_decay() -> None:
    """Evenly from the start to the end, and then no further."""
    schedule = LinearDecay(1.0, 0.2, 100)
    assert [schedule.value(step) for step in (0, 50, 100, 101, 10_000)] == pytest.approx([1.0, 0.6, 0.2, 0.2, 0.2])
    rising = LinearDecay(0.0, 1.0, 4)
    assert [rising.value(step) for step in range(6)] == [0.0, 0.25, 0.5, 0.75, 1.0, 1.0]


def test_exponential_decay() -> None:
    """By the same share at every step, down to the end."""
    schedule = ExponentialDecay(1.0, 0.1, 0.5)
    assert [schedule.value(step) for step in range(6)] == pytest.approx([1.0, 0.5, 0.25, 0.125, 0.1, 0.1])
    assert [ExponentialDecay(0.3, 0.0, 1.0).value(step) for step in (0, 1, 1_000)] == [0.3, 0.3, 0.3]


@pytest.mark.parametrize("schedule", [LinearDecay(1.0, 0.2, 100), ExponentialDecay(1.0, 0.05, 0.97)])
@pytest.mark.parametrize("step", [0, 1, 50, 99, 100, 5_000])
def test_scheduled_epsilon_greedy_uses_the_epsilon_of_its_step(schedule: Any, step: int) -> None:
    """The first action is chosen with ε after 0 steps."""
    expected = epsilon_greedy([0.0, 1.0, 0.0], schedule.value(step))
    assert exact(lambda: ScheduledEpsilonGreedy(schedule, np.array([step])), [0.0, 1.0, 0.0]) == pytest.approx(expected)


def ucb(values: list[float], counts: list[int], c: float) -> tuple[list[float], list[Integers]]:
    """The exact probabilities of UCB's choice, and the counts that each way leaves behind."""
    left: list[Integers] = []

    def make() -> UCB:
        strategy = UCB(np.array([counts]), np.zeros((1, len(counts))), c)
        left.append(strategy.counts)
        return strategy

    return exact(make, values), left


@given(rows, st.data())
def test_ucb_tries_every_action_first(values: list[float], data: st.DataObject) -> None:
    """An action that was never chosen goes before all others, whatever their values; among several, at random."""
    counts = data.draw(st.lists(st.integers(0, 2), min_size=len(values), max_size=len(values)).filter(lambda n: 0 in n))
    expected = [(count == 0) / counts.count(0) for count in counts]
    assert ucb(values, counts, 1.0)[0] == pytest.approx(expected)


def test_ucb_is_equation_2_10() -> None:
    """With 8 and 1 choices made, the tenth is at t = 10: ln t = 2.302585.

    For c = 1 the bounds are  Q₀ + √(2.302585/8) = Q₀ + 0.536492  and  Q₁ + √(2.302585/1) = Q₁ + 1.517427: action 1 is
    better by 0.980935 if Q is equal. (With ln 9 in the place of ln 10 it would be 0.958244.)
    """
    assert ucb([0.98, 0.0], [8, 1], 1.0)[0] == [0.0, 1.0]
    assert ucb([0.97, 0.0], [8, 1], 1.0)[0] == [0.0, 1.0]
    assert ucb([0.981, 0.0], [8, 1], 1.0)[0] == [1.0, 0.0]
    assert ucb([2 * 0.98, 0.0], [8, 1], 2.0)[0] == [0.0, 1.0]
    assert ucb([2 * 0.981, 0.0], [8, 1], 2.0)[0] == [1.0, 0.0]


def test_ucb_without_bonus_is_greedy_and_breaks_ties_uniformly() -> None:
    """At c = 0 only the values count; equal bounds are equally likely."""
    assert ucb([1.0, 3.0, 2.0], [50, 1, 1], 0.0)[0] == [0.0, 1.0, 0.0]
    assert ucb([1.0, 2.0, 2.0, 2.0], [4, 4, 4, 4], 0.5)[0] == pytest.approx([0.0, 1 / 3, 1 / 3, 1 / 3])


def test_ucb_counts_what_it_chooses() -> None:
    """One more for the chosen action of this state, and nothing else."""
    strategy = UCB(np.array([[2, 7], [1, 1]]), np.zeros((1, 2)), 0.0)
    assert strategy.choose(np.array([[0.0, 1.0], [5.0, 0.0]]), 0, np.random.default_rng(0)) == 1
    assert strategy.counts.tolist() == [[2, 8], [1, 1]]
    fresh = UCB.create((3, 4))
    assert fresh.counts.shape == (3, 4)
    assert not fresh.counts.any()


class Swapped(NamedTuple):
    """A student's strategy with parameters in another order."""

    epsilon: float

    def choose(self, state: int, Q: Any, rng: Random) -> int:
        """Always the first."""
        return 0


@pytest.mark.parametrize(
    ("exploration", "message"),
    [
        (Swapped(0.1), r"choose of Swapped must take \(self, Q, state, rng\), but takes \(self, state, Q, rng\)"),
        (EpsilonGreedy(2.0), "epsilon must be from 0 to 1, but is 2.0"),
        (EpsilonGreedy(-0.1), "epsilon must be from 0 to 1, but is -0.1"),
        (Softmax(0.0), "temperature must be greater than 0, but is 0.0"),
        (0.1, "exploration must be a strategy such as EpsilonGreedy\\(0.1\\), but is 0.1"),
        (UCB.create((3, 2)), "UCB was made for 3 states, but the agent has 2"),
        (UCB.create((2, 5)), "UCB was made for 5 actions, but the agent has 2"),
    ],
)
def test_agents_refuse_strategies_that_make_no_sense(exploration: Any, message: str) -> None:
    """A tuple cannot check itself, so the agent that gets the strategy does."""
    with pytest.raises(ValueError, match=message):
        QLearning.create((2, 2), exploration=exploration)
    with pytest.raises(ValueError, match=message):
        CountBased.create((2, 2), exploration=exploration)


@pytest.mark.parametrize(
    ("schedule", "message"),
    [
        (LinearDecay(1.5, 0.1, 10), "start must be from 0 to 1, but is 1.5"),
        (LinearDecay(1.0, 0.1, 0), "steps must be 1 or more, but is 0"),
        (ExponentialDecay(1.0, -0.1, 0.9), "end must be from 0 to 1, but is -0.1"),
        (ExponentialDecay(1.0, 0.1, 0.0), "rate must be greater than 0 and at most 1, but is 0.0"),
        (0.1, r"schedule must have a method value\(step\), as LinearDecay\(1.0, 0.1, 1000\) has, but is 0.1"),
    ],
)
def test_schedules_that_make_no_sense_are_refused(schedule: Any, message: str) -> None:
    """Where the strategy that follows them is made."""
    with pytest.raises(ValueError, match=message):
        ScheduledEpsilonGreedy.create(schedule)
