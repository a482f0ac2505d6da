"""What the figures of each lesson show is what `figures.txt` in its folder says: panels, labels, series, exact numbers.

Training is made up: of a series that depends on it the file has the label alone, and of learning curves whose they are.
Of all others, which theory and planning give, it has the first and the last number; it has no colours, sizes or places.
"""

import re
from collections.abc import Container, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pandas as pd
import pytest
from matplotlib.container import BarContainer

from edugym.experiments.figures import Curves, Sheet
from edugym.experiments.results.claims import Claim
from tests.course.lessons.shown import NOTEBOOKS, check_legends, sheets_of_cells, short_report
from tests.course.lessons.test_measured import SMALL

IN_CELLS = "In the cells"  # the line of the file between the figures of the report and those that only cells show
NUMBERS = re.compile(r" \[(\S+), (\S+)\]$")

NO_SENTENCE = re.compile(
    r"(?i:and|but|nor|or|so|than|then|that|which|who|whose|it|its|they|their|this|these|too|also)\b|[a-z]{2,}"
)
"""What begins a statement that needs the one before it: such a word, or a small letter (but `n = 1` may begin one)."""
COUNTED = "(item|frame|sweep|step|reward|episode|word|run|hit)"
BOUND = re.compile(
    r"at (?:least|most) ([\d.]+)|up to ([\d.]+)(?=,|$)|within ([\d.]+) of each|([\d.]+) or more"
    r"|more than (\w+)fold|(\w+) times less|one in (?P<share>\w+) or more|less than (?P<percent>\d+) %"
)
"""The number that a statement gives as its bound."""
WRONG_PLURAL = re.compile(rf"(?<![\d.])(?<!\d )(?<!= )1 {COUNTED}s\b|(?<![\d.])([02-9]|\d\d+) {COUNTED}\b")


class Series(NamedTuple):
    """A series of a panel: its label, and its first and last number; for a picture the lowest and the highest."""

    label: str
    ends: tuple[float, ...] = ()


def shown_in(sheets: Sequence[Sheet], frames: dict[str, list[str]] | None = None) -> dict[str, list[Series]]:
    """Return the series of all panels of all sheets, by what is written on the panels; `frames` takes their frames."""
    curves = [panel for sheet in sheets for row in sheet.rows for panel in row if isinstance(panel, Curves)]
    tables = [panel.results.table.filter(regex=r"^(environment|n_steps)") for panel in curves]
    differing = varying(pd.concat(tables)) if tables else []
    found: dict[str, list[Series]] = {}
    for sheet in sheets:
        axes, width = sheet.draw().axes, max(map(len, sheet.rows))
        for y, row in enumerate(sheet.rows):
            for ax, panel in zip(axes[y * width :], row, strict=False):
                series = [*drawn(ax)]
                if isinstance(panel, Curves):
                    series = [*curves_of(panel, series, differing)]
                title = ax.get_title().partition("\n")[0]
                written = " | ".join([f"{sheet.name}: {title}", ax.get_xlabel(), ax.get_ylabel()]).rstrip(" |")
                written = f"{written} (again)" if written in found else written
                found[written] = series
                if frames is not None:
                    frames[written] = [*frame(ax)]
    return found


def varying(table: pd.DataFrame) -> list[str]:
    """Return the columns of a table that do not hold the same everywhere."""
    return [str(name) for name in table if table[name].astype(str).nunique() > 1]


def curves_of(panel: Curves, series: list[Series], differing: list[str]) -> Iterator[Series]:
    """Yield the series of learning curves: the settings of the panel, the agent of each curve, and straight lines."""
    rows = panel.results.table.groupby("method", sort=False).first()
    for name in differing:
        if name in rows:
            yield Series(f"{name}: {rows[name].iloc[0]}")
    agents = rows.filter(regex=r"^agent")
    for one in series:
        if "agent" in agents and one.label in agents.index:
            own = agents.loc[one.label]
            alike = agents[agents["agent"] == own["agent"]]
            settings = [f"{name.removeprefix('agent.')} {own[name]}" for name in varying(alike)]
            yield Series(f"{one.label}: {', '.join([str(own['agent']), *settings])}")
        else:
            yield one


def drawn(ax: Any) -> Iterator[Series]:
    """Yield the series of a panel: lines and bars with a label, and pictures."""
    for line in ax.lines:
        yield from labelled(line, np.array(line.get_ydata(), float))
    for bars in ax.containers:
        if isinstance(bars, BarContainer):
            yield from labelled(bars, np.array([patch.get_height() for patch in bars], float))
    for picture in ax.images:
        values: Any = np.ma.filled(np.ma.asarray(picture.get_array(), float), np.nan)
        if len(known := np.unique(values[np.isfinite(values)])) > 1:
            yield Series("picture", (known[0], known[-1]))


def frame(ax: Any) -> Iterator[str]:
    """Yield the limits that a panel sets, and over what its longest line goes."""
    for name in "xy":
        if not getattr(ax, f"get_autoscale{name}_on")():
            yield "{} from {:.3g} to {:.3g}".format(name, *getattr(ax, f"get_{name}lim")())
    yield f"{len(ax.lines)} lines, {len(ax.patches)} patches"
    if ax.lines:
        x = max((np.array(line.get_xdata(), float) for line in ax.lines), key=len)
        yield f"{len(x)} points from {x[0]:.3g} to {x[-1]:.3g}"


