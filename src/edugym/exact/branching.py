"""A random generator that draws nothing, but takes every way that the code using it can go.

Code asks a random number a question: is it below 0.3? which whole number is `int(rng.random() * 5)`? `branches` runs
the code once for each sequence of possible answers, and keeps the probability of each. A number that is asked twice
answers consistently: it is known only up to an interval, which each answer narrows.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, ClassVar, NoReturn

import numpy as np

MOST_ANSWERS = 1_000
"""After so many answers on one way the code is taken to go on for ever, as rejection sampling may."""
MAX_WAYS = 20_000
"""How many ways one step may go: thirty coins, say, are thrown in a billion ways."""
ROUNDING = 1e-12
"""Less likely answers are not taken: they come from sums of probabilities that are not quite 1."""
KEPT_TOO_LONG = "an exact model cannot follow a random number kept from an earlier call: draw it where it is used"


def branches(draw: Callable[[Any], Any], means: bool = False) -> Iterator[tuple[float, Any]]:
    """Every way that `draw(rng)` can go: pairs of its probability and the value that `draw` returns.

    Args:
        draw: a function of a random generator alone. It may use `random`, `uniform`, `integers` and `choice`, multiply
            what it gets by numbers and add to it, compare it with numbers, and round it down to whole numbers.
        means: whether a value that is still random in the end may be replaced by its mean, and `normal` be used as well
            (right for rewards).

    Raises:
        ValueError: `draw` does something else with it, such as returning a continuous random number, or does not end.
    """
    untried: list[tuple[int, ...]] = [()]
    while untried:
        rng = BranchingGenerator(untried.pop(), means)
        try:
            value = draw(rng)
            if type(value) is Unknown:
                value = value.mean()
        except TypeError as error:
            if not any(kind.__name__ in str(error) for kind in (Unknown, BranchingGenerator)):
                raise
            raise ValueError(f"an exact model cannot follow what is done with a random number: {error}") from error
        rng.over = True
        if rng.refused:  # the code that got the error may have caught it
            raise ValueError(rng.refused)
        yield rng.probability, value
        untried.extend(rng.untried)


class BranchingGenerator:
    """In the place of a `numpy.random.Generator`: answers by a sequence of choices, then by the first possible.

    Attributes:
        means: whether random numbers may end as their means.
        draws: the random numbers given out.
        untried: the other sequences of choices met on the way.
        refused: why the code cannot be followed, or "".
        over: whether the code that it was given to has returned.
    """

    _numpy: ClassVar[Any] = np.random.default_rng(0)  # asked only for its errors

    def __init__(self, choices: tuple[int, ...], means: bool) -> None:
        """Follow `choices` as far as they go."""
        self.means = means
        self.draws: list[Draw] = []
        self.untried: list[tuple[int, ...]] = []
        self.refused = ""
        self.over = False
        self._given = choices
        self._taken: tuple[int, ...] = ()
        self._probability = 1.0

    @property
    def probability(self) -> float:
        """The probability of all answers so far: of the choices, and of the intervals in which the numbers lie."""
        return self._probability * math.prod([draw.high - draw.low for draw in self.draws])

    def refuse(self, why: str) -> NoReturn:
        """Stop, and remember why: the code may catch the error."""
        self.refused = why
        raise ValueError(why)

    def decide(self, probabilities: Sequence[float]) -> int:
        """Draw one of several things by their probabilities."""
        choice = self.take([k for k, p in enumerate(probabilities) if p > 0])
        self._probability *= probabilities[choice]
        return choice

    def take(self, possible: Sequence[int]) -> int:
        """Take one of several ways, and note the others, to be taken in later runs."""
        step = len(self._taken)
        if step == MOST_ANSWERS:
            self.refuse(f"an exact model cannot follow more than {MOST_ANSWERS} random choices in one step")
        if step < len(self._given):
            choice = self._given[step]
        else:
            choice = possible[0]
            self.untried += [(*self._taken, k) for k in possible[1:]]
        self._taken += (choice,)
        return choice

    def draw(self) -> "Draw":
        """A number uniform on [0, 1)."""
        self.draws.append(Draw(self))
        return self.draws[-1]

    def random(self) -> "Unknown":
        """A number uniform on [0, 1)."""
        return Unknown({self.draw(): 1.0}, 0.0)

    def uniform(self, low: float = 0.0, high: float = 1.0) -> "Unknown":
        """A number uniform on [low, high)."""
        return Unknown({self.draw(): high - low}, low)

    def integers(self, low: int, high: int | None = None) -> int:
        """A whole number uniform on low, ..., high - 1 (or 0, ..., low - 1)."""
        first, last = (0, int(low)) if high is None else (int(low), int(high))
        if first >= last:
            raise ValueError(f"rng.integers has nothing to draw from: {first} is not below {last}")
        self._require_few(last - first)
        return first + self.decide([1.0 / (last - first)] * (last - first))

    def choice(self, options: Any, *, p: Sequence[float] | None = None) -> Any:
        """One of the options (0, ..., options - 1 for a number)."""
        self._numpy.choice(options, p=p)  # refuses bad options and probabilities, as the real one does
        self._require_few(int(options) if np.ndim(options) == 0 else len(options))
        values = range(int(options)) if np.ndim(options) == 0 else np.asarray(options)
        weights = np.ones(len(values)) if p is None else np.asarray(p, np.float64)
        return values[self.decide((weights / weights.sum()).tolist())]

    def normal(self, loc: float = 0.0, scale: float = 1.0) -> "Unknown | float":
        """A normally distributed number, where means will do."""
        if scale < 0:
            raise ValueError(f"rng.normal needs a scale of 0 or more, but got {scale!r}")
        if scale == 0:
            return loc
        if not self.means:
            self.refuse("a finite model cannot follow rng.normal: what it draws is continuous")
        return Unknown({Noise(self): scale}, loc)

    def _require_few(self, n_values: int) -> None:
        """Refuse a draw from so many values that their list would fill the memory."""
        if n_values > MAX_WAYS:
            self.refuse(f"an exact model cannot follow a draw from {n_values} values: {MAX_WAYS} is the limit")

    def __getattr__(self, name: str) -> Any:
        """Any other draw cannot be followed."""
        self.refuse(f"an exact model cannot follow rng.{name}: use random, uniform, integers or choice")


class Draw:
    """A number drawn uniformly from [0, 1), of which only an interval is known."""

    def __init__(self, rng: BranchingGenerator) -> None:
        """Nothing is known yet."""
        self.rng = rng
        self.low, self.high = 0.0, 1.0

    def below(self, threshold: float) -> bool:
        """Whether it is below a threshold: where that is open, both ways are taken."""
        if self.rng.over:
            raise ValueError(KEPT_TOO_LONG)
        share = (threshold - self.low) / (self.high - self.low)
        if share <= ROUNDING or share >= 1.0 - ROUNDING:
            return share > 0.5
        if self.rng.take([0, 1]) == 0:
            self.high = threshold
            return True
        self.low = threshold
        return False


class Noise(Draw):
    """A number drawn from a distribution around 0, of which nothing but the mean is ever known."""

    def __init__(self, rng: BranchingGenerator) -> None:
        """Its mean is 0."""
        super().__init__(rng)
        self.low, self.high = -math.inf, math.inf

    def below(self, threshold: float) -> bool:
        """Not possible."""
        self.rng.refuse("an exact model can only add normal noise to a reward, not compare it or round it")


class Unknown:
    """A sum of random numbers, each times a factor, and a number.

    With a single random number in it, it can be compared and rounded down.
    """

    __array_ufunc__ = None  # so that NumPy's numbers leave the arithmetic to this class
    __class__: Any = property(lambda self: float)  # `isinstance(u, float)` must answer as for a real number

    def __init__(self, terms: dict[Draw, float], offset: float) -> None:
        """The factor of each draw, and what is added."""
        self.terms = {draw: factor for draw, factor in terms.items() if factor != 0}
        self.offset = offset

    def __repr__(self) -> str:
        """For messages."""
        return "a continuous random number"

    def _refuse(self, why: str) -> NoReturn:
        """Stop, and let every generator that this came from know."""
        for draw in self.terms:
            draw.rng.refused = why
        raise ValueError(why)

    def _refuse_to_be_used(self, *_: Any) -> NoReturn:
        """Not possible: it has no one value."""
        self._refuse("an exact model can only compare random numbers and round them down, not use their value")

    def mean(self) -> float:
        """Its mean, given what is known of it."""
        total = float(self.offset)
        for draw, factor in self.terms.items():
            if not draw.rng.means:
                self._refuse("a finite model cannot hold a continuous random number in a state")
            if draw.rng.over:
                raise ValueError(KEPT_TOO_LONG)
            total += 0.0 if isinstance(draw, Noise) else factor * (draw.low + draw.high) / 2
        return total

    def _single(self) -> tuple[Draw, float] | None:
        """The one draw in it and its factor, or None where there is none."""
        if len(self.terms) > 1:
            self._refuse("an exact model cannot compare or round what is made of several random numbers")
        return next(iter(self.terms.items()), None)

    def __lt__(self, other: Any) -> bool:
        """Whether it is below another one (equality has probability 0)."""
        difference: Unknown = self - other
        single = difference._single()
        if single is None:
            return bool(difference.offset < 0)
        draw, factor = single
        threshold = -difference.offset / factor
        return draw.below(threshold) if factor > 0 else not draw.below(threshold)

    __le__ = __lt__

    def __gt__(self, other: Any) -> bool:
        """Is it above another one?"""
        return not self < other

    def __ge__(self, other: Any) -> bool:
        """As `>`."""
        return not self < other

    def __add__(self, other: Any) -> "Unknown":
        """The sum with a number or with another one."""
        if type(other) is not Unknown:
            return Unknown(self.terms, self.offset + other)
        terms = {draw: self.terms.get(draw, 0.0) + other.terms.get(draw, 0.0) for draw in self.terms | other.terms}
        return Unknown(terms, self.offset + other.offset)

    def __mul__(self, other: Any) -> "Unknown":
        """Every term times a number."""
        if type(other) is Unknown:
            self._refuse("an exact model cannot follow the product of two random numbers")
        return Unknown({draw: factor * other for draw, factor in self.terms.items()}, self.offset * other)

    def __sub__(self, other: Any) -> "Unknown":
        """The difference."""
        negative: Unknown | float = -other
        return self + negative

    def __rsub__(self, other: float) -> "Unknown":
        """The difference from a number."""
        return (-self) + other

    def __truediv__(self, other: float) -> "Unknown":
        """Every term divided by a number."""
        return self * (1.0 / other)

    def __neg__(self) -> "Unknown":
        """Every term times -1."""
        return self * -1.0

    __radd__ = __add__
    __rmul__ = __mul__

    def __floor__(self) -> int:
        """The whole number below: the way is taken for every one that is possible."""
        single = self._single()
        if single is None:
            return math.floor(self.offset)
        draw, factor = single
        lowest, highest = sorted((factor * draw.low + self.offset, factor * draw.high + self.offset))
        whole = math.floor(lowest) if math.isfinite(lowest) else 0
        while whole + 1 < highest and not self < whole + 1:
            whole += 1
        return whole

    def __ceil__(self) -> int:
        """The whole number above."""
        return -math.floor(-self)

    def __int__(self) -> int:
        """The whole number towards zero."""
        return math.floor(self) if not self < 0 else math.ceil(self)

    __trunc__ = __int__

    def _refuse_operator(self, *_: Any) -> NoReturn:
        """Not possible; as an error of its own, since code may try a TypeError and go on."""
        self._refuse(
            "an exact model cannot follow what is done with a random number: only +, -, comparing, rounding "
            "down, and multiplying and dividing by numbers"
        )

    __float__ = __str__ = __format__ = _refuse_to_be_used
    __pow__ = __rpow__ = __mod__ = __rmod__ = __floordiv__ = __rfloordiv__ = __rtruediv__ = _refuse_operator
    __divmod__ = __rdivmod__ = __abs__ = __round__ = __index__ = __complex__ = _refuse_operator
