"""Finished runs on the disk, so that the same call goes on where a crash, a full disk or `kill -9` ended it."""

import contextlib
import hashlib
import os
import pickle
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from edugym.experiments.configuration import ExperimentTask, Planned
from edugym.experiments.fingerprints import fingerprint
from edugym.system.files import write_whole
from edugym.training.run import Run

CHECKPOINTS = "checkpoints"
"""The name of the folder for finished runs in the folder of a lesson's results."""
SUFFIX = ".run"
DIGEST = 32  # bytes


class Checkpoints:
    """A folder with a file for each finished run, agent included.

    The name of a file is a hash of all that determines the run (`edugym.experiments.fingerprints`): a run with other
    settings, seeds or code has another name, and is never taken for this one. The files are pickles: use a folder that
    nobody else can write to.
    """

    def __init__(self, folder: Path | None) -> None:
        """Take the folder, which is made when it is first needed; None to keep nothing."""
        self._folder = folder
        self._methods: dict[str, str] = {}
        self._used: set[Path] = set()

    def describe(self, method: str, *determined_by: Any) -> None:
        """Say what determines the runs of a method, besides their seeds."""
        if self._folder is None:
            return
        try:
            self._methods[method] = fingerprint(*determined_by)
        except Exception as error:  # each class has its own for what cannot be taken apart
            _cannot_keep(method, error)

    def found(self, plan: list[Planned]) -> dict[Planned, Run]:
        """Those runs of the plan that are there."""
        loaded = ((planned, self._load(planned)) for planned in plan)
        return {planned: run for planned, run in loaded if run is not None}

    def save(self, planned: Planned, run: Run) -> None:
        """Keep a finished run.

        Raises:
            OSError: the file cannot be written.
        """
        path = self._path(planned)
        if path is None:
            return
        try:
            contents = pickle.dumps(run)
        except Exception as error:  # as of a class that is defined in a function: each has an error of its own
            del self._methods[planned.method]  # which is said once
            _cannot_keep(planned.method, error)
            return
        # Not synced: thousands of short runs would wait for the disk, and a damaged file shows by its digest.
        write_whole(path, hashlib.sha256(contents).digest() + contents, synced=False)

    def remove(self) -> None:
        """Remove the runs of this experiment and files that were never finished, and the folder once it is empty."""
        if self._folder is None or not self._folder.exists():
            return
        for path in self._folder.iterdir():
            if path in self._used or path.suffix != SUFFIX:
                path.unlink()
        with contextlib.suppress(OSError):  # there are runs of others
            self._folder.rmdir()

    def _load(self, planned: Planned) -> Run | None:
        path = self._path(planned)
        try:
            contents = path.read_bytes() if path else b""
        except OSError:
            return None
        if contents[:DIGEST] != hashlib.sha256(contents[DIGEST:]).digest():
            return None  # damaged, for example by a power failure
        try:
            run: Run = pickle.loads(contents[DIGEST:])
        except Exception:  # such as an agent of a class that is not there any more
            return None
        return run

    def _path(self, planned: Planned) -> Path | None:
        name = self._methods.get(planned.method)
        if self._folder is None or name is None:
            return None
        _, seed, layout_seed = planned.repetition
        path = self._folder / f"{hashlib.sha256(f'{name} {seed} {layout_seed}'.encode()).hexdigest()[:32]}{SUFFIX}"
        self._used.add(path)
        return path


def _cannot_keep(method: str, error: Exception) -> None:
    warnings.warn(
        f"finished runs of {method!r} cannot be kept on the disk, so an interruption loses them: {error}", stacklevel=2
    )


def checkpoints_in(
    folder: str | os.PathLike[str] | None,
    save_to: str | os.PathLike[str] | None,
    task: ExperimentTask,
    agents: Mapping[str, Any],
    training: dict[str, Any],
) -> Checkpoints:
    """Where finished runs are kept: in the folder, or else beside the file."""
    if folder is None and save_to is not None:
        folder = f"{os.fspath(save_to)}.unfinished"
    store = Checkpoints(None if folder is None else Path(folder))
    for label, agent in agents.items():
        store.describe(label, task.origin, agent, training)
    return store
