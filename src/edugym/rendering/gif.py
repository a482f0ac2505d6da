"""Pictures as a film: an animated GIF, which pages, slides and messages play by themselves."""

import io
import math
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Scene
from edugym.system.extras import require
from edugym.system.files import write_whole

if TYPE_CHECKING:
    from PIL import Image

LAST_SECONDS = 2.0
"""How long the last picture stays before the film starts again."""


def to_gif(pictures: Iterable[Scene | NDArray[np.uint8]], path: str | Path, frames_per_second: float = 4.0) -> None:
    """Write pictures to a GIF that repeats without end.

    Where the pictures have different sizes, the smaller ones stand at the top left. A picture that equals the one
    before it is not stored: the one before it is shown for longer.

    Args:
        pictures: One or more scenes, or arrays of colours of shape (height, width, 3).
        path: The file to write.
        frames_per_second: How fast it plays, up to 50 (browsers slow down faster films).

    Raises:
        ValueError: If there is no picture, or the speed is not in (0, 50].
        gymnasium.error.DependencyNotInstalled: If Pillow is not installed.
        OSError: If the file cannot be written.
    """
    if not 0 < frames_per_second <= 50:
        raise ValueError(f"frames_per_second must be above 0 and at most 50, got {frames_per_second!r}")
    require("plot", "PIL")
    arrays = [to_pixels(picture) if isinstance(picture, Scene) else picture for picture in pictures]
    if not arrays:
        raise ValueError("pictures must be one or more, got none")
    height, width = (max(array.shape[side] for array in arrays) for side in (0, 1))
    images = [_image(array, height, width) for array in arrays]
    milliseconds = math.ceil(100 / frames_per_second) * 10  # GIF counts hundredths of a second
    durations = [milliseconds] * (len(images) - 1) + [round(1000 * LAST_SECONDS)]
    contents = io.BytesIO()
    images[0].save(contents, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0)
    write_whole(path, contents.getvalue())


def _image(array: NDArray[np.uint8], height: int, width: int) -> "Image.Image":
    """Return a picture on a canvas of the film's size, reduced to at most 256 colours."""
    from PIL import Image

    canvas = Image.new("RGB", (width, height))
    canvas.paste(Image.fromarray(array))
    return canvas.quantize(256)
