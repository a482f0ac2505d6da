"""The programs in docs: each writes what its own `--check` accepts; the page of the agents says what profiles say."""

import importlib
import sys
from pathlib import Path

import agents
import pandas
import pytest

from edugym import Profile
from edugym.adapters.registration import find
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.scores import COLUMNS
from edugym_course import agent_profiles

DOCS = Path(__file__).parents[1] / "docs"
FEW = [find("Casino")]
"""An environment whose film needs no training."""
NAMES = {"agents": ("PAGE", "CHALLENGE"), "architecture": ("PAGE", "PICTURE"), "isolation": ("PAGE",), "pages": ()}
"""Where each program writes."""


@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] * (name == "agents")) for name in NAMES])
def test_a_program_writes_what_it_accepts(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Files from which a row is missing become those of the checkout; of one that is old, `--check` writes nothing."""
    program = importlib.import_module(name)
    known = {path.name: path for path in [getattr(program, name) for name in NAMES[name]]}
    monkeypatch.setattr(sys, "argv", [""])
    for place in NAMES[name]:
        monkeypatch.setattr(program, place, tmp_path / getattr(program, place).name)
    if name == "pages":
        known = {path.name: path for one in FEW for path in (DOCS / "environments").glob(f"{one.name.lower()}.[ms]*")}
        monkeypatch.setattr(program, "PAGES", tmp_path)
        monkeypatch.setattr(program, "ENVIRONMENTS", FEW)
        monkeypatch.setattr(program, "in_course_order", lambda: FEW)
    for path in known.values():
        (tmp_path / path.name).write_text(without_a_row(path.read_text(encoding="utf-8")), encoding="utf-8")
    assert program.main() == 0
    assert all((tmp_path / path.name).read_bytes() == path.read_bytes() for path in known.values())
    monkeypatch.setattr(sys, "argv", ["", "--check"])
    for path in [path for path in tmp_path.iterdir() if path.name != "isolation.svg"]:  # which differs between machines
        whole = path.read_bytes()
        path.unlink()
        if path.suffix == ".md":
            path.write_text(without_a_row(whole.decode()), encoding="utf-8")
        old = path.exists() and path.read_bytes()
        assert program.main() == 1, path
        assert old == (path.exists() and path.read_bytes())
        path.write_bytes(whole)


def without_a_row(text: str) -> str:
    """Without the last row of a table; a picture without its end."""
    lines = text.splitlines(keepends=True)
    last = max((k for k, line in enumerate(lines) if line.startswith("|")), default=-1)
    return "".join(lines[:last] + lines[last:][1:])


LADDER = LADDERS[0]._replace(strengths=(8, 10))


@pytest.mark.parametrize(
    ("scores", "cells"),
    [
        ((1.0, 1.0), ("**1.00 ± 0.00**", "never", "good 1.00 (of 1 tried)")),
        ((1.0, 0.0), ("**0.50 ± 0.00**", "8–10", "good 0.50 (of 1 tried)")),
        ((0.4, 0.4), ("0.40 ± 0.00", "at once", "nobody of 1 tried is good: no score is above 0.40")),
        ((-0.1, 0.0), ("-0.05 ± 0.00", "at once", "nobody of 1 tried is better than random play")),
    ],
)
def test_the_page_says_what_the_profile_says(scores: tuple[float, float], cells: tuple[str, str, str]) -> None:
    """The score, in bold for who is to be taken; where it breaks; whom to take; and who cannot enter, and why."""
    rows = [
        dict.fromkeys(COLUMNS, 0.0)
        | {"agent": "good", "challenge": "Boulder", "strength": strength, "repetition": k, "score": score}
        for strength, score in zip(LADDER.strengths, scores, strict=True)
        for k in range(3)
    ]
    profile = Profile(
        pandas.DataFrame(rows), (LADDER,), ("good", "blank", "new"), {"blank": {"Boulder": "it is afraid"}}
    )
    page = agents.page(profile, {"blank": ["Boulder"], "good": ["Golf"]}, "torch 1").replace("\N{NO-BREAK SPACE}", " ")
    score, broken, take = cells
    for line in (
        f"| good | 3 | {score} |",
        f"| good | {broken} |",
        f"| {take} |",
        "| blank | 0 | – |",
        "| new | 0 | ? |",
    ):
        assert line in page
    assert "blank in Boulder: it is afraid." in page
    assert "made from earlier code: good: Golf; blank: everywhere" in page
    assert "measured with torch 1" in page
    assert "Roadrunner has no ladder yet." in page


def test_versions_of_agents_that_were_measured_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    """One line where all were measured with the same; else each line has its agents."""
    versions = {"SARSA": "edugym 1", "QLearning": "edugym 1"}
    monkeypatch.setattr(agent_profiles, "_about", lambda: {"versions": versions})
    assert agent_profiles.made_with() == "edugym 1"
    versions["DQN"] = "edugym 2"
    assert agent_profiles.made_with() == "edugym 2 (DQN); edugym 1 (QLearning, SARSA)"
