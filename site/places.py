"""Where the states of each task lie in the picture that its environment draws, and which pictures there are.

Most places are read off the environment's own scene: where it draws the face, or the ball, of a state.
"""

import dataclasses
import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

import edugym
from edugym.envs.diver import N_COLUMNS
from edugym.envs.golf import Ball
from edugym.envs.memory_corridor import Corridor
from edugym.envs.roadrunner import Runner
from edugym.envs.switches import Panel
from edugym.envs.tamagotchi import Toy
from edugym.envs.trashbot.geometry import BOX, BOX_SIZE, FOREARM, MAGNET, REACH, SHOULDER_Y, UPPER_ARM, Robot
from edugym.envs.trashbot.picture import FRAME, TOP
from edugym.rendering.palette import BLUE, INK, RED, ROAD, STONE
from edugym.rendering.scene import Circle, Scene, Text
from edugym.rendering.svg import to_svg
from edugym_course.lessons.continuous_actions.methods import CELLS

LONGEST_SHOWN = 10
"""Pictures are kept of corridors up to this length."""


class Cell(NamedTuple):
    """Where rows of a table lie in the picture: a rectangle, in the units of the scene."""

    x: float
    y: float
    width: float
    height: float


Place = tuple[Cell | None, int]
"""The cell of an observation, None where it has none, and its layer. Observations that differ only in what is not a
place (what has been collected, where the paddle is) lie in one cell, in different layers."""

Marks = list[tuple[float, float, str]]
"""For each action a sign, and where it stands: so far to the right of the middle of the cell, and so far below it."""


def _any_signs(mdp: Any) -> Marks:
    return []


def _own_scene(mdp: Any, state: Any) -> Scene:
    scene: Scene = mdp.scene(state)
    return scene


def _all_states(mdp: Any) -> Iterator[Any]:
    yield from edugym.finite_model(mdp).states


def _still(mdp: Any) -> None:
    return None


class Map(NamedTuple):
    """How a task lies in its pictures.

    Attributes:
        place: where an observation lies.
        look: which numbers in a state decide its picture, by their names; "" is the state itself.
        marks: the signs of the actions.
        pictures: states, one at least for each picture that there can be.
        scene: the picture of a state.
        moves: how a picture moves that has no steps; None for those that have.
    """

    place: Callable[[Any, tuple[int, ...]], Place]
    look: tuple[str, ...]
    marks: Callable[[Any], Marks] = _any_signs
    pictures: Callable[[Any], Iterator[Any]] = _all_states
    scene: Callable[[Any, Any], Scene] = _own_scene
    moves: Callable[[Any], dict[str, Any] | None] = _still


def circle(scene: Scene, glyph: str = "☺") -> Circle:
    """The first circle of a scene that the character back end draws as `glyph`: by default the face."""
    return next(shape for shape in scene.shapes if isinstance(shape, Circle) and shape.glyph == glyph)


def from_one(mdp: Any, state: Any) -> Scene:
    """The picture in which machines or switches are numbered from 1: a reader calls the first one so."""
    scene: Scene = mdp.scene(state)
    shapes, number = list[Any](), 0
    for shape in scene.shapes:
        if isinstance(shape, Text) and shape.content == str(number):
            number += 1
            shape = dataclasses.replace(shape, content=str(number))
        shapes.append(shape)
    return dataclasses.replace(scene, shapes=shapes)


def _by_the_places(mdp: Any, state: Any) -> Scene:
    """The doors below the place in the corridor, which is not called a door."""
    scene: Scene = mdp.scene(state)
    above = Text(scene.width / 2, 0.5, f"place {state.position + 1} of {state.length}", size=0.5)
    is_above = [isinstance(shape, Text) and shape.content.startswith("Door ") for shape in scene.shapes]
    shapes = [above if replaced else shape for shape, replaced in zip(scene.shapes, is_above, strict=True)]
    return dataclasses.replace(scene, shapes=shapes)


def signs(*names: str) -> Callable[[Any], Marks]:
    """Signs in the middle of a cell."""
    return lambda mdp: [(0.0, 0.0, name) for name in names]


def _first(mdp: Any) -> Any:
    return mdp.initial(np.random.default_rng(0))


def _whole_wall(mdp: Any, state: int) -> Scene:
    scene: Scene = mdp.scene(state, mdp.height)
    return scene


def _on_the_wall(mdp: Any, seen: tuple[int, ...]) -> Place:
    return Cell(1.05, circle(_whole_wall(mdp, seen[0])).y - 0.5, mdp.n_grips + 0.9, 1.0), 0


