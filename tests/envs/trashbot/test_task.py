"""Trashbot: episodes that a person can follow in degrees, the rewards, the clock, and the pictures."""

import math
from math import ceil, inf, nan
from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym.adapters.playing.game import Game
from edugym.adapters.registration import find
from edugym.envs.trashbot.geometry import BOX, BOX_SIZE, CONTAINER_X, MAGNET, RIM_Y, Robot, arm
from edugym.envs.trashbot.planning import ScriptedController, best_plan
from edugym.envs.trashbot.task import COLLIDED, DELIVERED, LATE, MOVING, START, TrashbotInBins
from tests.contract.described import NO_STEPS, Keywords, Parameters, refused
from tests.envs.trashbot.moves import DEFAULT, RNG, SCALE, robot, step, towards

TrashbotEnv: Any = find("Trashbot").load()


@st.composite
def arms(draw: st.DrawFn) -> Keywords:
    """Arms that have time to deliver the box."""
    action_scale = draw(st.floats(0.05, 0.3))
    enough = ceil(2.5 / action_scale)
    return {
        "n_bins": draw(st.none() | st.integers(2, 12)),
        "container_width": draw(st.floats(0.25, 1.0, exclude_min=True)),
        "action_scale": action_scale,
        "max_steps": draw(st.integers(enough, enough + 60)),
    }


def carry_the_box(_: dict[str, Any], env: Any) -> Any:
    """What the scripted controller does, as nearly as the bins allow."""
    task = env.mdp
    action = ScriptedController(task.action_scale).act(task.observation(env.state, env.np_random), env.np_random)
    return np.rint((action.astype(np.float64) + 1) / 2 * (task.n_bins - 1)).astype(int) if task.n_bins else action


PARAMETERS = Parameters(
    valid=arms(),
    corners=(
        {},
        {"n_bins": 2, "container_width": 0.2500001},
        {"n_bins": 5},
        {"n_bins": 11, "container_width": 1, "action_scale": 0.3, "max_steps": 9},
        {"n_bins": 2**31, "action_scale": 0.001, "max_steps": 2500},
        {"container_width": 0.3, "action_scale": 0.3, "max_steps": 9},
    ),
    bad=(
        *refused("n_bins", 1, 0, -3, 2**31 + 1, 2.5, "3", True, nan),
        *refused("container_width", 0.25, 0, -1, 1.001, inf, nan, "0.5", None, True),
        *refused("action_scale", 0, -0.1, 5e-324, 0.0009, 0.301, inf, nan, "0.2", None, True),
        *refused("max_steps", 11, None, *NO_STEPS),
        *refused("max_steps", 150, action_scale=0.01),
    ),
    random=False,
    informed=carry_the_box,
)


def test_best_with_three_bins() -> None:
    """By 12 degrees a step: down to the box, one step for it to be picked up, and over."""
    env = TrashbotEnv(3)
    env.reset()
    assert np.degrees(START) == pytest.approx([136, 66])
    _, rewards, terminations, _, infos = zip(*(env.step(action) for action in best_plan(env.mdp).actions), strict=True)
    angles = [np.degrees(info["angles"]) for info in infos]
    assert np.array(angles) == pytest.approx(np.array([(136, 54)] + [(136 - 12 * k, 54 - 12 * k) for k in range(9)]))
    assert rewards == pytest.approx([0, 1, *[0] * 7, 3.311], abs=5e-4)
    assert terminations == (*[False] * 9, True)
    assert [info["outcome"] for info in infos] == [*["moving"] * 9, "delivered"]
    assert (infos[-1]["steps"], infos[-1]["centring"]) == (10, pytest.approx(1.311, abs=5e-4))


@pytest.mark.parametrize(
    ("n_bins", "values"), [(2, [-1, 1]), (3, [-1, 0, 1]), (4, [-1, -1 / 3, 1 / 3, 1]), (5, [-1, -0.5, 0, 0.5, 1])]
)
def test_bins(n_bins: int, values: list[float]) -> None:
    """Evenly spread, ends included; an even number has no zero."""
    task = TrashbotEnv(n_bins).mdp
    assert isinstance(task, TrashbotInBins)
    for k, value in enumerate(values):
        assert task.turns((k, 0)) == pytest.approx((SCALE * value, -SCALE))
        assert task.turns((n_bins - 1, k)) == pytest.approx((SCALE, SCALE * value))
    assert (0.0 in values) == (n_bins % 2 == 1)


def test_moves() -> None:
    """Both joints turn by the action times the scale, counterclockwise."""
    state = Robot(2.0, 0.5, False, 3, MOVING)
    after, reward = step(state, (0.5, -1.0))
    assert after == Robot(2.0 + 0.5 * SCALE, 0.5 - SCALE, False, 4, MOVING)
    assert reward == 0.0
    assert step(state, (0.0, 0.0))[0] == state._replace(steps=4)


