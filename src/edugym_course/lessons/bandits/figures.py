"""The figures of lesson 0b."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.exact.regret import lai_robbins
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import BROWN, STROKES, Stroke, add_legend, axes_or_new, dress, strokes_of
from edugym.experiments.results.statistics import by_point
from edugym.mdp.protocol import Reals
from edugym_course.lessons.bandits.methods import (
    AT_FIRST,
    BOUNDS,
    DECAY,
    GAP,
    GRADIENT,
    HOPE,
    N_ARMS,
    N_PULLS,
    SLIPS,
    STEADY,
    THOMPSON,
    Pulls,
    pulls,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EVENLY = 20
"""So many points has a line over pulls on an even axis."""
POWERS = (10, 30, 100, 300, 1_000, 3_000, 10_000)
"""The points of a line over pulls on a logarithmic axis."""
GAPS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
LOOKS = dict(zip((SLIPS, DECAY, HOPE, BOUNDS, THOMPSON, GRADIENT, STEADY), STROKES, strict=True))
LOOKS[AT_FIRST] = Stroke(BROWN, "solid")
"""A method looks the same in all figures."""
BOUND = "Lai and Robbins, C ln t"


def constant_of(n_arms: int = N_ARMS, gap: float = GAP) -> float:
    """The constant C of Lai and Robbins for a bandit."""
    mdp = make_mdp("Bandit", n_arms=n_arms, gap=gap)
    return lai_robbins([mdp.payoff(0, arm) for arm in range(n_arms)])


def regrets(found: Mapping[str, Pulls], n_arms: int = N_ARMS) -> Sheet:
    """Return the regret of each method by pull, on an even and on a logarithmic axis; dashed, the bound."""
    return Sheet("regrets", [[over_pulls(found, n_arms), over_pulls(found, n_arms, POWERS)]])


def over_pulls(
    found: Mapping[str, Pulls], n_arms: int | None = None, at: Sequence[int] = (), title: str = ""
) -> Against:
    """Return the regret after some numbers of pulls, by default evenly spread; with `n_arms`, also the bound."""
    one = next(iter(found.values()))
    n_pulls = one.arms.shape[1]
    x = list(at) or [*range(n_pulls // EVENLY, n_pulls + 1, n_pulls // EVENLY)]
    lines = {label: [mine.regret(t) for t in x] for label, mine in found.items()}
    theory = {} if n_arms is None or one.gap == 0 else {BOUND: constant_of(n_arms, one.gap) * np.log(x)}
    return Against(x, lines, title, "pulls", "regret", theory, log=bool(at), strokes=LOOKS)


def over_gaps(found: Mapping[str, Sequence[Reals]], n_pulls: int = N_PULLS) -> Sheet:
    """Return the regret of whole runs against the gap."""
    panel = Against(GAPS, found, "", "gap Δ", f"regret after {n_pulls} pulls", {}, log=True, strokes=LOOKS)
    return Sheet("over_gaps", [[panel]])


def measure_gaps(**how: Any) -> dict[str, list[Reals]]:
    """Return the regret of two methods at several gaps, by run."""
    return {method: [pulls(method, gap=gap, **how).regret() for gap in GAPS] for method in (BOUNDS, THOMPSON)}


def drifting(still: Mapping[str, Pulls], moving: Mapping[str, Pulls]) -> Sheet:
    """Return the regret of methods where the arms stay as they are, and where they drift."""
    return Sheet("drifting", [[over_pulls(still, title="no drift"), over_pulls(moving, title="drift")]])


class ByArm(NamedTuple):
    """How often each method pulled each arm: the best one, and then the others from the most pulled.

    Attributes:
        counts: by label of the method, shape (runs, n_arms).
        title: the text above the axes.
    """

    counts: Mapping[str, Reals]
    title: str = ""

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw bars on a logarithmic axis, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        width = 0.8 / len(self.counts)
        strokes = strokes_of(self.counts, LOOKS)
        for i, (label, counts) in enumerate(self.counts.items()):
            mean, low, high = by_point(counts.T).T
            x = np.arange(len(mean)) + (i - (len(self.counts) - 1) / 2) * width
            ax.bar(x, mean, width, color=strokes[label].color, label=label)
            ax.errorbar(x, mean, yerr=[np.maximum(mean - low, 0), high - mean], fmt="none", ecolor="black", lw=0.7)
        ax.set_yscale("log")
        n_arms = len(next(iter(self.counts.values()))[0])
        ax.set_xticks(range(n_arms), ["best", *(str(rank) for rank in range(2, n_arms + 1))])
        dress(ax, "arm", "pulls", self.title)
        if place.alone:
            add_legend(ax)
        return ax


def by_arm(found: Mapping[str, Pulls]) -> Sheet:
    """Return how often each method pulled each arm."""
    return Sheet("by_arm", [[ByArm({label: one.by_rank() for label, one in found.items()})]])


def one_setting(n_arms: int, gap: float, drift: float, **how: Any) -> Sheet:
    """Return the regret of four methods in short runs, for sliders."""
    few: dict[str, Any] = {"n_pulls": N_PULLS // 5, "repetitions": 20, "n_arms": n_arms, "gap": gap, "drift": drift}
    found = {method: pulls(method, **{**few, **how}) for method in (SLIPS, BOUNDS, THOMPSON, GRADIENT)}
    return Sheet("one_setting", [[over_pulls(found, None if drift else n_arms)]])
