"""Saving agents and loading them, as plain arrays and numbers: without pickle, a stranger's file runs no code."""

import importlib
import io
import json
import pkgutil
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from edugym import agents
from edugym.files import write_whole


def save(agent: Any, path: str | Path) -> None:
    """Write an agent, its tables and its settings, to a file in NumPy's `.npz` format.

    Args:
        agent: a NamedTuple of arrays, numbers and other such NamedTuples.
        path: where to; an existing file is replaced only when the new one is complete, and a folder that does not exist
            is made.

    Raises:
        ValueError: the agent holds something else, which could not be loaded again.
        OSError: the file cannot be written.
    """
    arrays: dict[str, Any] = {}
    structure = _structure(agent, "agent", arrays)
    contents = io.BytesIO()
    np.savez_compressed(contents, structure=np.array(json.dumps(structure)), **arrays)
    write_whole(path, contents.getvalue())


def load(path: str | Path, kinds: Iterable[type] = ()) -> Any:
    """Read an agent back.

    Args:
        path: a file that `save` wrote.
        kinds: the classes in it that are not EduGym's own, such as an agent from a notebook.

    Raises:
        ValueError: the file is no saved agent, or holds a class that is neither EduGym's nor among `kinds`.
        OSError: the file cannot be read.
    """
    known = {kind.__name__: kind for kind in (*_own_classes(), *kinds)}
    content = io.BytesIO(Path(path).read_bytes())
    try:
        if not zipfile.is_zipfile(content):
            raise ValueError("it is not in the .npz format")
        content.seek(0)
        with np.load(content, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
        return _build(json.loads(str(arrays.pop("structure"))), arrays, known)
    except Exception as error:  # there is no end to what can be wrong with a damaged file
        raise ValueError(
            f"path must name a file that save() wrote, but {str(path)!r} cannot be loaded: {error}"
        ) from error


def _structure(value: Any, name: str, arrays: dict[str, Any]) -> Any:
    """The value as JSON, its arrays put aside."""
    if isinstance(value, np.ndarray) and value.dtype.kind in "biuf":
        arrays[name] = value
        return {"array": name}
    if isinstance(value, tuple) and hasattr(value, "_fields"):
        parts = zip(value._fields, value, strict=True)
        fields = {key: _structure(part, f"{name}.{key}", arrays) for key, part in parts}
        return {"kind": type(value).__name__, "fields": fields}
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, bool | int | float | str):
        return {"value": value}
    raise ValueError(f"an agent that is saved must hold numbers, arrays and NamedTuples, but {name} is {value!r}")


def _build(structure: Any, arrays: dict[str, Any], known: dict[str, type]) -> Any:
    if "array" in structure:
        return arrays[structure["array"]]
    if "kind" not in structure:
        return structure["value"]
    if structure["kind"] not in known:
        raise ValueError(
            f"kinds must hold the class {structure['kind']}, which the file names and EduGym does not have"
        )
    fields = {key: _build(part, arrays, known) for key, part in structure["fields"].items()}
    return known[structure["kind"]](**fields)


def _own_classes() -> Iterator[type]:
    """The NamedTuple classes of all agents and strategies of the package."""
    for module in pkgutil.iter_modules(agents.__path__, f"{agents.__name__}."):
        yield from (kind for kind in vars(importlib.import_module(module.name)).values() if hasattr(kind, "_fields"))
