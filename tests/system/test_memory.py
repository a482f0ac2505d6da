"""Sizes of tables in words."""

import os

import pytest

from edugym.system import memory as module
from edugym.system.memory import in_digits, in_words, memory, require_memory


@pytest.mark.parametrize(
    ("n_bytes", "words"),
    [
        (0, "0 bytes"),
        (999, "999 bytes"),
        (1_000, "1 kilobytes"),
        (2_500_000, "2.5 megabytes"),
        (999_000_000, "999 megabytes"),
        (123_456_000_000, "123 gigabytes"),
        (9 * 10**12, "9 terabytes"),
        (10**18, "1 exabytes"),
        (10**23, "100 zettabytes"),
        (4**25 * 3 * 8, "27 petabytes"),
        (10**24, "about 10^24 bytes"),
    ],
)
def test_in_words(n_bytes: int, words: str) -> None:
    """The largest unit that fits; powers of ten beyond all units."""
    assert in_words(n_bytes) == words


def test_in_digits() -> None:
    """With commas, or as a power of ten."""
    assert in_digits(1_234_567) == "1,234,567"
    assert in_digits(10**24 - 1) == "999,999,999,999,999,999,999,999"
    assert in_digits(10**24) == "about 10^24"
    assert in_digits(7 * 10**30) == "about 10^30"
    assert in_digits(256**10_000) == "about 10^24082"
    assert in_words(256**10_000) == "about 10^24082 bytes"


def test_require_memory() -> None:
    """What fits passes; what does not is refused in one sentence, with the advice."""
    require_memory("Q", (memory() // 8,), "do so")
    with pytest.raises(ValueError, match=r"Q would be a table of .* numbers\), and this machine has .*bytes: do so$"):
        require_memory("Q", (memory() // 8 + 1,), "do so")


def test_the_whole_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    """The size of the table, its axes, and the memory that is there: pages times their size."""
    monkeypatch.setattr(os, "sysconf", {"SC_PHYS_PAGES": 250, "SC_PAGE_SIZE": 4_000}.__getitem__)
    assert memory() == 1_000_000
    require_memory("Q", (1000, 250), "use fewer", item_bytes=4)
    said = "^Q would be a table of 2 megabytes (1,000 by 250 numbers), and this machine has 1 megabytes: use fewer$"
    with pytest.raises(ValueError, match=said.replace("(", r"\(").replace(")", r"\)")):
        require_memory("Q", (1000, 250), "use fewer")
    for error in (AttributeError, ValueError, OSError):

        def unknown(name: str, error: type[Exception] = error) -> int:
            raise error

        monkeypatch.setattr(os, "sysconf", unknown)
        assert memory() == module.ASSUMED == 16_000_000_000
