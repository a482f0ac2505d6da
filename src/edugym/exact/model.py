"""The exact model of a finite MDP, worked out from the very methods that `step` runs.

The dynamics are followed along every way that their random numbers can send them (see `edugym.exact.branching`), so
there is no second description of them that could drift from the first. Noise that is only added to a reward counts as
its mean. What is found is compared with some real steps (see `edugym.exact.checking`).
"""

import math
from array import array
from collections.abc import Iterable
from functools import partial
from typing import Any

import numpy as np
from gymnasium import spaces

from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.parameters import whole_number
from edugym.checks.tracebacks import end_at_students_line
from edugym.exact.branching import MAX_WAYS, branches
from edugym.exact.checking import compare_with_steps, global_randomness
from edugym.exact.tables import FiniteModel, plain
from edugym.mdp.protocol import MDP
from edugym.mdp.task import task_of
from edugym.system.packages import is_own

MAX_STATES = 50_000
MOST_STATES = 100_000_000
"""To what the limit of states may be raised: so many take an hour, and tens of gigabytes."""
MAX_ENTRIES = 50_000_000
"""Of each of the three tables of shape (S, A, K): more would not fit into the memory of a small machine."""


def finite_model(mdp: MDP[Any, Any], max_states: int = MAX_STATES) -> FiniteModel:
    """The exact model of an MDP, by taking every way that its methods can go, from its initial states on.

    A state takes some 10 µs, so that a hundred thousand states take a second or two and a million some twenty seconds.

    Args:
        mdp: the task. Its states are numbers, or (nested) tuples of numbers.
        max_states: how many states to look at before giving up, from 1 to 100 million. Ways from a state to the next
            are looked at up to ten times as many (100 000 are always allowed).

    Raises:
        ValueError: `mdp` is no MDP, or the task is not finite: it has too many states, states that hold arrays, or
            dynamics that draw from a continuous distribution; or an episode can start in a terminal state; or real
            steps do something else than its methods do when they are followed.
    """
    max_states = whole_number("max_states", max_states, 1, MOST_STATES)
    task_of(mdp, "mdp", MDP_ONLY)
    before = global_randomness()
    try:
        model = _explored(mdp, max_states)
        if not (isinstance(mdp, tuple) and is_own(mdp)):  # the package's own are compared in its tests
            compare_with_steps(model)
        problem = None
    except Exception as error:
        end_at_students_line(error)
        if not isinstance(error, ValueError):
            raise
        problem = error
    if global_randomness() != before:
        problem = ValueError("its methods draw from np.random or random: use the `rng` that they are given")
    if problem:
        reason = f"{type(mdp).__name__} has no finite model: {problem}"
        raise ValueError(reason).with_traceback(problem.__traceback__) from None
    return model


