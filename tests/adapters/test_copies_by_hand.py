"""Several copies of a task that go different ways: what each shows, and what becomes of all where one does not fit."""

import signal
import warnings
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.vector import AutoresetMode

from edugym import make_mdp
from edugym.adapters import vector_env
from edugym.adapters.copies import step_copies
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.mdp.protocol import Random
from edugym.rendering.scene import Scene
from tests.compiled.cells import WALK, cell
from tests.contract.play import Copies, plain


class Remembered(NamedTuple):
    """A task whose info and picture ask for everything; only some actions lead to the end.

    Attributes:
        action_space: of the actions.
        max_steps: the limit.
        end: the last state that is not terminal.
    """

    action_space: Any
    max_steps: int = 5
    end: int = 16

    @property
    def observation_space(self) -> Any:
        """Whole numbers."""
        return spaces.Discrete(100)

    def initial(self, rng: Random) -> int:
        """One of ten."""
        return int(rng.random() * 10)

    def transition(self, state: int, action: Any, rng: Random) -> int:
        """On, by chance."""
        return state + 1 + int(rng.random() * 3)

    def reward(self, state: int, action: Any, next_state: int, rng: Random) -> float:
        """As far as it goes."""
        return float(next_state - state)

    def terminal(self, state: int) -> bool:
        """Far away."""
        return state > self.end

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    def info(self, state: int, last_state: Any, last_action: Any, actions: Any, steps: int) -> dict[str, Any]:
        """All of it."""
        return {"all": (state, last_state, last_action, list(actions), steps)}


class Latest(Remembered):
    """Its info asks for the last action and no other."""

    __slots__ = ()

    def info(self, state: int, last_action: Any) -> dict[str, Any]:  # type: ignore[override]
        """What is known."""
        return {"last": last_action}


class Drawn(Remembered):
    """Its picture asks, and its info does not."""

    __slots__ = ()

    def info(self, state: int) -> dict[str, Any]:  # type: ignore[override]
        """Nothing."""
        return {}

    def scene(self, state: int, last_state: Any, actions: Any) -> Scene:
        """As wide as what is known."""
        return Scene(1.0 + state + 100 * (last_state or 0), 1.0 + sum(map(float, np.ravel(actions))), ())


KINDS = {
    "all": Remembered(spaces.Discrete(3)),
    "many actions": Remembered(spaces.Discrete(1000)),
    "vectors": Remembered(spaces.Box(0, 1, (2,), np.float32)),
    "two numbers": Remembered(spaces.MultiDiscrete([3, 200])),
    "the last action": Latest(spaces.Discrete(128)),
}


@pytest.mark.filterwarnings("ignore:.* interpreted")
@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP])
@pytest.mark.parametrize("name", KINDS)
def test_what_each_of_several_copies_knows(name: str, mode: AutoresetMode) -> None:
    """The info of a copy, with its own last state and actions, is that of a single environment."""
    task: Any = KINDS[name]
    alone = Copies([MDPEnv(task) for _ in range(3)], mode, seed=4)
    vector = MDPVectorEnv(MDPEnv(task), 3, mode)
    vector.reset(seed=4)
    vector.action_space.seed(0)
    for _ in range(60):
        actions = vector.action_space.sample()
        alone.step([int(action) if np.ndim(action) == 0 else action for action in actions])
        vector.step(actions)
        for i in range(3):
            assert plain(vector.showing(i).info()) == plain(alone.envs[i].info())


class Below(Remembered):
    """Pays less than nothing for low actions, which small types of NumPy's cannot tell."""

    __slots__ = ()

    def reward(self, state: int, action: Any, next_state: int, rng: Random) -> float:
        """Two less than the action."""
        return float(action[0] - 2)


