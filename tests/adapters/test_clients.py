"""What the users of Gymnasium and its wrappers expect of an environment."""

import pickle
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces, wrappers
from gymnasium.envs.registration import EnvSpec
from gymnasium.wrappers import vector as vector_wrappers

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.registration import ENVIRONMENTS, Entry, find, make_environment, make_mdp
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.contract.parameters import PARAMETERS
from tests.contract.play import every_environment, plain

LIMITED = [entry for entry in ENVIRONMENTS if hasattr(entry.load()().mdp, "max_steps")]


def spec_of(env: Any) -> EnvSpec:
    """The specification of an environment that has one."""
    spec: EnvSpec | None = env.spec
    assert spec is not None
    return spec


@pytest.mark.parametrize("n_bins", [None, 5])
def test_actions_of_trashbot(n_bins: int | None) -> None:
    """Lists and other types of numbers are taken; what is beyond the bounds of a Box is clipped."""
    same: list[Any] = [[0, 1], (0, 1), np.array([0, 1])]
    if n_bins is None:
        same += [[0.0, 1.0], np.array([0.0, 1.0]), np.array([0, 1], np.float16), [0.0, 7.5], [0, 10**9]]
    seen = []
    for action in same:
        env = gymnasium.make("edugym/Trashbot-v0", n_bins=n_bins)
        vector = gymnasium.make_vec("edugym/Trashbot-v0", 2, n_bins=n_bins)
        env.reset(seed=0)
        vector.reset(seed=0)
        step, steps = env.step(action), vector.step([action, action])
        assert plain(list(steps[0])) == plain([step[0], step[0]])
        seen.append(plain(step))
    assert len(set(map(repr, seen))) == 1


def test_clipping_keeps_the_users_array() -> None:
    """The array that was passed stays as it is."""
    env = make_environment("Trashbot")
    env.reset(seed=0)
    action = np.array([3.0, -3.0], np.float32)
    env.step(action)
    assert action.tolist() == [3.0, -3.0]
    assert env.last_action.tolist() == [1.0, -1.0]


@pytest.mark.parametrize("entry", LIMITED, ids=[entry.name for entry in LIMITED])
def test_limit_in_the_specification(entry: Entry) -> None:
    """It is that of the parameters, no wrapper cuts it short, and a wrapper's own lower limit is kept."""
    limited = "steps_per_episode" if entry.name == "Tamagotchi" else "max_steps"
    for limit in (7, 5000):
        parameters: dict[str, Any] = {limited: limit}
        env = gymnasium.make(entry.id, **parameters)
        assert spec_of(env).max_episode_steps == limit
        again = gymnasium.make(EnvSpec.from_json(spec_of(env).to_json()))
        restored = gymnasium.make(pickle.loads(pickle.dumps(spec_of(env))))
        assert spec_of(again).max_episode_steps == spec_of(restored).max_episode_steps == limit
        assert not isinstance(again, wrappers.TimeLimit)
    short = gymnasium.make(entry.id, max_episode_steps=3)
    assert spec_of(short).max_episode_steps == 3
    assert spec_of(gymnasium.make(EnvSpec.from_json(spec_of(short).to_json()))).max_episode_steps == 3
    assert gymnasium.spec(entry.id).max_episode_steps is None


def test_time_aware_observation() -> None:
    """The wrapper finds the limit, whatever the parameters."""
    env = wrappers.TimeAwareObservation(gymnasium.make("edugym/Boulder-v0", max_steps=250), flatten=False)
    assert isinstance(env.observation_space, spaces.Dict)
    assert env.observation_space["time"] == spaces.Box(0, 250, dtype=np.int32)
    env.reset(seed=0)
    for step in range(1, 251):
        observation, *_, truncated, _ = env.step(1)
        assert observation["time"] == [step]
        assert truncated == (step == 250)


