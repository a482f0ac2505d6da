"""The tables of a finite MDP: what can happen in every state after every action, and with what probability."""

from typing import Any, NamedTuple

import numpy as np

from edugym.checks.parameters import an_array, between, in_short, whole_number
from edugym.exact.branching import branches
from edugym.mdp.protocol import MDP, Integers, Random, Reals
from edugym.mdp.tabular import tabular_mdp


class Outcome(NamedTuple):
    """One thing that can happen after an action.

    Attributes:
        probability: p(next_state | state, action).
        next_state: the state, hidden parts included.
        reward: the mean reward of this transition, r(state, action, next_state).
        terminated: whether the task ends there.
    """

    probability: float
    next_state: Any
    reward: float
    terminated: bool


class Sample(NamedTuple):
    """One thing that happened after an action, drawn from a model.

    Attributes:
        next_state: the state, hidden parts included.
        reward: the mean reward of this transition, r(state, action, next_state).
        terminated: whether the task ends there.
    """

    next_state: Any
    reward: float
    terminated: bool


class FiniteModel(NamedTuple):
    """The tables of a finite MDP: row s of each is the state `states[s]`, and each (s, a) has up to K outcomes.

    A row is the place of a state in `states`, which need not be what the agent observes there: `row(state)` gives the
    row of a state, and `observations()` the observation that belongs to each row.

    Attributes:
        states: every state that can be reached, terminal ones included, in ascending order.
        rows: the row of each state.
        initial: shape (S,): the probability that an episode starts there.
        terminal: shape (S,): whether the task ends there.
        successors: shape (S, A, K): the next states, by row; unused places have probability 0.
        probabilities: shape (S, A, K): p of each, summing to 1 over the last axis. A terminal state leads to itself.
        rewards: shape (S, A, K): the mean reward of each, r(s, a, s'); 0 in terminal states.
        mdp: the task that this is the model of; None for a model that was made by hand.
    """

    states: tuple[Any, ...]
    rows: dict[Any, int]
    initial: Reals
    terminal: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]
    successors: Integers
    probabilities: Reals
    rewards: Reals
    mdp: MDP[Any, Any] | None = None

    def __repr__(self) -> str:
        """What it is a model of, and its sizes."""
        n_states, n_actions, width = self.successors.shape
        task = "a task" if self.mdp is None else type(self.mdp).__name__
        return f"<model of {task}: {n_states} states, {n_actions} actions, at most {width} outcome(s) of each>"

    @property
    def p(self) -> Reals:
        """Shape (S, A, S): the probability of every next state, as one dense array."""
        n_states, n_actions, _ = self.successors.shape
        dense = np.zeros((n_states, n_actions, n_states))
        s, a, _ = np.indices(self.successors.shape)
        np.add.at(dense, (s, a, self.successors), self.probabilities)
        return dense

    @property
    def r(self) -> Reals:
        """Shape (S, A): the mean reward of every action in every state."""
        mean: Reals = (self.probabilities * self.rewards).sum(axis=2)
        return mean

    @property
    def P(self) -> dict[int, dict[int, list[tuple[float, int, float, bool]]]]:
        """The model as in Gymnasium's toy_text: `P[s][a]` lists (probability, next row, reward, terminated).

        States are rows here, 0, 1, ..., so that planning code written for FrozenLake or Taxi runs on any task.
        """
        tables = (self.probabilities, self.successors, self.rewards, self.terminal[self.successors])
        ways_of = zip(*(table.tolist() for table in tables), strict=True)
        return {
            s: {
                a: [(p, n, r, end) for p, n, r, end in zip(*ways, strict=True) if p > 0]
                for a, ways in enumerate(zip(*by_action, strict=True))
            }
            for s, by_action in enumerate(ways_of)
        }

    def row(self, state: Any) -> int:
        """The row of a state, which may also be given as an array, as Gymnasium's observations are.

        Raises:
            ValueError: the task has no such state.
        """
        numbers = state.tolist() if isinstance(state, np.ndarray) else state
        try:
            return self.rows[plain(tuple(numbers) if isinstance(numbers, list) else numbers)]
        except (KeyError, ValueError):
            n = len(self.states)
            raise ValueError(
                f"state must be one of the {n} that can be reached (`states`), but is {in_short(state)}"
            ) from None

    def outcomes(self, state: Any, action: int) -> list[Outcome]:
        """All that can happen after `action` in `state`.

        Raises:
            ValueError: the task has no such state or action.
        """
        s, action = self._place(state, action)
        ways = zip(self.probabilities[s, action], self.successors[s, action], self.rewards[s, action], strict=True)
        return [Outcome(float(p), self.states[n], float(r), bool(self.terminal[n])) for p, n, r in ways if p > 0]

    def sample(self, state: Any, action: int, rng: Random) -> Sample:
        """Draw one of the things that can happen after `action` in `state`.

        Raises:
            ValueError: the task has no such state or action, or `rng` is no generator of random numbers.
        """
        if isinstance(rng, type) or not hasattr(rng, "random"):
            raise ValueError(f"rng must be a generator, such as numpy.random.default_rng(0), but is {in_short(rng)}")
        s, action = self._place(state, action)
        up_to = self.probabilities[s, action].cumsum()
        k = np.searchsorted(up_to, rng.random() * up_to[-1], side="right")
        n = self.successors[s, action, k]
        return Sample(self.states[n], float(self.rewards[s, action, k]), bool(self.terminal[n]))

    def _place(self, state: Any, action: Any) -> tuple[int, int]:
        """The row of a state, and the action as an `int`."""
        return self.row(state), whole_number("action", action, 0, self.successors.shape[1] - 1)

    def action_values(self, V: Reals, discount: float) -> Reals:
        """Look one step ahead: Q(s, a) = Σ_s' p(s'|s, a) [r(s, a, s') + γ V(s')], shape (S, A).

        Raises:
            ValueError: V is not a number for each state, or the discount γ is not from 0 to 1.
        """
        return looked_ahead(self, an_array("V", V, (len(self.states),)), between("discount", discount, 0, 1))

    def observations(self) -> Integers:
        """Shape (S,): what the agent observes in each state, as the row of a table, such as its Q.

        Raises:
            ValueError: the observation is random or is not made of whole numbers, or the model does not know its task.
        """
        task = self.table_task()

        def observed(state: Any) -> int:
            ways = list(branches(lambda rng: task.observation(state, rng)))
            if len(ways) > 1:
                raise ValueError(f"the observation must follow from the state, but in {state!r} it is random")
            return int(ways[0][1])

        return np.array([observed(state) for state in self.states], np.int64)

    def table_task(self) -> Any:
        """The task, with whole numbers 0, 1, ... for observations.

        Raises:
            ValueError: the model does not know its task, or that observes something else.
        """
        if self.mdp is None:
            raise ValueError("the model must know its task, but was made without `mdp`")
        return tabular_mdp(self.mdp)


def looked_ahead(model: FiniteModel, V: Reals, discount: float) -> Reals:
    """Look one step ahead, as `FiniteModel.action_values` does, but without its checks of V and discount."""
    Q: Reals = np.einsum("sak,sak->sa", model.probabilities, model.rewards + discount * V[model.successors])
    return Q


def plain(state: Any) -> Any:
    """A state that can be the key of a dictionary: NumPy's numbers become Python's.

    Raises:
        ValueError: it holds something else than numbers.
    """
    if isinstance(state, tuple):
        parts = [plain(part) for part in state]
        return type(state)(*parts) if hasattr(state, "_fields") else tuple(parts)
    if isinstance(state, np.generic):
        return state.item()
    if issubclass(
        type(state), int | float
    ):  # not `isinstance`: a random number that is still open claims to be a float
        return state
    raise ValueError(f"a state must be a number or a tuple of numbers, but there is {state!r}")
