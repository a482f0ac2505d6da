"""The figures of lesson 1."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from edugym.experiments.figures import Curves, Lines, Sheet, VisitMap
from edugym.experiments.figures.panel import With
from edugym.experiments.figures.sheet import in_pairs
from edugym.experiments.figures.style import format_steps
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers
from edugym_course.lessons.exploration.climbs import later, no_slip, share_of_climbs
from edugym_course.lessons.exploration.methods import (
    EPSILON,
    HEIGHTS,
    METHODS,
    N_STEPS,
    REPETITIONS,
    Maker,
    best_return,
    compare,
    visits_of,
)
from edugym_course.reporting import for_mdp

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def learning_curves(by_height: Mapping[int, Results], n_grips: int = 2, epsilon: float = EPSILON) -> Sheet:
    """Return the paper's figure: a panel for each height, and the progress on the highest wall."""
    panels = [curves(results, height, n_grips, epsilon) for height, results in by_height.items()]
    highest = max(by_height)
    return in_pairs("exploration", [*panels, progress(by_height[highest], highest)])


def race(
    own: Mapping[str, Maker],
    heights: Sequence[int] = HEIGHTS,
    *,
    n_grips: int = 2,
    repetitions: int = REPETITIONS,
    **how: Any,
) -> Sheet:
    """Return the paper's figure with methods of the reader's own beside its three.

    Args:
        own: by label, functions that make an agent for a wall, which is the MDP itself: `wall.height` is there.
        heights: the heights of the walls, one panel for each.
        n_grips: the number of grips at every height, 2 or more.
        repetitions: the number of runs of each method, each on a wall of its own.
        **how: more arguments of `compare`.
    """
    methods = {**METHODS, **{label: for_mdp(make) for label, make in own.items()}}
    compared = {
        height: compare(height, methods=methods, n_grips=n_grips, repetitions=repetitions, **how) for height in heights
    }
    return learning_curves(compared, n_grips)._replace(name="race")


def curves(results: Results, height: int, n_grips: int = 2, epsilon: float = EPSILON) -> Curves:
    """Return the learning curves of all methods on walls of one kind, with what is possible."""
    return Curves(
        results,
        f"height {height}" if n_grips == 2 else f"height {height}, {n_grips} grips",
        share=True,
        optimum=best_return(height, n_grips=n_grips),
        soft_optimum=best_return(height, epsilon, n_grips),
        y_label="runs that solve it",
    )


def progress(results: Results, height: int, title: str = "") -> With:
    """Return the highest position that was visited so far, in the course of training: a mean over the runs."""
    runs = {method: visits_of(results, method) for method in results.methods}
    last = float(results.table["step"].max())
    lines = Lines(
        np.linspace(0.0, last, 101),
        {method: np.mean([highest_so_far(run) for run in visits], axis=0) for method, visits in runs.items() if visits},
        title or f"how far, on height {height}",
        "training steps",
        "highest position so far",
    )

    def over_steps(ax: "Axes") -> None:
        ax.set_xlim(0.0, last)
        format_steps(ax)

    return With(lines, over_steps)


def highest_so_far(visits: Integers) -> Integers:
    """Return the highest position up to the start and the end of each interval, shape (n_intervals + 1,)."""
    positions = np.arange(visits.shape[1])
    highest: Integers = np.append(0, np.maximum.accumulate(((visits > 0) * positions).max(axis=1)))
    return highest


def visit_maps(results: Results, height: int) -> list[VisitMap]:
    """Return a map of visits for each method, a mean over its runs."""
    return [
        VisitMap(np.mean(visits, axis=0), N_STEPS, f"{method}, height {height}", "height")
        for method in METHODS
        if (visits := visits_of(results, method))
    ]


def climb_shares(results: Results, height: int) -> Lines:
    """Return the share of climbs that reach each height in the second half of training, beside 0.95^height."""
    return Lines(
        np.arange(height + 1.0),
        {
            method: np.mean([share_of_climbs(later(run)) for run in visits], axis=0)
            for method in METHODS
            if (visits := visits_of(results, method))
        },
        f"climbs on a wall of {height}, second half of training",
        "height",
        "share of climbs that get there",
        {"no slip on the way: 0.95^height": np.array([no_slip(h) for h in range(height + 1)])},
        log=True,
    )
