"""The look of all figures. No setting of Matplotlib changes, so that a reader's own figures stay as they are."""

import os
from collections.abc import Iterable, Mapping
from io import BytesIO
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from edugym.checks.parameters import a_path, a_text, in_short
from edugym.mdp.protocol import Integers, Reals
from edugym.rendering.palette import INK
from edugym.system.extras import require
from edugym.system.files import write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PANEL_SIZE = (3.6, 2.9)
"""Width and height of one panel on a sheet, in inches."""


class Stroke(NamedTuple):
    """The look of a method's line.

    Attributes:
        color: a colour, as in Matplotlib.
        linestyle: solid, or a pattern of dashes, as in Matplotlib.
    """

    color: str
    linestyle: Any


DEEP_BLUE, AMBER, TEAL, PINK, SKY_BLUE, VERMILION = "#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"
"""The colours of Okabe and Ito (2008), which readers with any colour vision can tell apart."""
GREY, BROWN, PURPLE, BLACK = "#4d4d4d", "#8c510a", "#762a83", "#000000"
"""Further colours, for more methods."""
PALE_BLUE, PALE_AMBER, PALE_GREEN = "#8fb8de", "#f2c078", "#9fd3b6"
"""Grounds on which text can be read."""

STROKES = (
    Stroke(DEEP_BLUE, "solid"),
    Stroke(AMBER, (0, (6, 1.5))),
    Stroke(TEAL, (0, (2, 1))),
    Stroke(PINK, (0, (6, 1.5, 1.5, 1.5))),
    Stroke(SKY_BLUE, "solid"),
    Stroke(VERMILION, (0, (6, 1.5))),
    Stroke(GREY, (0, (2, 1))),
)
"""The strokes of the first, second, ... method; the dashes distinguish them in black and white."""

REFERENCE: Mapping[str, Any] = MappingProxyType({"color": INK, "linewidth": 0.9, "linestyle": (0, (5, 3)), "zorder": 1})
"""The look of a line to compare with: the optimum, or what theory predicts."""

SOFT_REFERENCE: Mapping[str, Any] = MappingProxyType({**REFERENCE, "linestyle": (0, (1.5, 2))})
"""The look of a second such line."""


def stroke(index: int) -> Stroke:
    """The stroke of the method with this index; after the last stroke the first comes again."""
    return STROKES[index % len(STROKES)]


def axes_or_new(ax: "Axes | None") -> "Axes":
    """The axes to draw on: those given, or new ones in a figure of their own.

    Raises:
        ValueError: what is given are no axes.
        gymnasium.error.DependencyNotInstalled: Matplotlib is missing.
    """
    if ax is not None:
        if isinstance(ax, type) or not hasattr(ax, "plot"):
            raise ValueError(f"ax must be Matplotlib axes, but is {in_short(ax)}")
        return ax
    require("plot", "matplotlib")
    from matplotlib import pyplot

    return pyplot.subplots(figsize=(5.2, 3.6), layout="constrained")[1]


def strokes_of(methods: Iterable[str], chosen: Mapping[str, Stroke] | None) -> dict[str, Stroke]:
    """The stroke of each method: the chosen one, or else that of its place among the methods.

    Raises:
        ValueError: `chosen` is no dictionary of strokes.
    """
    chosen = {} if chosen is None else chosen
    if not isinstance(chosen, Mapping) or not all(isinstance(one, Stroke) for one in chosen.values()):
        raise ValueError(f"strokes must be a dictionary from labels to `Stroke`, but is {in_short(chosen)}")
    return {method: chosen.get(method, stroke(i)) for i, method in enumerate(methods)}


def plot_line(ax: "Axes", drawn: Stroke, x: Integers | Reals, values: Reals, label: str, **look: Any) -> None:
    """Draw the line of a method."""
    ax.plot(x, values, color=drawn.color, linestyle=drawn.linestyle, linewidth=1.6, label=label, **look)


def plot_with_band(ax: "Axes", drawn: Stroke, x: Integers | Reals, intervals: Reals, label: str, **look: Any) -> None:
    """Draw the line of a method through estimates, with intervals (from `by_point`) as a band."""
    estimate, low, high = intervals.T
    plot_line(ax, drawn, x, estimate, label, **look)
    ax.fill_between(x, low, high, color=drawn.color, alpha=0.16, linewidth=0)


def add_legend(ax: "Axes") -> None:
    """Add a legend on white ground, so that no line runs through its text."""
    ax.legend(fontsize=8, frameon=True, framealpha=1.0, edgecolor="none", borderpad=0.3)


def dress(ax: "Axes", x_label: str, y_label: str, title: str) -> None:
    """Add what all axes have: labels, a title, and a quiet frame on two sides.

    Raises:
        ValueError: one of the three is no text.
    """
    for name, text in (("x_label", x_label), ("y_label", y_label), ("title", title)):
        a_text(name, text)
    ax.set_xlabel(x_label, color=INK, fontsize=9)
    ax.set_ylabel(y_label, color=INK, fontsize=9)
    ax.set_title(title, color=INK, fontsize=10)
    ax.tick_params(labelsize=8, colors=INK, width=0.6)
    ax.spines[["top", "right"]].set_visible(False)
    ax.spines[["left", "bottom"]].set(color=INK, linewidth=0.6)


def format_steps(ax: "Axes") -> None:
    """Label few training steps on the x axis, with a space between thousands."""
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    most = 4 if ax.get_xlim()[1] < 2_000_000 else 2  # labels of millions are long
    ax.xaxis.set_major_locator(MaxNLocator(most, integer=True, steps=[1, 2, 5, 10]))
    ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}".replace(",", "\N{NO-BREAK SPACE}")))


def save_figure(figure: "Figure | Axes", path: str | os.PathLike[str]) -> tuple[Path, Path]:
    """Save a figure as PNG and as SVG. The same figure gives the same bytes every time.

    Args:
        figure: the Matplotlib figure, or axes in it.
        path: the path of both files; an ending is replaced.

    Returns:
        The paths of the two files.

    Raises:
        ValueError: `figure` is neither, or the path is none.
        OSError: a file cannot be written.
    """
    whole: Any = getattr(figure, "figure", None)
    if not hasattr(whole, "savefig"):
        raise ValueError(f"figure must be a Matplotlib figure, as `draw()` returns it, but is {in_short(figure)}")
    path = a_path("path", path)
    png, svg = (write_whole(path.with_suffix(f".{kind}"), to_bytes(whole, kind)) for kind in ("png", "svg"))
    return png, svg


def to_bytes(figure: "Figure", kind: str, dpi: int = 160) -> bytes:
    """The contents of a file with the figure; `kind` is "png" or "svg", `dpi` the pixels per inch of a PNG."""
    import matplotlib

    # Without these settings an SVG file contains the date, and random names for its parts.
    metadata = {"Software": None} if kind == "png" else {"Date": None, "Creator": None}
    contents = BytesIO()
    with matplotlib.rc_context({"svg.hashsalt": "edugym", "svg.fonttype": "path"}):
        figure.savefig(contents, format=kind, dpi=dpi, metadata=metadata)
    return contents.getvalue()
