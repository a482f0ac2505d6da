"""What an agent knows of a place in the picture for which it has no row of a table.

A table of Catch's positions can be drawn into the picture as it is. A network has no rows, and rows of a hashed table
mean nothing by themselves. So around the task notes are taken: how often each place was seen, and what to ask the agent
about it.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from vectors import Informed

from edugym.adapters.columns import RowsInPlace
from edugym.adapters.fitting import tabular
from edugym.agents.features import linear_values
from edugym.checks.contract import Contract
from edugym.mdp.in_place import blank, in_place
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.wrapper import wrapper


@wrapper
class Noted(NamedTuple):
    """A task around which notes are taken. It is the same task: nothing is drawn for them.

    Attributes:
        mdp: the task.
        places: the same task, observed as a place.
        visits: shape (1, n_places): how often each was seen.
        place: shape (1,): the latest.
        known: the notes on what to ask, `Boards`, `Rows` or `Scores`.
    """

    mdp: Any
    places: Any
    visits: Integers
    place: Integers
    known: Any

    def observation(self, state: Any, rng: Random) -> int:
        """Observe, and take notes."""
        seen: int = self.mdp.observation(state, rng)
        place = self.places.observation(state, rng)
        self.known.note(place, seen, state, rng)
        self.visits[0, place] += 1
        self.place[0] = place
        return seen


class Network(NamedTuple):
    """Asks a network."""

    agent: Any

    def look(self, board: Reals) -> None:
        """Compute the action values."""
        self.agent.write_values(board)


class WeightedSum(NamedTuple):
    """Asks an agent whose values are weighted sums."""

    agent: Any

    def look(self, board: Reals) -> None:
        """Compute the action values."""
        linear_values(self.agent.features, self.agent.weights, board, self.agent.Q)


class Boards(NamedTuple):
    """An agent that is asked about the board of a place, without noise.

    Attributes:
        asked: asks the agent, which leaves its answer in `Q`.
        mdp: the task without noise, which observes a board.
        rows: a board for each place.
        flat: the same numbers, a row for each place.
    """

    asked: Any
    mdp: Any
    rows: Any
    flat: Reals

    def note(self, place: int, seen: int, state: Any, rng: Random) -> None:
        """Note the board of a place."""
        self.rows.put(place, self.mdp, state, rng)

    def write(self, place: int, values: Reals) -> None:
        """Write the action values of a place."""
        self.asked.look(self.flat[place])
        for action in range(len(values)):
            values[action] = self.asked.agent.Q[0, action]


class Rows(NamedTuple):
    """A table whose rows are no places: it is asked about the row that was seen last in a place.

    Attributes:
        agent: with the table.
        latest: shape (n_places,): the rows.
    """

    agent: Any
    latest: Integers

    def note(self, place: int, seen: int, state: Any, rng: Random) -> None:
        """Note the row."""
        self.latest[place] = seen

    def write(self, place: int, values: Reals) -> None:
        """Write the action values of a place."""
        for action in range(len(values)):
            values[action] = self.agent.Q[self.latest[place], action]


class Scores(NamedTuple):
    """An agent that looks at a state first, and then has a number for each action.

    Attributes:
        agent: it has `look_at`.
        numbers: shape (1, n_actions): where it leaves them.
    """

    agent: Any
    numbers: Reals

    def note(self, place: int, seen: int, state: Any, rng: Random) -> None:
        """Note nothing: a place is its state."""

    def write(self, place: int, values: Reals) -> None:
        """Write the numbers of a place."""
        self.agent.look_at(place)
        for action in range(len(values)):
            values[action] = self.numbers[0, action]


def write_values(task: Noted, values: Reals) -> None:
    """Write the action values of each place that was seen, shape (n_places, n_actions)."""
    for place in range(len(values)):
        if task.visits[0, place] > 0:
            task.known.write(place, values[place])


def arrays_in(value: Any) -> Iterator[Any]:
    """The arrays in a value and its parts."""
    if isinstance(value, np.ndarray):
        yield value
    elif isinstance(value, tuple):
        for part in tuple.__iter__(value):
            yield from arrays_in(part)


def noted(mdp: Any, places: Any, clean: Any, contract: Contract) -> Noted:
    """The task with notes.

    Args:
        mdp: what the loop plays.
        places: the same task, observed as a place.
        clean: the same task, observed without noise.
        contract: of the agent.
    """
    places = tabular(places)
    n = int(places.observation_space.n)
    agent = contract.agent
    known: Any = Rows(agent, np.zeros(n, np.int64))
    if isinstance(agent, Informed):
        known = Scores(agent.agent, agent.agent.closeness if hasattr(agent.agent, "closeness") else agent.agent.values)
    if contract.takes_vectors:
        asked = Network(agent) if hasattr(agent, "write_values") else WeightedSum(agent)
        clean = in_place(clean)
        boards = np.zeros((n, *blank(clean).shape))
        known = Boards(asked, clean, RowsInPlace(boards), boards.reshape(n, -1))
    return Noted(mdp, places, np.zeros((1, n), np.int64), np.zeros(1, np.int64), known)
