"""Maps of visits."""

from typing import Any

import numpy as np
import pytest

from edugym.experiments.figures import Lines, VisitMap
from edugym.experiments.figures.panel import Place
from tests.experiments.figures.samples import new_axes


def test_maps_show_states_upwards() -> None:
    """Time runs to the right and states upwards; unvisited states are blank; the scale is beside the map."""
    visits = np.array([[4.0, 1.0, 0.0], [2.0, 2.0, 1.0]])
    ax = VisitMap(visits, 1_000, y_label="height").draw(new_axes())
    image = ax.images[0]
    shown = image.get_array()
    assert isinstance(shown, np.ma.MaskedArray)
    assert image.origin == "lower"
    assert (image.norm.vmin, image.norm.vmax) == (0.4, 4)
    assert shown.filled(0).tolist() == visits.T.tolist()
    assert shown.mask.tolist() == [[False, False], [False, False], [True, False]]
    assert list(image.get_extent()) == [0, 1_000, -0.5, 2.5]
    assert ax.get_ylabel() == "height"
    assert ax.figure.axes[1].get_ylabel() == "visits in 500 steps"


def test_maps_on_a_sheet_share_a_scale() -> None:
    """The same number has the same colour, and only the last map of a row has the scale beside it."""
    maps = [VisitMap(np.full((2, 3), number), 10) for number in (1, 50)]
    ax = maps[0].draw(new_axes(), Place(maps, last=False))
    assert (ax.images[0].norm.vmin, ax.images[0].norm.vmax) == (0.005, 50)
    assert len(ax.figure.axes) == 1


def test_a_map_beside_other_panels_has_a_scale_of_its_own() -> None:
    """It is the only map, and shows all that it has."""
    only = VisitMap(np.array([[2.0, 50.0]]), 10)
    norm: Any = only.draw(new_axes(), Place([Lines(np.ones(1), {}), only])).images[0].norm
    assert (norm.vmin, norm.vmax) == (2, 50)


@pytest.mark.parametrize("visits", [np.ones(3), -np.ones((2, 2)), np.full((2, 2), np.nan)])
def test_other_arrays_are_no_visits(visits: Any) -> None:
    """The message names the shape."""
    with pytest.raises(ValueError, match=r"visits must have shape \(n_intervals, n_states\)"):
        VisitMap(visits, 10).draw(new_axes())
