"""What methods measure against a parameter."""

import numpy as np

from edugym.experiments.figures.against import Against
from tests.experiments.figures.samples import heights, new_axes


def test_means_and_theory() -> None:
    """Each method has a line through its means and a band; theory has a dashed line."""
    rows = [np.array([0.0, 2.0]), np.array([3.0, 3.0])]
    ax = Against([0.1, 0.2], {"A": rows}, "title", "ε", "return", {"best": np.array([4.0, 5.0])}).draw(new_axes())
    assert [(line.get_label(), heights(line)) for line in ax.lines] == [("A", [1.0, 3.0]), ("best", [4.0, 5.0])]
    assert [line.get_linestyle() for line in ax.lines] == ["-", "--"]
    assert len(ax.collections) == 1
    assert (ax.get_title(), ax.get_xlabel(), ax.get_ylabel(), ax.get_xscale()) == ("title", "ε", "return", "linear")
    assert ax.get_legend() is not None


def test_every_line_of_theory_is_drawn() -> None:
    """There are two looks for them; a third line has the first again."""
    theory = {label: np.array([y, y]) for label, y in (("one", 1.0), ("two", 2.0), ("three", 3.0))}
    ax = Against([0.1, 0.2], {}, theory=theory).draw(new_axes())
    assert [(line.get_label(), heights(line)[0]) for line in ax.lines] == [("one", 1.0), ("two", 2.0), ("three", 3.0)]


def test_each_place_has_a_tick_on_a_logarithmic_axis() -> None:
    """As learning rates have."""
    ax = Against([0.003, 0.01, 1.0], {"A": [np.zeros(2)] * 3}, log=True).draw(new_axes())
    assert [label.get_text() for label in ax.get_xticklabels()] == ["0.003", "0.01", "1"]
