"""Refuses a table that would not fit into memory, before it is made."""

import math
import os

UNITS = ("bytes", "kilobytes", "megabytes", "gigabytes", "terabytes", "petabytes", "exabytes", "zettabytes")
"""Each a thousand of the one before."""
ASSUMED = 16 * 10**9
"""The memory of a machine that does not tell."""


def require_memory(name: str, shape: tuple[int, ...], advice: str, item_bytes: int = 8) -> None:
    """Refuse a table that is larger than the memory of this machine.

    Args:
        name: what the table is called in the message.
        shape: of the table, as Python's whole numbers, which never overflow.
        advice: what to do instead; the message ends with it.
        item_bytes: the size of one entry.

    Raises:
        ValueError: it is larger; the message says how large it would be.
    """
    needed, there = math.prod(shape) * item_bytes, memory()
    if needed > there:
        axes = " by ".join(map(in_digits, shape))
        raise ValueError(
            f"{name} would be a table of {in_words(needed)} ({axes} numbers), and this machine has {in_words(there)}:"
            f" {advice}"
        )


def in_words(n_bytes: int) -> str:
    """A number of bytes in the largest unit that fits, to at most three digits: "27 petabytes"."""
    power = int(math.log10(max(n_bytes, 1))) // 3
    if power >= len(UNITS):
        return f"{in_digits(n_bytes)} bytes"
    return f"{n_bytes / 1000**power:.3g} {UNITS[power]}"


def in_digits(number: int) -> str:
    """A whole number with commas, or its power of ten where it is very long."""
    return f"{number:,}" if number < 10**24 else f"about 10^{int(math.log10(number))}"


def memory() -> int:
    """The bytes of memory of this machine, or `ASSUMED` where it does not tell."""
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return ASSUMED
