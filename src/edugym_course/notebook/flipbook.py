"""What the sliders of a cell show, as pictures to flip through on a page behind which no kernel stands.

`lessons/build.py --flipbooks` makes them, beside the notebooks: a file of JSON for each call of `sliders`, and its
pictures. The website shows them.
"""

import base64
import hashlib
import io
import json
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from PIL import Image

from edugym.experiments.figures.sheet import SCREEN_DPI, Sheet
from edugym.experiments.figures.style import to_bytes
from edugym_course.notebook.common_axes import share_axes
from edugym_course.notebook.controls import Shown, Sliders, figure_of, result_of, shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST = 15
"""A first control with so many values at most has a picture of each, and so has a menu of names, of any length."""
SOME = 9
"""Pictures of a first control with more values; the default is one more."""
FEW = 5
"""Pictures of another control with more values, unless it is a menu of names; the default is one more."""
LONGEST = 20.0
"""Seconds of processor time for one picture."""
COLOURS = 64
"""No colour of a lesson's figure is then off by more than a tenth, and its file is half as large as in full colour."""


class Turn(NamedTuple):
    """The pictures over the values of one control; the others stand at their defaults.

    Attributes:
        parameter: the one that changes.
        values: its values as a reader sees them, in order.
        start: the place of its default among them.
        files: the pictures, one for each value.
        descriptions: what is on them, for readers who cannot see them.
        axes_differ: whether some axis has another range in another picture.
    """

    parameter: str
    values: Sequence[str]
    start: int
    files: Sequence[str]
    descriptions: Sequence[str]
    axes_differ: bool = False


class Flipbook(NamedTuple):
    """The pictures of a function with sliders.

    Attributes:
        function: the name of the function.
        fingerprint: of the cell that it belongs to (see `fingerprint`).
        turns: one for each control that has pictures; the first control always has.
        fixed: what the controls without pictures stand at, by their names.
        size: width and height of every picture, in pixels.
        axes_differ: whether some axis has another range in a picture of another control.
    """

    function: str
    fingerprint: str
    turns: Sequence[Turn]
    fixed: Mapping[str, str]
    size: Sequence[int]
    axes_differ: bool = False

    @property
    def files(self) -> list[str]:
        """All pictures."""
        return [file for turn in self.turns for file in turn.files]


def fingerprint(source: str, outputs: Sequence[Mapping[str, Any]]) -> str:
    """Of the code of an executed cell and of the pictures that it shows: these change if what it calls has changed."""
    shown = [
        "".join(content)
        for output in outputs
        for kind, content in sorted(output.get("data", {}).items())
        if kind.startswith("image/")
    ]
    return hashlib.sha256(json.dumps([source, *shown]).encode()).hexdigest()[:16]


def flipbooks(folder: Path) -> list[Flipbook]:
    """Read all that are in a folder: none if there is no folder."""
    read = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.json"))]
    return [Flipbook(**book | {"turns": [Turn(**turn) for turn in book["turns"]]}) for book in read]


