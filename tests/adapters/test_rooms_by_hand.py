"""What is in which room after each call, and which of the loops' numbers the agent and the task are given."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym.adapters.double_buffer import DoubleBuffer
from edugym.adapters.fitting import check_sizes
from edugym.checks.contract import takes_vectors
from edugym.mdp.protocol import Random
from edugym.mdp.task import Task

RNG = np.random.default_rng(0)


class Told(NamedTuple):
    """A task that observes its state, and notes what it is asked.

    Attributes:
        observation_space: of the states.
        action_space: of the actions.
        first: the initial state.
        log: what it was asked.
    """

    observation_space: Any
    action_space: Any
    first: Any
    log: list[Any]

    def initial(self, rng: Random) -> Any:
        """The first state."""
        return self.first

    def transition(self, state: Any, action: Any, rng: Random) -> Any:
        """Note it."""
        self.log.append(("transition", state, np.array(action).tolist(), rng))
        return 7

    def reward(self, state: Any, action: Any, next_state: Any, rng: Random) -> float:
        """Note it."""
        self.log.append(("reward", state, np.array(action).tolist(), next_state, rng))
        return 0.5

    def observation(self, state: Any, rng: Random) -> Any:
        """The state."""
        return state


class ToldInPlace(Told):
    """The same, written into an array."""

    __slots__ = ()

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """The state."""
        out[...] = state


class Hearer:
    """An agent that notes what it is given, and takes it as it is."""

    tabular: Any = False

    def __init__(self, log: list[Any]) -> None:
        """Note it here."""
        self.log = log

    def act(self, state: Any, rng: Random) -> int:
        """Note it."""
        self.log.append(("act", state.tolist(), rng))
        return 3

    def learn(self, *told: Any) -> None:
        """Note it."""
        self.log.append([one.tolist() if isinstance(one, np.ndarray) else one for one in told])


class VectorHearer(Hearer):
    """One that takes vectors."""

    n_inputs = 2


class WritingHearer(VectorHearer):
    """One that writes its actions, which count up."""

    def act_into(self, state: Any, rng: Random, action: Any) -> None:
        """Note it, and write."""
        self.log.append(("act into", state.tolist(), rng))
        action[:] = len(self.log)


PLANE = spaces.Box(-9.0, 9.0, (2,), np.float32)
FORCE = spaces.Box(-9.0, 9.0, (2,), np.float32)
TWO = spaces.Discrete(2)
BOARD = spaces.Box(-9.0, 9.0, (2, 2), np.float32)
PAIR = spaces.Tuple((spaces.Discrete(2, start=5), spaces.Discrete(3, start=-1)))

SEEN: dict[str, Any] = {
    "a vector": (PLANE, [np.array([1.0, 2.0]), np.array([3.0, 4.0])], [[1, 2], [3, 4]]),
    "a tuple of reals": (PLANE, [(1.0, 2.0), (3.0, 4.0)], [[1, 2], [3, 4]]),
    "a number": (spaces.Box(-9.0, 9.0, (), np.float32), [1.5, -2.5], [[1.5], [-2.5]]),
    "a board": (BOARD, [np.array([[1.0, 2.0], [3.0, 4.0]]), np.ones((2, 2))], [[1, 2, 3, 4], [1, 1, 1, 1]]),
    "a whole number": (spaces.Discrete(3, start=-1), [-1, 1], [[1, 0, 0], [0, 0, 1]]),
    "a pair": (PAIR, [(6, -1), (5, 1)], [[0, 1, 1, 0, 0], [1, 0, 0, 0, 1]]),
    "several": (spaces.MultiDiscrete([2, 3]), [np.array([1, 0]), np.array([0, 2])], [[0, 1, 1, 0, 0], [1, 0, 0, 0, 1]]),
}


@pytest.mark.parametrize("kind", [Told, ToldInPlace])
@pytest.mark.parametrize("name", SEEN)
def test_two_rooms_take_turns(name: str, kind: type[Told]) -> None:
    """An observation is written over the one before the last, as a vector."""
    space, (one, other), (first, second) = SEEN[name]
    view = DoubleBuffer(kind(space, TWO, one, []), VectorHearer([]))
    reader = view.of(VectorHearer([]))
    rooms = [view.mdp.observation(state, RNG) for state in (one, other, one, one, other)]
    assert rooms == [1, 0, 1, 0, 1]
    assert reader.rows.tolist() == [first, second]
    assert view.mdp.observation(other, RNG) == 0
    assert reader.rows.tolist() == [second, second]


def test_an_agent_is_told_what_is_in_the_rooms() -> None:
    """And everything else as it is, in the order of its parameters."""
    mdp = Told(PLANE, TWO, (1.0, 2.0), [])
    for agent, on_policy in ((VectorHearer([]), False), (VectorHearer([]), True)):
        view = DoubleBuffer(mdp, agent, on_policy)
        reader = view.of(agent)
        before, after = view.mdp.observation((1.0, 2.0), RNG), view.mdp.observation((3.0, 4.0), RNG)
        assert reader.act(before, RNG) == 3
        told = (before, 1, 0.25, after, 0, False, True) if on_policy else (before, 1, 0.25, after, False, True)
        reader.learn(*told)
        next_action = [0] if on_policy else []
        assert agent.log == [("act", [1, 2], RNG), [[1, 2], 1, 0.25, [3, 4], *next_action, False, True]]
    assert view.mdp.transition(4, 1, RNG) == 7
    assert view.mdp.reward(4, 1, 5, RNG) == 0.5
    assert mdp.log == [("transition", 4, 1, RNG), ("reward", 4, 1, 5, RNG)]


def test_actions_that_are_written_take_turns_in_rooms() -> None:
    """The task is given what is in the room, and the agent learns from it."""
    mdp, agent = Told(PLANE, FORCE, (1.0, 2.0), []), WritingHearer([])
    view = DoubleBuffer(mdp, agent)
    reader = view.of(agent)
    before, after = view.mdp.observation((1.0, 2.0), RNG), view.mdp.observation((3.0, 4.0), RNG)
    assert [reader.act(before, RNG), reader.act(after, RNG)] == [1, 0]
    assert reader.actions.dtype == np.float32
    assert reader.actions.tolist() == [[2, 2], [1, 1]]
    assert view.mdp.transition(4, 1, RNG) == 7
    assert view.mdp.reward(4, 0, 5, RNG) == 0.5
    assert mdp.log == [("transition", 4, [1, 1], RNG), ("reward", 4, [2, 2], 5, RNG)]
    reader.learn(before, 1, 0.25, after, True, False)
    assert agent.log[:2] == [("act into", [1, 2], RNG), ("act into", [3, 4], RNG)]
    assert agent.log[2:] == [[[1, 2], [1, 1], 0.25, [3, 4], True, False]]


@pytest.mark.parametrize(
    ("actions", "agent", "on_policy"),
    [(TWO, WritingHearer([]), False), (FORCE, VectorHearer([]), False), (FORCE, WritingHearer([]), True)],
)
def test_actions_that_are_handed_on(actions: Any, agent: Any, on_policy: bool) -> None:
    """Those of other agents and tasks are no rooms."""
    view = DoubleBuffer(Told(PLANE, actions, (1.0, 2.0), []), agent, on_policy)
    assert view.of(agent).act(view.mdp.observation((1.0, 2.0), RNG), RNG) == 3


class WithTable(Hearer):
    """An agent with a table."""

    tabular = True


class Silent(Hearer):
    """One that does not say that it has none."""

    tabular = None
    n_inputs = 2


@pytest.mark.parametrize(
    ("kind", "space", "agent"),
    [
        (Told, BOARD, Hearer([])),
        (ToldInPlace, PAIR, Hearer([])),
        (ToldInPlace, BOARD, WithTable([])),
        (ToldInPlace, BOARD, Silent([])),
    ],
)
def test_observations_that_are_handed_on(kind: type[Told], space: Any, agent: Any) -> None:
    """Where the agent takes no vectors, and the task writes nothing or observes no array, or the agent has a table."""
    mdp = kind(space, TWO, np.ones((2, 2)), [])
    view = DoubleBuffer(mdp, agent)
    assert view.mdp is mdp
    assert view.of(agent) is agent
    assert not takes_vectors(agent)


def test_boards_stay_boards() -> None:
    """For an agent that takes what the task shows, in the types of its space."""
    agent, other = Hearer([]), Hearer([])
    view = DoubleBuffer(ToldInPlace(BOARD, TWO, np.ones((2, 2)), []), agent)
    reader = view.of(other)
    assert reader.agent is other
    assert (reader.rows.shape, reader.rows.dtype) == ((2, 2, 2), np.float32)
    reader.act(view.mdp.observation([[1, 2], [3, 4]], RNG), RNG)
    assert other.log == [("act", [[1, 2], [3, 4]], RNG)]


@pytest.mark.parametrize(
    ("actions", "name", "needed"),
    [(TWO, "n_actions", 2), (spaces.Box(0, 1, (3, 2)), "n_actions", 6), (TWO, "n_inputs", 4)],
)
def test_sizes_that_an_agent_has(actions: Any, name: str, needed: int) -> None:
    """Those of the environment, where it has some."""
    mdp = Told(BOARD, actions, None, [])
    task = Task(mdp, mdp, is_mdp=True, is_own=False, max_steps=None)
    for given in (needed - 1, needed + 1):
        agent = type("Agent", (), {name: given})()
        with pytest.raises(ValueError, match=f"agent must be one for {name} = {needed}, .* but its is {given}$"):
            check_sizes(agent, task)
    check_sizes(type("Agent", (), {name: needed})(), task)
    check_sizes(
        type("Agent", (), {"n_actions": 99})(), task._replace(played=Told(BOARD, spaces.MultiBinary(2), None, []))
    )
