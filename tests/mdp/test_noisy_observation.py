"""Noise and brightness: what they change, how often, and what they leave alone."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces
from scipy import stats

from edugym import Brightness, MDPEnv, NoisyObservation, make_mdp
from edugym.envs.catch import Fall
from tests.mdp.watch import Shows
from tests.training.slips import named

GRID, IMAGE = make_mdp("Catch"), make_mdp("Catch", observation_type="rgb")
STATE = Fall(2, 3, 4)


def test_one_noisy_number_of_some_levels() -> None:
    """The first takes each level as often, spread over its range; all others are what they were."""
    rng = np.random.default_rng(0)
    for mdp, levels, values in ((GRID, 3, [0, 0.5, 1]), (IMAGE, 256, range(256)), (IMAGE, 2, [0, 255])):
        task: Any = NoisyObservation.create(mdp, levels=levels)
        seen = []
        for _ in range(20 * levels):
            shown = task.observation(STATE, rng)
            seen.append(shown.flat[0])
            assert np.array_equal(shown.flat[1:], mdp.observation(STATE, rng).flat[1:])
        counts = [seen.count(value) for value in values]
        assert sum(counts) == len(seen)
        assert stats.chisquare(counts).pvalue > 1e-4


@pytest.mark.parametrize("levels", [0, 1])
def test_without_noise_nothing_is_drawn(levels: int) -> None:
    """What is shown is what the task shows."""
    task: Any = NoisyObservation.create(GRID, levels, 0.0)
    rng = np.random.default_rng(0)
    assert np.array_equal(task.observation(STATE, rng), GRID.observation(STATE, rng))
    assert rng.bit_generator.state == np.random.default_rng(0).bit_generator.state


def test_normal_noise_in_every_number() -> None:
    """Of the standard deviation asked for, cut off at the ends of the range."""
    task: Any = NoisyObservation.create(GRID, sigma=0.2)
    rng = np.random.default_rng(1)
    shown = np.array([task.observation(STATE, rng) for _ in range(2_000)])
    assert (shown.min(), shown.max()) == (0.0, 1.0)
    dark = shown[:, 0, 0]
    assert np.mean(dark == 0.0) == pytest.approx(0.5, abs=0.05)
    assert np.sqrt(np.mean(dark[dark > 0] ** 2)) == pytest.approx(0.2, abs=0.02)
    assert abs(np.corrcoef(shown[:, 0, 0], shown[:, 0, 1])[0, 1]) < 0.1


def test_brightness_is_one_factor_for_the_whole_image() -> None:
    """Uniform from low to high, and a new one at every step."""
    task: Any = Brightness.create(GRID, 0.4, 0.9)
    rng = np.random.default_rng(2)
    factors = []
    for _ in range(500):
        shown = task.observation(STATE, rng)
        factors.append(shown.max())
        assert np.array_equal(shown, GRID.observation(STATE, rng) * np.float64(factors[-1]))
    assert stats.kstest(factors, "uniform", (0.4, 0.5)).pvalue > 1e-3
    assert np.array_equal(Brightness.create(IMAGE, 1, 1).observation(STATE, rng), IMAGE.observation(STATE, rng))


@pytest.mark.parametrize("task", [NoisyObservation.create(IMAGE, 7, 30.0), Brightness.create(IMAGE)])
def test_they_stay_in_their_observation_space(task: Any) -> None:
    """As Gymnasium environments, whole numbers stay whole."""
    env = MDPEnv(task)
    observation, _ = env.reset(seed=0)
    for _ in range(9):
        assert env.observation_space.contains(observation)
        observation, *_ = env.step(1)


def bounded(low: list[float], high: list[float]) -> Any:
    """A task that observes two numbers of these bounds."""
    return Shows(spaces.Box(np.array(low), np.array(high), dtype=np.float64), np.array(low))


NOISY: list[tuple[Any, Any, str]] = [
    (make_mdp("Boulder"), {"levels": 2}, "mdp Box Discrete"),
    (3, {"levels": 4}, "mdp 3"),
    (GRID, {"levels": -1}, "levels 0 -1"),
    (GRID, {"sigma": -0.1}, "sigma 0 -0.1"),
    (GRID, {"sigma": np.inf}, "sigma finite inf"),
    (bounded([0.0, -1.0], [1.0, 1.0]), {}, "mdp bounds Box("),
    (bounded([0.0, 0.0], [1.0, 2.0]), {}, "mdp bounds Box("),
    (bounded([0.0, 0.0], [np.inf, np.inf]), {}, "mdp bounds Box("),
]
DARK: list[tuple[Any, Any, str]] = [
    (3, {}, "mdp 3"),
    (GRID, {"low": -0.1}, "low 0 1 -0.1"),
    (GRID, {"low": 0.5, "high": 0.4}, "high 0.5 1 0.4"),
    (GRID, {"high": 1.1}, "high 0.4 1 1.1"),
    (make_mdp("Trashbot"), {}, "mdp 0 Box"),
    (bounded([0.0, 0.0], [1.0, 2.0]), {}, "mdp bounds Box("),
]


@pytest.mark.parametrize(("kind", "rows"), [(NoisyObservation, NOISY), (Brightness, DARK)])
def test_what_is_refused(kind: Any, rows: Any) -> None:
    """The parameter is named, its value, and what is allowed."""
    for mdp, arguments, names in rows:
        named(names, lambda: kind.create(mdp, **arguments))  # noqa: B023
