"""MemoryCorridor: an episode on paper, perfect play, and doors without a pattern."""

from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym.envs.memory_corridor import MemoryCorridor
from edugym.rendering.scene import Rectangle
from tests.contract.described import NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused
from tests.envs.classes import MemoryCorridorEnv

PARAMETERS = Parameters(
    valid=st.fixed_dictionaries({"num_doors": st.integers(2, 6)}, optional={"max_steps": st.integers(1, 60)}),
    corners=({}, {"num_doors": 2}, {"num_doors": 40}, {"max_steps": 1}, {"num_doors": 2, "max_steps": 7}),
    bad=(
        *refused("num_doors", 1, 0, -3, 1001, 10**5, *NO_WHOLE_NUMBER),
        *refused("max_steps", None, *NO_STEPS),
    ),
    informed=lambda info, _: info["right_door"],
)


MARKED = """
        Door 1 of 1
     ○       ●       ○

             !


     0       1       2


             ☺



"""

UNMARKED = """
        Door 1 of 2
     ○       ○       ○

     ?       ?       ?


     0       1       2


             ☺



"""

LAST = """
        Door 2 of 2
     ○       ○       ●

                     !


     0       1       2


             ☺



"""

LOCKED_IN = """
        Door 2 of 2
     ○       ○       ●

                     !


     0       1       2


     ☺



"""


def test_an_episode() -> None:
    """One marked door; then the same door unmarked and a marked one behind it; then a wrong one."""
    env = MemoryCorridorEnv(render_mode="ansi")
    assert env.reset(seed=8) == (1, {"length": 1, "position": 0, "right_door": 1})
    assert env.render() == MARKED
    assert env.step(1) == (3, 1.0, False, False, {"length": 2, "position": 0, "right_door": 1})
    assert env.render() == UNMARKED
    assert env.step(1) == (2, 1.0, False, False, {"length": 2, "position": 1, "right_door": 2})
    assert env.render() == LAST
    assert env.step(0) == (2, 0.0, True, False, {"length": 2, "position": 1, "right_door": 2})
    assert env.render() == LOCKED_IN


class Memory:
    """A perfect player: writes down every door that is marked, and finds the others in its notes."""

    def __init__(self, num_doors: int) -> None:
        """Nothing written yet."""
        self.num_doors, self.place = num_doors, 0
        self.notes: list[int] = []

    def choose(self, observation: int) -> int:
        """The right door."""
        if observation == self.num_doors:
            self.place += 1
            return self.notes[self.place - 1]
        self.notes.append(observation)
        self.place = 0
        return observation


@pytest.mark.parametrize("num_doors", [2, 3, 10])
@pytest.mark.parametrize("length", [1, 4, 12])
def test_perfect_play(num_doors: int, length: int) -> None:
    """What is observed is enough to play on for ever; through the corridor of length L it returns L (L + 1)/2."""
    env = MemoryCorridorEnv(num_doors)
    observation, info = env.reset(seed=num_doors)
    player, returned = Memory(num_doors), 0.0
    doors: list[int] = []
    while info["length"] <= length:
        assert observation == (info["right_door"] if info["position"] == info["length"] - 1 else num_doors)
        now = [env.mdp.right_door(env.state.seed, place) for place in range(info["length"])]
        assert now[: len(doors)] == doors
        doors = now
        action = player.choose(observation)
        assert action == info["right_door"]
        observation, reward, terminated, truncated, info = env.step(action)
        assert (reward, terminated, truncated) == (1.0, False, False)
        returned += float(reward)
    assert returned == length * (length + 1) / 2
    assert info == {"length": length + 1, "position": 0, "right_door": doors[0]}


def test_step_limit() -> None:
    """Perfect play is stopped after `max_steps` steps with as much reward; an error in the last one is an end."""
    for last, seen in ((0, (1.0, False, True)), (1, (0.0, True, False))):
        env = MemoryCorridorEnv(max_steps=20)
        observation, info = env.reset(seed=0)
        player = Memory(3)
        for _ in range(19):
            observation, reward, terminated, truncated, info = env.step(player.choose(observation))
            assert (reward, terminated, truncated) == (1.0, False, False)
        assert env.step((info["right_door"] + last) % 3)[1:4] == seen


@pytest.mark.parametrize("wrong", [1, 2])
def test_any_wrong_door_is_the_end(wrong: int) -> None:
    """At any place, marked or not, every other door ends the episode without reward, and nobody moves."""
    for steps in range(8):
        env = MemoryCorridorEnv()
        before, info = env.reset(seed=5)
        for _ in range(steps):
            before, *_, info = env.step(info["right_door"])
        assert env.step((info["right_door"] + wrong) % 3) == (before, 0.0, True, False, info)


@pytest.mark.parametrize(("place", "gap"), [(0, 1), (0, 2), (3, 1), (10, 40)])
def test_doors_have_no_pattern(place: int, gap: int) -> None:
    """The right doors are independent and uniform, and new ones in every episode."""
    task = MemoryCorridor(3, 1000)
    rng = np.random.default_rng(0)
    pairs = np.zeros((3, 3))
    n = 3000
    for _ in range(n):
        state = task.initial(rng)
        pairs[task.right_door(state.seed, place), task.right_door(state.seed, place + gap)] += 1
    assert np.abs(pairs - n / 9).max() < 5 * np.sqrt(n / 9 * 8 / 9)


def test_doors_of_a_corridor_have_no_pattern() -> None:
    """Along one long corridor, pairs at any distance are uniform."""
    task, n = MemoryCorridor(3, 1000), 9_000
    for seed in (0, 1, 2**31 - 1):
        doors = np.array([task.right_door(seed, place) for place in range(n + 7)])
        for gap in (1, 2, 7):
            pairs = np.zeros((3, 3))
            np.add.at(pairs, (doors[:n], doors[gap : n + gap]), 1)
            assert np.abs(pairs - n / 9).max() < 5 * np.sqrt(n / 9 * 8 / 9)


@pytest.mark.parametrize("num_doors", [2, 40])
def test_pictures(num_doors: int) -> None:
    """There is a picture of corridors of any width and length."""
    env: Any = MemoryCorridorEnv(num_doors, render_mode="ansi")
    _, info = env.reset(seed=0)
    for _ in range(400):
        *_, info = env.step(info["right_door"])
    frame = env.render()
    assert f"Door {info['position'] + 1} of {info['length']}" in frame
    assert frame.count("☺") == 1


@pytest.mark.parametrize(("position", "place"), [(0, 0), (12, 12), (30, 12), (48, 12), (50, 14), (59, 23)])
def test_the_place_in_a_long_corridor(position: int, place: int) -> None:
    """Of sixty squares twenty-four are shown, those around the agent; its own is yellow, those behind it are dark."""
    task = MemoryCorridor(3, 1000)
    state = task.initial(np.random.default_rng(0))._replace(length=60, position=position)
    shapes = [shape for shape in task.scene(state).shapes if isinstance(shape, Rectangle) and shape.y == 6.6]
    *squares, mark = shapes
    assert len(squares) == 24
    assert mark.x == pytest.approx(squares[place].x)
    assert [square.fill == squares[-1].fill for square in squares[:-1]] == [k >= place for k in range(23)]
