"""What is taken where nothing is given, in which order, and what is computed only once: readers rely on all of it."""

import importlib
import inspect
import pkgutil
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import is_dataclass
from pathlib import Path
from typing import Any

import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.error import DependencyNotInstalled

import edugym
from tests.agents.cases import AGENTS

FILE = Path(__file__).with_suffix(".txt")
NOT_LOOKED_AT = ("edugym.__main__", "edugym.lab.jupyter")
MODULES = [
    found.name
    for found in pkgutil.walk_packages(edugym.__path__, "edugym.", onerror=str)  # goes on where a library is missing
    if not found.name.startswith(NOT_LOOKED_AT)
]
KINDS = dict.fromkeys(case.kind for case in AGENTS.values())


def public(module: Any) -> Iterator[tuple[str, Any]]:
    """The functions, classes and methods that a module defines, by name, and all functions whose results are kept."""
    for name, value in vars(module).items():
        if (name.startswith("_") and not kept(value)) or getattr(value, "__module__", "") != module.__name__:
            continue
        if inspect.isfunction(value) or kept(value) or (inspect.isclass(value) and not issubclass(value, EnvSpec)):
            yield name, value
        for inner, member in vars(value).items() if inspect.isclass(value) else ():
            function = getattr(member, "__func__", member)
            if inspect.isfunction(function) and not inner.startswith("_"):
                yield f"{name}.{inner}", function


def kept(value: Any) -> bool:
    """Whether it is a function that computes nothing twice."""
    return hasattr(value, "cache_info") and not inspect.isclass(value)


def defaults(module: str) -> Iterator[str]:
    """A line for each of them that has any, and for each NamedTuple, whose fields are also known by their places."""
    for name, value in public(importlib.import_module(module)):
        try:
            parameters = inspect.signature(value).parameters
        except (TypeError, ValueError):  # as of a class without `__init__`
            continue
        taken = [
            key if one.default is one.empty else f"{key}={in_words(one.default)}" for key, one in parameters.items()
        ]
        if any("=" in one for one in taken) or hasattr(value, "_fields") or kept(value):
            yield f"{module}.{name}{' (kept)' * kept(value)}: {', '.join(taken)}".rstrip()


def in_words(value: Any) -> str:
    """A value without its address, and a number of NumPy's as one of Python's."""
    return re.sub(r" at 0x\w+", "", re.sub(r"np\.float64\(([^)]*)\)", r"\1", repr(value)))


def test_defaults() -> None:
    """If the change is meant, delete the file: this test writes it anew, for you to read what has changed."""
    now: list[str] = []
    missing: list[str] = []
    for module in MODULES:
        try:
            now += defaults(module)
        except (ImportError, DependencyNotInstalled, SystemExit):
            missing.append(f"{module}.")
    if not FILE.exists():
        FILE.write_text("\n".join(now) + "\n", encoding="utf-8")
        pytest.fail(f"{FILE} is new: read it, and commit it")
    before = FILE.read_text(encoding="utf-8").splitlines()
    assert now == [line for line in before if not line.startswith(tuple(missing))]


def test_what_cannot_be_changed() -> None:
    """Results, pictures and verdicts stay what they are; what Gymnasium or the clock changes does not."""
    frozen = {}
    for module in MODULES:
        with suppress(ImportError, DependencyNotInstalled, SystemExit):
            for kind in vars(importlib.import_module(module)).values():
                if inspect.isclass(kind) and is_dataclass(kind) and kind.__module__.startswith("edugym."):
                    made: Any = kind
                    frozen[kind.__name__] = made.__dataclass_params__.frozen
    assert {"Run", "Results", "Scene", "Circle", "Update"} - frozen.keys() == set()
    assert {name for name, is_frozen in frozen.items() if not is_frozen} == {"FilledSpec", "_Stretch"}


@pytest.mark.parametrize("kind", KINDS)
def test_fields_have_the_defaults_of_create(kind: Any) -> None:
    """Both ways of making an agent give the same one; its tables begin with zeros where nothing else is said."""
    created = {name: one.default for name, one in inspect.signature(kind.create).parameters.items()}
    fields = kind._field_defaults
    assert {name: value for name, value in fields.items() if created.get(name, value) != value} == {}
    assert created.get("initial_value", 0.0) == 0.0
