"""What a lesson shows, as text: its claims and figures, and what its cells show, after training that is made up."""

import ast
import contextlib
import io
import linecache
import re
import sys
import warnings
import zlib
from collections.abc import Iterator
from decimal import Decimal
from functools import partial
from itertools import zip_longest
from pathlib import Path
from typing import Any
from unittest.mock import patch

import build
import numpy as np
from rules import is_code, without_marks

from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.rendering.scene import Scene
from edugym.rendering.svg import to_svg
from edugym.training.train import train
from edugym_course.grading.challenge import Challenge
from edugym_course.lessons import load_experiments
from edugym_course.lessons.dimensionality import networks
from edugym_course.notebook.prediction import Prediction
from tests.course.lessons.drawn import drawn, numbers
from tests.course.lessons.few_runs import ANY_RETURN, SOLVED_OR_NOT, few_runs, made_up_run, told
from tests.course.lessons.figures import check_legends

FOLDER = Path(__file__).parent / "transcripts"
NOTEBOOKS = {path.parent.name: path for path in build.lesson_sources().values()}
RETURNS = {"exploration": SOLVED_OR_NOT, "signal": (-1_000.0, 7_000.0)}
"""From where to where the made-up returns of a lesson are, if not those of the others."""
IN_SHORT = 2, 50
AT_LENGTH = {"exploration": (8, 50), "depth": (4, 1_500)}
"""How many runs there are, and for how many steps agents really train: in some lessons more, for claims on shares."""
LEFT_OUT = (
    "importlib.util",  # installs the package
    "ppo.trainer(",  # trains a network
    "best_return(0.1", "crossing_by_attitude()", "repetitions=24)", "play_at_random(env", "after=300",
)  # fmt: skip
"""What is in the cells that are not run; the others in the list take seconds, and show what further cells show."""
DATA = re.compile(r"\[[^\]]*\]")
BEGINS = re.compile(r"^ *((?:class|def) \w+)", re.MULTILINE)
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def transcript(lesson: str) -> str:
    """Return all that a lesson shows, after made-up training; panels that are drawn alone have their legends."""
    module = load_experiments(lesson)
    returns = RETURNS.get(lesson, ANY_RETURN)
    with warnings.catch_warnings(action="ignore"):
        with short_training(returns, *AT_LENGTH.get(lesson, IN_SHORT)) as runs:
            report = module.report(repetitions=runs, seed=1, jobs=1)
        lines = [line for claim in report.claims for line in claimed(claim)]
        for sheet in report.figures:
            lines += drawn(sheet)
            check_legends(sheet)
        with short_training(returns, *IN_SHORT):
            lines += shown_by_cells(NOTEBOOKS[lesson])
    return "\n".join(lines) + "\n"


def claimed(claim: Any) -> list[str]:
    """Return the lines on a claim."""
    verdict = "holds" if claim.holds else "fails"
    return [
        f"claim: {claim.statement}",
        f"  {claim.quantity}: {numbers(claim.measured)}, expected {claim.expected}: {verdict}",
        *([f"  {claim.reason}"] if claim.reason else []),
    ]


@contextlib.contextmanager
def short_training(returns: tuple[float, float], runs: int, most: int) -> Iterator[int]:
    """Let agents train for a few steps, in a few runs, with returns that depend on nothing but the arguments."""
    made_up = partial(made_up_run, returns=returns, most=most)

    def seldom(*arguments: Any, **how: Any) -> Results:
        return few_runs(*arguments, most=runs, **how | {"jobs": 1})

    with contextlib.ExitStack() as stack:
        for module in [
            module for name, module in sys.modules.items() if name.startswith(("edugym.", "edugym_course."))
        ]:
            for name, real, instead in (("train", train, made_up), ("repeat", repeat, seldom)):
                if vars(module).get(name) is real:
                    stack.enter_context(patch.object(module, name, instead))
        stack.enter_context(patch.object(networks, "train_network", side_effect=ImportError))
        stack.enter_context(patch.object(Challenge, "score", scored))
        stack.enter_context(patch.object(Prediction, "measured", lambda _, value, *more: measured(value)))
        yield runs


def measured(value: Any) -> str:
    """Return what a prediction is compared with."""
    return f"measured: {value if isinstance(value, str) else numbers(value)}"


def scored(challenge: Challenge, make: Any, name: str) -> str:
    """Return who takes part in a challenge, with what."""
    task = challenge._task(1)
    return f"{name}: {told(task, make(task), challenge.n_steps, {})}"


