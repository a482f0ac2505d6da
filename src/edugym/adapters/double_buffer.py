"""A double buffer for observations that are arrays: the loops pass on the number of a slot, 0 or 1, not the array.

The MDP writes its observations into the two slots in turn, and the agent reads them there: a step needs the present
observation and the next. Array actions take the same way back: the agent writes, the MDP reads. So the loops handle
nothing but numbers, no step makes an array, and machine code counts no references.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.adapters.columns import RowsInPlace, observation_rows
from edugym.checks.contract import takes_vectors
from edugym.checks.mdps import innermost
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.tabular import table_lows, table_sizes
from edugym.mdp.task import vector_length
from edugym.mdp.wrapper import wrapper


@wrapper
class BufferedObservations(NamedTuple):
    """An MDP that writes its observations into a buffer, and shows the number of the slot.

    Attributes:
        mdp: the task.
        rows: two slots, and how an observation is written into one (see `edugym.adapters.columns`).
        latest: shape (1,): the slot of the latest observation.
        actions: shape (2, ...): slots for actions.
    """

    mdp: Any
    rows: Any
    latest: Integers
    actions: Any

    def observation(self, state: Any, rng: Random) -> int:
        """Write what the task shows into the older slot."""
        slot = 1 - int(self.latest[0])
        self.rows.put(slot, self.mdp, state, rng)
        self.latest[0] = slot
        return slot


class BufferedActions(BufferedObservations):
    """The same for an agent that writes its actions into a buffer, too."""

    __slots__ = ()

    def transition(self, state: Any, action: int, rng: Random) -> Any:
        """Do what is in a slot."""
        return self.mdp.transition(state, self.actions[action], rng)

    def reward(self, state: Any, action: int, next_state: Any, rng: Random) -> Any:
        """The reward for what is in a slot."""
        return self.mdp.reward(state, self.actions[action], next_state, rng)


class BufferedActor(NamedTuple):
    """An agent that is told the number of a slot, and looks up what is in it; subclasses add how it learns.

    The number is called `state`: the loops call `act` and `learn` of every agent with the same names.

    Attributes:
        agent: the agent, as `contract.learner` returns it.
        rows: shape (2, ...): the slots for observations of the MDP that it plays.
        latest: shape (1,): the slot of its latest action.
        actions: shape (2, ...): slots for actions.
    """

    agent: Any
    rows: Any
    latest: Integers
    actions: Any

    def act(self, state: int, rng: Random) -> Any:
        """The agent's action."""
        return self.agent.act(self.rows[state], rng)


class OffPolicyLearner(BufferedActor):
    """A buffered agent that learns before it chooses its next action."""

    __slots__ = ()

    def learn(self, state: int, action: Any, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Let the agent learn."""
        self.agent.learn(self.rows[state], action, reward, self.rows[next_state], terminated, truncated)


class OnPolicyLearner(BufferedActor):
    """A buffered agent that also learns from the action that it will take next."""

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


class WritingLearner(BufferedActor):
    """A buffered agent that writes its actions into an array (`act_into`)."""

    __slots__ = ()

    def act(self, state: int, rng: Random) -> int:
        """Write the agent's action into the older slot."""
        slot = 1 - int(self.latest[0])
        self.agent.act_into(self.rows[state], rng, self.actions[slot])
        self.latest[0] = slot
        return slot

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


class DoubleBuffer:
    """The buffer between an MDP and an agent, if the agent takes vectors or the MDP writes its observations in place.

    Other agents and MDPs stay as they are: the loops hand on their numbers.

    Args:
        mdp: the task.
        agent: the agent.
        on_policy: whether it learns from the action that it will take next.
        guard: puts guards around the task, for an agent. The rows are made before that, from an observation of the
            task itself: a wrong first one is then refused by a message, not by a guard.

    Attributes:
        mdp: the task for the loops.

    Raises:
        ValueError: the agent takes vectors, and the observations are not vectors.
    """

    def __init__(
        self, mdp: Any, agent: Any, on_policy: bool = False, guard: Callable[[Any, Any], Any] = lambda mdp, _: mdp
    ) -> None:
        """See the class."""
        rows = _rows(mdp, agent)
        self.mdp, self._kind = guard(mdp, agent), None
        if rows is None:
            return
        space = mdp.action_space
        writes = hasattr(agent, "act_into") and isinstance(space, spaces.Box) and not on_policy
        actions = np.zeros((2, *space.shape), space.dtype) if writes else np.zeros((2, 1))
        self.mdp = (BufferedActions if writes else BufferedObservations)(self.mdp, rows, np.zeros(1, np.int64), actions)
        # `writes` implies off-policy: an agent that learns from its next action gets that action itself.
        self._kind = WritingLearner if writes else OnPolicyLearner if on_policy else OffPolicyLearner
        self._slots = (rows.rows.reshape(2, -1) if takes_vectors(agent) else rows.rows), np.zeros(1, np.int64), actions

    def of(self, agent: Any) -> Any:
        """An agent as `contract.learner` returns it, or a policy, made to read and write this buffer."""
        return agent if self._kind is None else self._kind(agent, *self._slots)


def _rows(mdp: Any, agent: Any) -> Any:
    """Slots for observations as the agent takes them; None where the loops can hand them on as they are."""
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
    sizes, lows = (np.array(numbers, np.int64) for numbers in (table_sizes(space), table_lows(space)))
    return OneHotRows(np.zeros((2, n)), seen, sizes, lows)
