"""Students' code that is right, and how a slip in it is put there and answered, for tests."""

import re
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import edugym
from tests import messages
from tests.compiled.cells import LEARNER, WALK, cell

PACKAGE = str(Path(edugym.__file__).parent)

# Lines of the walk and of the learner that slips replace.
MOVE = "return max(0, state + 2 * action - 1)"
PAY = "return 1.0 if next_state == self.size else -0.25"
END = "return state == self.size"
SEE = "return state\n"
TRANSITION = "def transition(self, state, action, rng):"
LIMIT = "    def initial"
ACTS = "def act(self, state, rng):"
VALUE = "value = 0.0"

ENVIRONMENT = """
import gymnasium
class Line(gymnasium.Env):
    def __init__(self):
        self.observation_space = spaces.Discrete(6)
        self.action_space = spaces.Discrete(2)
    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.place = 0
        return self.place, {}
    def step(self, action):
        self.place = max(0, self.place + 2 * action - 1)
        return self.place, -1.0, self.place == 5, False, {}
"""
STEP = "return self.place, -1.0, self.place == 5, False, {}"


class Slip(NamedTuple):
    """A slip: what is replaced by what; words that the answer has; where the traceback ends, if in a student's line."""

    old: str
    new: str
    names: str
    line: str = ""
    error: type[Exception] = ValueError


def changed(source: str, old: str, new: str) -> str:
    """The code with a text replaced that stands there once."""
    assert source.count(old) == 1, old
    return source.replace(old, new)


def walk(source: str = WALK) -> Any:
    """A walk of five steps."""
    return cell(source)["Walk"](5)


def learner(source: str = LEARNER, table: Any = None) -> Any:
    """An agent for it."""
    return cell(source)["Learner"](np.zeros((6, 2)) if table is None else table)


LOOKING = """
class Looker(NamedTuple):
    tabular = False
    def act(self, state, rng): return 1
    def learn(self, state, action, reward, next_state, terminated): pass
"""


def looker(tabular: str = "False") -> Any:
    """An agent that is shown numbers, and learns nothing."""
    return cell(LOOKING.replace("False", tabular))["Looker"]()


def named(names: str, call: Callable[[], Any], error: type[Exception] = ValueError) -> Exception:
    """The error with which a call ends: its message has all the names, whole words, in one line."""
    with pytest.raises(error) as caught:
        call()
    for name in names.split():
        pattern = messages.named(name) if name.isidentifier() else re.escape(name)
        assert re.search(pattern, str(caught.value)), str(caught.value)
    assert "\n" not in str(caught.value)
    return caught.value


def answered(names: str, call: Callable[[], Any], line: str = "", error: type[Exception] = ValueError) -> Exception:
    """The same, with a traceback that shows the student's lines and at most one of the package."""
    raised = named(names, call, error)
    assert raised.__suppress_context__ or raised.__context__ is None
    assert raised.__cause__ is None
    frames = traceback.extract_tb(raised.__traceback__)
    ours = [frame for frame in frames if frame.filename.startswith(PACKAGE) or frame.filename == "<string>"]
    assert len(ours) <= 1, frames
    if line:
        assert line in (frames[-1].line or ""), frames
        assert frames[-1] not in ours
    else:
        assert not ours or ours == frames[-1:], frames
    return raised
