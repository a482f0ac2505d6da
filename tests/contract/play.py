"""How the contract tests play: the registry as test parameters, and episodes as plain values that can be compared."""

import copy
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode

from edugym.adapters.registration import ENVIRONMENTS
from tests.contract.parameters import PARAMETERS

CORNERS = [
    (entry, corner) for entry in ENVIRONMENTS if entry.name in PARAMETERS for corner in PARAMETERS[entry.name].corners
]

every_environment = pytest.mark.parametrize("entry", ENVIRONMENTS, ids=[entry.name for entry in ENVIRONMENTS])
every_corner = pytest.mark.parametrize(
    ("entry", "keywords"), CORNERS, ids=[f"{entry.name}-{corner or 'defaults'}" for entry, corner in CORNERS]
)

Env = gymnasium.Env[Any, Any]

MODES = [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP, AutoresetMode.DISABLED]


def good_or_not(name: str, info: dict[str, Any], env: Any, actions: Any, rng: np.random.Generator) -> Any:
    """A good action four times of five where it is known which are, and else any."""
    informed, action, well = PARAMETERS[name].informed, actions.sample(), rng.random() < 0.8
    return informed(info, env) if informed and well else action


class Player:
    """Plays an environment, four of five actions well where it is known how, and resets it when an episode is over.

    Copied or pickled, it takes its environment along: both continue in the same way.
    """

    def __init__(self, env: Env, name: str, seed: int = 0) -> None:
        """Start an episode."""
        self.env, self.name = env, name
        self.bare: Any = env.unwrapped
        self.rng = np.random.default_rng(seed)
        self.actions = copy.deepcopy(env.action_space)
        self.actions.seed(seed)
        self.observation, self.info = env.reset(seed=seed)

    def choose(self) -> Any:
        """The next action."""
        return good_or_not(self.name, self.info, self.bare, self.actions, self.rng)

    def play(self, n_steps: int) -> list[Any]:
        """All that can be seen during some steps."""
        seen = []
        for _ in range(n_steps):
            action = self.choose()
            self.observation, reward, terminated, truncated, self.info = self.env.step(action)
            seen.append(plain((action, self.observation, reward, terminated, truncated, self.info)))
            if terminated or truncated:
                self.observation, self.info = self.env.reset()
                seen.append(plain((self.observation, self.info)))
        return seen


class Copies:
    """Single environments that share one random stream: what a vector environment of them has to equal."""

    def __init__(self, envs: list[Any], mode: AutoresetMode, seed: int) -> None:
        """Start an episode in each."""
        self.envs, self.mode = envs, mode
        self.observations: list[Any] = [None] * len(envs)
        self.infos: list[dict[str, Any]] = [{}] * len(envs)
        self.over = [False] * len(envs)
        for i, env in enumerate(envs):
            env.np_random = envs[0].np_random
            self.restart(i, seed if i == 0 else None)

    def restart(self, i: int, seed: int | None = None) -> None:
        """Start an episode in one of them."""
        self.observations[i], self.infos[i] = self.envs[i].reset(seed=seed)
        self.over[i] = False

    def step(self, actions: Any) -> tuple[Any, ...]:
        """One step of all, and the last observation of the episodes that ended and started anew in it."""
        n = len(self.envs)
        rewards, terminations, truncations, last = [0.0] * n, [False] * n, [False] * n, [None] * n
        for i, env in enumerate(self.envs):
            if self.over[i] and self.mode is AutoresetMode.NEXT_STEP:
                self.restart(i)
                continue
            self.observations[i], rewards[i], terminations[i], truncations[i], self.infos[i] = env.step(actions[i])
            self.over[i] = terminations[i] or truncations[i]
            if self.over[i] and self.mode is AutoresetMode.SAME_STEP:
                last[i] = self.observations[i]
                self.restart(i)
        return rewards, terminations, truncations, last


def plain(value: Any) -> Any:
    """A value without arrays, which compares with == (and exactly: by type and bit for bit)."""
    if isinstance(value, dict):
        return {key: plain(part) for key, part in value.items()}
    if isinstance(value, tuple | list):
        return tuple(plain(part) for part in value)
    if isinstance(value, np.ndarray):
        return str(value.dtype), value.shape, plain(value.ravel().tolist())
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.random.Generator):
        return plain(value.bit_generator.state)
    return value
