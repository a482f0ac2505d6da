"""Other libraries than Stable-Baselines3 take the environments as they are; `make test-clients` installs them."""

import importlib
import math

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import FlattenObservation

from edugym import DQN, ENVIRONMENTS, train
from edugym.adapters.registration import Entry

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]  # their warnings are not ours
EVERY = pytest.mark.parametrize("entry", ENVIRONMENTS, ids=lambda entry: entry.name)


@EVERY
def test_torchrl(entry: Entry) -> None:
    """Its own check of an environment passes, and so does a rollout."""
    pytest.importorskip("torchrl")
    env = importlib.import_module("torchrl.envs.libs.gym").GymWrapper(gymnasium.make(entry.id))
    importlib.import_module("torchrl.envs.utils").check_env_specs(env)
    assert 0 < len(env.rollout(30)) <= 30


@EVERY
def test_tianshou(entry: Entry) -> None:
    """Its vector of two copies plays at random, and its buffer takes each step, with all of `info`."""
    pytest.importorskip("tianshou")
    data = importlib.import_module("tianshou.data")
    env = importlib.import_module("tianshou.env").DummyVectorEnv([lambda: gymnasium.make(entry.id)] * 2)
    buffer = data.VectorReplayBuffer(60, 2)
    seen, _ = env.reset(seed=0)
    for k, space in enumerate(env.action_space):
        space.seed(k)
    for _ in range(30):
        actions = np.array([space.sample() for space in env.action_space])
        following, rewards, terminated, truncated, info = env.step(actions)
        buffer.add(
            data.Batch(
                obs=seen,
                act=actions,
                rew=rewards,
                terminated=terminated,
                truncated=truncated,
                done=terminated | truncated,
                obs_next=following,
                info=data.Batch([*info]),
            )
        )
        ended = np.flatnonzero(terminated | truncated)
        if ended.size:
            following[ended], _ = env.reset(ended)
        seen = following
    sample, _ = buffer.sample(8)
    assert len(buffer) == 60
    assert np.isfinite(sample.rew).all()


def test_rllib() -> None:
    """Its PPO trains on it. It asks for observations in one row."""
    pytest.importorskip("ray.rllib")
    importlib.import_module("ray.tune.registry").register_env(
        "catch", lambda _: FlattenObservation(gymnasium.make("edugym/Catch-v0", rows=5))
    )
    configuration = importlib.import_module("ray.rllib.algorithms.ppo").PPOConfig().environment("catch")
    configuration = configuration.env_runners(num_env_runners=0).training(train_batch_size=500, num_epochs=1)
    algorithm = configuration.debugging(seed=0).build_algo()
    try:
        assert -1 <= algorithm.train()["env_runners"]["episode_return_mean"] <= 1
    finally:
        algorithm.stop()
        importlib.import_module("ray").shutdown()


def test_minigrid() -> None:
    """The other way round: our DQN trains on an environment of MiniGrid."""
    wrappers = pytest.importorskip("minigrid.wrappers")
    env = FlattenObservation(wrappers.ImgObsWrapper(wrappers.FullyObsWrapper(gymnasium.make("MiniGrid-Empty-5x5-v0"))))
    agent = DQN.create(env)
    run = train(env, agent, 1_000, evaluate_every=500, seed=1)
    assert run.steps.tolist() == [0, 500, 1_000]
    assert agent.updates[0] > 0
    assert all(map(math.isfinite, run.returns))
