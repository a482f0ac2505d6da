"""Whatever the parameters, an environment is made and drawn in a moment, or refuses them by name."""

import inspect
from typing import Any

import numpy as np
import pytest

from edugym.adapters.registration import Entry, make_environment, parameters_of
from edugym.rendering.ansi import to_text
from edugym.rendering.palette import STONE
from edugym.rendering.scene import Circle
from tests.contract.play import every_environment

LARGEST: list[tuple[str, dict[str, Any]]] = [
    ("Boulder", {"height": 10**6, "n_grips": 1000}),
    ("Roadrunner", {"size": 10**6, "stop_zone": 10**6 - 2}),
    ("Roadrunner", {"size": 50, "stop_zone": 48}),
    ("Study", {"total_days": 10**5, "lecture_days": 50_000, "n_actions": 1000}),
    ("Catch", {"rows": 1000, "columns": 1000}),
    ("MemoryCorridor", {"num_doors": 1000, "max_steps": 2**62}),
    ("Tamagotchi", {"max_msg_length": 56, "vocab_size": 2}),
    ("Tamagotchi", {"vocab_size": 2**31}),
    ("Trashbot", {"n_bins": 2**31}),
    ("Trashbot", {"n_bins": 100}),
    ("Golf", {"width": 1001, "length": 1001}),
    ("Golf", {"stochasticity_level": 1000}),
    ("Golf", {"stochasticity_level": 1000, "width": 3, "length": 1001, "max_hits": 10**6}),
]
MOST_SHAPES, MOST_CHARACTERS = 2_000, 50_000


@pytest.mark.parametrize(("name", "parameters"), LARGEST, ids=str)
def test_pictures_of_large_tasks(name: str, parameters: dict[str, Any]) -> None:
    """They have few enough shapes and characters to be drawn in much less than a second."""
    env = make_environment(name, **parameters)
    env.action_space.seed(0)
    env.reset(seed=0)
    for _ in range(5):
        scene = env.scene()
        assert len(scene.shapes) <= MOST_SHAPES
        assert len(to_text(scene)) <= MOST_CHARACTERS
        *_, terminated, truncated, _ = env.step(env.action_space.sample())
        if terminated or truncated:
            env.reset()


def test_boulder_shows_the_climber_among_many_grips() -> None:
    """The window of grips moves with the climber: the grip that it holds is in the picture."""
    env = make_environment("Boulder", height=30, n_grips=1000)
    env.reset(seed=0)
    for _ in range(29):
        env.step(env.info()["right_grip"])
        scene = env.scene()
        held = [shape for shape in scene.shapes if isinstance(shape, Circle) and shape.fill == STONE]
        assert held
        assert len(scene.shapes) < 2000


@every_environment
def test_huge_numbers(entry: Entry) -> None:
    """A number of 5 000 digits is refused with a sentence that names the parameter; only seeds may be so large."""
    for name in parameters_of(entry.load()):
        if name != "layout_seed":
            for huge in (10**5000, -(10**5000)):
                with pytest.raises(ValueError, match=f"^{name} must be .*, but is (a whole number of .* digits|-?inf)"):
                    entry.load()(**{name: huge})
    if "layout_seed" in parameters_of(entry.load()):
        assert entry.load()(layout_seed=10**5000)


@every_environment
def test_a_task_keeps_numbers_of_python(entry: Entry) -> None:
    """Whatever numbers its class is given: its methods are compiled once only, and it is written without types."""
    task = type(entry.load()().mdp)
    plain = task.create()
    for name, default in parameters_of(entry.load()).items():
        if type(default) in (int, float) and name in inspect.signature(task.create).parameters:
            given = (np.int64 if type(default) is int else np.float64)(default)
            made = task.create(**{name: given})
            assert [type(part) for part in made] == [type(part) for part in plain], name
