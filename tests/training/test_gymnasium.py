"""Training in Gymnasium environments: what wraps or changes an environment is never left out."""

import re
from collections.abc import Callable
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import TimeLimit, TransformObservation, TransformReward

from edugym import QLearning, make_mdp, train
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.envs.boulder import Boulder
from edugym.mdp.protocol import Random
from tests.training.tasks import SlipperyWalk, Stairs, StudentsQLearning, StudentsSarsa, tell_tale


def cliff_walking() -> str:
    """The id of the newest version that this Gymnasium has."""
    return max(key for key in gymnasium.registry if key.startswith("CliffWalking-v"))


@pytest.mark.parametrize("n_steps", [1_000, 10_000])
def test_an_environment_of_the_package_runs_as_its_mdp(n_steps: int) -> None:
    """By its id, made, unwrapped or as an MDP: one and the same run."""
    made = gymnasium.make("edugym/Boulder-v0")
    runs = []
    for environment in ("edugym/Boulder-v0", made, made.unwrapped, make_mdp("Boulder")):
        agent = QLearning.create(make_mdp("Boulder"), initial_value=1.0)
        run = train(environment, agent, n_steps, seed=3)
        runs.append((agent.Q.tobytes(), run.returns.tobytes(), run.episodes.tobytes()))
    assert len(set(runs)) == 1


@pytest.mark.parametrize("n_steps", [1_000, 6_000])
def test_a_wrapper_is_not_left_out(n_steps: int) -> None:
    """Rewards that are doubled are learned, and measured, as doubled."""
    plain, doubled = (
        gymnasium.make("edugym/Boulder-v0", height=2),
        TransformReward(gymnasium.make("edugym/Boulder-v0", height=2), lambda reward: 2 * float(reward)),
    )
    agents = [QLearning.create(plain), QLearning.create(plain)]
    one, two = (train(env, agent, n_steps) for env, agent in zip((plain, doubled), agents, strict=True))
    assert pytest.approx(2 * agents[0].Q) == agents[1].Q
    assert (one.returns[-1], two.returns[-1]) == (1.0, 2.0)
    assert two.training_returns[-1] == 2 * one.training_returns[-1]


def test_what_an_observation_wrapper_shows_is_what_is_learned_from() -> None:
    """All heights look like height 0: only the first row of the table changes."""
    env = gymnasium.make("edugym/Boulder-v0", height=2)
    blind = TransformObservation(env, lambda observation: 0, env.observation_space)
    agent = QLearning.create(blind)
    train(blind, agent, 1_000)
    assert agent.Q[0].any()
    assert not agent.Q[1:].any()


class Sometimes(gymnasium.RewardWrapper[Any, Any]):
    """A student's wrapper with a return that is missing."""

    def reward(self, reward: Any) -> Any:
        """Double it, if there is one."""
        return 2 * reward if reward else None


def test_what_a_wrapper_returns_is_checked() -> None:
    """As what a student's environment returns, also where it is wrapped around a task of the package."""
    agent = QLearning.create(make_mdp("Boulder"))
    wrapped: dict[str, Callable[[Any], Any]] = {
        "step of Sometimes must return a finite number as reward, but returned None": Sometimes,
        "step of TransformReward must return a finite number": lambda env: TransformReward(env, lambda _: np.nan),
        "reset of TransformObservation must return an observation in Discrete": lambda env: TransformObservation(
            env, lambda seen: seen - 1, None
        ),
    }
    for says, wrap in wrapped.items():
        for env in (wrap(gymnasium.make("edugym/Boulder-v0")), wrap(MDPEnv(make_mdp("Boulder")))):
            with pytest.raises(ValueError, match=says):
                train(env, agent, 300)


