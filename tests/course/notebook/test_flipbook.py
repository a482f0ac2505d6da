"""Pictures of a slider for pages behind which no kernel stands: which values, and what is written."""

import base64
import io
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ipywidgets import Text
from PIL import Image

from edugym.experiments.figures import Lines, Sheet
from edugym.rendering.scene import Circle, Scene
from edugym_course.notebook import flipbook, sliders
from edugym_course.notebook.common_axes import share_axes
from edugym_course.notebook.controls import call


def dot(x: Any = 1.0, name: str = "a", more: int = 3) -> Scene:
    """A circle at x."""
    return Scene(1000, 10, (Circle(ord(x) if isinstance(x, str) else x, 5, 1),))


def graph(x: int = 2) -> Any:
    """A figure whose height depends on x."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(2, x))
    figure.subplots().set_title(f"x is {x}")
    return figure


@pytest.mark.parametrize(
    ("allowed", "values", "start"),
    [
        ((0.0, 2.0, 0.5), ["0.0", "0.5", "1.0", "1.5", "2.0"], 2),
        ((0.0, 10.0, 0.5), ["0.0", "1.0", "2.5", "4.0", "5.0", "6.0", "7.5", "9.0", "10.0"], 1),
        ((0.0, 100.0, 1.0), ["0", "1", "12", "25", "38", "50", "62", "75", "88", "100"], 1),
        ((0.9, 1.2, 0.15), ["0.90", "1.00", "1.05", "1.20"], 1),
        (list(range(1, 16)), [str(value) for value in range(1, 16)], 0),
        (list(range(1, 17)), ["1", "3", "5", "7", "9", "10", "12", "14", "16"], 0),
        ([2, False, 1.0], ["2", "False", "1.0"], 2),
        ([1.0, *"abcdefghijklmnopq"], ["1.0", *"abcdefghijklmnopq"], 0),
    ],
)
def test_values_of_a_flipbook(tmp_path: Path, allowed: Any, values: list[str], start: int) -> None:
    """All of a few or some of many, always with both ends and the default; the others stay."""
    panel = sliders(dot, x=allowed, name=Text("a"), more=Text("3"))
    flipbook.keep(panel, tmp_path, "mark")
    [book] = flipbook.flipbooks(tmp_path)
    assert (book.function, book.fingerprint, book.fixed) == ("dot", "mark", {"name": "a", "more": "3"})
    [turn] = book.turns
    assert (turn.parameter, list(turn.values), turn.start) == ("x", values, start)
    drawn = [(tmp_path / file).read_text(encoding="utf-8") for file in book.files]
    assert drawn[start] == call(dot, {}).data
    assert len(set(drawn)) == len(values) == len(turn.descriptions)


def test_each_control_turns_while_the_others_stay(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Those after the first have fewer pictures, and none without fixed values, or where one takes too long."""

    def sum_of(x: int = 1, y: int = 20, note: str = "a", name: str = "one", slow: int = 1) -> Scene:
        end = time.process_time() + (0.3 if slow > 1 else 0)
        while time.process_time() < end:
            pass
        return Scene(1000, 10, (Circle(x + y + (100 if name == "two" else 0), 5, 1),))

    names = [f"{number}" for number in range(10)]
    panel = sliders(sum_of, x=(1, 3), y=(0, 100), note=Text("a"), name=["one", "two", *names], slow=(1, 2))
    monkeypatch.setattr(flipbook, "LONGEST", 0.2)
    flipbook.keep(panel, tmp_path, "mark")
    [book] = flipbook.flipbooks(tmp_path)
    found = {turn.parameter: (list(turn.values), turn.start) for turn in book.turns}
    assert found == {
        "x": (["1", "2", "3"], 0),
        "y": (["0", "20", "25", "50", "75", "100"], 1),
        "name": (["one", "two", *names], 0),
    }
    assert book.fixed == {"note": "a", "slow": "1"}
    for turn in book.turns:
        assert (tmp_path / turn.files[turn.start]).read_text(encoding="utf-8") == call(sum_of, {}).data
    assert (tmp_path / book.turns[1].files[-1]).read_text(encoding="utf-8") == call(sum_of, {"y": 100}).data
    assert len(set(book.files)) == 21 == len([*tmp_path.iterdir()]) - 1


def test_a_control_whose_results_are_of_another_kind_does_not_turn(tmp_path: Path) -> None:
    """A text, or a figure beside scenes."""

    def either(x: int = 1, kind: str = "scene", more: int = 1) -> Any:
        return {"scene": dot(x), "text": "no picture", "figure": graph(2)}[kind]

    flipbook.keep(sliders(either, x=(1, 3), kind=["scene", "text", "figure"], more=(1, 2)), tmp_path, "mark")
    [book] = flipbook.flipbooks(tmp_path)
    assert [turn.parameter for turn in book.turns] == ["x", "more"]
    assert book.fixed == {"kind": "scene"}


@pytest.mark.parametrize(("top", "differ"), [(3, False), (30, True)])
def test_one_setting_looks_the_same_whichever_slider_shows_it(tmp_path: Path, top: int, differ: bool) -> None:
    """Unless the axes of one slider could not be read with those of the other; then it is told."""

    def sheet(x: int = 2, y: int = 1) -> Sheet:
        return Sheet("one", [[Lines(np.arange(3.0), {"": np.arange(3.0) * x * y}, "line", "x", "y")]])

    flipbook.keep(sliders(sheet, x=[2, 3], y=[1, top]), tmp_path, "mark")
    [book] = flipbook.flipbooks(tmp_path)
    first, second = ((tmp_path / turn.files[turn.start]).read_bytes() for turn in book.turns)
    assert (first != second) == book.axes_differ == differ


