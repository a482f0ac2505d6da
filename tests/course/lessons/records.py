"""What a lesson does, as lines of text to read and to compare: its runs, its claims, what its figures show."""

import ast
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from difflib import unified_diff
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from matplotlib import pyplot
from matplotlib.container import BarContainer
from matplotlib.quiver import Quiver
from matplotlib.ticker import FixedLocator, NullLocator

from edugym.experiments.configuration import described, task
from edugym.experiments.figures import Sheet
from edugym.experiments.results.claims import Claim
from edugym.experiments.results.tables import Results

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
NUMBERS_ALONE = re.compile(r"[-(\[]*\d[-+*/\d.,()\[\] e]*")
CONTENTS = re.compile(r', "sha256": "\w+"|(?<= )\[\[.*?\]\]')
NOT_TOLD = ("progress", "stop", "jobs", "save_to", "checkpoints", "seed", "parameters")
"""Arguments of training that say nothing about what is measured, or that the results name; seeds show in numbers."""


def experiment(results: Results, how: Mapping[str, Any]) -> Iterator[str]:
    """Yield what an experiment compares, where and for how long, then each agent with its settings."""
    rows = results.table.groupby("method", sort=False).first()
    told = rows.filter(regex=r"^environment").iloc[0].to_dict()
    yield f"{listed(told)}, {arguments(how)}: {', '.join(map(str, rows.index))}"
    for method, row in rows.filter(regex=r"^agent").iterrows():
        yield f"  {method}: {listed({name: value for name, value in dict(row).items() if not pd.isna(value)})}"


def run(environment: Any, agent: Any, how: Mapping[str, Any]) -> str:
    """Return what is trained by itself, where and for how long."""
    known = {name: value for name, value in task(environment).settings.items() if name != "layout_seed"}
    trained = described(agent, "agent") if hasattr(agent, "_fields") or hasattr(agent, "__dict__") else {}
    return f"{listed(known)}, {arguments(how)}: {listed(trained)}"


def match(game: Any, agents: Sequence[Any], how: Mapping[str, Any]) -> str:
    """Return which players are trained, in which game and for how long."""
    players = " against ".join(listed(described(agent, "agent")) for agent in agents)
    return f"{listed(described(game, 'game'))}, {arguments(how)}: {players}"


def listed(settings: Mapping[Any, Any]) -> str:
    """Return names and values of settings; contents of tables are left out, which show in what is measured."""
    told = ", ".join(f"{name.partition('.')[2]} {value}".strip() for name, value in settings.items())
    return re.sub(r"\d+\.\d{5,}", lambda found: f"{float(found[0]):.5g}", CONTENTS.sub("", told))


def arguments(how: Mapping[str, Any]) -> str:
    """Return arguments as text."""
    told = {name: value for name, value in how.items() if name not in NOT_TOLD and value is not None}
    return ", ".join(f"{name} {value}" for name, value in told.items() if isinstance(value, int | float | str))


def claims(made: Sequence[Claim]) -> Iterator[str]:
    """Yield each claim with what made-up runs give, what it must be, and how far a reason is given and tested."""
    places = {claim.statement: str(place) for place, claim in enumerate(made, start=1)}
    for place, claim in enumerate(made, start=1):
        tests = ", ".join(places.get(statement, "?") for statement in claim.tested_by)
        more = "reason" * bool(claim.reason), tests and f"tested by {tests}", "remark" * bool(claim.remark)
        at = claim.measured
        bounds = f"{type(claim.expected).__name__} {', '.join(f'{bound:g}' for bound in claim.expected)}"
        yield f"{place}. {claim.statement}"
        yield f"   {claim.quantity}: {at.estimate:.5g} [{at.low:.5g}, {at.high:.5g}] of {at.n}"
        yield "   " + "; ".join([bounds, *filter(None, more)])


def figures(sheets: Sequence[Sheet]) -> Iterator[str]:
    """Yield what stands on each panel, and what is drawn there."""
    for sheet in sheets:
        figure = sheet.draw()
        for ax in figure.axes:
            if ax.axison or ax.texts or ax.has_data():
                yield " | ".join([f"{sheet.name}: {ax.get_title()}", ax.get_xlabel(), ax.get_ylabel()]).replace(
                    "\n", " / "
                )
                for line in (*axis(ax), *drawn(ax)):
                    yield "  " + line.replace("\n", " / ")
        pyplot.close(figure)


