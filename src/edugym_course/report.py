"""What the experiments of a lesson give: claims and figures."""

import inspect
import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Claim
from edugym.experiments.results.statistics import Interval, in_short


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

    @property
    def n_reasons(self) -> int:
        """How many claims give a reason."""
        return sum(bool(_text(claim.get("reason"))) for claim in self.claims)

    @property
    def n_tested(self) -> int:
        """How many of the reasons are tested."""
        return sum(bool(_text(claim.get("tested_by"))) for claim in self.claims)


def markdown(sections: Sequence[Section], folder: Path) -> str:
    """A report of several lessons in Markdown: an overview, then the claims and figures of each lesson.

    Args:
        sections: the lessons.
        folder: the folder of the report, from which it refers to its figures.
    """
    overview = (
        [f"[{one.name}](#{one.name})", f"{one.n_hold} of {len(one.claims)}", f"{one.n_tested} of {one.n_reasons}"]
        for one in sections
    )
    parts = ["# What the experiments show", *table(("lesson", "claims that hold", "tested reasons"), overview)]
    for section in sections:
        title, _, rest = inspect.cleandoc(section.about).partition("\n")
        parts += [f'<a id="{section.name}"></a>', f"## {title}", rest.strip()]
        head = ("", "claim", "measured, with 95 % interval", "expected", "holds")
        parts += table(head, ([str(i), *cells_of(row)] for i, row in enumerate(section.claims, start=1)))
        parts += [f"![{path.stem}]({path.relative_to(folder).as_posix()})" for path in section.figures]
    return "\n\n".join(part for part in parts if part) + "\n"


def rows_of(claims: Sequence[Claim]) -> list[dict[str, Any]]:
    """The claims as rows of a table. Of the claims that test a reason it has the numbers, counted from 1.

    Raises:
        ValueError: if a reason is tested by a claim that is not there.
    """
    numbers = {claim.statement: number for number, claim in enumerate(claims, start=1)}
    rows = []
    for claim in claims:
        for statement in claim.tested_by:
            if statement not in numbers:
                raise ValueError(f"the claim '{claim.statement}' is tested by '{statement}', which is not claimed")
        tested_by = ", ".join(str(numbers[statement]) for statement in claim.tested_by)
        row = claim._asdict() | claim.measured._asdict() | {"tested_by": tested_by}
        del row["measured"]
        rows.append(row | {"expected": str(claim.expected), "holds": claim.holds})
    return rows


def explanation(row: dict[str, Any]) -> list[str]:
    """What is said of a claim beside its statement: the reason, how it was tested, and the remark."""
    reason, tested_by, remark = (_text(row.get(name)) for name in ("reason", "tested_by", "remark"))
    lines = []
    if reason:
        lines.append(f"because {reason} (tested by {tested_by})" if tested_by else f"our guess: {reason}")
    return [*lines, *filter(None, [remark])]


def _text(cell: Any) -> str:
    """The content of a cell: an empty one is read as NaN, and a single number as a number."""
    if isinstance(cell, float):
        return "" if math.isnan(cell) else str(int(cell))
    return "" if cell is None else str(cell)


def cells_of(row: dict[str, Any]) -> list[str]:
    """A claim as cells of a table: what it says, what was measured, what was expected, and whether it holds."""
    measured = Interval(row["estimate"], row["low"], row["high"], int(row["n"]))
    shown = f"{measured}, n = {measured.n}" if measured.n else f"{measured}"
    if measured.n == 1 and measured.low == measured.high:
        shown = f"{in_short(measured.estimate)}, exact"
    statement = " — ".join([row["statement"], *explanation(row)])
    return [statement, f"{shown}: {row['quantity']}", row["expected"], "yes" if row["holds"] else "**NO**"]


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """A table in Markdown, as the only part of a list of them."""
    lines = [head, ["---"] * len(head), *rows]
    return ["\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)]
