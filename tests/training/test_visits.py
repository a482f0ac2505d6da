"""Recorded visits: every step once, where and when it was; and recording changes nothing else."""

from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import SARSA, GoExplore, QLearning, make_mdp, record_visits, train
from edugym.objectives import ChebyshevQLearning, ParetoQLearning, train_vectors
from tests.messages import named
from tests.training.tasks import StudentsSarsa

WALL = make_mdp("Boulder", height=6, layout_seed=3)


def sarsa(shape: Any) -> Any:
    """On-policy, and without `greedy`: evaluated as it acts."""
    return StudentsSarsa(np.zeros((7, 2)))


class Decaying(NamedTuple):
    """Explores less and less, counting as it acts, also where it is evaluated: it has no `greedy`."""

    Q: Any
    acted: Any

    def act(self, state: Any, rng: Any) -> Any:
        """Explore at first."""
        self.acted[0] += 1
        if rng.random() < 10 / (10 + self.acted[0]):
            return rng.integers(2)
        return rng.choice(np.flatnonzero(self.Q[state] == self.Q[state].max()))

    def learn(self, state: Any, action: Any, reward: Any, next_state: Any, terminated: Any) -> None:
        """As Q-learning does."""
        target = reward if terminated else reward + 0.9 * self.Q[next_state].max()
        self.Q[state, action] += 0.1 * (target - self.Q[state, action])


class Idle(NamedTuple):
    """Acts at random, and forgets what it has computed."""

    Q: Any

    def act(self, state: Any, rng: Any) -> Any:
        """Either action."""
        return rng.integers(2)

    def learn(self, state: Any, action: Any, reward: Any) -> Any:
        """Change nothing."""
        return self.Q[state, action] + 0.1 * reward


def decaying(shape: Any) -> Any:
    """One that counts how often it has acted."""
    return Decaying(np.zeros((7, 2)), np.zeros(1, np.int64))


@pytest.mark.parametrize("n_steps", [1_000, pytest.param(20_000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("make", [QLearning.create, GoExplore.create, sarsa, decaying])
def test_recording_changes_nothing(make: Any, n_steps: int) -> None:
    """The same curve and the same tables, bit for bit: interpreted and compiled, on- and off-policy."""
    agent, watched = make(WALL), make(WALL)
    alone = train(WALL, agent, n_steps, seed=5)
    recorder = record_visits(watched, WALL, n_steps)
    recorded = train(WALL, recorder, n_steps, seed=5)
    assert recorded.returns.tolist() == alone.returns.tolist()
    np.testing.assert_array_equal(recorded.training_returns, alone.training_returns)
    assert (watched.Q == agent.Q).all()
    assert recorder.visits[:, :6].sum() == n_steps


@pytest.mark.parametrize("kind", [ParetoQLearning, partial(ChebyshevQLearning.create, weights=(1.0, 8.0))])
def test_recording_changes_nothing_where_rewards_are_vectors(kind: Any) -> None:
    """The same curve; every step counts, and every treasure."""
    diver = make_mdp("Diver")
    make = getattr(kind, "create", kind)
    recorder = record_visits(make(diver), diver, 300)
    recorded, alone = (train_vectors(diver, one, 300, seed=5) for one in (recorder, make(diver)))
    assert recorded.returns.tolist() == alone.returns.tolist()
    assert recorder.visits.sum() == 300 + len(alone.training_returns)
    with pytest.raises(ValueError, match="train_vectors"):
        train(diver, recorder, 300)


def test_warnings_are_about_the_agent() -> None:
    """As without a recorder around it."""
    with pytest.warns(UserWarning, match="learn of Idle has changed nothing in Q"):
        train(WALL, record_visits(Idle(np.zeros((7, 2))), WALL, 1_000), 1_000, seed=5)


@pytest.mark.parametrize("make", [QLearning.create, sarsa])
def test_every_step_counts_once(make: Any) -> None:
    """In each interval as many visits as steps, and one more for each time the top was reached."""
    recorder = record_visits(make(WALL), WALL, 3_000, n_intervals=6)
    run = train(WALL, recorder, 3_000, evaluate_every=500, seed=2)
    reached = np.nan_to_num(run.training_returns[1:] * run.episodes[1:])  # the return of an episode is 1 at the top
    assert recorder.visits.shape == (6, 7)
    assert recorder.visits[:, 6].tolist() == np.round(reached).tolist()
    assert recorder.visits[:, :6].sum(axis=1).tolist() == [500] * 6


@pytest.mark.parametrize("on_policy", [False, True])
def test_visits_are_where_the_agent_was(on_policy: bool) -> None:
    """A climb by hand: up, up, a fall, and to the top of a wall of two."""
    agent: Any = SARSA.create((3, 2)) if on_policy else QLearning.create((3, 2))
    recorder: Any = record_visits(agent, (3, 2), 4, n_intervals=2)
    next_action = [0] if on_policy else []
    for state, next_state in ((0, 1), (1, 0), (0, 1), (1, 2)):
        recorder.learn(state, 0, 0.0, next_state, *next_action, next_state == 2, False)
    assert recorder.visits.tolist() == [[1, 1, 0], [1, 1, 1]]
    recorder.learn(0, 0, 0.0, 1, *next_action, False, False)  # beyond the steps that were announced
    assert recorder.visits.tolist() == [[1, 1, 0], [2, 1, 1]]
    assert record_visits(agent, (3, 2), 4).visits.shape == (100, 3)
    assert recorder.recorded is agent


@pytest.mark.parametrize(("name", "allowed"), [("n_steps", (1,)), ("n_intervals", (1, 1_000_000))])
def test_wrong_numbers_are_named(name: str, allowed: tuple[int, ...]) -> None:
    """Of steps and intervals there is one or more."""
    with pytest.raises(ValueError, match=named(name, *allowed, 0)):
        record_visits(QLearning.create((3, 2)), (3, 2), **{"n_steps": 10, name: 0})
    assert record_visits(QLearning.create((3, 2)), (3, 2), **{"n_steps": 10, name: 1})
