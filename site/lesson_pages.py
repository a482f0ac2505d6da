"""Lessons as pages: the students' notebooks, with the outputs that their executed edition has.

Nothing is executed here. Exercises come without their solutions, and checks without what they say about a solution.
"""

import base64
import html
import json
import re
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import urlencode

import film_views
import slider_views
from accessibility import alternative
from offers import Race
from races import RACES
from repository import REF, REPOSITORY, ROOT, with_links
from words import WORDS

from edugym import ENVIRONMENTS
from edugym.adapters.registration import find
from edugym_course.lab.records import number_of
from edugym_course.notebook.flipbook import fingerprint
from edugym_course.notebook.widget import WITHOUT_KERNEL

NOTEBOOKS = ROOT / "notebooks"
LIVE = "*In JupyterLab these controls are live.*"
RELEASED = re.compile(r"Move a slider\s+and release it: [^:.]* again, (?=with|exactly)")
MOVED = "Move a slider. Its pictures were computed beforehand, "
PLAY = f'{LIVE} <a href="../playground/index.html#{{}}">Play {{}} in the playground</a>.'
RACE = """<details class="live"><summary>Here, live: agents race in {0}, with sliders for {1}, α, γ and ε</summary>
<iframe class="playground" src="../playground/index.html?first#task={0}" loading="lazy"
title="Agents race in {0}: bet, run, and move sliders"></iframe>
</details>"""
"""It is loaded when it is opened."""
FOLD = '<details class="aside"><summary>Show this aside</summary>'
EXPLAINED = "<details><summary>What was measured</summary>\n"
EXPLANATION = "<!-- what it means -->"
"""It stands between what a cell measured and what the lesson says of it."""
FOLDED = "\n\n</details>"
MEASURED_ENDS = f"{FOLDED}\n::::"
FOLD_ENDS = "</details><!-- of the aside -->"
"""It ends otherwise than the folds inside of it, so that `projected_pages` can leave all of it out."""
IMAGES = {"image/svg+xml": "svg", "image/png": "png"}


class Lesson(NamedTuple):
    """A lesson as a page.

    Attributes:
        name: such as "01_exploration".
        title: its heading.
        text: the page, in Markdown.
        figures: the contents of its pictures by their path below the sources.
    """

    name: str
    title: str
    text: str
    figures: dict[str, bytes]

    @property
    def numbered(self) -> str:
        """The title behind the number by which guides call the lesson."""
        return f"{number_of(self.name)}. {self.title}"


def lessons() -> list[Lesson]:
    """Return all lessons, in order."""
    return [lesson(path) for path in sorted(NOTEBOOKS.glob("*.ipynb"))]


def lesson(path: Path) -> Lesson:
    """Return the page of a lesson."""
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    executed = json.loads((NOTEBOOKS / "solutions" / path.name).read_text(encoding="utf-8"))["cells"]
    outputs = {cell["id"]: (_source(cell), cell.get("outputs", [])) for cell in executed}
    heading, text, figures = "", list[str](), dict[str, bytes]()
    races, books, films = _races(path), slider_views.views(path.stem), film_views.views(path.stem)
    folded = False
    for cell in cells:
        source = _source(cell)
        opens = "jp-MarkdownHeadingCollapsed" in cell["metadata"]
        if folded and (opens or "aside" not in cell["metadata"].get("tags", [])):
            text.append(FOLD_ENDS)
            folded = False
        if cell["cell_type"] == "markdown":
            heading = [heading, *re.findall(r"^#+ (.*)$", source, re.MULTILINE)][-1]
            shown = RELEASED.sub(MOVED, with_links(source, f"notebooks/{path.name}", f"lessons/{path.stem}"))
            if shown.startswith(EXPLAINED) and text[-1].endswith(MEASURED_ENDS):  # one fold for both
                measured = text[-1].removesuffix(MEASURED_ENDS)
                text[-1] = f"{measured}\n\n{EXPLANATION}\n{shown.removeprefix(EXPLAINED)}\n::::"
                continue
            text.append(shown)
            if opens:
                text.append(FOLD)
                folded = True
            continue
        if cell["metadata"].get("jupyter", {}).get("source_hidden"):
            continue
        same, shown = outputs[cell["id"]]
        known = fingerprint(source, shown)
        book, film = books.get(known), films.get(known)
        if book and (book.fixed or len(book.turns) > 1):
            text.append(slider_views.what_moves(book))
        text.append(_fenced(source, "python"))
        if same == source and not {"check", "project"}.intersection(cell["metadata"].get("tags", [])):
            name = f"{path.stem}-{cell['id']}"
            view = slider_views.shown(book, path.stem, f"{name}-slider", heading) if book else ""
            body = _outputs(shown, source, name, heading, figures, view)
            if film:
                body = body.replace(LIVE, film_views.shown(film, f"{name}-film"), 1)
            text.append(body.replace(LIVE, _live(source)))
        if re.search(r"^sliders\(", source, re.MULTILINE):
            text += races
            races = []
    text.append("[Answer the three statements on this site](../survey.md), which sends nothing anywhere.")
    title = text[0].split("\n")[0].removeprefix("# ")
    return Lesson(path.stem, title, "\n\n".join([_opening(text[0], path), *text[1:], ""]), figures)


