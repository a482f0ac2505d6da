"""A progress bar, where the library for it is installed."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


class NoBar:
    """A progress bar that is not shown."""

    def update(self, n: int) -> None:
        """Do nothing."""


@contextmanager
def progress_bar(total: int, unit: str, *, shown: bool) -> Iterator[Any]:
    """Yield a tqdm bar with `update(n)`, in the terminal or the notebook, and close it at the end.

    Raises:
        ModuleNotFoundError: tqdm is not installed.
    """
    if not shown:
        yield NoBar()
        return
    from tqdm.auto import tqdm

    with tqdm(total=total, unit=unit, unit_scale=True, smoothing=0.1) as bar:
        yield bar
