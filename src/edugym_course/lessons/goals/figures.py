"""The figures of lesson 11."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.experiments.figures.against import Against
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.tables import Results
from edugym_course.lessons.goals.methods import (
    best_return,
    learn,
    network,
    true_value,
    values_by_distance,
)


def curves(results: Results, n_switches: int, title: str) -> Curves:
    """Return the learning curves of an experiment, with the best possible return."""
    return Curves(results, title, optimum=best_return(n_switches), y_range=(-n_switches - 0.3, 0.0))


def learning_curves(by_title: Mapping[str, tuple[int, Results]], name: str = "goals") -> Sheet:
    """Return a panel for each experiment, by its title: the number of switches, and the results."""
    return Sheet(name, [[curves(results, n, title) for title, (n, results) in by_title.items()]])


def one_setting(n_switches: int, strategy: str, **settings: Any) -> Sheet:
    """Return three short learning curves of a network, for sliders."""
    results = learn(n_switches, {strategy: network(strategy, **settings)}, 10_000, repetitions=3)
    return learning_curves({f"{n_switches} switches": (n_switches, results)}, "one_setting")


def beliefs(results: Results, methods: tuple[str, ...]) -> Sheet:
    """Return what networks believe of the best action, by the distance to the goal, beside what is true."""
    measured = {method: [*values_by_distance(results, method)] for method in methods}
    n = len(next(iter(measured.values())))
    x = [*range(1, n + 1)]
    true = np.array([true_value(d) for d in x])
    panel = Against(
        x, measured, "what the network believes", "distance: switches that are wrong", "max Q(s, g, a)", {"true": true}
    )
    return Sheet("beliefs", [[panel]])
