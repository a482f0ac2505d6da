"""A weighted sum of the objectives as the reward, so that every agent can learn on it."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.parameters import an_array, in_short
from edugym.mdp.multi_objective import require_objectives
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.wrapper import wrapper


@wrapper
class Weighted(NamedTuple):
    """The same task, but its reward is the weighted sum of the vector of rewards: w₁ r₁ + w₂ r₂ + ...

        run = edugym.train(Weighted.create(mdp, (1.0, 4.0)), agent, 100_000)

    A policy that is best for some weights above 0 is Pareto-optimal. But many Pareto-optimal policies are best for no
    weights (see `edugym.objectives.supported`).

    Attributes:
        mdp: the task with several objectives.
        weights: shape (n_objectives,): the weights, of 0 or more.
    """

    mdp: Any
    weights: Reals

    def rewards(self, state: Any, action: int, next_state: Any) -> Sequence[float]:
        """The vector of rewards of the task."""
        rewards: Sequence[float] = self.mdp.rewards(state, action, next_state)
        return rewards

    def reward(self, state: Any, action: int, next_state: Any, rng: Random) -> float:
        """Its weighted sum."""
        rewards = self.mdp.rewards(state, action, next_state)
        total = 0.0
        for i in range(len(self.weights)):
            total += self.weights[i] * rewards[i]
        return total

    @property
    def reward_threshold(self) -> None:
        """The best return is not known here: it depends on the weights."""
        return None

    @classmethod
    def create(cls, mdp: Any, weights: Any) -> "Weighted":
        """Wrap a task.

        Args:
            mdp: a task with several objectives, such as `Diver`.
            weights: a finite number of 0 or more for each objective, not all 0.

        Raises:
            ValueError: `mdp` has no several objectives, or the weights are not as above.
        """
        played = require_objectives(mdp)
        return cls(played, weights_for(weights, played.reward_space.shape[0]))


def weights_for(weights: Any, n_objectives: int) -> Reals:
    """Weights that a user gave, as an array.

    Raises:
        ValueError: they are not finite numbers of 0 or more, one for each objective and not all 0.
    """
    checked = an_array("weights", weights, (n_objectives,))
    if not (np.isfinite(checked).all() and (checked >= 0).all() and (checked > 0).any()):
        raise ValueError(f"weights must be finite numbers of 0 or more, not all 0, but is {in_short(weights)}")
    return np.array(checked, np.float64)
