"""Programs that machine code would run otherwise than Python: each is the same, or interpreted with one sentence."""

import json
import os
import subprocess
import sys
from typing import Any

import pytest

from tests.compiled.programs import COMPILED, RAISE, REFUSED, SURPRISES

EVERY = [*COMPILED.values(), *RAISE.values(), *SURPRISES.values(), *(source for source, _ in REFUSED.values())]


def verdicts(programs: list[str]) -> list[dict[str, Any]]:
    """What became of each, from a process of its own; `died` for what killed it."""
    found: list[dict[str, Any]] = []
    while len(found) < len(programs):
        rest = programs[len(found) :]
        done = subprocess.run(
            [sys.executable, "-m", "tests.compiled.oracle"],
            input=json.dumps(rest),
            env=os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
            capture_output=True,
            text=True,
            check=False,
        )
        lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith('{"same"')]
        found += lines
        if len(lines) < len(rest):
            found.append({"same": False, "compiled": False, "said": "", "seen": "died: " + done.stderr[-600:]})
    return found


@pytest.fixture(scope="module")
def catalogue() -> dict[str, dict[str, Any]]:
    """The verdicts on all programs, by their source."""
    return dict(zip(EVERY, verdicts(EVERY), strict=True))


@pytest.mark.parametrize("name", COMPILED)
def test_compiled(name: str, catalogue: dict[str, Any]) -> None:
    """These are compiled, with the same results."""
    found = catalogue[COMPILED[name]]
    assert found["same"], found["seen"]
    assert found["compiled"], found["said"]
    assert not found["error"]


@pytest.mark.parametrize("name", RAISE)
def test_errors(name: str, catalogue: dict[str, Any]) -> None:
    """These raise what they raise interpreted, at the same line."""
    found = catalogue[RAISE[name]]
    assert found["same"], found["seen"]
    assert found["error"]


@pytest.mark.parametrize("name", SURPRISES)
def test_surprises(name: str, catalogue: dict[str, Any]) -> None:
    """These go on as Python does, with a sentence if machine code was given up."""
    found = catalogue[SURPRISES[name]]
    assert found["same"], found["seen"]


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name: str, catalogue: dict[str, Any]) -> None:
    """These run interpreted, and one sentence names the class and the reason."""
    source, word = REFUSED[name]
    found = catalogue[source]
    assert found["same"], found["seen"]
    if word is not None and not found["error"]:
        assert not found["compiled"]
        assert found["said"].count("runs interpreted") == 1
        assert word in found["said"].partition("slower: ")[2]
        assert "\n" not in found["said"]
        assert len(found["said"]) < 300
