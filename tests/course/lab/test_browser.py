"""Every lesson in JupyterLab, in a real browser: it runs, its sliders and buttons work, and it shows no error.

It runs where Chromium, its driver and Selenium are installed; CONTRIBUTING.md says how to get them, and how to get
screenshots to look at.
"""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import build
import pytest
from asides import is_opening

from edugym_course.lab.lessons import student_lessons
from edugym_course.teaching.marks import is_aside
from tests.course.lab.browser import IN_A_BROWSER, PANEL, Lab, Page, chromium, running_lab, screenshots, until

SCREENSHOTS = os.environ.get("EDUGYM_SCREENSHOTS")
TRAINED = "01_exploration"
IN_SHORT = f"""
import os, sys
sys.path.append({str(build.ROOT)!r})
from tests.course.lessons import few_runs
sys.path.pop()
few_runs.limit_runs() if {TRAINED!r} in os.environ["JPY_SESSION_NAME"] else few_runs.make_runs_up()
del os, sys, few_runs
"""
"""In one lesson agents train in two runs, in the others results are made up: a student sees and moves the same."""
LESSONS = [lesson.name for lesson in student_lessons()]

pytestmark = IN_A_BROWSER


@pytest.fixture(scope="module", params=["Light", "Dark"] if SCREENSHOTS else ["Light"])
def lab(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """A running lab, in each theme if screenshots are wanted."""
    folder = tmp_path_factory.mktemp("lab")
    with running_lab(folder, f"JupyterLab {request.param}", "" if SCREENSHOTS else IN_SHORT) as lab:
        yield lab


@pytest.fixture(scope="module")
def driver() -> Iterator[Any]:
    """A browser: one for all tests, for it keeps the code of JupyterLab."""
    with chromium() as driver:
        yield driver


def test_the_start_page_leads_to_the_lessons(lab: Lab, driver: Any) -> None:
    """It shows pictures, and a click opens a lesson."""
    driver.get(lab.address)
    links = "[...document.querySelectorAll('.jp-MarkdownViewer a[href*=ipynb]')]"
    until(lambda: driver.execute_script(f"return {links}.length === {len(LESSONS)}"), "the links")
    images = "[...document.querySelectorAll('.jp-MarkdownViewer img')]"
    assert driver.execute_script(f"return {images}.every(image => image.naturalWidth > 0)")
    driver.execute_script(f"{links}[0].click()")
    until(lambda: driver.execute_script("return !!document.querySelector('.jp-Notebook')"), "the lesson")


@pytest.mark.parametrize("lesson", LESSONS)
def test_a_lesson_works(lesson: str, lab: Lab, driver: Any) -> None:
    """All cells run, and nothing is wrong but what students have not solved yet; all that moves is moved."""
    page = Page(driver, lab, f"{lesson}.ipynb")
    try_folds(page, lesson)
    cells = page.run_all()
    assert len(cells) > 20
    for cell in cells:
        if cell["cell_type"] == "code" and "raises-exception" not in cell["metadata"].get("tags", []):
            for output in cell["outputs"]:
                assert output["output_type"] != "error", (cell["source"], output)
                assert output.get("name") != "stderr", (cell["source"], output)
    boxes = page.widgets()
    assert sum(try_sliders(page, box) for box in boxes) > 0
    assert sum(try_buttons(page, box) for box in boxes) > 0
    if SCREENSHOTS:
        screenshots(page, Path(SCREENSHOTS), f"{lesson}-{lab.theme}")


def try_folds(page: Page, lesson: str) -> None:
    """See that the cells of asides are hidden and no others, and open them."""
    cells = build.read_lesson(build.lesson_sources()[lesson]).cells
    folded = sum(map(is_aside, cells)) - sum(map(is_opening, cells))
    hidden = f"{PANEL}.content.widgets.filter(cell => cell.isHidden).length"
    until(lambda: page(hidden) == folded, f"{folded} cells in folds", 30)
    page.command("notebook:expand-all-headings")
    until(lambda: page(hidden) == 0, "open folds", 30)


def try_sliders(page: Page, box: Any) -> int:
    """Move each slider in a box to an end, see that the picture changes, and return their number."""
    handles = page("[...arguments[0].querySelectorAll('.widget-hslider .noUi-handle')]", box)
    before: list[str] = []
    for handle in handles:
        low, high, now = (float(handle.get_attribute(f"aria-value{name}")) for name in ("min", "max", "now"))
        name = page("arguments[0].closest('.widget-hslider').querySelector('.widget-label').innerText", handle)
        side, value = ("left", low) if now == high else ("right", high)
        before.append(page.picture(box))
        page.drag(handle, side)
        until(lambda: page.picture(box) != before[-1], f"another picture: {name} moved to {value:g}", 30)
        assert float(handle.get_attribute("aria-valuenow")) == value
    assert page.errors(box) == []
    return len(handles)


def try_buttons(page: Page, box: Any) -> int:
    """Press the first button of a game or a film, see that something changes, and return the number of buttons."""
    buttons = page("[...arguments[0].querySelectorAll('button:enabled')]", box)
    if buttons and page.picture(box):
        before = page.picture(box) + page.text(box)
        page.press(buttons[0])
        until(lambda: page.picture(box) + page.text(box) != before, "an answer to the button", 30)
        assert page.errors(box) == []
    return len(buttons)
