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
from matplotlib.text import Annotation, Text

USUAL = {Line2D: 2, Patch: 1, Collection: 1, AxesImage: 0, Text: 3}
"""In which layer artists are drawn if nothing else is said."""

USUAL_DRESS = "left bottom, letters of [10.0, 9.0, 9.0, 8.0, 8.0]"
"""The frame of a panel, and the sizes of its title, of the labels of both axes, and of the numbers at them."""


def drawn(sheet: Any) -> list[str]:
    """Return lines on all panels of a sheet."""
    figure = sheet.draw()
    lines = [f"sheet {sheet.name}: {numbers(figure.get_size_inches())}"]
    lines += [f"  {line}" for ax in figure.axes for line in panel(ax)]
    return lines + [f"  legend: {said_in(legend)}" for legend in figure.legends]


def panel(ax: Any) -> Iterator[str]:
    """Yield lines on one panel; patches and texts that look alike are one line."""
    across, up = (
        f"{axis.get_label_text()!r} {axis.get_scale()} {numbers(axis.get_view_interval())}"
        for axis in (ax.xaxis, ax.yaxis)
    )
    written = [*(text.get_fontsize() for text in (ax.title, ax.xaxis.label, ax.yaxis.label))]
    written += [text.get_fontsize() for axis in (ax.xaxis, ax.yaxis) for text in axis.get_ticklabels()[:1]]
    frame = " ".join(side for side, spine in ax.spines.items() if ax.axison and spine.get_visible())
    dress = f"{frame or 'no frame'}, letters of {written}"
    yield f"panel {ax.get_title()!r}: {across}; {up}{'' if dress == USUAL_DRESS else f'; {dress}'}"
    for axis in (ax.xaxis, ax.yaxis):
        if type(axis.get_major_formatter()).__name__ == "FixedFormatter":
            named = [tick.get_text() for tick in axis.get_ticklabels()]
            turned = numbers([tick.get_rotation() for tick in axis.get_ticklabels()[:1]])
            yield f"  ticks at {numbers(axis.get_ticklocs())}, turned by {turned}: {named}"
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
        yield f"  legend in the panel: {said_in(legend)}"


def described(artist: Any) -> str:
    """Return a line on data that are drawn; "" for patches, texts, and what belongs to the axes."""
    if isinstance(artist, Line2D):
        style = (
            f"{to_hex(artist.get_color())} {artist.get_linestyle()} {artist.get_linewidth():g} {artist.get_marker()}"
        )
        filled = to_hex(artist.get_markerfacecolor(), keep_alpha=True)
        if artist.get_marker() != "None" and filled != to_hex(artist.get_color(), keep_alpha=True):
            style += f" in {filled}"
        if artist.get_linestyle() not in ("-", "None"):
            style += f" dashes {numbers(vars(artist)['_dash_pattern'][1])}"
        if artist.get_marker() != "None":
            style += f" {artist.get_fillstyle()} {artist.get_markersize():g}"
            style += f" edge {to_hex(artist.get_markeredgecolor())} {artist.get_markeredgewidth():g}"
        return f"line {style}{layer(artist)}: {numbers(artist.get_xdata())}; {numbers(artist.get_ydata())}"
    if isinstance(artist, AxesImage):
        cmap = artist.get_cmap()
        ends = f"{to_hex(cmap(0.0))} {to_hex(cmap(1.0))}"
        place = f"{artist.origin} {artist.axes.get_aspect()} {numbers(artist.get_extent())}"
        shown = f"{cmap.name} {ends} {numbers(artist.get_clim())} {place}"
        return f"image {shown} {artist.get_interpolation()}{layer(artist)}: {numbers(artist.get_array())}"
    if isinstance(artist, Quiver):
        colours: Any = artist.get_facecolor()
        kind = f"{to_hex(colours[0])} {artist.angles} {artist.pivot}"
        return f"arrows {kind}: {numbers(artist.XY)}; {numbers(artist.U)}; {numbers(artist.V)}"
    if isinstance(artist, Collection):
        colour = next(map(to_hex, (*artist.get_facecolor(), *artist.get_edgecolor())), "none")
        edge = numbers(artist.get_linewidth())
        points = numbers([x for path in artist.get_paths() for x in np.ravel(path.vertices)])
        return f"area {colour} edge {edge}{layer(artist)}: {points}"
    return ""


def look(artist: Any) -> str:
    """Return what kind of patch or text it is, its colour, and how it is written or framed."""
    kind = type(artist).__name__
    if isinstance(artist, Text):
        across, up = artist.get_horizontalalignment(), artist.get_verticalalignment()
        style = f"{artist.get_fontsize():g} {across} {up} {artist.get_rotation():g}"
        arrow = artist.arrow_patch if isinstance(artist, Annotation) else None
        line = f" arrow {to_hex(arrow.get_edgecolor())} {arrow.get_linewidth():g}" if arrow else ""
        return f"{kind} {to_hex(artist.get_color())} {style}{line}{layer(artist)}{labelled(artist)}"
    colours = " edge ".join(
        to_hex(colour, keep_alpha=True) for colour in (artist.get_facecolor(), artist.get_edgecolor())
    )
    return f"{kind} {colours} {artist.get_linewidth():g}{layer(artist)}{labelled(artist)}"


def layer(artist: Any) -> str:
    """Return how much shines through and in which layer it is, where that is unusual."""
    usual = next(level for kind, level in USUAL.items() if isinstance(artist, kind))
    through = "" if artist.get_alpha() is None else f" alpha {artist.get_alpha():g}"
    return through + ("" if artist.get_zorder() == usual else f" layer {artist.get_zorder():g}")


def said_in(legend: Any) -> str:
    """Return the labels of a legend, and how it is written and framed."""
    texts, frame = legend.get_texts(), legend.get_frame()
    sizes = numbers(sorted({text.get_fontsize() for text in texts}))
    edge = f"framed {frame.get_alpha()} {to_hex(frame.get_edgecolor(), keep_alpha=True)}" if frame.get_visible() else ""
    style = f"{legend._ncols} columns at {legend._loc_real}, letters of {sizes} {edge}".rstrip()
    return f"{[text.get_text() for text in texts]}, {style}"


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
