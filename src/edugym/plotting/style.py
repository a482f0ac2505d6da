"""How all figures look, in one place: nothing global is changed, so that a reader's own figures stay as they are."""

import os
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from edugym.files import write_whole
from edugym.rendering.palette import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PANEL = (3.6, 2.9)
"""Width and height of one set of axes in a figure of several, in inches."""


class Stroke(NamedTuple):
    """How the line of a method is drawn.

    Attributes:
        color: as in Matplotlib.
        linestyle: as in Matplotlib.
    """

    color: str
    linestyle: Any


STROKES = (
    Stroke("#0072b2", "solid"),
    Stroke("#e69f00", (0, (6, 1.5))),
    Stroke("#009e73", (0, (2, 1))),
    Stroke("#cc79a7", (0, (6, 1.5, 1.5, 1.5))),
    Stroke("#56b4e9", "solid"),
    Stroke("#d55e00", (0, (6, 1.5))),
    Stroke("#4d4d4d", (0, (2, 1))),
)
"""The first method gets the first, and so on. The colours are those of Okabe and Ito (2008), which readers with any
colour vision tell apart; the dashes tell them apart in black and white."""


def stroke(index: int) -> Stroke:
    """The stroke of the method with this place in the order of methods; after the last the first comes again."""
    return STROKES[index % len(STROKES)]


def own_axes(ax: "Axes | None") -> "Axes":
    """The axes to draw on: those given, or new ones in a figure of their own."""
    if ax is not None:
        return ax
    from matplotlib import pyplot

    return pyplot.subplots(figsize=(5.2, 3.6), layout="constrained")[1]


def dress(ax: "Axes", x_label: str, y_label: str, title: str | None) -> None:
    """What all axes have: labels, a quiet frame on two sides."""
    ax.set_xlabel(x_label, color=INK, fontsize=9)
    ax.set_ylabel(y_label, color=INK, fontsize=9)
    if title is not None:
        ax.set_title(title, color=INK, fontsize=10)
    ax.tick_params(labelsize=8, colors=INK, width=0.6)
    ax.spines[["top", "right"]].set_visible(False)
    ax.spines[["left", "bottom"]].set(color=INK, linewidth=0.6)


def count_steps(ax: "Axes") -> None:
    """Write training steps with a space between thousands, at few places."""
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    ax.xaxis.set_major_locator(MaxNLocator(4, integer=True, steps=[1, 2, 5, 10]))
    ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}".replace(",", "\N{NO-BREAK SPACE}")))


def save_figure(figure: "Figure", path: str | os.PathLike[str]) -> tuple[Path, Path]:
    """Save a figure as PNG and as SVG: the same figure gives the same bytes, today and tomorrow.

    Args:
        figure: what to save.
        path: where, without or with an ending, which is replaced.

    Returns:
        The two files.

    Raises:
        OSError: a file cannot be written.
    """
    import matplotlib

    files = []
    # The SVG would otherwise have the date in it, and the names of its parts a random number.
    for ending, metadata in (("png", {"Software": None}), ("svg", {"Date": None, "Creator": None})):
        contents = BytesIO()
        with matplotlib.rc_context({"svg.hashsalt": "edugym", "svg.fonttype": "path"}):
            figure.savefig(contents, format=ending, dpi=160, metadata=metadata)
        files.append(write_whole(Path(path).with_suffix(f".{ending}"), contents.getvalue()))
    return files[0], files[1]
