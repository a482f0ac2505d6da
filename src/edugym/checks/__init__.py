"""Checks of what users write: parameters, MDPs and agents. Each mistake is answered with one sentence."""

import importlib
import warnings
from typing import Any


def __getattr__(name: str) -> Any:
    """Find the checks of parameters under their name of version 0.1, for one more version."""
    parameters = importlib.import_module(f"{__name__}.parameters")
    if name.startswith("_") or not hasattr(parameters, name):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    warnings.warn(f"{__name__}.{name} has moved: import edugym.checks.parameters", DeprecationWarning, stacklevel=2)
    return getattr(parameters, name)
