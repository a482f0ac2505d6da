"""Images that are brighter or darker from step to step."""

from typing import Any, NamedTuple

from edugym.checks.parameters import between
from edugym.mdp.in_place import blank, in_place, written
from edugym.mdp.noisy_observation import bounds
from edugym.mdp.protocol import Random
from edugym.mdp.wrapper import wrapper


@wrapper
class Brightness(NamedTuple):
    """An MDP whose images are darkened: at every step all numbers are multiplied by a factor, drawn uniformly.

    Make one with `Brightness.create(mdp, low, high)`.

    Attributes:
        mdp: the task, which observes an array of numbers from 0 on.
        low: the lowest factor, from 0 to 1.
        high: the highest factor, from `low` to 1.
        blank: an observation, empty.
    """

    mdp: Any
    low: float
    high: float
    blank: Any

    def observation(self, state: Any, rng: Random) -> Any:
        """What `observe_into` writes, as a new array."""
        return written(self, state, rng)

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write what the task shows, darkened."""
        self.mdp.observe_into(state, rng, out)
        factor = self.low + (self.high - self.low) * rng.random()
        for k in range(out.size):
            out.flat[k] = factor * float(out.flat[k])

    @classmethod
    def create(cls, mdp: Any, low: float = 0.4, high: float = 1.0) -> "Brightness":
        """The wrapper for an MDP that observes an array.

        Args:
            mdp: the task.
            low: the lowest factor, from 0 to 1.
            high: the highest factor, from `low` to 1.

        Raises:
            ValueError: the task observes something else, or a number is not as said.
        """
        darkest, _ = bounds(mdp)
        between("low", low, 0, 1)
        between("high", high, low, 1)
        if darkest != 0.0:
            raise ValueError(f"the numbers that mdp observes must begin at 0, but are {mdp.observation_space}")
        mdp = in_place(mdp)
        return cls(mdp, float(low), float(high), blank(mdp))
