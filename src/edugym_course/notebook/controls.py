"""Repeat an experiment with other parameters as soon as a slider is released."""

import base64
import html
import inspect
import io
import sys
from collections.abc import Callable
from decimal import Decimal
from numbers import Real
from typing import TYPE_CHECKING, Any, NamedTuple

import ipywidgets
import numpy as np

from edugym.checks.parameters import in_short, one_of
from edugym.rendering.drawing import Drawing
from edugym_course.notebook.widget import SMALLEST_FIGURE, NotebookWidget, picture_widget, png_html, svg_html

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Shown(NamedTuple):
    """The result of a function, ready to be shown.

    Attributes:
        mime_type: "image/png" (with the data in base 64), "image/svg+xml" or "text/html".
        data: the picture or the text.
        description: a few words for readers who cannot see it.
    """

    mime_type: str
    data: str
    description: str

    def html(self) -> str:
        """It as an HTML element."""
        if self.mime_type == "image/png":
            return png_html(base64.b64decode(self.data), self.description, SMALLEST_FIGURE)
        return svg_html(self.data) if self.mime_type == "image/svg+xml" else self.data


class Sliders(NotebookWidget):
    """A function with controls for some of its parameters, and its latest result.

    Attributes:
        function: the function.
        controls: the widget of each parameter, by its name.
    """

    def __init__(self, function: Callable[..., Any], controls: dict[str, Any]) -> None:
        """Make the widgets, and call the function for the first time."""
        self.function = function
        self.controls = controls
        self._picture, self._status = picture_widget(), ipywidgets.HTML()
        self.update()
        for control in controls.values():
            control.observe(self.calling(self.update), "value")
        super().__init__(*controls.values(), self._status, self._picture)

    def update(self) -> None:
        """Call the function with the values of the controls, and show its result."""
        self._status.value = "Computing ..."
        try:
            self._shown = call(self.function, {name: control.value for name, control in self.controls.items()})
        except BaseException:
            self._status.value = "The function failed with the error below; this picture is the last one that worked."
            raise
        self._picture.value = self._shown.html()
        self._status.value = "Done."

    def still(self) -> dict[str, str]:
        """The latest result of the function."""
        return {self._shown.mime_type: self._shown.data}


def sliders(function: Callable[..., Any], /, **controls: Any) -> Sliders:
    """Repeat an experiment as soon as a slider is released: `sliders(learning_curve, epsilon=(0.0, 1.0, 0.05))`.

    The function is called once at first, and again whenever a control changes.

    Args:
        function: a plain function that returns a `Sheet`, a Matplotlib figure or axes, a scene, a table, or a text.
        controls: for some of the function's parameters, the values that they may take:

            * `(low, high)` or `(low, high, step)`: a slider, for whole numbers if all of these are whole;
            * a list or a range: a slider if it contains only numbers, else a menu;
            * True or False: a box to tick;
            * a widget of ipywidgets.

            Each starts from the default of its parameter. Without a default, a slider starts at its low end, a list at
            its first value, and a box as given.

    Returns:
        The controls with the result. As the last value of a cell they show themselves.

    Raises:
        ValueError: it is no function or has no such parameter, or a control is none of these or does not allow the
            default.
    """
    if isinstance(function, type) or not callable(function):
        raise ValueError(f"function must be a function, but is {in_short(function)}")
    parameters = inspect.signature(function).parameters
    widgets = {}
    for name, allowed in controls.items():
        one_of("control", name, list(parameters))
        default = parameters[name].default
        start = None if default is inspect.Parameter.empty else default
        widgets[name] = control(name, allowed, start, label_width=max(map(len, controls)))
    return Sliders(function, widgets)


