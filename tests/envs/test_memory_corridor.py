"""MemoryCorridor: an episode on paper, perfect play, and doors without a pattern."""

import itertools
from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym.adapters.registration import find
from edugym.envs.memory_corridor import MemoryCorridor
from tests.contract.described import NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused

MemoryCorridorEnv: Any = find("MemoryCorridor").load()

PARAMETERS = Parameters(
    valid=st.fixed_dictionaries({"num_doors": st.integers(2, 6)}, optional={"max_steps": st.integers(1, 60)}),
    corners=({}, {"num_doors": 2}, {"num_doors": 40}, {"max_steps": 1}, {"num_doors": 2, "max_steps": 7}),
    bad=(
        *refused("num_doors", 1, 0, -3, 1001, 10**5, *NO_WHOLE_NUMBER),
        *refused("max_steps", None, *NO_STEPS),
    ),
    informed=lambda info, _: info["right_door"],
)


def test_an_episode() -> None:
    """One marked door; then the same door unmarked and a marked one behind it; then a wrong one."""
    env = MemoryCorridorEnv()
    assert env.reset(seed=8) == (1, {"length": 1, "position": 0, "right_door": 1})
    assert env.step(1) == (3, 1.0, False, False, {"length": 2, "position": 0, "right_door": 1})
    assert env.step(1) == (2, 1.0, False, False, {"length": 2, "position": 1, "right_door": 2})
    assert env.step(0) == (2, 0.0, True, False, {"length": 2, "position": 1, "right_door": 2})


@pytest.mark.parametrize("num_doors", [2, 3, 10])
@pytest.mark.parametrize("length", [1, 4, 12])
def test_perfect_play(num_doors: int, length: int) -> None:
    """Only the last door is marked, and all stay what they were; up to length L it returns L (L + 1)/2."""
    env, returned, doors = MemoryCorridorEnv(num_doors), 0.0, list[int]()
    observation, info = env.reset(seed=num_doors)
    while info["length"] <= length:
        assert observation == (info["right_door"] if info["position"] == info["length"] - 1 else num_doors)
        now = [env.mdp.right_door(env.state.seed, place) for place in range(info["length"])]
        assert (now[: len(doors)], now[info["position"]]) == (doors, info["right_door"])
        doors = now
        observation, reward, terminated, truncated, info = env.step(info["right_door"])
        assert (reward, terminated, truncated) == (1.0, False, False)
        returned += float(reward)
    assert returned == length * (length + 1) / 2
    assert info == {"length": length + 1, "position": 0, "right_door": doors[0]}


def test_any_wrong_door_is_the_end() -> None:
    """At any place, marked or not, every other door ends the episode without reward, and nobody moves."""
    for steps, wrong in itertools.product(range(8), (1, 2)):
        env = MemoryCorridorEnv()
        before, info = env.reset(seed=5)
        for _ in range(steps):
            before, *_, info = env.step(info["right_door"])
        assert env.step((info["right_door"] + wrong) % 3) == (before, 0.0, True, False, info)


def test_doors_of_a_corridor_have_no_pattern() -> None:
    """Along one long corridor, pairs at any distance are uniform."""
    task, n = MemoryCorridor(3, 1000), 9_000
    for seed in (0, 1, 2**31 - 1):
        doors = np.array([task.right_door(seed, place) for place in range(n + 7)])
        for gap in (1, 2, 7):
            pairs = np.zeros((3, 3))
            np.add.at(pairs, (doors[:n], doors[gap : n + gap]), 1)
            assert np.abs(pairs - n / 9).max() < 5 * np.sqrt(n / 9 * 8 / 9)
