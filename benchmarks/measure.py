"""Measuring several programs against each other on a machine that does other things as well.

What is compared takes turns, round after round (A B C A B C ...), so that a slow minute of the machine hits all alike.
A ratio is taken within each round, and the median over the rounds is reported. The process stays on one core, garbage
is collected before each measurement and not during it, and what counts is the processor time of this process.
"""

import gc
import os
import statistics
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NamedTuple, TypeAlias

Work: TypeAlias = Callable[[int], int]
"""Does about as many units of work as it is asked for, and says how many it did."""


class Contender(NamedTuple):
    """Something to be measured.

    Attributes:
        name: what it is.
        prepare: sets it up, which does not count, and gives the work.
    """

    name: str
    prepare: Callable[[], Work]


class Comparison(NamedTuple):
    """EduGym against others, at one kind of work.

    Attributes:
        name: the kind of work.
        unit: of what so many a second are done.
        ours: EduGym.
        others: what it is compared with.
        rate_target: so many units a second are wanted; None for no such aim.
        ratio_target: so many times the first of the others is wanted; None for no such aim.
        turn_length: how many times as long as usual a turn lasts: more than 1 where a run takes long to begin.
    """

    name: str
    unit: str
    ours: Contender
    others: list[Contender]
    rate_target: float | None = None
    ratio_target: float | None = None
    turn_length: float = 1.0


class Spread(NamedTuple):
    """A quantity as measured in several rounds: its median, and the lowest and highest value."""

    median: float
    low: float
    high: float


class Measured(NamedTuple):
    """What came out of a comparison.

    Attributes:
        comparison: what was compared.
        rates: by name, the units a second.
        ratios: by name of the others, how many times as fast EduGym is.
    """

    comparison: Comparison
    rates: dict[str, Spread]
    ratios: dict[str, Spread]

    def targets(self) -> dict[str, bool]:
        """The aims in words, and whether each is met."""
        aims = {}
        rate, ratio = self.comparison.rate_target, self.comparison.ratio_target
        if rate is not None:
            aims[f">= {number(rate)}/s"] = self.rates[self.comparison.ours.name].median >= rate
        if ratio is not None:
            aims[f">= {ratio:.0f} x"] = self.ratios[self.comparison.others[0].name].median >= ratio
        return aims


def measure(comparison: Comparison, rounds: int, seconds: float) -> Measured:
    """Measure all contenders, in turns.

    Args:
        comparison: the contenders.
        rounds: how often each has its turn, 1 or more.
        seconds: about how long a turn lasts.
    """
    contenders = (comparison.ours, *comparison.others)
    with on_one_core():  # from the start, since threads stay on the cores of whoever began them
        works = {contender.name: contender.prepare() for contender in contenders}
        amounts = {name: _amount(work, seconds * comparison.turn_length) for name, work in works.items()}
        turns = [{name: _rate(work, amounts[name]) for name, work in works.items()} for _ in range(rounds)]
    ours = comparison.ours.name
    return Measured(
        comparison,
        {name: spread_of([turn[name] for turn in turns]) for name in works},
        {name: spread_of([turn[ours] / turn[name] for turn in turns]) for name in works if name != ours},
    )


def number(value: float) -> str:
    """A number to three digits, with k for thousands, M for millions and G for milliards."""
    for size, letter in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:.3g} {letter}"
    return f"{value:.3g}"


def _amount(work: Work, seconds: float) -> int:
    """How much work takes so long; finding out warms it up."""
    amount = 1
    while True:
        rate = _rate(work, amount)
        if amount / rate >= seconds / 4:
            return max(1, int(rate * seconds))
        amount = max(2 * amount, int(rate * seconds / 3))


def _rate(work: Work, amount: int) -> float:
    """Units a second."""
    gc.collect()
    gc.disable()
    try:
        began = time.process_time()
        done = work(amount)
        took = time.process_time() - began
    finally:
        gc.enable()
    return done / max(took, 1e-9)


def spread_of(values: list[float]) -> Spread:
    """The median, and the lowest and the highest value."""
    return Spread(statistics.median(values), min(values), max(values))


@contextmanager
def on_one_core() -> Iterator[None]:
    """Stay on one processor core, where the operating system lets us choose."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, cores)
