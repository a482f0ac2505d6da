"""Tests of what executes a lesson's cells: errors that fail the build, and pictures for its sliders."""

from pathlib import Path

import build
import flipbooks
import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

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
    assert sorted(file.name for file in folder.iterdir()) == ["dot-0.svg", "dot-1.svg", "dot-2.svg", "dot.json"]
    assert [*flipbooks.outdated("01_dots", tmp_path)] == []
    for changed in (
        new_code_cell(SLIDERS.replace("(1, 3)", "(1, 4)"), outputs=[picture]),
        new_code_cell(SLIDERS, outputs=[other]),
    ):
        nbformat.write(new_notebook(cells=[changed]), path)
        assert [*flipbooks.outdated("01_dots", tmp_path)] == [folder / "dot.json"]
