"""Learning curves of deep agents: how long an evaluation episode may take."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

pytest.importorskip("torch")

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.deep.curves import Curve
from edugym.mdp.protocol import Random


class Endless(NamedTuple):
    """One state, and a reward of 1 for every step."""

    max_steps: int | None

    def initial(self, rng: Random) -> int:
        """The one state."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """Back to it."""
        return 0

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """Always 1."""
        return 1.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """One."""
        return spaces.Discrete(1)

    @property
    def action_space(self) -> spaces.Discrete:
        """Two, of no effect."""
        return spaces.Discrete(2)


@pytest.mark.parametrize(
    ("environment", "steps"),
    [(MDPEnv(Endless(1_200)), 1_200), (MDPEnv(Endless(7)), 7), (MDPEnv(Endless(None)), 1_000)],
)
def test_an_episode_lasts_as_long_as_the_task(environment: Any, steps: int) -> None:
    """And 1000 steps where it has no limit, as in `edugym.train`."""
    curve = Curve(environment, {}, lambda: lambda observations, first: np.zeros(2, np.int64), 10, 2, 0)
    curve.measure(0)
    assert curve.run(None, 0, 0).returns.tolist() == [steps]


def test_the_limit_of_a_gymnasium_id() -> None:
    """Its own: Acrobot, whose reward is -1 at every step, ends after 500 steps, or 1100 where it is made so."""
    for parameters, steps in (({}, 500), ({"max_episode_steps": 1_100}, 1_100)):
        curve = Curve("Acrobot-v1", parameters, lambda: lambda observations, first: np.ones(1, np.int64), 10, 1, 0)
        curve.measure(0)
        assert curve.run(None, 0, 0).returns.tolist() == [-steps]
