"""How far a long run is: a progress bar for who asks for one, and for others a line if it takes long."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from edugym.system import waiting

PATIENCE = 3.0
"""After so many seconds a person wants to know how long a run still takes,"""
LONG = 10.0
"""if that is so many seconds or more."""


class Remainder:
    """A line that says how long a run still takes. Short runs show none.

    The longest time between two updates does not count: it is that of the compiler.
    """

    def __init__(self, total: int) -> None:
        """Begin to measure."""
        self._total, self._done, self._text = total, 0, ""
        self._began = self._last = self._told = time.perf_counter()
        self._longest, self._in_longest = 0.0, 0
        self._is_told_from_within = False

    def update(self, n: int) -> None:
        """So many steps more are done."""
        outermost = _open[0]
        if outermost is self:
            self._count(0 if self._is_told_from_within else n)
        elif outermost is not None:  # a run of an experiment, which otherwise hears of it only at its end
            outermost._is_told_from_within = True
            outermost._count(n)

    def __enter__(self) -> "Remainder":
        """Begin a run."""
        return self

    def __exit__(self, *error: object) -> None:
        """Take the line away."""
        if self._text:
            waiting.clear(self._text)

    def _count(self, n: int) -> None:
        now = time.perf_counter()
        gap, self._last, self._done = now - self._last, now, self._done + n
        if gap > self._longest:
            self._longest, self._in_longest = gap, n
        if now - self._told < PATIENCE or self._done == self._in_longest:
            return
        self._told = now
        pace = (now - self._began - self._longest) / (self._done - self._in_longest)
        left = pace * max(0, self._total - self._done)
        if left >= LONG or self._text:
            if self._text:
                waiting.clear(self._text)
            self._text = (
                f"edugym: {self._done / self._total:.0%} done, about {in_words(left)} to go (fewer steps or repetitions"
                " take less) ..."
            )
            waiting.show(self._text)


_open: list[Remainder | None] = []
"""The bars of the runs under way, the outermost first; None for one that was asked for, within which none is needed."""


def in_words(seconds: float) -> str:
    """How long something takes, roughly: "40 seconds", "3 minutes"."""
    return f"{seconds:.0f} seconds" if seconds < 90 else f"{seconds / 60:.0f} minutes"


@contextmanager
def progress_bar(total: int, unit: str, *, shown: bool) -> Iterator[Any]:
    """Yield a tqdm bar with `update(n)`, in the terminal or the notebook, and close it at the end.

    If it is not shown, a run that takes long says so in a line, unless it is part of an experiment, which does.

    Raises:
        ModuleNotFoundError: tqdm is not installed.
    """
    new: Any = Remainder(total)
    if shown:
        from tqdm.auto import tqdm

        new = tqdm(total=total, unit=unit, unit_scale=True, smoothing=0.1)
    entry = None if shown else new
    _open.append(entry)
    try:
        with new as bar:
            yield bar
    finally:
        _open.remove(entry)