@pytest.mark.parametrize("returned", [3, (3,), (3, None), [3, {}], (3, {}, 0)], ids=repr)
def test_what_reset_returns_is_checked(returned: Any) -> None:
    """One observation and a dictionary, whatever else is missing, too many or of another type."""

    class Returns(gymnasium.Env[Any, Any]):
        observation_space = action_space = gymnasium.spaces.Discrete(5)

        def reset(self, **options: Any) -> Any:
            return returned

        def step(self, action: int) -> Any:
            return 0, 0.0, False, False, {}

    says = rf"^reset of Returns must return \(observation, info\), but returned {re.escape(repr(returned))}$"
    env = Returns()
    with pytest.raises(ValueError, match=says):
        train(env, QLearning.create(env), 300)


class GenerousBoulder(MDPEnv[Boulder]):
    """A student's change: every step pays 1 more."""

    def step(self, action: Any) -> Any:
        """One step."""
        observation, reward, *rest = super().step(action)
        return observation, float(reward) + 1.0, *rest


class HighBoulder(MDPEnv[Boulder]):
    """A student's change: the climb starts at height 1."""

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> Any:
        """Start."""
        _, info = super().reset(seed=seed, options=options)
        self.state = 1
        return 1, info


def test_a_students_own_step_and_reset_are_not_left_out() -> None:
    """A subclass of an environment is trained in as it is, not as the MDP inside it."""
    agent = tell_tale()
    run = train(GenerousBoulder(Boulder.create(height=4, max_steps=5)), agent, 10)
    assert run.training_returns[-1] == 5.0
    high = QLearning.create((3, 2), initial_value=1.0)
    train(HighBoulder(Boulder.create(height=2, max_steps=1)), high, 6_000)
    assert abs(high.Q[1] - 1.0).max() > 0.005
    assert high.Q[1].max() == pytest.approx(1.0)
    assert high.Q[0].tolist() == [1.0, 1.0]  # no step was ever taken from the ground


def test_a_time_limit_around_an_environment_truncates() -> None:
    """Gymnasium's wrapper, of 3 steps, around a task of at most 40."""
    agent = tell_tale()
    run = train(TimeLimit(gymnasium.make("edugym/Boulder-v0", height=4), 3), agent, 300)
    assert agent.told.tolist() == [300, 0, 100, 0]
    assert run.episodes.sum() == 100


@pytest.mark.parametrize(("limit", "measured"), [(None, 1_000), (2_500, 2_500)])
def test_evaluation_lasts_as_long_as_the_environment_says(limit: int | None, measured: int) -> None:
    """Up for ever costs 1 a step; without a limit it is cut off after a thousand."""
    env = gymnasium.make(cliff_walking(), max_episode_steps=limit)
    agent = tell_tale()._replace(Q=np.zeros((48, 4)))
    assert train(env, agent, 1).returns.tolist() == [-measured, -measured]


def test_max_steps_truncates_training_and_evaluation() -> None:
    """For a Gymnasium environment without a limit of its own."""
    agent = tell_tale()._replace(Q=np.zeros((48, 4)))
    run = train(cliff_walking(), agent, 100, max_steps=20, evaluate_every=50)
    assert agent.told.tolist() == [100, 0, 5, 0]
    assert run.returns.tolist() == [*run.training_returns[1:].tolist(), -20.0] == [-20.0] * 3
    assert run.episodes.tolist() == [0, 2, 3]


class EndsTwice(MDPEnv[Stairs]):
    """An environment that says terminated and truncated at once."""

    def step(self, action: Any) -> Any:
        """One step."""
        observation, reward, terminated, _, info = super().step(action)
        return observation, reward, terminated, terminated, info


def test_an_end_that_is_also_a_limit_is_an_end() -> None:
    """So that nobody bootstraps from it."""
    agent = tell_tale()
    train(EndsTwice(Stairs()), agent, 30)
    assert agent.told.tolist() == [30, 10, 0, 0]


