"""Training in Gymnasium environments: what wraps or changes an environment is never left out."""

from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import FlattenObservation, TimeLimit, TransformObservation, TransformReward

from edugym import MDPEnv, QLearning, TabularObservation, make_mdp, train
from edugym.envs.boulder import Boulder
from tests.compiled.cells import cell
from tests.training.slips import ENVIRONMENT, STEP, answered, changed, looker
from tests.training.tasks import Ring, tell_tale

BOULDER = "edugym/Boulder-v0"
CLIFF = max(key for key in gymnasium.registry if key.startswith("CliffWalking-v"))


@pytest.mark.parametrize("n_steps", [1_000, 6_000])
def test_an_environment_of_the_package_runs_as_its_mdp(n_steps: int) -> None:
    """By its name, its id, made, unwrapped or as an MDP: one and the same run."""
    made = gymnasium.make(BOULDER)
    runs = []
    for environment in ("Boulder", BOULDER, f"edugym:{BOULDER}", made, made.unwrapped, make_mdp("Boulder")):
        agent = QLearning.create(make_mdp("Boulder"), initial_value=1.0)
        run = train(environment, agent, n_steps, seed=3)
        runs.append((agent.Q.tobytes(), run.returns.tobytes(), run.episodes.tobytes()))
    assert len(set(runs)) == 1


def test_wrappers_are_not_left_out() -> None:
    """Rewards that are doubled are learned, and measured, as doubled; what all look alike has one row."""
    plain = gymnasium.make(BOULDER, height=2)
    doubled = TransformReward(gymnasium.make(BOULDER, height=2), lambda reward: 2 * float(reward))
    blind = TransformObservation(gymnasium.make(BOULDER, height=2), lambda observation: 0, plain.observation_space)
    one, two, blinded = (train(env, QLearning.create(plain), 1_000) for env in (plain, doubled, blind))
    assert pytest.approx(2 * one.agent.Q) == two.agent.Q
    assert (one.returns[-1], two.returns[-1]) == (1.0, 2.0)
    assert two.training_returns[-1] == 2 * one.training_returns[-1]
    assert blinded.agent.Q[0].any()
    assert not blinded.agent.Q[1:].any()


def test_what_a_wrapper_returns_is_checked() -> None:
    """As what a student's environment returns; the wrapper is named where it is around a task of the package."""
    agent = QLearning.create(make_mdp("Boulder"))
    for env in (gymnasium.make(BOULDER), MDPEnv(make_mdp("Boulder"))):
        noisy = TransformReward(env, lambda _: np.nan)
        below: Any = TransformObservation(env, lambda seen: seen - 1, None)
        answered("step TransformReward reward nan", lambda: train(noisy, agent, 300))  # noqa: B023
        answered("reset TransformObservation Discrete(", lambda: train(below, agent, 300))  # noqa: B023


def test_training_is_checked_where_evaluation_meets_no_mistake() -> None:
    """The greedy action is right, and the one that is taken in training is not."""
    env = cell(changed(ENVIRONMENT, STEP, "return self.place, -1.0, None if action else False, False, {}"))["Line"]()
    answered(
        "step Line terminated None", lambda: train(env, looker("False\n    def greedy(self, state, rng): return 0"), 30)
    )


def test_checks_are_taken_away() -> None:
    """From inside the package's wrappers, after an error, too."""
    inner = gymnasium.make("FrozenLake-v1")
    seen: list[Any] = []
    for env in (TabularObservation(inner), FlattenObservation(inner)):
        agent: Any = tell_tale()._replace(Q=np.zeros((16, 4)))
        train(env, agent if isinstance(env, TabularObservation) else looker(), 3)
        seen.append(env.env)
    assert seen == [inner, inner]
    broken = TabularObservation(TransformReward(inner, lambda _: np.nan))
    with pytest.raises(ValueError, match="reward"):
        train(broken, tell_tale()._replace(Q=np.zeros((16, 4))), 3)
    assert type(broken.env) is TransformReward


