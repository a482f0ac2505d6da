"""The figures of lesson 16."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.experiments.figures.against import Against
from edugym.experiments.figures.sheet import Sheet
from edugym_course.lessons.offline.methods import (
    AS_IT_IS,
    ESTIMATORS,
    MORNING,
    PESSIMISTIC,
    Judged,
    Learned,
    learned,
)

PROMISED, KEPT, GATHERED = "promised", "kept", "mean night of the data"
SHARES = (0.0, 0.3, 0.6, 0.8, 0.9, 0.97)
"""How often the clocks that collect data do what is best."""
X_LABEL = "share of the clock"
TITLES = {AS_IT_IS: "fitted Q as it is", PESSIMISTIC: "with pessimism"}


def promises(
    by_x: Mapping[float, Learned], x_label: str = X_LABEL, name: str = "promises", *, log: bool = False
) -> Sheet:
    """Return what each rule promises and keeps against something, in a panel for each rule."""
    optimum = np.full(len(by_x), next(iter(by_x.values())).best)

    def panel(rule: str, title: str) -> Against:
        lines = {
            PROMISED: [one.promised[rule] for one in by_x.values()],
            KEPT: [one.kept[rule] for one in by_x.values()],
            GATHERED: [one.gathered for one in by_x.values()],
        }
        return Against([*by_x], lines, title, x_label, "return of a night", {"optimum": optimum}, log)

    return Sheet(name, [[panel(rule, title) for rule, title in TITLES.items()]])


def errors(by_nights: Mapping[float, Judged], name: str = "errors") -> Sheet:
    """Return how far each estimator is off, against the number of nights."""
    lines = {method: [one.errors(method) for one in by_nights.values()] for method in ESTIMATORS}
    panel = Against([*by_nights], lines, "", "nights", "distance from the exact return", {}, log=True)
    return Sheet(name, [[panel]])


def one_setting(n_nights: int, penalty: float, **how: Any) -> Sheet:
    """Return what was promised and kept in a few runs, for sliders."""
    rules = AS_IT_IS, PESSIMISTIC
    found = {
        share: learned(MORNING, share, n_nights, penalty=penalty, rules=rules, repetitions=6, **how) for share in SHARES
    }
    return promises(found, X_LABEL, "one_setting")
