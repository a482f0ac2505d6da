"""Write the page of the claims, `docs/claims.md`: what every lesson claims, and what was measured of it.

Measuring all lessons took about 40 minutes on one core of a busy machine. So `docs/claims.json` keeps the results, and
the page is made from them.

    python docs/claims.py                       write the page
    python docs/claims.py --measure LESSON ...  measure these lessons, or "old" for all that have changed, then write it

A test says when the page is out of date.
"""

import argparse
import hashlib
import inspect
import json
import re
from pathlib import Path
from typing import Any

from edugym.system.files import write_whole
from edugym_course.lab.lessons import CHECKOUT
from edugym_course.lab.records import number_of
from edugym_course.lessons import lesson_names, load_experiments
from edugym_course.report import Section, cells_of, rows_of, table

PAGE, DATA = Path(__file__).parent / "claims.md", Path(__file__).parent / "claims.json"
LESSONS = Path(__file__).parents[1] / "src" / "edugym_course" / "lessons"
DIGITS = 6
"""Significant digits of a number that is kept."""
HEAD = """\
# What the lessons claim

{n_claims} claims of {n_lessons} lessons, each with what was measured. The code says beforehand in which range the
number must lie, and a claim holds only if its whole 95 % interval does. n is the number of values behind the interval;
what is computed and not estimated is *exact*. A reason that follows *because* was tested, by the claims whose numbers
stand behind it; a guess was not. Of {n_reasons} reasons {n_tested} were tested.

*Runs of a method* says how often `edugym reproduce` trains each method. Some claims take more runs or fewer, as their n
shows. The figures in a lesson have runs of their own, and the lesson says how many.

All seeds are spawned from seed 0. `edugym reproduce exploration` measures a lesson again, with other seeds by
`--seed 1`, and draws [its figures](paper.md). In November 2026 all lessons were measured with seeds 777 and 20261, too:
all claims held but four, which missed their ranges, three with seed 20261 and one with 777. Three of them have said
a smaller size since; that of seed 777 takes three times as many runs.

(This page is written by [`docs/claims.py`](claims.py).)
"""
OLD = "*The lesson's experiments have changed since this was measured.*"
MISSING = "*Not measured for this page yet:* `edugym reproduce {}` *does it.*"


def experiments_of(lesson: str) -> str:
    """A hash of what a lesson trains and claims, as its `report.txt` has it."""
    text = (LESSONS / lesson / "report.txt").read_text(encoding="utf-8")
    return hashlib.sha256(text.partition("# Figures\n")[0].encode()).hexdigest()[:12]


def measure(lesson: str) -> dict[str, Any]:
    """Measure the claims of a lesson, with its own number of runs."""
    report = load_experiments(lesson).report
    rows = [{name: _short(value) for name, value in row.items()} for row in rows_of(report().claims)]
    runs = inspect.signature(report).parameters["repetitions"].default
    return {"experiments": experiments_of(lesson), "runs": runs, "claims": rows}


def _short(value: Any) -> Any:
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}")
    return value if isinstance(value, bool | str) else int(value)


def read() -> dict[str, Any]:
    """What has been measured, by lesson."""
    measured: dict[str, Any] = json.loads(DATA.read_text(encoding="utf-8")) if DATA.exists() else {}
    return measured


def write(measured: dict[str, Any]) -> None:
    """Keep it, a claim a line."""
    lessons = []
    for name in filter(measured.__contains__, lesson_names()):
        *about, (_, claims) = measured[name].items()
        lines = ",\n".join(json.dumps(row, ensure_ascii=False, allow_nan=False) for row in claims)
        lessons.append(f'"{name}": {json.dumps(dict(about))[:-1]}, "claims": [\n{lines}\n]}}')
    write_whole(DATA, ("{\n" + ",\n".join(lessons) + "\n}\n").encode())


def page(measured: dict[str, Any]) -> str:
    """The page in Markdown."""
    files = {number_of(path.stem): path.stem for path in CHECKOUT.glob("*.ipynb")}
    overview, sections, parts = [], list[Section](), list[str]()
    for name in lesson_names():
        about = (LESSONS / name / "experiments.py").read_text(encoding="utf-8")
        first, title, number = re.findall(r'^"""(.)(.*?) \(lesson (\w+)\):', about)[0]
        title = f"{number}: {first.lower()}{title}"
        parts += [f"## Lesson {title}"]
        if name not in measured:
            parts += [MISSING.format(name)]
            continue
        found = measured[name]
        sections.append(section := Section(name, title, found["claims"], ()))
        counts = f"{section.n_hold} of {len(section.claims)}", f"{section.n_tested} of {section.n_reasons}"
        overview.append([f"[{title}](../notebooks/{files[number]}.ipynb)", *counts, str(found["runs"])])
        parts += [OLD] * (found["experiments"] != experiments_of(name))
        rows = ([str(i), *cells_of(row)] for i, row in enumerate(section.claims, start=1))
        parts += table(("", "claim", "measured, with 95 % interval", "expected", "holds"), rows)
    totals = {
        "n_claims": sum(len(one.claims) for one in sections),
        "n_reasons": sum(one.n_reasons for one in sections),
        "n_tested": sum(one.n_tested for one in sections),
    }
    head = HEAD.format(n_lessons=len(measured), **totals).rstrip()
    summary = table(("lesson", "claims that hold", "tested reasons", "runs of a method"), overview)
    return "\n\n".join([head, *summary, *parts]) + "\n"


def main() -> None:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measure", nargs="+", metavar="LESSON", default=[], help='lessons to measure, or "old"')
    options = parser.parse_args()
    measured = read()
    old = [name for name in lesson_names() if measured.get(name, {}).get("experiments") != experiments_of(name)]
    for name in old if options.measure == ["old"] else options.measure:
        measured[name] = measure(name)
        write(measured)
    PAGE.write_text(page(measured), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