def test_positions() -> None:
    """Stretched to the right; up, then level to the left; and what is observed, in units of the reach."""
    assert arm(0.0, 0.0) == pytest.approx((1.0, 0.5, 1.8, 0.5))
    assert arm(math.pi / 2, math.pi / 2) == pytest.approx((0.0, 1.5, -0.8, 1.5))
    assert arm(0.0, 0.0).tip_y == pytest.approx(0.3)
    assert arm(0.0, 0.0).load == pytest.approx((1.675, 0.05, 1.925, 0.3))
    stretched, hanging = Robot(0.0, 0.0, True, 0, MOVING), Robot(-math.pi / 2, 0.0, False, 0, MOVING)
    assert DEFAULT.observation(stretched, RNG) == pytest.approx((0.5, 0, 0.9, 0, 0.9, -0.1, 1))
    assert DEFAULT.observation(hanging, RNG) == pytest.approx((0, -0.5, 0, -0.9, 0, -1, 0))


OVER, RIM = RIM_Y + BOX_SIZE + MAGNET + 0.02, RIM_Y + BOX_SIZE + MAGNET


@pytest.mark.parametrize(
    ("width", "offset", "depth", "bonus"),
    [
        (0.45, 0.0, 0.02, 2.0),
        (0.45, 0.0, 0.001, 2.0),
        (0.45, 0.0, -0.001, None),  # not below the rim
        (0.45, 0.05, 0.02, 1.0),
        (0.45, -0.05, 0.02, 1.0),
        (0.45, -0.0999, 0.02, 0.002),
        (0.35, 0.025, 0.02, 1.0),
        (0.35, -0.047, 0.02, 0.12),
    ],
)
def test_delivery(width: float, offset: float, depth: float, bonus: float | None) -> None:
    """2 and at most 2 for the middle, falling linearly to 0 where the box only just fits: for 0.45, 0.1 off."""
    x, task = CONTAINER_X + offset, DEFAULT._replace(container_width=width)
    state = robot(x, OVER, holding=True)
    after, reward = step(state, towards(state, x, RIM - depth), task)
    assert (after.outcome, after.holding) == ((MOVING, True) if bonus is None else (DELIVERED, False))
    assert reward == pytest.approx(0 if bonus is None else 2 + bonus)


def test_late() -> None:
    """The last step costs 1 and terminates; the clock is in the state, and not seen."""
    env = TrashbotEnv(5, max_steps=12)
    first, _ = env.reset()
    steps = [env.step(np.array([2, 2])) for _ in range(12)]
    for k, (observation, *rest, info) in enumerate(steps[:-1], 1):
        assert (*rest, info["steps"], info["outcome"]) == (0.0, False, False, k, "moving")
        assert observation.tolist() == first.tolist()
    *_, reward, terminated, truncated, info = steps[-1]
    assert (reward, terminated, truncated, info["outcome"]) == (-1.0, True, False, "late")


@pytest.mark.parametrize(
    ("state", "to", "bend", "outcome", "reward"),
    [
        (robot(-1.45, BOX.top + MAGNET + 0.05, 1.0, steps=6), (-1.45, BOX.top + MAGNET - 0.05), 1.0, LATE, 0.0),
        (robot(CONTAINER_X, OVER, holding=True, steps=6), (CONTAINER_X, RIM - 0.02), -1.0, DELIVERED, 4.0),
        (robot(0.8, 0.25, steps=6), (0.8, 0.15), -1.0, COLLIDED, -2.0),
    ],
)
def test_last_step(state: Robot, to: tuple[float, float], bend: float, outcome: int, reward: float) -> None:
    """What else happens in it counts: +1 for the box, all of a delivery, and a collision as ever."""
    after, paid = step(state, towards(state, *to, bend), DEFAULT._replace(time_limit=7))
    assert after.outcome == outcome
    assert paid == pytest.approx(reward)


TURNS = {"upper arm left": (1, 0), "upper arm right": (-1, 0), "forearm left": (0, 1), "forearm right": (0, -1)}
BOTH = {"both": (1, 1), "forearm against upper arm": (-1, 1)}


@pytest.mark.parametrize("n_bins", [None, 2, 3, 4, 5, 6, 11])
def test_played_by_a_person(n_bins: int | None) -> None:
    """The buttons turn one joint each; as far as it goes, and a little; where none can rest, both a little."""
    env = TrashbotEnv(n_bins)
    game, last = Game(env), (n_bins or 5) - 1
    little = 1 / last if last % 2 else (2 / last if n_bins else 0.25)
    small = {
        f"{name} {side}, a little": (sign * little * turn[0], sign * little * turn[1])
        for name, turn in (BOTH.items() if last % 2 else {"upper arm": (1, 0), "forearm": (0, 1)}.items())
        for side, sign in (("left", 1), ("right", -1))
    }
    rest = -1 / last if last % 2 else 0.0
    large = {name: (turn[0] or rest, turn[1] or rest) for name, turn in TURNS.items()}
    if n_bins in (2, 3):
        large, small = {name.removesuffix(", a little"): turn for name, turn in small.items()}, {}
    assert {name: env.mdp.turns(action) for name, action in game.actions.items()} == {
        name: pytest.approx((SCALE * turn[0], SCALE * turn[1])) for name, turn in (large | small).items()
    }
    for name in game.actions:
        game.reset()
        game.step(name)
