"""Figures of several panels."""

from collections.abc import Sequence
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple

from edugym.checks.parameters import a_text, in_short, several
from edugym.experiments.figures.panel import Panel, Place
from edugym.experiments.figures.style import PANEL_SIZE, to_bytes
from edugym.system.extras import require

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.figure import Figure

SCREEN_DPI = 110


class Sheet(NamedTuple):
    """Rows of panels. What they have in common is drawn once: the legend, and the label of the y axis of a row.

    In a notebook a sheet shows itself as the last value of a cell.

    Attributes:
        name: the name of its file, without an ending.
        rows: the panels of each row, from the left; a shorter row leaves its last places empty.
    """

    name: str
    rows: Sequence[Sequence[Panel]]

    def draw(self) -> "Figure":
        """Draw all panels, in memory: no window opens.

        Returns:
            The Matplotlib figure; `save_figure` writes it to files.

        Raises:
            ValueError: the name is no text, or a panel is none.
        """
        a_text("name", self.name)
        rows = "rows of panels, such as [[Curves(results)]]"
        for panel in chain(*(several("rows", row, object, rows) for row in several("rows", self.rows, object, rows))):
            if isinstance(panel, type) or not hasattr(panel, "draw"):
                raise ValueError(f"rows must be {rows}, but one of {in_short(self.rows)} is {in_short(panel)}")
        require("plot", "matplotlib")
        from matplotlib.figure import Figure

        panels = [panel for row in self.rows for panel in row]
        n_rows, n_columns = max(len(self.rows), 1), max([1, *map(len, self.rows)])
        width = max(n_columns, 1.4) * PANEL_SIZE[0]  # a single panel is wider, for its legend
        figure = Figure(figsize=(width, n_rows * PANEL_SIZE[1]), layout="constrained")
        axes = figure.subplots(n_rows, n_columns, squeeze=False)
        labelled: dict[str, Artist] = {}
        for row, places in zip([*self.rows, []], axes, strict=False):
            for ax in places[len(row) :]:
                ax.set_axis_off()
            for panel, ax in zip(row, places, strict=False):
                panel.draw(ax, Place(panels, last=panel is row[-1]))
                labelled |= {label: artist for artist, label in zip(*ax.get_legend_handles_labels(), strict=True)}
                if ax is not places[0] and ax.get_ylabel() == places[0].get_ylabel():
                    ax.set_ylabel("")
        if labelled:
            n_in_a_row = max(2, int(width / 2))  # a label takes about two inches
            figure.set_figheight(figure.get_figheight() + 0.25 * -(-len(labelled) // n_in_a_row))
            figure.legend(
                labelled.values(),
                labelled.keys(),
                loc="outside upper center",
                ncols=n_in_a_row,
                frameon=False,
                fontsize=9,
            )
        return figure

    @property
    def titles(self) -> str:
        """The titles of its panels, for readers who cannot see them."""
        return ", ".join(panel.title for row in self.rows for panel in row)

    def __repr__(self) -> str:
        """The name and the titles; the panels themselves hold whole tables."""
        return f"<Sheet {self.name!r}: {self.titles}>"

    def _repr_png_(self) -> bytes:
        """The picture for a notebook."""
        return to_bytes(self.draw(), "png", dpi=SCREEN_DPI)


def in_pairs(name: str, panels: Sequence[Panel]) -> Sheet:
    """A sheet with two panels in a row, so that it can be read on a narrow page."""
    return Sheet(name, [panels[first : first + 2] for first in range(0, len(panels), 2)])
