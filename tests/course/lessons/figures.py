"""What holds for every figure of a lesson."""

from matplotlib import pyplot
from matplotlib.lines import Line2D

from edugym.experiments.figures import Sheet


def check_legends(sheet: Sheet) -> None:
    """A panel by itself has a legend where it labels anything, with its own lines; training steps have thousands."""
    for panel in (panel for row in sheet.rows for panel in row):
        ax = panel.draw()
        if (ax.get_xlabel(), ax.get_xscale()) == ("training steps", "linear"):
            assert ax.xaxis.get_major_formatter()(12_345) == "12\N{NO-BREAK SPACE}345", panel.title
        artists, labels = ax.get_legend_handles_labels()
        legend = ax.get_legend()
        assert (legend is not None) == bool(labels), panel.title
        texts, samples = (legend.get_texts(), legend.legend_handles) if legend else ([], [])
        shown = {text.get_text(): sample for text, sample in zip(texts, samples, strict=True)}
        for artist, label in zip(artists, labels, strict=True):
            sample = shown.get(label)
            if isinstance(artist, Line2D) and isinstance(sample, Line2D):
                assert (sample.get_color(), sample.get_linestyle()) == (artist.get_color(), artist.get_linestyle())
        pyplot.close(ax.get_figure(root=True))
