"""A task from a notebook cell is everything that the package's own tasks are, in all four ways."""

import math
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.error import ResetNeeded
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode

import edugym
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.compiled.cells import LEARNER, SLIPPERY, WALK, cell
from tests.contract.play import Copies, plain

PICTURE = (
    WALK.replace("class Walk", "class PictureWalk")
    .replace(
        "return state\n\n    @property",
        "picture = np.zeros((2, 3), np.float32)\n        picture[0, 0] = state\n        return picture\n\n"
        "    @property",
        1,
    )
    .replace("spaces.Discrete(self.size + 1)", "spaces.Box(0, 100, (2, 3), np.float32)")
)

TRAIL = """
class Trail(NamedTuple):
    steps: np.ndarray
    length: int

class Trails(NamedTuple):
    size: int
    max_steps: int = 12

    def initial(self, rng):
        return Trail(np.zeros(1, np.int64), 0)

    def transition(self, state, action, rng):
        longer = np.empty(len(state.steps) + 1, np.int64)
        longer[:-1] = state.steps
        longer[-1] = action + int(rng.random() * 2)
        return Trail(longer, state.length + 1)

    def reward(self, state, action, next_state, rng):
        return float(next_state.steps[-1]) + rng.normal(0.0, 0.1)

    def terminal(self, state):
        return len(state.steps) > self.size

    def observation(self, state, rng):
        return state.length, int(state.steps[-1])

    @property
    def observation_space(self):
        return spaces.MultiDiscrete([self.size + 1, 3])

    @property
    def action_space(self):
        return spaces.Discrete(2)
"""
"""A student's task whose state holds an array that grows, with noise in everything."""

DRIFT = """
class Place(NamedTuple):
    x: float
    laps: int

class Drift(NamedTuple):
    size: int

    def initial(self, rng):
        return Place(START, 0)

    def transition(self, state, action, rng):
        return Place(state.x + 0.25 + rng.random() / 1000, state.laps + action)

    def reward(self, state, action, next_state, rng):
        return next_state.x

    def terminal(self, state):
        return state.laps == self.size

    def observation(self, state, rng):
        return state.laps

    observation_space = property(lambda self: spaces.Discrete(self.size + 1))
    action_space = property(lambda self: spaces.Discrete(2))
"""
"""A student's task whose state starts as a whole number and does not stay one, if START is 0."""

TASKS = {
    "deterministic": (WALK, "Walk", (5,)),
    "stochastic": (SLIPPERY, "SlipperyWalk", (5, 0.25)),
    "arrays": (TRAIL, "Trails", (9,)),
    "step limit": (TRAIL, "Trails", (99, 7)),
    "continuous": (DRIFT.replace("START", "0.0"), "Drift", (3,)),
    "pictures": (PICTURE, "PictureWalk", (5,)),
}
every_task = pytest.mark.parametrize(("source", "name", "values"), TASKS.values(), ids=TASKS)


RIGHT = """
class Right(NamedTuple):
    tabular: bool = False
    def act(self, state, rng): return 1
    def learn(self, state, action, reward, next_state, terminated): pass
"""
"""An agent that always goes right."""


def task_of(source: str, name: str, values: tuple[Any, ...]) -> Any:
    """A task from a cell."""
    return cell(source)[name](*values)


@every_task
def test_environment(source: str, name: str, values: tuple[Any, ...]) -> None:
    """It is a Gymnasium environment without fault."""
    env = MDPEnv(task_of(source, name, values))
    check_env(env, skip_render_check=True)
    for mode in ("ansi", "rgb_array"):
        drawn = MDPEnv(env.mdp, render_mode=mode)
        with pytest.raises(ResetNeeded, match="render before the first reset"):
            drawn.render()
        drawn.reset(seed=0)
        frame = drawn.render()
        assert f"state {drawn.state!r}"[:8] in frame if isinstance(frame, str) else frame.ndim == 3
    env.reset()
    with pytest.warns(UserWarning, match="without a render_mode"):
        env.render()
    with pytest.raises(ValueError, match="render_mode must be one of None, 'human', 'rgb_array', 'ansi', but is 'svg'"):
        MDPEnv(env.mdp, render_mode="svg")


