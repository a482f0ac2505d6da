"""Save and load agents as plain arrays and numbers. Without pickle, a file from a stranger cannot run code."""

import importlib
import io
import json
import math
import pkgutil
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from edugym.agents.settings import check
from edugym.checks.parameters import MOST_STEPS, a_path, in_short, several, whole_number
from edugym.system.files import write_whole

MOST_BYTES = 2**30
"""How large the arrays of a file may be by default: a small file can unpack to a thousand times its size."""


def save(agent: Any, path: str | Path) -> None:
    """Write an agent, its tables and its settings, to a file in NumPy's `.npz` format.

    Args:
        agent: a NamedTuple of arrays, numbers and other such NamedTuples.
        path: the file. Its folder is made if it does not exist; an old file is replaced when the new one is complete.

    Raises:
        ValueError: the agent is not such a NamedTuple, or a setting is wrong: it could not be loaded again.
        OSError: the file cannot be written.
    """
    if not _is_named_tuple(agent):
        raise ValueError(f"agent must be a NamedTuple, such as QLearning.create(...), but is {in_short(agent)}")
    path = a_path("path", path)
    check(agent)
    arrays: dict[str, Any] = {}
    structure = _structure(agent, "agent", arrays)
    contents = io.BytesIO()
    np.savez_compressed(contents, structure=np.array(json.dumps(structure)), **arrays)
    write_whole(path, contents.getvalue())


def load(path: str | Path, kinds: Iterable[type] | type = (), *, max_bytes: int = MOST_BYTES) -> Any:
    """Read an agent from a file that `save` wrote.

    Args:
        path: the file.
        kinds: the classes in it that are not EduGym's own, such as an agent from a notebook.
        max_bytes: the size of its tables in memory, at most. A larger file is refused before it is unpacked.

    Raises:
        ValueError: the file is not a saved agent; it holds a class that is neither EduGym's nor among `kinds`, a value
            that does not fit its class, or larger tables than `max_bytes`.
        OSError: the file cannot be read.
    """
    if isinstance(path, type):
        raise ValueError("path must be the name of a file, and come first, but is the class " + path.__name__)
    path = a_path("path", path)
    given = [kinds] if isinstance(kinds, type) else several("kinds", kinds, type, "a class or several")
    max_bytes = whole_number("max_bytes", max_bytes, 1, MOST_STEPS)
    known = {kind.__name__: kind for kind in (*_own_classes(), *given)}
    with path.open("rb") as file:
        content = file.read(max_bytes + 1)
    try:
        arrays = _arrays(content, max_bytes)
        if arrays.get("structure", np.zeros(0)).shape != ():
            raise ValueError("it holds no agent")
        agent = _build(json.loads(str(arrays["structure"])), arrays, known)
        if not _is_named_tuple(agent):
            raise ValueError("it holds no agent")
        check(agent)
    except Exception as error:  # there is no end to what can be wrong with a damaged file
        raise ValueError(
            f"path must name a file that save() wrote, but {str(path)!r} cannot be loaded: {str(error) or repr(error)}"
        ) from None
    return agent


def _is_named_tuple(value: Any) -> bool:
    return isinstance(value, tuple) and hasattr(value, "_fields")


def _structure(value: Any, name: str, arrays: dict[str, Any]) -> Any:
    """Return a value as JSON, and put its arrays into `arrays`."""
    if isinstance(value, np.ndarray) and value.dtype.kind in "biuf":
        arrays[name] = value
        return {"array": name}
    if _is_named_tuple(value):
        parts = zip(value._fields, value, strict=True)
        fields = {key: _structure(part, f"{name}.{key}", arrays) for key, part in parts}
        return {"kind": type(value).__name__, "fields": fields}
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, bool | int | float | str):
        return {"value": value}
    raise ValueError(
        f"an agent that is saved must hold numbers, arrays and NamedTuples, but {name} is {in_short(value)}"
    )


def _arrays(content: bytes, max_bytes: int) -> dict[str, Any]:
    """Read the arrays of an `.npz` file by name, after a look at how large they will be."""
    too_large = f"it holds more than {max_bytes} bytes; to allow that, pass a larger max_bytes"
    if len(content) > max_bytes:
        raise ValueError(too_large)
    if not zipfile.is_zipfile(io.BytesIO(content)):
        raise ValueError("it is not in the .npz format")
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        entries = archive.infolist()
        if sum(entry.file_size for entry in entries) > max_bytes:
            raise ValueError(too_large)
        return {entry.filename.removesuffix(".npy"): _array(archive, entry) for entry in entries}


def _array(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> Any:
    """Read one array, whose header must agree with the size of its entry in the archive."""
    if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise ValueError(f"{entry.filename} is compressed in a way that save() does not use")
    with archive.open(entry) as file:
        if np.lib.format.read_magic(file) != (1, 0):
            raise ValueError(f"{entry.filename} is not an array that save() wrote")
        shape, is_fortran, dtype = np.lib.format.read_array_header_1_0(file)
        size = entry.file_size - file.tell()
        if dtype.kind not in "biufU" or math.prod(shape) * dtype.itemsize != size:
            raise ValueError(f"{entry.filename} is not an array that save() wrote")
        return np.ndarray(shape, dtype, bytearray(file.read()), order="F" if is_fortran else "C")


def _build(structure: Any, arrays: dict[str, Any], known: dict[str, type[Any]]) -> Any:
    """Return the value that `_structure` took apart."""
    match structure:
        case {"array": str(name)} if name in arrays:
            return arrays[name]
        case {"value": None | bool() | int() | float() | str() as value}:
            return value
        case {"kind": str(name), "fields": dict(parts)}:
            if name not in known:
                raise ValueError(f"kinds must hold the class {name}, which the file names and EduGym does not have")
            kind = known[name]
            fields = {key: _build(part, arrays, known) for key, part in parts.items()}
            unknown = sorted(fields.keys() - {*kind._fields})
            missing = sorted({*kind._fields} - fields.keys() - kind._field_defaults.keys())
            if unknown or missing:
                raise ValueError(f"{name} has other fields than the file: {', '.join(unknown + missing)}")
            return kind(**fields)
    raise ValueError("its structure is damaged")


def _own_classes() -> Iterator[type]:
    """Yield the NamedTuple classes of all agents and strategies of the package."""
    for module in pkgutil.iter_modules([str(Path(__file__).parent)], f"{__package__}."):
        yield from (kind for kind in vars(importlib.import_module(module.name)).values() if hasattr(kind, "_fields"))
