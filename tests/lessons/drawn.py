"""A figure as text: what is written on it, and the colours and data of all that is drawn."""

from collections.abc import Iterator
from itertools import groupby
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
    lines = [f"sheet {sheet.name}: {numbers(figure.get_size_inches())}"]
    lines += [f"  {line}" for ax in figure.axes for line in panel(ax)]
    return lines + [f"  legend: {[text.get_text() for text in legend.get_texts()]}" for legend in figure.legends]


def panel(ax: Any) -> Iterator[str]:
    """Yield lines on one panel; patches and texts that look alike are one line."""
    across, up = (
        f"{axis.get_label_text()!r} {axis.get_scale()} {numbers(axis.get_view_interval())}"
        for axis in (ax.xaxis, ax.yaxis)
    )
    yield f"panel {ax.get_title()!r}: {across}; {up}"
    for axis in (ax.xaxis, ax.yaxis):
        if type(axis.get_major_formatter()).__name__ == "FixedFormatter":
            named = [tick.get_text() for tick in axis.get_ticklabels()]
            yield f"  ticks at {numbers(axis.get_ticklocs())}: {named}"
    artists = [artist for artist in ax.get_children() if artist.get_visible() and not isinstance(artist, Spine)]
    texts = [artist for artist in artists if isinstance(artist, Text) and artist is not ax.title and artist.get_text()]
    patches = [artist for artist in artists if isinstance(artist, Patch) and artist is not ax.patch]
    for artist in artists:
        if line := described(artist):
            yield f"  {line}{labelled(artist)}"
    for kind, same in groupby(sorted(patches, key=look), look):
        yield f"  {kind}: {numbers([x for patch in same for x in corners(patch)])}"
    for kind, group in groupby(sorted(texts, key=look), look):
        those = [*group]
        places = numbers([x for text in those for x in text.get_position()])
        yield f"  {kind} at {places}: {' | '.join(text.get_text() for text in those)!r}"
    if legend := ax.get_legend():
        yield f"  legend in the panel: {[text.get_text() for text in legend.get_texts()]}"


def described(artist: Any) -> str:
    """Return a line on data that are drawn; "" for patches, texts, and what belongs to the axes."""
    if isinstance(artist, Line2D):
        style = (
            f"{to_hex(artist.get_color())} {artist.get_linestyle()} {artist.get_linewidth():g} {artist.get_marker()}"
        )
        filled = to_hex(artist.get_markerfacecolor(), keep_alpha=True)
        if artist.get_marker() != "None" and filled != to_hex(artist.get_color(), keep_alpha=True):
            style += f" in {filled}"
        return f"line {style}: {numbers(artist.get_xdata())}; {numbers(artist.get_ydata())}"
    if isinstance(artist, AxesImage):
        cmap = artist.get_cmap()
        ends = f"{to_hex(cmap(0.0))} {to_hex(cmap(1.0))}"
        place = f"{artist.origin} {artist.axes.get_aspect()} {numbers(artist.get_extent())}"
        shown = f"{cmap.name} {ends} {numbers(artist.get_clim())} {place}"
        return f"image {shown}: {numbers(artist.get_array())}"
    if isinstance(artist, Quiver):
        colours: Any = artist.get_facecolor()
        kind = f"{to_hex(colours[0])} {artist.angles} {artist.pivot}"
        return f"arrows {kind}: {numbers(artist.XY)}; {numbers(artist.U)}; {numbers(artist.V)}"
    if isinstance(artist, Collection):
        colour = next(map(to_hex, (*artist.get_facecolor(), *artist.get_edgecolor())), "none")
        return f"area {colour}: {numbers([x for path in artist.get_paths() for x in np.ravel(path.vertices)])}"
    return ""


def look(artist: Any) -> str:
    """Return what kind of patch or text it is, and its colour."""
    colour = artist.get_color() if isinstance(artist, Text) else artist.get_facecolor()
    return f"{type(artist).__name__} {to_hex(colour)}{labelled(artist)}"


def corners(patch: Any) -> Any:
    """Return the places of the corners of a patch; none of an arrow, which depends on the size of the picture."""
    if isinstance(patch, FancyArrowPatch):
        return []
    return np.ravel(patch.get_patch_transform().transform(patch.get_path().vertices))


def labelled(artist: Any) -> str:
    """Return the label, if it stands in a legend."""
    label = str(artist.get_label())
    return "" if label.startswith("_") or not label else f" {label!r}"


def numbers(values: Any) -> str:
    """Return a few numbers in brackets; of many the first and last, how many, their mean, and a sum with weights."""
    flat = np.ma.filled(np.ma.asarray(values).astype(float), np.nan).ravel()
    if flat.size <= 4:
        return f"[{', '.join(f'{value:.4g}' for value in flat)}]"
    known = flat[np.isfinite(flat)]
    weighted = known @ np.arange(1, known.size + 1) / flat.size
    return f"[{flat[0]:.4g} .. {flat[-1]:.4g}, {flat.size} of mean {known.mean():.4g}, {weighted:.4g}]"
