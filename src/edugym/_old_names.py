"""Where things were in version 0.1: the old names of modules work for one more version, with a DeprecationWarning.

A finder at the end of Python's list of import systems is asked only for modules that nobody else finds.
"""

import importlib
import importlib.abc
import importlib.machinery
import pkgutil
import re
import sys
import warnings
from collections.abc import Sequence
from contextlib import suppress
from types import ModuleType
from typing import Any

MOVED = {
    "adapters.rooms": "edugym.adapters.double_buffer",
    "adapters.tabular_observation": "edugym.adapters.fitting",
    "cli": "edugym_course.cli",
    "commands": "edugym_course.commands",
    "compiled.generated": "edugym.system.generated",
    "compiled.bridge": "edugym.compiled.namedtuples",
    "compiled.copies": "edugym.compiled.snapshot",
    "compiled.generators": "edugym.compiled.random_generators",
    "compiled.judging": "edugym.compiled.typed_checks",
    "compiled.passes": "edugym.compiled.untyped_checks",
    "compiled.pipelines": "edugym.compiled.compiler_pipelines",
    "compiled.reasons": "edugym.compiled.error_messages",
    "compiled.turns": "edugym.compiled.interrupt_polling",
    "exercises": "edugym_course.lessons",
    "extras": "edugym.system.extras",
    "files": "edugym.system.files",
    "grading": "edugym_course.grading",
    "grading.patience": "edugym_course.grading.time_limit",
    "grading.verdict": "edugym_course.grading.checking",
    "grading.wrong": "edugym_course.grading.errors",
    "interrupts": "edugym.system.interrupts",
    "lab": "edugym_course.lab",
    "lessons": "edugym_course.lessons",
    "mdp.checking": "edugym.checks.mdps",
    "mdp.tracebacks": "edugym.checks.tracebacks",
    "mdp.values": "edugym.checks.values",
    "memory": "edugym.system.memory",
    "notebook": "edugym_course.notebook",
    "playing": "edugym.adapters.playing",
    "plotting.report": "edugym_course.report",
    "plotting": "edugym.experiments.figures",
    "registration": "edugym.adapters.registration",
    "results": "edugym.experiments.results",
    "sharing": "edugym.adapters.sharing",
    "stored": "edugym_course.stored",
    "training.checked_env": "edugym.checks.envs",
    "training.checking": "edugym.checks.agents",
    "training.checkpoints": "edugym.experiments.checkpoints",
    "training.configuration": "edugym.experiments.configuration",
    "training.contract": "edugym.checks.contract",
    "training.fingerprints": "edugym.experiments.fingerprints",
    "training.guarded": "edugym.mdp.guards",
    "training.repeat": "edugym.experiments.repeat",
}
"""The new place of each module or package that has moved, by its old name below `edugym`."""

RENAMED = {
    "edugym.grading.student_code.running": "edugym_course.grading.student_code.student_code",
    "edugym.interrupts.Work": "edugym.system.interrupts.SignalGuard",
    "edugym.interrupts.held": "edugym.system.interrupts.deferring_signals",
    "edugym.mdp.checking.check_mdp": "edugym.mdp.task.check_mdp",
    "edugym.mdp.checking.require_environment": "edugym.checks.interfaces.require_environment",
    "edugym.mdp.checking.require_mdp": "edugym.checks.interfaces.require_mdp",
    "edugym.mdp.checking.require_method": "edugym.checks.interfaces.require_method",
    "edugym.mdp.values.own_copy": "edugym.checks.values.deep_copy",
    "edugym.plotting.style.own_axes": "edugym.experiments.figures.style.axes_or_new",
    "edugym.registration.full_id": "edugym.mdp.task.full_id",
}
"""Names in these modules that are called otherwise now, or lie in another module than the rest."""


def new_name(old: str) -> str | None:
    """The new name of a module, or None if it has not moved. Modules inside a package moved along with it."""
    below, rest = old.removeprefix("edugym."), ""
    while below:
        if below in MOVED:
            if below == "exercises" and rest:  # each lesson holds its own now
                lesson, _, inner = rest[1:].partition(".")
                rest = f".{lesson}.exercises" + (f".{inner}" if inner else "")
            return MOVED[below] + rest
        below, _, last = below.rpartition(".")
        rest = f".{last}{rest}"
    return None


class OldNames(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Imports a module by its old name."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        """Describe the module, if it has moved."""
        if not fullname.startswith("edugym.") or new_name(fullname) is None:
            return None
        return importlib.machinery.ModuleSpec(fullname, self, is_package=True)

    def create_module(self, spec: importlib.machinery.ModuleSpec) -> ModuleType:
        """Make the module that stands for the moved one."""
        new = new_name(spec.name)
        assert new is not None
        importlib.import_module(new)  # it may say that a library is missing
        warnings.warn(f"{spec.name} has moved: import {new}", DeprecationWarning, stacklevel=2)
        return Moved(spec.name, new)

    def exec_module(self, module: ModuleType) -> None:
        """There is nothing to do: names are looked up in the new module."""


class Moved(ModuleType):
    """A module under its old name: it has the names of the new one, and of the modules in it if that is a lesson."""

    def __init__(self, old: str, new: str) -> None:
        """Stand for the module `new`."""
        super().__init__(old, importlib.import_module(new).__doc__)
        self.__path__: list[str] = []
        self._new = new

    def __getattr__(self, name: str) -> Any:
        """Look up a name; a lesson once handed on what its files define."""
        if name.startswith("__") and name != "__all__":
            raise AttributeError(name)
        if renamed := RENAMED.get(f"{self.__name__}.{name}"):
            place, _, now = renamed.rpartition(".")
            return getattr(importlib.import_module(place), now)
        module = importlib.import_module(self._new)
        found = getattr(module, name, None)
        if re.fullmatch(r"edugym_course\.lessons\.\w+", self._new):
            handed_on = _handed_on(module, name)
            found = found if handed_on is None else handed_on
        if isinstance(found, ModuleType) and found.__name__ == f"{self._new}.{name}":
            return importlib.import_module(f"{self.__name__}.{name}")
        if found is None and not hasattr(module, name):
            raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
        return found


def _handed_on(lesson: ModuleType, name: str) -> Any:
    """What a lesson's package once called by this name: it is in its experiments, or else in another of its files."""
    from gymnasium.error import DependencyNotInstalled  # here, since `import edugym` should not take its time

    if name == "attempt":
        return importlib.import_module("edugym.training.attempt").attempt
    files = [inner.name for inner in pkgutil.iter_modules(lesson.__path__) if inner.name.isidentifier()]
    for file in sorted({*files} - {"exercises"}, key=lambda file: (file != "experiments", file)):
        with suppress(ImportError, DependencyNotInstalled):  # another file may have the name
            found = getattr(importlib.import_module(f"{lesson.__name__}.{file}"), name, None)
            if found is not None and not isinstance(found, ModuleType):
                return found
    return None


def install() -> None:
    """Let the old names be found."""
    if not any(isinstance(finder, OldNames) for finder in sys.meta_path):
        sys.meta_path.append(OldNames())
