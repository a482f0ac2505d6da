"""What the experiments of a lesson give: claims and figures."""

import inspect
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Claim
from edugym.experiments.results.statistics import Interval


class Report(NamedTuple):
    """The outcome of the experiments of a lesson.

    Attributes:
        claims: the claims, each with its measurement.
        figures: the figures to draw; none after an interruption.
    """

    claims: Sequence[Claim]
    figures: Sequence[Sheet]


class Section(NamedTuple):
    """What the report says about one lesson.

    Attributes:
        name: the lesson.
        about: what was done, in Markdown: first the title, then the rest.
        claims: the rows of the file with the claims.
        figures: the pictures.
    """

    name: str
    about: str
    claims: Sequence[dict[str, Any]]
    figures: Sequence[Path]

    @property
    def n_hold(self) -> int:
        """How many claims hold."""
        return sum(bool(claim["holds"]) for claim in self.claims)


def markdown(sections: Sequence[Section], folder: Path) -> str:
    """A report of several lessons in Markdown: an overview, then the claims and figures of each lesson.

    Args:
        sections: the lessons.
        folder: the folder of the report, from which it refers to its figures.
    """
    overview = ([f"[{one.name}](#{one.name})", f"{one.n_hold} of {len(one.claims)}"] for one in sections)
    parts = ["# What the experiments show", *_table(("lesson", "claims that hold"), overview)]
    for section in sections:
        title, _, rest = inspect.cleandoc(section.about).partition("\n")
        parts += [f'<a id="{section.name}"></a>', f"## {title}", rest.strip()]
        parts += _table(("claim", "measured, with 95 % interval", "expected", "holds"), map(_row, section.claims))
        parts += [f"![{path.stem}]({path.relative_to(folder).as_posix()})" for path in section.figures]
    return "\n\n".join(part for part in parts if part) + "\n"


def _row(claim: dict[str, Any]) -> list[str]:
    measured = Interval(claim["estimate"], claim["low"], claim["high"], int(claim["n"]))
    reason = claim["reason"] if isinstance(claim["reason"], str) else ""  # an empty cell is read as NaN
    holds = "yes" if claim["holds"] else "**NO**"
    return [
        " — ".join(filter(None, (claim["statement"], reason))),
        f"{measured}: {claim['quantity']}",
        claim["expected"],
        holds,
    ]


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    lines = [head, ["---"] * len(head), *rows]
    return ["\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)]
