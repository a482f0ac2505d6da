"""The traceback of an error in a student's code: it ends at the student's line, and shows none of our frames."""

import dis
import inspect
import re
from importlib.util import find_spec
from pathlib import Path
from types import FunctionType, TracebackType

import numpy as np

from edugym.system.packages import OURS

UNSHOWN = OURS | {"contextlib", "gymnasium", "joblib", "numpy"}
"""Packages whose frames are no help in finding a mistake."""


def end_at_students_line(error: Exception) -> None:
    """Let the traceback of an error, which is raised again, end at the student's line, with none of our frames.

    An error about a frozen field, or a method without self, says what to do instead.
    """
    frames, last = [], error.__traceback__
    while last is not None:
        if last.tb_frame.f_globals.get("__name__", "").partition(".")[0] not in UNSHOWN:
            frames.append(last)
        last = last.tb_next
    traceback: TracebackType | None = None
    for frame in reversed(frames):
        traceback = TracebackType(traceback, frame.tb_frame, frame.tb_lasti, frame.tb_lineno)
    if frames and isinstance(error, AttributeError):
        _explain_frozen_field(error, frames[-1])
    if frames and isinstance(error, TypeError):
        _explain_missing_self(error, frames[-1])
    error.__traceback__ = traceback
    _say_where_in_another_process(error)


def _say_where_in_another_process(error: Exception) -> None:
    """If the error comes from a process of joblib, note the student's line instead of the traceback of all frames."""
    cause = error.__cause__
    if type(cause).__name__ == "_RemoteTraceback":
        error.__cause__ = None
        frames = re.split(r'^  File (?=")', str(cause), flags=re.MULTILINE)[1:]
        students = [frame for frame in frames if not _is_unshown(frame.split('"')[1])]
        if students:
            place, *code = students[-1].splitlines()[:2]
            error.add_note("\n".join([f"In another process: {place}", *code]))


def _is_unshown(file: str) -> bool:
    """Whether a file belongs to one of the packages whose frames are not shown."""
    found = [spec.origin for name in UNSHOWN if (spec := find_spec(name)) and spec.origin]
    return any(
        Path(file).is_relative_to(Path(one).parent) if one.endswith("__init__.py") else file == one for one in found
    )


def _explain_frozen_field(error: AttributeError, last: TracebackType) -> None:
    """Say how to keep what changes, where the line assigns an attribute of a NamedTuple."""
    frame = last.tb_frame
    owner = frame.f_locals.get("self")
    assigned = [one.argval for one in dis.get_instructions(frame.f_code) if one.offset == last.tb_lasti]
    fails = [one.opname for one in dis.get_instructions(frame.f_code) if one.offset == last.tb_lasti]
    if fails != ["STORE_ATTR"] or not isinstance(owner, tuple):
        return
    name = assigned[0]
    value = getattr(owner, name, None)
    remedy = f"keep what changes in a field that is an array, {name} = np.array([...]), and assign self.{name}[0]"
    if isinstance(value, np.ndarray):
        inside = f"self.{name}[:]" if value.ndim else f"self.{name}[...]"
        remedy = f"change the numbers in the array, as in {inside} += 1"
    error.args = (
        f"{frame.f_code.co_name} of {type(owner).__name__} assigns self.{name}, but the fields of a NamedTuple never"
        f" change: {remedy}",
    )


def _explain_missing_self(error: TypeError, last: TracebackType) -> None:
    """Say that the first parameter of a method is self, where a method of the student's has been called without one."""
    found = re.search(r"(\w+)\.(\w+)\(\) takes (\d+) positional arguments? but (\d+) (?:was|were) given$", str(error))
    if not found or int(found[4]) != int(found[3]) + 1:
        return
    owner, name = found[1], found[2]
    scope = last.tb_frame.f_globals | last.tb_frame.f_locals
    kinds = [value if isinstance(value, type) else type(value) for value in (scope.get(owner), scope.get("self"))]
    for kind in (base for one in kinds for base in one.__mro__ if base.__name__ == owner):
        method = vars(kind).get(name)
        function = method.fget if isinstance(method, property) else method
        takes = inspect.signature(function).parameters if isinstance(function, FunctionType) else {"self": None}
        if "self" not in takes:
            says = f"the first parameter of a method is self: def {name}({', '.join(['self', *map(str, takes)])})"
            error.args = (f"{error}: {says}",)
            return