@every_environment
def test_thresholds(entry: Entry) -> None:
    """The reward threshold is a return that an agent can reach, and the best one where all is known."""
    env = gymnasium.make(entry.id)
    threshold = spec_of(env).reward_threshold
    assert threshold is not None
    assert isinstance(threshold, float)
    for keywords in ({}, *PARAMETERS[entry.name].finite):
        mdp = entry.load()(**keywords).mdp
        if not PARAMETERS[entry.name].finite or mdp.reward_threshold is None or entry.name == "Golf":
            continue
        assert mdp.reward_threshold == pytest.approx(value_iteration(finite_model(mdp)).start, abs=1e-6), keywords


@pytest.mark.parametrize("name", ["Boulder", "Roadrunner", "Supermarket"])
def test_a_threshold_is_there_where_the_limit_lets_an_agent_reach_it(name: str) -> None:
    """In as many steps as the best episode takes, and not in one less."""
    model, rng = finite_model(make_mdp(name)), np.random.default_rng(0)
    values = value_iteration(model, discount=0.99)  # the best is fast
    state, steps, ended = model.states[model.initial.argmax()], 0, False
    while not ended:
        taken = model.sample(state, int(values.Q[model.row(state)].argmax()), rng)
        state, steps, ended = taken.next_state, steps + 1, taken.terminated
    assert make_mdp(name, max_steps=steps).reward_threshold == pytest.approx(value_iteration(model).start)
    assert make_mdp(name, max_steps=steps - 1).reward_threshold is None


@pytest.mark.parametrize(
    ("name", "parameters", "threshold"),
    [
        ("Boulder", {"height": 3, "max_steps": 2}, None),
        ("Catch", {"observation_type": "vectorised"}, 1.0),
        ("Golf", {}, 0.85),
        ("Golf", {"observe_hits": True}, 0.85),
        ("Golf", {"max_hits": 11}, None),
        ("MemoryCorridor", {"max_steps": 7}, 7.0),
        ("Roadrunner", {"max_speed": 1}, -7.0),  # nine steps, of which the last one pays 1
        ("Roadrunner", {"max_speed": 1, "negative_reward": -3}, -3.0),
        ("Roadrunner", {"stop_zone": 1}, None),
        ("Study", {"action_reward_noise_mean": 0}, 10.0),
        ("Supermarket", {"noise": 5.0}, 95.0),
        ("Tamagotchi", {}, 6600.0),
        ("Tamagotchi", {"tau": 0.02}, None),
        ("Trashbot", {"n_bins": 3}, 3.0),
    ],
)
def test_thresholds_by_hand(name: str, parameters: dict[str, Any], threshold: float | None) -> None:
    """Of the tasks of the docstrings; None where it is not known."""
    assert make_mdp(name, **parameters).reward_threshold == threshold


def test_not_trying_is_the_best_of_some_exams() -> None:
    """Where studying costs more than passing pays."""
    mdp = make_mdp("Study", action_reward_noise_mean=20, layout_seed=2)
    assert mdp.reward_threshold == pytest.approx(mdp.total_days * mdp.action_rewards.max())
    assert mdp.reward_threshold == pytest.approx(value_iteration(finite_model(mdp)).start)


@every_environment
def test_make_vec_with_a_limit(entry: Entry) -> None:
    """`max_episode_steps` truncates, unless the environment's own limit is lower or the episode terminates then."""
    vector = gymnasium.make_vec(entry.id, 3, max_episode_steps=2)
    single = gymnasium.make(entry.id, max_episode_steps=2)
    assert vector.spec is not None
    assert vector.spec.max_episode_steps == spec_of(single).max_episode_steps == 2
    vector.reset(seed=0)
    vector.action_space.seed(0)
    ended = np.zeros(3, np.bool_)
    for step in range(2):
        *_, terminations, truncations, _ = vector.step(vector.action_space.sample())
        assert not (terminations & truncations).any()
        ended |= terminations | truncations
        assert ended.all() or step == 0
    own = gymnasium.make_vec(entry.id, 2, max_episode_steps=-1).unwrapped
    assert isinstance(own, MDPVectorEnv)
    assert own.spec is not None
    assert own.spec.max_episode_steps == spec_of(gymnasium.make(entry.id)).max_episode_steps
    with pytest.raises(ValueError, match="max_episode_steps must be 1 or more, but is 0"):
        gymnasium.make_vec(entry.id, 2, max_episode_steps=0)


