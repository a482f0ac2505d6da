"""What Gymnasium itself puts around an environment: statistics, copies in a row and in processes, and a window."""

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AsyncVectorEnv, SyncVectorEnv
from gymnasium.vector.utils import iterate
from gymnasium.wrappers import HumanRendering, RecordEpisodeStatistics

from edugym.adapters.registration import Entry
from tests.contract.play import every_environment, plain

SEEDS = [7, 8]
STEPS = 50


def statistics(entry: Entry) -> None:
    """Of three episodes: the sum of their rewards and the number of their steps."""
    env: Any = RecordEpisodeStatistics(gymnasium.make(entry.id))
    env.action_space.seed(0)
    for seed in range(3):
        env.reset(seed=seed)
        rewards, over = [], False
        while not over:
            _, reward, terminated, truncated, info = env.step(env.action_space.sample())
            rewards.append(reward)
            over = terminated or truncated
        assert info["episode"]["r"] == pytest.approx(sum(rewards))
        assert info["episode"]["l"] == len(rewards)


def shown_alone(entry: Entry, seed: int, actions: list[Any]) -> list[Any]:
    """What one environment shows where the step after an episode's last one begins the next."""
    env: Any = gymnasium.make(entry.id)
    seen: list[Any] = [(env.reset(seed=seed)[0],)]
    over = False
    for action in actions:
        seen.append((env.reset()[0], 0.0, False, False) if over else env.step(action)[:4])
        over = seen[-1][2] or seen[-1][3]
    return seen


def copies(entry: Entry, kind: Callable[..., Any]) -> None:
    """Each of two copies shows what an environment with its seed shows alone, type and shape included."""
    vector = kind([lambda: gymnasium.make(entry.id)] * 2)
    vector.action_space.seed(0)
    actions = [vector.action_space.sample() for _ in range(STEPS)]
    seen = [(vector.reset(seed=SEEDS)[0],), *(vector.step(action)[:4] for action in actions)]
    vector.close()
    for i, seed in enumerate(SEEDS):
        expected = shown_alone(entry, seed, [list(iterate(vector.action_space, action))[i] for action in actions])
        for (observations, *rest), (alone, *others) in zip(seen, expected, strict=True):
            assert plain(list(iterate(vector.observation_space, observations))[i]) == plain(alone)
            assert plain([values[i] for values in rest]) == plain(others)


def sync(entry: Entry) -> None:
    """In one process."""
    copies(entry, SyncVectorEnv)


def processes(entry: Entry) -> None:
    """Each in a process of its own, which shares its observations by memory."""
    copies(entry, AsyncVectorEnv)


def window(entry: Entry) -> None:
    """It has the picture of the environment in it, and is gone when it is closed."""
    pygame = pytest.importorskip("pygame")
    env: Any = gymnasium.make(entry.id, render_mode="rgb_array")
    env.unwrapped.metadata = {**env.unwrapped.metadata, "render_fps": 10_000}  # no waiting between two pictures
    shown: Any = HumanRendering(env)
    shown.reset(seed=0)
    shown.action_space.seed(0)
    for _ in range(5):
        _, _, terminated, truncated, _ = shown.step(shown.action_space.sample())
        pixels = np.swapaxes(pygame.surfarray.array3d(shown.window), 0, 1)
        assert np.array_equal(pixels, env.render())
        if terminated or truncated:
            shown.reset()
    shown.close()
    assert not pygame.display.get_init()


@every_environment
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")  # Python's own, of what Gymnasium does by default
@pytest.mark.parametrize("works", [statistics, sync, pytest.param(processes, marks=pytest.mark.slow), window])
def test_gymnasiums_machinery(entry: Entry, works: Callable[[Entry], None]) -> None:
    """Gymnasium's own statistics, copies and window work with every environment as with those that it brings."""
    works(entry)
