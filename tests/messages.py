"""Messages are tested by what they name (the parameter, what is allowed, the value), and not by their words."""

import re
from typing import Any


def named(*things: Any) -> str:
    """A pattern for messages that name these things, in this order; a text as it is, anything else by its `repr`."""
    texts = (thing if isinstance(thing, str) else repr(thing) for thing in things)
    return ".*".join(rf"(?<!\w){re.escape(text)}(?!\w)" for text in texts)