def test_pictures_are_small_of_one_size_and_the_same_each_time(tmp_path: Path) -> None:
    """Whatever size the figures have: a page must not jump."""
    written = []
    for folder in (tmp_path / "first", tmp_path / "second"):
        folder.mkdir()
        flipbook.keep(sliders(graph, x=(1, 3)), folder, "mark")
        written.append({path.name: path.read_bytes() for path in folder.iterdir()})
    assert written[0] == written[1]
    [book] = flipbook.flipbooks(tmp_path / "first")
    assert book.turns[0].descriptions == ["x is 1", "x is 2", "x is 3"]
    for file in book.files:
        with Image.open(tmp_path / "first" / file) as image:
            assert (image.mode, list(image.size)) == ("P", book.size)
            assert image.convert("RGB").getpixel((image.width - 1, image.height - 1)) == (255, 255, 255)
    with pytest.raises(ValueError, match="graph"):
        flipbook.keep(sliders(graph, x=(1, 3)), tmp_path / "first", "mark")


def test_a_result_that_is_no_picture_has_no_flipbook(tmp_path: Path) -> None:
    """Nothing is written."""

    def said(x: int = 1) -> str:
        return str(x)

    flipbook.keep(sliders(said, x=(1, 3)), tmp_path, "mark")
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize(
    ("control", "longest", "names"),
    [((1, 3), 0.0, "dot takes over 0 s for x = 1"), (Text("a"), 20.0, "control x of dot")],
)
def test_what_cannot_be_turned_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, control: Any, longest: float, names: str
) -> None:
    """A picture that takes too long, and a control without fixed values: nothing is written."""
    monkeypatch.setattr(flipbook, "LONGEST", longest)
    with pytest.raises(ValueError, match=names):
        flipbook.keep(sliders(dot, x=control), tmp_path, "mark")
    assert not [*tmp_path.iterdir()]


def plotted(draw: str, top: float) -> Any:
    """A figure with one axis up to `top`."""
    from matplotlib.figure import Figure

    figure = Figure()
    axes = figure.subplots()
    if draw == "picture":
        axes.imshow(np.ones((round(top), 2)))
    elif draw == "names":
        axes.plot([1, 2], [0, 1])
        axes.set_yticks(range(round(top)))
        axes.set_ylim(0, top)
    elif draw == "colours":
        figure.colorbar(axes.pcolormesh(np.array([[0, top]])))
    elif draw == "down":
        axes.set_ylim(top, 0)
    elif draw == "two":
        axes.plot([1, 2], [0, 1])
        figure.add_subplot() if top > 1 else None
    else:
        axes.set_yscale(draw.partition(" ")[0])
        axes.set_ylim(1 if draw == "log" else 0, top)
    return figure


@pytest.mark.parametrize(
    ("draw", "tops", "common"),
    [
        ("linear", (2, 3, 4), True),
        ("linear", (4, 4), True),
        ("linear", (1, 4), True),
        ("linear", (1, 6), False),  # the smallest could not be read any more
        ("log", (100, 1e4), True),
        ("log", (1e1, 1e6), False),
        ("names", (3, 4), False),
        ("picture", (3, 4), False),
        ("colours", (3, 4), False),
        ("down", (3, 4), False),
        ("down", (4, 4), True),
        ("two", (1, 4), False),
    ],
)
def test_figures_get_common_axes_where_they_can_be_read(draw: str, tops: tuple[float, ...], common: bool) -> None:
    """What cannot be compared keeps its range, and it is told that ranges differ."""
    figures = [plotted(draw, top) for top in tops]
    before = [axes.get_ylim() for figure in figures for axes in figure.axes]
    assert share_axes(figures) == (not common)
    after = [axes.get_ylim() for figure in figures for axes in figure.axes]
    assert after == ([max(before, key=max)] * len(tops) if common else before)


def test_a_flipbook_has_common_axes_and_says_where_they_differ(tmp_path: Path) -> None:
    """Of figures and of sheets; one picture that has all of the range stays as the cell shows it."""

    def sheet(x: int = 2) -> Sheet:
        return Sheet("one", [[Lines(np.arange(3.0), {"": np.arange(3.0) * x}, f"{x}", "x", "y")]])

    for most, differ in ((3, False), (12, True)):
        flipbook.keep(sliders(sheet, x=[2, most]), tmp_path, "mark")
        [book] = flipbook.flipbooks(tmp_path)
        assert book.turns[0].axes_differ == differ
        assert book.turns[0].descriptions == ["2", str(most)]
        kept, alone = (tmp_path / file for file in book.files), [call(sheet, {"x": x}).data for x in (2, most)]
        same = [np.asarray(Image.open(io.BytesIO(base64.b64decode(picture))).convert("L")) for picture in alone]
        close = [
            np.abs(np.asarray(Image.open(a).convert("L")).astype(int) - b).max() < 30
            for a, b in zip(kept, same, strict=True)
        ]
        assert close == [differ, True]
        (tmp_path / "sheet.json").unlink()
