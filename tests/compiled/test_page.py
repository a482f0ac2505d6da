"""What docs/machine-code.md says in numbers."""

from pathlib import Path

import pytest

from edugym.checks.mdps import CHECKED_STEPS
from edugym.compiled import code, compiler, disk, execution, interrupt_polling, snapshot, subset
from edugym.training import trainers

PAGE = " ".join((Path(__file__).parents[2] / "docs" / "machine-code.md").read_text(encoding="utf-8").split())


@pytest.mark.parametrize(
    ("sentence", "value", "said"),
    [
        ("The first 200 training steps", CHECKED_STEPS, 200),
        ("If 5 000 steps or more were asked for", execution.COMPILE_FROM, 5_000),
        ("Where tables are large (1 MB or more)", snapshot.LARGE, 10**6),
        ("returns to Python some fifty times a second", trainers.CALL_SECONDS, 1 / 50),
        ("asks after every 4096 turns", interrupt_polling.ITERATIONS_BETWEEN_POLLS, 4096),
        ("more than 20 seconds of processor time", compiler.MOST_SECONDS, 20),
        ("tuples of up to 300 of them", subset.MOST_PARTS, 300),
        ("arrays of up to 0.25 MB", code.MOST_FROZEN, 250_000),
        ("After three such calls", execution.MOST_SURPRISES, 3),
        ("never more than about 256 MB", disk.LIMIT, 256 * 2**20),
    ],
)
def test_numbers(sentence: str, value: float, said: float) -> None:
    """Each is in a sentence of the page, and is that of the code."""
    assert sentence in PAGE
    assert value == said
