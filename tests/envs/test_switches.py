"""Switches: an episode on paper, the exact truth against the distance, and the conventions of goal environments."""

from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given
from hypothesis import strategies as st

from edugym import MDPVectorEnv, finite_model, make_mdp, value_iteration
from edugym.envs.switches import Panel, Switches, SwitchesEnv
from tests.contract.described import NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused

PARAMETERS = Parameters(
    valid=st.fixed_dictionaries({"n_switches": st.integers(1, 62)}, optional={"max_steps": st.integers(1, 60)}),
    corners=({}, {"n_switches": 1, "max_steps": 1}, {"n_switches": 31}, {"n_switches": 2, "max_steps": 2**62}),
    bad=(*refused("n_switches", 0, -1, 63, 10**9, *NO_WHOLE_NUMBER), *refused("max_steps", *NO_STEPS)),
    finite=({"n_switches": 1}, {"n_switches": 3, "max_steps": 2}, {"n_switches": 4}),
    informed=lambda _, env: a_wrong_switch(env),
)


def a_wrong_switch(env: Any) -> int:
    """The first switch that is wrong; switch 0 at the goal."""
    wrong = int(env.state.switches) ^ int(env.state.goal)
    return env.mdp.n_switches - wrong.bit_length() if wrong else 0


def numbers(observation: dict[str, Any]) -> list[list[int]]:
    """What is observed, achieved and wanted."""
    return [observation[name].tolist() for name in ("observation", "achieved_goal", "desired_goal")]


def test_an_episode() -> None:
    """Of three switches 0 and 2 are wrong; the first step errs, and the limit does not count at the goal."""
    env = SwitchesEnv(3, max_steps=4)
    env.reset(seed=0)
    env.state = Panel(0b011, 0b110)
    for action, achieved, distance in ((1, [0, 0, 1], 3), (0, [1, 0, 1], 2), (1, [1, 1, 1], 1)):
        observation, *rest = env.step(action)
        assert numbers(observation) == [achieved, achieved, [1, 1, 0]]
        assert rest == [-1.0, False, False, {"distance": distance, "is_success": False, "steps": env.steps}]
    observation, *rest = env.step(2)
    assert numbers(observation) == [[1, 1, 0]] * 3
    assert rest == [0.0, True, False, {"distance": 0, "is_success": True, "steps": 4}]


@given(st.integers(1, 62), st.integers(0, 2**32), st.data())
def test_a_flip_is_undone_by_a_flip(n: int, seed: int, data: st.DataObject) -> None:
    """It changes the one switch, and the distance by one; the goal stays."""
    mdp, rng = Switches.create(n), np.random.default_rng(seed)
    state, action = mdp.initial(rng), data.draw(st.integers(0, n - 1))
    after = mdp.transition(state, action, rng)
    seen, then = (mdp.observation(one, rng) for one in (state, after))
    assert np.flatnonzero(seen != then).tolist() == [action]
    assert abs(mdp.distance(after) - mdp.distance(state)) == 1
    assert mdp.distance(state) == (seen[:n] != seen[n:]).sum() > 0
    assert mdp.transition(after, action, rng) == state


@pytest.mark.parametrize("discount", [1.0, 0.9])
@pytest.mark.parametrize("n", [1, 2, 5])
def test_the_distance_is_the_exact_truth(n: int, discount: float) -> None:
    """The exact model of all pairs has the values of the docstring, and the best actions are the wrong switches."""
    mdp = make_mdp("Switches", n_switches=n)
    model = finite_model(mdp)
    values = value_iteration(model, discount)
    assert len(model.states) == 4**n
    for row, state in enumerate(model.states):
        d = mdp.distance(state)
        if d == 0:
            continue
        best = -sum(discount**k for k in range(d - 1))
        assert values.Q[row].max() == pytest.approx(best, abs=1e-9)
        wrong = [(state.switches ^ state.goal) >> (n - 1 - k) & 1 for k in range(n)]
        further = [-1 + discount * -sum(discount**k for k in range(d)) if not one else best for one in wrong]
        assert values.Q[row] == pytest.approx(further, abs=1e-9)
    mean = n * 2 ** (n - 1) / (2**n - 1)
    assert np.dot(model.initial, [mdp.distance(state) for state in model.states]) == pytest.approx(mean)
    assert mdp.reward_threshold == pytest.approx(1 - mean)
    assert make_mdp("Switches", n_switches=n, max_steps=10**6).reward_threshold == mdp.reward_threshold
    assert n == 1 or make_mdp("Switches", n_switches=n, max_steps=n - 1).reward_threshold is None


