"""Learning curves, and other lines of several methods."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from edugym.checks import whole_number
from edugym.mdp.protocol import Reals
from edugym.plotting.style import count_steps, dress, own_axes, stroke
from edugym.rendering.palette import INK
from edugym.results.statistics import by_point
from edugym.results.tables import Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LABELS = {
    "return": "return (greedy)",
    "training_return": "return (while exploring)",
    "episodes": "episodes ended",
}


def learning_curves(
    results: Results,
    ax: "Axes | None" = None,
    *,
    column: str = "return",
    methods: Sequence[str] | None = None,
    share: bool = False,
    optimum: float | None = None,
    optimum_label: str = "optimum",
    soft_optimum: float | None = None,
    soft_optimum_label: str = "best ε-soft policy",
    smooth: int | None = None,
    title: str | None = None,
    y_label: str | None = None,
    legend: bool = True,
) -> "Axes":
    """Draw the learning curve of each method: the mean over repetitions, and its 95 % confidence interval as a band.

    Args:
        results: what to draw.
        ax: where; by default in a new figure.
        column: "return" (of evaluation episodes, played without exploring), "training_return" or "episodes".
        methods: which, by their labels; by default all. Their order gives the colours, so that figures with the same
            methods have the same colours.
        share: whether the values are 1 or 0, so that the mean is a share: the band is then Wilson's interval.
        optimum: the best value there is, drawn as a dashed line.
        optimum_label: what the legend calls it.
        soft_optimum: the best value there is for a policy that goes on exploring, a dashed line too.
        soft_optimum_label: what the legend calls it.
        smooth: over how many points each repetition is averaged, the point and those before it; by default none.
        title: what is written above.
        y_label: what is written beside; by default what the column is.
        legend: whether to draw a legend.

    Returns:
        The axes.

    Raises:
        ValueError: a parameter is not as above.
    """
    if smooth is not None:
        whole_number("smooth", smooth, 1)
    ax = own_axes(ax)
    for i, method in enumerate(methods if methods is not None else results.methods):
        curves = results.curves(method, column)
        if smooth is not None:
            curves = curves.rolling(smooth, min_periods=1).mean()
        steps, values = curves.index.to_numpy(), curves.to_numpy(float)
        mean, low, high = by_point(values, share=share and smooth is None).T
        color, linestyle = stroke(i)
        ax.plot(steps, mean, color=color, linestyle=linestyle, linewidth=1.6, label=method)
        ax.fill_between(steps, low, high, color=color, alpha=0.16, linewidth=0)
    for value, label, dashes in ((optimum, optimum_label, (5, 3)), (soft_optimum, soft_optimum_label, (1.5, 2))):
        if value is not None:
            ax.axhline(value, color=INK, linewidth=0.9, linestyle=(0, dashes), label=label, zorder=1)
    dress(ax, "training steps", LABELS[column] if y_label is None else y_label, title)
    if not results.table.empty:
        ax.set_xlim(0, results.table["step"].max())
    count_steps(ax)
    if legend:
        ax.legend(frameon=False, fontsize=8)
    return ax


def lines(
    x: Reals,
    values: Mapping[str, Reals],
    ax: "Axes | None" = None,
    *,
    theory: Mapping[str, Reals] | None = None,
    title: str | None = None,
    x_label: str = "",
    y_label: str = "",
    legend: bool = True,
) -> "Axes":
    """Draw a line for each method over something else than training steps.

    Args:
        x: shape (n,): where the values are.
        values: by label of the method, shape (n,).
        ax: where; by default in a new figure.
        theory: by label, what the values should be, shape (n,): dashed lines.
        title: what is written above.
        x_label: what is written below.
        y_label: what is written beside.
        legend: whether to draw a legend.

    Returns:
        The axes.
    """
    ax = own_axes(ax)
    for i, (method, line) in enumerate(values.items()):
        color, linestyle = stroke(i)
        ax.plot(x, line, color=color, linestyle=linestyle, linewidth=1.6, label=method)
    for label, line in (theory or {}).items():
        ax.plot(x, line, color=INK, linewidth=0.9, linestyle=(0, (5, 3)), label=label, zorder=1)
    dress(ax, x_label, y_label, title)
    if legend:
        ax.legend(frameon=False, fontsize=8)
    return ax
