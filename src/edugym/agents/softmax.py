"""A policy by preferences: π(a|s) ∝ exp(θ(s, a)), how it chooses, and the gradient of its logarithm.

Reference: Sutton and Barto, Reinforcement Learning, 2nd edition, section 13.1.
"""

import math

from edugym.agents.tables import best_value
from edugym.mdp.protocol import Random, Reals


def softmax(preferences: Reals, state: int, probabilities: Reals) -> None:
    """Write π(·|s) into `probabilities`, shape (n_actions,): equation 13.2 with a table of preferences.

    The highest preference is subtracted from all, which changes nothing but that no exponential is too large.
    """
    highest = best_value(preferences, state)
    total = 0.0
    for action in range(len(probabilities)):
        probabilities[action] = math.exp(preferences[state, action] - highest)
        total += probabilities[action]
    for action in range(len(probabilities)):
        probabilities[action] /= total


def draw_action(probabilities: Reals, rng: Random) -> int:
    """An action drawn with these probabilities, shape (n_actions,)."""
    left = rng.random()
    for action in range(len(probabilities) - 1):
        left -= probabilities[action]
        if left < 0.0:
            return action
    return len(probabilities) - 1


def follow_log_gradient(preferences: Reals, state: int, action: int, probabilities: Reals, size: float) -> None:
    """Add `size` times ∇ln π(A|s) to the preferences: 1 - π(A|s) for the action itself, -π(a|s) for any other.

    Args:
        preferences: θ, shape (n_states, n_actions).
        state: s.
        action: A.
        probabilities: π(·|s), shape (n_actions,).
        size: of the step; negative to make the action rarer.
    """
    for a in range(len(probabilities)):
        preferences[state, a] += size * ((1.0 if a == action else 0.0) - probabilities[a])
