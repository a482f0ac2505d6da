"""A figure as text: what is written on it, and the data and colours of all that is drawn."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.collections import Collection
from matplotlib.colors import to_hex
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patches import FancyArrowPatch, Patch
from matplotlib.quiver import Quiver
from matplotlib.spines import Spine
from matplotlib.text import Text


def drawn(sheet: Any) -> list[str]:
    """Return lines on all panels of a sheet."""
    figure = sheet.draw()
    lines = [f"sheet {sheet.name}"]
    for ax in figure.axes:
        lines += [f"  {line}" for line in panel(ax)]
    return lines + [f"  legend: {text.get_text()}" for legend in figure.legends for text in legend.get_texts()]


def panel(ax: Any) -> Iterator[str]:
    """Yield lines on one panel."""
    across, up = (
        f"{axis.get_label_text()!r} {scale} {numbers(axis.get_view_interval())}"
        for axis, scale in ((ax.xaxis, ax.get_xscale()), (ax.yaxis, ax.get_yscale()))
    )
    yield f"panel {ax.get_title()!r}: {across}; {up}"
    for axis in (ax.xaxis, ax.yaxis):
        named = [tick.get_text() for tick in axis.get_ticklabels() if tick.get_text()]
        if type(axis.get_major_formatter()).__name__ == "FixedFormatter":
            yield f"  ticks at {numbers(axis.get_ticklocs())}: {named}"
    for artist in ax.get_children():
        belongs = artist is ax.patch or artist is ax.title or isinstance(artist, Spine)
        if artist.get_visible() and not belongs and (line := described(artist)):
            label = str(artist.get_label())
            yield f"  {line}" + ("" if label.startswith("_") or not label else f", label {label!r}")


def described(artist: Any) -> str:
    """Return a line on one thing that is drawn; "" for what belongs to the axes themselves."""
    if isinstance(artist, Line2D):
        look = f"{to_hex(artist.get_color())} {artist.get_linestyle()} {artist.get_marker()}"
        return f"line {look}: {numbers(artist.get_xdata())}; {numbers(artist.get_ydata())}"
    if isinstance(artist, AxesImage):
        return f"image {artist.get_cmap().name} {numbers(artist.get_clim())}: {numbers(artist.get_array())}"
    if isinstance(artist, Text):
        said = artist.get_text()
        return f"text {said!r} {to_hex(artist.get_color())} at {numbers(artist.get_position())}" if said else ""
    if isinstance(artist, Quiver):
        return f"arrows: {numbers(artist.XY)}; {numbers(artist.U)}; {numbers(artist.V)}"
    if isinstance(artist, Collection):
        colour = next(map(to_hex, (*artist.get_facecolor(), *artist.get_edgecolor())), "none")
        return f"area {colour}: {numbers([x for path in artist.get_paths() for x in np.ravel(path.vertices)])}"
    if isinstance(artist, Patch):
        corners = [] if isinstance(artist, FancyArrowPatch) else artist.get_path().vertices
        places = numbers(artist.get_patch_transform().transform(corners)) if len(corners) else ""
        return f"{type(artist).__name__} {to_hex(artist.get_facecolor())}: {places}"
    return ""


def numbers(values: Any) -> str:
    """Return a few numbers as they are, and of many the first and last, the mean and a mean with weights."""
    flat = np.ma.filled(np.ma.asarray(values).astype(float), np.nan).ravel()
    if flat.size <= 4:
        return ", ".join(f"{value:.4g}" for value in flat)
    known = flat[np.isfinite(flat)]
    weighted = known @ np.arange(1, known.size + 1) / known.size
    return f"{flat[0]:.4g} .. {flat[-1]:.4g} ({flat.size}, {known.mean():.4g}, {weighted:.4g})"
