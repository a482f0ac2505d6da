"""Noise in what the agent sees."""

from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.parameters import MOST_STEPS, a_number, at_least, whole_number
from edugym.mdp.in_place import blank, in_place, written
from edugym.mdp.protocol import Random
from edugym.mdp.task import task_of
from edugym.mdp.wrapper import wrapper


@wrapper
class NoisyObservation(NamedTuple):
    """An MDP whose observations are noisy: in one number of few levels, in all numbers, or both.

    The noise is drawn anew at every step. What leaves the range of the observation space is cut off.

    Make one with `NoisyObservation.create(mdp, levels=256)` or `(mdp, sigma=0.1)`.

    Attributes:
        mdp: the task, which observes an array (an image, for instance).
        levels: how many values the first number (of an image, in the top left pixel) takes instead of what it showed,
            evenly spread over its range, each as likely; 0 or 1 for none of this noise.
        sigma: the standard deviation of the normal noise that is added to every number, in units of the observation.
        low: the lowest number that may be observed.
        high: the highest.
        blank: an observation, empty.
    """

    mdp: Any
    levels: int
    sigma: float
    low: float
    high: float
    blank: Any

    def observation(self, state: Any, rng: Random) -> Any:
        """What `observe_into` writes, as a new array."""
        return written(self, state, rng)

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write what the task shows, and the noise over it."""
        self.mdp.observe_into(state, rng, out)
        if self.levels > 1:
            level = int(rng.random() * self.levels)
            out.flat[0] = self.low + (self.high - self.low) * level / (self.levels - 1)
        if self.sigma > 0.0:
            for k in range(out.size):
                out.flat[k] = min(max(float(out.flat[k]) + rng.normal(0.0, self.sigma), self.low), self.high)

    @classmethod
    def create(cls, mdp: Any, levels: int = 0, sigma: float = 0.0) -> "NoisyObservation":
        """The wrapper for an MDP that observes an array, whose numbers all have the same bounds.

        Args:
            mdp: the task.
            levels: of the noise in the first number, from 0 to 2^62.
            sigma: of the noise in every number, 0 or more.

        Raises:
            ValueError: the task observes something else, or a number is not as said.
        """
        low, high = bounds(mdp)
        levels = whole_number("levels", levels, 0, MOST_STEPS)
        at_least("sigma", sigma, 0)
        a_number("sigma", sigma)
        mdp = in_place(mdp)
        return cls(mdp, levels, float(sigma), low, high, blank(mdp))


def bounds(mdp: Any) -> tuple[float, float]:
    """The lowest and the highest number in the observations of an MDP.

    Raises:
        ValueError: it does not observe an array, or one without bounds, or with different ones.
    """
    task_of(mdp, "mdp", MDP_ONLY)
    space = mdp.observation_space
    if not isinstance(space, spaces.Box):
        raise ValueError(f"mdp must observe an array (a Box), but its observation space is {space}")
    low, high = float(space.low.min()), float(space.high.max())
    if not space.is_bounded() or (space.low != low).any() or (space.high != high).any():
        raise ValueError(f"the numbers that mdp observes must all have the same finite bounds, but are {space}")
    return low, high