@pytest.mark.parametrize("given", [np.uint8, np.int8, np.uint64, np.int64])
def test_actions_have_the_type_of_their_space(given: Any) -> None:
    """Whatever type they are given in; they are kept as they were, whatever becomes of the array that was given."""
    vector = MDPVectorEnv(MDPEnv(Below(spaces.MultiDiscrete([3, 2]), end=40)), 2)
    vector.reset(seed=0)
    actions = np.array([[0, 1], [1, 0]], given)
    assert vector.step(actions)[1].tolist() == [-2.0, -1.0]
    actions[:] = 1
    for i, own in enumerate(([0, 1], [1, 0])):
        (kept,) = vector.showing(i).actions
        assert (kept.tolist(), kept.dtype) == (own, np.int64)


@pytest.mark.parametrize("mode", AutoresetMode)
def test_what_is_tried_is_like_what_is_run(mode: AutoresetMode) -> None:
    """The loops are tried, and compiled, with arrays of the same types, which are not those of the copies."""
    vector = MDPVectorEnv(MDPEnv(make_mdp("Boulder")), 5, autoreset_mode=mode)
    vector.reset(seed=0)
    vector._steps[:], vector._over[1] = range(5), True
    few, all_of_them = vector._few(3), vector._batch()
    for part, whole in zip(arrays(few), arrays(all_of_them), strict=True):
        assert part.dtype == whole.dtype
        assert len(part) == min(3, len(whole))
        assert not np.shares_memory(part, whole)
    assert (few.steps.tolist(), few.over.tolist()) == ([0, 1, 2], [False, True, False])


def arrays(value: Any) -> list[np.ndarray[Any, Any]]:
    """All arrays in a tuple."""
    return [value] if isinstance(value, np.ndarray) else [array for part in value for array in arrays(part)]


@pytest.mark.filterwarnings("ignore:.* interpreted")
@pytest.mark.parametrize("name", KINDS)
def test_actions_are_remembered_as_they_were(name: str) -> None:
    """Whoever gave them may use the array again."""
    vector = MDPVectorEnv(MDPEnv(KINDS[name]), 2)
    vector.reset(seed=0)
    vector.action_space.seed(0)
    actions = vector.action_space.sample()
    vector.step(actions)
    taken = actions.tolist()
    actions[:] = 1 - actions
    assert [np.asarray(vector.showing(i).last_action).tolist() for i in range(2)] == taken


@pytest.mark.filterwarnings("ignore:.* interpreted")
def test_what_each_of_several_copies_draws() -> None:
    """Where the picture alone asks for what was before."""
    task: Any = Drawn(spaces.Discrete(3))
    alone = Copies([MDPEnv(task) for _ in range(3)], AutoresetMode.SAME_STEP, seed=4)
    vector = MDPVectorEnv(MDPEnv(task), 3, "SameStep")
    vector.reset(seed=4)
    for step in range(30):
        actions = [step % 3, (step + 1) % 3, 2]
        alone.step(actions)
        vector.step(actions)
        assert [vector.showing(i).scene() for i in range(3)] == [env.scene() for env in alone.envs]


def test_ctrl_c_while_a_step_is_put_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """It waits until the copies are where they were before the step."""
    vector: Any = MDPVectorEnv(MDPEnv(cell(WALK)["Walk"](5)), 2)
    vector.reset(seed=0)
    vector.step([1, 1])
    before, runner = [vector.state(i) for i in range(2)], vector._runner
    fast, put_back = runner._code[step_copies], runner._put_back

    def failing(*arguments: Any) -> None:
        fast(*arguments)
        assert [vector.state(i) for i in range(2)] != before
        raise ZeroDivisionError

    def interrupted(*kept: Any) -> None:
        signal.raise_signal(signal.SIGINT)
        put_back(*kept)

    monkeypatch.setitem(runner._code, step_copies, failing)
    monkeypatch.setattr(runner, "_put_back", interrupted)
    with pytest.raises(KeyboardInterrupt):
        vector.step([1, 1])
    assert [vector.state(i) for i in range(2)] == before


@pytest.mark.parametrize(("asked", "limit"), [(None, 5), (-1, 5), (7, 5), (5, 5), (3, 3)])
def test_the_lower_limit_counts(asked: int | None, limit: int) -> None:
    """The task's own, or what is asked for."""
    task: Any = Remembered(spaces.Discrete(1))._replace(end=40)
    vector = MDPVectorEnv(MDPEnv(task), 2, max_episode_steps=asked)
    vector.spec = gymnasium.spec("edugym/Boulder-v0")
    assert vector.spec.max_episode_steps == limit
    vector.reset(seed=0)
    truncated = [vector.step([0, 0])[3].tolist() for _ in range(limit)]
    assert truncated == [[False, False]] * (limit - 1) + [[True, True]]


