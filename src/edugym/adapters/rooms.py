"""Observations that are arrays stay where they are: the loops pass on in which of two rooms one is, not the array.

The MDP writes what it shows into one room and then the other, and the agent looks it up there; and so with actions that
are arrays, the other way round. So the loops handle nothing but numbers, no array is made at any step, and machine code
needs no reference counts.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.adapters.columns import RowsInPlace, observation_rows
from edugym.adapters.fitting import takes_vectors
from edugym.checks.mdps import innermost
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.sizes import table_lows, table_sizes, vector_length
from edugym.mdp.wrapper import wrapper


@wrapper
class InRooms(NamedTuple):
    """An MDP that puts its observations into rooms, and shows the number of the room.

    Attributes:
        mdp: the task.
        rows: two rooms, and how an observation is written into one (see `edugym.adapters.columns`).
        latest: shape (1,): the room of the latest observation.
        actions: shape (2, ...): rooms for actions.
    """

    mdp: Any
    rows: Any
    latest: Integers
    actions: Any

    def observation(self, state: Any, rng: Random) -> int:
        """Put what the task shows into the room that has waited longer."""
        room = 1 - int(self.latest[0])
        self.rows.put(room, self.mdp, state, rng)
        self.latest[0] = room
        return room


class ActionsInRooms(InRooms):
    """The same for an agent that puts its actions into rooms, too."""

    __slots__ = ()

    def transition(self, state: Any, action: int, rng: Random) -> Any:
        """Do what is in a room."""
        return self.mdp.transition(state, self.actions[action], rng)

    def reward(self, state: Any, action: int, next_state: Any, rng: Random) -> Any:
        """The reward for what is in a room."""
        return self.mdp.reward(state, self.actions[action], next_state, rng)


class AnyReader(NamedTuple):
    """An agent that is told the number of a room, and looks up what is in it; how it learns is added below.

    Attributes:
        agent: the agent, in the form that the loops ask for.
        rows: shape (2, ...): the rooms of the MDP that it plays.
        latest: shape (1,): the room of its latest action.
        actions: shape (2, ...): rooms for actions.
    """

    agent: Any
    rows: Any
    latest: Integers
    actions: Any

    def act(self, state: int, rng: Random) -> Any:
        """The agent's action."""
        return self.agent.act(self.rows[state], rng)


