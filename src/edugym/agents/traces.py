"""Eligibility traces: which pairs of state and action get credit for what happens now."""

from typing import Annotated, Any, NamedTuple, Protocol

from edugym.agents.settings import Counter, Table
from edugym.checks.parameters import in_short
from edugym.mdp.protocol import Integers, Reals

NEGLIGIBLE = 1e-9
"""A trace below this is dropped, so that a step costs as much as there are pairs with a trace, not pairs in all."""


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
    """Refuse what is no kind of trace.

    Raises:
        ValueError: it is none.
    """
    if isinstance(traces, type) or not hasattr(traces, "visited"):
        raise ValueError(f"traces must be Accumulating(), Replacing() or Dutch(), but is {in_short(traces)}")


class Traces(NamedTuple):
    """The pairs that have a trace, in no particular order.

    Attributes:
        n: shape (1,): how many these are.
        states: shape (n_states * n_actions,): the state of each.
        actions: shape (n_states * n_actions,): its action.
        values: shape (n_states * n_actions,): its trace Z.
        places: shape (n_states, n_actions): 1 + the index of a pair in these, 0 for one without a trace.
        next_value: shape (1,): the value that was expected where the episode goes on.
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
        """Multiply all traces by γλ, and drop what is negligible."""
        for k in range(self.n[0] - 1, -1, -1):
            self.values[k] *= factor
            if self.values[k] < NEGLIGIBLE:
                last = self.n[0] - 1  # takes the place of the one that is dropped
                self.places[self.states[k], self.actions[k]] = 0
                if k < last:
                    self.states[k], self.actions[k] = self.states[last], self.actions[last]
                    self.values[k] = self.values[last]
                    self.places[self.states[k], self.actions[k]] = k + 1
                self.n[0] = last

    def clear(self) -> None:
        """Drop all."""
        for k in range(self.n[0]):
            self.places[self.states[k], self.actions[k]] = 0
        self.n[0] = 0
