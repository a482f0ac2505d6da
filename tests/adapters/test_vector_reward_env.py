"""Vectors as rewards: the same episodes as the MDP's, and the wrappers of MO-Gymnasium."""

import copy
import pickle
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.error import ResetNeeded

import edugym
from edugym.envs.diver import Diver
from edugym.objectives import VectorRewardEnv, exact_front
from tests.exact.graphs import loop

ID = "edugym.objectives:edugym/MODiver-v0"


def test_the_rewards_are_those_of_the_mdp() -> None:
    """And everything else is as in the ordinary environment, at random play from the same seeds."""
    mdp = Diver.create(0.7, weights=(2, 3), max_steps=5)
    env, ordinary, rng = VectorRewardEnv(mdp), edugym.MDPEnv(mdp), np.random.default_rng(0)
    assert (env.reward_dim, env.reward_space) == (2, mdp.reward_space)
    ends = set()
    for seed in range(30):
        seen, told = env.reset(seed=seed)
        assert (seen, str(told)) == (ordinary.reset(seed=seed)[0], str(ordinary.info()))
        over = False
        while not over:
            action = int(rng.integers(2))
            seen, rewards, terminated, truncated, info = env.step(action)
            again, reward, *ended, _ = ordinary.step(action)
            assert (seen, [terminated, truncated]) == (again, ended)
            assert rewards in env.reward_space
            assert float(rewards @ (2.0, 3.0)) == reward
            assert rewards.tolist() == info["vector_reward"].tolist()
            over = terminated or truncated
        ends.add(terminated)
    assert ends == {True, False}


def test_the_front_is_what_is_played() -> None:
    """The actions of each point give its return."""
    env: Any = gymnasium.make(ID, concavity=0.75)
    assert isinstance(env.unwrapped, VectorRewardEnv)
    assert env.spec.reward_threshold is None
    assert env.spec.max_episode_steps == 100
    front = exact_front(env.unwrapped.mdp)
    for point, actions in zip(front.returns, front.actions, strict=True):
        env.reset(seed=0)
        steps = [env.step(action) for action in actions]
        assert sum(step[1] for step in steps).tolist() == point.tolist()
        assert [step[2] for step in steps] == [False] * (len(steps) - 1) + [True]


def test_it_keeps_the_habits_of_an_environment() -> None:
    """Rewards are new arrays; it can be copied and pickled; it draws; it refuses what `MDPEnv` refuses."""
    env = VectorRewardEnv(Diver.create(), render_mode="ansi")
    with pytest.raises(ResetNeeded):
        env.step(0)
    env.reset(seed=0)
    first, second = env.step(1)[1], env.step(1)[1]
    assert first is not second
    for twin in (copy.deepcopy(env), pickle.loads(pickle.dumps(env))):
        assert twin.step(0)[1].tolist() == [0, -1]
        assert twin.render() != env.render()
    with pytest.raises(ValueError, match="action"):
        env.step(9)


@pytest.mark.parametrize("slip", ["one number", "nothing", "too many"])
def test_slips(slip: str) -> None:
    """The step says what is wrong."""
    env = VectorRewardEnv(loop(slip))
    env.reset(seed=0)
    with pytest.raises(ValueError, match=r"what rewards of Graph returns must be an array of numbers of shape \(2,\)"):
        env.step(0)


def test_no_objectives() -> None:
    """An ordinary MDP, or none."""
    for mdp in (edugym.make_mdp("Boulder"), Diver, "Diver", None):
        with pytest.raises(ValueError, match="mdp must"):
            VectorRewardEnv(mdp)


def test_agents_learn_on_the_ordinary_environment() -> None:
    """`train` says that a reward must be one number."""
    env = VectorRewardEnv(Diver.create())
    with pytest.raises(ValueError, match="step of VectorRewardEnv must return a finite number as reward"):
        edugym.train(env, edugym.QLearning.create(env), 100, seed=0)


def test_wrappers_of_mo_gymnasium() -> None:
    """`make`, a weighted sum, the statistics of episodes, and copies in a vector."""
    mo: Any = pytest.importorskip("mo_gymnasium", exc_type=ImportError)
    weights = np.array([1.0, 4.0])
    env = mo.wrappers.LinearReward(mo.make(ID), weight=weights)
    ordinary = gymnasium.make("edugym/Diver-v0", weights=weights.tolist())
    env.reset(seed=0)
    ordinary.reset(seed=0)
    for action in (1, 1, 0, 1, 0, 0, 0):
        reward, *ended, info = env.step(action)[1:]
        assert [reward, *ended] == list(ordinary.step(action)[1:4])
        assert info["vector_reward"] @ weights == reward
        if ended[0]:
            break
    assert ended == [True, False]

    recorded = mo.wrappers.MORecordEpisodeStatistics(mo.make(ID))
    recorded.reset(seed=0)
    recorded.step(1)
    recorded.step(0)
    *_, info = recorded.step(0)
    assert info["episode"]["r"].tolist() == [20.4375, -3.0]

    clipped = mo.wrappers.MOClipReward(mo.make(ID), idx=0, min_r=0, max_r=5)
    clipped.reset(seed=0)
    assert clipped.step(0)[1].tolist() == [5, -1]

    copies = mo.wrappers.vector.MOSyncVectorEnv([lambda: mo.make(ID)] * 3)
    copies.reset(seed=0)
    assert copies.step(np.array([1, 0, 1]))[1].tolist() == [[0, -1], [10, -1], [0, -1]]
