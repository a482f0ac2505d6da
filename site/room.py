"""Room for the pictures of an environment: without it a page jumps when they arrive."""

import re
import struct
from pathlib import Path
from typing import Any

PICTURE = re.compile(r'<img alt="([^"]*)" src="\.\./_images/([^"]+\.(?:svg|gif))" />')
HIGHEST = 416
"""How high a picture is at most, in pixels; `max-height` in site.css is the same, in rem."""


def size_of(picture: Path) -> tuple[int, int]:
    """Return the width and the height of a picture, in pixels, from its first bytes."""
    begin = picture.read_bytes()[:200]
    if picture.suffix == ".gif":
        width, height = struct.unpack("<HH", begin[6:10])
    else:
        width, height = (int(number) for number in re.findall(rb' (?:width|height)="(\d+)"', begin)[:2])
    return width, height


def add(app: Any, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """Say in the page of an environment how large its pictures will be."""
    if not page.startswith("environments/") or "body" not in context:
        return
    sources = {name: source for source, name in app.builder.images.items()}

    def with_room(found: re.Match[str]) -> str:
        alternative, name = found.groups()
        width, height = size_of(Path(app.srcdir, sources[name]))
        wide = round(width * min(1.0, HIGHEST / height))
        style = f"--width: {wide}px; aspect-ratio: {width} / {height}"
        return f'<img alt="{alternative}" src="../_images/{name}" style="{style}" />'

    context["body"] = PICTURE.sub(with_room, context["body"])
