"""The experiments of the lessons: what each gives, and where it is.

Every lesson with experiments has a module here with one function for the command line and for tests:

    report(*, repetitions=..., seed=0, jobs=-1, progress=False, stop=None, folder=None) -> Report

It does the experiments of the lesson, writes the results into the folder as it goes, and says what they show, as data:
claims, and what is to be drawn (`edugym.plotting` draws it).
"""

import importlib
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple, Protocol, TypeAlias, cast

from edugym.mdp.protocol import Reals
from edugym.results.claims import Claim
from edugym.results.tables import Results

MODULES = {"exploration": "edugym.lessons.exploration"}
"""The module of each lesson that has experiments; imported when it is asked for."""


class Curves(NamedTuple):
    """Axes with a learning curve for each method.

    Attributes:
        title: what is above them.
        results: what is drawn.
        optimum: the best return that there is, for a dashed line; None for none.
        soft_optimum: the best return of a policy that goes on exploring, for another; None for none.
        share: whether returns are 1 or 0, so that the mean over repetitions is a share, with Wilson's interval.
        y_label: what the return is.
    """

    title: str
    results: Results
    optimum: float | None = None
    soft_optimum: float | None = None
    share: bool = False
    y_label: str = "return"


class VisitMap(NamedTuple):
    """Axes with a map of which states were visited when.

    Attributes:
        title: what is above them.
        visits: shape (n_intervals, n_states): the visits, a mean over repetitions or a count.
        n_steps: the training steps over which the intervals stretch.
        y_label: what the number of a state means.
    """

    title: str
    visits: Reals
    n_steps: int
    y_label: str = "state"


class Lines(NamedTuple):
    """Axes with a line for each method over something else than training.

    Attributes:
        title: what is above them.
        x: shape (n,): where the values are.
        lines: by label of the method, the values, shape (n,).
        x_label: what `x` is.
        y_label: what the values are.
        theory: by label, what they should be, for dashed lines.
    """

    title: str
    x: Reals
    lines: Mapping[str, Reals]
    x_label: str
    y_label: str
    theory: Mapping[str, Reals]


Panel: TypeAlias = Curves | VisitMap | Lines


class Figure(NamedTuple):
    """What is to be drawn: rows of axes.

    Attributes:
        name: of the file.
        rows: the axes, all rows of one length.
    """

    name: str
    rows: Sequence[Sequence[Panel]]


class Report(NamedTuple):
    """What the experiments of a lesson gave.

    Attributes:
        claims: what they show.
        figures: what is to be drawn of them.
    """

    claims: Sequence[Claim]
    figures: Sequence[Figure]


class Experiment(Protocol):
    """The experiments of one lesson: its module."""

    def report(
        self,
        *,
        repetitions: int = ...,
        seed: int = ...,
        jobs: int | None = ...,
        progress: bool = ...,
        stop: threading.Event | None = ...,
        folder: Path | None = ...,
    ) -> Report:
        """Do them; see `edugym.training.repeat` for most arguments.

        Results are written into `folder`, if one is given, as soon as they are there. What an interruption left undone
        is reported as not measured.
        """


def experiment(lesson: str) -> Experiment:
    """The experiments of a lesson.

    Raises:
        ValueError: there is no such lesson, or it has none.
    """
    if lesson not in MODULES:
        raise ValueError(f"lesson must be one of {', '.join(MODULES)}, but is {lesson!r}")
    return cast(Experiment, importlib.import_module(MODULES[lesson]))
