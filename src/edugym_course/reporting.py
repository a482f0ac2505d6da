"""Every lesson has a function `report`; the command line and the tests call it.

    report(*, repetitions=..., seed=0, jobs=-1, progress=False, stop=None, folder=None) -> Report

It runs the experiments, saves their results in the folder one by one, and returns the claims and figures. Ctrl-C ends
all of it with a `KeyboardInterrupt`. `reporting` builds it from two functions: one measures, one judges.
"""

import threading
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple, Protocol

from edugym.experiments.checkpoints import CHECKPOINTS
from edugym_course.report import Report


def for_mdp(make: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Turn a function that makes an agent for an MDP into one that takes an environment of it."""
    return partial(_make_for_mdp, make)


def _make_for_mdp(make: Callable[[Any], Any], environment: Any) -> Any:
    return make(environment.unwrapped.mdp)


class Reporter(Protocol):
    """The function `report` of a lesson."""

    def __call__(
        self,
        *,
        repetitions: int = ...,
        seed: int = ...,
        jobs: int | None = ...,
        progress: bool = ...,
        stop: threading.Event | None = ...,
        folder: Path | None = ...,
    ) -> Report:
        """Run the experiments.

        Args:
            repetitions: the number of runs of each method; by default that of the lesson.
            seed: the number from which all seeds are spawned.
            jobs: the number of runs at a time, as in `edugym.experiments.repeat`.
            progress: whether to show progress, as there.
            stop: an event that ends all experiments when it is set, as there. The report is then empty, since
                comparisons of incomplete results mean nothing.
            folder: the folder for the results, which are saved as soon as they are complete. Finished runs are kept in
                a folder `checkpoints` in it: the same call goes on from there.
        """


class SharedArguments(NamedTuple):
    """The arguments of `edugym.experiments.repeat` that all experiments of a lesson share.

    A lesson writes `compare(..., **how())`, or `compare(..., **how("name"))` to save the results as `name.csv`.

    Attributes:
        shared: the arguments.
        folder: the folder for the results; None saves nothing.
    """

    shared: dict[str, Any]
    folder: Path | None

    def __call__(self, name: str | None = None, **other: Any) -> dict[str, Any]:
        """The arguments for one experiment.

        Args:
            name: the name under which its results are saved.
            **other: arguments to add, or to take in place of the shared ones.
        """
        saved = {} if name is None or self.folder is None else {"save_to": self.folder / f"{name}.csv"}
        return self.shared | saved | other

    @property
    def repetitions(self) -> int:
        """The number of runs of each method."""
        return int(self.shared["repetitions"])


def reporting(
    measure: Callable[[SharedArguments], tuple[Any, ...]], judge: Callable[..., Report], repetitions: int
) -> Reporter:
    """Build the function `report` of a lesson.

    Args:
        measure: runs all experiments, and returns their results.
        judge: makes the claims and figures of these results, which are its arguments.
        repetitions: the number of runs of each method, unless the caller chooses another.
    """
    default = repetitions  # the name is taken by the parameter of `report`

    def report(
        *,
        repetitions: int = default,
        seed: int = 0,
        jobs: int | None = -1,
        progress: bool = False,
        stop: threading.Event | None = None,
        folder: Path | None = None,
    ) -> Report:
        stop = stop or threading.Event()  # one event ends all experiments
        shared = {"repetitions": repetitions, "seed": seed, "jobs": jobs, "progress": progress, "stop": stop}
        measured = measure(SharedArguments(shared | {"checkpoints": folder and folder / CHECKPOINTS}, folder))
        return Report([], []) if stop.is_set() else judge(*measured)

    return report
