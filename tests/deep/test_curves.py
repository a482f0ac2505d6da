"""Learning curves of deep agents: how long an evaluation episode may take."""

from typing import Any

import numpy as np
import pytest

pytest.importorskip("torch")

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.deep.curves import Curve
from tests.training.tasks import Ring


@pytest.mark.parametrize(
    ("environment", "steps"),
    [(MDPEnv(Ring(1_200)), 1_200), (MDPEnv(Ring(7)), 7), (MDPEnv(Ring(None)), 1_000)],
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
