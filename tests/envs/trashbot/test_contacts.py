"""Trashbot: what touches what, in exact cases, and that nothing passes through anything."""

import itertools
import math
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from edugym.envs.trashbot.geometry import BASE, BOX, MAGNET, SHOULDER_Y, WALL, Block, Robot, arm
from edugym.envs.trashbot.task import COLLIDED, MOVING, STRIDE, Trashbot
from tests.envs.trashbot.moves import DEFAULT, RNG, robot, step, towards

GROUND = Block(-2.0, -1.0, 2.0, 0.0)


def inside(line: tuple[int, ...], block: Block) -> bool:
    """Whether a line and a block meet, by clipping the one at the sides of the other, in exact fractions."""
    x0, y0, x1, y1 = line
    first, last = Fraction(0), Fraction(1)
    for start, way, low, high in ((x0, x1 - x0, block.left, block.right), (y0, y1 - y0, block.bottom, block.top)):
        if way == 0:
            if not low <= start <= high:
                return False
            continue
        ends = sorted((Fraction(int(low) - start, way), Fraction(int(high) - start, way)))
        first, last = max(first, ends[0]), min(last, ends[1])
    return first <= last


WHOLE = st.integers(-12, 12)


@given(st.tuples(WHOLE, WHOLE, WHOLE, WHOLE), WHOLE, WHOLE, st.integers(0, 8), st.integers(0, 8))
def test_lines_against_blocks(line: tuple[int, ...], left: int, bottom: int, width: int, height: int) -> None:
    """Exact, touches of sides and corners included: whole numbers leave no room for rounding."""
    block = Block(left, bottom, left + width, bottom + height)
    assert block.meets_line(*line) == inside(line, block)


@pytest.mark.parametrize(
    ("x", "picked_up"),
    [(-1.45, True), (BOX.left - 0.01, False), (BOX.left + 0.01, True), (BOX.right - 0.01, True)],
)
def test_picked_up_from_above(x: float, picked_up: bool) -> None:
    """The box comes to the magnet, which stays where it was, and the way up is free; beside it the magnet passes by."""
    state = robot(x, BOX.top + MAGNET + 0.05, 1.0)
    after, reward = step(state, towards(state, x, BOX.top + MAGNET - 0.05, 1.0))
    assert (after.holding, reward, after.outcome, after.steps) == (picked_up, float(picked_up), MOVING, 1)
    if picked_up:
        assert after[:2] == state[:2]
        up, reward = step(after, towards(after, x, BOX.top + MAGNET + 0.15, 1.0))
        assert (up.holding, up.outcome, reward) == (True, MOVING, 0.0)


BESIDE = robot(BOX.right + 0.06, BOX.top + MAGNET + 0.02, 1.0)
BELOW, FLAT = Robot(3.1425, -0.2809, False, 0, MOVING), Robot(math.pi + 0.15, -0.3, False, 0, MOVING)
WIDE = DEFAULT._replace(action_scale=1.0)


@pytest.mark.parametrize(
    ("state", "action", "task", "by_magnet"),
    [
        (BESIDE, towards(BESIDE, BOX.right - 0.06, BOX.top + MAGNET - 0.1, 1.0), DEFAULT, True),  # down at its side
        (BELOW, (0.3746, -0.9696), WIDE, True),  # a swing that starts as low as the box stands, and ends from above
        (FLAT, (1.0, 0.0), DEFAULT, False),  # the forearm comes down on it
    ],
)
def test_the_box_is_hit(state: Robot, action: Any, task: Trashbot, by_magnet: bool) -> None:
    """Whatever touches the box but the magnet from above is a collision."""
    assert not task.collides(arm(*state[:2]), False)
    after, reward = step(state, action, task)
    assert (after.holding, after.outcome, reward) == (False, COLLIDED, -2.0)
    last = arm(*after[:2])
    assert (last.magnet_meets(BOX), last.links_meet(BOX)) == (by_magnet, not by_magnet)


