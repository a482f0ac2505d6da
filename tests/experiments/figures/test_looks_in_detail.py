"""How panels look from near: ticks, frames, legends and scales."""

from io import BytesIO
from typing import Any

import numpy as np
import pytest
from matplotlib import rc_context
from matplotlib.colors import to_hex
from matplotlib.layout_engine import ConstrainedLayoutEngine
from PIL import Image

from edugym.experiments.figures import Sheet, VisitMap
from edugym.experiments.figures.style import REFERENCE, SOFT_REFERENCE
from edugym.rendering.palette import INK
from tests.experiments.figures.samples import figure_of, new_axes
from tests.experiments.figures.test_looks import PANELS


def test_the_points_of_a_parameter_are_small() -> None:
    """They mark the places, and the line stays the thing to look at; the y axis has as many ticks as ever."""
    ax = PANELS["against"]().draw(new_axes())
    assert [line.get_markersize() for line in ax.lines[:2]] == [3, 3]
    plain = new_axes()
    plain.set_ylim(ax.get_ylim())
    assert ax.get_yticks().tolist() == plain.get_yticks().tolist()


@pytest.mark.parametrize("name", PANELS)
def test_ticks_and_frame_are_quiet(name: str) -> None:
    """Small, thin, and in ink."""
    ax = PANELS[name]().draw(new_axes())
    for axis in (ax.xaxis, ax.yaxis):
        label, line = axis.get_ticklabels()[0], axis.get_ticklines()[0]
        assert (label.get_fontsize(), label.get_color()) == (8, INK)
        assert (line.get_markeredgewidth(), line.get_color()) == (0.6, INK)
    for side in ("left", "bottom"):
        assert (ax.spines[side].get_linewidth(), to_hex(ax.spines[side].get_edgecolor())) == (0.6, to_hex(INK))


def test_a_legend_stands_on_white_ground() -> None:
    """Without a frame, so that no line runs through its text, also for a reader whose own legends have no ground."""
    with rc_context({"legend.frameon": False}):
        legend: Any = PANELS["lines"]().draw(new_axes()).get_legend()
    assert {text.get_fontsize() for text in legend.get_texts()} == {8}
    frame = legend.get_frame()
    assert legend.get_frame_on()
    assert frame.get_facecolor() == (1, 1, 1, 1)
    assert frame.get_edgecolor()[3] == 0
    assert legend.borderpad == 0.3
    sheet: Any = Sheet("sheet", [[PANELS["lines"]()]]).draw()
    assert {text.get_fontsize() for text in sheet.legends[0].get_texts()} == {9}
    sheet.draw_without_rendering()
    ground, place = sheet.legends[0].get_window_extent(), sheet.axes[0].get_window_extent()
    assert ground.y0 > place.y1


def test_nothing_is_cut_off() -> None:
    """Labels have room on a sheet and in a figure of its own; a sheet shows itself in a size for screens."""
    sheet = Sheet("sheet", [[PANELS["curves"](), PANELS["lines"]()]])
    figure: Any = sheet.draw()
    for drawn in (figure, figure_of(PANELS["curves"]().draw())):
        assert isinstance(drawn.get_layout_engine(), ConstrainedLayoutEngine)
    width, height = Image.open(BytesIO(sheet._repr_png_())).size
    assert [width, height] == [int(110 * side) for side in figure.get_size_inches()]


def test_a_map_and_its_scale() -> None:
    """State 0 is at the bottom, time goes from 0 to the last step, and the scale beside it has small numbers."""
    ax = VisitMap(np.ones((2, 3)), 10).draw(new_axes())
    (image,) = ax.images
    assert [*image.get_extent()] == [0, 10, -0.5, 2.5]
    assert (image.origin, ax.get_aspect(), image.get_cmap().name) == ("lower", "auto", "viridis_r")
    scale: Any = figure_of(ax).axes[1]
    assert scale.get_ylabel() == "visits in 5 steps"
    assert (scale.yaxis.label.get_fontsize(), scale.yaxis.get_ticklabels()[0].get_fontsize()) == (8, 7)
    assert not scale.spines["outline"].get_visible()
    assert scale.get_position().x0 - ax.get_position().x1 == pytest.approx(0.02 / 0.83 * ax.get_position().width)


def test_steps_are_labelled_by_round_whole_numbers() -> None:
    """A few of them."""
    locator: Any = PANELS["curves"]().draw(new_axes()).xaxis.get_major_locator()
    assert locator.tick_values(0, 300).tolist() == [0, 100, 200, 300]
    assert locator.tick_values(0, 1).tolist() == [0, 1]


def test_lines_to_compare_with() -> None:
    """Thin and dashed, behind the others; the second kind has short dashes."""
    assert REFERENCE == {"color": INK, "linewidth": 0.9, "linestyle": (0, (5, 3)), "zorder": 1}
    assert SOFT_REFERENCE == {**REFERENCE, "linestyle": (0, (1.5, 2))}