def keep(panel: Sliders, folder: Path, fingerprint: str) -> None:
    """Call the function of sliders with several values of each in turn, and write what it shows into a folder.

    Figures get common axes where they can be read so (see `share_axes`): all of them, or else those of each control. A
    control other than the first that has no fixed values, or whose pictures take too long or are none, is left out.
    Nothing is written if a result of the first one is no picture.

    Args:
        panel: the sliders, none of them moved.
        folder: where to write.
        fingerprint: of the cell that has made the sliders.

    Raises:
        ValueError: the folder has a flipbook of a function with this name, the first control has no fixed values, or
            a picture of the first control takes too long.
    """
    first, *others = panel.controls
    name = panel.function.__name__
    if (path := folder / f"{name}.json").exists():
        raise ValueError(f"two cells have sliders for a function with the name {name}: give them names of their own")
    called = [_called(panel, first, MOST, SOME)]
    for other in others:
        with suppress(_CannotTurn):
            called.append(_called(panel, other, FEW, FEW))
    between = _share(called)
    drawn = [_drawn(one, name) for one in called]
    kinds = {picture.mime_type for picture in drawn[0].pictures}
    if kinds not in ({"image/png"}, {"image/svg+xml"}):
        return
    drawn = [one for one in drawn if {picture.mime_type for picture in one.pictures} == kinds]
    contents, size = _files([picture.data for one in drawn for picture in one.pictures], kinds.pop())
    ending = "svg" if contents[0].startswith(b"<svg") else "png"
    unwritten = iter(contents)
    turns = []
    for one in drawn:
        files = [f"{name}-{one.parameter}-{number}.{ending}" for number in range(len(one.values))]
        for file in files:
            (folder / file).write_bytes(next(unwritten))
        control = panel.controls[one.parameter]
        values = [_written(control, value) for value in one.values]
        descriptions = ["" if picture.description == name else picture.description for picture in one.pictures]
        turns.append(Turn(one.parameter, values, one.values.index(control.value), files, descriptions, one.axes_differ))
    turned = {one.parameter for one in drawn}
    fixed = {other: _written(one, one.value) for other, one in panel.controls.items() if other not in turned}
    book = Flipbook(name, fingerprint, turns, fixed, size, between and len(turns) > 1)
    written = book._asdict() | {"turns": [turn._asdict() for turn in turns]}
    path.write_text(json.dumps(written, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


class _CannotTurn(ValueError):
    """A control has no fixed values, or a picture of it takes too long."""


class _Called(NamedTuple):
    """The results over the values of one control, and the figure of each that has one."""

    parameter: str
    values: list[Any]
    results: list[Any]
    figures: list["Figure | None"]


class _Drawn(NamedTuple):
    """The pictures over the values of one control."""

    parameter: str
    values: list[Any]
    pictures: list[Shown]
    axes_differ: bool


def _called(panel: Sliders, parameter: str, most: int, some: int) -> _Called:
    """Call the function with all values of a control if they are at most `most`, or else with some of them."""
    name, control = panel.function.__name__, panel.controls[parameter]
    values = _values(control, most, some)
    if not values:
        raise _CannotTurn(f"control {parameter} of {name} must be a slider, a menu or a box: name another first")
    defaults, results = {other: one.value for other, one in panel.controls.items()}, []
    for value in values:
        began = time.process_time()
        results.append(result_of(panel.function, defaults | {parameter: value}))
        if time.process_time() - began > LONGEST:
            raise _CannotTurn(f"{name} takes over {LONGEST:g} s for {parameter} = {value}: name another control first")
    return _Called(parameter, values, results, [_figure(result) for result in results])


def _drawn(called: _Called, name: str) -> _Drawn:
    """Draw results, with the axes that their figures share."""
    differ = _share([called])
    pictures = [_picture(result, figure, name) for result, figure in zip(called.results, called.figures, strict=True)]
    return _Drawn(called.parameter, called.values, pictures, differ)


def _share(called: Sequence[_Called]) -> bool:
    """Give all figures common axes where they can be read so, and return whether some still differ."""
    return share_axes([figure for one in called for figure in one.figures if figure is not None])


def _figure(result: Any) -> "Figure | None":
    """The Matplotlib figure of a result, or None if it has none."""
    return result.draw() if isinstance(result, Sheet) else figure_of(result)


def _picture(result: Any, figure: "Figure | None", name: str) -> Shown:
    """A result as a cell shows it, with its figure as it is now."""
    if not isinstance(result, Sheet):
        return shown(result, name)
    assert figure is not None
    contents = base64.b64encode(to_bytes(figure, "png", dpi=SCREEN_DPI)).decode()
    return Shown("image/png", contents, result.titles or name)


def _values(control: Any, most: int, some: int) -> list[Any]:
    """The values of a control to draw, its present one and both ends among them; none of a control without any."""
    if hasattr(control, "options"):
        values = list(control.options)
    elif hasattr(control, "step"):
        n_steps = round((control.max - control.min) / control.step)
        values = [round(control.min + step * control.step, 9) for step in range(n_steps + 1)]
    else:
        values = [False, True] if isinstance(control.value, bool) else []
    if values and control.value not in values:  # between two steps
        values = sorted([*values, control.value])
    if len(values) <= most or not all(isinstance(value, Real) for value in values):
        return values
    places = {round(number * (len(values) - 1) / (some - 1)) for number in range(some)}
    return [values[place] for place in sorted({*places, values.index(control.value)})]


def _written(control: Any, value: Any) -> str:
    """A value as the control shows it."""
    return format(value, getattr(control, "readout_format", "")) if hasattr(control, "step") else str(value)


def _files(pictures: list[str], kind: str) -> tuple[list[bytes], list[int]]:
    """The contents of the files, and their common width and height: a smaller picture gets a white margin."""
    if kind == "image/svg+xml":
        from xml.etree import ElementTree

        root = ElementTree.fromstring(pictures[0])
        return [picture.encode() for picture in pictures], [int(root.attrib[side]) for side in ("width", "height")]
    images = [Image.open(io.BytesIO(base64.b64decode(picture))).convert("RGBA") for picture in pictures]
    size = max(image.width for image in images), max(image.height for image in images)
    contents = []
    for image in images:
        page = Image.new("RGB", size, "white")
        page.paste(image, mask=image)
        buffer = io.BytesIO()
        few = page.quantize(COLOURS, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        few.save(buffer, "PNG", optimize=True)
        contents.append(buffer.getvalue())
    return contents, list(size)
