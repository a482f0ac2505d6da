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
        return {WIDGET: view, "text/plain": "Run this cell to get the controls."} | self.still()


def picture_html(picture: Picture) -> str:
    """A picture of an environment for an HTML widget."""
    if isinstance(picture, Scene):
        return svg_html(to_svg(picture))
    if isinstance(picture, str):
        plain = re.sub("\x1b\\[[0-9;]*m", "", picture)  # Gymnasium's environments color their characters
        return f"<pre>{html.escape(plain)}</pre>"
    return png_html(png_of(picture), "The environment")


def svg_html(svg: str) -> str:
    """An SVG picture that is no wider than the page: phones are narrow."""
    return svg.replace("<svg ", '<svg style="max-width: 100%; height: auto" ', 1)


def png_of(pixels: np.ndarray[Any, np.dtype[np.uint8]]) -> bytes:
    """Pixels of shape (height, width, 3) as the contents of a PNG file."""
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(pixels).save(buffer, "PNG")
    return buffer.getvalue()


def png_html(png: bytes, description: str) -> str:
    """A PNG file as an HTML element; the description is for readers who cannot see it."""
    data = base64.b64encode(png).decode()
    return f'<img alt="{html.escape(description)}" src="data:image/png;base64,{data}" style="max-width: 100%">'


def text_html(text: str) -> str:
    """Lines of text for an HTML widget."""
    return html.escape(text).replace("\n", "<br>")