@given(st.floats(-1.75, -1.25), st.floats(0.3, 1.2), st.floats(-1, 1), st.floats(-1, 1), st.sampled_from([-1.0, 1.0]))
def test_held_box_is_free(x: float, y: float, first: float, second: float, bend: float) -> None:
    """Wherever the box is picked up, it and the arm touch nothing else then."""
    assume(math.hypot(x, y - SHOULDER_Y) < 1.79)
    state = robot(x, y, bend)
    now = arm(*state[:2])
    assume(not (DEFAULT.collides(now, False) or now.links_meet(BOX) or now.magnet_meets(BOX)))
    task = DEFAULT._replace(action_scale=0.3)
    after = task.transition(state, (first, second), RNG)
    if after.holding:
        assert not task.collides(arm(*after[:2]), True)
        assert arm(*after[:2]).tip_y > BOX.top


@pytest.mark.parametrize(
    ("wrist", "to", "bend", "holding", "collides"),
    [
        ((-0.9, 0.8), (-0.9, 0.85), 1, False, False),  # nothing there
        ((-1.15, 0.4), (-1.25, 0.4), 1, False, False),  # the magnet moves towards the box, not yet there
        ((0.8, 0.25), (0.8, 0.15), -1, False, True),  # the magnet on the ground
        ((0.8, 0.5), (0.8, 0.4), -1, True, True),  # the box on the ground
        ((-1.25, 0.6), (-1.33, 0.6), 1, True, True),  # the held box at the stand
        ((0.36, 0.6), (0.3, 0.6), -1, True, True),  # the box at the base
        ((1.25, 0.8), (1.36, 0.8), -1, False, True),  # the magnet at the left wall, from the left
        ((1.42, 0.8), (1.36, 0.8), -1, False, True),  # from within
        ((1.25, 0.8), (1.45, 0.8), -1, False, True),  # and through it
        ((1.15, 1.0), (1.22, 1.0), -1, True, True),  # the box at the left wall
        ((1.5, 1.2), (1.5, 1.1), -1, True, True),  # the box on the edge of the left wall
        ((1.66, 1.05), (1.71, 1.0), -1, True, True),  # the box at the right wall, from within
    ],
)
def test_collisions(
    wrist: tuple[float, float], to: tuple[float, float], bend: float, holding: bool, collides: bool
) -> None:
    """What ends the episode with -2 where it is touched."""
    state = robot(*wrist, bend, holding)
    assert not DEFAULT.collides(arm(*state[:2]), holding)
    after, reward = step(state, towards(state, *to, bend, WIDE), WIDE)
    assert (after.outcome, reward, after.holding) == ((COLLIDED, -2.0, holding) if collides else (MOVING, 0.0, holding))
    assert DEFAULT.terminal(after) == collides == DEFAULT.collides(arm(*after[:2]), holding)


def test_links_collide() -> None:
    """The elbow on the ground, the upper arm on the base, the forearm at a wall, the magnet nowhere."""
    for shoulder, elbow, block in (
        (math.pi + 0.55, -1.2, GROUND), (-0.5, 2.2, BASE), (0.12, 0.0, DEFAULT.obstacles[2]),
    ):  # fmt: skip
        now = arm(shoulder, elbow)
        assert (DEFAULT.collides(now, False), now.links_meet(block), now.magnet_meets(block)) == (True, True, False)


ANGLES, TURNS = st.floats(-math.pi, math.pi), st.floats(-0.3, 0.3)


@given(ANGLES, ANGLES, TURNS, TURNS)
def test_parts_of_a_move_are_short(shoulder: float, elbow: float, shoulder_turn: float, elbow_turn: float) -> None:
    """From one look to the next neither elbow nor wrist moves farther than a stride; magnet and box move with it."""
    n = DEFAULT.parts(shoulder_turn, elbow_turn)
    looks = [arm(shoulder + shoulder_turn * k / n, elbow + elbow_turn * k / n) for k in range(n + 1)]
    assert STRIDE < WALL
    for one, other in itertools.pairwise(looks):
        assert math.dist(one[:2], other[:2]) <= STRIDE
        assert math.dist(one[2:], other[2:]) <= STRIDE
