"""The figures that the experiments of the lessons describe."""

from typing import TYPE_CHECKING

from edugym.lessons.report import Curves, Figure, Lines, VisitMap
from edugym.plotting.curves import learning_curves, lines
from edugym.plotting.maps import visitation_map
from edugym.plotting.style import PANEL

if TYPE_CHECKING:
    import matplotlib.figure
    from matplotlib.axes import Axes


def draw(figure: Figure) -> "matplotlib.figure.Figure":
    """Draw a figure that an experiment describes, in memory: nothing is shown.

    Args:
        figure: rows of panels. What panels have in common is said once: the legend, the label of the y axis of a row,
            and the scale of the colours of all maps.

    Returns:
        The Matplotlib figure, without a window; `save_figure` saves it, and in a notebook it shows itself.
    """
    from matplotlib.figure import Figure as Canvas

    n_rows, n_columns = max(len(figure.rows), 1), max(map(len, figure.rows), default=1)
    width = max(n_columns, 1.4) * PANEL[0]  # a single panel has its legend inside, and room for it
    canvas = Canvas(figsize=(width, n_rows * PANEL[1]), layout="constrained")
    axes = canvas.subplots(n_rows, max(n_columns, 1), squeeze=False)
    for row, panels in zip(axes, figure.rows, strict=False):
        for column, (ax, panel) in enumerate(zip(row, panels, strict=False)):
            _draw_panel(panel, ax, figure, last=column == len(panels) - 1)
            if column and ax.get_ylabel() == row[0].get_ylabel():
                ax.set_ylabel("")
    labelled = axes[0, 0].get_legend_handles_labels()
    if n_columns > 1 and labelled[0]:
        canvas.legend(*labelled, loc="outside upper center", ncols=len(labelled[0]), frameon=False, fontsize=9)
    return canvas


def _draw_panel(panel: Curves | VisitMap | Lines, ax: "Axes", figure: Figure, last: bool) -> None:
    """Draw one panel of a figure; `last` in its row."""
    single = all(len(row) == 1 for row in figure.rows)
    match panel:
        case Curves(title, results, optimum, soft_optimum, share, y_label):
            learning_curves(
                results,
                ax,
                share=share,
                optimum=optimum,
                soft_optimum=soft_optimum,
                title=title,
                y_label=y_label,
                legend=single,
            )
        case VisitMap(title, visits, n_steps, y_label):
            largest = max(p.visits.max() for row in figure.rows for p in row if isinstance(p, VisitMap))
            visitation_map(visits, n_steps, ax, largest=largest, title=title, y_label=y_label, colour_bar=last)
        case Lines(title, x, values, x_label, y_label, theory):
            lines(x, values, ax, theory=theory, title=title, x_label=x_label, y_label=y_label, legend=single)
