"""Pictures of a slider for pages behind which no kernel stands: which values, and what is written."""

import time
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from edugym.rendering.scene import Circle, Scene
from edugym_course.notebook import flipbook, sliders
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
        ((0.0, 100.0, 1.0), ["0", "1", "25", "38", "50", "62", "75", "88", "100"], 1),
        ((0.9, 1.2, 0.15), ["0.90", "1.00", "1.05", "1.20"], 1),
        (list(range(1, 16)), [str(value) for value in range(1, 16)], 0),
        (list(range(1, 17)), ["1", "3", "5", "7", "9", "10", "12", "14", "16"], 0),
        ([2, False, 1.0], ["2", "False", "1.0"], 2),
        ([1.0, *"abcdefghijklmnopq"], ["1.0", *"abcdefghijklmnopq"], 0),
    ],
)
def test_values_of_a_flipbook(tmp_path: Path, allowed: Any, values: list[str], start: int) -> None:
    """All of a few or some of many, always with both ends and the default; the others stay."""
    panel = sliders(dot, x=allowed, name=["b", "a"], more=(1, 5))
    flipbook.keep(panel, tmp_path, "mark")
    [book] = flipbook.flipbooks(tmp_path)
    assert (book.function, book.fingerprint, book.parameter) == ("dot", "mark", "x")
    assert (list(book.values), book.start, book.others) == (values, start, {"name": "a", "more": "3"})
    drawn = [(tmp_path / file).read_text(encoding="utf-8") for file in book.files]
    assert drawn[start] == call(dot, {}).data
    assert len(set(drawn)) == len(values) == len(book.descriptions)


def test_pictures_are_small_of_one_size_and_the_same_each_time(tmp_path: Path) -> None:
    """Whatever size the figures have: a page must not jump."""
    written = []
    for folder in (tmp_path / "first", tmp_path / "second"):
        folder.mkdir()
        flipbook.keep(sliders(graph, x=(1, 3)), folder, "mark")
        written.append({path.name: path.read_bytes() for path in folder.iterdir()})
    assert written[0] == written[1]
    [book] = flipbook.flipbooks(tmp_path / "first")
    assert book.descriptions == ["x is 1", "x is 2", "x is 3"]
    for file in book.files:
        with Image.open(tmp_path / "first" / file) as image:
            assert (image.mode, list(image.size)) == ("P", book.size)
            assert image.convert("RGB").getpixel((image.width - 1, image.height - 1)) == (255, 255, 255)
    with pytest.raises(ValueError, match="graph"):
        flipbook.keep(sliders(graph, x=(1, 3)), tmp_path / "first", "mark")


@pytest.mark.parametrize("reason", ["text", "slow"])
def test_what_has_no_flipbook(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, reason: str) -> None:
    """A result that is no picture, or takes too long: nothing is written."""

    def slow(x: int = 1) -> Any:
        end = time.process_time() + 0.02
        while time.process_time() < end:
            pass
        return str(x) if reason == "text" else dot(x)

    monkeypatch.setattr(flipbook, "LONGEST", 0.01 if reason == "slow" else 20.0)
    flipbook.keep(sliders(slow, x=(1, 3)), tmp_path, "mark")
    assert not [*tmp_path.iterdir()]
