"""Pages to project: what stands on them, and figures that can be read from the last row."""

import re
from io import BytesIO

import lesson_pages
import numpy as np
import panels
import projected_pages
import pytest
from PIL import Image


def test_a_page_to_project_shows_what_was_measured_only_on_demand() -> None:
    """It has a picture, equations, a bet and its race; the rest of the lesson is not there, and programs neither."""
    lessons = lesson_pages.lessons()
    pages, figures = projected_pages.pages(lessons), projected_pages.figures(lessons)
    assert figures
    for lesson in lessons:
        before, fold, after = pages.pop(f"project/{lesson.name}").partition('<details class="measured">')
        assert all(part in before for part in ("![", "$$", "<fieldset")), lesson.name
        assert "Measured: " not in before, lesson.name
        assert "Measured: " in after, lesson.name
        for path in re.findall(r"\(\.\./(lessons/figures/[^)]*)\)", before + fold + after):
            assert path in lesson.figures
        for path in re.findall(r"\]\((figures/[^)]*)\)", before + fold + after):
            assert f"project/{path}" in figures
        assert "```python" not in after
        assert re.findall(r"#task=(\w+)", after) == re.findall(r"\?first#task=(\w+)", lesson.text), lesson.name
        assert len(before.split()) < 400, lesson.name  # a lesson has thousands
    assert list(pages) == ["project/index"]
    assert pages["project/index"].count("](/project/") == len(lessons)


@pytest.mark.parametrize(
    ("width", "legend", "gap", "sizes"),
    [
        (1188, False, 9, [(389, 300), (396, 300), (403, 300)]),
        (1188, True, 9, [(639, 32), (389, 270), (396, 270), (403, 270)]),
        (1188, False, 0, [(1188, 300)]),
        (792, False, 9, [(792, 300)]),
    ],
    ids=["three", "with a legend", "touching", "two"],
)
def test_a_figure_of_three_panels_is_cut_apart(
    width: int, legend: bool, gap: int, sizes: list[tuple[int, int]]
) -> None:
    """Beside each other three would be too small to read; what stands above all of them stays in one piece."""
    pixels = np.full((300, width, 3), 255, np.uint8)
    for left in range(0, width, 396):
        pixels[50:290, left + (gap > 0) * 40 : left + 396 - gap] = 0
        pixels[50:290, left + 4 : left + 8] = 0  # a name beside an axis
    if legend:
        pixels[10:30, 300:900] = 0
    file = BytesIO()
    Image.fromarray(pixels).save(file, "PNG")
    assert [panels.size(part) for part in panels.panels(file.getvalue())] == sizes