def shown_by_cells(path: Path) -> list[str]:
    """Return what the cells of a lesson print and show, each below its first line; checks are not made."""
    lines: list[str] = []
    shown: list[Any] = []
    namespace: dict[str, Any] = {"__name__": "__main__", "display": lambda *values: shown.extend(values)}
    for cell in build.read_lesson(path).cells:
        if not is_code(cell) or any(text in cell.source for text in LEFT_OUT):
            continue
        source = without_marks(cell.source)
        body = [part for part in ast.parse(source).body if not ast.unparse(part).startswith("check(")]
        last = body[-1] if body else None
        value = last.value if isinstance(last, ast.Expr) else None
        file = f"<{path.stem}, {cell.id}>"
        linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(ast.Module(body[:-1] if value else body, []), file, "exec"), namespace)
            if value:
                shown.append(eval(compile(ast.Expression(value), file, "eval"), namespace))
        texts = [*printed.getvalue().splitlines(), *(line for thing in shown for line in told_of(thing))]
        for sheet in shown:
            if hasattr(sheet, "rows") and hasattr(sheet, "draw"):
                check_legends(sheet)
        shown.clear()
        lines += [f"cell: {cell.source.splitlines()[0]}", *(f"  {text}" for text in texts)] if texts else []
    return lines


def told_of(value: Any) -> Iterator[str]:
    """Yield lines on what a cell shows: figures, controls in four positions, films, games, questions, texts.

    Of a listing, the names of its classes and functions.
    """
    kind = type(value).__name__
    if hasattr(value, "rows") and hasattr(value, "draw"):
        yield from drawn(value)
    elif kind == "Sliders":
        for name, ends in settings_of(value).items():
            yield f"{name}: {ends}"
            for line in told_of(value.function(**ends)):
                yield f"  {line}"
    elif kind == "Film":
        lines = [frame.line for frame in value.frames]
        yield f"film of {len(lines)} frames, {lines[0]!r} to {lines[-1]!r}"
        yield from (line for k in (0, len(lines) // 2, -1) for line in told_of(value.frames[k].picture))
    elif kind == "Buttons":
        yield f"play {told(value.game.environment, None, 0, {})}, {'' if value.blind else 'not '}blind"
        yield from told_of(value.game.picture())
    elif isinstance(value, Prediction):
        yield f"predict: {value.question} {[*value.options] if value.options else value.unit}".rstrip()
    elif kind == "Listing":
        yield f"listing of {value.module}: {', '.join(BEGINS.findall(value.code))}"
    elif isinstance(value, Scene):
        yield f"picture of {len(value.shapes)} shapes, {zlib.crc32(to_svg(value).encode()):x}"
    elif kind in ("Score", "str", "dict"):
        yield from str(value).splitlines()


def settings_of(sliders: Any) -> dict[str, dict[str, Any]]:
    """Return the arguments at which the controls start, those at both their ends, and others in between."""
    found: dict[str, dict[str, Any]] = {"start": {}, "low": {}, "middle": {}, "high": {}}
    for place, (name, control) in enumerate(sliders.controls.items()):
        values = positions(control)
        others = [value for value in values if value != control.value]
        between = [value for value in others if value not in (values[0], values[-1])] or others
        found["start"][name] = control.value
        found["low"][name], found["high"][name] = values[0], values[-1]
        found["middle"][name] = between[len(between) * (1 + place % 3) // 4]  # not all at one height
    return found


def positions(control: Any) -> list[Any]:
    """Return all values that a control may take, in their order."""
    if hasattr(control, "step"):
        low, high, step = (Decimal(str(value)) for value in (control.min, control.max, control.step))
        return [type(control.value)(low + k * step) for k in range(int((high - low) / step) + 1)]
    options = getattr(control, "options", None) or (False, True)
    return [option[1] if isinstance(option, tuple) else option for option in options]


def difference(old: str, new: str) -> list[str]:
    """Return the first lines that differ by more than the last digits of data, as in a diff."""
    olds, news = old.splitlines(), new.splitlines()
    for number, (before, now) in enumerate(zip_longest(olds, news, fillvalue=""), start=1):
        if not alike(before, now):
            return [f"line {number}:", f"- {before}", f"+ {now}"]
    return []


def alike(before: str, now: str) -> bool:
    """Whether two lines are the same but for the last digits of data, which stand in brackets."""
    if before == now:
        return True
    if DATA.sub("", before) != DATA.sub("", now):
        return False
    for one, other in zip(DATA.findall(before), DATA.findall(now), strict=True):
        numbers_before, numbers_now = ([float(text) for text in NUMBER.findall(data)] for data in (one, other))
        if NUMBER.sub("0", one) != NUMBER.sub("0", other):
            return False
        if not np.allclose(numbers_before, numbers_now, rtol=2e-3, atol=1e-6):
            return False
    return True
