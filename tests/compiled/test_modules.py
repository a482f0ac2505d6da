"""Which modules code that is compiled may use, by what is said of those that it may not."""

import math
import os
import random
import sys
import time
from typing import Any

import numpy as np
import pytest

from edugym.compiled.subset import _of_name

SAID: dict[str, tuple[Any, str | None]] = {
    "math": (math, None),
    "np": (np, None),
    "one's own": (sys.modules[__name__], None),
    "random": (random, "it draws from random, which no seed of a run reaches: draw from rng"),
    "np.random": (np.random, "it draws from numpy.random, which no seed of a run reaches: draw from rng"),
    "np.linalg": (np.linalg, "it uses the module numpy.linalg"),
    "time": (time, "it uses the module time"),
    "os": (os, "it uses the module os"),
}


@pytest.mark.parametrize("name", SAID)
def test_modules(name: str) -> None:
    """Before anything is compiled."""
    value, said = SAID[name]
    assert _of_name(value, name) == said
