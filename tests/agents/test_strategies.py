"""The exploration strategies: the exact probability of every action, from closed forms and by following every draw."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import edugym as eg
from edugym.agents import tables
from edugym.exact.branching import branches
from edugym.mdp.protocol import Random
from tests.agents.cases import STRATEGIES, package_classes
from tests.messages import named

KNOWN = {name: make for name, make in STRATEGIES.items() if hasattr(make((2, 2)), "probability")}
# Values from so few numbers that ties are frequent, and the same with other last digits.
FEW = [-1.0, 0.0, 0.5, 2.0]
rows = st.lists(st.sampled_from(FEW), min_size=1, max_size=6)
rounded_rows = st.lists(
    st.sampled_from([*FEW, -1 - 4e-16, 0.5 + 2e-16, 0.5 - 2e-16, 2 + 4e-16]), min_size=1, max_size=6
)


def exact(make: Callable[[], Any], values: list[float]) -> list[float]:
    """The probability of each action, by following every way that the strategy's random numbers can send it."""
    Q = np.array([[9.0] * len(values), values])
    probabilities = [0.0] * len(values)
    for probability, action in branches(lambda rng: make().choose(Q, 1, rng)):
        probabilities[action] += probability
    return probabilities


def epsilon_greedy(values: list[float], epsilon: float) -> list[float]:
    """ε/n for every action, and the rest evenly for the best, which are equal but for their last digits."""
    best = [round(value, 9) == round(max(values), 9) for value in values]
    return [epsilon / len(values) + (1 - epsilon) * is_best / sum(best) for is_best in best]


def softmax(values: list[float], temperature: float) -> list[float]:
    """Equation 2.11."""
    weights = [math.exp(value / temperature) for value in values]
    return [weight / sum(weights) for weight in weights]


@given(rounded_rows, st.floats(0.0, 1.0), st.sampled_from([0.1, 1.0, 7.0]))
def test_closed_forms(values: list[float], epsilon: float, temperature: float) -> None:
    """Ties are broken at random, an exploring step may hit the best action too, and softmax is equation 2.11."""
    assert exact(eg.Greedy, values) == pytest.approx(epsilon_greedy(values, 0.0))
    assert exact(lambda: eg.EpsilonGreedy(epsilon), values) == pytest.approx(epsilon_greedy(values, epsilon))
    assert exact(lambda: eg.Softmax(temperature), values) == pytest.approx(softmax(values, temperature))


@pytest.mark.parametrize(
    ("value", "best", "expected"),
    [
        (0.1 * 3, 0.3, True),
        (-0.3, 0.1 * -3, True),
        (1.0 + (2.0**-40 - 1.0), 2.0**-40, True),
        (0.3 - 1e-11, 0.3, False),  # small, and not by rounding
        (-1e-300, 0.0, False),
        (-0.0, 0.0, True),
        (5e-324, 1e-323, False),
        (math.inf, math.inf, True),
        (-math.inf, -math.inf, True),
        (3.0, math.inf, False),
        (-math.inf, math.inf, False),
        (-math.inf, 3.0, False),
        (-1.7e308, 1.7e308, False),  # without a warning, which would be an error here
    ],
)
def test_equal_but_for_rounding(value: float, best: float, expected: bool) -> None:
    """By hand; everyone who asks which actions are best gives the same answer."""
    Q, other = np.array([[value, best]]), np.array([[10.0, 20.0]])
    assert tables.tied(value, best) == tables.tied(Q[0, 0], Q[0, 1]) == expected
    share = 0.5 if expected else 0.0
    assert exact(eg.Greedy, [value, best]) == [share, 1 - share]
    assert exact(eg.Greedy, [best, value]) == [1 - share, share]
    assert eg.Greedy().probability(Q, 0, 0) == share
    assert tables.value_of_best(Q, other, 0) == 20 - 10 * share
    watkins = eg.QLambda.create((2, 2))
    watkins.Q[1] = Q[0]
    watkins.learn(0, 0, 0.0, 1, 0, False, False)
    assert watkins.Z.n[0] == expected


