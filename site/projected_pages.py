"""One page a lesson to project in class: the challenge, the picture, the equations, a bet, and what was measured.

All of it is taken from the lesson, by the headings and marks that every lesson has. `site.css` makes its letters large
and hides what stands around it, and `site.js` turns to the next part of it when a key is pressed.
"""

import re
from collections.abc import Iterator
from itertools import pairwise

from lesson_pages import EXPLANATION, FOLD, FOLD_ENDS, Lesson

CHALLENGE = re.compile(r"\*\*The challenge\.\*\* (.*?)\n\n", re.DOTALL)
PICTURE = re.compile(r"^!\[.*\)(?:\{\.wide\})?$", re.MULTILINE)
EQUATION = re.compile(r"^### [^\n]*$|^\$\$\n.*?^\$\$$", re.MULTILINE | re.DOTALL)
QUESTION = re.compile(r'^<fieldset class="prediction">.*</fieldset>$', re.MULTILINE)
MEASURED = re.compile(r'<details class="measured">.*?</details>', re.DOTALL)
EXPLAINED = re.compile(rf"{re.escape(EXPLANATION)}.*</details>", re.DOTALL)
ASIDE = re.compile(rf"^### [^\n]*\n\n{re.escape(FOLD)}.*?{re.escape(FOLD_ENDS)}$\n*", re.MULTILINE | re.DOTALL)
RACE = re.compile(r'<details class="live"><summary>.*?: agents race in (\w+)')
MARK = '<div class="projected"></div>'
PROGRAM = re.compile(r"^(`{3,})python\n.*?^\1$\n*", re.MULTILINE | re.DOTALL)


def pages(lessons: list[Lesson]) -> dict[str, str]:
    """Return the pages by their place, and the page that lists them."""
    listed = [f"- [{lesson.numbered}](/{_place(lesson)}.md)\n" for lesson in lessons]
    return {
        "project/index": "# To project in class\n\nOne page a lesson. Show the task and the equations, let the class "
        "bet, count the hands, and only then open what was measured. The keys → and ←, or Page Down and Page Up as a "
        "clicker sends them, turn to the next part and back; the button at the top fills the screen. A click on a "
        "figure makes it as wide as the page, so that its numbers are larger.\n\n" + "".join(listed),
        **{_place(lesson): page(lesson) for lesson in lessons},
    }


def page(lesson: Lesson) -> str:
    """Return what to project of a lesson; nothing of it comes from an aside."""
    path = ASIDE.sub("", lesson.text)
    sections = {part.partition(":")[0]: part for part in re.split(r"^## ", path, flags=re.MULTILINE)}
    task, idea = sections["Meet the environment"], sections["The idea"]
    bet = next(part for part in sections.values() if QUESTION.search(part) and MEASURED.search(part))
    question = _first(QUESTION, bet).replace("Your prediction. ", "", 1)
    measured = PROGRAM.sub("", EXPLAINED.sub("</details>", _first(MEASURED, bet)))
    measured = measured.replace("what this cell measured", "what was measured")
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
        measured.replace("](figures/", "](../lessons/figures/"),
        " · ".join(_links(lesson)),
        "",
    ])  # fmt: skip


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
