"""Training in an MDP: what a run records, that it can be repeated and stopped, and that watching changes nothing."""

import itertools
import math
import threading
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest

from edugym import SARSA, CountBased, EpsilonGreedy, QLearning, ScheduledEpsilonGreedy, make_mdp, train
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.agents.strategies import LinearDecay
from edugym.mdp.protocol import Random
from edugym.training.run import Run
from edugym.training.train import _Curve
from edugym.training.trainers import EVALUATION_LIMIT, new_log
from tests.training.tasks import SlipperyWalk, Stairs


@pytest.mark.parametrize("n_steps", [10, 6_000])
@pytest.mark.parametrize("kind", [QLearning, SARSA])
@pytest.mark.parametrize("wrapped", [False, True], ids=["MDP", "gymnasium"])
def test_the_curve_by_hand(wrapped: bool, kind: Any, n_steps: int, compiled_at_once: None) -> None:
    """Episodes of three steps that return 6 end after 3, 6, 9, ... steps; interpreted and compiled, in every loop."""
    task = gymnasium.Wrapper(MDPEnv(Stairs())) if wrapped else Stairs()
    run = train(task, kind.create(Stairs()), n_steps, evaluate_every=4)
    assert run.steps.tolist() == [*range(0, n_steps, 4), n_steps]
    assert run.returns.tolist() == [6.0] * len(run.steps)
    assert run.episodes[:3].tolist() == [0, 1, 1]
    assert run.episodes.cumsum().tolist() == [step // 3 for step in run.steps]
    assert math.isnan(run.training_returns[0])
    assert run.training_returns[1:].tolist() == [6.0] * (len(run.steps) - 1)
    assert run.complete


@pytest.mark.parametrize("every", [70, 130, 999, 1_000])
def test_points_are_where_they_should_be(every: int) -> None:
    """However many steps a call of `learn` takes, none goes beyond the next point."""
    run = train(Stairs(), QLearning.create(Stairs()), 3_000, evaluate_every=every)
    assert run.steps.tolist() == [*range(0, 3_000, every), 3_000]


def test_points_where_no_episode_ended_are_nan() -> None:
    """Every second step a point: episodes end in the intervals (2, 4], (4, 6], (8, 10]."""
    run = train(Stairs(), QLearning.create(Stairs()), 10, evaluate_every=2)
    assert run.episodes.tolist() == [0, 0, 1, 1, 0, 1]
    assert np.isnan(run.training_returns).tolist() == [True, True, False, False, True, False]


def test_by_default_there_are_a_hundred_points() -> None:
    """And one at the start; short runs have one for each step."""
    assert train(Stairs(), QLearning.create(Stairs()), 1_000).steps.tolist() == list(range(0, 1_001, 10))
    assert train(Stairs(), QLearning.create(Stairs()), 3).steps.tolist() == [0, 1, 2, 3]


def test_a_point_is_the_mean_of_its_evaluation_episodes() -> None:
    """One random agent, evaluated on many episodes and on one."""
    mdp = SlipperyWalk()
    agent = QLearning.create(mdp, learning_rate=5e-324, exploration=EpsilonGreedy(1.0))
    agent.Q[:, 1] = 1.0  # it goes right, and that is not changed
    many = train(mdp, agent, 1, evaluation_episodes=20_000)
    right = 0.8 / 0.2  # gambler's ruin: 6 comes before 0 with probability (1 - 1/4^s) / (1 - 1/4^6) from s
    success = np.mean([(1 - right**-s) / (1 - right**-6) for s in (2, 3, 4)])
    assert many.returns == pytest.approx([2 * success - 1] * 2, abs=0.02)
    one = train(mdp, agent, 200)
    assert set(np.sign(one.returns)) == {-1.0, 1.0}


class Evaluated:
    """A trainer whose evaluation episodes return 1, 2, 3, ..., two in a call."""

    agent, is_compiled = None, False

    def __init__(self) -> None:
        """Nothing was played."""
        self.asked: list[int] = []
        self.returns, self.log = itertools.count(1.0), new_log()

    def learn(self, at_most: int) -> int:
        """No need."""
        raise NotImplementedError

    def doubts(self, run: Run) -> list[str]:
        """None."""
        return []

    def play_episodes(self, at_most: int) -> list[float]:
        """Two, or one."""
        self.asked.append(at_most)
        return [next(self.returns) for _ in range(min(2, at_most))]


def test_as_many_episodes_as_asked_for() -> None:
    """Five: two, two and one. A point that is stopped on the way is none, and what was counted is for the next."""
    training, curve = Evaluated(), _Curve()
    assert curve.last == -1
    training.log.returns[0], training.log.episodes[0] = 12.0, 3
    curve.measure(0, training, 5, lambda: True)
    assert curve.last == -1
    curve.measure(7, training, 5, lambda: False)
    curve.measure(9, training, 2, lambda: True)
    assert training.asked == [5, 5, 3, 1, 2]
    assert curve.last == 9
    steps, returns, training_returns, episodes = (column.tolist() for column in curve.columns())
    assert (steps, returns, episodes) == ([7, 9], [np.mean([3, 4, 5, 6, 7]), 8.5], [3, 0])
    assert training_returns == pytest.approx([4.0, math.nan], nan_ok=True)


def test_training_returns_include_exploration() -> None:
    """Mean return of the training episodes against an evaluation that does not explore."""
    mdp = make_mdp("Boulder", height=4, max_steps=4)
    run = train(mdp, QLearning.create(mdp, initial_value=1.0), 200_000, evaluate_every=100_000, seed=1)
    assert run.returns[-1] == 1.0
    assert run.training_returns[-1] == pytest.approx(0.95**4, abs=0.01)  # ε/2 of the grips are wrong


def test_a_seed_repeats_a_run_bit_for_bit() -> None:
    """Tables and curve; another seed gives another run."""
    mdp = SlipperyWalk()
    runs = [train(mdp, QLearning.create(mdp), 20_000, seed=seed) for seed in (3, 3, 4)]
    for attribute in ("steps", "returns", "training_returns", "episodes"):
        assert np.array_equal(getattr(runs[0], attribute), getattr(runs[1], attribute), equal_nan=True)
    assert np.array_equal(runs[0].agent.Q, runs[1].agent.Q)
    assert not np.array_equal(runs[0].agent.Q, runs[2].agent.Q)
    assert (runs[0].seed, runs[2].seed) == (3, 4)


class Wanderer(NamedTuple):
    """An agent that has no `greedy`, and changes whenever it acts."""

    Q: Any
    exploration: Any

    def act(self, state: int, rng: Random) -> int:
        """Explores less and less."""
        action: int = self.exploration.choose(self.Q, state, rng)
        return action

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """The mean reward."""
        self.Q[state, action] += 0.1 * (reward - self.Q[state, action])


@pytest.mark.parametrize("n_steps", [3_000, 9_000])
@pytest.mark.parametrize("kind", ["with greedy", "without greedy"])
def test_evaluating_changes_nothing(kind: str, n_steps: int) -> None:
    """However often and however long the agent is evaluated, it learns the same."""
    mdp, agents = SlipperyWalk(), []
    for evaluate_every, evaluation_episodes in ((n_steps, 1), (100, 1), (1_000, 7)):
        exploration = ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.0, 2_000))
        if kind == "with greedy":
            agent: Any = QLearning.create(mdp, exploration=exploration)
        else:
            agent = Wanderer(np.zeros((7, 2)), exploration)
        train(mdp, agent, n_steps, evaluate_every=evaluate_every, evaluation_episodes=evaluation_episodes)
        agents.append(agent)
    for agent in agents[1:]:
        assert np.array_equal(agent.Q, agents[0].Q)
        assert agent.exploration.step[0] == agents[0].exploration.step[0] == n_steps


