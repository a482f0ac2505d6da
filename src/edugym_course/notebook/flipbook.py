"""What one slider of a cell shows, as pictures to flip through on a page behind which no kernel stands.

`lessons/build.py --flipbooks` makes them, beside the notebooks: a file of JSON for each call of `sliders`, and its
pictures. The website shows them.
"""

import base64
import hashlib
import io
import json
import time
from collections.abc import Mapping, Sequence
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

ALL = 15
"""A control with so many values at most has a picture of each, and so has a menu of names, of any length."""
SOME = 9
"""Pictures of a control with more values."""
LONGEST = 20.0
"""Seconds of processor time for one picture."""
COLOURS = 64
"""No colour of a lesson's figure is then off by more than a tenth, and its file is half as large as in full colour."""


class Flipbook(NamedTuple):
    """The pictures of a function with sliders, over the values of its first one.

    Attributes:
        function: the name of the function.
        fingerprint: of the cell that it belongs to (see `fingerprint`).
        parameter: the one that changes.
        values: its values as a reader sees them, in order.
        start: the place of its default among them.
        others: what the other controls stand at, by their names.
        files: the pictures, one for each value.
        descriptions: what is on them, for readers who cannot see them.
        size: width and height of every picture, in pixels.
        axes_differ: whether some axis has another range in another picture.
    """

    function: str
    fingerprint: str
    parameter: str
    values: Sequence[str]
    start: int
    others: Mapping[str, str]
    files: Sequence[str]
    descriptions: Sequence[str]
    size: Sequence[int]
    axes_differ: bool = False


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
    return [Flipbook(**json.loads(path.read_text(encoding="utf-8"))) for path in sorted(folder.glob("*.json"))]


def keep(panel: Sliders, folder: Path, fingerprint: str) -> None:
    """Call the function of sliders with several values of the first one, and write what it shows into a folder.

    Its figures get common axes where they can be read so (see `share_axes`). Nothing is written if a result is no
    picture.

    Args:
        panel: the sliders, none of them moved.
        folder: where to write.
        fingerprint: of the cell that has made the sliders.

    Raises:
        ValueError: the folder has a flipbook of a function with this name, the first control has no fixed values, or
            a picture takes too long.
    """
    (parameter, control), *others = panel.controls.items()
    name = panel.function.__name__
    if (path := folder / f"{name}.json").exists():
        raise ValueError(f"two cells have sliders for a function with the name {name}: give them names of their own")
    values = _values(control)
    if not values:
        raise ValueError(f"the first control of {name} must be a slider, a menu or a box to tick: name another first")
    results = []
    for value in values:
        began = time.process_time()
        results.append(result_of(panel.function, {name: one.value for name, one in others} | {parameter: value}))
        if time.process_time() - began > LONGEST:
            raise ValueError(f"{name} takes over {LONGEST:g} s for {parameter} = {value}: name another control first")
    figures = [_figure(result) for result in results]
    differ = share_axes([figure for figure in figures if figure is not None])
    pictures = [_picture(result, figure, name) for result, figure in zip(results, figures, strict=True)]
    kinds = {picture.mime_type for picture in pictures}
    if kinds not in ({"image/png"}, {"image/svg+xml"}):
        return
    contents, size = _files([picture.data for picture in pictures], kinds.pop())
    ending = "svg" if contents[0].startswith(b"<svg") else "png"
    files = [f"{name}-{number}.{ending}" for number in range(len(contents))]
    for file, content in zip(files, contents, strict=True):
        (folder / file).write_bytes(content)
    book = Flipbook(
        function=name,
        fingerprint=fingerprint,
        parameter=parameter,
        values=[_written(control, value) for value in values],
        start=values.index(control.value),
        others={other: _written(one, one.value) for other, one in others},
        files=files,
        descriptions=["" if picture.description == name else picture.description for picture in pictures],
        size=size,
        axes_differ=differ,
    )
    path.write_text(json.dumps(book._asdict(), indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


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


def _values(control: Any) -> list[Any]:
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
    if len(values) <= ALL or not all(isinstance(value, Real) for value in values):
        return values
    places = [round(number * (len(values) - 1) / (SOME - 1)) for number in range(SOME)]
    start = values.index(control.value)
    if start not in places:
        places[min(range(1, SOME - 1), key=lambda number: abs(places[number] - start))] = start
    return [values[place] for place in places]


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
