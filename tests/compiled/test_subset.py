"""Programs that machine code would run otherwise than Python: each is the same, or interpreted with one sentence."""

import json
import os
import subprocess
import sys
from typing import Any

import pytest

from tests.compiled.programs import COMPILED, RAISE, RARE, REFUSED, SURPRISES


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


REFUSED_SOURCES = {name: source for name, (source, _) in REFUSED.items()}
EVERY = COMPILED | RAISE | SURPRISES | REFUSED_SOURCES
USUAL = [name for name in EVERY if name not in RARE]


@pytest.mark.parametrize("names", [USUAL, pytest.param(RARE, marks=pytest.mark.slow)], ids=["usual", "rare"])
def test_programs(names: list[str]) -> None:
    """All give the same results, or the same error at the same line; where one is refused a sentence says why."""
    found = dict(zip(names, verdicts([EVERY[name] for name in names]), strict=True))
    assert not {name: verdict["seen"] for name, verdict in found.items() if not verdict["same"]}
    assert not {name: found[name]["said"] for name in names if name in COMPILED and not found[name]["compiled"]}
    assert {name for name in names if name in RAISE} <= {name for name in names if found[name]["error"]}
    assert not {name for name in names if name in COMPILED and found[name]["error"]}
    for name in names:
        word = REFUSED[name][1] if name in REFUSED else None
        if word is not None and not found[name]["error"]:
            said = found[name]["said"]
            assert not found[name]["compiled"], name
            assert said.count("runs interpreted") == 1, (name, said)
            assert word in said.partition("slower: ")[2], (name, said)
            assert "\n" not in said
            assert len(said) < 300


def test_every_program_has_a_name_of_its_own() -> None:
    """And those that are called rare are there."""
    assert len(EVERY) == len(COMPILED) + len(RAISE) + len(SURPRISES) + len(REFUSED)
    assert EVERY.keys() >= set(RARE)
