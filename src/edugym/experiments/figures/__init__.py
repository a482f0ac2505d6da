"""Figures: each kind of panel is a value that draws itself on Matplotlib axes, and a sheet is a figure of several.

No window opens, and no setting of Matplotlib changes. A new kind of panel is a file of its own here.
"""

from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import save_figure
from edugym.experiments.figures.visits import VisitMap

__all__ = ["Curves", "Lines", "Sheet", "VisitMap", "save_figure"]
