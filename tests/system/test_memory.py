"""Sizes of tables in words."""

import os

import pytest

from edugym.system.memory import ASSUMED, in_digits, in_words, memory, require_memory


@pytest.mark.parametrize(
    ("n_bytes", "words"),
    [(0, "0 bytes"), (999, "999 bytes"), (1_000, "1 kilobytes"), (2_500_000, "2.5 megabytes"),
     (123_456_000_000, "123 gigabytes"), (10**23, "100 zettabytes"), (4**25 * 3 * 8, "27 petabytes"),
     (10**24, "about 10^24 bytes")],
)  # fmt: skip
def test_in_words(n_bytes: int, words: str) -> None:
    """The largest unit that fits; powers of ten beyond all units."""
    assert in_words(n_bytes) == words


def test_in_digits() -> None:
    """With commas, or as a power of ten."""
    assert in_digits(10**24 - 1) == "999,999,999,999,999,999,999,999"
    assert in_digits(10**24) == "about 10^24"
    assert in_words(256**10_000) == "about 10^24082 bytes"


def test_require_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    """What fits passes; else the size of the table, its axes, and the memory that is there: pages times their size."""
    monkeypatch.setattr(os, "sysconf", {"SC_PHYS_PAGES": 250, "SC_PAGE_SIZE": 4_000}.__getitem__)
    assert memory() == 1_000_000
    require_memory("Q", (1000, 250), "use fewer", item_bytes=4)
    with pytest.raises(ValueError, match=r"^Q .*2 megabytes \(1,000 by 250 .* 1 megabytes: use fewer$"):
        require_memory("Q", (1000, 250), "use fewer")
    monkeypatch.delattr(os, "sysconf")
    assert memory() == ASSUMED
