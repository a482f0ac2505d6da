"""One page a lesson to project in class: the challenge, the picture, the equations, a bet, and what was measured.

All of it is taken from the lesson, by the headings and marks that every lesson has. `projected.css` makes its letters
large and hides what stands around it, and `site.js` turns to the next part of it when a key is pressed.
"""

import re
from collections.abc import Iterator
from functools import partial
from itertools import pairwise
from typing import Any

from lesson_pages import EXPLANATION, FOLD, FOLD_ENDS, Lesson
from panels import PANEL, panels, size

CHALLENGE = re.compile(r"\*\*The challenge\.\*\* (.*?)\n\n", re.DOTALL)
PICTURE = re.compile(r"^!\[.*\)(?:\{\.wide\})?$", re.MULTILINE)
EQUATION = re.compile(r"^### [^\n]*$|^\$\$\n.*?^\$\$$", re.MULTILINE | re.DOTALL)
QUESTION = re.compile(r'^<fieldset class="prediction">.*</fieldset>$', re.MULTILINE)
MEASURED = re.compile(r'<details class="measured">.*?</details>', re.DOTALL)
EXPLAINED = re.compile(rf"{re.escape(EXPLANATION)}.*</details>", re.DOTALL)
ASIDE = re.compile(rf"^### [^\n]*\n\n{re.escape(FOLD)}.*?{re.escape(FOLD_ENDS)}$\n*", re.MULTILINE | re.DOTALL)
RACE = re.compile(r'<details class="live"><summary>.*?: agents race in (\w+)')
FIGURE = re.compile(r"!\[([^\]]*)\]\((?:\.\./lessons/)?figures/(\S+)\.png\)\{\.wide\}")
TALL = 1.3
"""A figure whose height goes into its width fewer times is as wide as the page, though one has to scroll."""
LOW = 5
"""A legend is wider than so many times its height."""
MARK = '<div class="projected"><button type="button" class="fill">Fill the screen</button></div>'
PROGRAM = re.compile(r"^(`{3,})python\n.*?^\1$\n*", re.MULTILINE | re.DOTALL)


def pages(lessons: list[Lesson]) -> dict[str, str]:
    """Return the pages by their place, and the page that lists them."""
    listed = [f"- [{lesson.numbered}](/{_place(lesson)}.md)\n" for lesson in lessons]
    return {
        "project/index": "# To project in class\n\nOne page a lesson. Show the task and the equations, let the class "
        "bet, count the hands, and only then open what was measured. The keys → and ←, or Page Down and Page Up as a "
        "clicker sends them, turn to the next part and back; the button at the top fills the screen.\n\n"
        + "".join(listed),
        **{_place(lesson): page(lesson) for lesson in lessons},
    }


def page(lesson: Lesson) -> str:
    """Return what to project of a lesson; nothing of it comes from an aside."""
    path = ASIDE.sub("", lesson.text)
    sections = {part.partition(":")[0]: part for part in re.split(r"^## ", path, flags=re.MULTILINE)}
    task, idea = sections["Meet the environment"], sections["The idea"]
    question = _first(QUESTION, _bet(lesson)).replace("Your prediction. ", "", 1)
    return "\n\n".join([
        f"# {lesson.title}, to project",
        MARK,
        _first(CHALLENGE, lesson.text, 1),
        f"## {_heading(task)}",
        _first(PICTURE, task).replace("](figures/", "](../lessons/figures/"),
        f"## {_heading(idea)}",
        *_equations(idea),
        "## Place your bets",
        question,
        FIGURE.sub(partial(_readable, lesson), _measured(lesson).replace("](figures/", "](../lessons/figures/")),
        " · ".join(_links(lesson)),
        "",
    ])  # fmt: skip


def figures(lessons: list[Lesson]) -> dict[str, bytes]:
    """Return the panels that pages show in place of whole figures, by their place."""
    found = dict[str, bytes]()
    for lesson in lessons:
        for _, name in FIGURE.findall(_measured(lesson)):
            several = panels(lesson.figures[f"lessons/figures/{name}.png"])
            if len(several) > 1:
                found |= {f"project/figures/{name}-{k}.png": panel for k, panel in enumerate(several, start=1)}
    return found


def add_style(app: Any, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """Add the style of these pages in the head of each, so that it is there before anything is drawn."""
    if MARK in context.get("body", ""):
        app.add_css_file("projected.css", priority=900)  # after `site.css`


def _measured(lesson: Lesson) -> str:
    """What was measured of the first bet of a lesson, without what is said of it and without programs."""
    text = PROGRAM.sub("", EXPLAINED.sub("</details>", _first(MEASURED, _bet(lesson))))
    return text.replace("what this cell measured", "what was measured")


def _bet(lesson: Lesson) -> str:
    """The first section with a bet that is measured."""
    path = ASIDE.sub("", lesson.text)
    return next(
        part for part in re.split(r"^## ", path, flags=re.MULTILINE) if QUESTION.search(part) and MEASURED.search(part)
    )


def _readable(lesson: Lesson, found: re.Match[str]) -> str:
    """A figure so large that the numbers at its axes can be read from the last row."""
    says, name = found.groups()
    figure = lesson.figures[f"lessons/figures/{name}.png"]
    several = panels(figure)
    if len(several) == 1:
        return f"![{says}](../lessons/figures/{name}.png){{{_kind(figure)}}}"
    kinds = (_kind(part, ".panel") for part in several)
    return " ".join(f"![{says}, part {k}](figures/{name}-{k}.png){{{kind}}}" for k, kind in enumerate(kinds, start=1))


def _kind(figure: bytes, usual: str = "") -> str:
    """How large it is: a tall one and a legend fill the width, and panels stand in twos, with letters of one size."""
    width, height = size(figure)
    if not usual:
        return ".wide .tall" if width < TALL * height else ".wide"
    return f'.wide {usual} width="{49 * width / PANEL:.0f}%"' if width < LOW * height else ".wide"


def _links(lesson: Lesson) -> Iterator[str]:
    """Where to go on: the race of the lesson, with its settings; the lesson; and the other pages to project."""
    for race in RACE.findall(lesson.text):
        yield f'<a href="../playground/index.html#task={race}">Let the agents race in {race}</a>'
    yield f"[The whole lesson](/lessons/{lesson.name}.md)"
    yield "[All pages to project](/project/index.md)"


def _place(lesson: Lesson) -> str:
    return f"project/{lesson.name}"


def _first(pattern: re.Pattern[str], text: str, group: int = 0) -> str:
    found = pattern.search(text)
    assert found is not None, (pattern.pattern, text[:200])
    return found[group]


def _heading(section: str) -> str:
    heading = section.split("\n")[0].partition(": ")[2]
    return heading[0].upper() + heading[1:]


def _equations(section: str) -> list[str]:
    """Return the equations of a section, each below its heading."""
    found = [*EQUATION.findall(section), "### the end"]
    return [one for one, after in pairwise(found) if not (one[0] == after[0] == "#")]
