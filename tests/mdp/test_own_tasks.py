"""A task from a notebook cell is everything that the package's own tasks are, in all four ways."""

import math
from typing import Any

import gymnasium
import numpy as np
import pytest
from contract.play import plain
from gymnasium import spaces
from gymnasium.error import ResetNeeded
from gymnasium.utils.env_checker import check_env

import edugym
from edugym.mdp.env import MDPEnv
from edugym.mdp.model import finite_model
from edugym.mdp.vector import MDPVectorEnv
from edugym.planning.value_iteration import value_iteration
from mdp.cells import LEARNER, SLIPPERY, WALK, cell

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
        envs = [MDPEnv(task) for _ in range(n)]
        first, _ = vector.reset(seed=5)
        starts = []
        for env in envs:
            starts.append(env.reset(seed=5 if env is envs[0] else None)[0])
            env.np_random = envs[0].np_random
        if n == 1:
            assert plain(first) == plain(np.array(starts, first.dtype))
        for env in envs[1:]:
            env.reset()
        if n > 1:  # start again in the order of the vector environment
            first, _ = vector.reset(seed=5)
            envs[0].reset(seed=5)
            for env in envs[1:]:
                env.np_random = envs[0].np_random
                env.reset()
        rng = np.random.default_rng(0)
        for _ in range(60):
            actions = rng.integers(0, 2, n)
            observations, rewards, terminations, truncations, infos = vector.step(actions)
            for i, env in enumerate(envs):
                observation, reward, terminated, truncated, _ = env.step(int(actions[i]))
                if terminated or truncated:
                    assert plain(infos["final_obs"][i]) == plain(observation)
                    observation, _ = env.reset()
                assert plain(observations[i]) == plain(observation)
                assert (rewards[i], terminations[i], truncations[i]) == (reward, terminated, truncated)
                assert plain(vector.state(i)) == plain(env.state)


def test_training_in_the_deterministic_task() -> None:
    """A student's agent finds the shortest way in a student's task, and the curve says so."""
    notebook = cell(WALK + LEARNER)
    task = notebook["Walk"](5)
    run = edugym.train(task, notebook["Learner"](np.zeros((6, 2))), 40_000, evaluate_every=10_000, max_steps=100)
    best = 1 - 4 * 0.25
    assert run.returns[-1] == best
    assert run.agent.Q[:5, 1].tolist() == pytest.approx([best - 0.25 * k * -1 for k in range(5)], abs=1e-6)


@pytest.mark.parametrize("slip", [0.1, 0.25])
def test_ways_agree_on_the_stochastic_task(slip: float) -> None:
    """Model, environment, vector environment and compiled play all find the mean return that the formula gives."""
    size, n_episodes = 5, 4000
    task = task_of(SLIPPERY, "SlipperyWalk", (size, slip))
    times = [1 / (1 - slip)]
    for _ in range(size - 1):
        times.append((1 + slip * times[-1]) / (1 - slip))
    exact = 1 - 0.25 * (sum(times) - 1)
    assert value_iteration(finite_model(task)).start == pytest.approx(exact, abs=1e-8)

    env = MDPEnv(task)
    env.reset(seed=1)
    singly = np.zeros(n_episodes)
    for episode in range(n_episodes):
        env.reset()
        terminated = False
        while not terminated:
            _, reward, terminated, _, _ = env.step(1)
            singly[episode] += float(reward)

    n = 500
    vector = MDPVectorEnv(env, n, "SameStep")
    vector.reset(seed=2)
    going = np.zeros(n)
    together: list[float] = []
    while len(together) < n_episodes:
        _, rewards, terminations, _, _ = vector.step(np.ones(n, np.int64))
        going += rewards
        together += going[terminations].tolist()
        going[terminations] = 0.0

    right = cell(
        "class Right(NamedTuple):\n    Q: np.ndarray\n    def act(self, state, rng): return 1\n"
        "    def learn(self, state, action, reward, next_state, terminated): pass"
    )["Right"](np.zeros((6, 2)))
    run = edugym.train(task, right, 10_000, evaluate_every=10_000, evaluation_episodes=n_episodes, max_steps=10_000)
    deviation = singly.std(ddof=1)
    assert abs(singly.mean() - exact) < 5 * deviation / math.sqrt(n_episodes)
    assert abs(run.returns[-1] - exact) < 5 * deviation / math.sqrt(n_episodes)
    early = np.mean(together)  # the first to end are the short ones
    assert exact < early < exact + deviation


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
        ("False", "state + 1"),
        ("'start'", "state + '>'"),
        ("None", "1 if state is None else state + 1"),
        ("(0, (1, 2))", "(state[0] + 0.5, (state[1][0] - 1, state[1][1]))"),
        ("(0,)", "(*state, action)"),
        ("()", "(*state, action)"),
    ],
)
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
    for step in range(6):
        if step == 0:
            quiet_reset(vector)
        vector.step(np.array([1, 1]))
        env.step(1)
        assert [plain(vector.state(0)), plain(vector.state(1))] == [plain(env.state)] * 2


def quiet_reset(vector: Any) -> None:
    """Reset and step once, whatever is said about compiling, and reset again."""
    import warnings

    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".* cannot be compiled")
        vector.reset(seed=0)
        vector.step(np.array([1, 1]))
        vector.reset(seed=0)


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
