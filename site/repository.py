"""The files of the checkout: which of them are pages of the website, and where a link to another one leads."""

import os
import re
import tomllib
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
_PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
REPOSITORY: str = _PROJECT["urls"]["Repository"]
VERSION: str = _PROJECT["version"]

REF = os.environ.get("EDUGYM_REF", "main")
"""The branch or tag on GitHub to which links lead: a release's own, so that they show its code later too."""

PICTURES = {".svg", ".png", ".gif"}
_FENCED = re.compile(r"^(?P<fence>`{3,}|~{3,}).*?^(?P=fence)`*$|`[^`\n]+`", re.MULTILINE | re.DOTALL)
_MAIN = f"{REPOSITORY}/blob/main/"
_LINK = re.compile(rf"(?<=\]\()(?:{re.escape(_MAIN)}|(?!https?:|mailto:|[#/]))[^)\s]+(?=\))")
_SECTION = re.compile(r"^<!-- section: (\S+) # (.+) -->$", re.MULTILINE)


def documented(changelog: str) -> str:
    """Return which version a checkout documents: a release, and what came after it if its changelog lists that."""
    later = changelog.partition("\n## [Unreleased]\n")[2].partition("\n## [")[0].strip()
    return f"{VERSION}, and what came after it" if later else VERSION


def page_of(path: str) -> str | None:
    """Return the page that a file of the checkout becomes, without an ending; None if it becomes none."""
    folder, name = os.path.split(path)
    stem, ending = os.path.splitext(name)
    if path == "README.md":
        return "index"
    if path == "docs/agents.md":
        return "agents/index"
    if path == "LICENSE":
        return "guides/license"
    if folder == "notebooks" and ending == ".ipynb":
        return f"lessons/{stem}"
    if ending == ".md" and folder == "docs/environments":
        return "environments/index" if stem == "README" else f"environments/{stem}"
    if ending == ".md" and folder in ("", "docs"):
        return f"guides/{stem.lower()}"
    if ending == ".md" and folder == "site/pages":
        return stem
    return None


def outside(pattern: re.Pattern[str], text: str, change: Callable[[str], str]) -> str:
    """Return a Markdown text in which all matches of a pattern are changed, except those in code."""
    pieces, end = [], 0
    for code in _FENCED.finditer(text):
        pieces += [pattern.sub(lambda match: change(match[0]), text[end : code.start()]), code[0]]
        end = code.end()
    return "".join([*pieces, pattern.sub(lambda match: change(match[0]), text[end:])])


def with_links(text: str, path: str, page: str) -> str:
    """Return a Markdown text of the checkout whose links lead to pages, to pictures, or to the repository on GitHub.

    Args:
        text: the text.
        path: the file that it stands in; its links are relative to this file.
        page: the page that it stands on.

    Raises:
        ValueError: a link leads nowhere.
    """

    def target(link: str) -> str:
        file, hash_sign, heading = link.partition("#")
        folder = "" if file.startswith(_MAIN) else os.path.dirname(path)
        there = os.path.normpath(os.path.join(folder, file.removeprefix(_MAIN)))
        if not (ROOT / there).exists():
            raise ValueError(f"{path} links to {link}, which is not there")
        if (known := page_of(there)) is not None:
            return relative(known + ".md", page) + hash_sign + heading
        if Path(there).suffix in PICTURES:
            return relative(picture_of(there), page)
        kind = "tree" if (ROOT / there).is_dir() else "blob"
        return f"{REPOSITORY}/{kind}/{REF}/{there}{hash_sign}{heading}"

    return outside(_LINK, text, target)


def picture_of(path: str) -> str:
    """Return where a picture of the checkout is in the sources of the website."""
    return f"pictures/{os.path.basename(path)}"


def relative(target: str, page: str) -> str:
    """Return the way from a page to a file of the website."""
    return os.path.relpath(target, os.path.dirname(page)).replace(os.sep, "/")


def section(path: str, heading: str) -> str:
    """Return what stands below a heading of a Markdown file, up to the next heading of its level or above."""
    text = (ROOT / path).read_text(encoding="utf-8")
    found = re.search(rf"^(#+) {re.escape(heading)}\n(.*?)(?=^#{{1,2}} |\Z)", text, re.MULTILINE | re.DOTALL)
    if found is None:
        raise ValueError(f"{path} has no heading {heading!r}")
    return found[2].strip()


def with_sections(text: str, page: str) -> str:
    """Put the sections of other files in their place: `<!-- section: README.md # Ten lines -->`."""
    return _SECTION.sub(lambda mark: with_links(section(mark[1], mark[2]), mark[1], page), text)
