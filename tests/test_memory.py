"""Sizes of tables in words."""

import pytest

from edugym.memory import in_digits, in_words, memory, require_memory


@pytest.mark.parametrize(
    ("n_bytes", "words"),
    [
        (0, "0 bytes"),
        (999, "999 bytes"),
        (1_000, "1 kilobytes"),
        (2_500_000, "2.5 megabytes"),
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
    assert in_digits(7 * 10**30) == "about 10^30"
    assert in_digits(256**10_000) == "about 10^24082"
    assert in_words(256**10_000) == "about 10^24082 bytes"


def test_require_memory() -> None:
    """What fits passes; what does not is refused in one sentence, with the advice."""
    require_memory("Q", (memory() // 8,), "do so")
    with pytest.raises(ValueError, match=r"Q would be a table of .* numbers\), and this machine has .*bytes: do so$"):
        require_memory("Q", (memory() // 8 + 1,), "do so")
