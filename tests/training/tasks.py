"""Small tasks and agents, as students write them, to be trained."""

from typing import Any

import numpy as np
import pytest

from edugym.compiled import execution
from tests.compiled.cells import cell


def interpret(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let nothing be compiled from here on, as where there is no compiler."""
    monkeypatch.setattr(execution, "may_compile", lambda: False)


NOTEBOOK = cell("""
from edugym.agents.tables import best_value, greedy_action

class Stairs(NamedTuple):
    def initial(self, rng): return 0
    def transition(self, state, action, rng): return state + 1
    def reward(self, state, action, next_state, rng): return float(next_state)
    def terminal(self, state): return state == 3
    def observation(self, state, rng): return state
    observation_space = property(lambda self: spaces.Discrete(4))
    action_space = property(lambda self: spaces.Discrete(2))

class Ring(NamedTuple):
    max_steps: int | None = 5
    def initial(self, rng): return 0
    def transition(self, state, action, rng): return 1 - state
    def reward(self, state, action, next_state, rng): return 1.0
    def terminal(self, state): return False
    def observation(self, state, rng): return state
    observation_space = property(lambda self: spaces.Discrete(2))
    action_space = property(lambda self: spaces.Discrete(2))

class SlipperyWalk(Stairs):
    __slots__ = ()
    def initial(self, rng): return 2 + int(rng.random() * 3)
    def transition(self, state, action, rng):
        right = (action == 1) == (rng.random() >= 0.2)
        return state + 1 if right else state - 1
    def reward(self, state, action, next_state, rng):
        return rng.normal(0.0, 0.1) + (1.0 if next_state == 6 else -1.0 if next_state == 0 else 0.0)
    def terminal(self, state): return state in (0, 6)
    observation_space = property(lambda self: spaces.Discrete(7))

class Explorer(NamedTuple):
    Q: np.ndarray
    def act(self, state, rng):
        if rng.random() < 0.2:
            return int(rng.random() * self.Q.shape[1])
        return greedy_action(self.Q, state, rng)

class StudentsQLearning(Explorer):
    __slots__ = ()
    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + 0.9 * best_value(self.Q, next_state)
        self.Q[state, action] += 0.3 * (target - self.Q[state, action])

class StudentsSarsa(Explorer):
    __slots__ = ()
    def learn(self, reward, next_action, next_state, state, action, terminated, rate=0.3):
        target = reward if terminated else reward + 0.9 * self.Q[next_state, next_action]
        self.Q[state, action] += rate * (target - self.Q[state, action])

class TellTale(NamedTuple):
    Q: np.ndarray
    told: np.ndarray
    def act(self, state, rng): return 0
    def learn(self, state, action, reward, next_state, terminated, truncated):
        self.told[0] += 1
        self.told[1] += terminated
        self.told[2] += truncated
        self.told[3] += terminated and truncated
""")

Stairs: Any = NOTEBOOK["Stairs"]
"""Three steps that pay 1, 2 and 3: a return of 6; both actions do the same."""
Ring: Any = NOTEBOOK["Ring"]
"""Two states that follow each other; every step pays 1, and an episode has five, or as many as is said."""
SlipperyWalk: Any = NOTEBOOK["SlipperyWalk"]
"""Left or right between 0 and 6, slipping to the other side one time in five; 6 pays 1, 0 costs 1, with some noise."""
StudentsQLearning: Any = NOTEBOOK["StudentsQLearning"]
"""Q-learning in ten lines, as a student writes it: α = 0.3, γ = 0.9, ε = 0.2."""
StudentsSarsa: Any = NOTEBOOK["StudentsSarsa"]
"""SARSA, with its parameters in an order of its own, and one more."""


def tell_tale() -> Any:
    """An agent that notes what the loop tells it of the end of episodes."""
    return NOTEBOOK["TellTale"](np.zeros((20, 2)), np.zeros(4, np.int64))
