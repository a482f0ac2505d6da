"""Data and helpers that the tests of figures share."""

from functools import cache

import matplotlib as mpl
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from edugym import QLearning, Results, repeat

mpl.use("agg")


def made_results(repetitions: int = 4) -> Results:
    """Return two methods with returns made by hand: 0 or 1 of "A", and numbers of "B"."""
    table = _trained(repetitions).copy()
    ones = (table["repetition"] * 100 < table["step"]).astype(float)
    table["return"] = ones.where(table["method"] == "A", 10.0 + table["repetition"] + table["step"] / 100)
    return Results(table)


@cache
def _trained(repetitions: int) -> pd.DataFrame:
    agents = dict.fromkeys("AB", QLearning.create)
    return repeat("Boulder", agents, 300, repetitions=repetitions, evaluate_every=100, jobs=1).table


def new_axes() -> Axes:
    """Return axes in memory."""
    return Figure().subplots()


def figure_of(ax: Axes) -> Figure:
    """Return the figure that contains the axes."""
    figure = ax.figure
    assert isinstance(figure, Figure)
    return figure


def heights(line: Line2D) -> list[float]:
    """Return the heights of a line's points."""
    return [float(y) for y in np.asarray(line.get_ydata(), float)]
