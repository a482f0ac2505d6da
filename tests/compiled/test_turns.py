"""Loops without an end: machine code answers Ctrl-C and the order to stop."""

import subprocess
import sys

import pytest

EXPECTED = {
    "training": ["in the loop at line 37 of your code", "False True 0.0", "Timeout", "False"],
    "in_threads": ["Interrupted True", "Interrupted True"],
    "vector": ["True 300 300"],
    "planning": ["Interrupted"],
    "evaluation": ["Interrupted 0"],
}


@pytest.mark.parametrize("how", EXPECTED)
def test_what_never_ends_can_be_stopped(how: str) -> None:
    """See `unending.py`. Without `edugym.compiled.turns` these programs go on until they are killed."""
    done = subprocess.run(
        [sys.executable, "-m", "tests.compiled.unending", how],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert (done.stdout.splitlines(), done.stderr) == (EXPECTED[how], "")
