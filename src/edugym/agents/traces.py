"""Eligibility traces Z(s, a): how much of the next TD error each pair of state and action gets.

In a table most of them would be 0. So only the others are stored, as a list of pairs, and a step costs as much as the
list is long. Where a textbook writes `Z *= gamma * trace_decay`, `Traces.fade` goes through this list.
"""

from typing import Annotated, Any, NamedTuple, Protocol

from edugym.agents.settings import Counter, Table
from edugym.checks.parameters import in_short
from edugym.mdp.protocol import Integers, Reals

NEGLIGIBLE = 1e-9
"""A smaller trace is taken as 0, and leaves the list."""


class Trace(Protocol):
    """How a visit changes the trace of a pair."""

    @property
    def true_online(self) -> float:
        """Whether the update has the terms of the true online box: 1 for yes, 0 for no."""

    def visited(self, trace: float, learning_rate: float) -> float:
        """The trace after a visit, given the faded one before it."""


class Accumulating(NamedTuple):
    """Every visit adds 1: Z(S, A) <- Z(S, A) + 1 (section 12.2)."""

    @property
    def true_online(self) -> float:
        """Whether the update has the terms of the true online box: 1 for yes, 0 for no."""
        return 0.0

    def visited(self, trace: float, learning_rate: float) -> float:
        """One more."""
        return trace + 1.0


class Replacing(NamedTuple):
    """A visit sets it to 1: Z(S, A) <- 1 (sections 12.5 and 12.7)."""

    @property
    def true_online(self) -> float:
        """Whether the update has the terms of the true online box: 1 for yes, 0 for no."""
        return 0.0

    def visited(self, trace: float, learning_rate: float) -> float:
        """1, whatever it was."""
        return 1.0


class Dutch(NamedTuple):
    """In between; exact in true online SARSA(λ): Z(S, A) <- (1 - α) Z(S, A) + 1 (equation 12.11).

    With it the update has the two more terms of the true online box of section 12.7.
    """

    @property
    def true_online(self) -> float:
        """Whether the update has the terms of the true online box: 1 for yes, 0 for no."""
        return 1.0

    def visited(self, trace: float, learning_rate: float) -> float:
        """One more than the share 1 - α of it."""
        return (1.0 - learning_rate) * trace + 1.0


def check_trace(traces: Any) -> None:
    """Check that something is a kind of trace.

    Raises:
        ValueError: it is not.
    """
    if isinstance(traces, type) or not hasattr(traces, "visited"):
        raise ValueError(f"traces must be Accumulating(), Replacing() or Dutch(), but is {in_short(traces)}")


class Traces(NamedTuple):
    """The traces that are not 0, as a list of pairs in no particular order.

    Attributes:
        n: shape (1,): the length of the list; what the next three arrays hold beyond it does not count.
        states: shape (n_states * n_actions,): the state of each pair in the list.
        actions: shape (n_states * n_actions,): its action.
        values: shape (n_states * n_actions,): its trace.
        places: shape (n_states, n_actions): where each pair is in the list, from 1; 0 for one that is not in it.
        next_value: shape (1,): Q(S', A') as the last update had it, the Q_old of the next one (for Dutch traces).
    """

    n: Counter
    states: Annotated[Integers, Table(("pairs",))]
    actions: Annotated[Integers, Table(("pairs",))]
    values: Annotated[Reals, Table(("pairs",))]
    places: Annotated[Integers, Table(("states", "actions"))]
    next_value: Annotated[Reals, Table((1,))]

    def value(self, state: int, action: int) -> float:
        """Z(s, a)."""
        place = self.places[state, action]
        return float(self.values[place - 1]) if place > 0 else 0.0

    def put(self, state: int, action: int, value: float) -> None:
        """Set Z(s, a)."""
        place = self.places[state, action]
        if place == 0:
            self.n[0] += 1
            place = self.n[0]
            self.states[place - 1] = state
            self.actions[place - 1] = action
            self.places[state, action] = place
        self.values[place - 1] = value

    def fade(self, factor: float) -> None:
        """Multiply all traces by a factor, γλ, and take those that become negligible off the list."""
        for k in range(self.n[0] - 1, -1, -1):
            self.values[k] *= factor
            if self.values[k] < NEGLIGIBLE:
                last = self.n[0] - 1  # the last pair of the list fills the gap
                self.places[self.states[k], self.actions[k]] = 0
                if k < last:
                    self.states[k], self.actions[k] = self.states[last], self.actions[last]
                    self.values[k] = self.values[last]
                    self.places[self.states[k], self.actions[k]] = k + 1
                self.n[0] = last

    def clear(self) -> None:
        """Set all traces to 0."""
        for k in range(self.n[0]):
            self.places[self.states[k], self.actions[k]] = 0
        self.n[0] = 0
