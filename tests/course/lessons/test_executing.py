"""Tests of what executes a lesson's cells: errors that fail the build, and pictures for its sliders."""

import shutil
from contextlib import nullcontext
from pathlib import Path

import build
import flipbooks
import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from edugym_course.notebook.widget import WITHOUT_KERNEL

WIDGET_ERROR = "import ipywidgets\ndef shout(x):\n    raise KeyError('in a widget')\nipywidgets.interact(shout, x=2)"
CLEARED_ERROR = """\
import ipywidgets
def shout(x):
    if x < 3:
        raise KeyError('in a widget')
slider = ipywidgets.IntSlider(2)
ipywidgets.interact(shout, x=slider)
slider.value = 4"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("code", "message"),
    [
        (WIDGET_ERROR, "one: cell-000 .*KeyError: 'in a widget'"),
        (CLEARED_ERROR, "one: cell-000 .*KeyError: 'in a widget'"),
        ("b = ipywidgets.Button()\nb.on_click(lambda _: 1 / 0)\nb.click()", "ZeroDivisionError"),
        ("1 / 0", r"cell-000 \('1 / 0'\): ZeroDivisionError"),
        ("import warnings\nwarnings.warn('old')", "wrote to stderr: .*UserWarning: old"),
        ("object()", "prints <object at 0x.* end with plt.show"),
        ("import time\ntime.sleep(20)", "cell-000 .*timed out"),
        ("import os\nos._exit(1)", "cell-000 .*Kernel died"),
    ],
)
def test_what_a_reader_would_see_go_wrong_fails_the_build(code: str, message: str) -> None:
    """An exception, also one that a widget swallows or later clears away, a warning, an address, a wait, a crash."""
    source = code if "import" in code or "ipywidgets" not in code else f"import ipywidgets\n{code}"
    notebook = new_notebook(cells=[new_code_cell(source, id="cell-000")])
    with pytest.raises(build.LessonError, match=f"(?s){message}"):
        build.execute(notebook, "one", seconds=1 if "sleep" in code else 5)


SLIDERS = """\
from edugym.rendering.scene import Circle, Scene
from edugym_course.notebook import sliders


def dot(x=2):
    return Scene(10, 10, (Circle(x, 1, 1),))


_ = 3  # what a notebook assigns to _ hides its last output there
sliders(dot, x=(1, 3))"""


def test_flipbooks_belong_to_a_cell_as_it_is(tmp_path: Path) -> None:
    """They are made from an executed notebook, which stays; a cell with other code, or another picture, has none."""
    path = tmp_path / "solutions" / "01_dots.ipynb"
    path.parent.mkdir()
    picture, other = (
        nbformat.v4.new_output("display_data", {"image/svg+xml": picture}) for picture in ("<svg/>", "<svg></svg>")
    )
    cell = new_code_cell(SLIDERS, outputs=[picture])
    nbformat.write(new_notebook(cells=[cell, new_code_cell("1 / 0")]), path)  # what comes after them is not run
    before = path.read_bytes()
    assert flipbooks.make("01_dots", tmp_path) == []
    assert path.read_bytes() == before
    folder = flipbooks.place("01_dots", tmp_path)
    assert sorted(file.name for file in folder.iterdir()) == ["dot-x-0.svg", "dot-x-1.svg", "dot-x-2.svg", "dot.json"]
    assert [*flipbooks.outdated("01_dots", tmp_path)] == []
    for changed in (
        new_code_cell(SLIDERS.replace("(1, 3)", "(1, 4)"), outputs=[picture]),
        new_code_cell(SLIDERS, outputs=[other]),
    ):
        nbformat.write(new_notebook(cells=[changed]), path)
        assert [*flipbooks.outdated("01_dots", tmp_path)] == [folder / "dot.json"]
    path.write_bytes(before)
    (folder / "dot-x-1.svg").unlink()
    assert [*flipbooks.outdated("01_dots", tmp_path)] == [folder / "dot-x-1.svg"]
    (folder / "dot.json").unlink()
    assert [*flipbooks.outdated("01_dots", tmp_path)] == [folder / "dot.json"]
    nbformat.write(new_notebook(cells=[new_code_cell(SLIDERS)]), path)  # which shows no picture, so needs none
    assert [*flipbooks.outdated("01_dots", tmp_path)] == []


FILM = """\
from edugym_course.notebook import frames


def watch():
    return frames("Boulder", [0, 1], height=3)


watch()"""


def test_films_belong_to_a_cell_as_it_is(tmp_path: Path) -> None:
    """Its frames are kept; a cell with another picture has none, and a game that one plays needs none."""
    path = tmp_path / "solutions" / "01_climb.ipynb"
    path.parent.mkdir()
    shown = {"image/svg+xml": "<svg/>", "text/plain": WITHOUT_KERNEL}
    cells = [
        new_code_cell(source, outputs=[nbformat.v4.new_output("display_data", shown)])
        for source in (FILM, "from edugym_course.notebook import play\n\nplay('Boulder')")
    ]
    nbformat.write(new_notebook(cells=cells), path)
    [missing] = flipbooks.outdated("01_climb", tmp_path)
    assert flipbooks.make("01_climb", tmp_path) == []
    folder = flipbooks.place("01_climb", tmp_path)
    assert [*folder.iterdir()] == [missing]
    assert [*flipbooks.outdated("01_climb", tmp_path)] == []
    cells[0].outputs[0].data["image/svg+xml"] = "<svg></svg>"
    nbformat.write(new_notebook(cells=cells), path)
    lacking, left = flipbooks.outdated("01_climb", tmp_path)
    assert left == missing != lacking


FULL = OSError(28, "No space left on device")


@pytest.mark.parametrize("fault", [FULL, KeyboardInterrupt()])
@pytest.mark.parametrize("step", ["copy", "rename 0", "rename 1", None])
def test_pictures_are_replaced_all_or_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str | None, fault: BaseException
) -> None:
    """A full disk or Ctrl-C at any step leaves the old ones, and nothing else."""
    folder, made, unfinished = tmp_path / "book", tmp_path / "made", tmp_path / ".unfinished"
    for place, text in ((folder, "old"), (made, "new")):
        place.mkdir()
        (place / text).write_text(text)
    renamed: list[Path] = []
    real_copy, real_rename = shutil.copy, Path.rename

    def copy(source: Path, target: Path) -> None:
        real_copy(source, target)
        if step == "copy":
            raise fault

    def rename(source: Path, target: Path) -> Path:
        renamed.append(source)
        if step == f"rename {len(renamed) - 1}":
            raise fault
        return real_rename(source, target)

    monkeypatch.setattr(shutil, "copy", copy)
    monkeypatch.setattr(Path, "rename", rename)
    with pytest.raises(type(fault)) if step else nullcontext():
        flipbooks.replace(folder, made, unfinished)
    assert [path.name for path in folder.iterdir()] == ["old" if step else "new"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["book", "made"]


def test_who_was_killed_between_two_steps_loses_nothing(tmp_path: Path) -> None:
    """The old pictures come back before anything else happens."""
    (tmp_path / ".unfinished" / "old").mkdir(parents=True)
    with pytest.raises(FileNotFoundError):
        flipbooks.replace(tmp_path / "book", tmp_path / "nothing", tmp_path / ".unfinished")
    assert [path.name for path in tmp_path.iterdir()] == ["book"]
