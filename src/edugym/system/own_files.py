"""Run a Python file of the user's own as a module, and say in one sentence what is wrong with it."""

import importlib.util
import sys
import traceback
from pathlib import Path
from types import ModuleType


def run_file(path: Path, *, importable: bool = False) -> ModuleType:
    """Run a Python file as a module. What it imports may lie beside it.

    Args:
        path: the file.
        importable: whether other modules find it under its name afterwards, as pickle must to read its classes. A
            module that has this name already keeps it.

    Raises:
        ValueError: the file does not end in .py, or it fails; the message names the line.
        OSError: the file cannot be read.
    """
    path.open("rb").close()  # an error that names the path
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None:
        raise ValueError(f"path must be a Python file, which ends in .py, but is {str(path)!r}")
    module = importlib.util.module_from_spec(spec)
    known = sys.modules.get(path.stem)
    if importable and (known is None or getattr(known, "__file__", None) == spec.origin):
        sys.modules[path.stem] = module
    sys.path.insert(0, str(path.resolve().parent))
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        if sys.modules.get(path.stem) is module:
            del sys.modules[path.stem]
        raise ValueError(
            f"{path.name} must run without an error, but {_line(error, str(spec.origin))}raises"
            f" {type(error).__name__}: {error.msg if isinstance(error, SyntaxError) else error}"
        ) from error
    finally:
        sys.path.pop(0)
    return module


def _line(error: Exception, file: str) -> str:
    """The line of the file at which it fails, for a message."""
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == file]
    if not lines and isinstance(error, SyntaxError):
        lines = [error.lineno]
    return f"line {lines[-1]} " if lines else ""
