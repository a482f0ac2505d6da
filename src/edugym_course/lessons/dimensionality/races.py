"""Methods of lesson 4 side by side: a table and a network under noise, and the reader's own agents beside them."""

import warnings
from collections.abc import Mapping
from functools import partial
from typing import Any

from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.tables import Results, joined
from edugym_course.lessons.dimensionality.figures import table_and_network, withheld
from edugym_course.lessons.dimensionality.methods import (
    DARKEST,
    LEVELS,
    NETWORK,
    PIXELS,
    SIGMA,
    TABLE,
    generalise,
    hashed_dark,
    learn,
    network,
    pixels,
    returns_by_column,
    seen,
    thrown,
)
from edugym_course.lessons.dimensionality.tasks import TRAINED

HOPELESS = 40_000
ONE_PIXEL, ALL_PIXELS = f"one noisy pixel of {LEVELS} levels", f"noise in all pixels, σ = {SIGMA:g}"


def compare_sights(n_steps: int = HOPELESS, repetitions: tuple[int, int] = (30, 5), **how: Any) -> dict[str, Results]:
    """Train a table and a network under every kind of noise.

    Args:
        n_steps: the training steps of each run.
        repetitions: the number of runs of the table, and of the network.
        **how: more arguments of `learn`.

    Returns:
        By a title for each kind of noise, the results of both.
    """
    sights: dict[str, tuple[Any, Any]] = {
        "no noise": (pixels(), seen()),
        ONE_PIXEL: (pixels(levels=LEVELS), seen(levels=LEVELS)),
        ALL_PIXELS: (pixels(sigma=SIGMA, capacity=2 * n_steps + 20_000), seen(sigma=SIGMA)),
        f"brightness from {DARKEST:g} to 1": (partial(hashed_dark, 2 * n_steps + 20_000), seen(darkest=DARKEST)),
    }
    of_table, of_network = repetitions
    return {
        title: joined(
            [
                learn(hashed, PIXELS, n_steps=n_steps, repetitions=of_table, **how),
                learn(boards, NETWORK, network(), n_steps=n_steps, repetitions=of_network, **how),
            ]
        )
        for title, (hashed, boards) in sights.items()
    }


def race(own: Mapping[str, Any], repetitions: int = 5, n_steps: int = 6_000) -> Sheet:
    """Train the reader's own agents with balls from three columns, and test them beside the table.

    Args:
        own: by label, functions that make an agent for boards of 50 numbers in a row.
        repetitions: the number of runs.
        n_steps: the training steps of each run.
    """
    table_runs = generalise([TABLE], repetitions=repetitions, jobs=1)
    tests = {TABLE: returns_by_column(table_runs[TABLE])}
    how: dict[str, Any] = {"n_steps": n_steps, "points": 2, "repetitions": repetitions, "jobs": 1}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # that an agent runs interpreted: these runs are short
        for label, make in own.items():
            tests[label] = returns_by_column(learn(thrown("row", TRAINED), label, make, **how), "row")
    return withheld(tests)


def race_networks(own: Mapping[str, Any], repetitions: int = 2, n_steps: int = 8_000) -> Sheet:
    """Train the reader's own networks beside that of the lesson, without noise."""
    how: dict[str, Any] = {"n_steps": n_steps, "repetitions": repetitions, "jobs": 1}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        runs = [learn(seen(), label, make, **how) for label, make in {NETWORK: network(), **own}.items()]
    return table_and_network({"no noise": joined(runs)})
