"""The programs in docs: each writes what its own `--check` accepts, and that finds what is out of date."""

import importlib
import sys
from pathlib import Path

import pytest

from edugym.adapters.registration import find

DOCS = Path(__file__).parents[1] / "docs"
FEW = [find("Casino"), find("Golf")]
"""Environments whose films need no training."""
NAMES = {"agents": ("PAGE", "CHALLENGE"), "architecture": ("PAGE", "PICTURE"), "isolation": ("PAGE",), "pages": ()}
"""Where each program writes."""


@pytest.mark.parametrize("name", NAMES)
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