class ByTheLastDigit(eg.QLearning):
    """Q-learning that takes the highest value even where it is higher by rounding only."""

    __slots__ = ()

    def act(self, state: int, rng: Random) -> int:
        """Draw among those that are exactly the highest."""
        return int(rng.choice(np.flatnonzero(self.Q[state] == self.Q[state].max())))

    def greedy(self, state: int, rng: Random) -> int:
        """The same."""
        return self.act(state, rng)


def test_rounding_decides_nothing() -> None:
    """With α = 1 all values here are powers of γ, the same ones for every γ. Not so where the last digit decides."""

    def powers(kind: Any, discount: float, seed: int) -> Any:
        wall = eg.make_mdp("Boulder", height=25, n_grips=3, layout_seed=seed)
        agent = kind(np.ones((26, 3)), 1.0, discount, eg.Greedy())
        eg.train(wall, agent, 1_500, seed=seed, evaluate_every=1_500)
        return (np.log(agent.Q) / math.log(discount)).round().tolist()

    for seed in (1, 2):
        assert powers(eg.QLearning, 0.9, seed) == powers(eg.QLearning, 0.99, seed) == powers(eg.QLearning, 0.5, seed)
        assert powers(ByTheLastDigit, 0.9, seed) != powers(ByTheLastDigit, 0.5, seed)


@pytest.mark.parametrize(
    ("temperature", "values", "expected"),
    [
        (5e-324, [1.0, 3.0, 2.0, 3.0], [0.0, 0.5, 0.0, 0.5]),  # in the limit greedy
        (math.inf, [1.0, 3.0, -2.0], [1 / 3] * 3),  # and in the other limit uniform
        (1.0, [1e6, 1e6 - 1.0], softmax([1.0, 0.0], 1.0)),  # exponentials that are too large for a float
        (1.0, [-1e6, -1e6 - 1.0], softmax([1.0, 0.0], 1.0)),
        (1.0, [1.7e308, -1.7e308], [1.0, 0.0]),  # and differences
    ],
)
def test_the_limits_of_softmax(temperature: float, values: list[float], expected: list[float]) -> None:
    """Tiny and huge temperatures and values (a warning would be an error here)."""
    assert exact(lambda: eg.Softmax(temperature), values) == pytest.approx(expected)


@given(rounded_rows)
@pytest.mark.parametrize("make", KNOWN.values(), ids=KNOWN)
def test_known_probabilities_are_those_of_the_choices(make: Any, values: list[float]) -> None:
    """`probability` is how often `choose` gives each action, ties included, and `expected_value` the mean."""
    Q = np.array([[9.0] * len(values), values])
    chosen, strategy = exact(lambda: make(Q.shape), values), make(Q.shape)
    assert [strategy.probability(Q, 1, action) for action in range(len(values))] == pytest.approx(chosen)
    assert strategy.expected_value(Q, 1) == pytest.approx(np.dot(chosen, values))


def test_what_has_no_probabilities_is_refused() -> None:
    """UCB: its choice depends on counts that the choice changes. The message names it, and those that will do."""
    known = {type(make((2, 2))) for make in KNOWN.values()}
    assert known == set(package_classes("expected_value")) == set(package_classes("probability"))
    message = r"exploration must be a strategy that knows .*EpsilonGreedy\(0\.1\) \(.*or Softmax\), but is UCB$"
    with pytest.raises(ValueError, match=message):
        eg.ExpectedSARSA.create((4, 2), exploration=eg.UCB.create((4, 2)))


