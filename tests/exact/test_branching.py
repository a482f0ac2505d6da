"""Every way that random numbers can send a piece of code, with its exact probability."""

import itertools
import math
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym.exact.branching import MOST_ANSWERS, branches

SAMPLES = 300
Draw = Callable[[Any], Any]


def check(draw: Draw, expected: dict[Any, float]) -> None:
    """Compare with probabilities worked out by hand, and with what a real generator does."""
    found: dict[Any, float] = {}
    for p, value in branches(draw):
        assert p > 0
        found[value] = found.get(value, 0.0) + p
    assert found == pytest.approx({value: p for value, p in expected.items() if p > 0}, abs=1e-12)
    rng = np.random.default_rng(0)
    counts = Counter(draw(rng) for _ in range(SAMPLES))
    assert set(counts) <= set(found)
    for value, p in found.items():
        assert abs(counts[value] / SAMPLES - p) < 6 * math.sqrt(p * (1 - p) / SAMPLES) + 1e-12


PROBABILITIES = st.integers(0, 64).map(lambda k: k / 64)


@settings(max_examples=40)
@given(p=PROBABILITIES)
def test_a_coin(p: float) -> None:
    """One question, however it is asked."""
    for draw in (
        lambda rng: rng.random() < p,
        lambda rng: rng.random() <= p,
        lambda rng: p > rng.random(),
        lambda rng: p >= rng.random(),
        lambda rng: not rng.random() > p,
        lambda rng: not rng.random() >= p,
        lambda rng: rng.random() < np.float64(p),
        lambda rng: bool(np.float64(p) > rng.random()),
        lambda rng: 1.0 - rng.random() > 1.0 - p,
        lambda rng: -rng.random() > -p,
        lambda rng: 2 * rng.random() - 1 < 2 * p - 1,
        lambda rng: rng.random() / 4 < p / 4,
        lambda rng: rng.uniform() < p,
        lambda rng: rng.uniform(-3.0, 5.0) < 8 * p - 3,
        lambda rng: rng.uniform(high=2.0) < 2 * p,
    ):
        check(draw, {True: p, False: 1 - p})


@settings(max_examples=40)
@given(ps=st.lists(PROBABILITIES, min_size=1, max_size=4))
def test_questions_to_several_numbers(ps: list[float]) -> None:
    """Independent numbers: the products."""
    sides = ([(True, p), (False, 1 - p)] for p in ps)
    ways = [tuple(zip(*way, strict=True)) for way in itertools.product(*sides)]
    check(lambda rng: tuple(rng.random() < p for p in ps), {answers: math.prod(shares) for answers, shares in ways})


@settings(max_examples=40)
@given(n=st.integers(1, 40), shift=st.integers(-20, 20))
def test_whole_numbers(n: int, shift: int) -> None:
    """One of n, in all the ways to say it."""
    for draw in (
        lambda rng: rng.integers(shift, shift + n),
        lambda rng: rng.integers(np.int64(n)) + shift,
        lambda rng: int(rng.random() * n) + shift,
        lambda rng: math.floor(rng.random() * n + shift),
        lambda rng: math.floor(np.float64(n) * rng.random()) + shift,
        lambda rng: math.floor(rng.uniform(shift, shift + n)),
        lambda rng: math.ceil(rng.random() * n) - 1 + shift,
        lambda rng: math.trunc(rng.random() * n) + shift,
        lambda rng: rng.choice(n) + shift,
        lambda rng: rng.choice(list(range(shift, shift + n))),
        lambda rng: rng.choice(np.arange(n) + shift),
    ):
        check(draw, {k + shift: 1 / n for k in range(n)})


def test_whole_numbers_towards_zero() -> None:
    """`int` cuts off, `math.floor` goes down: they differ below zero."""
    check(lambda rng: int(rng.uniform(-2.5, 1.5)), {-2: 1 / 8, -1: 1 / 4, 0: 1 / 2, 1: 1 / 8})
    check(lambda rng: math.floor(rng.uniform(-2.5, 1.5)), {-3: 1 / 8, -2: 1 / 4, -1: 1 / 4, 0: 1 / 4, 1: 1 / 8})
    check(lambda rng: math.ceil(rng.uniform(-2.5, 1.5)), {-2: 1 / 8, -1: 1 / 4, 0: 1 / 4, 1: 1 / 4, 2: 1 / 8})


@settings(max_examples=40)
@given(n=st.integers(2, 12), numerator=st.integers(1, 63))
def test_one_number_asked_in_two_ways(n: int, numerator: int) -> None:
    """What is known of a number from one question limits the answers to the next."""
    p = Fraction(numerator, 64)

    def draw(rng: Any) -> tuple[bool, int, bool]:
        u = rng.random()
        return bool(u < numerator / 64), int(u * n), bool(u < numerator / 64)

    expected = {}
    for k in range(n):
        low, high = Fraction(k, n), Fraction(k + 1, n)
        expected[True, k, True] = float(max(Fraction(0), min(high, p) - low))
        expected[False, k, False] = float(max(Fraction(0), high - max(low, p)))
    check(draw, expected)


@settings(max_examples=40)
@given(weights=st.lists(st.integers(0, 9), min_size=1, max_size=6).filter(any))
def test_choice_with_probabilities(weights: list[int]) -> None:
    """`choice` with p: what has no probability is never taken."""
    p = [weight / sum(weights) for weight in weights]
    check(lambda rng: int(rng.choice(len(p), p=p)), dict(enumerate(p)))
    letters = "abcdef"[: len(p)]
    check(lambda rng: str(rng.choice(list(letters), p=p)), dict(zip(letters, p, strict=True)))


