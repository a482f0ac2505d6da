"""How Numba makes machine code of a loop and of the functions that it reaches: its pipeline, with passes of ours."""

import importlib
from collections.abc import Callable
from typing import Any

from edugym.compiled.judging import after_typing
from edugym.compiled.passes import before_typing, own_before_typing

compiler: Any = importlib.import_module("numba.core.compiler")
machinery: Any = importlib.import_module("numba.core.compiler_machinery")
untyped_passes: Any = importlib.import_module("numba.core.untyped_passes")
typed_passes: Any = importlib.import_module("numba.core.typed_passes")


def _pass(name: str, work: Callable[[Any], bool], kind: str = "FunctionPass") -> Any:
    """A pass as Numba has them."""
    base = getattr(machinery, kind)
    members = {
        "_name": name,
        "__init__": lambda self: base.__init__(self),
        "run_pass": lambda self, state: work(state),
    }
    return machinery.register_pass(mutates_CFG=False, analysis_only=kind == "AnalysisPass")(
        type(name, (base,), members)
    )


class _Unlinked:
    """Numba's code generator for a part of a build, which goes into the whole and is never run by itself."""

    def __init__(self, codegen: Any) -> None:
        self._codegen = codegen

    def __getattr__(self, name: str) -> Any:
        return getattr(self._codegen, name)

    def _add_module(self, module: Any) -> None:
        """Nothing: only the whole is made machine code of."""


def share_function_passes(codegen: Any) -> None:
    """Optimise all functions by the same passes: new ones for each, as Numba takes them, cost 33 KB for ever.

    (llvmlite does not free all of it, and a build has a hundred functions.)
    """
    passes = codegen._function_pass_manager()
    codegen._function_pass_manager = lambda: passes


def _before_lowering(state: Any) -> bool:
    """Optimise the part, and make machine code of it, only within the whole.

    By itself each would cost time, and megabytes for ever. (Its functions are optimised one by one all the same.)
    """
    flags = state.flags
    flags.no_compile = flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
    codegen = state.targetctx.codegen()
    library = state.library = codegen.create_library(state.func_id.func_qualname)
    library._codegen = _Unlinked(codegen)
    library._optimize_final_module = lambda: None
    library._finalize_specific = lambda: None
    return False


def _after_lowering(state: Any) -> bool:
    lowered = state["cr"]
    entry: Any = [].append  # by which Numba knows the part, in place of its address: some builtin that is like no other
    state.targetctx.insert_user_function(entry, lowered.fndesc, [state.library])
    state["cr"] = lowered._replace(cfunc=entry)
    return False


BEFORE_LOWERING = _pass("edugym_before_lowering", _before_lowering, "AnalysisPass")
AFTER_LOWERING = _pass("edugym_after_lowering", _after_lowering, "AnalysisPass")
BEFORE = _pass("edugym_before_typing", before_typing)
OWN_BEFORE = _pass("edugym_before_typing_of_own", own_before_typing)
AFTER = _pass("edugym_after_typing", after_typing)


def _pipeline(*, part: bool = True, judged: bool = False) -> Any:
    """Numba's pipeline for a loop, or for a part of its build: a method or a helper."""

    def define_pipelines(self: Any) -> list[Any]:
        manager = compiler.DefaultPassBuilder.define_nopython_pipeline(self.state)
        manager.add_pass_after(BEFORE if judged else OWN_BEFORE, untyped_passes.InlineClosureLikes)
        if judged:
            manager.add_pass_after(AFTER, typed_passes.NopythonTypeInference)
        if part:
            manager.add_pass_after(BEFORE_LOWERING, typed_passes.AnnotateTypes)
            manager.add_pass_after(AFTER_LOWERING, typed_passes.NativeLowering)
        manager.finalize()
        return [manager]

    return type("Pipeline", (compiler.CompilerBase,), {"define_pipelines": define_pipelines})


Whole, Part, JudgedPart = _pipeline(part=False), _pipeline(), _pipeline(judged=True)
"""The pipelines for a loop, for the package's own functions that it reaches, and for those of others."""