def _grips(mdp: Any) -> Marks:
    return [(grip - (mdp.n_grips - 1) / 2, -1.0, "○") for grip in range(mdp.n_grips)]


def _on_the_road(mdp: Any, seen: tuple[int, ...]) -> Place:
    x, dx = seen
    fastest = math.isqrt(2 * mdp.size) + 1
    if x >= mdp.size or dx > fastest:
        return None, 0
    face = circle(mdp.scene(Runner(x, 0)))
    height = 5.4 * face.radius / (fastest + 1)
    return Cell(face.x - 0.5, face.y + face.radius - (dx + 1) * height, 1.0, height), 0


def _on_the_calendar(mdp: Any, seen: tuple[int, ...]) -> Place:
    knowledge, energy, day = seen
    if day == mdp.total_days:
        return None, 0
    face = circle(mdp.scene(_first(mdp)._replace(day=day)))
    n_knowledge, n_energy, _ = (int(n) for n in mdp.observation_space.nvec)
    width, height = 1.7 / n_energy, 1.3 / n_knowledge
    return Cell(face.x - 0.85 + energy * width, face.y + 0.93 - (knowledge + 1) * height, width, height), 0


def _on_the_board(mdp: Any, seen: tuple[int, ...]) -> Place:
    ball_x, ball_y, paddle_x = seen
    ball = circle(mdp.scene(_first(mdp)._replace(ball_x=ball_x, ball_y=ball_y)), "o")
    return Cell(ball.x - 0.5, ball.y - 0.36, 1.0, 1.0), paddle_x


def _at_the_doors(mdp: Any, seen: tuple[int, ...]) -> Place:
    (mark,) = seen
    width = max(2.0 * mdp.num_doors + 1.0, 7.0)
    if mark == mdp.num_doors:  # no door is marked: the floor
        return Cell(0.25, 4.75, width - 0.5, 1.4), 0
    return Cell((width - 2.0 * mdp.num_doors) / 2 + 0.25 + 2.0 * mark, 1.6, 1.5, 3.0), 0


def _doors(mdp: Any) -> Marks:
    return [(0.0, 0.0, str(door)) for door in range(mdp.num_doors)]


def _corridors(mdp: Any) -> Iterator[Corridor]:
    """A state for each picture. Which door is right follows from the seed, so seeds are tried."""
    for length in range(1, LONGEST_SHOWN + 1):
        for position in range(length):
            for mark in range(mdp.num_doors) if position == length - 1 else (0,):
                seed = next(seed for seed in range(10_000) if mdp.right_door(seed, position) == mark)
                yield from (Corridor(seed, length, position, opened) for opened in range(-1, mdp.num_doors))


