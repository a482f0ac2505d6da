"""What the tests of widgets have in common."""

from typing import Any

import ipywidgets


def texts(widget: Any) -> list[str]:
    """What the HTML widgets inside a widget say, from top to bottom."""
    if isinstance(widget, ipywidgets.HTML):
        return [str(widget.value)]
    return [text for child in getattr(widget, "children", ()) for text in texts(child)]
