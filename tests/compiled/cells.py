"""Classes as students write them: in notebook cells, which can be run again."""

import enum
import linecache
import math
from itertools import count
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

_numbers = count(1)


def cell(source: str, namespace: dict[str, Any] | None = None) -> dict[str, Any]:
    """Run a notebook cell, in a new notebook or in one that has run others, and give the notebook's variables."""
    if namespace is None:
        namespace = {"__name__": "__main__", "NamedTuple": NamedTuple}
        namespace |= {"np": np, "math": math, "enum": enum, "spaces": spaces}
    name = f"<cell {next(_numbers)}>"
    linecache.cache[name] = (len(source), None, source.splitlines(keepends=True), name)
    exec(compile(source, name, "exec"), namespace)
    return namespace


WALK = """
class Walk(NamedTuple):
    size: int

    def initial(self, rng):
        return 0

    def transition(self, state, action, rng):
        return max(0, state + 2 * action - 1)

    def reward(self, state, action, next_state, rng):
        return 1.0 if next_state == self.size else -0.25

    def terminal(self, state):
        return state == self.size

    def observation(self, state, rng):
        return state

    @property
    def observation_space(self):
        return spaces.Discrete(self.size + 1)

    @property
    def action_space(self):
        return spaces.Discrete(2)
"""
"""A corridor from 0 to `size`: action 1 leads right, action 0 left; each step costs, the end pays."""

SLIPPERY = (
    WALK.replace("class Walk", "class SlipperyWalk")
    .replace("size: int", "size: int\n    slip: float")
    .replace(
        "return max(0, state + 2 * action - 1)",
        "forward = action == 1\n        if rng.random() < self.slip:\n            forward = not forward\n"
        "        return state + 1 if forward else max(0, state - 1)",
    )
)
"""The same on ice: with probability `slip` a step goes the other way."""

LEARNER = """
class Learner(NamedTuple):
    Q: np.ndarray
    rate: float = 0.5

    def act(self, state, rng):
        if rng.random() < 0.1:
            return int(rng.random() * self.Q.shape[1])
        best = 0
        for action in range(self.Q.shape[1]):
            if self.Q[state, action] > self.Q[state, best]:
                best = action
        return best

    def learn(self, state, action, reward, next_state, terminated):
        value = 0.0 if terminated else max(self.Q[next_state, 0], self.Q[next_state, 1])
        self.Q[state, action] += self.rate * (reward + value - self.Q[state, action])
"""
"""A student's Q-learning."""