def control(name: str, allowed: Any, default: Any, label_width: int) -> Any:
    """The widget for a parameter (see `sliders`); it starts from `default` unless that is None."""
    label = {
        "description": name.replace("_", " "),
        "style": {"description_width": f"{label_width + 2}ch"},  # an m is wider than a digit
        "layout": {"width": "auto", "max_width": "420px"},
    }
    at_the_end = {"continuous_update": False}
    if isinstance(allowed, ipywidgets.ValueWidget):
        if hasattr(allowed, "continuous_update"):
            allowed.continuous_update = False
        return allowed
    if isinstance(allowed, bool):
        return ipywidgets.Checkbox(value=allowed if default is None else bool(default), **label)
    if isinstance(allowed, list | range) and len(allowed) > 0:
        options = list(allowed)
        value = options[0] if default is None else default
        one_of(name, value, options)
        if all(isinstance(option, Real) and not isinstance(option, bool) for option in options):
            return ipywidgets.SelectionSlider(options=options, value=value, **label, **at_the_end)
        return ipywidgets.Dropdown(options=options, value=value, **label)
    numbers = isinstance(allowed, tuple) and len(allowed) in (2, 3) and all(isinstance(x, Real) for x in allowed)
    if not numbers or not allowed[0] < allowed[1] or (len(allowed) == 3 and not allowed[2] > 0):
        raise ValueError(
            f"{name} must be (low, high) or (low, high, step) with low < high and step > 0, a list or range with"
            f" something in it, True, False, or a widget, but is {in_short(allowed)}"
        )
    low, high = allowed[:2]
    value = low if default is None else default
    if not low <= value <= high:
        raise ValueError(f"{name} must be from {low} to {high}, but the default of the function is {value!r}")
    if all(isinstance(x, int | np.integer) for x in (*allowed, value)):
        step = allowed[2] if len(allowed) == 3 else 1
        return ipywidgets.IntSlider(min=low, max=high, step=step, value=value, **label, **at_the_end)
    step = allowed[2] if len(allowed) == 3 else (high - low) / 100
    digits = max(0, -int(Decimal(str(step)).normalize().as_tuple().exponent))
    written = {"readout_format": f".{min(digits, 6)}f"}
    return ipywidgets.FloatSlider(min=low, max=high, step=step, value=value, **label, **at_the_end, **written)


def call(function: Callable[..., Any], arguments: dict[str, Any]) -> Shown:
    """Call a function and prepare its result; figures that it made in Matplotlib are closed again."""
    return shown(result_of(function, arguments), function.__name__)


def result_of(function: Callable[..., Any], arguments: dict[str, Any]) -> Any:
    """Call a function and return its result, or the Matplotlib figure in it; what it has opened is closed again."""
    before = set(_open_figures())
    try:
        result = function(**arguments)
        made = [number for number in _open_figures() if number not in before]
        figure = figure_of(result)
        if result is None and made:
            figure = sys.modules["matplotlib.pyplot"].figure(made[-1])
        return result if figure is None else figure
    finally:
        for number in set(_open_figures()) - before:
            sys.modules["matplotlib.pyplot"].close(number)


def _open_figures() -> list[int]:
    """The numbers of the figures that Matplotlib has open: none where nobody has imported it, which takes a second."""
    plt = sys.modules.get("matplotlib.pyplot")
    return [] if plt is None else list(plt.get_fignums())


def figure_of(result: Any) -> "Figure | None":
    """The figure in a result, or the figure of its axes; None if the result is something else."""
    first = np.ravel(result)[0] if isinstance(result, np.ndarray) and result.size > 0 else result
    while isinstance(first, list | tuple) and first:
        first = first[0]
    figure: Figure | None = getattr(getattr(first, "figure", None), "figure", None)  # also from axes in a SubFigure
    return figure


def shown(result: Any, name: str) -> Shown:
    """Prepare the result of the function with this name, as a picture or as text."""
    if "matplotlib.figure" in sys.modules and isinstance(result, sys.modules["matplotlib.figure"].Figure):
        titles = [result.get_suptitle(), *(axes.get_title() for axes in result.axes), name]
        buffer = io.BytesIO()
        result.savefig(buffer, format="png", bbox_inches="tight")
        return Shown("image/png", base64.b64encode(buffer.getvalue()).decode(), next(filter(None, titles)))
    if hasattr(result, "_repr_png_"):
        return Shown("image/png", base64.b64encode(result._repr_png_()).decode(), getattr(result, "titles", "") or name)
    for mime_type, method in (("image/svg+xml", "_repr_svg_"), ("text/html", "_repr_html_")):
        if hasattr(result, method):
            description = result.title if isinstance(result, Drawing) and result.title else name
            return Shown(mime_type, getattr(result, method)(), description)
    return Shown("text/html", "" if result is None else f"<pre>{html.escape(str(result))}</pre>", name)
