"""A progress bar, where the library for it is installed."""

from typing import Any


def progress_bar(total: int, unit: str) -> Any:
    """A tqdm bar with `update(n)` and `close()`, drawn to the terminal or the notebook.

    Raises:
        ModuleNotFoundError: tqdm is not installed.
    """
    from tqdm.auto import tqdm

    return tqdm(total=total, unit=unit, unit_scale=True, smoothing=0.1)
