"""Figures to project: those of three panels side by side are cut apart, or their numbers would be too small to read."""

from io import BytesIO
from itertools import pairwise

import numpy as np
from PIL import Image

WIDE = 1_000
"""Pixels: a figure of two panels has fewer, one of three has more."""
PANEL = 396
"""Pixels of one of three panels, more or less: the numbers beside it take more or less room."""
NEAR, LEGEND = 20, 40
"""Pixels: a line on the top of a figure, at most so high, that comes so near to a cut is a legend of all panels."""
EMPTY = 12
"""How far a colour, as the sum of red, green and blue, is from that of the background at most."""


def size(figure: bytes) -> tuple[int, int]:
    """The width and height of a picture, in pixels."""
    return Image.open(BytesIO(figure)).size


def panels(figure: bytes) -> list[bytes]:
    """The legend of all panels, if there is one, and the panels; a figure of fewer than three stays whole."""
    image = Image.open(BytesIO(figure)).convert("RGB")
    pixels = np.asarray(image, np.int64)
    drawn = np.abs(pixels - pixels[0, 0]).sum(axis=2) >= EMPTY
    rows = drawn.any(axis=1)
    first = int(rows.argmax())
    top = first + int((~rows[first:]).argmax())  # where the first line ends
    top = top if top < LEGEND else 0
    cuts = _cuts(drawn[top:].any(axis=0)) if image.width > WIDE else []
    if not cuts:
        return [figure]
    columns = drawn[:top].any(axis=0).nonzero()[0]
    boxes = list[tuple[int, int, int, int]]()
    if len(columns) and any(abs(columns - cut).min() < NEAR for cut in cuts):
        boxes.append((max(0, int(columns[0]) - NEAR), 0, int(columns[-1]) + NEAR, top + 2))
    else:
        top = 0
    boxes += [(left, top, right, image.height) for left, right in pairwise([0, *cuts, image.width])]
    return [_png(image.crop(box)) for box in boxes]


def _cuts(drawn: np.ndarray) -> list[int]:
    """Where to cut, from whether something is drawn in each column; nowhere if two panels touch."""
    cuts = []
    for middle in range(PANEL, len(drawn) - PANEL // 2, PANEL):
        near = range(middle - PANEL // 4, middle + PANEL // 4)
        ends = [x for x in near if drawn[x - 1] and not drawn[x]]
        if not ends:
            return []
        cuts.append(ends[0] + 2)  # the first is where the axes end: the next ones part the numbers of the other panel
    return cuts


def _png(image: Image.Image) -> bytes:
    file = BytesIO()
    image.save(file, "PNG")
    return file.getvalue()
