"""A lesson in JupyterLab on the screen of a phone, in a real browser: what it shows can be read."""

from collections.abc import Iterator

import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell

from tests.course.lab.browser import IN_A_BROWSER, PANEL, Page, open_notebook

pytestmark = IN_A_BROWSER

CELLS = (
    """
import numpy as np

from edugym.experiments.figures import Lines, Sheet
from edugym_course.notebook import frames, play, sliders, source


def waves(speed=1.0):
    x = np.arange(9.0)
    return Sheet("waves", [[Lines(x, {"wave": np.sin(speed * x)})] * 3])


waves()""",
    "sliders(waves, speed=(0.5, 2.0))",
    'play("Casino")',
    'frames("Study", [0, 1])',
    "source(frames)",
    'print("agent     ", "12 345 " * 9)',
    'play("Casino").game.picture()',
)
FOLD = "<details><summary>Answer</summary>\n\nIt is 4.\n</details>\n\nAnd this follows."

PICTURES = f"""
return [...{PANEL}.content.node.querySelectorAll('.jp-OutputArea-output :is(img[src*=png], svg)')].map(picture => {{
    const width = picture.getBoundingClientRect().width;
    const texts = [...picture.querySelectorAll('text')].filter(text => text.textContent);
    const size = text => parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a;
    let place = picture;
    while (place.scrollWidth < width - 1 || getComputedStyle(place).overflowX !== 'auto') place = place.parentElement;
    place.scrollTo(9999, 0);
    return {{
        letters: picture.tagName === 'IMG' ? FIGURE * width / picture.naturalWidth : Math.min(...texts.map(size)),
        hidden: picture.getBoundingClientRect().right - place.getBoundingClientRect().right,
    }};
}})""".replace("FIGURE", str(8 * 110 / 72))
"""Of each picture the size of its smallest text, and what is still hidden of it when one has scrolled to its end."""


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """A notebook with each kind of output, run to its end, on a screen 390 pixels wide."""
    cells = [*map(new_code_cell, CELLS), new_markdown_cell(FOLD)]
    with open_notebook(tmp_path_factory.mktemp("phone"), cells, 390, 4000) as page:
        yield page


def test_pictures_can_be_read(page: Page) -> None:
    """Their text has nine pixels or more, and scrolling shows all of them."""
    pictures = page.driver.execute_script(PICTURES)
    assert len(pictures) == 4
    for picture in pictures:
        assert picture["letters"] > 8.9
        assert picture["hidden"] < 5


def test_a_scene_keeps_its_size(page: Page) -> None:
    """It is no row of a film's pictures, which grows to be readable."""
    assert page(f"{PANEL}.content.node.querySelector('.jp-RenderedSVG img').width") == 480


def test_a_line_stays_a_line(page: Page) -> None:
    """Of code and of a printed table, which scroll as well."""
    lines = f"""[...{PANEL}.content.node.querySelectorAll('.jp-OutputArea-output pre')].map(
        shown => [shown.scrollWidth > shown.clientWidth, shown.innerText.trim().split('\\n').length,
                  Math.round(shown.getBoundingClientRect().height / parseFloat(getComputedStyle(shown).lineHeight))])"""
    code, table = page(lines)
    assert code[0]
    assert code[2] == pytest.approx(code[1], abs=1)
    assert table == [True, 1, pytest.approx(1, abs=1)]


def test_a_fold_stands_apart(page: Page) -> None:
    """From what follows it."""
    fold = f"{PANEL}.content.node.querySelector('details')"
    after = f"{fold}.nextElementSibling.getBoundingClientRect().top"
    assert page(f"{after} - {fold}.getBoundingClientRect().bottom") > 8
