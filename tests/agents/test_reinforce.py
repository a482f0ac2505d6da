"""REINFORCE: an episode worked out by hand, and the baseline's use."""

import numpy as np
import pytest

from edugym import REINFORCE
from tests.agents.case import Case

CASES = {"REINFORCE": Case(REINFORCE, lambda env: REINFORCE.create(env, longest=200))}


@pytest.mark.parametrize(("terminated", "last"), [(True, 0.0), (False, 8.0)])
def test_an_episode(terminated: bool, last: float) -> None:
    """States 0, 1 and 0 again, rewards 1, 2 and 3, γ = 1/2; it ends, or is truncated in state 2, which is worth 8.

    Returns: G₂ = 3 + last/2, G₁ = 2 + G₂/2, G₀ = 1 + G₁/2. Baseline: V(0) is updated before it is used again.
    """
    agent = REINFORCE.create((3, 2), learning_rate=0.2, value_learning_rate=0.1, discount=0.5)
    agent.V[:] = [1.0, 0.0, 8.0]
    agent.learn(0, 0, 1.0, 1, False, False)
    agent.learn(1, 1, 2.0, 0, False, False)
    assert not agent.preferences.any()  # nothing before the end of the episode
    agent.learn(0, 0, 3.0, 2, terminated, not terminated)
    G = [0.0, 0.0, 3 + last / 2]
    G[1] = 2 + G[2] / 2
    G[0] = 1 + G[1] / 2
    first = 1.0 + 0.1 * (G[0] - 1.0)
    assert pytest.approx([first + 0.1 * (G[2] - first), 0.1 * G[1], 8.0]) == agent.V
    step = 0.2 * (G[0] - 1.0) / 2  # π = 1/2 at first
    p = np.exp(step) / (np.exp(step) + np.exp(-step))
    step += 0.2 * 0.25 * (G[2] - first) * (1 - p)
    assert agent.preferences[0] == pytest.approx([step, -step])
    assert agent.preferences[1] == pytest.approx(0.2 * 0.5 * G[1] * np.array([-0.5, 0.5]))
    assert agent.episode.length[0] == 0


def test_a_long_episode_is_learned_from_in_parts() -> None:
    """With room for two steps the second one is treated as the last before a truncation."""
    agent = REINFORCE.create((2, 2), longest=2)
    agent.learn(0, 0, 1.0, 1, False, False)
    assert not agent.preferences.any()
    agent.learn(1, 0, 1.0, 0, False, False)
    assert agent.preferences.any()
    assert agent.episode.length[0] == 0
    with pytest.raises(ValueError, match="longest must be 1 or more, but is 0"):
        REINFORCE.create((2, 2), longest=0)


def test_the_baseline_makes_updates_less_noisy() -> None:
    """Rewards are 10 and noise; the preferences wander less far with a baseline, though they are worth the same."""

    def wandering(value_learning_rate: float, seed: int) -> float:
        agent = REINFORCE.create((1, 2), learning_rate=0.01, value_learning_rate=value_learning_rate)
        rng = np.random.default_rng(seed)
        for _ in range(500):
            agent.learn(0, agent.act(0, rng), 10 + rng.normal(), 0, True, False)
        return float(abs(agent.preferences[0, 0]))

    without, with_one = (np.mean([wandering(rate, seed) for seed in range(20)]) for rate in (0.0, 0.1))
    assert with_one < without / 2