CHANGED = """
import gymnasium
from edugym import MDPEnv
class Generous(MDPEnv):
    def step(self, action):
        observation, reward, *rest = super().step(action)
        return observation, reward + 1.0, *rest

class High(MDPEnv):
    def reset(self, *, seed=None, options=None):
        _, info = super().reset(seed=seed, options=options)
        self.state = 1
        return 1, info

class Lamp(gymnasium.Env):
    is_on, action_space = False, spaces.Discrete(2)
    def __init__(self, in_pair):
        lamp = spaces.Discrete(2)
        self.in_pair, self.observation_space = in_pair, spaces.Tuple((lamp, lamp)) if in_pair else lamp
    def seen(self): return (self.is_on, 1) if self.in_pair else self.is_on
    def reset(self, *, seed=None, options=None):
        self.is_on = False
        return self.seen(), {}
    def step(self, action):
        self.is_on = self.is_on != bool(action == 1)
        return self.seen(), float(self.is_on), False, False, {}
"""
Generous, High, Lamp = (cell(CHANGED)[name] for name in ("Generous", "High", "Lamp"))
"""Every step pays 1 more; the climb starts at height 1; a flag, alone or beside a number, that action 1 switches."""


def test_a_students_own_step_and_reset_are_not_left_out() -> None:
    """A subclass of an environment is trained in as it is, not as the MDP inside it."""
    assert train(Generous(Boulder.create(height=4, max_steps=5)), tell_tale(), 10).training_returns[-1] == 5.0
    high = QLearning.create((3, 2), initial_value=1.0)
    train(High(Boulder.create(height=2, max_steps=1)), high, 1_000)
    assert abs(high.Q[1] - 1.0).max() > 0.005
    assert high.Q[0].tolist() == [1.0, 1.0]  # no step was ever taken from the ground


@pytest.mark.parametrize(
    ("make", "measured"),
    [
        (lambda: gymnasium.make(CLIFF, max_episode_steps=None), -1_000),
        (lambda: gymnasium.make(CLIFF, max_episode_steps=2_500), -2_500),
        (lambda: gymnasium.Wrapper(MDPEnv(Ring(2_000))), 2_000),
    ],
)
def test_evaluation_lasts_as_long_as_the_environment_says(make: Any, measured: int) -> None:
    """Up for ever costs 1 a step; without a limit it is cut off after a thousand."""
    agent = tell_tale()._replace(Q=np.zeros((48, 4)))
    assert train(make(), agent, 1).returns.tolist() == [measured, measured]


def test_what_truncates() -> None:
    """Gymnasium's wrapper, of 3 steps, around a task of at most 40; and `max_steps`, training and evaluation."""
    agent = tell_tale()
    assert train(TimeLimit(gymnasium.make(BOULDER, height=4), 3), agent, 300).episodes.sum() == 100
    assert agent.told.tolist() == [300, 0, 100, 0]
    agent = tell_tale()._replace(Q=np.zeros((48, 4)))
    run = train(CLIFF, agent, 100, max_steps=20, evaluate_every=50)
    assert agent.told.tolist() == [100, 0, 5, 0]
    assert run.returns.tolist() == [*run.training_returns[1:].tolist(), -20.0] == [-20.0] * 3
    assert run.episodes.tolist() == [0, 2, 3]


Looks = cell("""
class Looks(NamedTuple):
    seen: np.ndarray
    tabular = False
    def act(self, state, rng):
        self.seen[0] = max(self.seen[0], abs(state[0]))
        return 1
    def learn(self, state, action, reward, next_state, terminated):
        self.seen[1] = max(self.seen[1], abs(next_state[1]))
""")["Looks"]


@pytest.mark.parametrize("environment", ["CartPole-v1", "edugym/Golf-v0"])
def test_an_agent_without_a_table_sees_observations_as_they_are(environment: str) -> None:
    """Arrays and tuples, where `tabular` is False."""
    agent = Looks(np.zeros(2))
    train(environment, agent, 200)
    assert (agent.seen > 0).all()


@pytest.mark.parametrize(("in_pair", "off", "on"), [(False, 0, 1), (True, 1, 3)])
def test_a_flag_is_a_number_of_an_environment(in_pair: bool, off: int, on: int) -> None:
    """Gymnasium counts True as an element of Discrete(2); the agent gets the number of a row, and learns the switch."""
    env = Lamp(in_pair)
    agent = train(env, QLearning.create(env, discount=0.5), 2_000, max_steps=10).agent
    assert agent.Q[off, 1] > agent.Q[off, 0]
    assert agent.Q[on, 0] > agent.Q[on, 1]
