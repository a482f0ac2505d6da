"""What is drawn of every environment is what is written beside this file: shapes, places, and which share a colour."""

import dataclasses
import difflib
import importlib
import inspect
import itertools
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

from edugym.adapters.registration import Entry, make_environment
from edugym.rendering.ansi import to_text
from edugym.rendering.palette import STONE
from edugym.rendering.scene import Circle, Scene
from edugym_course import lessons
from edugym_course.lessons.own_problem.bedroom import bedroom
from tests.contract.parameters import PARAMETERS
from tests.contract.play import Player, every_environment

COLOURS, PLACES = ("fill", "colour", "outline"), ("x", "y", "points", "content")
FOLDER = Path(__file__).parent / "pictures"
OTHERS: dict[str, tuple[dict[str, Any], ...]] = {
    "Boulder": ({"height": 30, "n_grips": 3},),
    "Catch": (
        {"rows": 60, "columns": 70, "observation_type": "rgb"},
        {"rows": 2, "columns": 1, "observation_type": "vectorised"},
    ),
    "Golf": ({"width": 81, "length": 90, "stochasticity_level": 1.0}, {"width": 3, "stochasticity_level": 0}),
    "MemoryCorridor": ({"num_doors": 50},),
    "Roadrunner": ({"size": 24, "stop_zone": 5}, {"size": 60, "stop_zone": 35}),
    "Study": ({"total_days": 38, "lectures_needed": 1, "energy_needed": 3},),
    "Switches": ({"n_switches": 20}, {"n_switches": 1}),
    "Tamagotchi": ({"max_msg_length": 10, "vocab_size": 9}, {"vocab_size": 3, "tau": 0.1}),
    "Trashbot": ({"n_bins": 2}, {"n_bins": 16, "container_width": 1.0}),
}
"""Tasks of which a picture shows only a part, or others than by default."""


def lines_of(scene: Scene, colours: dict[Any, int]) -> list[str]:
    """A line for the picture, and one for each shape; shapes that come again at other places share a line with them.

    Numbers have two digits, since others may differ on another machine.
    """
    lines = [f"{scene.width:g} x {scene.height:g}, {scene.columns} columns: {scene.title}"]
    shapes = [described(shape, colours) for shape in scene.shapes]
    kinds, at = [what for what, _ in shapes], 0
    while at < len(shapes):
        times, period = max(((repeats(kinds[at:], period), period) for period in (1, *range(9, 1, -1))), key=covered)
        for k in range(at, at + period):
            places = [shapes[k + turn * period][1] for turn in range(times)]
            lines.append(" ".join((f"{period} x" * (period > 1), kinds[k], *places)))
        at += times * period
    number = re.compile(r"-?\d+\.\d+(e-?\d+)?")
    return [number.sub(lambda found: f"{round(float(found[0]), 2) + 0.0:g}", line).strip() for line in lines]


def repeats(kinds: list[str], period: int) -> int:
    """How many times the first kinds of shapes come, one time after the other."""
    return next(k for k in itertools.count(1) if kinds[k * period : (k + 1) * period] != kinds[:period])


def covered(found: tuple[int, int]) -> int:
    """How many shapes come again in that many turns of a period."""
    return (found[0] - 1) * found[1]


def described(shape: Any, colours: dict[Any, int]) -> tuple[str, str]:
    """The class of a shape with what differs from its defaults, and its place; colours are numbered as they come."""
    place, changed = [], {}
    for field in dataclasses.fields(shape):
        value = getattr(shape, field.name)
        if field.name in COLOURS:
            changed[field.name] = f"colour {colours.setdefault(value, len(colours))}"
        elif field.name in PLACES:
            place.append(value)
        elif value != field.default:
            changed[field.name] = value
    return f"{type(shape).__name__} {changed}", repr(place)


def frames(entry: Entry) -> Iterator[tuple[str, Scene]]:
    """The first two frames of an episode, and the last one of several, played well or at random; other tasks."""
    player = Player(entry.load()(), entry.name)
    for episode in (0, 2, 3, 5):
        _, player.info = player.env.reset(seed=episode)
        for step in range(100):
            if episode == 0 and step < 2:
                yield f"episode 0, step {step}", player.bare.scene()
            if stepped(player, well=episode == 0):
                break
        yield f"episode {episode}, {'at random' if episode else 'well'}, the last step", player.bare.scene()
    for k, parameters in enumerate(OTHERS.get(entry.name, ())):
        player = Player(entry.load()(**parameters), entry.name)
        for step in range(30):
            if step in (0, 16, 29):
                yield f"other task {k}, step {step}", player.bare.scene()
            if stepped(player, well=True):
                yield f"other task {k}, the last step", player.bare.scene()
                break


def stepped(player: Player, well: bool) -> bool:
    """Whether the episode is over after a good action, where one is known, or any."""
    informed = PARAMETERS[player.name].informed
    action = informed(player.info, player.bare) if informed and well else player.actions.sample()
    _, _, terminated, truncated, player.info = player.env.step(action)
    return terminated or truncated


