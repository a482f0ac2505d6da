"""Which code is EduGym's own, which belongs to Python or an installed library, and which is therefore a user's."""

import sys
import sysconfig
from importlib.machinery import PathFinder
from pathlib import Path
from types import ModuleType
from typing import Any

OURS = frozenset({"edugym", "edugym_course"})
"""The two packages of this distribution: the library and the course."""
STANDARD = tuple(Path(sysconfig.get_path(kind)).resolve() for kind in ("stdlib", "platstdlib"))
SITES = frozenset({"site-packages", "dist-packages"})
"""The names of folders into which installers put packages: of Python, of a virtual environment, or of a user."""


def package_of(thing: Any) -> str:
    """The top-level package in which a class, function or module is defined; "" if it does not say."""
    name = thing.__name__ if isinstance(thing, ModuleType) else getattr(thing, "__module__", None)
    return (name or "").partition(".")[0]


def is_ours(thing: Any) -> bool:
    """Whether a class, function or module is EduGym's own."""
    return package_of(thing) in OURS


def is_own(value: Any) -> bool:
    """Whether all classes in a value are EduGym's own, or Python's and NumPy's, and no student's."""
    if isinstance(value, tuple) and not all(map(is_own, value)):
        return False
    return is_ours(type(value)) or package_of(type(value)) in ("builtins", "numpy")


def is_installed(place: str | Path) -> bool:
    """Whether a file or folder belongs to Python's library or to an installed package."""
    path = Path(place).resolve()
    return not SITES.isdisjoint(path.parts) or any(path.is_relative_to(folder) for folder in STANDARD)


def own_folders() -> list[Path]:
    """The folders with EduGym's own code: one for each of `OURS` that is there."""
    specs = (PathFinder.find_spec(name, sys.path) for name in sorted(OURS))
    return [Path(spec.origin).parent for spec in specs if spec and spec.origin]
