"""What the playground says of a race of which nothing tells who learns best."""

import json
import subprocess
from typing import Any

import playground
import pytest

from tests.site.node import NODE

pytestmark = pytest.mark.skipif(NODE is None, reason="needs Node.js: apt-get install nodejs")


def agent(label: str, curve: list[float], n_seeds: int = 1) -> dict[str, Any]:
    """An agent with the same curve for each seed."""
    points = [[100 * k, value, value] for k, value in enumerate(curve)]
    return {"label": label, "curves": [points] * n_seeds}


def said(name: str, *given: Any) -> str:
    """What a function of the page says."""
    call = f"{name}({', '.join(map(json.dumps, given))})"
    script = f"import {{ {name} }} from '{playground.PAGE.as_uri()}/verdict.js'; process.stdout.write({call})"
    command = [str(NODE), "--input-type=module", "--eval", script]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize(
    ("curves", "optimum", "says"),
    [
        ([[1.0] * 20, [1.0] * 20], 1.0, "before training too"),
        ([[1.0] * 20, [0.0] * 20], 1.0, "A (1)"),
        ([[0.5] * 20, [0.5] * 20], 1.0, "Nobody has learned"),
        ([[0.5] * 20, [0.5] * 20], None, "Nobody has learned"),
        ([[0.0] * 20, [0.0] * 20], 1.0, "Nobody has learned"),
        ([[0.0] + [1.0] * 20, [0.0] * 10 + [1.0] * 11], 1.0, "and A got there first."),
        ([[0.0] + [0.99] * 20, [0.0] * 10 + [1.0] * 11, [0.0] * 21], 1.0, "B (1) and A (0.99) did best"),
        ([[0.0] + [0.99] * 20, [0.0] * 10 + [1.0] * 11], 1.0, "B (1) and A (0.99) did equally well"),
        ([[0.0] * 10 + [1.0] * 11, [0.0] + [0.99] * 20], 1.0, "Your bet on “A” did as well, but was slower."),
        ([[0.0] * 21, [0.0] + [0.99] * 20], 1.0, "Your bet on “A” was wrong."),
        ([[0.0] + [1.0] * 20, [0.0] + [0.5] * 20], 1.0, "training. B (0.5) is behind."),
        ([[0.0] + [1.0] * 20, [0.0] * 21], 1.0, "training. B (0) has learned nothing that shows."),
        (
            [[0.0] + [1.0] * 20, [0.0] * 5 + [0.2] + [0.0] * 15],
            1.0,
            "B (0) rose, but ended where it began.",
        ),
        ([[0.0] + [1.0] * 20, [0.0] * 5 + [-0.5] * 16], 1.0, "B (−0.5) ended lower than it began."),
        ([[0.0] + [1.0] * 20, [0.0] * 21, [0.0] * 21], 1.0, "B (0) and C (0) have learned nothing"),
        ([[-9.0] + [-2.0] * 20] * 2, -2.0, "did equally well"),
        ([[1.0] * 5 + [0.0] * 3 + [1.0] * 12, [1.0] * 20], 1.0, "before training too, if not always between"),
        ([[0.0] + [1.0] * 20, [0.0] * 10 + [1.0] * 11], 1.0, "Your bet was right. A"),
    ],
)
def test_a_verdict(curves: list[list[float]], optimum: float | None, says: str) -> None:
    """Whoever stays where it began has learned nothing, unless nothing more can be had."""
    agents = list(map(agent, "ABC", curves))
    assert says in said("verdict", agents, [], 2000, 0, optimum)


def test_two_of_one_name() -> None:
    """Each is called by its place."""
    agents = [agent("A", [0.0] + [1.0] * 20), agent("B", [0.0] * 21), agent("A", [0.0] + [0.5] * 20)]
    sentences = said("verdict", agents, [], 2000, None, 1.0)
    assert sentences.startswith("The first A (1) did best")
    assert "The second A (0.5) is behind. B (0) has learned" in sentences


def test_a_duel_of_equals() -> None:
    """Who got there first is said, if the other needed visibly longer."""
    slow, fast, nearly = (agent(label, [0.0] * n + [1.0] * (40 - n)) for label, n in (("A", 20), ("B", 4), ("C", 20)))
    assert "no difference that shows, but B got there after" in said("duel", slow, fast, 0, 1.0)
    assert "no difference that shows, but your agent got there after" in said("duel", fast, slow, 0, 1.0)
    assert said("duel", slow, nearly, 0, 1.0).endswith("no difference that shows.")


@pytest.mark.parametrize(
    ("late", "n_seeds", "says"),
    [
        ([0.0] * 9 + [0.2], 1, "In the last tenth of training your agent has 0.02, B 0: neither has learned anything"),
        ([1.0] * 10, 1, "your agent did better with this seed"),
        ([1.0] * 10, 5, "your agent wins"),
    ],
)
def test_a_duel(late: list[float], n_seeds: int, says: str) -> None:
    """One seed has no winner, and a small difference shows nothing."""
    ours, theirs = (agent(label, [0.0] * 10 + end, n_seeds) for label, end in (("A", late), ("B", [0.0] * 10)))
    assert says in said("duel", ours, theirs, 0, 1.0)
