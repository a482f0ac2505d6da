"""The figures of lesson 12."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import With
from edugym.experiments.figures.sheet import Sheet
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import INK
from edugym.training.train_vectors import VectorRun
from edugym_course.lessons.objectives.methods import (
    LIMIT,
    TIME_WEIGHTS,
    closest,
    found_by_weights,
    front_of,
    lagrangian,
    late,
    too_long,
    treasure_of,
    weighted,
)
from edugym_course.lessons.objectives.panels import Front

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BLOCK = 100
"""Over so many dives a share is taken."""
CONCAVITIES = (0.0, 0.5, 1.0)
TICKS = (0.15, 0.5, 1.5, 5.0, 15.0, 60.0)
"""The weights of time that an axis names."""


def front(concavity: float, **more: Any) -> Sheet:
    """Return the front, and what lies around it."""
    return Sheet("front", [[Front(front_of(concavity), f"concavity {concavity:g}", **more)]])


def one_weight(price: float, concavity: float = 0.5) -> Sheet:
    """Return what Q-learning picks up for one price, with the line of all that is as good, for sliders."""
    found = {"Q-learning": [treasure_of(weighted(concavity, price).returns[-1])]}
    return front(concavity, found=found, weights=(1.0, price))


def by_weights(concavities: Sequence[float] = CONCAVITIES, seed: int = 0) -> Sheet:
    """Return what Q-learning finds with all prices, by the concavity."""
    panels = [
        Front(front_of(c), f"concavity {c:g}", {"found by some weights": found_by_weights(c, seed)})
        for c in concavities
    ]
    return Sheet("by_weights", [panels])


def by_distance(concavity: float, found: Mapping[str, Sequence[int]]) -> Sheet:
    """Return which treasure is picked up against the weight of time, and which one is the closest."""
    lines = {label: np.array(treasures, float) for label, treasures in found.items()}
    x = np.log10(TIME_WEIGHTS)

    def mark(ax: "Axes") -> None:
        ax.scatter(x, closest(concavity), 30, facecolors="white", edgecolors=INK, zorder=3, label="closest")
        ax.set_xticks(np.log10(TICKS), [f"{weight:g}" for weight in TICKS])

    panel = Lines(x, lines, f"concavity {concavity:g}", "weight of time", "treasure")
    return Sheet("by_distance", [[With(panel, mark)]])


def shares_too_long(runs: Mapping[str, VectorRun], limit: int = LIMIT, most: int = 2_000) -> With:
    """Return how many of each hundred training dives take too long, by label."""
    n = min([most, *(len(run.training_returns) for run in runs.values())]) // BLOCK
    shares = {
        label: too_long(run.training_returns[: n * BLOCK], limit).reshape(n, BLOCK).mean(axis=1)
        for label, run in runs.items()
    }
    lines = Lines(BLOCK * np.arange(1.0, n + 1), shares, "while it learns", "dives", "share that takes too long")
    return With(lines, lambda ax: ax.set_ylim(-0.03, 1.0))


def under_a_limit(concavity: float, first_price: float = 0.0, limit: int = LIMIT) -> Sheet:
    """Return what the agent with a limit does in the end, and while it learns, for sliders."""
    run = lagrangian(concavity, limit, first_price=first_price)
    ends = [treasure_of(returns) for returns in np.unique(late(run), axis=0)]
    picture = Front(front_of(concavity), f"concavity {concavity:g}", {"dives in the end": ends}, limit=limit)
    return Sheet("under_a_limit", [[picture, shares_too_long({"all dives": run}, limit)]])


def sets(points: Mapping[int, Reals], concavity: float) -> Sheet:
    """Return the points that Pareto Q-learning has at the start, after so many steps."""
    exact = front_of(concavity)
    panels = []
    for steps, found in points.items():
        known = [int(np.abs(exact - point).sum(axis=1).argmin()) for point in found if point in exact]
        panels.append(Front(exact, f"after {steps} steps", {"Pareto Q-learning": known}))
    return Sheet("sets", [panels])
