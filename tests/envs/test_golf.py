"""Golf: an episode on paper, the edges of green and course, and the noise of every swing."""

import math
from math import inf, nan
from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym.adapters.registration import find
from edugym.envs.golf import Ball, Golf
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.contract.described import NO_WHOLE_NUMBER, Keywords, Parameters, refused

GolfEnv: Any = find("Golf").load()


@st.composite
def courses(draw: st.DrawFn) -> Keywords:
    """Golf courses: the green does not reach the tee."""
    width = draw(st.sampled_from([3, 5, 7, 9]))
    length = draw(st.integers(width, 20))
    return {
        "width": width,
        "length": length,
        "green_radius": draw(st.floats(0.1, length - width / 2, exclude_max=True)),
        "max_hits": draw(st.integers(1, 12)),
        "stochasticity_level": draw(st.floats(0.001, 0.1)),
        "observe_hits": draw(st.booleans()),
    }


PARAMETERS = Parameters(
    valid=courses(),
    corners=(
        {},
        {"observe_hits": True},
        {"width": 3, "length": 3, "green_radius": 0.5, "max_hits": 1},
        {"width": 21, "length": 60, "max_hits": 100, "observe_hits": True},
        {"stochasticity_level": 0},
        {"stochasticity_level": 0.0, "max_hits": 3, "observe_hits": True},
        {"stochasticity_level": 1000.0, "observe_hits": True},
    ),
    bad=(
        *refused("width", 1, 4, -7, 1003, *NO_WHOLE_NUMBER),
        *refused("length", 6, 0, 1002, 10**6, *NO_WHOLE_NUMBER),
        *refused("green_radius", 0, -1.0, 13.5, 100, nan, inf, "2", None, True),
        *refused("green_radius", 0.5, stochasticity_level=0),  # whole cells lie half a cell from the flag or more
        *refused("max_hits", 0, 10**6 + 1, *NO_WHOLE_NUMBER),
        *refused("max_hits", 1, stochasticity_level=0),
        *refused("max_hits", 2, width=5, length=9, green_radius=0.9, stochasticity_level=0),  # not from the water
        *refused("stochasticity_level", -0.1, 1001, 1e308, nan, inf, "a", None, True),
        *refused("observe_hits", 1, "yes", None),
    ),
    finite=({"stochasticity_level": 0}, {"stochasticity_level": 0, "observe_hits": True, "max_hits": 4}),
)


RNG = np.random.default_rng(0)  # for what draws nothing


def golf(**parameters: Any) -> Golf:
    """The task."""
    return Golf.create(**parameters)


def test_an_episode_without_noise() -> None:
    """A drive, a putt and a putt along the middle: ten cells, one and one, and the ball is 1.5 from the flag."""
    env = GolfEnv(stochasticity_level=0)
    observation, info = env.reset(seed=0)
    assert (observation.tolist(), info["ball"].tolist(), info["hits"]) == ([3, 0], [3.5, 0.0], 0)
    for action, y, reward, terminated in ((2, 10, 0.0, False), (0, 11, 0.0, False), (0, 12, 1 - 2 / 10, True)):
        observation, *seen, info = env.step(action)
        assert (observation.tolist(), *seen) == ([3, y], reward, terminated, False)
        assert info["ball"].tolist() == [3.5, y]


def test_an_episode_with_noise() -> None:
    """What a seed gives, on every machine: the ball strays more the harder it is hit."""
    env = GolfEnv(observe_hits=True)
    env.reset(seed=1)
    trace = []
    for action in (0, 2, 0, 1):
        observation, reward, terminated, _, info = env.step(action)
        trace.append((observation.tolist(), reward, terminated, *np.round(info["ball"], 3).tolist()))
    assert trace == [
        ([3, 1, 1], 0.0, False, 3.505, 1.012),
        ([3, 9, 2], 0.0, False, 3.997, 9.058),
        ([3, 10, 3], 0.0, False, 3.899, 10.058),
        ([3, 14, 4], 0.7, True, 3.309, 14.171),
    ]


BELOW_7, BELOW_17 = math.nextafter(7.0, 0.0), math.nextafter(17.0, 0.0)


