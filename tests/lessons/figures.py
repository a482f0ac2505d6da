"""What holds for every figure of a lesson."""

from matplotlib import pyplot

from edugym.plotting import Sheet


def check_legends(sheet: Sheet) -> None:
    """A panel that is drawn by itself has a legend where it labels anything."""
    for panel in (panel for row in sheet.rows for panel in row):
        ax = panel.draw()
        assert (ax.get_legend() is not None) == bool(ax.get_legend_handles_labels()[1]), panel.title
        pyplot.close(ax.get_figure(root=True))