def test_degenerate_draws() -> None:
    """What can only come out in one way has probability 1; a number may be compared with itself."""
    for draw in (
        lambda rng: rng.random() < 1.0,
        lambda rng: rng.random() >= 0.0,
        lambda rng: rng.random() * 0.0 < 1e-300,
        lambda rng: rng.uniform(2.0, 2.0) < 2.1,
        lambda rng: math.floor(rng.uniform(2.0, 2.0)) == 2,
        lambda rng: math.floor((u := rng.random()) - u + 2.5) == 2,
        lambda rng: (u := rng.random()) - u < 1e-9,
        lambda rng: rng.integers(1) == 0,
        lambda rng: rng.normal(3.0, 0.0) == 3.0,
        lambda rng: rng.random() != 0.5,
    ):
        assert list(branches(draw)) == [(1.0, True)]
    check(lambda rng: bool((u := rng.random()) < 1 - u), {True: 0.5, False: 0.5})


MEANS: list[tuple[Draw, float]] = [
    (lambda rng: rng.random(), 0.5),
    (lambda rng: 3.0, 3.0),
    (lambda rng: 2 * rng.uniform(1.0, 3.0) - 1, 3.0),
    (lambda rng: rng.normal(1.5, 2.0), 1.5),
    (lambda rng: 1.0 - 2.0 * rng.normal() / 4, 1.0),
    (lambda rng: rng.normal(1.0, 2.0) + rng.random() + 3.0 * rng.normal(2.0), 7.5),
    (lambda rng: -rng.random() if rng.random() < 0.25 else 10, 0.25 * -0.5 + 7.5),
    (lambda rng: u if (u := rng.random()) < 0.5 else 0.0, 0.125),
    # The sum is made before anything is known.
    (lambda rng: (u := rng.random(), total := u + rng.random(), total if u < 0.5 else 0.0)[-1], 0.5 * 0.75),
]


@pytest.mark.parametrize(("draw", "mean"), MEANS)
def test_means(draw: Draw, mean: float) -> None:
    """What is still random in the end counts as its mean, given what was asked of it; noise is added up."""
    assert sum(p * value for p, value in branches(draw, means=True)) == pytest.approx(mean)


def swallowed(draw: Draw) -> Draw:
    """Code that goes on where a draw is an error."""

    def go_on(rng: Any) -> float:
        with suppress(ValueError):
            draw(rng)
        return 0.0

    return go_on


UNKNOWN = "cannot follow what is done with a random number"
REFUSED: list[tuple[Draw, str]] = [
    (lambda rng: rng.random(), "cannot hold a continuous random number"),
    (lambda rng: rng.random() + rng.random() < 1.0, "several random numbers"),
    (lambda rng: rng.random() < rng.random(), "several random numbers"),
    (lambda rng: rng.random() * rng.random() < 0.5, "product of two random numbers"),
    (lambda rng: rng.random() ** 2 < 0.5, UNKNOWN),
    (lambda rng: round(rng.random()), UNKNOWN),
    (lambda rng: 1 / rng.random() > 3, UNKNOWN),
    (lambda rng: np.sqrt(rng.random()) < 0.5, UNKNOWN),
    (lambda rng: rng.random(3), UNKNOWN),
    (lambda rng: math.exp(rng.random()) < 2, "not use their value"),
    (lambda rng: rng.integers(3, 3), "nothing to draw from: 3 is not below 3"),
    (lambda rng: rng.integers(10**9), "a draw from 1000000000 values: 20000 is the limit"),
    (lambda rng: rng.choice(10**9), "a draw from 1000000000 values: 20000 is the limit"),
    (lambda rng: rng.choice(np.arange(20_001)), "a draw from 20001 values: 20000 is the limit"),
    (lambda rng: rng.choice(2, p=[0.5, 0.6]), "(?i)do not sum to 1"),
    (lambda rng: rng.choice(2, p=[1.0]), "must have same size"),
    (lambda rng: rng.normal(0.0, 1.0), "cannot follow rng.normal"),
    (lambda rng: rng.normal(0.0, -1.0), "rng.normal needs a scale of 0 or more, but got -1.0"),
    (lambda rng: rng.poisson(2.0), "cannot follow rng.poisson"),
    (swallowed(lambda rng: rng.poisson(2.0)), "cannot follow rng.poisson"),
    (swallowed(lambda rng: math.exp(rng.random())), "not use their value"),
]


@pytest.mark.parametrize(("draw", "reason"), REFUSED)
def test_what_cannot_be_followed(draw: Draw, reason: str) -> None:
    """Everything else is refused with a reason: never a wrong probability."""
    with pytest.raises(ValueError, match=reason):
        list(branches(draw))


def test_noise_may_only_be_added() -> None:
    """In rewards noise counts as its mean; where that would be wrong, it is refused."""
    draws: list[Draw] = [
        lambda rng: 1.0 if rng.normal() > 0 else 0.0,
        lambda rng: int(rng.normal(5.0, 2.0)),
        lambda rng: rng.normal() * rng.normal(),
        lambda rng: abs(rng.normal()),
        lambda rng: min(rng.random(), rng.random()),
    ]
    for draw in draws:
        with pytest.raises(ValueError, match="an exact model can"):
            list(branches(draw, means=True))


def test_code_that_does_not_end() -> None:
    """Trying again until it fits has no end of ways."""

    def draw(rng: Any) -> None:
        while rng.random() < 0.5:
            pass

    with pytest.raises(ValueError, match=f"more than {MOST_ANSWERS} random choices"):
        list(branches(draw))
    assert list(branches(lambda rng: [rng.integers(1) for _ in range(MOST_ANSWERS)])) == [(1.0, [0] * MOST_ANSWERS)]
    with pytest.raises(ZeroDivisionError):  # an error that has nothing to do with random numbers
        list(branches(lambda rng: rng.random() / 0 < 1))
