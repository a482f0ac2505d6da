"""The base of every widget of a lesson."""

import base64
import html
import io
import re
from collections.abc import Callable
from typing import Any

import ipywidgets
import numpy as np
from IPython.utils.capture import capture_output

from edugym.adapters.playing.game import Picture
from edugym.rendering.scene import Scene
from edugym.rendering.svg import to_svg

WIDGET = "application/vnd.jupyter.widget-view+json"
WITHOUT_KERNEL = "Run this cell to get the controls."
"""What a widget says where no kernel runs, beside its still picture."""
READABLE = 9.0
"""The least size of text in a picture, in CSS pixels: in a narrower cell the picture scrolls sideways."""
SMALLEST_FIGURE = 0.75
"""What is left of a figure at least; the numbers beside the axes of a `Sheet` are then as small as is readable."""


class NotebookWidget:
    """Widgets that show themselves in a notebook, and a still picture where no kernel runs, as on GitHub.

    The output of a callback, or its error, appears below the widgets.

    Attributes:
        widget: everything as one widget of ipywidgets, which can be put into another.
        messages: the output of the last callback.
    """

    def __init__(self, *rows: Any) -> None:
        """Stack the rows of widgets."""
        self.messages = ipywidgets.Output()
        self.widget = ipywidgets.VBox([*rows, self.messages])
        self._has_messages = False

    def still(self) -> dict[str, str]:
        """The present picture, by MIME type."""
        raise NotImplementedError

    def calling(self, action: Callable[[], None]) -> Callable[[Any], None]:
        """A callback for a widget that calls `action`.

        `messages` is left alone while there is nothing to show or to clear. nbclient, and so nbgrader, answers each of
        its changes, and may then miss that the cell has ended: https://github.com/jupyter/nbclient/issues/312.
        """

        def callback(event: Any) -> None:
            error: BaseException | None = None
            with capture_output() as output:
                try:
                    action()
                except BaseException as raised:
                    error = raised
            if self._has_messages:
                self.messages.clear_output()
            self._has_messages = bool(output.stdout or output.stderr or output.outputs or error)
            if self._has_messages:
                with self.messages:  # catches an error and shows it
                    output.show()
                    if error is not None:
                        raise error

        return callback

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What Jupyter stores in the notebook; the front end shows the richest form that it can."""
        view = {"version_major": 2, "version_minor": 0, "model_id": self.widget.model_id}
        return {WIDGET: view, "text/plain": WITHOUT_KERNEL} | self.still()


def picture_html(picture: Picture) -> str:
    """A picture of an environment for an HTML widget."""
    if isinstance(picture, Scene):
        return svg_html(to_svg(picture))
    if isinstance(picture, str):
        plain = re.sub("\x1b\\[[0-9;]*m", "", picture)  # Gymnasium's environments color their characters
        return f"<pre>{html.escape(plain)}</pre>"
    return png_html(png_of(picture), "The environment")


def picture_widget() -> ipywidgets.HTML:
    """A place for a picture, as wide as the cell at most; a wider picture scrolls, and stays there when it changes."""
    return ipywidgets.HTML(layout=ipywidgets.Layout(max_width="100%", overflow="auto"))


def svg_html(svg: str) -> str:
    """An SVG picture that is no wider than the page, for phones are narrow, unless its text would be too small."""
    size = re.search(r'<svg [^>]*width="([\d.]+)"[^>]* viewBox="0 0 ([\d.]+) ', svg)
    ems = [float(em) for em in re.findall(r'font-size="([\d.]+)"[^>]*>\s*[^<\s]', svg)]
    least = min(float(size[1]), READABLE * float(size[2]) / min(ems)) if size and ems else 0
    return svg.replace("<svg ", f'<svg style="{_widths(least)}; height: auto" ', 1)


def _widths(least: float) -> str:
    """The style of a picture that shrinks to the width of the page, but not below `least` CSS pixels."""
    return f"max-width: max(100%, {least:.0f}px)"


def png_of(pixels: np.ndarray[Any, np.dtype[np.uint8]]) -> bytes:
    """Pixels of shape (height, width, 3) as the contents of a PNG file."""
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(pixels).save(buffer, "PNG")
    return buffer.getvalue()


def png_html(png: bytes, description: str, smallest: float = 0) -> str:
    """A PNG file as an HTML element.

    Args:
        png: the contents of the file.
        description: what is in it, for readers who cannot see it.
        smallest: what is left of its size at least where the page is narrow.
    """
    data = base64.b64encode(png).decode()
    width, height = (int.from_bytes(png[place : place + 4], "big") for place in (16, 20))
    size = f'width="{width}" height="{height}" style="{_widths(smallest * width)}; height: auto"'
    return f'<img alt="{html.escape(description)}" src="data:image/png;base64,{data}" {size}>'


def text_html(text: str) -> str:
    """Lines of text for an HTML widget."""
    return html.escape(text).replace("\n", "<br>")
