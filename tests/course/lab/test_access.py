"""A lesson in JupyterLab without a mouse, in a light and in a dark theme: keys reach what a student uses."""

from collections.abc import Iterator
from functools import partial
from typing import Any

import pytest
from nbformat.v4 import new_code_cell

from tests.course.lab.browser import IN_A_BROWSER, PANEL, Page, faults, open_notebook, until

pytestmark = IN_A_BROWSER

PALE = '<p style="color:#888;background:#999">this is hard to read</p>'
CELLS = (
    """
import numpy as np

from edugym.experiments.figures import Lines, Sheet
from edugym_course.notebook import frames, play, predict, sliders, source


def waves(speed=1.0):
    x = np.arange(9.0)
    return Sheet("waves", [[Lines(x, {"wave": np.sin(speed * x)})]])


which = predict("Which one is higher?", ["the first", "the second", "neither"])
which""",
    'height = predict("How high does it get?", unit="grips")\nheight',
    "sliders(waves, speed=(0.5, 2.0))",
    'play("Casino")',
    'frames("Study", [0, 1])',
    'print(which.measured("the second"), height.measured(1.4))',
    "source(frames)",
    f"from IPython.display import HTML\nHTML({PALE!r})",
)
ANSWERS = 5
"""The number of the cell that compares the predictions with what was measured."""
NAMELESS = {"aria-input-field-name", "button-name"}
"""axe's rules that ipywidgets breaks: the handle of a slider and the buttons of a film have no name; see the statements
in docs."""
OUTPUTS = f"[...{PANEL}.content.node.querySelectorAll('.jp-OutputArea')]"


@pytest.fixture(scope="module", params=["Light", "Dark"])
def page(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """A notebook with each kind of widget, run to its end, on a screen that shows all of it."""
    cells, theme = [*map(new_code_cell, CELLS)], f"JupyterLab {request.param}"
    with open_notebook(tmp_path_factory.mktemp("access"), cells, 1400, 5000, theme) as page:
        yield page


def press(page: Page, cell: int, selector: str, *keys: str) -> Any:
    """Give the focus to an element of a cell, press keys, and return the element that has the focus then."""
    from selenium.webdriver import ActionChains

    element = page(f"{PANEL}.content.widgets[{cell}].node.querySelector('.jp-OutputArea {selector}')")
    page.reach(element)
    page("arguments[0].focus()", element)
    ActionChains(page.driver).send_keys(*keys).perform()
    return page("document.activeElement")


def shown(page: Page, box: Any) -> str:
    """The picture and the text in a box."""
    return page.picture(box) + page.text(box)


def has_changed(page: Page, box: Any, before: str) -> bool:
    """Whether a box shows something else than before."""
    return shown(page, box) != before


def test_predictions(page: Page) -> None:
    """Tab reaches each option, the space bar takes it, and a number is typed."""
    from selenium.webdriver.common.keys import Keys

    chosen = press(page, 0, "input[type=radio]", Keys.TAB, Keys.SPACE)
    until(chosen.is_selected, "the second option", 10)
    press(page, 1, "input[type=text]", "1.5", Keys.TAB)
    page(f"void ({PANEL}.content.activeCellIndex = {ANSWERS})")
    answers = f"JSON.stringify({PANEL}.content.model.cells.get({ANSWERS}).outputs.toJSON())"
    page.command("notebook:run-cell")
    until(lambda: "Measured: the second, as you predicted. You predicted 1.5 grips." in page(answers), "both", 10)


def test_sliders_films_and_games(page: Page) -> None:
    """Arrows move a slider, the space bar plays a film and a game."""
    from selenium.webdriver.common.keys import Keys

    for cell, selector, key in (
        (2, ".noUi-handle", Keys.ARROW_RIGHT),
        (4, ".noUi-handle", Keys.ARROW_RIGHT),
        (4, "button", Keys.SPACE),
        (3, "button:enabled", Keys.SPACE),
    ):
        box = page(f"{PANEL}.content.widgets[{cell}].node.querySelector('.jp-OutputArea .widget-vbox')")
        before = shown(page, box)
        press(page, cell, selector, key)
        until(partial(has_changed, page, box, before), f"{key} in {cell}", 30)
        assert page.errors(box) == []


def test_what_is_shown_can_be_read_by_everybody(page: Page, axe: str) -> None:
    """No output breaks axe's rules, that of contrast among them, but for names that controls of Jupyter lack."""
    page("void (document.body.style.overflow = 'visible')")  # with no height of its own it hides all from axe
    found = dict(faults(page.driver, axe, OUTPUTS))
    assert found.pop("color-contrast") == [PALE]  # the control
    assert found.keys() == NAMELESS
    assert all("noUi-handle" in node or "fa fa-" in node for nodes in found.values() for node in nodes)
