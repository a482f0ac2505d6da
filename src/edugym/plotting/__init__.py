"""Figures: each kind of panel is a value that draws itself on Matplotlib axes, and a sheet is a figure of several.

No window opens, and no setting of Matplotlib changes. A new kind of panel is a file of its own here.
"""

from edugym.plotting.curves import Curves
from edugym.plotting.lines import Lines
from edugym.plotting.sheet import Sheet
from edugym.plotting.style import save_figure
from edugym.plotting.visits import VisitMap

__all__ = ["Curves", "Lines", "Sheet", "VisitMap", "save_figure"]
