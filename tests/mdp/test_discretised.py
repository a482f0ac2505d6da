"""Bins for what is observed and what is done."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import (
    DiscreteActions,
    Discretised,
    Hashed,
    MDPEnv,
    QLearning,
    Tabular,
    make_mdp,
    table_size,
    train,
)
from edugym.envs.catch import Fall
from edugym.mdp.protocol import named_actions
from tests.mdp.watch import watched


class Shows(NamedTuple):
    """Shows the numbers that are its state; actions set them."""

    low: float = -1.0
    high: float = 1.0

    def initial(self, rng: Any) -> tuple[float, float]:
        """Zeros."""
        return 0.0, 0.0

    def transition(self, state: Any, action: Any, rng: Any) -> Any:
        """The action."""
        return action[0], action[1]

    def reward(self, state: Any, action: Any, next_state: Any, rng: Any) -> float:
        """The first part of the action."""
        return float(action[0])

    def terminal(self, state: Any) -> bool:
        """Never."""
        return False

    def observation(self, state: Any, rng: Any) -> Any:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Box:
        """Two numbers."""
        return spaces.Box(self.low, self.high, (2,), np.float32)

    @property
    def action_space(self) -> spaces.Box:
        """Two numbers."""
        return spaces.Box(np.array([-1, 0], np.float32), np.array([1, 10], np.float32))


@pytest.mark.parametrize(
    ("value", "expected"),
    [(-7, 0), (-1, 0), (-0.51, 0), (-0.5, 1), (-0.01, 1), (0, 2), (0.49, 2), (0.5, 3), (0.99, 3), (1, 3), (np.inf, 3)],
)
def test_bins(value: float, expected: int) -> None:
    """Four from -1 to 1, of which each begins where the one before ends; what is outside is in the last."""
    task: Any = Discretised.create(Shows(), 4)
    assert task.observation((value, 0.0), None).tolist() == [expected, 2]


def test_bins_and_ends_of_its_own_for_each_number() -> None:
    """In the order of the observation."""
    task: Any = Discretised.create(Shows(-np.inf, np.inf), [2, 5], low=[0, 10], high=[1, 20])
    assert task.observation_space == spaces.MultiDiscrete([2, 5])
    assert task.observation((0.6, 13.9), None).tolist() == [1, 1]
    assert Tabular.create(task).observation((0.6, 13.9), np.random.default_rng(0)) == 6


@given(st.floats(-3, 3), st.integers(1, 50))
@settings(max_examples=50, deadline=None)
def test_a_bin_holds_what_is_in_it(value: float, bins: int) -> None:
    """The middle of a number's bin is at most half a bin away."""
    task: Any = Discretised.create(Shows(), bins)
    cell = int(task.observation((value, 0.0), None)[0])
    middle = -1 + (cell + 0.5) * 2 / bins
    assert abs(min(max(value, -1), 1) - middle) <= 1 / bins + 1e-9


def test_pixels_are_their_own_bins() -> None:
    """A grid of zeros and ones in two bins, and bytes in 256, are what they were; the tables are beyond any memory."""
    grid: Any = Discretised.create(make_mdp("Catch"), 2)
    image: Any = Discretised.create(make_mdp("Catch", observation_type="rgb"), 256)
    state = Fall(1, 2, 3)
    for task in (grid, image):
        assert task.observation(state, None).tolist() == np.ravel(task.mdp.observation(state, None)).tolist()
    assert table_size(grid) == (2**50, 3)
    assert table_size(image) == (256**150, 3)
    with pytest.raises(ValueError, match="Q would be a table of 27 petabytes"):
        QLearning.create(grid)
    with pytest.raises(ValueError, match=r"of about 10\^362 bytes \(about 10\^361 by 3 numbers\)"):
        QLearning.create(image)
    with pytest.raises(ValueError, match=r"about 10\^361 observations do not fit 63 bits: .*edugym.Hashed"):
        Tabular.create(image)


def test_numbers_that_are_none() -> None:
    """They lie in no bin."""
    task: Any = Discretised.create(Shows(), 4)
    with pytest.raises(ValueError, match=r"an observation that is not a number \(NaN\) lies in no bin"):
        task.observation((np.nan, 0.0), None)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"bins": 0}, "bins must be a whole number, 1 or more|bins must be from 1"),
        ({"bins": 2**31 + 1}, "bins must be from 1 to 2147483648"),
        ({"bins": 2.5}, "bins must be a whole number"),
        ({"bins": [2, 2, 2]}, r"bins must be one number or 2, one for each, but is \[2, 2, 2\]"),
        ({"bins": 2, "low": [1, 2, 3]}, r"low must be one number or 2, one for each, but is \[1, 2, 3\]"),
        ({"bins": 2, "low": [0, 3]}, "high must be greater than low, but for number 1 they are 1.0 and 3.0$"),
        ({"bins": 2, "high": -1.0}, "high must be greater than low, but for number 0 they are -1.0 and -1.0$"),
        ({"bins": 2, "low": [0, 1]}, "high must be greater than low, but for number 1 they are 1.0 and 1.0$"),
        ({"bins": 2, "low": np.inf}, "low must be given for a task that observes numbers without bounds"),
    ],
)
def test_arguments(arguments: dict[str, Any], message: str) -> None:
    """Each is checked, and named."""
    with pytest.raises(ValueError, match=message):
        Discretised.create(Shows(), **arguments)


