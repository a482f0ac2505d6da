"""What each swing of Golf is worth to a player who sees exactly where the ball lies, for every attitude to risk."""

from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np

from edugym.envs.golf import DISTANCES, SWINGS, Golf
from edugym.mdp.protocol import Reals
from edugym.system.extras import require

GUESSES = 49
"""At how many guesses of a value, from -1 to 1, its expected update is computed; between them it is interpolated."""

CROSSINGS = {
    0.05: 0.02356,
    0.1: 0.02395,
    0.15: 0.02438,
    0.19: 0.02475,
    0.23: 0.02514,
    0.27: 0.02558,
    0.3: 0.02592,
    0.33: 0.02629,
    0.36: 0.02669,
    0.39: 0.02710,
    0.42: 0.02755,
    0.45: 0.02802,
    0.48: 0.02852,
    0.5: 0.02887,
    0.52: 0.02924,
    0.54: 0.02962,
    0.56: 0.03002,
    0.58: 0.03044,
    0.6: 0.03087,
    0.62: 0.03131,
    0.64: 0.03178,
    0.66: 0.03227,
    0.68: 0.03277,
    0.7: 0.03330,
    0.72: 0.03385,
    0.74: 0.03442,
    0.76: 0.03501,
    0.78: 0.03563,
    0.8: 0.03628,
    0.81: 0.03661,
    0.82: 0.03695,
    0.83: 0.03730,
    0.84: 0.03766,
    0.85: 0.03802,
    0.86: 0.03839,
    0.87: 0.03877,
    0.88: 0.03916,
    0.89: 0.03956,
    0.9: 0.03996,
    0.91: 0.04038,
    0.92: 0.04080,
    0.93: 0.04124,
}
"""By the probability of a random swing after the first, what `crossing` gives with 5 hits; a test computes one."""


@cache
def from_the_tee(
    level: float, cell: float = 0.125, *, risk: float = 0.0, epsilon: float = 0.0, max_hits: int = 10
) -> dict[str, float]:
    """Return what each swing from the tee is worth, for a player who then plays as well as can be and sees the ball.

    V_h, the value of a place after h hits, is computed backwards from the last hit on a grid of places. A swing leads
    to its aim plus normal noise, so what it is worth is the mean of what all places are worth with normal weights: a
    product with one matrix for x and one for y. With β other than 0 it is the value at which the expected update of
    risk-sensitive Q-learning is 0, instead of the mean.

    Args:
        level: the stochasticity level, above 0.
        cell: the distance between places on the grid.
        risk: β, the attitude to risk, from -10 to 10.
        epsilon: the probability of a random swing, in every hit after the first.
        max_hits: the most hits of a game.
    """
    require("experiments", "scipy")
    from scipy.special import ndtr

    golf = Golf.create(stochasticity_level=level, max_hits=max_hits)
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
        payoff = 1 - (hits - 1) / golf.max_hits  # on the green
        each = []
        for swing, (tee, grid, at) in swings.items():
            each.append(interpolated(worth_of(grid, payoff, green, V, risk), *at))
            worth[swing] = float(worth_of(tee, payoff, green, V, risk)[0, 0])
        V = (1 - epsilon) * np.max(each, axis=0) + epsilon * np.mean(each, axis=0)
    return worth


def worth_of(weights: tuple[Reals, Reals], payoff: float, green: Reals, V: Reals, risk: float) -> Reals:
    """Return what swings are worth that lead to the cells of a grid with these probabilities.

    Args:
        weights: the probabilities for x and for y; what is missing to 1 is the probability of a lost ball.
        payoff: the reward on the green.
        green: the share of each cell that belongs to the green.
        V: the value of each cell beside the green.
        risk: β.
    """
    across, along = weights

    def mean(of: Callable[[Any], Any]) -> Reals:
        lost = of(-1.0)  # all probabilities are those above a lost ball
        inside = green * (of(payoff) - lost) + (1 - green) * (of(V) - lost)
        total: Reals = across @ inside @ along.T + lost
        return total

    if risk == 0.0:
        return mean(lambda value: value)
    guesses = np.linspace(-1.0, 1.0, GUESSES)
    updates = np.array([mean(partial(_update, risk=risk, guess=guess)) for guess in guesses])
    # The expected update falls with the guess; the value is where it is 0.
    after = np.clip(np.argmax(updates <= 0.0, axis=0), 1, GUESSES - 1)
    high, low = (np.take_along_axis(updates, at[np.newaxis], 0)[0] for at in (after - 1, after))
    value: Reals = guesses[after - 1] + (guesses[after] - guesses[after - 1]) * high / np.maximum(high - low, 1e-300)
    return np.clip(value, -1.0, 1.0)


def _update(value: Any, risk: float, guess: float) -> Any:
    return weighted(risk, value - guess)


def weighted(risk: float, delta: Any) -> Any:
    """Return 2σ(βδ) δ: a TD error, weighted as risk-sensitive Q-learning does."""
    return (1.0 + np.tanh(risk * delta / 2.0)) * delta


def interpolated(values: Reals, i: Reals, j: Reals) -> Reals:
    """Return values between those of a grid, shape (n, m), at places that are counted in its steps (bilinear)."""
    down, left = i.astype(int), j.astype(int)
    u, v = i - down, j - left
    low = (1 - v) * values[down, left] + v * values[down, left + 1]
    high = (1 - v) * values[down + 1, left] + v * values[down + 1, left + 1]
    between: Reals = (1 - u) * low + u * high
    return between


def crossing(low: float = 0.018, high: float = 0.0195, **player: Any) -> float:
    """Return the level at which drive and chip from the tee are worth the same, by three steps of false position.

    Args:
        low: a level at which the drive is worth more.
        high: a level at which the chip is worth more.
        player: more arguments of `from_the_tee`.
    """

    def lead(level: float) -> float:
        worth = from_the_tee(level, **player)
        return worth["drive"] - worth["chip"]

    for _ in range(3):
        middle = low + (high - low) * lead(low) / (lead(low) - lead(high))
        low, high = (middle, high) if lead(middle) > 0 else (low, middle)
    return middle


def optimum(level: float) -> float:
    """Return the best expected return; without noise it takes two hits."""
    return max(from_the_tee(level).values()) if level > 0 else 0.9


def soft_optimum(level: float, epsilon: float) -> float:
    """Return the best expected return of a player who takes a random swing with probability ε; `level` is above 0."""
    worth = [*from_the_tee(level, epsilon=epsilon).values()]
    return float((1 - epsilon) * max(worth) + epsilon * np.mean(worth))


def certain_value(outcomes: Any, probabilities: Any, risk: float) -> float:
    """Return the value that risk-sensitive Q-learning learns for a step that pays by chance, and ends.

    It is the number from which an update moves neither up nor down on average, found by bisection.

    Args:
        outcomes: the rewards.
        probabilities: how likely each of them is.
        risk: β.
    """
    rewards, chances = np.asarray(outcomes, float), np.asarray(probabilities, float)
    low, high = float(rewards.min()), float(rewards.max())
    for _ in range(60):
        middle = (low + high) / 2
        up = float(chances @ weighted(risk, rewards - middle)) > 0.0
        low, high = (middle, high) if up else (low, middle)
    return (low + high) / 2
