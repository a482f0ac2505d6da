"""Cases that tell a right answer and every mistake apart."""

import numpy as np
import pytest

from edugym_course.grading.cases import telling_draw


def two_numbers(rng: np.random.Generator) -> list[float]:
    """Two numbers of which each is 0 or 1."""
    return [float(number) for number in rng.integers(2, size=2)]


@pytest.mark.parametrize("seed", range(20))
def test_cases_tell_rules_apart(seed: int) -> None:
    """Twice a number is the number itself where both are 0: such a draw is left out."""
    rules = [lambda x: x, lambda x: 2 * x, lambda x: [x * x + 1]]
    assert any(two_numbers(telling_draw(seed, two_numbers, rules)))


def test_how_cases_are_drawn() -> None:
    """Rules that are the same but for rounding are refused; a seed gives the same cases, and another one others."""
    with pytest.raises(ValueError, match="two of them never differed"):
        telling_draw(0, two_numbers, [lambda x: x, lambda x: 1 * x])
    with pytest.raises(ValueError, match="two of them never differed"):
        telling_draw(0, two_numbers, [lambda x: x, lambda x: x + 1e-12])
    telling_draw(0, two_numbers, [lambda x: x, lambda x: x + 1e-4])
    drawn = {seed: telling_draw(seed, two_numbers, [abs]).random(3).tolist() for seed in (0, 1)}
    assert drawn[0] == telling_draw(0, two_numbers, [abs]).random(3).tolist()
    assert drawn[0] != drawn[1]
