"""What the users of Gymnasium and its wrappers expect of an environment."""

import pickle
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import wrappers
from gymnasium.envs.registration import EnvSpec

from edugym import MDPEnv, MDPVectorEnv, finite_model, make_environment, make_mdp, value_iteration
from edugym.adapters.registration import Entry
from tests.contract.parameters import PARAMETERS
from tests.contract.play import every_environment
from tests.messages import named


def test_limits_in_the_specification() -> None:
    """The limit of the parameters, which no wrapper cuts short; a wrapper's own lower limit is kept."""
    spec: Any = gymnasium.make("edugym/Boulder-v0", max_steps=5000).spec
    copied = EnvSpec.from_json(spec.to_json()), pickle.loads(pickle.dumps(spec))
    made: list[Any] = [*map(gymnasium.make, copied)]
    assert [one.spec.max_episode_steps for one in made] == [spec.max_episode_steps] * 2 == [5000] * 2
    assert not isinstance(made[0], wrappers.TimeLimit)
    short: Any = gymnasium.make("edugym/Boulder-v0", max_episode_steps=3)
    again: Any = gymnasium.make(EnvSpec.from_json(short.spec.to_json()))
    assert short.spec.max_episode_steps == again.spec.max_episode_steps == 3
    assert gymnasium.spec("edugym/Boulder-v0").max_episode_steps is None
    copies: Any = gymnasium.make_vec("edugym/Boulder-v0", 3, max_episode_steps=2)
    copies.reset(seed=0)
    assert copies.spec.max_episode_steps == 2
    assert [copies.step([1, 1, 1])[3].tolist() for _ in range(2)] == [[False] * 3, [True] * 3]
    unlimited: Any = gymnasium.make_vec("edugym/Boulder-v0", 2, max_episode_steps=-1)
    assert unlimited.spec.max_episode_steps == 100
    with pytest.raises(ValueError, match=named("max_episode_steps", 1, 0)):
        gymnasium.make_vec("edugym/Boulder-v0", 2, max_episode_steps=0)


@every_environment
def test_thresholds(entry: Entry) -> None:
    """The reward threshold is a return that an agent can reach, and the best one where all is known."""
    spec = gymnasium.make(entry.id).spec
    assert spec is not None
    assert isinstance(spec.reward_threshold, float)
    finite = PARAMETERS[entry.name].finite
    if not finite or entry.name == "Golf":  # whose threshold is rounded
        return
    unwilling = {"action_reward_noise_mean": 20, "layout_seed": 2}  # with it, trying costs more than passing pays
    for keywords in ({}, *finite, *[unwilling] * (entry.name == "Study")):
        mdp = entry.load()(**keywords).mdp
        if mdp.reward_threshold is not None:
            horizon = mdp.max_steps if PARAMETERS[entry.name].endless else None
            best = value_iteration(finite_model(mdp), horizon=horizon).start
            assert mdp.reward_threshold == pytest.approx(best, abs=1e-6), keywords
        assert mdp.reward_threshold is not None or keywords is not unwilling


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
        ("Boulder", {"height": 3, "max_steps": 2}, None), ("Catch", {"observation_type": "vectorised"}, 1.0),
        ("Golf", {}, 0.85), ("Golf", {"observe_hits": True}, 0.85), ("Golf", {"max_hits": 11}, None),
        ("Roadrunner", {"max_speed": 1}, -7.0),  # nine steps, of which the last one pays 1
        ("Roadrunner", {"max_speed": 1, "negative_reward": -3}, -3.0), ("Roadrunner", {"stop_zone": 1}, None),
        ("MemoryCorridor", {"max_steps": 7}, 7.0), ("Study", {"action_reward_noise_mean": 0}, 10.0),
        ("Supermarket", {"noise": 5.0}, 95.0), ("Trashbot", {"n_bins": 3}, 3.0),
        ("Tamagotchi", {}, 6600.0), ("Tamagotchi", {"tau": 0.02}, None),
    ],
)  # fmt: skip
def test_thresholds_by_hand(name: str, parameters: dict[str, Any], threshold: float | None) -> None:
    """Of the tasks of the docstrings; None where it is not known."""
    assert make_mdp(name, **parameters).reward_threshold == threshold


@every_environment
def test_info_holds_plain_and_numpy_values(entry: Entry) -> None:
    """Copies side by side keep them in arrays of numbers: only text becomes objects."""
    copies = gymnasium.make_vec(entry.id, 2, "sync")
    _, infos = copies.reset(seed=0)
    for name, values in infos.items():
        assert values.dtype != object or all(isinstance(value, str) for value in values), name
        assert not hasattr(dict, name), f"clients make attributes of info: Tianshou then calls {name} as that of a dict"
    copies.close()


def test_environments_that_are_accepted() -> None:
    """Copies are made of an environment, of what `gymnasium.make` gives, or of an MDP; not of what changes it."""
    made: Any = gymnasium.make("edugym/Boulder-v0", height=3)
    for given in (made, made.unwrapped, made.unwrapped.mdp):
        assert MDPVectorEnv(given, 2).mdp == made.unwrapped.mdp

    class Doubled(MDPEnv[Any]):
        def step(self, action: Any) -> Any:
            observation, reward, *rest = super().step(action)
            return observation, 2 * float(reward), *rest

    refused: list[tuple[Any, str]] = [
        (wrappers.TimeLimit(made, 3), "env must have no wrapper that changes it, but has TimeLimit"),
        (Doubled(made.unwrapped.mdp), "env must do in a step what its MDP does"),
        (3, "env must be an MDP, .* but is 3$"),
    ]
    for given, says in refused:
        with pytest.raises(ValueError, match=f"^{says}"):
            MDPVectorEnv(given, 2)
    with pytest.raises(ValueError, match=named("autoreset_mode", "'NextStep'", "'nextstep'")):
        MDPVectorEnv(made, 2, "nextstep")


def test_steps_that_wait() -> None:
    """Supermarket tells whether a step would wait; copies of it do not."""
    env = make_environment("Supermarket", step_timeout=3000.0)
    assert env.can_call_step()
    env.reset(seed=0)
    assert not env.can_call_step()
    free = make_environment("Supermarket")
    free.reset(seed=0)
    assert free.can_call_step()
    copies: Any = gymnasium.make_vec("edugym/Supermarket-v0", 2, step_timeout=3000.0).unwrapped
    assert type(copies.showing(0)) is MDPEnv
