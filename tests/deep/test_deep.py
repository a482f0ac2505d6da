"""Stable-Baselines3 gets what its own vector environment gives, and learns from it."""

import re
import sys
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.error import DependencyNotInstalled, ResetNeeded
from sb3_contrib import RecurrentPPO
from stable_baselines3 import DQN
from stable_baselines3.common.env_checker import check_env
from stable_baselines3.common.env_util import make_vec_env
from stable_baselines3.common.monitor import Monitor
from stable_baselines3.common.vec_env import DummyVecEnv

from edugym.adapters.registration import Entry
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.deep import stable_baselines3_env
from edugym.envs.boulder import Boulder
from tests.contract.play import every_environment, plain
from tests.messages import named

CATCH: Any = gymnasium.make("edugym/Catch-v0").unwrapped


def copies(environment: Any, *arguments: Any, **parameters: Any) -> Any:
    """As `stable_baselines3_env`, of any type: that which a `VecEnv` declares is too general to look into."""
    return stable_baselines3_env(environment, *arguments, **parameters)


@every_environment
def test_checker_of_stable_baselines3(entry: Entry) -> None:
    """Stable-Baselines3's own checker finds nothing wrong with any environment."""
    check_env(entry.load()(), warn=entry.name != "Catch")  # it advises against grids and against images this small


@every_environment
def test_one_copy_is_dummy_vec_env(entry: Entry) -> None:
    """One copy gives what Stable-Baselines3's own vector environment of one environment gives, types included."""
    ours, theirs = copies(entry.name), DummyVecEnv([entry.load()])
    assert (ours.observation_space, ours.action_space) == (theirs.observation_space, theirs.action_space)
    assert ours.seed(11) == theirs.seed(11)
    assert plain(ours.reset()) == plain(theirs.reset())
    ours.action_space.seed(3)
    ended = 0
    for _ in range(1_001):
        actions = np.array([ours.action_space.sample()])
        *given, infos = ours.step(actions)
        *expected, infos_there = theirs.step(actions)
        assert plain(given) == plain(expected)
        assert infos[0]["TimeLimit.truncated"] is infos_there[0]["TimeLimit.truncated"]
        assert ("terminal_observation" in infos[0]) == ("terminal_observation" in infos_there[0]) == bool(given[2][0])
        if given[2][0]:
            ended += 1
            assert plain(infos[0]["terminal_observation"]) == plain(infos_there[0]["terminal_observation"])
    assert ended > 0


def test_seeds() -> None:
    """The same seed gives the same run, another one another; without one the stream goes on."""

    def starts(*seed: int) -> list[Any]:
        env = copies("Catch", 6, observation_type="vectorised")
        env.seed(*seed)
        return [env.reset()[:, 0].tolist() for _ in range(4)]

    assert starts(5) == starts(5) != starts(6)
    assert starts() != starts()
    assert len({*map(str, starts(5))}) > 1  # a seed counts for one reset


def test_attributes_and_methods() -> None:
    """Attributes and methods are those of each copy; what would change a copy is refused."""
    env = copies("Catch", 3, rows=4, observation_type="vectorised")
    env.reset()
    observations, *_ = env.step(np.array([0, 1, 2]))
    assert env.get_attr("state") == [tuple(row) for row in observations.tolist()]
    assert env.get_attr("steps", indices=[0, 2]) == [1, 1]
    assert env.get_attr("mdp", indices=1)[0].rows == 4
    assert [info["paddle"] for info in env.env_method("info")] == [1, 2, 3]
    assert [info["paddle"] for info in env.env_method("info", indices=2)] == [3]
    assert env.has_attr("render_mode")
    assert not env.has_attr("no_such_thing")
    assert env.env_is_wrapped(Monitor) == [False] * 3
    assert env.env_is_wrapped(Monitor, indices=0) == [False]
    with pytest.raises(NotImplementedError, match="mdp"):
        env.set_attr("mdp", None)
    for method in ("reset", "step", "close"):
        with pytest.raises(NotImplementedError, match=method):
            env.env_method(method)
    env.close()
    assert env.vector.closed


def test_pictures() -> None:
    """Copies made to be drawn are drawn, side by side in one image."""
    env = copies("Catch", 4, render_mode="rgb_array")
    env.reset()
    images, whole = env.get_images(), env.render()
    assert len(images) == 4
    assert whole.shape == (2 * images[0].shape[0], 2 * images[0].shape[1], 3)
    human = copies("Catch", 2, render_mode="human")
    human.reset()
    assert human.render() is None
    human.close()


