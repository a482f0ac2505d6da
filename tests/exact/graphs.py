"""A small task with several objectives, made of tables."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Integers, Random, Reals


class Graph(NamedTuple):
    """A walk on a graph; the last node is the end.

    Attributes:
        successors: shape (S, A): where each action leads.
        vectors: shape (S, A, n_objectives): what it pays.
        max_steps: the step limit.
        slip: "" or one mistake of students.
    """

    successors: Integers
    vectors: Reals
    max_steps: int | None
    slip: str = ""

    def initial(self, rng: Random) -> int:
        """Node 0."""
        return int(rng.integers(2)) if self.slip == "random start" else 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """Along an edge."""
        if self.slip == "random walk" and rng.random() < 0.5:
            return state
        return int(self.successors[state, action])

    def rewards(self, state: int, action: int, next_state: int) -> Any:
        """What the edge pays."""
        if self.slip in ("one number", "nothing", "too many"):
            return {"one number": 1.0, "nothing": None, "too many": (1.0,) * 9}[self.slip]
        return tuple(self.vectors[state, action])

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """The sum."""
        return float(self.vectors[state, action].sum())

    def terminal(self, state: int) -> bool:
        """The last node."""
        return state == len(self.successors) - 1

    def observation(self, state: int, rng: Random) -> int:
        """The node."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The nodes."""
        return spaces.Discrete(len(self.successors))

    @property
    def action_space(self) -> spaces.Discrete:
        """The edges."""
        return spaces.Discrete(self.successors.shape[1])

    @property
    def reward_space(self) -> Any:
        """Vectors."""
        if self.slip == "space":
            return spaces.Discrete(3)
        n = self.vectors.shape[2]
        return spaces.Box(-np.inf, np.inf, (n,), np.float64)


def loop(slip: str = "", max_steps: int | None = 5) -> Graph:
    """Three nodes: wait for 1 of the second objective, or go on for 1 of the first."""
    vectors = np.array([[[0.0, 1.0], [1.0, 0.0]]] * 3)
    return Graph(np.array([[0, 1], [1, 2], [2, 2]]), vectors, max_steps, slip)
