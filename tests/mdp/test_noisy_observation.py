"""Noise and brightness: what they change, how often, and what they leave alone."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces
from scipy import stats

from edugym import Brightness, Hashed, MDPEnv, NoisyObservation, make_mdp
from edugym.envs.catch import Fall
from edugym.mdp.noisy_observation import bounds
from tests.mdp.watch import watched

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


class Bounded(NamedTuple):
    """Observes two numbers.

    Attributes:
        low: their lowest values.
        high: their highest values.
    """

    low: Any
    high: Any

    @property
    def observation_space(self) -> spaces.Box:
        """Of these bounds."""
        return spaces.Box(np.array(self.low), np.array(self.high), dtype=np.float64)

    @property
    def action_space(self) -> spaces.Discrete:
        """One action."""
        return spaces.Discrete(1)

    def initial(self, rng: Any) -> int:
        """The only state."""
        return 0

    def transition(self, state: int, action: int, rng: Any) -> int:
        """It stays."""
        return state

    def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
        """None."""
        return 0.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Any) -> Any:
        """The lowest."""
        return np.array(self.low)


@pytest.mark.parametrize(
    ("low", "high"), [([0.0, -1.0], [1.0, 1.0]), ([0.0, 0.0], [1.0, 2.0]), ([0.0, 0.0], [np.inf, np.inf])]
)
def test_bounds_that_differ(low: Any, high: Any) -> None:
    """Or that are none."""
    with pytest.raises(ValueError, match="the numbers that mdp observes must all have the same finite bounds, but are"):
        NoisyObservation.create(Bounded(low, high), 2)
    assert bounds(Bounded([0.0, 0.0], [1.0, 1.0])) == (0.0, 1.0)


def test_normal_noise_in_every_number() -> None:
    """Of the standard deviation asked for, cut off at the ends of the range."""
    task: Any = NoisyObservation.create(GRID, sigma=0.2)
    rng = np.random.default_rng(1)
    shown = np.array([task.observation(STATE, rng) for _ in range(2_000)])
    assert shown.min() == 0.0
    assert shown.max() == 1.0
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


def test_they_stay_in_their_observation_space() -> None:
    """As Gymnasium environments, whole numbers stay whole."""
    noisy: Any = NoisyObservation.create(IMAGE, 7, 30.0)
    dark: Any = Brightness.create(IMAGE)
    for task in (noisy, dark):
        env = MDPEnv(task)
        observation, _ = env.reset(seed=0)
        for _ in range(9):
            assert env.observation_space.contains(observation)
            observation, *_ = env.step(1)


def test_machine_code_does_the_same() -> None:
    """One over the other, hashed."""
    tasks = [
        Hashed.create(Brightness.create(NoisyObservation.create(IMAGE, 4, 20.0), 0.5), 500, overflow=True)
        for _ in range(2)
    ]
    assert np.array_equal(watched(tasks[0], machine_code=True), watched(tasks[1]))
    assert tasks[0].used == 500


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: NoisyObservation.create(make_mdp("Boulder"), 2), r"mdp must observe an array \(a Box\)"),
        (lambda: NoisyObservation.create(GRID, -1), "levels must be"),
        (lambda: NoisyObservation.create(GRID, sigma=-0.1), "sigma must be 0 or more, but is -0.1"),
        (lambda: NoisyObservation.create(GRID, sigma=np.inf), "sigma must be a finite number"),
        (lambda: NoisyObservation.create(3, 4), r"mdp must be an MDP, .* but is 3"),
        (lambda: Brightness.create(GRID, -0.1), "low must be from 0 to 1, but is -0.1"),
        (lambda: Brightness.create(GRID, 0.5, 0.4), "high must be from 0.5 to 1, but is 0.4"),
        (lambda: Brightness.create(make_mdp("Trashbot")), "the numbers that mdp observes must begin at 0"),
    ],
)
def test_arguments(make: Any, message: str) -> None:
    """Each is checked, and named."""
    with pytest.raises(ValueError, match=message):
        make()