@pytest.mark.parametrize("kind", [StudentsQLearning, StudentsSarsa])
def test_both_loops_are_one(kind: Any) -> None:
    """In a task without chance, the loop for Gymnasium and that for MDPs give the same bits."""
    tables = []
    for wrap in (lambda env: env, gymnasium.Wrapper):
        agent = kind(np.zeros((4, 2)))
        run = train(wrap(MDPEnv(Stairs())), agent, 1_000, max_steps=2, seed=1)
        tables.append((agent.Q, run.training_returns, run.episodes))
    assert tables[0][0].any()
    assert all(np.array_equal(one, other, equal_nan=True) for one, other in zip(*tables, strict=True))


def test_a_gymnasium_run_repeats() -> None:
    """With its seed, also where the environment draws; another seed gives another run."""
    tables = []
    for seed in (1, 1, 2):
        agent = QLearning.create(SlipperyWalk())
        train(gymnasium.Wrapper(MDPEnv(SlipperyWalk())), agent, 1_000, seed=seed)
        tables.append(agent.Q)
    assert np.array_equal(tables[0], tables[1])
    assert not np.array_equal(tables[0], tables[2])


class Memory(NamedTuple):
    """What an agent has seen."""

    seen: Any


class Looks(Memory):
    """An agent that is shown observations as they are."""

    __slots__ = ()
    tabular = False

    def act(self, state: Any, rng: Random) -> int:
        """Note the first number."""
        self.seen[0] = max(self.seen[0], abs(state[0]))
        return 1

    def learn(self, state: Any, action: int, reward: float, next_state: Any, terminated: bool) -> None:
        """Note the second."""
        self.seen[1] = max(self.seen[1], abs(next_state[1]))


@pytest.mark.parametrize("environment", ["CartPole-v1", "edugym/Golf-v0"])
def test_an_agent_without_a_table_sees_observations_as_they_are(environment: str) -> None:
    """Arrays and tuples, where `tabular` is False."""
    agent = Looks(np.zeros(2))
    train(environment, agent, 200)
    assert (agent.seen > 0).all()


def test_what_does_not_fit_a_table_is_refused() -> None:
    """Before anything is trained."""
    with pytest.raises(ValueError, match="a table needs observations that are whole numbers"):
        train("CartPole-v1", QLearning.create((2, 2)), 10)


class Forgets(Looks):
    """The same, without saying that it has no table."""

    __slots__ = ()
    tabular = True


def test_who_forgets_tabular_is_told() -> None:
    """A student's agent for real numbers."""
    with pytest.raises(ValueError, match=r"Box.*: write `tabular = False` in the class Forgets if it takes such obser"):
        train("CartPole-v1", Forgets(np.zeros(2)), 10)


class Lamp(gymnasium.Env[Any, Any]):
    """On or off, as a flag; alone, or beside a number."""

    action_space = gymnasium.spaces.Discrete(2)

    def __init__(self, in_pair: bool) -> None:
        """Show the flag alone, or in a pair."""
        lamp = gymnasium.spaces.Discrete(2)
        self.observation_space: Any = gymnasium.spaces.Tuple((lamp, lamp)) if in_pair else lamp
        self.in_pair, self.is_on = in_pair, False

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[Any, dict[str, Any]]:
        """Off."""
        super().reset(seed=seed)
        self.is_on = False
        return self._seen(), {}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Action 1 switches; every step with the lamp on pays 1."""
        self.is_on = self.is_on != bool(action == 1)
        return self._seen(), float(self.is_on), False, False, {}

    def _seen(self) -> Any:
        return (self.is_on, 1) if self.in_pair else self.is_on


@pytest.mark.parametrize(("in_pair", "off", "on"), [(False, 0, 1), (True, 1, 3)])
def test_a_flag_is_a_number_of_an_environment(in_pair: bool, off: int, on: int) -> None:
    """Gymnasium counts True as an element of Discrete(2); the agent gets the number of a row, and learns the switch."""
    env = Lamp(in_pair)
    agent = train(env, QLearning.create(env, discount=0.5), 2_000, max_steps=10).agent
    assert agent.Q[off, 1] > agent.Q[off, 0]
    assert agent.Q[on, 0] > agent.Q[on, 1]
