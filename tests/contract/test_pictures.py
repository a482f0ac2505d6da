"""What is drawn of every environment is what is written beside this file: each shape, with its place and its colour."""

import dataclasses
import difflib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from edugym.registration import ENVIRONMENTS, Entry
from edugym.rendering.scene import Scene
from tests.contract.parameters import PARAMETERS
from tests.contract.play import Player, every_environment

FOLDER = Path(__file__).parent / "pictures"
LARGE: dict[str, dict[str, Any]] = {
    "Boulder": {"height": 30, "n_grips": 3},
    "MemoryCorridor": {"num_doors": 5},
    "Study": {"total_days": 38},
}
"""Tasks of which a picture shows only a part, or more than by default."""


def lines_of(scene: Scene) -> list[str]:
    """A line for the picture, and one for each shape, with what differs from its defaults."""
    ground = f"{scene.width:g} x {scene.height:g}, {scene.background}, {scene.columns} columns: {scene.title}"
    return [re.sub(r"-?\d+\.\d+(e-?\d+)?", rounded, line) for line in (ground, *map(line_of, scene.shapes))]


def rounded(number: re.Match[str]) -> str:
    """The number with two digits behind the point: the others may differ on another machine."""
    return f"{round(float(number[0]), 2) + 0.0:g}"


def line_of(shape: Any) -> str:
    """The class of a shape, and what differs from its defaults."""
    changed = {
        field.name: value
        for field in dataclasses.fields(shape)
        if (value := getattr(shape, field.name)) != field.default
    }
    return f"{type(shape).__name__} {changed}"


def frames(entry: Entry) -> Iterator[tuple[str, Scene]]:
    """The first four frames of an episode, and the last one of several: played well, and at random."""
    player = Player(entry.load()(), entry.name)
    informed = PARAMETERS[entry.name].informed
    for episode, well in enumerate((True, True, False, False, False, False)):
        _, player.info = player.env.reset(seed=episode)
        for step in range(100):
            if episode == 0 and step < 4:
                yield f"episode 0, step {step}", player.bare.scene()
            good = informed(player.info, player.bare) if informed and well else player.actions.sample()
            _, _, terminated, truncated, player.info = player.env.step(good)
            if terminated or truncated:
                break
        yield f"episode {episode}, {'well' if well else 'at random'}, the last step", player.bare.scene()


def large(entry: Entry) -> Iterator[tuple[str, Scene]]:
    """Three frames of an episode of a large task that is played well."""
    player = Player(entry.load()(**LARGE[entry.name]), entry.name)
    informed: Any = PARAMETERS[entry.name].informed
    for step in range(30):
        if step in (0, 16, 29):
            yield f"large, step {step}", player.bare.scene()
        *_, player.info = player.env.step(informed(player.info, player.bare))


def pictures(entry: Entry) -> str:
    """What is drawn: of each frame, what differs from the one before."""
    before: list[str] = []
    told = []
    for name, scene in (*frames(entry), *(large(entry) if entry.name in LARGE else ())):
        now = lines_of(scene)
        told += [name, *(f"  {line}" for line in difflib.ndiff(before, now) if line[0] in "+-")]
        before = now
    return "\n".join(told) + "\n"


@every_environment
def test_pictures(entry: Entry) -> None:
    """If the change is meant, delete the file: this test writes it anew, for you to read what has changed."""
    now, path = pictures(entry), FOLDER / f"{entry.name}.txt"
    if not path.exists():
        path.write_text(now, encoding="utf-8")
        pytest.fail(f"{path} is new: read it, and commit it")
    assert now.splitlines() == path.read_text(encoding="utf-8").splitlines()


def test_every_file_is_of_an_environment() -> None:
    """Or it would be left behind."""
    assert {path.stem for path in FOLDER.glob("*.txt")} == {entry.name for entry in ENVIRONMENTS}
