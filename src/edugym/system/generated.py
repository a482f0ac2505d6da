"""NamedTuple classes that are generated for a shape or a signature, since machine code has to know it beforehand."""

import hashlib
import linecache
import sys
from types import ModuleType
from typing import Any, NamedTuple


def generated_class(name: str, lines: list[str], kinds: dict[str, type]) -> Any:
    """The NamedTuple class with these lines; the same lines and classes give the same class, in a module of its own.

    The names of both are the same in every process, so that the disk cache of machine code finds the class again. They
    differ where the texts do, since Numba's fast path tells classes apart by their names.

    Args:
        name: what its name begins with.
        lines: the body of the class, indented by four.
        kinds: the classes that the body names.
    """
    known = [(kind.__module__, kind.__qualname__) for kind in kinds.values()]
    full_name = f"{name}_{hashlib.sha256(repr((lines, known)).encode()).hexdigest()[:16]}"
    module = sys.modules.get(f"edugym.compiled.{full_name}")
    if module is None or module.__dict__["KINDS"] != kinds:
        module = ModuleType(f"edugym.compiled.{full_name}")
        module.__dict__.update(kinds, NamedTuple=NamedTuple, KINDS=kinds)
        source = "\n".join([f"class {full_name}(NamedTuple):", *lines, ""])
        file = f"<{full_name}>"
        linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)  # for who reads its source
        exec(compile(source, file, "exec"), module.__dict__)
        module.__dict__[full_name].__reduce__ = lambda value: (_value, (name, lines, kinds, tuple(value)))
        sys.modules[module.__name__] = module
    return module.__dict__[full_name]


def _value(name: str, lines: list[str], kinds: dict[str, type], fields: tuple[Any, ...]) -> Any:
    """A value of such a class: how another process unpickles it, which has not generated the class yet."""
    return generated_class(name, lines, kinds)(*fields)
