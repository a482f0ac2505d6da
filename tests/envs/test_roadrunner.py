"""Roadrunner: runs that a person can follow, every rule at its edges, and the optima."""

from math import inf, nan
from typing import Any

import pytest
from hypothesis import strategies as st

from edugym.adapters.registration import find
from edugym.envs.roadrunner import Roadrunner, Runner
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.contract.described import NO_STEPS, NO_WHOLE_NUMBER, Keywords, Parameters, refused

RoadrunnerEnv: Any = find("Roadrunner").load()


@st.composite
def roads(draw: st.DrawFn) -> Keywords:
    """Roads whose start is not in the stop zone."""
    size = draw(st.integers(2, 25))
    return {
        "size": size,
        "max_speed": draw(st.integers(1, 30)),
        "negative_reward": draw(st.floats(-1e6, 0)),
        "stop_zone": draw(st.integers(0, size - 2)),
        "max_steps": draw(st.none() | st.integers(1, 60)),
    }


PARAMETERS = Parameters(
    valid=roads(),
    corners=(
        {},
        {"size": 2, "max_speed": 1, "stop_zone": 0},
        {"size": 100, "max_speed": 200, "stop_zone": 98, "negative_reward": 0},
        {"size": 30, "stop_zone": 3, "negative_reward": -1, "max_steps": 1},
    ),
    bad=(
        *refused("size", 1, 0, -10, 10**6 + 1, 10**400, *NO_WHOLE_NUMBER),
        *refused("max_speed", 0, -1, 10**6 + 1, *NO_WHOLE_NUMBER),
        *refused("negative_reward", 1, 0.5, -inf, inf, nan, "-1", None, True),
        *refused("stop_zone", -1, 9, 10, *NO_WHOLE_NUMBER),
        *refused("stop_zone", 1, size=2),
        *refused("max_steps", *NO_STEPS),
    ),
    finite=({}, {"size": 2}, {"size": 15, "max_speed": 3, "stop_zone": 2, "negative_reward": -1}),
    random=False,
    informed=lambda _, env: 2 if env.state.dx < 1 else 1,
)


SLOWER, SAME, FASTER = 0, 1, 2


def test_stall() -> None:
    """A speed below 0 ends the episode where the runner is; the state keeps the -1 that the observation hides."""
    env = RoadrunnerEnv()
    env.reset(seed=0)
    for action, expected in [(FASTER, (1, 1)), (FASTER, (3, 2)), (SLOWER, (4, 1)), (SLOWER, (4, 0)), (SLOWER, (4, -1))]:
        observation, reward, terminated, _, info = env.step(action)
        assert env.state == Runner(*expected)
    assert observation.tolist() == [4, 0]
    assert (reward, terminated) == (-100.0, True)
    assert info == {"distance": 5, "stalled": True}


@pytest.mark.parametrize("stop_zone", [0, 1, 4])
@pytest.mark.parametrize("max_speed", [1, 3, 12])
def test_every_transition(max_speed: int, stop_zone: int) -> None:
    """Steps agree with the rules in words, in every state that can be reached and for every action."""
    env = RoadrunnerEnv(size=12, max_speed=max_speed, negative_reward=-5, stop_zone=stop_zone)
    target = 11
    running = [state for state in env.finite_model.states if not env.mdp.terminal(state)]
    assert max(state.dx for state in running) == min(max_speed, 4 if stop_zone == 0 else 3)  # 1 + 2 + 3 + 4 is 10
    for x, dx in running:
        for action, change in enumerate([-1, 0, 1]):
            speed = min(dx + change, max_speed)
            missing = target - (x + speed)
            if speed < 0:
                expected: tuple[Any, ...] = (x, -1), -5.0, True
            elif missing < 0:
                expected = (12, speed), -5.0, True
            elif missing <= stop_zone:
                expected = (x + speed, speed), 1.0 - missing, True
            else:
                expected = (x + speed, speed), -1.0, False
            env.reset()
            env.state = Runner(x, dx)
            _, reward, terminated, _, _ = env.step(action)
            assert (env.state, reward, terminated) == expected


@pytest.mark.parametrize(("size", "steps"), [(2, 1), (10, 4), (15, 5), (20, 6), (25, 7)])
@pytest.mark.parametrize("penalty", [-100.0, -3.0, -1.0, 0.0])
def test_best_return(size: int, steps: int, penalty: float) -> None:
    """Of the fastest run, which takes so many steps, or of a stall at once where that costs less."""
    mdp = Roadrunner.create(size=size, negative_reward=penalty)
    model, best = finite_model(mdp), max(2.0 - steps, penalty)
    assert value_iteration(model).start == value_iteration(model, horizon=steps).start == best
    assert mdp.reward_threshold == best
    assert best == penalty or steps == 1 or value_iteration(model, horizon=steps - 1).start < best