LEAVING = """
class Leaving(NamedTuple):
    max_steps: int = 170
    def initial(self, rng): return int(rng.random() * 10)
    def transition(self, state, action, rng):
        return state + int(rng.random() * 3) if state < 150 else state + rng.random()
    def reward(self, state, action, next_state, rng): return state + rng.random()
    def terminal(self, state): return state > 160
    def observation(self, state, rng): return rng.random()
    observation_space = property(lambda self: spaces.Box(0, 1, (), np.float64))
    action_space = property(lambda self: spaces.Discrete(2))
"""
"""A student's task whose states are no longer whole from 150 on, with chance in everything."""


def test_all_copies_go_on_where_the_state_of_one_does_not_fit() -> None:
    """The whole step is taken again, with the same chances, from the same states, after as many steps."""
    task = cell(LEAVING)["Leaving"]()
    alone = Copies([MDPEnv(task) for _ in range(3)], AutoresetMode.NEXT_STEP, seed=8)
    vector = MDPVectorEnv(MDPEnv(task), 3)
    vector.reset(seed=8)
    compiled = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for _ in range(250):
            rewards, terminations, truncations, _ = alone.step([1, 1, 1])
            observations, *seen, _ = vector.step([1, 1, 1])
            assert observations.tolist() == [float(seen) for seen in alone.observations]
            assert [part.tolist() for part in seen] == [rewards, terminations, truncations]
            assert plain([vector.state(i) for i in range(3)]) == plain([env.state for env in alone.envs])
            assert [vector.showing(i).steps for i in range(3)] == [env.steps for env in alone.envs]
            compiled.append(vector.is_compiled)
    assert compiled[0]
    assert not compiled[-1]


SETS = """
class Sets(NamedTuple):
    observation_space: object = spaces.Discrete(1)
    action_space: object = spaces.Discrete(2)
    def initial(self, rng): return {1}
    def transition(self, state, action, rng): return state
    def reward(self, state, action, next_state, rng): return 1.0
    def terminal(self, state): return False
    def observation(self, state, rng): return 0
"""
"""A student's task whose states are no numbers."""


def test_who_is_told_that_nothing_is_compiled() -> None:
    """The line that resets the copies, with the class and why."""
    vector = MDPVectorEnv(MDPEnv(cell(SETS)["Sets"]()), 2)
    with pytest.warns(
        UserWarning, match=r"^Sets cannot be compiled and runs interpreted, .* tuples of numbers"
    ) as told:
        vector.reset(seed=0)
    assert [one.filename for one in told] == [__file__]
    assert not vector.is_compiled


def test_rewards_before_the_first_step(monkeypatch: pytest.MonkeyPatch) -> None:
    """A reset gives none: what stood in the memory of their array, such as NaN, is no reason to leave machine code."""

    class Dirty:
        """NumPy on a machine whose new memory is full of NaN."""

        def __getattr__(self, name: str) -> Any:
            return getattr(np, name)

        def empty(self, shape: Any, dtype: Any = np.float64) -> Any:
            """An array of them, where there can be any."""
            return np.full(shape, np.nan if np.dtype(dtype).kind == "f" else 0, dtype)

    vector = MDPVectorEnv(MDPEnv(cell(LEAVING)["Leaving"]()), 2)
    monkeypatch.setattr(vector_env, "np", Dirty())
    vector.reset(seed=0)
    vector.reset()
    assert vector.is_compiled


def test_without_a_limit_nothing_is_truncated() -> None:
    """However long nothing ends."""
    envs = MDPVectorEnv(MDPEnv(cell(WALK)["Walk"](5)), 2)
    envs.reset(seed=0)
    still = np.zeros(2, np.int64)
    assert not any(envs.step(still)[3].any() for _ in range(3_000))
