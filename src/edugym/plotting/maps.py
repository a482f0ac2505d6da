"""Maps of what an agent explored."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from edugym.plotting.style import count_steps, dress, own_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def visitation_map(
    visits: ArrayLike,
    n_steps: int,
    ax: "Axes | None" = None,
    *,
    largest: float | None = None,
    title: str | None = None,
    y_label: str = "state",
    colour_bar: bool = True,
) -> "Axes":
    """Draw how often each state was visited, over the training: dark is often, white is never, on a logarithmic scale.

    Args:
        visits: shape (n_intervals, n_states), as `record_visits` counts them, or a mean of several of these.
        n_steps: the training steps over which the intervals stretch.
        ax: where; by default in a new figure.
        largest: the number of visits with the darkest colour, to compare maps; by default the most there are.
        title: what is written above.
        y_label: what the number of a state means, such as "height".
        colour_bar: whether to draw the scale of the colours.

    Returns:
        The axes.

    Raises:
        ValueError: `visits` has another shape or negative numbers.
    """
    counts = np.asarray(visits, float)
    if counts.ndim != 2 or (counts < 0).any():
        raise ValueError(
            f"visits must have shape (n_intervals, n_states) and no negative numbers, but has {counts.shape}"
        )
    from matplotlib.colors import LogNorm

    ax = own_axes(ax)
    top = max(counts.max(), 1.0) if largest is None else largest
    # Maps that are compared span four powers of ten; one of its own, what it has.
    bottom = counts[counts > 0].min(initial=top / 10) if largest is None else top / 1e4
    n_intervals, n_states = counts.shape
    picture = ax.imshow(
        np.ma.masked_equal(counts.T, 0),
        cmap="viridis_r",
        norm=LogNorm(bottom, top),
        origin="lower",
        aspect="auto",
        interpolation="nearest",
        extent=(0, n_steps, -0.5, n_states - 0.5),
    )
    dress(ax, "training steps", y_label, title)
    count_steps(ax)
    if colour_bar:
        bar = ax.figure.colorbar(picture, ax=ax, pad=0.02)
        bar.set_label(f"visits in {n_steps / n_intervals:.3g} steps", fontsize=8)
        bar.ax.tick_params(labelsize=7)
        bar.outline.set_visible(False)
    return ax