def axis(ax: Any) -> Iterator[str]:
    """Yield what is set of the axes of a panel: kinds, limits and ticks."""
    for name in "xy":
        own = getattr(ax, f"{name}axis")
        if own.get_scale() != "linear":
            yield f"{name} is {own.get_scale()}"
        if not getattr(ax, f"get_autoscale{name}_on")():
            yield "{} from {:.5g} to {:.5g}".format(name, *getattr(ax, f"get_{name}lim")())
        if isinstance(own.get_major_locator(), FixedLocator | NullLocator):
            ticks = [text.get_text() for text in own.get_ticklabels()]
            yield f"{name} ticks at {numbers(own.get_ticklocs())}: {' '.join(ticks)}".rstrip(": ")


def drawn(ax: Any) -> Iterator[str]:
    """Yield the lines, bars, pictures, other shapes and texts of a panel, with their numbers."""
    before = ""
    for line in ax.lines:
        over = f", over {numbers(line.get_xdata())}"
        yield f"{name_of(line, 'line')}: {numbers(line.get_ydata())}{over if over != before else ''}"
        before = over
    for bars in ax.containers:
        if isinstance(bars, BarContainer):
            yield f"{name_of(bars, 'bars')}: {numbers([patch.get_height() for patch in bars])}"
    corners = [patch.get_patch_transform().transform(patch.get_path().vertices) for patch in ax.patches]
    if corners:
        yield f"{len(corners)} patches: {places(corners)}"
    for picture in ax.images:
        values: Any = np.ma.filled(np.ma.asarray(picture.get_array(), float), np.nan)
        yield f"picture {' x '.join(map(str, values.shape))}: {numbers(values)}"
    shapes = [path.vertices for one in ax.collections for path in one.get_paths()]
    shapes += [one.get_offsets().reshape(-1, 2) for one in ax.collections]
    shapes += [np.column_stack([one.U, one.V]) for one in ax.collections if isinstance(one, Quiver)]
    if shapes:
        yield f"{len(ax.collections)} shapes: {places(shapes)}"
    if ax.texts:
        yield f"says: {' '.join(text.get_text() for text in ax.texts)}"


def places(points: Sequence[Any]) -> str:
    """Return `numbers` of what is shown across, and of what is shown up."""
    x, y = np.concatenate(points).T
    return f"{numbers(x)}; {numbers(y)}"


def name_of(artist: Any, otherwise: str) -> str:
    """Return the label of what is drawn, or what it is."""
    label = str(artist.get_label())
    return otherwise if not label or label.startswith("_") else label


def numbers(values: Any) -> str:
    """Return how many numbers there are, the first, the last and their mean; those that are not finite do not count."""
    known = np.asarray(values, float).ravel()
    known = known[np.isfinite(known)]
    if len(known) < 4:
        return " ".join(f"{number:.5g}" for number in known) or "nothing"
    return f"{known[0]:.5g} ... {known[-1]:.5g}, {len(known)} around {known.mean():.5g}"


def defaults(folder: Path) -> Iterator[str]:
    """Yield the numbers that a lesson's experiments name, and the functions that have default values, with these."""
    for path in sorted(folder.glob("*.py")):
        if path.name[0].isdigit() or path.stem in ("exercises", "project"):
            continue
        name, tree = path.stem, ast.parse(path.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef):
                told = ", ".join(f"{key} {ast.unparse(value)}" for key, value in given(node.args))
                if told:
                    yield f"{name}.{node.name}: {told}"
        for node in tree.body:
            if isinstance(node, ast.Assign) and NUMBERS_ALONE.fullmatch(ast.unparse(node.value)):
                yield f"{name}: {ast.unparse(node)}"


def given(arguments: ast.arguments) -> Iterator[tuple[str, ast.expr]]:
    """Yield the arguments that have default values, with these."""
    placed = [*arguments.posonlyargs, *arguments.args]
    pairs = [*zip(reversed(placed), reversed(arguments.defaults), strict=False)][::-1]
    for argument, value in [*pairs, *zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)]:
        if value is not None and re.search(r"\d|True|False", ast.unparse(value)):
            yield argument.arg, value


def differences(written: str, now: str) -> str:
    """Return in which lines a text is not what is written; numbers that are not whole may differ in the last digits."""
    old, new = written.splitlines(), now.splitlines()
    if len(old) == len(new):
        new = [before if alike(before, after) else after for before, after in zip(old, new, strict=True)]
    return "\n".join([*unified_diff(old, new, "as written", "as it is now", n=1, lineterm="")][:60])


def alike(line: str, other: str) -> bool:
    """Whether two lines say the same."""
    pairs = [*zip(NUMBER.findall(line), NUMBER.findall(other), strict=False)]
    return NUMBER.sub("#", line) == NUMBER.sub("#", other) and all(
        a == b or (not (a + b).isdigit() and math.isclose(float(a), float(b), rel_tol=2e-3, abs_tol=1e-9))
        for a, b in pairs
    )
