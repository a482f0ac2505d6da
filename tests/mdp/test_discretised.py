"""Bins for what is observed and what is done."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym import DiscreteActions, Discretised, MDPEnv, QLearning, Tabular, make_mdp, table_size
from edugym.envs.catch import Fall
from edugym.mdp.protocol import named_actions
from tests.mdp.watch import Shows
from tests.training.slips import named


def shows(low: float = -1.0, high: float = 1.0, actions: Any = None) -> Any:
    """A task whose actions are the two numbers that it shows."""
    both = spaces.Box(np.array([-1, 0], np.float32), np.array([1, 10], np.float32))
    return Shows(spaces.Box(low, high, (2,)), None, both if actions is None else actions)


@pytest.mark.parametrize(
    ("value", "expected"),
    [(-7, 0), (-1, 0), (-0.51, 0), (-0.5, 1), (-0.01, 1), (0, 2), (0.49, 2), (0.5, 3), (0.99, 3), (1, 3), (np.inf, 3)],
)
def test_bins(value: float, expected: int) -> None:
    """Four from -1 to 1, of which each begins where the one before ends; what is outside is in the last."""
    task: Any = Discretised.create(shows(), 4)
    assert task.observation((value, 0.0), None).tolist() == [expected, 2]
    named("NaN bin", lambda: task.observation((np.nan, 0.0), None))


def test_bins_and_ends_of_its_own_for_each_number() -> None:
    """In the order of the observation."""
    task: Any = Discretised.create(shows(-np.inf, np.inf), [2, 5], low=[0, 10], high=[1, 20])
    assert task.observation_space == spaces.MultiDiscrete([2, 5])
    assert task.observation((0.6, 13.9), None).tolist() == [1, 1]
    assert Tabular.create(task).observation((0.6, 13.9), np.random.default_rng(0)) == 6


def test_pixels_are_their_own_bins() -> None:
    """A grid of zeros and ones in two bins, and bytes in 256, are what they were; the tables are beyond any memory."""
    grid: Any = Discretised.create(make_mdp("Catch"), 2)
    image: Any = Discretised.create(make_mdp("Catch", observation_type="rgb"), 256)
    state = Fall(1, 2, 3)
    for task in (grid, image):
        assert task.observation(state, None).tolist() == np.ravel(task.mdp.observation(state, None)).tolist()
    assert (table_size(grid), table_size(image)) == ((2**50, 3), (256**150, 3))
    named("Q 27 petabytes", lambda: QLearning.create(grid))
    named("Q 10^362 10^361 3", lambda: QLearning.create(image))
    named("10^361 63 edugym.Hashed", lambda: Tabular.create(image))


ENDLESS = shows(-np.inf, np.inf)
OBSERVATIONS: list[tuple[Any, dict[str, Any], str]] = [
    (shows(), {"bins": 0}, "bins 1"),
    (shows(), {"bins": 2**31 + 1}, "bins 1 2147483648 2147483649"),
    (shows(), {"bins": 2.5}, "bins whole 2.5"),
    (shows(), {"bins": [2, 2, 2]}, "bins one 2 [2, 2, 2]"),
    (shows(), {"bins": 2, "low": [1, 2, 3]}, "low 2 [1, 2, 3]"),
    (shows(), {"bins": 2, "low": [0, 3]}, "high low 1 1.0 3.0"),
    (shows(), {"bins": 2, "high": -1.0}, "high low 0 -1.0 -1.0"),
    (shows(), {"bins": 2, "low": [0, 1]}, "high low 1 1.0 1.0"),
    (shows(), {"bins": 2, "low": np.inf}, "low finite inf"),
    (ENDLESS, {"bins": 3}, "low=..."),
    (shows(), {"bins": 3, "high": [1.0, np.inf]}, "high finite inf"),
    (make_mdp("Boulder"), {"bins": 3}, "mdp Box Discrete"),
    (3, {"bins": 4}, "mdp 3"),
]
BOX = "actions mdp Box bounds"
ACTIONS: list[tuple[Any, dict[str, Any], str]] = [
    (make_mdp("Boulder"), {"bins": 3}, f"{BOX} Discrete(2)"),
    (shows(actions=spaces.Box(0.0, 1.0, (2, 2))), {"bins": 3}, f"{BOX} (2, 2)"),
    (shows(actions=spaces.MultiDiscrete([2, 3])), {"bins": 3}, f"{BOX} MultiDiscrete"),
    (shows(actions=spaces.Box(-np.inf, 1.0, (2,))), {"bins": 3}, f"{BOX} -inf"),
    (shows(), {"bins": 1}, "bins 2 1"),
    (shows(), {"bins": 1_000}, "bins 100000 1000 1,000,000"),
    (shows(), {"bins": [2, 50_001]}, "bins 100000"),
    (shows(), {"bins": [2]}, "bins one 2 [2]"),
    (3, {"bins": 4}, "mdp 3"),
]


@pytest.mark.parametrize(("kind", "rows"), [(Discretised, OBSERVATIONS), (DiscreteActions, ACTIONS)])
def test_what_is_refused(kind: Any, rows: Any) -> None:
    """The parameter is named, its value, and what is allowed."""
    for mdp, arguments, names in rows:
        named(names, lambda: kind.create(mdp, **arguments))  # noqa: B023


def test_actions() -> None:
    """All combinations, the last number fastest; each does what it stands for."""
    task: Any = DiscreteActions.create(shows(-10.0, 10.0), [2, 3])
    assert task.action_space == spaces.Discrete(6)
    assert task.actions.tolist() == [[-1, 0], [-1, 5], [-1, 10], [1, 0], [1, 5], [1, 10]]
    assert list(named_actions(task))[:2] == ["-1, 0", "-1, 5"]
    more: Any = DiscreteActions.create(shows(), [3, 5])
    assert list(named_actions(more))[5:7] == ["0, 0", "0, 2.5"]
    env = MDPEnv(task)
    env.reset(seed=0)
    observation, reward, *_ = env.step(4)
    assert (observation.tolist(), reward) == ([1.0, 5.0], 1.0)
    assert DiscreteActions.create(shows(), [2, 50_000]).action_space.n == 100_000
