"""What a panel is: one set of axes with everything drawn on them."""

from collections.abc import Callable, Sequence
from functools import wraps
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from edugym.experiments.figures.style import add_legend, axes_or_new

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Place(NamedTuple):
    """The place of a panel on a sheet.

    Attributes:
        panels: all panels of the sheet, for what they share, such as a scale of colours; empty for a panel that is
            drawn by itself.
        last: whether the panel is the last of its row.
    """

    panels: "Sequence[Panel]" = ()
    last: bool = True

    @property
    def alone(self) -> bool:
        """Whether the panel is drawn by itself and needs its own legend; a sheet has one legend for all its panels."""
        return not self.panels


ALONE = Place()


class Panel(Protocol):
    """A value, usually a `NamedTuple`, that draws itself."""

    @property
    def title(self) -> str:
        """The text above the axes."""

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the panel.

        Args:
            ax: the axes to draw on; by default those of a new figure.
            place: the place on a sheet.

        Returns:
            The axes.
        """


class With(NamedTuple):
    """A panel, and what is drawn on it besides, such as lines to compare with.

    Attributes:
        panel: the panel.
        more: draws the rest on the panel's axes.
    """

    panel: Panel
    more: Callable[["Axes"], object]

    @property
    def title(self) -> str:
        """The text above the axes."""
        return self.panel.title

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the panel and then the rest on `ax`, by default in a new figure, and return the axes."""
        ax = self.panel.draw(ax, place)
        self.more(ax)
        if place.alone and ax.get_legend_handles_labels()[1]:
            add_legend(ax)
        return ax


def on_axes(draw: Callable[[Any, "Axes"], None]) -> Callable[..., "Axes"]:
    """Make the method `draw` of a panel from one that draws on the axes that it is given.

    Without axes it draws in a new figure. A panel that is drawn by itself gets a legend if it labels anything.
    """

    @wraps(draw)
    def drawn(self: Any, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        ax = axes_or_new(ax)
        draw(self, ax)
        if place.alone and ax.get_legend_handles_labels()[1]:
            add_legend(ax)
        return ax

    return drawn
