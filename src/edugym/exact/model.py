"""The exact model of a finite MDP, worked out from the very methods that `step` runs.

The dynamics are followed along every way that their random numbers can send them (see `edugym.exact.branching`), so
there is no second description of them that could drift from the first. Noise that is only added to a reward counts as
its mean.
"""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.exact.branching import branches
from edugym.mdp.protocol import MDP, Integers, Reals

MAX_STATES = 50_000
MAX_WAYS = 100_000
"""How many ways from a state to the next are looked at, in all, before giving up: some five seconds' worth."""


class Outcome(NamedTuple):
    """One thing that can happen after an action, as in the tables `P[s][a]` of Gymnasium's toy_text.

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


class FiniteModel(NamedTuple):
    """The tables of a finite MDP: row s of each is the state `states[s]`, and each (s, a) has up to K outcomes.

    Attributes:
        states: every state that can be reached, terminal ones included, in the order in which they were found.
        rows: the row of each state.
        initial: shape (S,): the probability that an episode starts there.
        terminal: shape (S,): whether the task ends there.
        successors: shape (S, A, K): the next states, by row; unused places have probability 0.
        probabilities: shape (S, A, K): p of each, summing to 1 over the last axis. A terminal state leads to itself.
        rewards: shape (S, A, K): the mean reward of each, r(s, a, s'); 0 in terminal states.
    """

    states: tuple[Any, ...]
    rows: dict[Any, int]
    initial: Reals
    terminal: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]
    successors: Integers
    probabilities: Reals
    rewards: Reals

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

    def row(self, state: Any) -> int:
        """The row of a state, which may also be given as an array, as Gymnasium's observations are.

        Raises:
            ValueError: the task has no such state.
        """
        numbers = state.tolist() if isinstance(state, np.ndarray) else state
        try:
            return self.rows[_plain(tuple(numbers) if isinstance(numbers, list) else numbers)]
        except (KeyError, ValueError):
            n = len(self.states)
            raise ValueError(f"state must be one of the {n} that can be reached (`states`), but is {state!r}") from None

    def outcomes(self, state: Any, action: int) -> list[Outcome]:
        """All that can happen after `action` in `state`.

        Raises:
            ValueError: the task has no such state.
        """
        s = self.row(state)
        return [
            Outcome(float(p), self.states[n], float(reward), bool(self.terminal[n]))
            for p, n, reward in zip(
                self.probabilities[s, action], self.successors[s, action], self.rewards[s, action], strict=True
            )
            if p > 0
        ]


def finite_model(mdp: MDP[Any, Any], max_states: int = MAX_STATES) -> FiniteModel:
    """The exact model of an MDP, by taking every way that its methods can go, from its initial states on.

    Args:
        mdp: the task. Its states are numbers, or (nested) tuples of numbers.
        max_states: how many states to look at before giving up.

    Raises:
        ValueError: the task is not finite: it has too many states, states that hold arrays, or dynamics that draw from
            a continuous distribution.
    """
    try:
        return _explored(mdp, max_states)
    except ValueError as error:
        raise ValueError(f"{type(mdp).__name__} has no finite model: {error}") from error


def _explored(mdp: MDP[Any, Any], max_states: int) -> FiniteModel:
    if not isinstance(mdp.action_space, spaces.Discrete):
        raise ValueError(f"its action space is {mdp.action_space}")
    n_actions = int(mdp.action_space.n)
    states: list[Any] = []
    rows: dict[Any, int] = {}
    ways = 0

    def row_of(state: Any) -> int:
        if state not in rows:
            if len(states) == max_states:
                raise ValueError(f"it has more than {max_states} states")
            rows[state] = len(states)
            states.append(state)
        return rows[state]

    def reached(draw: Callable[[Any], Any]) -> dict[int, float]:
        """The states that a draw can give, by row, with their probabilities."""
        nonlocal ways
        total: dict[int, float] = {}
        for p, state in branches(draw):
            ways += 1
            if ways > MAX_WAYS:
                raise ValueError(f"its dynamics can go more than {MAX_WAYS} ways")
            row = row_of(_plain(state))
            total[row] = total.get(row, 0.0) + p
        return total

    first = reached(mdp.initial)
    table: list[list[list[tuple[int, float, float]]]] = []  # by state, action and outcome: successor, p, reward
    for s, state in enumerate(states):  # grows on the way
        if mdp.terminal(state):
            table.append([[(s, 1.0, 0.0)]] * n_actions)
            continue
        table.append([])
        for action in range(n_actions):
            successors = reached(partial(mdp.transition, state, action))
            table[s].append([(n, p, _mean_reward(mdp, state, action, states[n])) for n, p in successors.items()])

    width = max(len(outcomes) for by_action in table for outcomes in by_action)
    full = np.zeros((3, len(states), n_actions, width))
    for s, by_action in enumerate(table):
        for a, outcomes in enumerate(by_action):
            full[:, s, a, : len(outcomes)] = np.transpose(outcomes)
    initial = np.zeros(len(states))
    initial[list(first)] = list(first.values())
    terminal = np.array([bool(mdp.terminal(state)) for state in states])
    return FiniteModel(tuple(states), rows, initial, terminal, full[0].astype(np.int64), full[1], full[2])


def _mean_reward(mdp: MDP[Any, Any], state: Any, action: int, next_state: Any) -> float:
    ways = branches(lambda rng: mdp.reward(state, action, next_state, rng), means=True)
    return float(sum(p * reward for p, reward in ways))


def _plain(state: Any) -> Any:
    """A state that can be the key of a dictionary: NumPy's numbers become Python's.

    Raises:
        ValueError: it holds something else than numbers.
    """
    if isinstance(state, tuple):
        parts = [_plain(part) for part in state]
        return type(state)(*parts) if hasattr(state, "_fields") else tuple(parts)
    if isinstance(state, np.generic):
        return state.item()
    if isinstance(state, int | float):
        return state
    raise ValueError(f"a state must be a number or a tuple of numbers, but there is {state!r}")
