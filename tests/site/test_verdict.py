"""What the playground says of a race of which nothing tells who learns best."""

import json
import subprocess

import playground
import pytest

from tests.site.node import NODE

pytestmark = pytest.mark.skipif(NODE is None, reason="needs Node.js: apt-get install nodejs")


@pytest.mark.parametrize(
    ("curves", "optimum", "says"),
    [
        ([[1.0] * 20, [1.0] * 20], 1.0, "before training too"),
        ([[1.0] * 20, [0.0] * 20], 1.0, "A (1)"),
        ([[0.5] * 20, [0.5] * 20], 1.0, "Nobody has learned"),
        ([[0.5] * 20, [0.5] * 20], None, "Nobody has learned"),
        ([[0.0] * 20, [0.0] * 20], 1.0, "Nobody has learned"),
        ([[0.0] + [1.0] * 20, [0.0] * 10 + [1.0] * 11], 1.0, "A (1) did best"),
        ([[-9.0] + [-2.0] * 20] * 2, -2.0, "did equally well"),
    ],
)
def test_a_verdict(curves: list[list[float]], optimum: float | None, says: str) -> None:
    """Whoever stays where it began has learned nothing, unless nothing more can be had."""
    agents = [
        {"label": label, "curves": [[[100 * k, value, value] for k, value in enumerate(curve)]]}
        for label, curve in zip("AB", curves, strict=True)
    ]
    script = f"""
        import {{ verdict }} from '{playground.PAGE.as_uri()}/verdict.js'
        process.stdout.write(verdict({json.dumps(agents)}, [], 2000, null, {json.dumps(optimum)}))
    """
    command = [str(NODE), "--input-type=module", "--eval", script]
    assert says in subprocess.run(command, capture_output=True, text=True, check=True).stdout
