"""The figures of lesson 14."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.experiments.figures.against import Against
from edugym.experiments.figures.sheet import Sheet
from edugym_course.lessons.own_problem.morning import Morning
from edugym_course.lessons.preferences.methods import Followed, followed

LEARNED, SECOND, MEANT = "learned reward", "second learned reward", "meant reward"
OF_SLIDERS = (10.0, 3.0, 2.0, 1.0, 0.5, 0.3, 0.1, 0.0)
"""The penalties of the sliders, which must answer within a second."""


def panel(found: Followed, title: str = "", *, second: bool = False) -> Against:
    """Return what the policies gain, against how far they go from the reference policy."""
    measured = {LEARNED: found.learned, MEANT: found.meant} | ({SECOND: found.second} if second else {})
    return Against(
        found.nats.mean(axis=1).tolist(),
        {label: [*rows] for label, rows in measured.items()},
        title,
        "nats from the reference policy",
        "gain in return",
        {"optimum": np.full(len(found.penalties), found.best)},
    )


def gains(by_title: Mapping[str, Followed], name: str = "gains", *, second: bool = False) -> Sheet:
    """Return a panel for each experiment."""
    return Sheet(name, [[panel(found, title, second=second) for title, found in by_title.items()]])


def one_setting(n_comparisons: int, noise: float, prior: float, **how: Any) -> Sheet:
    """Return a panel of a few runs, for sliders."""
    found = followed(Morning(), n_comparisons, noise, prior, penalties=OF_SLIDERS, repetitions=30, **how)
    return gains({f"{n_comparisons} comparisons": found}, "one_setting")
