"""Tile coding: a few overlapping grids over the observation."""

import math
from collections.abc import Sequence
from typing import Annotated, Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.agents.features import NO_VECTOR
from edugym.agents.settings import Table, check
from edugym.agents.vectors import UNBOUNDED, vector_bounds, vector_size
from edugym.checks.parameters import an_array, in_short, whole_number
from edugym.mdp.protocol import Integers, Reals
from edugym.system.memory import in_digits

MOST_FEATURES = 10_000_000


class TileCoding(NamedTuple):
    """Grids over the space of observations, each a little displaced; a feature is a tile, and 1 if the state is in it.

    One tile of each grid (tiling) is active at a time. States that share a tile share what is learned there, and the
    more tiles, the nearer they are. The k-th of n tilings is displaced by k/n of a tile's width times 1, 3, 5, ...
    along the axes, which spreads the tilings more evenly than the same for all. A learning rate is divided by the
    number of tilings: a rate of 1 corrects the whole error at once.

    Every tile has a weight of its own: there is no hashing, so no two places are confused.

    Attributes:
        active: shape (n_tilings,): which features are 1.
        values: shape (n_tilings,): all 1.
        low: shape (n_inputs,): where the grid begins, for each number in an observation; what is lower counts as this.
        high: shape (n_inputs,): where it ends, likewise.
        tiles: shape (n_inputs,): into how many tiles it is divided from `low` to `high`; 1 leaves a number out.

    Reference: Sutton and Barto, 2nd edition, section 9.5.4.
    """

    active: Annotated[Integers, Table(("tilings",))]
    values: Annotated[Reals, Table(("tilings",))]
    low: Annotated[Reals, Table(("inputs",))]
    high: Annotated[Reals, Table(("inputs",))]
    tiles: Annotated[Integers, Table(("inputs",))]

    @property
    def n_inputs(self) -> int:
        """How many numbers an observation has."""
        return len(self.low)

    @property
    def n_features(self) -> int:
        """How many tiles there are. Displacement needs one more along each axis than there are from `low` to `high`."""
        n = len(self.active)
        for i in range(len(self.tiles)):
            if self.tiles[i] > 1:
                n *= self.tiles[i] + 1
        return n

    @property
    def at_once(self) -> int:
        """As many features as tilings are 1 at once."""
        return len(self.active)

    @property
    def n_active(self) -> int:
        """One of each tiling."""
        return len(self.active)

    def see(self, state: Any) -> None:
        """Find the tile of each tiling in which an observation is, number by number: tile = tile · n + place.

        Raises:
            ValueError: the state is no vector with a number for each input.
        """
        if len(state) != len(self.low):
            raise ValueError(NO_VECTOR)
        n_tilings = len(self.active)
        for k in range(n_tilings):
            self.active[k] = k
        displacement = 1
        for i in range(len(self.low)):
            if self.tiles[i] > 1:
                share = (float(state[i]) - self.low[i]) / (self.high[i] - self.low[i])
                place = min(max(0.0, share), 1.0) * self.tiles[i]  # in tiles, from 0
                for k in range(n_tilings):
                    shift = displacement * k % n_tilings / n_tilings
                    self.active[k] = self.active[k] * (self.tiles[i] + 1) + int(place + shift)
                displacement += 2

    @classmethod
    def create(
        cls,
        environment: Any,
        tiles: int | Sequence[int] = 8,
        tilings: int = 8,
        low: Sequence[float] | None = None,
        high: Sequence[float] | None = None,
    ) -> "TileCoding":
        """Tile coding for an environment (or the shape (n_inputs, n_actions), whose numbers are from 0 to 1).

        Args:
            environment: an MDP or Gymnasium environment with observations that are numbers.
            tiles: into how many tiles each number is divided, 1 or more: one number for all, or one for each; 1 leaves
                a number out.
            tilings: how many grids there are, 1 or more; best a power of two, and at least four times as many as the
                numbers that are not left out. (The grids are displaced by 1, 3, 5, ... steps in the first, second,
                third, ... number. With 3 tilings, for example, nothing would be displaced in the second number.)
            low: the lowest value that each number takes; by default that of the observation space.
            high: the highest, likewise. Both must be given where the observation space has no bounds, or bounds that
                are a billion or more apart.

        Raises:
            ValueError: a parameter is not as above, or there would be more than ten million tiles.
        """
        box = isinstance(getattr(environment, "action_space", None), spaces.Box)
        n_inputs, _ = vector_size(environment, spaces.Box if box else spaces.Discrete)
        lows, highs = vector_bounds(environment)
        lows = lows if low is None else an_array("low", low, (n_inputs,))
        highs = highs if high is None else an_array("high", high, (n_inputs,))
        counts: list[Any] = (
            list(tiles) if isinstance(tiles, list | tuple | np.ndarray) and np.ndim(tiles) else [tiles] * n_inputs
        )
        if len(counts) != n_inputs or np.ndim(tiles) > 1:
            raise ValueError(
                f"tiles must be a whole number, or {n_inputs}, one for each input, but is {in_short(tiles)}"
            )
        counts = [whole_number("tiles", count, 1, MOST_FEATURES) for count in counts]
        tilings = whole_number("tilings", tilings, 1, MOST_FEATURES)
        for i in range(n_inputs):
            if counts[i] > 1 and not (lows[i] < highs[i] and highs[i] - lows[i] < UNBOUNDED):
                raise ValueError(
                    "low and high must be the bounds of the observation, the lower first and less than a billion apart,"
                    f" but number {i} is from {lows[i]} to {highs[i]}: give low=[...] and high=[...], or"
                    " leave it out by 1 in tiles"
                )
        n_tiles = tilings * math.prod(count + 1 for count in counts if count > 1)
        if n_tiles > MOST_FEATURES:
            raise ValueError(
                f"tiles and tilings must make at most {MOST_FEATURES:,} tiles, but {in_short(tiles)} and {tilings} make"
                f" {in_digits(n_tiles)}: leave numbers out by 1"
            )
        lows, highs = (np.where(np.array(counts) > 1, bounds, 0.0) for bounds in (lows, highs))
        made = cls(np.zeros(tilings, np.int64), np.ones(tilings), lows, highs, np.array(counts, np.int64))
        check(made)
        return made
