"""Features: what a linear agent sees of an observation, and values that are linear in them.

    q̂(s, a, w) = Σ_i x_i(s) w_ia

Few features are not 0 at a time, so only these are listed. Features are a value that an agent holds, like its
exploration: `LinearQLearning.create(environment, features=TileCoding.create(environment))`.

Reference: Sutton and Barto, Reinforcement Learning, 2nd edition, sections 9.4 and 9.5.
"""

from typing import Annotated, Any, NamedTuple, Protocol

from edugym.agents.settings import Counter, Range, Table, new
from edugym.agents.vectors import vector_size
from edugym.checks.parameters import in_short
from edugym.mdp.protocol import Integers, Reals

NO_VECTOR = (
    "state must be a flat vector with a number for each input of the features: in a loop of your own wrap the"
    " environment, gymnasium.wrappers.FlattenObservation(env)"
)


class Features(Protocol):
    """A function from observations to features, x(s), with room for its latest result."""

    @property
    def active(self) -> Integers:
        """Which features of the latest observation are not 0, shape (n,); `n_active` of them count."""

    @property
    def values(self) -> Reals:
        """The values of these features, shape (n,)."""

    @property
    def n_inputs(self) -> int:
        """How many numbers an observation has."""

    @property
    def n_features(self) -> int:
        """How many features there are in all."""

    @property
    def at_once(self) -> int:
        """By what a learning rate is divided: the number of features that are always active together, or 1."""

    @property
    def n_active(self) -> int:
        """How many features of the latest observation are not 0."""

    def see(self, state: Any) -> None:
        """Write the features of an observation, shape (n_inputs,), into `active` and `values`."""


class Identity(NamedTuple):
    """The observation itself, x(s) = s, and a constant.

    Of a whole number this is a 1 in the place of the number: with `constant=0` the agent then learns a table.

    Attributes:
        active: shape (n_inputs + 1,): which features are not 0.
        values: shape (n_inputs + 1,): their values.
        length: shape (1,): how many these are.
        constant: the value of the last feature, which is the same for all observations; 0 for none.
    """

    active: Annotated[Integers, Table(("features",))]
    values: Annotated[Reals, Table(("features",))]
    length: Counter
    constant: Annotated[float, Range(0)] = 1.0

    @property
    def n_inputs(self) -> int:
        """How many numbers an observation has."""
        return len(self.active) - 1

    @property
    def n_features(self) -> int:
        """One for each number, and one for the constant."""
        return len(self.active)

    @property
    def at_once(self) -> int:
        """Learning rates are taken as they are."""
        return 1

    @property
    def n_active(self) -> int:
        """How many are not 0."""
        return int(self.length[0])

    def see(self, state: Any) -> None:
        """List the numbers that are not 0.

        Raises:
            ValueError: the state is no vector with a number for each input.
        """
        if len(state) != len(self.active) - 1:
            raise ValueError(NO_VECTOR)
        n = 0
        for i in range(len(state)):
            if state[i] != 0.0:
                self.active[n] = i
                self.values[n] = state[i]
                n += 1
        if self.constant != 0.0:
            self.active[n] = len(state)
            self.values[n] = self.constant
            n += 1
        self.length[0] = n

    @classmethod
    def create(cls, environment: Any, constant: float = 1.0) -> "Identity":
        """Features for an environment (or the shape (n_inputs, n_actions)).

        Raises:
            ValueError: the constant is negative, or the environment has no observations that are numbers.
        """
        n_inputs, _ = vector_size(environment)
        return new(cls, None, {"constant": constant}, features=n_inputs + 1)


def linear_value(features: Features, weights: Reals, state: Any, k: int) -> float:
    """The value Σ_i x_i(s) w_ik; afterwards the features are those of `state`.

    Args:
        features: of the agent.
        weights: shape (n_features, n).
        state: the observation, shape (n_inputs,).
        k: the column of the weights.
    """
    features.see(state)
    value = 0.0
    for j in range(features.n_active):
        value += features.values[j] * weights[features.active[j], k]
    return value


def linear_values(features: Features, weights: Reals, state: Any, values: Reals) -> None:
    """Write the values for all columns of the weights into the one row of `values`, shape (1, n)."""
    features.see(state)
    for k in range(weights.shape[1]):
        value = 0.0
        for j in range(features.n_active):
            value += features.values[j] * weights[features.active[j], k]
        values[0, k] = value


def follow_gradient(features: Features, weights: Reals, k: int, size: float) -> None:
    """Add `size` times the gradient of the linear value, which is x(s), to the k-th column of the weights."""
    for j in range(features.n_active):
        weights[features.active[j], k] += size * features.values[j]


def check_features(features: Any, n_inputs: int) -> None:
    """Check that something is features, for observations of so many numbers.

    Raises:
        ValueError: it is not.
    """
    if isinstance(features, type) or not (hasattr(features, "see") and hasattr(features, "n_features")):
        raise ValueError(
            f"features must be a value such as TileCoding.create(environment), but is {in_short(features)}"
        )
    if features.n_inputs != n_inputs:
        raise ValueError(
            f"features must be of {n_inputs} numbers, as an observation has, but are of {features.n_inputs}"
        )
