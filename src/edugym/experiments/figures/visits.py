"""Maps of the states that an agent visited."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from edugym.checks.parameters import an_array, in_short, number_of_steps
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.style import axes_or_new, dress, format_steps
from edugym.mdp.protocol import Reals

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DECADES = 4
"""Maps on one sheet share a scale that spans so many powers of ten."""


class VisitMap(NamedTuple):
    """How often each state was visited in the course of training.

    Dark means often and white never, on a logarithmic scale. Maps on one sheet share the scale, which is drawn beside
    the last one of each row.

    Attributes:
        visits: shape (n_intervals, n_states): the visits that `record_visits` counted, or a mean over several runs.
        n_steps: the training steps that the intervals divide.
        title: the text above the axes.
        y_label: the meaning of the number of a state, such as "height".
    """

    visits: ArrayLike
    n_steps: int
    title: str = ""
    y_label: str = "state"

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the map on `ax`, by default in a new figure, and return the axes.

        Raises:
            ValueError: `visits` has another shape or negative numbers, or `n_steps` is none.
        """
        from matplotlib.colors import LogNorm

        number_of_steps("n_steps", self.n_steps)
        counts = self.counts()
        maps = [panel for panel in place.panels if isinstance(panel, VisitMap)]
        top = max(1.0, *(panel.counts().max() for panel in maps or [self]))
        # A map that is compared with others must not stretch its own scale; one by itself shows all that it has.
        bottom = top / 10**DECADES if len(maps) > 1 else counts[counts > 0].min(initial=top / 10)
        ax = axes_or_new(ax)
        n_intervals, n_states = counts.shape
        picture = ax.imshow(
            np.ma.masked_equal(counts.T, 0),
            cmap="viridis_r",
            norm=LogNorm(bottom, top),
            origin="lower",
            aspect="auto",
            interpolation="nearest",
            extent=(0, self.n_steps, -0.5, n_states - 0.5),
        )
        dress(ax, "training steps", self.y_label, self.title)
        format_steps(ax)
        if place.last:
            bar = ax.figure.colorbar(picture, pad=0.02)
            bar.set_label(f"visits in {self.n_steps / n_intervals:.3g} steps", fontsize=8)
            bar.ax.tick_params(labelsize=7)
            bar.outline.set_visible(False)
        return ax

    def counts(self) -> Reals:
        """The visits as an array, after a check."""
        counts = an_array("visits", self.visits, ("n_intervals", "n_states"))
        if not (counts >= 0).all():
            raise ValueError(
                f"visits must be numbers of 0 or more, shape (n_intervals, n_states), but is {in_short(self.visits)}"
            )
        return counts
