"""The editor of the playground: what a reader may begin with runs, and mistakes are told with their line."""

import re
import tarfile
from pathlib import Path
from typing import Any

import editor
import edugym_page
import playground
import pytest
from races import RACES, Race

SHORT = re.findall(r"SHORT = `(.*?)`", (playground.PAGE / "editor.js").read_text(encoding="utf-8"), re.DOTALL)[0]
BOULDER_OF_4 = 'mdp = edugym.make_mdp("Boulder", height=4)'


def made(race: Race, seen: str) -> str:
    """The lines that make a task, as an agent sees it."""
    value = race.strength.values[race.strength.first]
    given = {race.strength.parameter: value, **race.parameters}
    text = ", ".join([repr(race.environment), *(f"{name}={value!r}" for name, value in given.items())])
    return f"mdp = edugym.make_mdp({text})\n" + (f"mdp = {seen}\n" if seen else "")


def run(source: str, task: str = BOULDER_OF_4, steps: int = 300) -> dict[str, Any]:
    """What comes of a program."""
    return edugym_page.run(source, task, steps, 0, 1)


def test_the_short_agent_learns() -> None:
    """And nothing is said of it."""
    found = run(SHORT, steps=3_000)
    assert found["curve"][-1] == [3_000, 1.0]
    assert found["said"] == []


QUICK, *OTHERS = RACES


@pytest.mark.parametrize(
    "races", [[QUICK], pytest.param(OTHERS, marks=pytest.mark.slow)], ids=["one task", "all others"]
)
def test_all_agents_run_from_their_files(races: list[Race]) -> None:
    """In every task; the settings are those of the lesson."""
    texts = playground.sources(races)
    for race in races:
        for entry in playground.menu(race)["agents"]:
            settings = "".join(f", {name}={value}" for name, value in entry["settings"])
            source = f"{texts[entry['kind']]}\n\nagent = {entry['kind']}.create(mdp{settings})\n"
            found = run(source, made(race, entry["seen"]), steps=60)
            assert "curve" in found, (race.environment, entry["label"], found)


MISTAKES = {
    "agent = 3 +": (1, "SyntaxError"),
    "x = 1": (None, "agent = ..."),
    "agent = 3": (None, "agent must be an object with the methods act and learn"),
    SHORT.replace("target - ", "target - sef."): (17, "NameError"),
    SHORT.replace("return rng.choice(best)", "return 7"): (None, "act"),
}


@pytest.mark.parametrize("source", MISTAKES, ids=lambda source: str(len(source)))
def test_mistakes_are_told_with_their_line(source: str) -> None:
    """In one sentence of the package's own where there is one."""
    line, word = MISTAKES[source]
    found = run(source)
    assert word in found["error"]
    assert found["line"] == line


def test_what_is_interpreted_says_why() -> None:
    """With the line, in a sentence."""
    found = run(SHORT.replace("        target =", "        notes = {}\n        target ="), steps=6_000)
    (said,) = found["said"]
    assert "it makes a dict (line 16)" in said


def test_without_npm_there_is_no_editor(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The page is built all the same."""
    monkeypatch.setattr(editor, "PACKAGES", tmp_path / "npm")
    monkeypatch.setenv("PATH", "")
    assert editor.build(tmp_path / "python") is None
    assert not (tmp_path / "python").exists()


def test_what_is_fetched_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An archive that is there is not fetched again."""
    monkeypatch.setattr(editor, "PACKAGES", tmp_path)
    monkeypatch.setenv("PATH", "")
    kept = tmp_path / "a-b-1.0.tgz"
    tarfile.open(kept, "w").close()
    assert editor._fetched("@a/b@1.0") == kept