def _on_the_screen(mdp: Any, seen: tuple[int, ...]) -> Place:
    hp, word = seen
    column = min(hp // 20, 4)
    return Cell(3.6 + 0.96 * column, 6.3 + 0.82 * word, 0.96, 0.82), hp - 20 * column


def _toys(mdp: Any) -> Iterator[Toy]:
    return (Toy((100, 100, 100, 100), hp, 0, message) for hp in range(101) for message in range(mdp.vocab_size))


def _under_the_wrist(mdp: Any, seen: tuple[int, ...]) -> Place:
    column, row, holding = seen[2], seen[3], seen[6]
    size = 2 * REACH / CELLS
    return Cell(column * size - REACH + FRAME, TOP - ((row + 1) * size - REACH + SHOULDER_Y), size, size), holding


def _robots(mdp: Any) -> Iterator[Robot]:
    yield _first(mdp)
    yield _first(mdp)._replace(shoulder=1.0, elbow=1.0, holding=True)


def _arm(mdp: Any) -> dict[str, Any]:
    """What is needed to draw the arm by its angles, in the units of the scene."""
    return {
        "kind": "arm",
        "shoulder": [FRAME, TOP - SHOULDER_Y],
        "links": [UPPER_ARM, FOREARM, MAGNET],
        "box": [BOX.left + FRAME, TOP - BOX.top, BOX_SIZE],
        "ground": TOP,
        "colours": {"ink": INK, "link": ROAD, "joint": STONE, "box": RED, "magnet": BLUE},
    }


def _on_the_course(mdp: Any, seen: tuple[int, ...]) -> Place:
    ball = circle(mdp.scene(Ball(seen[0] + 0.5, seen[1] + 0.5, 0)), "o")
    return Cell(ball.x - 0.5, ball.y - 0.5, 1.0, 1.0), 0


def _balls(mdp: Any) -> Iterator[Ball]:
    yield _first(mdp)
    yield Ball(mdp.width / 3, mdp.length / 2, 1)


def _without_text(mdp: Any, state: Any) -> Scene:
    scene: Scene = mdp.scene(state)
    return dataclasses.replace(scene, shapes=[shape for shape in scene.shapes if not isinstance(shape, Text)])


def _ball(mdp: Any) -> dict[str, Any]:
    """The ball and the player beside it; y grows upwards in the task, and downwards in the picture."""
    first, other = (to_svg(_without_text(mdp, state)).split("\n") for state in _balls(mdp))
    start = _first(mdp)
    sprite = "".join(element for element in first[3:-1] if element not in other)
    return {"kind": "ball", "sprite": sprite, "start": [start.x, start.y]}


def _in_the_aisles(mdp: Any, seen: tuple[int, ...]) -> Place:
    (state,) = seen
    return Cell(float(state // 8 % 10), float(state // 80), 1.0, 1.0), state % 8


def _by_what_is_wrong(mdp: Any, seen: tuple[int, ...]) -> Place:
    """Below the switches, from the left by how many of them are wrong."""
    n = mdp.n_switches
    wrong = sum(switch != wanted for switch, wanted in zip(seen[:n], seen[n:], strict=True))
    width = (max(n, 4) + 1.6) / (n + 1)
    return Cell(0.2 + wrong * width, 4.25, width, 0.3), int("".join(map(str, seen)), 2)


def _panels(mdp: Any) -> Iterator[Panel]:
    patterns = range(2**mdp.n_switches)
    return (Panel(switches, goal) for switches in patterns for goal in patterns)


def _below_the_arms(mdp: Any, seen: tuple[int, ...]) -> Place:
    face = circle(mdp.scene(mdp.first_best))
    return Cell(face.x - 0.5, face.y - 0.45, 1.0, 0.9), 0


def _arms(mdp: Any) -> Marks:
    return [(0.9, 0.0, str(arm + 1)) for arm in range(mdp.n_arms)]


def _by_the_casino(mdp: Any, seen: tuple[int, ...]) -> Place:
    face = circle(mdp.scene(seen[0]))
    return Cell(face.x - 0.5, face.y - 0.45, 1.0, 0.9), 0


def _in_the_sea(mdp: Any, seen: tuple[int, ...]) -> Place:
    y, x = divmod(seen[0], N_COLUMNS)
    return (Cell(float(x), y + 1.0, 1.0, 1.0) if y <= x + 1 else None), 0


def _without_steps(mdp: Any, state: Any) -> Scene:
    """The sea without the text above it, which counts the steps: they do not follow from the state."""
    scene: Scene = mdp.scene(state)
    above = [shape for shape in scene.shapes if isinstance(shape, Text) and shape.y < 1.0]
    return dataclasses.replace(scene, shapes=[shape for shape in scene.shapes if shape not in above])


MAPS = {
    "Bandit": Map(_below_the_arms, ("",), _arms, scene=from_one),
    "Boulder": Map(_on_the_wall, ("",), _grips, lambda mdp: iter(range(mdp.height + 1)), _whole_wall),
    "Roadrunner": Map(_on_the_road, (".x", ".dx"), signs("−", "=", "+")),
    "Study": Map(_on_the_calendar, (".knowledge", ".energy", ".day", ".passed"), signs("S", "z", "o", "·", "·")),
    "Catch": Map(
        _on_the_board, (".ball_x", ".ball_y", ".paddle_x"), signs("←", "•", "→"), scene=_without_text
    ),  # what an agent sees differs
    "MemoryCorridor": Map(
        _at_the_doors, (".length", ".position", ".opened", "observation"), _doors, _corridors, _by_the_places
    ),
    "Tamagotchi": Map(_on_the_screen, (".hp", ".message"), signs("p", "s", "f", "c"), _toys),
    "Trashbot": Map(
        _under_the_wrist,
        (".shoulder", ".elbow", ".holding", ".outcome"),
        pictures=_robots,
        scene=_without_text,
        moves=_arm,
    ),
    "Golf": Map(_on_the_course, (".x", ".y"), signs("p", "c", "d"), _balls, _without_text, _ball),
    "Casino": Map(_by_the_casino, ("",), scene=from_one),
    "Diver": Map(_in_the_sea, ("",), signs("↓", "→"), scene=_without_steps),
    "Switches": Map(_by_what_is_wrong, (".switches", ".goal"), pictures=_panels, scene=from_one),
    "Supermarket": Map(_in_the_aisles, ("",), signs("↑", "↓", "←", "→")),
}
"""The map of each task, by the name of its environment."""
