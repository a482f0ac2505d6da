"""Numba's compiler pipelines for a loop and for the functions that it reaches, with added passes."""

import threading
import warnings
from collections.abc import Callable
from contextlib import AbstractContextManager
from types import FunctionType
from typing import Any

from numba.core import compiler, errors, event, typed_passes, untyped_passes
from numba.core import compiler_machinery as machinery

from edugym.compiled.facts import Incomplete, facts, require_complete
from edugym.compiled.finite import IMPLEMENTED
from edugym.compiled.mixed_numbers import follow_only
from edugym.compiled.namedtuples import building
from edugym.compiled.typed_checks import check_typed
from edugym.compiled.untyped_checks import check_untyped, finish_own
from edugym.system.interrupts import Stopped


def _pass(name: str, work: Callable[[Any], bool], kind: str = "FunctionPass") -> Any:
    """A compiler pass, as Numba has them, that calls `work(state)`."""
    base = getattr(machinery, kind)
    members = {
        "_name": name,
        "__init__": lambda self: base.__init__(self),
        "run_pass": lambda self, state: work(state),
    }
    return machinery.register_pass(mutates_CFG=False, analysis_only=kind == "AnalysisPass")(
        type(name, (base,), members)
    )


class _LinkedLater:
    """Numba's code generator for a part of a build: the part is linked into the whole and never run by itself."""

    def __init__(self, codegen: Any) -> None:
        self._codegen = codegen

    def __getattr__(self, name: str) -> Any:
        return getattr(self._codegen, name)

    def _add_module(self, module: Any) -> None:
        """Does nothing: machine code is generated for the whole build, not for its parts."""


def share_function_passes(codegen: Any) -> None:
    """Optimises all functions with one pass manager of LLVM's.

    Numba makes a new one for each function. That costs 33 KB which llvmlite never frees, and a build has a hundred
    functions.
    """
    passes = codegen._function_pass_manager()
    codegen._function_pass_manager = lambda: passes


def _before_lowering(state: Any) -> bool:
    """Skips optimising and linking for a part: both happen for the whole, and would cost time and memory twice."""
    flags = state.flags
    flags.no_compile = flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
    codegen = state.targetctx.codegen()
    library = state.library = codegen.create_library(state.func_id.func_qualname)
    library._codegen = _LinkedLater(codegen)
    library._optimize_final_module = lambda: None
    library._finalize_specific = lambda: None
    return False


def _after_lowering(state: Any) -> bool:
    """Registers the part under a key of its own, since it has no address by which Numba could know it."""
    lowered = state["cr"]
    entry: Any = [].append  # a builtin function that equals no other
    state.targetctx.insert_user_function(entry, lowered.fndesc, [state.library])
    state["cr"] = lowered._replace(cfunc=entry)
    return False


BEFORE_LOWERING = _pass("edugym_before_lowering", _before_lowering, "AnalysisPass")
AFTER_LOWERING = _pass("edugym_after_lowering", _after_lowering, "AnalysisPass")
CHECK_UNTYPED = _pass("edugym_check_untyped", check_untyped)
FINISH_OWN = _pass("edugym_finish_own", finish_own)
CHECK_TYPED = _pass("edugym_check_typed", check_typed)
FOLLOW_MIXED = _pass("edugym_follow_mixed", follow_only)
REQUIRE_COMPLETE = _pass("edugym_require_complete", require_complete)


def _pipeline(*, part: bool = True, checked: bool = False) -> Any:
    """Numba's pipeline for a loop, or for a part of its build: a method or a helper."""

    def define_pipelines(self: Any) -> list[Any]:
        manager = compiler.DefaultPassBuilder.define_nopython_pipeline(self.state)
        manager.add_pass_after(CHECK_UNTYPED if checked else FINISH_OWN, untyped_passes.InlineClosureLikes)
        if not part:
            manager.add_pass_after(REQUIRE_COMPLETE, typed_passes.NopythonTypeInference)
        manager.add_pass_after(CHECK_TYPED if checked else FOLLOW_MIXED, typed_passes.NopythonTypeInference)
        if part:
            manager.add_pass_after(BEFORE_LOWERING, typed_passes.AnnotateTypes)
            manager.add_pass_after(AFTER_LOWERING, typed_passes.NativeLowering)
        manager.finalize()
        return [manager]

    return type("Pipeline", (compiler.CompilerBase,), {"define_pipelines": define_pipelines})


Loop, Part, CheckedPart = _pipeline(part=False), _pipeline(), _pipeline(checked=True)
"""The pipelines for a loop, for the package's own functions that it reaches, and for functions of students."""


class _StopsAtNextPass(event.Listener):  # type: ignore[misc]
    """Stops the build of this thread where Numba begins its next pass."""

    def __init__(self, late: threading.Event) -> None:
        self._late, self._thread = late, threading.get_ident()

    def on_start(self, event: Any) -> None:
        if self._late.is_set() and threading.get_ident() == self._thread:
            raise Stopped

    def on_end(self, event: Any) -> None:
        """A pass has ended."""


def stopping_when(late: threading.Event) -> AbstractContextManager[Any]:
    """Raises `Stopped` in a build of this block, between two passes, once the event is set.

    Raised anywhere else, it could leave llvmlite with an object that LLVM has already freed, and the process would
    crash when that is collected.
    """
    listener: AbstractContextManager[Any] = event.install_listener("numba:run_pass", _StopsAtNextPass(late))
    return listener


def compile_until_known(
    made: Any, signature: tuple[Any, ...], options: dict[str, bool], functions: set[FunctionType], foreign: bool
) -> None:
    """Compiles a loop, again and again until all is known of the numbers in it (see `mixed_numbers`).

    Args:
        made: Numba's dispatcher of the loop.
        signature: the types of its arguments.
        options: Numba's.
        functions: those that it may reach.
        foreign: whether any of its code is a student's.
    """
    facts.clear()
    facts.is_foreign, complete = foreign, False
    while not complete:
        with building(options, functions - IMPLEMENTED), warnings.catch_warnings():
            warnings.simplefilter("ignore", errors.NumbaWarning)
            try:
                made.compile(signature)
                complete = True
            except Incomplete:
                pass
