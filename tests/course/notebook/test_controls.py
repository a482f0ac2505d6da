"""Figures with sliders: an experiment that is done again at each change."""

import base64
import io
import re
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import ipywidgets
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from PIL import Image

from edugym.experiments.figures import Sheet
from edugym.rendering.scene import Circle, Scene
from edugym_course.notebook import sliders
from edugym_course.notebook.controls import call
from tests.compiled.cells import cell
from tests.course.notebook.widgets import texts


@pytest.fixture(autouse=True)
def no_figure_left() -> Iterator[None]:
    """Every test must leave as many figures open as it opened itself: none."""
    plt.switch_backend("agg")
    yield
    assert plt.get_fignums() == []


def curve(slope: float = 1.0, points: int = 3, colour: str = "red", dashed: bool = False) -> Any:
    """A straight line."""
    _, axes = plt.subplots(figsize=(2, 1))
    axes.plot(np.arange(points) * slope, "--" if dashed else "-", color=colour)
    axes.set_title(f"slope {slope:g}")
    return axes


def test_exploring_with_sliders() -> None:
    """The function is called once at first and once for each change, with what the controls say."""
    calls: list[dict[str, Any]] = []
    status = ""

    def recorded(slope: float = 1.0, points: int = 3, colour: str = "red", dashed: bool = False) -> Any:
        calls.append({"slope": slope, "points": points, "colour": colour, "dashed": dashed})
        nonlocal status
        status = texts(panel.widget)[0] if len(calls) > 1 else ""
        return curve(slope, points, colour, dashed)

    panel = sliders(recorded, slope=(0.0, 2.0, 0.5), points=(2, 6, 2), colour=["blue", "red"], dashed=True)
    first = {"slope": 1.0, "points": 3, "colour": "red", "dashed": False}
    assert calls == [first]
    before = texts(panel.widget)[1]
    assert before.startswith('<img alt="slope 1" src="data:image/png;base64,')
    for name, value in {"slope": 1.5, "points": 4, "colour": "blue", "dashed": True}.items():
        panel.controls[name].value = value
        first[name] = value
        assert calls[-1] == first
    assert len(calls) == 5
    assert texts(panel.widget)[0] != status
    assert texts(panel.widget)[1].startswith('<img alt="slope 1.5"')
    png = base64.b64decode(panel.still()["image/png"])
    with Image.open(io.BytesIO(png)) as image:
        assert image.format == "PNG"
        assert image.width > 100


@pytest.mark.parametrize(
    ("allowed", "kind", "value"),
    [((0, 4), ipywidgets.IntSlider, 2), ((0, 2), ipywidgets.IntSlider, 2), ((2, 4), ipywidgets.IntSlider, 2),
     ((-1, 1), ipywidgets.IntSlider, 0), ([1, 0], ipywidgets.SelectionSlider, 0),
     (["a", ""], ipywidgets.Dropdown, ""), (True, ipywidgets.Checkbox, False),
     ((0, 4.0), ipywidgets.FloatSlider, 2.0), ((0, 4, 2), ipywidgets.IntSlider, 2),
     ([1, 2, 5], ipywidgets.SelectionSlider, 2), (range(4), ipywidgets.SelectionSlider, 2),
     ([2, "two"], ipywidgets.Dropdown, 2), ([2, True], ipywidgets.Dropdown, 2)],
)  # fmt: skip
def test_kinds_of_controls(allowed: Any, kind: type[Any], value: Any) -> None:
    """Each starts from the function's default, also from one that is empty, and counts only when it is let go."""
    control = sliders(lambda x=value: None, x=allowed).controls["x"]
    assert type(control) is kind
    assert control.value == value
    assert control.description == "x"
    assert not getattr(control, "continuous_update", False)


def test_ends_steps_and_labels() -> None:
    """As given; whole numbers go by one, others by a hundredth of the range. All labels are as wide as the longest."""

    def function(learning_rate: float = 0.5, x: int = 3, y: int = 4, z: float = 1.5, kind: str = "b") -> None:
        """Nothing to see."""

    ranges: dict[str, Any] = {"learning_rate": (0.0, 2.0), "x": (1, 9), "y": (0, 8, 2), "z": (1, 3, 0.5)}
    controls = sliders(function, **ranges, kind=["a", "b"]).controls
    of_sliders = [(slider.min, slider.max, slider.step) for slider in map(controls.get, ranges) if slider is not None]
    assert of_sliders == [(0, 2, 0.02), (1, 9, 1), (0, 8, 2), (1, 3, 0.5)]
    digits = [control.readout_format for control in controls.values() if hasattr(control, "readout_format")]
    assert digits == [".2f", "d", "d", ".1f"]
    tiny: Any = sliders(lambda x=0.0: None, x=(0.0, 1.0, 1e-9)).controls["x"]
    assert tiny.readout_format == ".6f"
    assert [control.description for control in controls.values()] == ["learning rate", "x", "y", "z", "kind"]
    assert {control.style.description_width for control in controls.values()} == {"15ch"}
    assert (controls["kind"].options, controls["kind"].value) == (("a", "b"), "b")
    assert sliders(lambda x=3: None, x=range(1, 7, 2)).controls["x"].options == (1, 3, 5)


