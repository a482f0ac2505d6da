"""Which spaces the copies of a task can have: those of which several elements are one array."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym.adapters.vector_env import MDPVectorEnv
from edugym.mdp.protocol import Random

ELEMENTS: list[tuple[spaces.Space[Any], Any]] = [
    (spaces.Discrete(3, start=5), 6),
    (spaces.Box(-1.0, 1.0, (2,), np.float64), [0.5, -0.25]),
    (spaces.MultiDiscrete([2, 3]), [1, 2]),
    (spaces.MultiBinary(3), [1, 0, 1]),
]
ACTIONS = [(spaces.Discrete(3), 2), *ELEMENTS[1:]]
OTHERS: list[tuple[spaces.Space[Any], Any]] = [
    (spaces.Text(3), "abc"),
    (spaces.Tuple((spaces.Discrete(2), spaces.Discrete(2))), (1, 0)),
    (spaces.Dict({"a": spaces.Discrete(2)}), {"a": 1}),
]


class Still(NamedTuple):
    """Shows the same element all the time, and pays the sum of an action. Its state is a set: it is not compiled."""

    observation_space: Any
    seen: Any
    action_space: Any

    def initial(self, rng: Random) -> Any:
        """The only state."""
        return {1}

    def transition(self, state: Any, action: Any, rng: Random) -> Any:
        """Stay."""
        return state

    def reward(self, state: Any, action: Any, next_state: Any, rng: Random) -> float:
        """The sum."""
        return float(np.sum(action))

    def terminal(self, state: Any) -> bool:
        """Never."""
        return False

    def observation(self, state: Any, rng: Random) -> Any:
        """Always this."""
        return self.seen


@pytest.mark.filterwarnings("ignore:Still cannot be compiled")
@pytest.mark.parametrize(("acts", "action"), ACTIONS)
@pytest.mark.parametrize(("shows", "seen"), ELEMENTS)
def test_elements_become_rows(shows: spaces.Space[Any], seen: Any, acts: spaces.Space[Any], action: Any) -> None:
    """Of observations and of actions, in all combinations."""
    task: Any = Still(shows, np.array(seen, shows.dtype) if np.ndim(seen) else seen, acts)
    envs = MDPVectorEnv(task, 3)
    observations, _ = envs.reset(seed=0)
    assert observations.tolist() == [seen] * 3
    assert observations in envs.observation_space
    observations, rewards, *_ = envs.step(np.array([action] * 3, acts.dtype))
    assert observations.tolist() == [seen] * 3
    assert rewards.tolist() == [np.sum(action)] * 3


@pytest.mark.parametrize(("space", "element"), OTHERS)
def test_other_spaces_are_refused(space: spaces.Space[Any], element: Any) -> None:
    """With the name of the space that does not fit."""
    says = "_space must be Discrete, Box, MultiDiscrete or MultiBinary in a vector environment, but is "
    task: Any
    for task, which in (
        (Still(space, element, spaces.Discrete(2)), "observation"),
        (Still(spaces.Discrete(2), 0, space), "action"),
    ):
        with pytest.raises(ValueError, match=f"^{which}{says}"):
            MDPVectorEnv(task, 3)
