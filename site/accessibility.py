"""What screen readers need: texts for pictures, and otherwise what Sphinx and its theme write so that they stumble."""

import re
from pathlib import Path

_SIGNATURE = re.compile(r'<dt class="sig .*?</dt>', re.DOTALL)
_MENDED = [
    ('class="caption" role="heading">', 'class="caption" role="heading" aria-level="2">'),
    ('<aside class="sidebar-drawer">', '<aside class="sidebar-drawer" aria-label="All pages">'),
    ('<aside class="toc-drawer">', '<aside class="toc-drawer" aria-label="On this page">'),
    ('<aside class="toc-drawer no-toc">', '<aside class="toc-drawer no-toc" aria-label="On this page">'),
    ('</noscript>\n\n<div id="search-results">', '</noscript>\n<h1>Search</h1>\n<div id="search-results">'),
    ('<th class="head"><p></p></th>', '<td class="head"></td>'),
]
_LINES = [("<dl>", '<span class="parameters">'), ("</dl>", "</span>"), ("<dd>", "<span>"), ("</dd>", "</span>")]


def alternative(text: str) -> str:
    """Return a text for a picture without the signs of Markdown and of formulas, which none can hear."""
    return re.sub(r"[\[\]$`*\\]|\s+", " ", text)


def mended(page: str) -> str:
    """Return a page in HTML in which headings have a level, landmarks a name, and lists the form of lists."""
    for written, better in _MENDED:
        page = page.replace(written, better)
    return _SIGNATURE.sub(lambda found: _spans(found[0]), page)


def _spans(signature: str) -> str:
    """Return a signature whose parameters, each on its line, are no list of definitions without terms."""
    for written, better in _LINES:
        signature = signature.replace(written, better)
    return signature


def mend(folder: Path) -> None:
    """Mend all pages in a folder."""
    for file in folder.rglob("*.html"):
        page = file.read_text(encoding="utf-8")
        if (better := mended(page)) != page:
            file.write_text(better, encoding="utf-8")