@every_task
def test_vector_environment(source: str, name: str, values: tuple[Any, ...]) -> None:
    """Copies of it are stepped together as one by one."""
    task = task_of(source, name, values)
    for n in (1, 3):
        vector = MDPVectorEnv(MDPEnv(task), n, "SameStep")
        alone = Copies([MDPEnv(task) for _ in range(n)], AutoresetMode.SAME_STEP, seed=5)
        observations, _ = vector.reset(seed=5)
        assert plain(tuple(observations)) == plain(tuple(np.array(alone.observations, observations.dtype)))
        rng = np.random.default_rng(0)
        for _ in range(60):
            actions = rng.integers(0, 2, n)
            rewards, terminations, truncations, last = alone.step(actions.tolist())
            observations, *seen, infos = vector.step(actions)
            assert plain(tuple(observations)) == plain(tuple(np.array(alone.observations, observations.dtype)))
            assert [part.tolist() for part in seen] == [rewards, terminations, truncations]
            assert plain(list(infos.get("final_obs", [None] * n))) == plain(last)
            assert plain([vector.state(i) for i in range(n)]) == plain([env.state for env in alone.envs])


def test_training_in_the_deterministic_task() -> None:
    """A student's agent finds the shortest way in a student's task, and the curve says so."""
    notebook = cell(WALK + LEARNER)
    task = notebook["Walk"](5)
    run = edugym.train(task, notebook["Learner"](np.zeros((6, 2))), 40_000, evaluate_every=10_000, max_steps=100)
    best = 1 - 4 * 0.25
    assert run.returns[-1] == best
    assert run.agent.Q[:5, 1].tolist() == pytest.approx([best - 0.25 * k * -1 for k in range(5)], abs=1e-6)


def test_ways_agree_on_the_stochastic_task() -> None:
    """Model, environment, vector environment and compiled play all find the mean return that the formula gives."""
    notebook = cell(SLIPPERY + RIGHT)
    size, n_episodes = 5, 4000
    for slip in (0.1, 0.25):
        task = notebook["SlipperyWalk"](size, slip)
        times = [1 / (1 - slip)]
        for _ in range(size - 1):
            times.append((1 + slip * times[-1]) / (1 - slip))
        exact = 1 - 0.25 * (sum(times) - 1)
        assert value_iteration(finite_model(task)).start == pytest.approx(exact, abs=1e-8)
        run = edugym.train(
            task,
            notebook["Right"](),
            10_000,
            evaluate_every=10_000,
            evaluation_episodes=n_episodes,
            max_steps=10_000,
        )
        for returns in (singly(task, n_episodes), together(task, n_episodes), run.returns[-1:]):
            deviation = singly(task, 1000).std(ddof=1)
            assert abs(returns.mean() - exact) < 5 * deviation / math.sqrt(n_episodes)


def singly(task: Any, n_episodes: int) -> Any:
    """The returns of always going right in an environment."""
    env = MDPEnv(task)
    env.reset(seed=1)
    returns = np.zeros(n_episodes)
    for episode in range(n_episodes):
        env.reset()
        terminated = False
        while not terminated:
            _, reward, terminated, _, _ = env.step(1)
            returns[episode] += float(reward)
    return returns


def together(task: Any, n_episodes: int) -> Any:
    """The same in a vector environment: of every copy the first ten episodes, since the first to end are short ones."""
    n = n_episodes // 10
    vector = MDPVectorEnv(MDPEnv(task), n, "SameStep")
    vector.reset(seed=2)
    going = np.zeros(n)
    returns: list[list[float]] = [[] for _ in range(n)]
    while min(map(len, returns)) < 10:
        _, rewards, terminations, _, _ = vector.step(np.ones(n, np.int64))
        going += rewards
        for i in np.flatnonzero(terminations).tolist():
            returns[i].append(float(going[i]))
        going[terminations] = 0.0
    return np.array([some[:10] for some in returns])


def test_whole_numbers_that_do_not_stay_whole() -> None:
    """A state that starts as 0 and becomes 0.25 is not rounded in the vector environment."""
    task = task_of(DRIFT.replace("START", "0"), "Drift", (99,))
    vector, env = MDPVectorEnv(MDPEnv(task), 1), MDPEnv(task)
    vector.reset(seed=3)
    with pytest.warns(UserWarning, match="Drift, Place cannot be compiled and runs interpreted"):
        vector.step(np.array([0]))
    vector.reset(seed=3)
    env.reset(seed=3)
    for _ in range(10):
        _, rewards, *_ = vector.step(np.array([0]))
        assert rewards[0] == env.step(0)[1]
        assert vector.state(0) == env.state


