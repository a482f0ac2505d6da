"""The sliders of a lesson on its page: pictures to flip through, for no kernel stands behind the page.

`site.js` changes the picture. Without JavaScript the picture of the first setting stays, and no slider is seen.
"""

import html
import json

from accessibility import alternative
from repository import ROOT

from edugym_course.notebook.flipbook import Flipbook, Turn, flipbooks

FOLDER = ROOT / "notebooks" / "flipbooks"
ONE_PANEL = 600
"""Pixels; what is wider cannot be read when it is as narrow as a phone, and is scrolled."""
VIEW = """<div class="flipbook">
{turns}
<div class="picture"><img{wide} src="{file}" alt="{alternative}" width="{width}" height="{height}" loading="lazy"/>
</div>
<p class="others">{says}</p>
</div>"""
TURN = """<div class="turn" data-pictures="{pictures}"><label for="{name}">{parameter}</label>
<input type="range" id="{name}" min="0" max="{last}" value="{start}" aria-valuetext="{value}" autocomplete="off"/>
<output for="{name}" style="min-width: {longest}ch">{value}</output></div>"""


def views(lesson: str) -> dict[str, Flipbook]:
    """Return the flipbooks of a lesson by the fingerprints of their cells: a cell that has changed finds none."""
    return {book.fingerprint: book for book in flipbooks(FOLDER / lesson)}


def shown(book: Flipbook, lesson: str, name: str, heading: str) -> str:
    """Return a flipbook as HTML; `name` is its own on the page, and the heading is part of what screen readers say."""
    pictures = [_pictures(turn, lesson, heading) for turn in book.turns]
    _, file, described = pictures[0][book.turns[0].start]
    names = [f"{name}-{number}" for number in range(len(pictures))]
    longest = max(len(value) for turn in book.turns for value in turn.values)
    return VIEW.format(
        turns="\n".join(map(_turn, book.turns, pictures, names, [longest] * len(names))),
        file=file,
        alternative=html.escape(described),
        wide=' class="wide"' if book.size[0] > ONE_PANEL else "",
        width=book.size[0],
        height=book.size[1],
        says=html.escape(_settings(book)),
    )


def _pictures(turn: Turn, lesson: str, heading: str) -> list[tuple[str, str, str]]:
    """Return the value, file and alternative text of each picture of a slider."""
    parameter = spoken(turn.parameter)
    return [
        (
            value,
            f"../notebooks/flipbooks/{lesson}/{file}",
            alternative(f"{heading}: {parameter} {value}" + (f"; {description}" if description else "")),
        )
        for value, file, description in zip(turn.values, turn.files, turn.descriptions, strict=True)
    ]


def _turn(turn: Turn, pictures: list[tuple[str, str, str]], name: str, longest: int) -> str:
    """Return a slider as HTML; `longest` is the number of letters that its value may have."""
    return TURN.format(
        pictures=html.escape(json.dumps(pictures, ensure_ascii=False)),
        name=name,
        parameter=html.escape(spoken(turn.parameter)),
        last=len(pictures) - 1,
        longest=longest,
        start=turn.start,
        value=html.escape(turn.values[turn.start]),
    )


def _settings(book: Flipbook) -> str:
    """Return what to say below a picture: the controls without a slider, what moves, and whether the axes change."""
    differ = [f"with {spoken(turn.parameter)}" for turn in book.turns if turn.axes_differ]
    if book.axes_differ:
        differ.append("from slider to slider")
    fixed = [f"{spoken(name)} = {value}" for name, value in book.fixed.items()]
    says = []
    if fixed:
        says.append(f"Drawn with {_listed(fixed)}.")
    if len(book.turns) > 1:
        says.append("When you move a slider, the others go back to where they began.")
    if differ:
        when = f" {_listed(differ)}" if len(book.turns) > 1 else ""
        says.append(f"The axes change too{when}: read their numbers.")
    if not fixed and len(book.turns) == 1:
        says.append("In JupyterLab each picture is computed when you move the slider.")
    return " ".join(says)


def what_moves(book: Flipbook) -> str:
    """Return what to say before a picture whose sliders do not all move here, or not together."""
    moving = _listed([f"`{spoken(turn.parameter)}`" for turn in book.turns])
    fixed = _listed([f"`{spoken(name)}`" for name in book.fixed])
    if len(book.turns) == 1:
        return f"*On this page you can move one slider, {moving}. In JupyterLab you can also change {fixed}.*"
    also = f", and also change {fixed}" if fixed else ""
    here = f"On this page you can move {moving}, one at a time, to some of their values."
    return f"*{here} In JupyterLab you can take all values and combine them{also}.*"


def _listed(names: list[str]) -> str:
    """Return names as one says them."""
    return " and ".join([*filter(None, [", ".join(names[:-1])]), *names[-1:]])


def spoken(parameter: str) -> str:
    """Return the name of a parameter as its slider has it in JupyterLab."""
    return parameter.replace("_", " ")