def test_one_s_own_environment() -> None:
    """An environment or a vector environment can be given instead of a name."""
    assert copies(CATCH).num_envs == 1
    assert copies(CATCH, 7).reset().shape == (7, 10, 5)
    vector = MDPVectorEnv(CATCH, 5, "SameStep")
    assert copies(vector).vector is copies(vector, 5).vector is vector


def test_without_stable_baselines3(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where Stable-Baselines3 is missing the error says what to install."""
    monkeypatch.delitem(sys.modules, "edugym.deep.vec_env")
    monkeypatch.setitem(sys.modules, "stable_baselines3", None)
    monkeypatch.setitem(sys.modules, "stable_baselines3.common.vec_env.base_vec_env", None)
    with pytest.raises(DependencyNotInstalled, match=r"edugym\[deep\]"):
        copies("Catch")


def test_dqn_knows_a_time_limit_from_an_end() -> None:
    """In the memory of a DQN agent exactly the episodes that were cut off are marked as cut off."""
    env = copies("MemoryCorridor", 2, num_doors=2, max_steps=2)
    model = DQN("MlpPolicy", env, learning_starts=100, buffer_size=400, seed=0, device="cpu")
    model.learn(400)
    memory: Any = model.replay_buffer
    assert memory.full
    cut_off, over, right = memory.timeouts == 1, memory.dones == 1, memory.rewards == 1
    assert (over & ~right == over & ~cut_off).all()  # a wrong door, and nothing else, is an end
    assert 0 < cut_off.sum() < over.sum()
    assert (cut_off <= over).all()


@pytest.mark.slow
def test_a_recurrent_agent_learns_in_the_way_that_the_docstring_says() -> None:
    """RecurrentPPO takes Golf as its copies are made there, and only so."""
    says = re.search(r"`(make_vec_env\(.+\))`", str(stable_baselines3_env.__doc__))
    assert says is not None
    flat = eval(says[1], {"make_vec_env": make_vec_env, "gymnasium": gymnasium})
    few: dict[str, Any] = {"n_steps": 32, "batch_size": 32, "n_epochs": 1, "seed": 0, "device": "cpu"}
    model = RecurrentPPO("MlpLstmPolicy", flat, **few)
    before = [weights.tolist() for weights in model.policy.parameters()]
    assert model.learn(64).num_timesteps == 64
    assert [weights.tolist() for weights in model.policy.parameters()] != before
    with pytest.raises(TypeError, match="input_size should be of type int"):
        RecurrentPPO("MlpLstmPolicy", copies("Golf"), **few)


WRONG: list[tuple[Any, tuple[Any, ...], dict[str, Any], str]] = [
    *((wrong, (), {}, "environment must be") for wrong in (None, 3, Boulder)),
    (gymnasium.make("edugym/Catch-v0", max_episode_steps=3), (), {}, "must have no wrapper that changes it"),
    ("CartPole-v1", (), {}, named("environment", "Boulder", "'CartPole-v1'")),
    ("Supermarket", (4,), {"step_timeout": 0.1}, "and no more, such as waiting, but .*use .*DummyVecEnv"),
    ("Catch", (2,), {"rows": 1}, named("rows", 2, 1000, 1)),
    ("Catch", (0,), {}, "num_envs"),
    (CATCH, (), {"rows": 3}, r"parameters .* \{'rows': 3\}"),
    *((MDPVectorEnv(CATCH, 2, mode), (), {}, named("autoreset_mode", mode)) for mode in ("NextStep", "Disabled")),
    (MDPVectorEnv(CATCH, 2, "SameStep"), (3,), {}, r"num_envs must be 2, .* but is 3"),
]


def test_what_does_not_fit_is_refused() -> None:
    """With a sentence that says so; wrong steps as in a single environment."""
    for environment, arguments, parameters, message in WRONG:
        with pytest.raises(ValueError, match=message):
            copies(environment, *arguments, **parameters)
    env = copies("Catch", 2)
    with pytest.raises(ResetNeeded):
        env.step(np.array([0, 0]))
    env.reset()
    with pytest.raises(ValueError, match="not in the action space"):
        env.step(np.array([0, 3]))
