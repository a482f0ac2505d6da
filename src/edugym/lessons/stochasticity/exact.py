"""What each swing of Golf is worth to a player who sees exactly where the ball lies."""

from functools import cache

import numpy as np

from edugym.envs.golf import DISTANCES, SWINGS, Golf
from edugym.extras import require
from edugym.mdp.protocol import Reals


@cache
def from_the_tee(level: float, cell: float = 0.125) -> dict[str, float]:
    """Return what each swing from the tee is worth, for a player who then plays as well as can be and sees the ball.

    V_h, the value of a place after h hits, is computed backwards from the last hit on a grid of places. A swing leads
    to its aim plus normal noise, so what it is worth is the mean of what all places are worth with normal weights: a
    product with one matrix for x and one for y.

    Args:
        level: the stochasticity level, above 0.
        cell: the distance between places on the grid.
    """
    require("experiments", "scipy")
    from scipy.special import ndtr

    golf = Golf.create(stochasticity_level=level)
    flag_x, flag_y = golf.width / 2, golf.length - golf.width / 2
    edges_x, edges_y = (np.linspace(0, size, round(size / cell) + 1) for size in (golf.width, golf.length))
    x, y = np.meshgrid(edges_x[:-1] + cell / 2, edges_y[:-1] + cell / 2, indexing="ij")
    parts = (np.arange(5) - 2) * cell / 5
    green = np.mean([np.hypot(x + dx - flag_x, y + dy - flag_y) < golf.green_radius for dx in parts for dy in parts], 0)

    def weights(places: Reals, edges: Reals, deviation: float) -> Reals:
        """The probability of each cell of the grid, shape (places, cells)."""
        return np.diff(ndtr((edges - places[:, np.newaxis]) / deviation), axis=1)

    distance = np.hypot(flag_x - x, flag_y - y)
    swings = {}
    for swing, d in zip(SWINGS, DISTANCES, strict=True):
        # The probabilities of cells for balls from the tee, and for balls aimed at a grid around the course.
        deviation = level * d * d
        tee = weights(np.array([flag_x]), edges_x, deviation), weights(np.array([d]), edges_y, deviation)
        around = [np.arange(-d, size + d + 3 * cell, 2 * cell) for size in (golf.width, golf.length)]
        grid = weights(around[0], edges_x, deviation), weights(around[1], edges_y, deviation)
        aim = x + d * (flag_x - x) / distance, y + d * (flag_y - y) / distance
        swings[swing] = tee, grid, [(place + d) / (2 * cell) for place in aim]

    worth: dict[str, float] = {}
    V = np.full_like(x, -1.0)  # out of hits
    for hits in range(golf.max_hits, 0, -1):
        payoff = green * (1 - (hits - 1) / golf.max_hits) + (1 - green) * V + 1  # above what a lost ball pays
        best = np.full_like(x, -np.inf)
        for swing, (tee, grid, at) in swings.items():
            best = np.maximum(best, interpolated(grid[0] @ payoff @ grid[1].T - 1, *at))
            worth[swing] = float((tee[0] @ payoff @ tee[1].T)[0, 0]) - 1
        V = best
    return worth


def interpolated(values: Reals, i: Reals, j: Reals) -> Reals:
    """Return values between those of a grid, shape (n, m), at places that are counted in its steps (bilinear)."""
    down, left = i.astype(int), j.astype(int)
    u, v = i - down, j - left
    low = (1 - v) * values[down, left] + v * values[down, left + 1]
    high = (1 - v) * values[down + 1, left] + v * values[down + 1, left + 1]
    between: Reals = (1 - u) * low + u * high
    return between


def crossing(low: float = 0.018, high: float = 0.0195) -> float:
    """Return the level at which drive and chip from the tee are worth the same, by three steps of false position."""

    def lead(level: float) -> float:
        worth = from_the_tee(level)
        return worth["drive"] - worth["chip"]

    for _ in range(3):
        middle = low + (high - low) * lead(low) / (lead(low) - lead(high))
        low, high = (middle, high) if lead(middle) > 0 else (low, middle)
    return middle


def optimum(level: float) -> float:
    """Return the best expected return; without noise it takes two hits."""
    return max(from_the_tee(level).values()) if level > 0 else 0.9
