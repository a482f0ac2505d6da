"""The figures that a lesson shows, in its report and in its cells, after training that is made up."""

import ast
import contextlib
import io
import linecache
import sys
import warnings
from collections.abc import Iterator
from functools import partial
from typing import Any
from unittest.mock import patch

import build
from matplotlib import pyplot
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator
from rules import is_code, without_marks

from edugym.experiments import repeat as repeating
from edugym.experiments.figures import Sheet
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.scores import Profile
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.system.packages import OURS
from edugym.training.run import Run
from edugym.training.train import train
from edugym.training.train_players import GameRun, train_players
from edugym.training.train_vectors import VectorRun, train_vectors
from edugym_course.grading.challenge import Challenge
from edugym_course.lessons import load_experiments
from edugym_course.lessons.depth.methods import PASSING
from edugym_course.lessons.dimensionality import networks
from edugym_course.notebook.prediction import Prediction
from edugym_course.report import Report
from tests.course.lessons import records
from tests.course.lessons.few_runs import (
    ANY_RETURN,
    SOLVED_OR_NOT,
    few_profiles,
    few_runs,
    random_run,
    short_match,
    short_vectors,
)

NOTEBOOKS = {path.parent.name: path for path in build.lesson_sources().values()}
RETURNS = {"exploration": SOLVED_OR_NOT, "signal": (-1_000.0, 7_000.0)}
"""From where to where the made-up returns of a lesson are, if not those of the others."""
LEFT_OUT = (
    "importlib.util",  # installs the package
    "ppo.trainer(",  # trains a network
    "best_return(0.1", "crossing_by_attitude()", "repetitions=24)", "play_at_random(env", "after=300",
)  # fmt: skip
"""What is in the cells that are not run; the others in the list take seconds, and show what further cells show."""


@contextlib.contextmanager
def short_training(lesson: str, runs: int = 2, most: int = 50, calls: dict[str, None] | None = None) -> Iterator[Any]:
    """Yield a lesson's module whose agents train in `runs` runs for `most` steps at most, with made-up returns.

    `calls` takes what was asked for, each once.
    """
    module: Any = load_experiments(lesson)
    returns, asked = RETURNS.get(lesson, ANY_RETURN), {} if calls is None else calls
    made_up = partial(random_run, returns=returns, most=most)

    def single(environment: Any, agent: Any, n_steps: int, **how: Any) -> Run:
        asked[records.run(environment, agent, {"steps": n_steps, **how})] = None
        return made_up(environment, agent, n_steps, **how)

    def match(game: Any, agents: Any, n_steps: int, **how: Any) -> GameRun:
        asked[records.match(game, agents, {"steps": n_steps, **how})] = None
        return short_match(game, agents, n_steps, most=most, **how)

    def vectors(environment: Any, agent: Any, n_steps: int, **how: Any) -> VectorRun:
        asked[records.run(environment, agent, {"steps": n_steps, **how})] = None
        return short_vectors(environment, agent, n_steps, most=most, **how)

    def seldom(environment: Any, agents: Any, n_steps: int, **how: Any) -> Results:
        results = few_runs(environment, agents, n_steps, most=runs, **how | {"jobs": 1})
        asked.update(dict.fromkeys(records.experiment(results, {"steps": n_steps, **how})))
        return results

    def seldom_climbed(agents: Any, **how: Any) -> Profile:
        asked[f"profile, {records.arguments(how)}: {', '.join(agents)}"] = None
        return few_profiles(agents, most=runs, **how | {"jobs": 1})

    with contextlib.ExitStack() as stack:
        stack.enter_context(warnings.catch_warnings(action="ignore"))
        for found in [one for name, one in sys.modules.items() if name.partition(".")[0] in OURS]:
            replaced = (
                ("train", train, made_up if found is repeating else single),
                ("repeat", repeat, seldom),
                ("train_players", train_players, match),
                ("profile", profile, seldom_climbed),
                ("train_vectors", train_vectors, vectors),
                ("PASSING", PASSING, -2.5),  # which about half of the made-up agents reach
            )
            for name, real, instead in replaced:
                if vars(found).get(name) is real:
                    stack.enter_context(patch.object(found, name, instead))
        stack.enter_context(patch.object(networks, "train_network", side_effect=ImportError))
        stack.enter_context(patch.object(Challenge, "score", lambda *_: ""))
        stack.enter_context(patch.object(Prediction, "measured", lambda *_: ""))
        yield module


def short_report(lesson: str, seed: int = 1, **short: Any) -> Report:
    """Return the claims and the figures of a lesson's report."""
    with short_training(lesson, **short) as module:
        report: Report = module.report(repetitions=short.get("runs", 2), seed=seed, jobs=1)
        return report


def sheets_of_cells(lesson: str, **short: Any) -> list[Sheet]:
    """Return the figures that the cells of a lesson show, and its sliders where they start; checks are not made."""
    shown: list[Any] = []
    namespace: dict[str, Any] = {"__name__": "__main__", "display": lambda *values: shown.extend(values)}
    with short_training(lesson, **short), contextlib.redirect_stdout(io.StringIO()):
        for cell in build.read_lesson(NOTEBOOKS[lesson]).cells:
            if is_code(cell) and not any(text in cell.source for text in LEFT_OUT):
                run_cell(without_marks(cell.source), f"<{lesson}, {cell.id}>", namespace)
        shown += [
            one.function(**{name: control.value for name, control in one.controls.items()})
            for one in shown
            if type(one).__name__ == "Sliders"
        ]
    return [one for one in shown if isinstance(one, Sheet)]


def run_cell(source: str, file: str, namespace: dict[str, Any]) -> None:
    """Run a cell without its calls of `check`; its last value is displayed, as in a notebook."""
    body = [part for part in ast.parse(source).body if not ast.unparse(part).startswith("check(")]
    last = body.pop().value if body and isinstance(body[-1], ast.Expr) else None  # type: ignore[attr-defined]
    linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
    exec(compile(ast.Module(body, []), file, "exec"), namespace)
    if last:
        namespace["display"](eval(compile(ast.Expression(last), file, "eval"), namespace))


def check_legends(sheet: Sheet) -> None:
    """A panel by itself has a legend where it labels anything, with its own lines; training steps have thousands."""
    for panel in (panel for row in sheet.rows for panel in row):
        ax = panel.draw()
        by_hand = isinstance(ax.xaxis.get_major_locator(), FixedLocator)
        if (ax.get_xlabel(), ax.get_xscale(), by_hand) == ("training steps", "linear", False):
            assert ax.xaxis.get_major_formatter()(12_345) == "12\N{NO-BREAK SPACE}345", panel.title
        artists, labels = ax.get_legend_handles_labels()
        legend = ax.get_legend()
        assert (legend is not None) == bool(labels), panel.title
        texts, samples = (legend.get_texts(), legend.legend_handles) if legend else ([], [])
        shown = {text.get_text(): sample for text, sample in zip(texts, samples, strict=True)}
        for artist, label in zip(artists, labels, strict=True):
            sample = shown.get(label)
            if isinstance(artist, Line2D) and isinstance(sample, Line2D):
                assert (sample.get_color(), sample.get_linestyle()) == (artist.get_color(), artist.get_linestyle())
        pyplot.close(ax.get_figure(root=True))
