"""What the pages of a website name: links, anchors and files, and which of them lead nowhere."""

from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Found(HTMLParser):
    """What a page names: targets of links, what it loads, and its anchors."""

    def __init__(self, text: str) -> None:
        """Read a page."""
        super().__init__()
        self.links, self.loads, self.anchors = list[str](), list[str](), {""}
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note what an element names."""
        named = {name: value or "" for name, value in attrs}
        self.anchors.update(named[name] for name in ("id", "name") if name in named)
        if tag == "a" and "href" in named:
            self.links.append(named["href"])
        elif tag == "link" and named.get("rel") not in ("next", "prev", "search", "index"):
            self.loads.append(named.get("href", ""))
        elif "src" in named:
            self.loads.append(named["src"])


def found_in(folder: Path) -> dict[Path, Found]:
    """What the pages in a folder name, without those of a playground."""
    files = [file for file in folder.rglob("*.html") if "playground" not in file.parts]
    return {file: Found(file.read_text(encoding="utf-8")) for file in files}


def broken(pages: dict[Path, Found]) -> list[str]:
    """Links to files and anchors that are not there."""
    wrong = []
    for file, found in pages.items():
        for link in found.links + found.loads:
            parts = urlsplit(link)
            if parts.scheme in ("http", "https", "data"):
                continue
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            if target.parts[-2:] == ("playground", "index.html"):  # its fragments are settings
                continue
            anchors = pages[target].anchors if target in pages else {parts.fragment}
            if not target.exists() or unquote(parts.fragment) not in anchors:
                wrong.append(f"{file}: {link}")
    return wrong
