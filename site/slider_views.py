"""The sliders of a lesson on its page: pictures to flip through, for no kernel stands behind the page.

`site.js` changes the picture. Without JavaScript the picture of the first setting stays, and no slider is seen.
"""

import html
import json

from accessibility import alternative
from repository import ROOT

from edugym_course.notebook.flipbook import Flipbook, flipbooks

FOLDER = ROOT / "notebooks" / "flipbooks"
ONE_PANEL = 600
"""Pixels; what is wider cannot be read when it is as narrow as a phone, and is scrolled."""
VIEW = """<div class="flipbook" data-pictures="{pictures}">
<div class="turn"><label for="{name}">{parameter}</label>
<input type="range" id="{name}" min="0" max="{last}" value="{start}" aria-valuetext="{value}" autocomplete="off"/>
<output for="{name}" style="min-width: {longest}ch">{value}</output></div>
<div class="picture"><img{wide} src="{file}" alt="{alternative}" width="{width}" height="{height}" loading="lazy"/>
</div>
<p class="others">{says}</p>
</div>"""


def views(lesson: str) -> dict[str, Flipbook]:
    """Return the flipbooks of a lesson by the fingerprints of their cells: a cell that has changed finds none."""
    return {book.fingerprint: book for book in flipbooks(FOLDER / lesson)}


def shown(book: Flipbook, lesson: str, name: str, heading: str) -> str:
    """Return a flipbook as HTML; `name` is its own on the page, and the heading is part of what screen readers say."""
    files = [f"../notebooks/flipbooks/{lesson}/{file}" for file in book.files]
    parameter = spoken(book.parameter)
    alternatives = [
        alternative(f"{heading}: {parameter} {value}" + (f"; {description}" if description else ""))
        for value, description in zip(book.values, book.descriptions, strict=True)
    ]
    pictures = list(zip(book.values, files, alternatives, strict=True))
    return VIEW.format(
        pictures=html.escape(json.dumps(pictures, ensure_ascii=False)),
        name=name,
        parameter=html.escape(parameter),
        last=len(files) - 1,
        longest=max(map(len, book.values)),
        start=book.start,
        value=html.escape(book.values[book.start]),
        file=files[book.start],
        alternative=html.escape(alternatives[book.start]),
        wide=' class="wide"' if book.size[0] > ONE_PANEL else "",
        width=book.size[0],
        height=book.size[1],
        says=html.escape(_settings(book)),
    )


def _settings(book: Flipbook) -> str:
    """Return sentences on what does not change here, what does besides, and where one can change all."""
    axes = "The axes change too: read their numbers. " if book.axes_differ else ""
    if not book.others:
        return f"{axes}In JupyterLab each picture is computed when you move the slider."
    *first, last = [f"{spoken(name)} = {value}" for name, value in book.others.items()]
    drawn = " and ".join([*filter(None, [", ".join(first)]), last])
    return f"Drawn with {drawn}. {axes}".strip()


def what_moves(book: Flipbook) -> str:
    """Return what to say before a picture of which not all sliders move here."""
    others = [f"`{spoken(name)}`" for name in book.others]
    listed = " and ".join([*filter(None, [", ".join(others[:-1])]), others[-1]])
    here = f"On this page you can move one slider, `{spoken(book.parameter)}`."
    return f"*{here} In JupyterLab you can also change {listed}.*"


def spoken(parameter: str) -> str:
    """Return the name of a parameter as its slider has it in JupyterLab."""
    return parameter.replace("_", " ")