@pytest.mark.parametrize(
    ("x", "y", "cell", "off_course"),
    [
        (0.0, 0.0, (0, 0), False),
        (-1e-12, 5.0, (0, 5), True),
        (3.5, -1e-12, (3, 0), True),
        (7.0, 5.0, (6, 5), True),
        (BELOW_7, 5.0, (6, 5), False),
        (3.5, 17.0, (3, 16), True),
        (3.5, BELOW_17, (3, 16), False),
        (-3.0, 99.0, (0, 16), True),
        (1e300, -1e300, (6, 0), True),
    ],
)
def test_edges_of_the_course(x: float, y: float, cell: tuple[int, int], off_course: bool) -> None:
    """The near and the left edge belong to it, the far and the right do not; off it the nearest cell is observed."""
    task, ball = golf(), Ball(x, y, 4)
    assert task.off_course(ball) == off_course == task.terminal(ball)
    assert task.reward(Ball(3.5, 0.0, 3), 0, ball, RNG) == (-1.0 if off_course else 0.0)
    assert task.observation(ball, RNG) == cell
    assert golf(observe_hits=True).observation(ball, RNG) == (*cell, 4)


def test_edge_of_the_green() -> None:
    """The green is what is closer to the flag than its radius, all around."""
    for radius in (2.0, 2.1):
        task = golf()._replace(green_radius=radius)
        for distance in (0.0, radius - 1e-9, radius + 1e-9):
            for dx, dy in ((distance, 0), (-distance, 0), (0, distance), (0, -distance)):
                ball = Ball(3.5 + dx, 13.5 + dy, 1)
                assert task.on_green(ball) == (distance < radius) == task.terminal(ball)
    assert not golf()._replace(green_radius=2.0).on_green(Ball(3.5, 15.5, 1))


@pytest.mark.parametrize("hits", range(1, 11))
def test_rewards(hits: int) -> None:
    """On the green 1, 0.9, ..., 0.1 by the hits; elsewhere -1 after the last one; off the course always -1."""
    task, anywhere = golf(), Ball(3.5, 5.0, hits - 1)
    assert task.reward(anywhere, 0, Ball(3.5, 13.0, hits), RNG) == pytest.approx(1 - (hits - 1) / 10)
    assert task.reward(anywhere, 0, Ball(3.5, 6.0, hits), RNG) == (-1.0 if hits == 10 else 0.0)
    assert task.reward(anywhere, 0, Ball(-1.0, 6.0, hits), RNG) == -1.0
    assert task.terminal(Ball(3.5, 6.0, hits)) == (hits == 10)


def test_green_beyond_the_edge() -> None:
    """A ball that is off the course is lost, also where it is close to the flag."""
    task, lost = golf(width=3, length=9, green_radius=4.0), Ball(-0.5, 7.5, 1)
    assert task.on_green(lost)
    assert task.terminal(lost)
    assert task.reward(Ball(1.5, 0.0, 0), 0, lost, RNG) == -1.0


def test_best_return_without_noise() -> None:
    """Without noise a drive and a chip end on the green, half a cell behind the flag: 0.9, and nothing is better."""
    task = golf(stochasticity_level=0)
    assert value_iteration(finite_model(task)).start == pytest.approx(0.9)
    assert task.transition(task.transition(task.initial(RNG), 2, RNG), 1, RNG) == Ball(3.5, 14.0, 2)


@pytest.mark.slow
def test_best_return() -> None:
    """At the defaults a drive, and then whatever is likeliest to reach the green, returns about 0.87."""
    task, rng, n = golf(), np.random.default_rng(0), 40_000
    returns = np.zeros(n)
    for k in range(n):
        ball = task.initial(rng)
        while not task.terminal(ball):
            distance = math.hypot(ball.x - 3.5, ball.y - 13.5)
            action = 2 if distance > 8 else (1 if distance > 2.9 else 0)
            after = task.transition(ball, action, rng)
            returns[k] += task.reward(ball, action, after, rng)
            ball = after
    assert abs(returns.mean() - 0.868) < 5 * returns.std() / math.sqrt(n)  # about 0.007