def test_it_is_a_goal_environment() -> None:
    """By the assertions in the documentation of Gymnasium-Robotics, at every step, also where the limit is met."""
    env: Any = gymnasium.make("edugym/Switches-v0", n_switches=3, max_steps=5)
    space = env.observation_space
    assert isinstance(space, spaces.Dict)
    assert set(space.spaces) == {"observation", "achieved_goal", "desired_goal"}
    ends = set()
    for seed in range(40):
        _, info = env.reset(seed=seed)
        over = False
        while not over:
            seen, reward, terminated, truncated, info = env.step(int(env.np_random.integers(3)))
            goals = seen["achieved_goal"], seen["desired_goal"], info
            computed = [
                getattr(env.unwrapped, f"compute_{name}")(*goals) for name in ("reward", "terminated", "truncated")
            ]
            assert computed == [reward, terminated, truncated]
            assert info["is_success"] == terminated
            over = terminated or truncated
        ends.add((terminated, truncated))
    assert ends == {(True, False), (False, True)}


def test_rewards_of_batches() -> None:
    """Of every pair of patterns, in a batch of two axes, as the MDP rewards a step that leads there."""
    env, rng, n = SwitchesEnv(3), np.random.default_rng(0), 3
    patterns = np.array([[k >> 2 & 1, k >> 1 & 1, k & 1] for k in range(8)])
    achieved, desired = (np.array(part) for part in np.broadcast_arrays(patterns[:, None], patterns[None]))
    rewards = env.compute_reward(achieved, desired, [{}] * 8)
    expected = [[env.mdp.reward(Panel(0, g), 0, Panel(s, g), rng) for g in range(8)] for s in range(8)]
    assert (rewards.tolist(), rewards.dtype) == (expected, np.float64)
    assert env.compute_terminated(achieved, desired, {}).tolist() == (rewards == 0).tolist()
    infos = [{"steps": k} for k in range(8)]
    late = env.compute_truncated(patterns, np.zeros_like(patterns), infos)
    assert late.tolist() == [k == env.mdp.max_steps for k in range(8)]
    for wrong in (patterns[:, :2], patterns[:4], 0):
        with pytest.raises(ValueError, match=rf"achieved_goal and desired_goal must be .* last axis is {n}, but are"):
            env.compute_reward(patterns, wrong, {})


def test_copies_show_dictionaries_too() -> None:
    """Arrays with a row for each copy, the last observations of finished episodes included."""
    envs = gymnasium.make_vec("edugym/Switches-v0", 5, n_switches=1, autoreset_mode="SameStep").unwrapped
    assert isinstance(envs, MDPVectorEnv)
    envs.reset(seed=0)
    seen, rewards, terminations, _, infos = envs.step(np.zeros(5, np.int64))
    assert {name: part.shape for name, part in seen.items()} == dict.fromkeys(seen, (5, 1))
    assert (rewards.tolist(), terminations.tolist()) == ([0.0] * 5, [True] * 5)
    assert all(last["achieved_goal"] == last["desired_goal"] for last in infos["final_obs"])
    assert (seen["achieved_goal"] != seen["desired_goal"]).all()


@pytest.mark.parametrize("copies", [0, 4])
def test_replay_in_hindsight_of_stable_baselines3(copies: int) -> None:
    """Its `HerReplayBuffer` fills a memory from the dictionaries, of copies too, and its DQN learns from it."""
    sb3, her = pytest.importorskip("stable_baselines3"), pytest.importorskip("stable_baselines3.her")
    env: Any = gymnasium.make("edugym/Switches-v0", n_switches=4)
    if copies:
        env = pytest.importorskip("edugym.deep").stable_baselines3_env("Switches", copies, n_switches=4)
    agent = sb3.DQN(
        "MultiInputPolicy",
        env,
        replay_buffer_class=her.HerReplayBuffer,
        replay_buffer_kwargs={"n_sampled_goal": 4, "goal_selection_strategy": "future"},
        learning_starts=100,
        train_freq=10,
        batch_size=32,
        policy_kwargs={"net_arch": [16]},
        device="cpu",
        seed=0,
    )
    agent.learn(200)
    assert agent.num_timesteps == 200
    batch = agent.replay_buffer.sample(200)
    after = batch.next_observations
    reached = (after["achieved_goal"] == after["desired_goal"]).all(dim=1)
    assert batch.rewards[:, 0].tolist() == [0.0 if one else -1.0 for one in reached]
    assert 0.2 < float(reached.float().mean()) < 1.0  # the goals of chance alone are reached in few of 200 steps