@pytest.mark.parametrize(
    ("schedule", "values"),
    [
        (eg.LinearDecay(1.0, 0.2, 4), [1.0, 0.8, 0.6, 0.4, 0.2, 0.2]),
        (eg.LinearDecay(0.0, 1.0, 4), [0.0, 0.25, 0.5, 0.75, 1.0, 1.0]),
        (eg.ExponentialDecay(1.0, 0.1, 0.5), [1.0, 0.5, 0.25, 0.125, 0.1, 0.1]),
        (eg.ExponentialDecay(0.3, 0.0, 1.0), [0.3] * 6),
    ],
)
def test_schedules(schedule: Any, values: list[float]) -> None:
    """From the start to the end, and then no further; the first action is chosen with ε after 0 steps."""
    assert [schedule.value(step) for step in range(6)] == pytest.approx(values)
    assert schedule.value(10_000) == pytest.approx(values[-1])

    def made(step: int) -> eg.ScheduledEpsilonGreedy:
        return eg.ScheduledEpsilonGreedy(schedule, np.array([step]))

    for step, epsilon in enumerate(values):
        strategy, Q = made(step), np.array([[0.0, 1.0]])
        chosen = exact(partial(made, step), [0.0, 1.0])
        assert [chosen[1], strategy.probability(Q, 0, 1)] == pytest.approx([1 - epsilon / 2] * 2)
        assert strategy.step[0] == step  # only a choice is a step of the schedule
        strategy.choose(Q, 0, np.random.default_rng(0))
        assert strategy.step[0] == step + 1


def ucb(values: list[float], counts: list[int], c: float) -> list[float]:
    """The exact probabilities of UCB's choice."""
    return exact(lambda: eg.UCB(np.array([[7] * len(counts), counts]), np.zeros((1, len(counts))), c), values)


@given(rows, st.data())
def test_ucb_tries_every_action_first(values: list[float], data: st.DataObject) -> None:
    """An action that was never chosen goes before all others, whatever their values; among several, at random."""
    counts = data.draw(st.lists(st.integers(0, 2), min_size=len(values), max_size=len(values)).filter(lambda n: 0 in n))
    expected = [(count == 0) / counts.count(0) for count in counts]
    assert ucb(values, counts, 1.0) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("values", "counts", "c", "expected"),
    [
        ([2 * 0.980, 0.0], [8, 1], 2.0, [0, 1]),
        ([2 * 0.981, 0.0], [8, 1], 2.0, [1, 0]),
        ([1.0, 3.0, 2.0], [50, 1, 1], 0.0, [0, 1, 0]),  # without a bonus only the values count
        ([1.0, 2.0, 2.0, 2.0], [4, 4, 4, 4], 0.5, [0, 1 / 3, 1 / 3, 1 / 3]),  # equal bounds are equally likely
    ],
)
def test_ucb_is_equation_2_10(values: list[float], counts: list[int], c: float, expected: list[float]) -> None:
    """After 8 and 1 choices t = 10: √(ln 10) - √(ln 10 / 8) = 0.980935 (with ln 9 it would be 0.958244)."""
    assert ucb(values, counts, c) == pytest.approx(expected)


def test_ucb_counts_what_it_chooses() -> None:
    """One more for the chosen action of this state, and nothing else."""
    strategy = eg.UCB(np.array([[2, 7], [1, 1]]), np.zeros((1, 2)), 0.0)
    assert strategy.choose(np.array([[0.0, 1.0], [5.0, 0.0]]), 0, np.random.default_rng(0)) == 1
    assert strategy.counts.tolist() == [[2, 8], [1, 1]]
    assert eg.UCB.create((3, 4)).counts.tolist() == [[0] * 4] * 3


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
        (eg.EpsilonGreedy(2.0), named("epsilon", 0, 1, 2.0)),
        (0.1, "exploration must be a strategy such as EpsilonGreedy\\(0.1\\), but is 0.1"),
        (eg.UCB.create((3, 2)), "UCB was made for 3 states, but the agent has 2"),
        (eg.UCB.create((2, 5)), "UCB was made for 5 actions, but the agent has 2"),
    ],
)
def test_agents_refuse_strategies_that_make_no_sense(exploration: Any, message: str) -> None:
    """A tuple cannot check itself, so the agent that gets the strategy does."""
    with pytest.raises(ValueError, match=message):
        eg.QLearning.create((2, 2), exploration=exploration)


def test_schedules_that_make_no_sense_are_refused() -> None:
    """Where the strategy that follows them is made."""
    for schedule, message in (
        (eg.LinearDecay(1.5, 0.1, 10), named("start", 0, 1, 1.5)),
        (0.1, r"schedule must have a method value\(step\), as LinearDecay\(1.0, 0.1, 1000\) has, but is 0.1"),
    ):
        with pytest.raises(ValueError, match=message):
            eg.ScheduledEpsilonGreedy.create(schedule)