def test_controls_without_a_default() -> None:
    """A slider starts at its low end, a list at its first value, a box as given; widgets are taken as they are."""
    seen: list[tuple[Any, ...]] = []

    def recorded(a: Any, b: Any, c: Any, learning_rate: Any) -> None:
        seen.append((a, b, c, learning_rate))

    logarithmic = ipywidgets.FloatLogSlider(value=0.1, min=-3, max=0)
    panel = sliders(recorded, a=(3, 9), b=["x", "y"], c=True, learning_rate=logarithmic)
    assert seen == [(3, "x", True, 0.1)]
    assert panel.controls["learning_rate"] is logarithmic
    assert not logarithmic.continuous_update


WRONG: list[Any] = [(4, 0), (2, 2), (0, 4, 0), (0,), (0, 4, 1, 2), (0, "4"), [], "text", np.array([0, 4])]


@pytest.mark.parametrize(
    ("controls", "message"),
    [
        ({"y": (0, 1)}, "control .*'x'.*'y'"),
        ({"x": (5, 9)}, "x .*5 to 9.* 2$"),
        ({"x": [1, 3]}, "x .*1, 3.* 2$"),
        *(({"x": allowed}, f"x .*low < high .*{re.escape(repr(allowed))}") for allowed in WRONG),
    ],
)
def test_wrong_controls_are_named(controls: dict[str, Any], message: str) -> None:
    """Before the function is called."""

    def never(x: int = 2) -> None:
        pytest.fail("called")

    with pytest.raises(ValueError, match=message):
        sliders(never, **controls)


DRAWING = """
import matplotlib.pyplot as plt
from matplotlib.figure import Figure

def grid_of_axes(): return plt.subplots(1, 2)[1]
def figure_without_pyplot():  # no list of open figures knows it
    figure = Figure()
    figure.subplots().set_title("drawn apart")
    return figure
def nothing_returned():  # the last figure that is made is shown
    plt.figure().suptitle("made first")
    plt.figure().suptitle("made")
def text_beside_a_figure():  # what is returned counts
    plt.figure()
    return "done"
"""
FUNCTIONS = cell(DRAWING)


@pytest.mark.parametrize(
    ("function", "mime_type", "data", "description"),
    [
        (curve, "image/png", "iVBOR", "slope 1"),
        (FUNCTIONS["grid_of_axes"], "image/png", "iVBOR", "grid_of_axes"),
        (FUNCTIONS["figure_without_pyplot"], "image/png", "iVBOR", "drawn apart"),
        (FUNCTIONS["nothing_returned"], "image/png", "iVBOR", "made"),
        (FUNCTIONS["text_beside_a_figure"], "text/html", "<pre>done</pre>", "text_beside_a_figure"),
        (lambda: Sheet("made", []), "image/png", "iVBOR", "<lambda>"),
        (lambda: ("two", [1, 2]), "text/html", "<pre>(&#x27;two&#x27;, [1, 2])</pre>", "<lambda>"),
        (lambda: Scene(1, 1, (Circle(0.5, 0.5, 0.2),)), "image/svg+xml", "<svg", "<lambda>"),
        (lambda: Scene(1, 1, (), title="a dot"), "image/svg+xml", "<svg", "a dot"),
        (lambda: pd.DataFrame({"method": [1]}), "text/html", "<div>", "<lambda>"),
        (lambda: "a < b", "text/html", "<pre>a &lt; b</pre>", "<lambda>"),
        (lambda: SimpleNamespace(figure=3), "text/html", "<pre>namespace(figure=3)</pre>", "<lambda>"),
        (lambda: None, "text/html", "", "<lambda>"),
    ],
)
def test_what_functions_return(function: Callable[..., Any], mime_type: str, data: str, description: str) -> None:
    """Figures, axes, scenes, tables and texts are all shown."""
    result = call(function, {})
    assert (result.mime_type, result.description) == (mime_type, description)
    assert result.data.startswith(data)
    assert (result.data == "") == (data == "")
    assert ("max-width: max(100%, " in result.html()) == mime_type.startswith("image/")  # for phones


def test_figures_of_others_stay_open() -> None:
    """Only what the function made is closed, also when it fails."""
    own = plt.figure()

    def failing() -> None:
        plt.figure()
        raise RuntimeError("no")

    call(curve, {})
    with pytest.raises(RuntimeError, match="no"):
        call(failing, {})
    assert plt.get_fignums() == [own.number]
    plt.close(own)