def test_a_task_without_end_or_limit_is_evaluated_all_the_same() -> None:
    """For `EVALUATION_LIMIT` steps."""

    class Endless(Stairs):
        __slots__ = ()

        def transition(self, state: int, action: int, rng: Random) -> int:
            return 1

        def terminal(self, state: int) -> bool:
            return False

    run = train(Endless(), QLearning.create(Endless()), 10)
    assert run.returns.tolist() == [float(EVALUATION_LIMIT)] * 11
    assert run.episodes.sum() == 0


def test_tables_change_in_place_and_training_can_go_on() -> None:
    """The agent that was given is trained; a second run starts from there."""
    mdp = make_mdp("Boulder", height=3)
    agent = QLearning.create(mdp)
    run = train(mdp, agent, 1_000, seed=0)
    assert run.agent.Q is agent.Q
    before = agent.Q.copy()
    train(mdp, agent, 1_000, seed=1)
    assert not np.array_equal(before, agent.Q)


def test_whole_numbers_will_do_for_settings() -> None:
    """An integer where a float is meant does not change the run."""
    mdp, tables = make_mdp("Boulder", height=3), []
    for one in (1, 1.0):
        agent = CountBased.create(mdp, bonus=one, learning_rate=one, discount=one)
        train(mdp, agent, 6_000)
        tables.append(agent.Q)
    assert np.array_equal(tables[0], tables[1])


def test_stop_ends_a_run_before_it_begins() -> None:
    """With what has been measured."""
    stop = threading.Event()
    stop.set()
    run = train(Stairs(), QLearning.create(Stairs()), 10**12, stop=stop)
    assert (run.steps.tolist(), run.returns.tolist(), run.complete) == ([0], [6.0], False)


@pytest.mark.parametrize("kind", [Stairs, SlipperyWalk])
def test_stop_ends_a_run_on_the_way(kind: Any, compiled_at_once: None) -> None:
    """Set by another thread, while this one is busy with machine code; nothing is warned of."""
    train(kind(), QLearning.create(kind()), 10_000)  # compiled now, so that the time is that of the run
    stop = threading.Event()
    timer = threading.Timer(0.3, stop.set)
    timer.start()
    run = train(kind(), QLearning.create(kind()), 10**12, evaluate_every=10**5, stop=stop)
    timer.join()
    assert not run.complete
    assert run.agent.Q.any()
    assert 0 < len(run.steps) < 10**6


@pytest.mark.parametrize(
    ("parameter", "value", "allowed"),
    [
        ("n_steps", 0, "1 or more"),
        ("n_steps", 1e5, "a whole number"),
        ("n_steps", "10", "a whole number"),
        ("max_steps", 0, "1 or more"),
        ("max_steps", True, "a whole number"),
        ("evaluate_every", 0, "1 or more"),
        ("evaluation_episodes", 0, "1 or more"),
        ("seed", -1, "0 or more"),
        ("seed", None, "a whole number"),
    ],
)
def test_bad_parameters_are_refused(parameter: str, value: Any, allowed: str) -> None:
    """The message names the parameter, its value and what is allowed; nothing has been trained."""
    agent = QLearning.create(Stairs())
    with pytest.raises(ValueError, match=rf"{parameter} must be .*{allowed}.*, but is {value!r}"):
        train(Stairs(), agent, **{"n_steps": 10, parameter: value})
    assert not agent.Q.any()
