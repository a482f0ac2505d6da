"""Lines over anything else than training steps."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from edugym.checks.parameters import an_array, in_short, true_or_false
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.style import REFERENCE, Stroke, add_legend, axes_or_new, dress, plot_line, strokes_of
from edugym.mdp.protocol import Reals

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Lines(NamedTuple):
    """A line for each method, and dashed lines for what theory predicts.

    Attributes:
        x: shape (n,): the places of the values on the x axis.
        lines: by label of the method, its values, shape (n,).
        title: the text above the axes.
        x_label: the label of the x axis.
        y_label: the label of the y axis.
        theory: by label, the values that theory predicts, shape (n,).
        log: whether the y axis is logarithmic.
        strokes: by label of the method, the look of its line; else it is that of its place among the lines.
    """

    x: Reals
    lines: Mapping[str, Reals]
    title: str = ""
    x_label: str = ""
    y_label: str = ""
    theory: Mapping[str, Reals] = MappingProxyType({})
    log: bool = False
    strokes: Mapping[str, Stroke] | None = None

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the lines on `ax`, by default in a new figure, and return the axes."""
        x = an_array("x", self.x, ("n",))
        true_or_false("log", self.log)
        lines, theory = (self._checked(name, len(x)) for name in ("lines", "theory"))
        ax = axes_or_new(ax)
        for method, drawn in strokes_of(lines, self.strokes).items():
            plot_line(ax, drawn, x, lines[method], method)
        for label, line in theory.items():
            ax.plot(x, line, label=label, **REFERENCE)
        if self.log:
            ax.set_yscale("log")
        dress(ax, self.x_label, self.y_label, self.title)
        if place.alone:
            add_legend(ax)
        return ax

    def _checked(self, name: str, n: int) -> dict[str, Reals]:
        """`lines` or `theory`, with n values each."""
        given = getattr(self, name)
        if not isinstance(given, Mapping):
            raise ValueError(f"{name} must be a dictionary from labels to values, but is {in_short(given)}")
        return {label: an_array(f"{name}[{label!r}]", values, (n,)) for label, values in given.items()}