@every_environment
def test_keys(entry: Entry) -> None:
    """`gymnasium.utils.play` finds keys for every environment, and actions that it accepts."""
    env = gymnasium.make(entry.id, render_mode="rgb_array")
    keys = env.get_wrapper_attr("get_keys_to_action")()
    assert keys
    assert all(len(key) == 1 and action in env.action_space for key, action in keys.items())


@every_environment
def test_wrappers(entry: Entry) -> None:
    """Gymnasium's own wrappers run on the environment and on copies of it."""
    env = gymnasium.make(entry.id)
    wrapped = wrappers.RecordEpisodeStatistics(wrappers.FlattenObservation(wrappers.ClipReward(env, -1, 1)))
    wrapped.reset(seed=0)
    wrapped.action_space.seed(0)
    for _ in range(30):
        observation, _, terminated, truncated, _ = wrapped.step(wrapped.action_space.sample())
        assert wrapped.observation_space.contains(observation)
        if terminated or truncated:
            wrapped.reset()
    copies = vector_wrappers.RecordEpisodeStatistics(gymnasium.make_vec(entry.id, 4))
    copies.reset(seed=0)
    copies.action_space.seed(0)
    for _ in range(30):
        copies.step(copies.action_space.sample())


@every_environment
def test_info_holds_plain_and_numpy_values(entry: Entry) -> None:
    """Copies side by side keep them in arrays of numbers: only text becomes objects."""
    copies = gymnasium.make_vec(entry.id, 2, "sync")
    _, infos = copies.reset(seed=0)
    for name, values in infos.items():
        assert values.dtype != object or all(isinstance(value, str) for value in values), name
    copies.close()


def test_can_call_step() -> None:
    """Supermarket tells whether a step would wait."""
    env = make_environment("Supermarket", step_timeout=3000.0)
    assert env.can_call_step()
    env.reset(seed=0)
    assert not env.can_call_step()
    free = make_environment("Supermarket")
    free.reset(seed=0)
    assert free.can_call_step()


def test_environments_that_are_accepted() -> None:
    """Copies are made of an environment, of what `gymnasium.make` gives, or of an MDP; not of what changes it."""
    made: Any = gymnasium.make("edugym/Boulder-v0", height=3)
    for given in (made, made.unwrapped, made.unwrapped.mdp):
        assert MDPVectorEnv(given, 2).mdp.height == 3
    limited: Any = gymnasium.make("edugym/Boulder-v0", max_episode_steps=3)
    with pytest.raises(ValueError, match="must have no wrapper that changes it, but has TimeLimit"):
        MDPVectorEnv(limited, 2)

    class Doubled(MDPEnv[Any]):
        def step(self, action: Any) -> Any:
            observation, reward, *rest = super().step(action)
            return observation, 2 * float(reward), *rest

    with pytest.raises(ValueError, match="env must do in a step what its MDP does"):
        MDPVectorEnv(Doubled(made.unwrapped.mdp), 2)
    waiting = gymnasium.make_vec("edugym/Supermarket-v0", 2, step_timeout=100.0)
    waiting.reset(seed=0)
    waiting.step(np.array([1, 1]))
    with pytest.raises(
        ValueError, match="autoreset_mode must be one of 'NextStep', 'SameStep', 'Disabled', but is 'next"
    ):
        MDPVectorEnv(made, 2, "nextstep")


def test_the_page_for_users_of_the_original() -> None:
    """What it names is there."""
    assert find("Supermarket").id == "edugym/Supermarket-v0"
    assert make_environment("Study").named_actions() == {
        "study": 0,
        "sleep": 1,
        "go out": 2,
        "other 1": 3,
        "other 2": 4,
    }