def _opening(first: str, path: Path) -> str:
    """Add to the first cell, below its heading, where to run the lesson."""
    heading, rest = first.split("\n", 1)
    rest = re.sub(r"\n\n\[Open this lesson in Colab\].*", "", rest)
    rest = re.sub(r"\n\n\*\*This page is a program\.\*\*.*?(?=\n\n|\Z)", "", rest, flags=re.DOTALL)  # here it is not
    colab = REPOSITORY.replace("https://github.com/", "https://colab.research.google.com/github/")
    notebook = f'<a href="../notebooks/{path.name}" download>download the notebook</a>'
    here = (
        "Here you read the lesson with its results. To change it and to solve its exercises, "
        "[install the lessons](../students.md#install-and-open-the-lessons), "
        f"{notebook}, or [open it in Colab]({colab}/blob/{REF}/notebooks/{path.name})."
    )
    for race in _raced(path):
        place = f"../playground/index.html#task={race.environment}"
        here += f' Or first <a href="{place}">race its agents in the playground</a>, and'
        here += f' <a href="{place}&amp;code=true">change an agent\'s code</a> there.'
    return f"{heading}\n\n:::{{container}} where\n{here}\n:::\n{rest}"


def _races(path: Path) -> list[str]:
    """Return the race of a lesson's environment, with sliders that need no Python; none where it has no race."""
    return [RACE.format(race.environment, WORDS[race.environment].strength) for race in _raced(path)]


def _raced(path: Path) -> list[Race]:
    """Return the race of a lesson's environment, if it has one."""
    number = number_of(path.stem)
    return [race for race in RACES if find(race.environment).lesson == number]


def _live(source: str) -> str:
    """Return what is said below controls; a task that one plays can also be played in the playground."""
    played = re.match(r'play\(\s*"(\w+)"', source)
    names = [entry.name for entry in ENVIRONMENTS]
    if played is None or played[1] not in names:
        return LIVE
    where = urlencode({"task": played[1], "play": "true"} | ({"blind": "true"} if "blind=True" in source else {}))
    return PLAY.format(where, played[1])


def _source(cell: dict[str, Any]) -> str:
    return "".join(cell["source"])


def _fenced(code: str, language: str) -> str:
    fence = "`" * max(3, *(len(run) + 1 for run in ["", *re.findall("`+", code)]))
    return f"{fence}{language}\n{code.rstrip()}\n{fence}"


def _outputs(
    outputs: list[dict[str, Any]], source: str, name: str, heading: str, figures: dict[str, bytes], view: str
) -> str:
    """Return all outputs of a cell; where they answer a prediction, they are shown on demand.

    Sliders are the `view`, if there is one, or else their first picture.
    """
    parts, answers = list[str](), False
    for number, output in enumerate(outputs):
        data = {kind: "".join(content) for kind, content in output.get("data", {}).items()}
        shown = data.get("text/html", "")
        if output["output_type"] == "stream":
            parts.append(_fenced("".join(output["text"]), "text"))
        elif shown.startswith("Your prediction. "):
            parts.append(_question(shown.removeprefix("Your prediction. "), name, source))
        elif shown.startswith("<p>Measured: "):
            answers = True
            parts.append(html.unescape(re.sub(r" \(You made no prediction.*", "", shown.removeprefix("<p>"))))
        elif view and data.get("text/plain") == WITHOUT_KERNEL:
            parts.append(view)
        elif kinds := [kind for kind in IMAGES if kind in data]:
            parts.append(_picture(data, kinds[0], f"{name}-{number}", heading, figures))
        elif "text/markdown" in data:
            parts.append(data["text/markdown"])
        elif data["text/plain"] == WITHOUT_KERNEL:
            parts.append(LIVE)
        else:
            parts.append(_fenced(data["text/plain"], "text"))
    if not parts:
        return ""
    body = "\n\n".join(parts)
    if answers:
        body = f'<details class="measured"><summary>Show what this cell measured</summary>\n\n{body}{FOLDED}'
    return f"::::{{container}} output\n{body}\n::::"


def _question(shown: str, name: str, source: str) -> str:
    """Return a prediction to make: radio buttons, or a field for a number with its unit, which the cell names."""
    question, _, choices = shown.partition("<br>")
    options = re.split(r"(?:^| )\([a-z]\) ", choices)[1:]
    fields = [f'<label><input type="radio" name="{name}"> {option}</label>' for option in options]
    unit = "".join(re.findall(r'unit="(.*?)"', source)[:1])
    fields = fields or [f'<label>your guess <input type="text" inputmode="decimal" size="8"> {unit}</label>']
    return f'<fieldset class="prediction"><legend>Your prediction. {question}</legend>{"".join(fields)}</fieldset>'


def _picture(data: dict[str, str], kind: str, name: str, heading: str, figures: dict[str, bytes]) -> str:
    """Note the file of a picture, and return the line that shows it."""
    path = f"lessons/figures/{name}.{IMAGES[kind]}"
    figures[path] = base64.b64decode(data[kind]) if kind == "image/png" else data[kind].encode()
    plain = data["text/plain"]
    titles = html.unescape("; ".join(dict.fromkeys(re.findall(r"<title>(.*?)</title>", data[kind]))))
    if sheet := re.match(r"<Sheet '.*?': (.*)>$", plain, re.DOTALL):
        titles = f"figure with the panels {sheet[1]}"
    said = alternative(f"{heading}: {titles or 'the controls at their first settings'}")
    wide = "{.wide}" if kind == "image/png" or data[kind].count("<svg") > 2 else ""
    picture = f"![{said}](figures/{name}.{IMAGES[kind]}){wide}"
    return f"{picture}\n\n{LIVE}" if plain == WITHOUT_KERNEL else picture
