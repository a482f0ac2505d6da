"""Warnings in the terminal, while a command runs."""

import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def warnings_said_at_once() -> Iterator[None]:
    """Say each warning once, above the progress bar, when it comes: a user asks why a run is slow while it is."""
    from tqdm import tqdm

    said = set()

    def say(message: Warning | str, *_: Any, **__: Any) -> None:
        if (text := str(message)) not in said:
            said.add(text)
            tqdm.write(f"edugym: {text}", file=sys.stderr)

    with warnings.catch_warnings():
        warnings.simplefilter("always")
        warnings.showwarning = say
        yield