@pytest.mark.parametrize(
    ("initial", "transition"),
    [
        ("0", "state + 0.5"),
        ("'start'", "state + '>'"),
        ("None", "1 if state is None else state + 1"),
        ("()", "(*state, action)"),
    ],
)
@pytest.mark.filterwarnings("ignore:.* cannot be compiled")
def test_states_of_any_kind(initial: str, transition: str) -> None:
    """States of other types than numbers, and of types that change, work in every environment, if not compiled."""
    source = f"""
class Odd(NamedTuple):
    size: int
    max_steps: int = 6
    def initial(self, rng): return {initial}
    def transition(self, state, action, rng): return {transition}
    def reward(self, state, action, next_state, rng): return 1.0
    def terminal(self, state): return False
    def observation(self, state, rng): return 0
    observation_space = property(lambda self: spaces.Discrete(1))
    action_space = property(lambda self: spaces.Discrete(2))
"""
    task = task_of(source, "Odd", (1,))
    env, vector = MDPEnv(task), MDPVectorEnv(MDPEnv(task), 2)
    env.reset(seed=0)
    vector.reset(seed=0)
    for _ in range(6):
        vector.step(np.array([1, 1]))
        env.step(1)
        assert plain([vector.state(0), vector.state(1)]) == plain([env.state] * 2)


def test_subclass_of_an_environment() -> None:
    """What a student overrides in an environment counts, also when an agent is trained in it."""

    class Doubled(MDPEnv[Any]):
        def step(self, action: Any) -> Any:
            observation, reward, *rest = super().step(action)
            return observation, 2 * float(reward), *rest

    notebook = cell(WALK + LEARNER)
    env = Doubled(notebook["Walk"](3))
    run = edugym.train(env, notebook["Learner"](np.zeros((4, 2))), 3000, max_steps=50)
    assert run.returns[-1] == 2 * (1 - 2 * 0.25)


def test_registered_by_a_student() -> None:
    """A student's environment can be registered with Gymnasium and made by its id."""
    task = task_of(WALK, "Walk", (5,))
    gymnasium.register("student/Walk-v0", entry_point=lambda **keywords: MDPEnv(task, **keywords), max_episode_steps=3)
    try:
        env = gymnasium.make("student/Walk-v0", render_mode="ansi")
        env.reset(seed=0)
        assert [env.step(0)[3] for _ in range(3)] == [False, False, True]
    finally:
        del gymnasium.registry["student/Walk-v0"]


def test_actions_that_do_not_start_at_0() -> None:
    """Actions are 0, 1, ...: an MDP that numbers them otherwise is told so."""
    task = task_of(WALK.replace("spaces.Discrete(2)", "spaces.Discrete(2, start=1)"), "Walk", (5,))
    with pytest.raises(ValueError, match=r"action.*Discrete\(2, start=1\)"):
        MDPEnv(task)


def test_observations_are_arrays_of_their_own() -> None:
    """An array that an MDP gives as observation is copied, so that nobody can write into the task."""
    task = task_of(PICTURE, "PictureWalk", (5,))
    env = MDPEnv(task)
    observation, _ = env.reset(seed=0)
    assert isinstance(env.observation_space, spaces.Box)
    observation[:] = 7
    again, *_ = env.step(1)
    assert again.tolist() == [[1, 0, 0], [0, 0, 0]]


@pytest.mark.parametrize("returned", ["None", "np.zeros((3, 3))", "'a wall'"])
@pytest.mark.parametrize("mode", ["ansi", "rgb_array"])
def test_scenes_that_are_none(returned: str, mode: str) -> None:
    """A picture that is something else is answered with one sentence."""
    source = WALK.replace(
        "    def initial", f"    def scene(self, state):\n        return {returned}\n\n    def initial"
    )
    env = MDPEnv(cell(source)["Walk"](5), render_mode=mode)
    env.reset(seed=0)
    with pytest.raises(ValueError, match="scene of Walk must return a Scene, but returned "):
        env.render()
