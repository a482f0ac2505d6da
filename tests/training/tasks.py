"""Small tasks and agents, as students write them, to be trained."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym.agents.tables import best_value, greedy_action
from edugym.compiled import execution
from edugym.mdp.protocol import Random


def interpret(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let nothing be compiled from here on, as where there is no compiler."""
    monkeypatch.setattr(execution, "may_compile", lambda: False)


class Stairs(NamedTuple):
    """Three steps that pay 1, 2 and 3: a return of 6."""

    def initial(self, rng: Random) -> int:
        """At the bottom."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """One up."""
        return state + 1

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """As much as the number of the step."""
        return float(next_state)

    def terminal(self, state: int) -> bool:
        """After the third."""
        return state == 3

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The bottom and three steps."""
        return spaces.Discrete(4)

    @property
    def action_space(self) -> spaces.Discrete:
        """Two that do the same."""
        return spaces.Discrete(2)


class Ring(NamedTuple):
    """Two states that follow each other; every step pays 1, and an episode has five, or as many as is said."""

    max_steps: int | None = 5

    def initial(self, rng: Random) -> int:
        """The first."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """The other one."""
        return 1 - state

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """Always 1."""
        return 1.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """Both states."""
        return spaces.Discrete(2)

    @property
    def action_space(self) -> spaces.Discrete:
        """Two, of the same effect."""
        return spaces.Discrete(2)


class SlipperyWalk(Stairs):
    """Left or right between 0 and 6, slipping to the other side one time in five; 6 pays 1, and 0 costs 1."""

    __slots__ = ()

    def initial(self, rng: Random) -> int:
        """At 2, 3 or 4."""
        return 2 + int(rng.random() * 3)

    def transition(self, state: int, action: int, rng: Random) -> int:
        """One to the side, wanted or not."""
        right = (action == 1) == (rng.random() >= 0.2)
        return state + 1 if right else state - 1

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """At the ends, with some noise."""
        return rng.normal(0.0, 0.1) + (1.0 if next_state == 6 else -1.0 if next_state == 0 else 0.0)

    def terminal(self, state: int) -> bool:
        """At either end."""
        return state in (0, 6)

    @property
    def observation_space(self) -> spaces.Discrete:
        """Seven places."""
        return spaces.Discrete(7)


class Explorer(NamedTuple):
    """A table and how to act by it."""

    Q: Any

    def act(self, state: int, rng: Random) -> int:
        """ε-greedy with ε = 0.2."""
        if rng.random() < 0.2:
            return int(rng.random() * self.Q.shape[1])
        return greedy_action(self.Q, state, rng)


class StudentsQLearning(Explorer):
    """Q-learning in ten lines, as a student writes it."""

    __slots__ = ()

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """α = 0.3, γ = 0.9."""
        target = reward if terminated else reward + 0.9 * best_value(self.Q, next_state)
        self.Q[state, action] += 0.3 * (target - self.Q[state, action])


class StudentsSarsa(Explorer):
    """SARSA in ten lines, as a student writes it, with its parameters in an order of its own, and one more."""

    __slots__ = ()

    def learn(
        self,
        reward: float,
        next_action: int,
        next_state: int,
        state: int,
        action: int,
        terminated: bool,
        rate: float = 0.3,
    ) -> None:
        """γ = 0.9."""
        target = reward if terminated else reward + 0.9 * self.Q[next_state, next_action]
        self.Q[state, action] += rate * (target - self.Q[state, action])


class TellTale(NamedTuple):
    """Notes what the loop tells it of the end of episodes."""

    Q: Any
    told: Any

    def act(self, state: int, rng: Random) -> int:
        """Always the same."""
        return 0

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Count."""
        self.told[0] += 1
        self.told[1] += terminated
        self.told[2] += truncated
        self.told[3] += terminated and truncated


def tell_tale() -> TellTale:
    """A new one."""
    return TellTale(np.zeros((20, 2)), np.zeros(4, np.int64))