class _Explorer:
    """The states found so far, and how to find more."""

    def __init__(self, mdp: MDP[Any, Any], max_states: int) -> None:
        """Nothing has been found yet."""
        self.mdp = mdp
        self.max_states = max_states
        self.ways_left = max(100_000, 10 * max_states)
        self.states: list[Any] = []
        self.rows: dict[Any, int] = {}

    def row(self, state: Any) -> int:
        """The row of a state, a new one if it has not been met."""
        try:
            return self.rows[state]
        except (KeyError, TypeError):  # a new one, or one that holds an array, which `plain` refuses
            state = plain(state)
        if len(self.states) == self.max_states:
            raise ValueError(f"it has more than {self.max_states} states (max_states can be raised)")
        self.rows[state] = len(self.states)
        self.states.append(state)
        return len(self.states) - 1

    def reached(self, draw: partial[Any]) -> dict[int, float]:
        """The states that a draw can give, by row, with their probabilities."""
        total: dict[int, float] = {}
        for way, (p, state) in enumerate(branches(draw)):
            if way == MAX_WAYS:
                raise ValueError(f"one step can go more than {MAX_WAYS} ways")
            self.ways_left -= 1
            if self.ways_left < 0:
                raise ValueError("its steps can go too many ways in all (a larger max_states allows more)")
            if state is None:
                raise ValueError(f"{'transition' if draw.args else 'initial'} returns None: is its `return` missing?")
            row = self.row(state)
            total[row] = total.get(row, 0.0) + p
        if abs(sum(total.values()) - 1.0) > 1e-6:
            where = f"after action {draw.args[1]} in state {draw.args[0]!r}" if draw.args else "at the start"
            raise ValueError(f"the probabilities of what can happen {where} sum to {sum(total.values()):.6g}")
        return total

    def ends(self, state: Any) -> bool:
        """Whether the task ends there."""
        end = self.mdp.terminal(state)
        if not isinstance(end, bool | int | np.bool_ | np.integer):
            raise ValueError(f"terminal must return True or False, but returns {end!r} for state {state!r}")
        return bool(end)

    def mean_reward(self, state: Any, action: int, next_state: Any) -> float:
        """The mean reward of a transition."""
        mean = 0.0
        for p, reward in branches(partial(self.mdp.reward, state, action, next_state), means=True):
            try:
                mean += p * float(reward)
            except TypeError:
                mean = math.nan
            if not math.isfinite(mean):
                place = f"{state!r}, {action}, {next_state!r}"
                raise ValueError(f"reward must return a finite number, but returns {reward!r} for {place}") from None
        return mean


def _explored(mdp: MDP[Any, Any], max_states: int) -> FiniteModel:
    if not isinstance(mdp.action_space, spaces.Discrete):
        raise ValueError(f"its action space is {mdp.action_space}, not Discrete(n)")
    n_actions = int(mdp.action_space.n)
    explorer = _Explorer(mdp, max_states)
    first = explorer.reached(partial(mdp.initial))
    for state in explorer.states:
        if explorer.ends(state):
            raise ValueError(f"initial must return a state that is not terminal, but can return {state!r}")
    # For each state and action in turn: how many outcomes it has, then for each outcome: successor, p and reward.
    widths, successors, probabilities, rewards = array("l"), array("l"), array("d"), array("d")
    terminal = array("b")
    for s, state in enumerate(explorer.states):  # grows on the way
        terminal.append(explorer.ends(state))
        for action in range(n_actions):
            reached = {s: 1.0} if terminal[s] else explorer.reached(partial(mdp.transition, state, action))
            widths.append(len(reached))
            successors.extend(reached)
            probabilities.extend(reached.values())
            for n in reached:
                rewards.append(0.0 if terminal[s] else explorer.mean_reward(state, action, explorer.states[n]))

    order = _ascending(explorer.states)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    states = tuple(explorer.states[s] for s in order.tolist())
    initial = np.zeros(len(states))
    initial[rank[list(first)]] = list(first.values())

    width = np.array(widths)
    entries = len(width) * int(width.max())
    if entries > MAX_ENTRIES:
        raise ValueError(f"its tables would have {entries} entries, and {MAX_ENTRIES} is the limit")
    places = np.arange(width.max()) < width[:, np.newaxis]  # shape (S * A, K): which places of the tables are used
    shape = (len(states), n_actions, width.max())

    def table(numbers: Any) -> Any:
        filled = np.zeros(places.shape, numbers.dtype)
        filled[places] = numbers
        return filled.reshape(shape)[order]

    return FiniteModel(
        states,
        {state: s for s, state in enumerate(states)},
        initial,
        np.array(terminal, bool)[order],
        table(rank[np.array(successors)]),
        table(np.array(probabilities)),
        table(np.array(rewards)),
        mdp,
    )


def _ascending(states: list[Any]) -> Any:
    """The order that sorts the states; as they were found where they cannot be compared."""
    try:
        order: Iterable[int] = sorted(range(len(states)), key=states.__getitem__)
    except TypeError:
        order = range(len(states))
    return np.fromiter(order, np.int64, len(states))
