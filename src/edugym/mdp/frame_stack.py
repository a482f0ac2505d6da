"""The last few observations as one number: short-term memory for partially observable tasks."""

import math
from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.parameters import in_short, number_of_steps, true_or_false, whole_number
from edugym.mdp.protocol import Random
from edugym.mdp.tabular import MOST_ROWS, table_sizes, tabular_mdp
from edugym.mdp.task import task_of
from edugym.mdp.wrapper import wrapper

MOST_SHOWN = 100_000
"""The longest window of which the number of rows can be asked for."""


class Stacked(NamedTuple):
    """A state of the task, and what the agent remembers of the way to it.

    Attributes:
        inner: the state of the task.
        row: the last k observations (and the actions between them) as the digits of one number; the newest is last.
    """

    inner: Any
    row: int


@wrapper
class FrameStack(NamedTuple):
    """An MDP that shows its last k observations, and the actions between them if wanted, as the number of a table row.

    For n observations and m actions the table has n^k rows, or n^k m^(k-1) if the actions are shown. An episode starts
    with k copies of its first observation (and action 0 between them). If n = 4, the observations 2, 2 are row 10.

    Make one with, for example, `FrameStack.create(edugym.make_mdp("MemoryCorridor"), 3)`. (For a Gymnasium environment
    of this package, `env.unwrapped.mdp` is the MDP.) What is not defined here, `@wrapper` takes from the inner MDP.

    Attributes:
        mdp: the task, which observes 0, 1, ..., n - 1.
        k: how many observations are shown, 1 or more.
        n_observations: n.
        n_actions: m, or 1 where actions are not shown.
        n_recent: the number of rows of a window of k - 1 observations: `row % n_recent` drops the oldest.

    References: Sutton and Barto, 2nd edition, section 17.3 (there called a kth-order history).
    """

    mdp: Any
    k: int
    n_observations: int
    n_actions: int
    n_recent: int

    @property
    def observation_space(self) -> spaces.Discrete:
        """The rows of the table."""
        return spaces.Discrete(_windows(self.n_observations, self.k, self.n_actions))

    def initial(self, rng: Random) -> Stacked:
        """The first observation, k times."""
        state = self.mdp.initial(rng)
        first = int(self.mdp.observation(state, rng))
        row = first
        for _ in range(self.k - 1):
            row = row * self.n_actions * self.n_observations + first
        return Stacked(state, row)

    def transition(self, state: Stacked, action: int, rng: Random) -> Stacked:
        """The oldest observation goes, the new one comes."""
        next_state = self.mdp.transition(state.inner, action, rng)
        row = state.row % self.n_recent
        if self.n_actions > 1:
            row = row * self.n_actions + int(action)
        return Stacked(next_state, row * self.n_observations + int(self.mdp.observation(next_state, rng)))

    def reward(self, state: Stacked, action: int, next_state: Stacked, rng: Random) -> float:
        """The reward of the task."""
        reward: float = self.mdp.reward(state.inner, action, next_state.inner, rng)
        return reward

    def terminal(self, state: Stacked) -> bool:
        """Whether the task ends."""
        terminal: bool = self.mdp.terminal(state.inner)
        return terminal

    def observation(self, state: Stacked, rng: Random) -> int:
        """The row of what the agent remembers."""
        return state.row

    def inside(self, state: Stacked) -> Any:
        """The state of the task."""
        return state.inner

    @classmethod
    def create(cls, mdp: Any, k: int, actions: bool = False) -> "FrameStack":
        """The wrapper for an MDP that observes whole numbers.

        Args:
            mdp: the task.
            k: how many observations to show, 1 or more.
            actions: whether to show the actions between them as well; the action space must then be Discrete.

        Raises:
            ValueError: a parameter is not as above; `mdp` is not an MDP, its observations are not whole numbers, or its
                actions do not start at 0; or the table would have 2^63 rows or more.
        """
        task_of(mdp, "mdp", MDP_ONLY)
        k = whole_number("k", k, 1)
        true_or_false("actions", actions)
        mdp = tabular_mdp(mdp)
        n_actions, n = 1, math.prod(table_sizes(mdp.observation_space))
        if actions and k > 1:
            if not isinstance(mdp.action_space, spaces.Discrete):
                raise ValueError(
                    f"actions must be False, since the action space is not Discrete but {mdp.action_space}"
                )
            n_actions = int(mdp.action_space.n)
        most = longest_stack(n, n_actions)
        if most is not None and k > most:
            shown = f"{n} observations" if n_actions == 1 else f"{n} observations and {n_actions} actions"
            raise ValueError(
                f"k must be at most {most}, but is {in_short(k)}: for {shown} a longer window has 2^63 rows or more"
            )
        return cls(mdp, k, n, n_actions, _windows(n, k - 1, n_actions) if k > 1 else 1)


def stack_size(n_observations: int, k: int, n_actions: int = 1) -> int:
    """How many different windows of k observations there are, with the actions between them: n^k m^(k-1).

    It is computed with Python's whole numbers, so it may be larger than any table.

    Args:
        n_observations: n, from 1 to 2^62.
        k: how many observations a window has, from 1 to 100 000.
        n_actions: m, from 1 to 2^62; 1 where actions are not shown.

    Raises:
        ValueError: a number is not as above.
    """
    n, m = number_of_steps("n_observations", n_observations), number_of_steps("n_actions", n_actions)
    return _windows(n, whole_number("k", k, 1, MOST_SHOWN), m)


def _windows(n_observations: int, k: int, n_actions: int) -> int:
    """`stack_size` of numbers that have been looked at."""
    size: int = n_observations**k * n_actions ** (k - 1)
    return size


def longest_stack(n_observations: int, n_actions: int = 1) -> int | None:
    """The largest k for which a window has fewer than 2^63 rows; None if there is no such limit."""
    if n_observations * n_actions == 1:
        return None
    k = 0
    while _windows(n_observations, k + 1, n_actions) <= MOST_ROWS:
        k += 1
    return k