def test_tasks_that_observe_something_else() -> None:
    """No bins for whole numbers, and none where there are no bounds; what is no task is told first."""
    for create in (Discretised.create, DiscreteActions.create):
        with pytest.raises(ValueError, match=r"mdp must be an MDP, .* but is 3"):
            create(3, 4)
    with pytest.raises(ValueError, match="mdp must observe real numbers"):
        Discretised.create(make_mdp("Boulder"), 3)
    with pytest.raises(ValueError, match="low must be given for a task that observes numbers without bounds: low="):
        Discretised.create(Shows(-np.inf, np.inf), 3)
    with pytest.raises(ValueError, match="high must be given for a task that observes numbers without bounds: high="):
        Discretised.create(Shows(), 3, high=[1.0, np.inf])


def test_actions() -> None:
    """All combinations, the last number fastest; each does what it stands for."""
    task: Any = DiscreteActions.create(Shows(-10.0, 10.0), [2, 3])
    assert task.action_space == spaces.Discrete(6)
    assert task.actions.tolist() == [[-1, 0], [-1, 5], [-1, 10], [1, 0], [1, 5], [1, 10]]
    assert list(named_actions(task))[:2] == ["-1, 0", "-1, 5"]
    more: Any = DiscreteActions.create(Shows(), [3, 5])
    assert list(named_actions(more))[5:7] == ["0, 0", "0, 2.5"]
    env = MDPEnv(task)
    env.reset(seed=0)
    observation, reward, *_ = env.step(4)
    assert observation.tolist() == [1.0, 5.0]
    assert reward == 1.0


class Table(Shows):
    """Its actions have two axes."""

    action_space = spaces.Box(0.0, 1.0, (2, 2))


class Several(Shows):
    """Its actions are whole numbers."""

    action_space: Any = spaces.MultiDiscrete([2, 3])


class Endless(Shows):
    """Its actions have no bounds."""

    action_space = spaces.Box(-np.inf, 1.0, (2,))


@pytest.mark.parametrize(
    ("mdp", "bins", "message"),
    [
        (make_mdp("Boulder"), 3, "the actions of mdp must be a Box of one axis with finite bounds"),
        (
            Table(),
            3,
            r"the actions of mdp must be a Box of one axis with finite bounds, but are Box\(0.0, 1.0, \(2, 2\)",
        ),
        (Several(), 3, r"the actions of mdp must be a Box of one axis with finite bounds, but are MultiDiscrete"),
        (Endless(), 3, r"the actions of mdp must be a Box of one axis with finite bounds, but are Box\(-inf, 1.0"),
        (Shows(), 1, "bins must be from 2|bins must be a whole number, 2"),
        (Shows(), 1_000, "bins must give at most 100000 actions, but 1000 gives 1,000,000"),
        (Shows(), [2, 50_001], "bins must give at most 100000 actions"),
        (Shows(), [2], "bins must be one number or 2, one for each"),
    ],
)
def test_arguments_of_actions(mdp: Any, bins: Any, message: str) -> None:
    """Each is checked, and named."""
    with pytest.raises(ValueError, match=message):
        DiscreteActions.create(mdp, bins)
    assert DiscreteActions.create(Shows(), [2, 50_000]).action_space.n == 100_000


def test_machine_code_does_the_same() -> None:
    """Both, on Trashbot, under a hashed table."""
    tasks = [
        Hashed.create(Discretised.create(DiscreteActions.create(make_mdp("Trashbot"), 3), 20), 3_000) for _ in range(2)
    ]
    shown = watched(tasks[0])
    assert np.array_equal(watched(tasks[1], machine_code=True), shown)
    assert len(np.unique(shown[:, 0])) > 20


def test_a_table_learns_in_a_discretised_task() -> None:
    """The better of the two first parts of an action, by Q-learning."""
    task = DiscreteActions.create(Discretised.create(Shows(high=10.0), 2), 2)
    agent = QLearning.create(task, discount=0.5)
    train(task, agent, 2_000, seed=0, max_steps=10)
    assert set(agent.Q[agent.Q.any(axis=1)].argmax(axis=1)) <= {2, 3}
