"""Numba, set up for this package: loaded when it is first needed, and taught about NamedTuples."""

import hashlib
import importlib
import importlib.util
import os
import threading
import warnings
from functools import cache
from types import FunctionType
from typing import Any

from edugym.compiled.namedtuples import skip_check_of_scipy, teach
from edugym.system.other_threads import call_interruptibly

_loading = threading.RLock()
_setup_error: list[str] = []  # empty until Numba is set up; then what is wrong with this version of it, or ""


class CompilationError(Exception):
    """Something in the loop cannot be compiled: `str(error)` says what and, if known, where."""


class NoCompiler(CompilationError):
    """Nothing can be compiled here: Numba is not installed, or was switched off."""


def may_compile() -> bool:
    """Whether there seems to be a compiler: Numba is not loaded for that, which takes half a second."""
    return importlib.util.find_spec("numba") is not None and os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0")


@cache
def numba_ready() -> Any:
    """Numba, imported when it is first needed, and taught about NamedTuples.

    Raises:
        NoCompiler: nothing can be compiled here.
    """
    return call_interruptibly(_load_numba)


def _load_numba() -> Any:
    with _loading:  # an abandoned thread may still be loading it
        try:
            numba = importlib.import_module("numba")
        except ImportError as error:
            raise NoCompiler("Numba is not installed") from error
        if numba.config.DISABLE_JIT:
            raise NoCompiler("Numba is switched off by NUMBA_DISABLE_JIT")
        if not _setup_error:
            try:
                skip_check_of_scipy()
                teach(numba, importlib.import_module("edugym.compiled.compiler_pipelines"))
                processor()
            except Exception as error:  # anything may be missing in another version of Numba
                _setup_error.append(f"{type(error).__name__}: {error}")
                message = f"this version of Numba ({numba.__version__}) is not known to EduGym"
                warnings.warn(f"{message}: everything runs interpreted ({_setup_error[0]})", stacklevel=2)
            else:
                _setup_error.append("")
        if _setup_error[0]:
            raise NoCompiler(f"this version of Numba is not known: {_setup_error[0]}")
        return numba


@cache
def processor() -> str:
    """The processor for which Numba writes machine code."""
    target: Any = importlib.import_module("numba.core.registry").cpu_target
    return hashlib.sha256(repr(target.target_context.codegen().magic_tuple()).encode()).hexdigest()[:8]


def refused_error() -> Any:
    """The class `Refused`, imported late since it needs Numba."""
    return importlib.import_module("edugym.compiled.untyped_checks").Refused


@cache
def replacements() -> frozenset[FunctionType]:
    """The functions that compiler passes put into code: checked ones in place of Python's own, and polling."""
    arithmetic: Any = importlib.import_module("edugym.compiled.arithmetic")
    polling: Any = importlib.import_module("edugym.compiled.interrupt_polling").count_iteration
    drawn: Any = importlib.import_module("edugym.compiled.draws").DRAWN
    tables = arithmetic.REPLACED, arithmetic.CALLED, arithmetic.EXTREMES, drawn
    return frozenset({polling, *(function for table in tables for function in table.values())})
