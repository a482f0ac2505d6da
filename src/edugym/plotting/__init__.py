"""Figures: functions that take results and return Matplotlib axes. They show nothing, and change nothing global."""

from edugym.extras import require
from edugym.plotting.curves import learning_curves, lines
from edugym.plotting.drawing import draw
from edugym.plotting.maps import visitation_map
from edugym.plotting.style import save_figure

require("plot", "matplotlib")

__all__ = ["draw", "learning_curves", "lines", "save_figure", "visitation_map"]