def frames_of_lessons() -> Iterator[tuple[str, Scene]]:
    """All that lessons draw as scenes, as it is by default, and the bedroom of lesson 10."""
    for file in sorted(Path(lessons.__file__).parent.glob("*/pictures.py")):
        module = importlib.import_module(f"{lessons.__name__}.{file.parent.name}.pictures")
        for name, draw in inspect.getmembers(module, inspect.isfunction):
            if draw.__module__ == module.__name__ and not name.startswith("_"):
                yield f"{file.parent.name}: {name}", draw()
    for time, depth, action in ((0, 2, 0), (3, 1, 1), (7, 2, 2), (8, 2, 0), (8, 0, 0)):
        yield f"bedroom: {time}, {depth}, {action}", bedroom(time, depth, last_action=action)


def pictures(shown: Iterable[tuple[str, Scene]]) -> str:
    """What is drawn: of each frame, the lines that differ from those of the one before, with their numbers."""
    before: list[str] = []
    told, colours = [], dict[Any, int]()
    for name, scene in shown:
        now, gone, new = lines_of(scene, colours), list[int](), list[str]()
        for _, i, j, k, m in difflib.SequenceMatcher(None, before, now, autojunk=False).get_opcodes():
            if before[i:j] != now[k:m]:
                gone += range(i, j)
                new += [f"  {number} {now[number]}" for number in range(k, m)]
        told += [f"{name}: without {gone}" if gone else name, *new]
        before = now
    return "\n".join(told) + "\n"


@every_environment
def test_pictures(entry: Entry) -> None:
    """Of an environment."""
    compare(entry.name, frames(entry))


def test_pictures_of_lessons() -> None:
    """Of all lessons, in one file."""
    compare("lessons", frames_of_lessons())


def compare(name: str, shown: Iterable[tuple[str, Scene]]) -> None:
    """If the change is meant, delete the file: this writes it anew, for you to read what has changed."""
    now, path = pictures(shown), FOLDER / f"{name}.txt"
    if not path.exists():
        path.write_text(now, encoding="utf-8")
        pytest.skip(f"{path} is new: read it, and commit it")
    assert now.splitlines() == path.read_text(encoding="utf-8").splitlines()


@pytest.mark.parametrize(
    ("name", "parameter", "most", "others", "glyph", "shown", "beyond"),
    [
        ("Boulder", "height", 12, {}, "●", 12, 12),  # one grip of each level holds
        ("Boulder", "n_grips", 40, {"height": 2}, "×", 78, 78),  # and the others do not
        ("Catch", "columns", 50, {"rows": 50}, "Line", 2 + 49 + 49, 2),  # a grid, or none
        ("Catch", "rows", 50, {"columns": 5}, "Line", 2 + 49 + 4, 2),
        ("MemoryCorridor", "num_doors", 40, {}, "○", 39, 39),  # all lamps but one are dark
        ("Roadrunner", "size", 50, {}, "Line", 50, 1),
        ("Roadrunner", "size", 50, {"stop_zone": 9}, "_", 10, 1),
        ("Study", "total_days", 30, {}, "Text", 62, 62),  # two for each page, and the names of two bars
        ("Trashbot", "n_bins", 15, {}, "·", 15 * 15, 0),  # a dot for each pair of actions, or a line around them
    ],
)
def test_how_much_is_shown(
    name: str, parameter: str, most: int, others: dict[str, Any], glyph: str, shown: int, beyond: int
) -> None:
    """Of the largest task that is drawn in full, and of the next one."""

    def count(value: int) -> int:
        parameters: dict[str, Any] = {parameter: value, **others}
        env: Any = make_environment(name, **parameters)
        env.reset(seed=0)
        return sum(glyph in (shape.glyph, type(shape).__name__) for shape in env.scene().shapes)

    assert (count(most), count(most + 1)) == (shown, beyond)


LARGEST: list[tuple[str, dict[str, Any]]] = [
    ("Boulder", {"height": 10**6, "n_grips": 1000}),
    ("Roadrunner", {"size": 10**6, "stop_zone": 10**6 - 2}),
    ("Study", {"total_days": 10**5, "lecture_days": 50_000, "n_actions": 1000}),
    ("MemoryCorridor", {"num_doors": 1000, "max_steps": 2**62}),
    ("Switches", {"n_switches": 62}),
    ("Tamagotchi", {"max_msg_length": 56, "vocab_size": 2}),
    ("Tamagotchi", {"vocab_size": 2**31}),
    ("Trashbot", {"n_bins": 2**31}),
    ("Golf", {"width": 1001, "length": 1001}),
    ("Golf", {"stochasticity_level": 1000, "width": 3, "length": 1001, "max_hits": 10**6}),
]
MOST_SHAPES, MOST_CHARACTERS = 2_000, 50_000


@pytest.mark.parametrize(("name", "parameters"), LARGEST, ids=str)
def test_pictures_of_large_tasks(name: str, parameters: dict[str, Any]) -> None:
    """They have few enough shapes and characters to be drawn in much less than a second."""
    player = Player(make_environment(name, **parameters), name)
    for _ in range(5):
        scene = player.bare.scene()
        assert len(scene.shapes) <= MOST_SHAPES
        assert len(to_text(scene)) <= MOST_CHARACTERS
        player.play(1)


def test_boulder_shows_the_climber_among_many_grips() -> None:
    """The window of grips moves with the climber: the grip that it holds is in the picture."""
    env = make_environment("Boulder", height=30, n_grips=1000)
    env.reset(seed=0)
    for _ in range(29):
        env.step(env.info()["right_grip"])
        shapes = env.scene().shapes
        assert any(isinstance(shape, Circle) and shape.fill == STONE for shape in shapes)
        assert len(shapes) < MOST_SHAPES
