"""Thompson sampling: an exploration strategy that believes, draws from its belief, and acts on what it drew."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Range, Table, new
from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Integers, Random, Reals


class ThompsonSampling(NamedTuple):
    """Choose each action as often as it is probably the best one: draw a value of each, and take the largest.

        θ(a) ~ N(Q(s, a), σ² / N(s, a)),    A = argmax_a θ(a)

    If Q(s, a) is the mean of N(s, a) rewards, as with `SampleAverage`, and their noise is normal with spread σ, this is
    the posterior distribution of the mean reward of a (with a flat prior, before anything is known). For rewards
    between two bounds σ is at most half their distance, 0.5 for rewards of 0 and 1. An action that was never chosen in
    a state comes first.

    Attributes:
        counts: shape (n_states, n_actions): N(s, a), how often each action was chosen in each state.
        drawn: shape (1, n_actions): θ, the values drawn last.
        spread: σ, the standard deviation of the noise of the rewards, a finite number of 0 or more; 0 is greedy.

    References: Thompson (1933); Russo, Van Roy, Kazerouni, Osband and Wen (2018), A tutorial on Thompson sampling;
    Korda, Kaufmann and Munos (2013), for the flat prior.
    """

    counts: Annotated[Integers, Table(("states", "actions"))]
    drawn: Annotated[Reals, Table((1, "actions"))]
    spread: Annotated[float, Range(0)] = 1.0

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """Draw a value of each action, choose the action with the largest (ties at random), and count it."""
        for action in range(Q.shape[1]):
            n = self.counts[state, action]
            self.drawn[0, action] = rng.normal(Q[state, action], self.spread / math.sqrt(n)) if n > 0 else math.inf
        chosen = greedy_action(self.drawn, 0, rng)
        self.counts[state, chosen] += 1
        return chosen

    @classmethod
    def create(cls, environment: Any, spread: float = 1.0) -> "ThompsonSampling":
        """A strategy that has chosen nothing yet, for an environment (or the shape of its table).

        Raises:
            ValueError: the spread is not as above, or the environment does not fit a table.
        """
        return new(cls, environment, {"spread": spread})