class Reader(AnyReader):
    """One that learns from what happened."""

    __slots__ = ()

    def learn(self, state: int, action: Any, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Let the agent learn."""
        self.agent.learn(self.rows[state], action, reward, self.rows[next_state], terminated, truncated)


class OnPolicyReader(AnyReader):
    """One that learns from the action it will take next, too."""

    __slots__ = ()

    def learn(
        self,
        state: int,
        action: Any,
        reward: float,
        next_state: int,
        next_action: Any,
        terminated: bool,
        truncated: bool,
    ) -> None:
        """Let the agent learn."""
        self.agent.learn(self.rows[state], action, reward, self.rows[next_state], next_action, terminated, truncated)


class ReaderAndWriter(AnyReader):
    """One for agents that write their actions into an array (`act_into`)."""

    __slots__ = ()

    def act(self, state: int, rng: Random) -> int:
        """Put the agent's action into the room that has waited longer."""
        room = 1 - int(self.latest[0])
        self.agent.act_into(self.rows[state], rng, self.actions[room])
        self.latest[0] = room
        return room

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Let the agent learn."""
        before, after = self.rows[state], self.rows[next_state]
        self.agent.learn(before, self.actions[action], reward, after, terminated, truncated)


class OneHotRow(NamedTuple):
    """Rows for whole numbers: 1 in the place of the number, else 0, as Gymnasium's `flatten` has it.

    Attributes:
        rows: shape (2, n).
        low: the lowest number.
    """

    rows: Reals
    low: int

    def put(self, i: int, mdp: Any, state: Any, rng: Random) -> None:
        """Observe a state, and write what is seen into the i-th row."""
        for k in range(self.rows.shape[1]):
            self.rows[i, k] = 0.0
        self.rows[i, mdp.observation(state, rng) - self.low] = 1.0


class OneHotRows(NamedTuple):
    """The same for several whole numbers, one after the other.

    Attributes:
        rows: shape (2, n): n is the sum of the sizes.
        seen: one row of shape (n_numbers,), for the numbers themselves (see `edugym.adapters.columns`).
        sizes: shape (n_numbers,): how many values each takes.
        lows: shape (n_numbers,): the lowest value of each.
    """

    rows: Reals
    seen: Any
    sizes: Integers
    lows: Integers

    def put(self, i: int, mdp: Any, state: Any, rng: Random) -> None:
        """Observe a state, and write what is seen into the i-th row."""
        for k in range(self.rows.shape[1]):
            self.rows[i, k] = 0.0
        self.seen.put(0, mdp, state, rng)
        first = 0
        for k in range(len(self.sizes)):
            self.rows[i, first + int(self.seen.rows[0, k]) - self.lows[k]] = 1.0
            first += self.sizes[k]


class View:
    """An MDP as an agent sees it: through rooms of its own, where the agent takes vectors or the MDP writes in place.

    Args:
        mdp: the task.
        agent: the agent.
        on_policy: whether it learns from the action that it will take next.
        guard: what puts guards around the task, for an agent, once the task has shown what it observes.

    Attributes:
        mdp: the task for the loops.

    Raises:
        ValueError: the agent takes vectors, and the observations are none.
    """

    def __init__(
        self, mdp: Any, agent: Any, on_policy: bool = False, guard: Callable[[Any, Any], Any] = lambda mdp, _: mdp
    ) -> None:
        """See the class."""
        rows = _rows(mdp, agent)
        self.mdp, self._reader = guard(mdp, agent), None
        if rows is None:
            return
        space = mdp.action_space
        writes = hasattr(agent, "act_into") and isinstance(space, spaces.Box) and not on_policy
        actions = np.zeros((2, *space.shape), space.dtype) if writes else np.zeros((2, 1))
        self.mdp = (ActionsInRooms if writes else InRooms)(self.mdp, rows, np.zeros(1, np.int64), actions)
        self._reader = ReaderAndWriter if writes else OnPolicyReader if on_policy else Reader
        self._rooms = (rows.rows.reshape(2, -1) if takes_vectors(agent) else rows.rows), np.zeros(1, np.int64), actions

    def of(self, agent: Any) -> Any:
        """An agent, in the form that the loops ask for, with this view."""
        return agent if self._reader is None else self._reader(agent, *self._rooms)


def _rows(mdp: Any, agent: Any) -> Any:
    """Rooms for observations as the agent takes them; None where the loops can hand them on as they are."""
    space = mdp.observation_space
    if takes_vectors(agent):
        return _vector_rows(mdp)
    if getattr(agent, "tabular", True) is not False or space.shape is None:
        return None
    kind = observation_rows(mdp, None)
    return kind(np.zeros((2, *space.shape), space.dtype)) if kind is RowsInPlace else None


def _vector_rows(mdp: Any) -> Any:
    """Two rows for the observations of an MDP as vectors.

    Raises:
        ValueError: it does not observe what it says.
    """
    space, rng = mdp.observation_space, np.random.default_rng(0)
    n = vector_length(space)
    sample = mdp.observation(mdp.initial(rng), rng)
    shape = (len(table_sizes(space)),) if space.shape is None else space.shape
    if sample is None or np.shape(sample) != shape:
        raise ValueError(
            f"observation of {type(innermost(mdp)).__name__} must give what its observation_space says, {space}, but"
            f" gave {sample!r}"
        )
    if isinstance(space, spaces.Box):
        return observation_rows(mdp, sample)(np.zeros((2, *(space.shape or (1,))), space.dtype))
    if isinstance(space, spaces.Discrete):
        return OneHotRow(np.zeros((2, n)), int(space.start))
    seen = observation_rows(mdp, sample)(np.zeros((1, *shape), np.int64))
    return OneHotRows(np.zeros((2, n)), seen, np.array(table_sizes(space)), np.array(table_lows(space)))
