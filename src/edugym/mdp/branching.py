"""A random generator that draws nothing, but takes every way that the code using it can go.

Code asks a random number a question: is it below 0.3? which whole number is `int(rng.random() * 5)`? `branches` runs
the code once for each sequence of possible answers, and keeps the probability of each. A number that is asked twice
answers
consistently: it is known only up to an interval, which each answer narrows.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any


def branches(draw: Callable[[Any], Any], means: bool = False) -> Iterator[tuple[float, Any]]:
    """Every way that `draw(rng)` can go: pairs of its probability and the value that `draw` returns.

    Args:
        draw: a function of a random generator alone. It may use `random`, `uniform`, `integers` and `choice`, compare
            what it gets with numbers, and round it down to whole numbers.
        means: whether continuous noise may be replaced by its mean (right where it is only added, as in rewards).

    Raises:
        ValueError: `draw` does something else with it, such as returning a continuous random number.
    """
    untried: list[tuple[int, ...]] = [()]
    while untried:
        rng = BranchingGenerator(untried.pop(), means)
        value = draw(rng)
        if isinstance(value, Unknown):
            value = value.mean()
        yield rng.probability, value
        untried.extend(rng.untried)


class BranchingGenerator:
    """In the place of a `numpy.random.Generator`: answers by given choices, then by the first possible."""

    def __init__(self, choices: tuple[int, ...], means: bool) -> None:
        """Follow `choices` as far as they go."""
        self.probability = 1.0
        self.untried: list[tuple[int, ...]] = []
        self._means = means
        self._given = choices
        self._taken: tuple[int, ...] = ()

    def decide(self, probabilities: Sequence[float]) -> int:
        """Take one of several ways, by their probabilities; note the others, to be taken in later runs."""
        possible = [k for k, p in enumerate(probabilities) if p > 0]
        step = len(self._taken)
        if step < len(self._given):
            choice = self._given[step]
        else:
            choice = possible[0]
            self.untried += [(*self._taken, k) for k in possible[1:]]
        self._taken += (choice,)
        self.probability *= probabilities[choice]
        return choice

    def random(self) -> "Unknown":
        """A number uniform on [0, 1)."""
        return Unknown(Draw(self), 1.0, 0.0)

    def uniform(self, low: float = 0.0, high: float = 1.0) -> "Unknown":
        """A number uniform on [low, high)."""
        return Unknown(Draw(self), high - low, low)

    def integers(self, low: int, high: int | None = None) -> int:
        """A whole number uniform on low, ..., high - 1 (or 0, ..., low - 1)."""
        first, last = (0, low) if high is None else (low, high)
        return int(first) + self.decide([1.0 / (last - first)] * int(last - first))

    def choice(self, options: Any, p: Sequence[float] | None = None) -> Any:
        """One of the options (0, ..., options - 1 for a number)."""
        options = range(options) if isinstance(options, int) else options
        return options[self.decide(p if p is not None else [1.0 / len(options)] * len(options))]

    def normal(self, loc: float = 0.0, scale: float = 1.0) -> float:
        """The mean of a normal distribution, where means will do."""
        if not self._means and scale > 0:
            raise ValueError("a finite model cannot follow rng.normal: what it draws is continuous")
        return loc

    def __getattr__(self, name: str) -> Any:
        """Any other draw cannot be followed."""
        raise ValueError(f"an exact model cannot follow rng.{name}: use random, uniform, integers or choice")


class Draw:
    """A number drawn uniformly from [0, 1), of which only an interval is known."""

    def __init__(self, rng: BranchingGenerator) -> None:
        """Nothing is known yet."""
        self.rng = rng
        self.low, self.high = 0.0, 1.0

    def below(self, threshold: float) -> bool:
        """Whether it is below a threshold: where that is open, both ways are taken."""
        share = (threshold - self.low) / (self.high - self.low)
        if share <= 0.0 or share >= 1.0:
            return share >= 1.0
        if self.rng.decide([share, 1.0 - share]) == 0:
            self.high = threshold
            return True
        self.low = threshold
        return False


class Unknown:
    """A random number `scale * draw + offset`, which can be calculated with, compared and rounded down."""

    def __init__(self, draw: Draw, scale: float, offset: float) -> None:
        """A multiple of a draw, moved."""
        self.draw, self.scale, self.offset = draw, scale, offset

    def mean(self) -> float:
        """Its mean, given what is known of it."""
        if not self.draw.rng._means:
            raise ValueError("a finite model cannot hold a continuous random number in a state")
        return self.scale * (self.draw.low + self.draw.high) / 2 + self.offset

    def __lt__(self, other: float) -> bool:
        """Is it below a number? That it equals one has probability 0."""
        threshold = (other - self.offset) / self.scale
        return self.draw.below(threshold) if self.scale > 0 else not self.draw.below(threshold)

    def __le__(self, other: float) -> bool:
        """As `<`."""
        return self < other

    def __gt__(self, other: float) -> bool:
        """Is it above a number?"""
        return not self < other

    def __ge__(self, other: float) -> bool:
        """As `>`."""
        return not self < other

    def __add__(self, other: float) -> "Unknown":
        """Moved."""
        return Unknown(self.draw, self.scale, self.offset + other)

    def __sub__(self, other: float) -> "Unknown":
        """Moved."""
        return self + -other

    def __mul__(self, other: float) -> "Unknown":
        """Scaled."""
        return Unknown(self.draw, self.scale * other, self.offset * other)

    def __truediv__(self, other: float) -> "Unknown":
        """Scaled."""
        return self * (1.0 / other)

    def __neg__(self) -> "Unknown":
        """Mirrored."""
        return self * -1.0

    def __rsub__(self, other: float) -> "Unknown":
        """Mirrored and moved."""
        return -self + other

    __radd__ = __add__
    __rmul__ = __mul__

    def __floor__(self) -> int:
        """The whole number below: the way is taken for every one that is possible."""
        ends = sorted((self.scale * end + self.offset) for end in (self.draw.low, self.draw.high))
        whole = math.floor(ends[0])
        while whole + 1 < ends[1] and not self < whole + 1:
            whole += 1
        return whole

    def __int__(self) -> int:
        """The whole number towards zero."""
        return math.floor(self) if not self < 0 else -math.floor(-self)

    __trunc__ = __int__

    def __float__(self) -> float:
        """Not possible: it has no one value."""
        raise ValueError("an exact model can only compare random numbers and round them down, not use their value")