def labelled(artist: Any, values: Any) -> Iterator[Series]:
    """Yield the series that an artist draws, if it has a label."""
    label, known = str(artist.get_label()), values[np.isfinite(values)]
    if label and not label.startswith("_"):
        yield Series(label, (known[0], known[-1]) if len(known) else ())


def told(found: dict[str, list[Series]], other: dict[str, list[Series]]) -> str:
    """Return what figures show as text, with the numbers that are the same after other training."""
    lines = []
    for written, series in found.items():
        lines.append(written)
        others = {again.label: again.ends for again in other.get(written, [])}
        for one in series:
            exact = any(one.ends) and others.get(one.label) == one.ends
            lines.append(f"  {one.label} [{one.ends[0]:.4g}, {one.ends[1]:.4g}]" if exact else f"  {one.label}")
    return "\n".join(lines)


def check(text: str, found: dict[str, list[Series]]) -> None:
    """Compare what figures show with the text; numbers may differ in the last digits, as on other machines."""
    blocks = [block.splitlines() for block in re.split(r"\n(?! )", text.strip())]
    for written, *lines in blocks:
        series = found[written]
        assert len(lines) == len(series), written
        for line, one in zip(lines, series, strict=True):
            assert one.label.startswith(NUMBERS.sub("", line.strip())), written  # the file may leave settings out
            if numbers := NUMBERS.search(line):
                ends = [*map(float, numbers.groups())]
                assert ends == pytest.approx(one.ends, rel=2e-3, abs=1e-9), f"{written}: {line}"
    assert {written for written, *_ in blocks} == {*found}


def read(lesson: str) -> tuple[Path, str, str]:
    """Return the file of a lesson, what it says of the report, and of the cells."""
    path = NOTEBOOKS[lesson].parent / "figures.txt"
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    report, _, cells = text.partition(f"\n{IN_CELLS}\n")
    return path, report, cells


def asks_for_what_it_says(claim: Claim) -> bool:
    """Whether the bounds that a statement names are those that the numbers must keep."""
    asked = [abs(bound) for bound in claim.expected]
    for found in BOUND.finditer(claim.statement):
        said = found[found.lastindex or 0]
        number = float(SMALL.get(said, said))
        number = 1 / number if found["share"] else number / 100 if found["percent"] else number
        if number not in [pytest.approx(bound) for bound in asked]:
            return False
    return True


@pytest.fixture(autouse=True)
def torch_is_there_where_it_is_needed(lesson: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Networks are trained with it."""
    if lesson == "continuous_actions":
        pytest.importorskip("torch")
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_figures_of_the_report(lesson: str) -> None:
    """If a change is meant, edit the file, or delete it: this test writes it anew, for you to read `git diff`."""
    path, report, _ = read(lesson)
    frames_path = path.with_name("frames.txt")
    (claims, sheets), frames = short_report(lesson), dict[str, list[str]]()
    found = shown_in(sheets, frames)
    if not report or not frames_path.exists():
        other_frames: dict[str, list[str]] = {}
        others = shown_in(short_report(lesson, seed=2, runs=3, most=300).figures, other_frames)
        lines = [[name, *(part for part in parts if part in other_frames[name])] for name, parts in frames.items()]
        frames_path.write_text("\n".join(map(" || ".join, lines)) + "\n", encoding="utf-8")
        if not report:
            cells = only_in_cells(sheets_of_cells(lesson), found)
            path.write_text(f"{told(found, others)}\n{IN_CELLS}\n{told(cells, {})}\n", encoding="utf-8")
        pytest.fail(f"{path} or {frames_path} is new: read it, and commit it")
    check(report, found)
    assert [claim.statement for claim in claims if not asks_for_what_it_says(claim)] == []
    statements = [claim.statement for claim in claims if not claim.statement.startswith("novelty reward ")]  # a label
    assert [text for text in [*found, *statements] if WRONG_PLURAL.search(text)] == []
    assert [statement for statement in statements if NO_SENTENCE.match(statement)] == []
    for written, *parts in (line.split(" || ") for line in frames_path.read_text(encoding="utf-8").splitlines()):
        assert {*parts} <= {*frames[written]}, written
    for sheet in sheets:
        check_legends(sheet)


@pytest.mark.slow
@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_figures_of_the_cells(lesson: str) -> None:
    """Those that only the lesson's text shows, and its sliders where they start."""
    _, report, cells = read(lesson)
    sheets = sheets_of_cells(lesson)
    check(cells, only_in_cells(sheets, report.splitlines()))
    for sheet in sheets:
        check_legends(sheet)


def only_in_cells(sheets: list[Sheet], report: Container[str]) -> dict[str, list[Series]]:
    """Return what the sheets of cells show on panels that are not in the report."""
    return {written: series for written, series in shown_in(sheets).items() if written not in report}
