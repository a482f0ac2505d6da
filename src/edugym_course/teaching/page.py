"""The results of a class on one page: HTML without requests to other hosts, Markdown, and CSV."""

import csv
import html
import io
from collections.abc import Sequence

from edugym_course.teaching.assignment import Assignment
from edugym_course.teaching.grading import ORDINARY, Graded

STYLE = """\
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; }
th, td { padding: .3rem .8rem; border-bottom: 1px solid #8886; text-align: right; vertical-align: top; }
th:first-child, td:first-child, td:last-child, th:last-child { text-align: left; }
caption { text-align: left; padding-bottom: .5rem; }"""


def number(points: float) -> str:
    """Return points without needless digits."""
    return f"{points:g}"


def belongs(graded: Graded, assignment: Assignment) -> list[str]:
    """Return a sentence for each other student whose numbers some answers fit, and for the ordinary lesson."""

    def whose(other: str) -> str:
        return "the ordinary lesson" if other == ORDINARY else f"{assignment.students[other].name} ({other})"

    return [
        f"{_exercises(exercises)} {'fits' if len(exercises) == 1 else 'fit'} the numbers of {whose(other)}"
        for other, exercises in graded.fits.items()
    ]


def _exercises(numbers: Sequence[int]) -> str:
    texts = [*map(str, numbers)]
    if len(texts) == 1:
        return f"the answer to exercise {texts[0]}"
    return f"the answers to exercises {', '.join(texts[:-1])} and {texts[-1]}"


def table(assignment: Assignment, results: Sequence[Graded]) -> tuple[list[str], list[list[str]]]:
    """Return the heading and the rows of the results, the last row with the means."""
    most = [task.points for task in assignment.tasks]
    heading = ["student", *(f"exercise {task.number} ({number(task.points)})" for task in assignment.tasks)]
    rows = [
        [
            f"{graded.student.name} ({graded.student.id})",
            *(number(verdict.points) for verdict in graded.verdicts),
            number(graded.points),
            "; ".join([*belongs(graded, assignment), *graded.remarks]),
        ]
        for graded in results
    ]
    means = [
        f"{sum(graded.verdicts[place].points for graded in results) / len(results):.1f}" for place in range(len(most))
    ]
    mean = f"{sum(graded.points for graded in results) / len(results):.1f}"
    return [*heading, f"points ({number(sum(most))})", "remarks"], [*rows, ["mean", *means, mean, ""]]


def details(results: Sequence[Graded]) -> list[tuple[str, list[str]]]:
    """Return what the checks said, by student."""
    return [
        (
            f"{graded.student.name} ({graded.student.id})",
            [f"Exercise {place}: {verdict.says}" for place, verdict in enumerate(graded.verdicts, 1) if verdict.says],
        )
        for graded in results
        if any(verdict.says not in ("", *graded.remarks) for verdict in graded.verdicts)
    ]


def markdown(assignment: Assignment, results: Sequence[Graded]) -> str:
    """Return the page as Markdown."""

    def cells(texts: Sequence[str]) -> str:
        return "| " + " | ".join(text.replace("|", "\\|").replace("<", "&lt;") for text in texts) + " |"

    heading, rows = table(assignment, results)
    lines = [f"# {assignment.lesson}: the results of the class", "", cells(heading), "|" + "---|" * len(heading)]
    lines += [*map(cells, rows), "", "## What the checks said"]
    for name, said in details(results):
        lines += ["", f"### {name}", "", *(f"- `{text.replace('`', chr(39))}`" for text in said)]
    return "\n".join(lines) + "\n"


def as_html(assignment: Assignment, results: Sequence[Graded]) -> str:
    """Return the page as HTML, which loads nothing from anywhere."""
    heading, rows = table(assignment, results)
    escape = html.escape

    def row(texts: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(text)}</{tag}>" for text in texts) + "</tr>"

    title = escape(f"{assignment.lesson}: the results of the class")
    body = "\n".join(row(texts, "td") for texts in rows)
    said = "\n".join(
        f"<h3>{escape(name)}</h3>\n<ul>{''.join(f'<li>{escape(text)}</li>' for text in texts)}</ul>"
        for name, texts in details(results)
    )
    return f"""\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>{title}</title>
<style>
{STYLE}
</style>
</head>
<body>
<h1>{title}</h1>
<table>
<caption>Points for each exercise; in brackets the most that can be had.</caption>
<thead>{row(heading, "th")}</thead>
<tbody>
{body}
</tbody>
</table>
<h2>What the checks said</h2>
{said}
</body>
</html>
"""


def as_csv(assignment: Assignment, results: Sequence[Graded]) -> str:
    """Return a row for each student: points of every exercise and in all, and whose numbers her answers fit."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    names = [f"exercise_{task.number}" for task in assignment.tasks]
    writer.writerow(["id", "name", *names, "points", "most", "fits_numbers_of"])
    most = number(sum(task.points for task in assignment.tasks))
    for graded in results:
        points = [number(verdict.points) for verdict in graded.verdicts]
        fits = " ".join(
            f"{other or 'ordinary'}:{'+'.join(map(str, numbers))}" for other, numbers in graded.fits.items()
        )
        writer.writerow([graded.student.id, graded.student.name, *points, number(graded.points), most, fits])
    return text.getvalue()
