"""The guides, by whom they are for."""

import re
from collections.abc import Mapping
from itertools import chain

GROUPS = {
    "For students": (
        "your-own",
        "notation",
        "profiles",
        "class-challenge",
        "several-agents",
        "several-objectives",
        "preferences",
        "offline",
    ),
    "For teachers": (
        "teaching",
        "own-numbers",
        "course-plans",
        "assessment",
        "claims",
        "statements",
        "license",
        "writing-lessons",
    ),
    "For engineers": (
        "machine-code",
        "speed",
        "clusters",
        "isolation",
        "paper",
        "coming-from-the-original-edugym",
        "architecture",
        "contributing",
        "changelog",
    ),
}

ORDER = [f"guides/{name}" for name in chain.from_iterable(GROUPS.values())]


def index(texts: Mapping[str, str]) -> str:
    """Return the page that lists the guides.

    Args:
        texts: all pages in Markdown, by their place.

    Raises:
        ValueError: a guide is in no group, or one in a group is not there.
    """
    there = {page for page in texts if page.startswith("guides/")}
    if different := there.symmetric_difference(ORDER):
        raise ValueError(f"site/guides.py must name each guide once, but look at {', '.join(sorted(different))}")
    parts = ["# Guides\n"]
    for group, names in GROUPS.items():
        parts += [f"\n## {group}\n\n", *(_line(f"guides/{name}", texts) for name in names)]
    return "".join(parts)


def _line(page: str, texts: Mapping[str, str]) -> str:
    title = re.findall(r"^# (.*)$", texts[page], re.MULTILINE)[0]
    return f"- [{title}](/{page}.md)\n"
