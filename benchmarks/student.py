"""The same as a student writes it: Gymnasium environments with `step`, and agents with a NumPy table.

Written to be read, not to be slow: plain Python numbers where they will do, and NumPy where one would take it.
"""

from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Random, Reals


class Boulder(gymnasium.Env[Any, Any]):
    """The wall of the exploration lesson."""

    def __init__(self, height: int = 10, n_grips: int = 2) -> None:
        """A wall."""
        self.observation_space = spaces.Discrete(height + 1)
        self.action_space = spaces.Discrete(n_grips)
        self.height = height
        self.max_steps = 10 * height
        self.grips = np.random.default_rng(0).integers(n_grips, size=height).tolist()

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """To the ground."""
        super().reset(seed=seed)
        self.position = 0
        self.steps = 0
        return self.position, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Jump to a grip."""
        if action == self.grips[self.position]:
            self.position += 1
        else:
            self.position = 0
        self.steps += 1
        terminated = self.position == self.height
        truncated = self.steps >= self.max_steps
        reward = 1.0 if terminated else 0.0
        return self.position, reward, terminated, truncated, {}


class Golf(gymnasium.Env[Any, Any]):
    """The course of the stochasticity lesson."""

    swings = (1.0, 4.0, 10.0)

    def __init__(self, width: int = 7, length: int = 17, green_radius: float = 2.1, max_hits: int = 10) -> None:
        """A course."""
        self.observation_space = spaces.Tuple([spaces.Discrete(width), spaces.Discrete(length)])
        self.action_space = spaces.Discrete(3)
        self.width, self.length, self.green_radius, self.max_hits = width, length, green_radius, max_hits
        self.flag = np.array([width / 2, length - width / 2])

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[tuple[int, int], dict[str, Any]]:
        """To the tee."""
        super().reset(seed=seed)
        self.ball = np.array([self.width / 2, 0.0])
        self.hits = 0
        return self.cell(), {}

    def step(self, action: int) -> tuple[tuple[int, int], float, bool, bool, dict[str, Any]]:
        """Hit the ball."""
        distance = self.swings[action]
        to_flag = self.flag - self.ball
        direction = to_flag / np.linalg.norm(to_flag)
        self.ball = self.ball + distance * direction + self.np_random.normal(0.0, 0.015 * distance**2, size=2)
        self.hits += 1
        on_green = np.linalg.norm(self.ball - self.flag) < self.green_radius
        x, y = self.ball
        off_course = x < 0 or x >= self.width or y < 0 or y >= self.length
        lost = off_course or (not on_green and self.hits == self.max_hits)
        reward = -1.0 if lost else 1.0 - (self.hits - 1) / self.max_hits if on_green else 0.0
        return self.cell(), reward, bool(on_green or lost), False, {}

    def cell(self) -> tuple[int, int]:
        """The cell of the ball."""
        x, y = np.floor(self.ball)
        return min(max(int(x), 0), self.width - 1), min(max(int(y), 0), self.length - 1)


def q_learning(
    env: gymnasium.Env[Any, Any], Q: Reals, n_steps: int, alpha: float, gamma: float, epsilon: float
) -> None:
    """Q-learning as in every tutorial; `Q` is indexed by the observation and the action."""
    rng = np.random.default_rng(0)
    n_actions = Q.shape[-1]
    observation, _ = env.reset(seed=0)
    for _ in range(n_steps):
        explore = rng.random() < epsilon
        action = int(rng.integers(n_actions)) if explore else int(np.argmax(Q[observation]))
        next_observation, reward, terminated, truncated, _ = env.step(action)
        future = 0.0 if terminated else np.max(Q[next_observation])
        row = Q[observation]
        row[action] += alpha * (float(reward) + gamma * future - row[action])
        observation = next_observation
        if terminated or truncated:
            observation, _ = env.reset()


class OwnAgent(NamedTuple):
    """An agent of a student's own, for EduGym to train: ten lines of NumPy, in no way made for speed."""

    Q: Any
    alpha: float
    gamma: float
    epsilon: float

    def act(self, state: int, rng: Random) -> Any:
        """ε-greedy; where all actions are as good, any of them."""
        values = self.Q[state]
        if rng.random() < self.epsilon or values.min() == values.max():
            return rng.integers(len(values))
        return np.argmax(values)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Q-learning."""
        target = reward if terminated else reward + self.gamma * self.Q[next_state].max()
        self.Q[state, action] += self.alpha * (target - self.Q[state, action])
