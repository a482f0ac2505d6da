"""What a page says of itself where its link is passed on: title, description, and a picture if the address is known."""

import os
from html import escape
from typing import Any

from docutils import nodes

ADDRESS = os.environ.get("EDUGYM_SITE", "").rstrip("/")
"""Where the site will be, such as https://example.org/edugym. Only a whole address can name a picture of a preview."""
PICTURE = "_images/supermarket.gif"
MOST = 200
"""Letters of a description."""


def described(doctree: Any) -> str:
    """Return the first paragraph of a page that stands in no box, list or table, cut between two words."""
    paragraphs = (node.astext() for node in doctree.findall(nodes.paragraph) if isinstance(node.parent, nodes.section))
    text = " ".join(next((found for found in paragraphs if len(found.split()) > 3), "").split())
    return text if len(text) <= MOST else f"{text[: MOST - 2].rsplit(' ', 1)[0]} …"


def tags(title: str, description: str) -> str:
    """Return the elements of a page's head."""
    said = {"og:site_name": "EduGym", "og:type": "website", "og:title": title, "og:description": description}
    if ADDRESS:
        said["og:image"] = f"{ADDRESS}/{PICTURE}"
    parts = [f'<meta name="description" content="{escape(description)}">'] if description else []
    parts += [f'<meta property="{name}" content="{escape(value)}">' for name, value in said.items() if value]
    return "".join(f"{part}\n" for part in parts)


def add(app: Any, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """Add to the head of a page what Sphinx does not write."""
    if doctree is not None:  # the search and the index of names have none
        context["metatags"] += tags(app.env.titles[page].astext(), described(doctree))
