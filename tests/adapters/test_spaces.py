"""Which actions stand for an element of each space, and which spaces the copies of a task can have."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym import MDPEnv, MDPVectorEnv
from tests.compiled.cells import cell

WHOLE, SEVERAL, TEXT = spaces.Discrete(3), spaces.MultiDiscrete([2, 3]), spaces.Text(3)
REAL = spaces.Box(np.array([-1, 0], np.float32), np.array([1, 5], np.float32))


STILL = """
class Still(NamedTuple):  # shows the same element all the time, and pays the sum of an action
    observation_space: object
    seen: object
    action_space: object
    def initial(self, rng): return {1}  # a set: it is not compiled
    def transition(self, state, action, rng): return state
    def reward(self, state, action, next_state, rng): return 0.0 if isinstance(action, str) else float(np.sum(action))
    def terminal(self, state): return False
    def observation(self, state, rng): return self.seen
"""
Still = cell(STILL)["Still"]


def started(space: spaces.Space[Any], *, copies: int = 0) -> Any:
    """One environment or several copies with this action space, at the start of an episode."""
    task: Any = Still(spaces.Discrete(1), 0, space)
    env: Any = MDPVectorEnv(task, copies) if copies else MDPEnv(task)
    env.reset(seed=0)
    return env


@pytest.mark.filterwarnings("ignore:Still cannot be compiled")
@pytest.mark.parametrize(
    ("space", "action", "taken"),
    [
        (WHOLE, 1, 1),
        (WHOLE, np.int8(2), 2),
        (SEVERAL, [1, 2], np.array([1, 2])),
        (SEVERAL, np.array([0, 1], np.uint8), np.array([0, 1])),
        (REAL, [0, 2], np.array([0, 2], np.float32)),
        (REAL, np.array([-1.5, 5.5], np.float32), np.array([-1, 5], np.float32)),
        (REAL, (1.5, -0.5), np.array([1, 0], np.float32)),
        (TEXT, "abc", "abc"),
    ],
)
def test_what_is_taken(space: spaces.Space[Any], action: Any, taken: Any) -> None:
    """In the type of the space; real numbers are cut off at the bounds; an array is one of its own."""
    env = started(space)
    env.step(action)
    assert type(env.last_action) is type(taken)
    np.testing.assert_array_equal(env.last_action, taken)
    if isinstance(taken, np.ndarray):
        assert env.last_action.dtype == space.dtype
        assert not np.shares_memory(env.last_action, np.asarray(action))
    if space is not TEXT:
        assert started(space, copies=2).step([action, action])[1].tolist() == [np.sum(taken)] * 2


@pytest.mark.parametrize(
    ("space", "action"),
    [(SEVERAL, [[0], [1, 2]]), (REAL, ["a", "b"]), (REAL, [True, False]), (TEXT, "abcd"), (WHOLE, 10**30)],
)
def test_what_is_refused(space: spaces.Space[Any], action: Any) -> None:
    """With the action and the space, beside what the contract tests try."""
    with pytest.raises(ValueError, match=r"^action .* is not in the action space (Discrete|Multi|Box|Text)"):
        started(space).step(action)


@pytest.mark.filterwarnings("ignore:Still cannot be compiled")
@pytest.mark.parametrize(
    ("space", "seen"),
    [
        (spaces.Discrete(3, start=5), 6),
        (spaces.Box(-1.0, 1.0, (2,), np.float64), [0.5, -0.25]),
        (SEVERAL, [1, 2]),
        (spaces.MultiBinary(3), [1, 0, 1]),
    ],
)
def test_elements_become_rows(space: spaces.Space[Any], seen: Any) -> None:
    """Of observations and of actions."""
    acts = WHOLE if isinstance(space, spaces.Discrete) else space
    action = 2 if acts is WHOLE else seen
    task: Any = Still(space, np.array(seen, space.dtype) if np.ndim(seen) else seen, acts)
    envs = MDPVectorEnv(task, 3)
    observations, _ = envs.reset(seed=0)
    assert observations.tolist() == [seen] * 3
    assert observations in envs.observation_space
    observations, rewards, *_ = envs.step(np.array([action] * 3, acts.dtype))
    assert observations.tolist() == [seen] * 3
    assert rewards.tolist() == [np.sum(action)] * 3


@pytest.mark.parametrize(
    ("space", "element"),
    [
        (TEXT, "abc"),
        (spaces.Tuple((spaces.Discrete(2), spaces.Discrete(2))), (1, 0)),
        (spaces.Dict({"a": spaces.Discrete(2)}), {"a": 1}),
    ],
)
def test_spaces_without_arrays_are_refused(space: spaces.Space[Any], element: Any) -> None:
    """By copies, with the name of the space; a single environment shows and takes such elements."""
    tasks: dict[str, Any] = {"observation": Still(space, element, WHOLE), "action": Still(WHOLE, 0, space)}
    for which, task in tasks.items():
        with pytest.raises(ValueError, match=f"^{which}_space must be Discrete, Box, .* but is {type(space).__name__}"):
            MDPVectorEnv(task, 3)
    assert MDPEnv(tasks["observation"]).reset(seed=0)[0] == element


def test_an_observation_with_a_part_too_few() -> None:
    """No part is left out in silence; whole numbers of NumPy's become Python's."""
    space = spaces.Tuple([spaces.Discrete(3), spaces.Discrete(3)])
    seen, _ = MDPEnv(Still(space, (np.int64(1), 2), WHOLE)).reset(seed=0)
    assert (seen, [type(part) for part in seen]) == ((1, 2), [int, int])
    with pytest.raises(ValueError, match=r"\(1,\)|zip"):
        MDPEnv(Still(space, (1,), WHOLE)).reset(seed=0)
