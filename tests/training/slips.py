"""The slips that students make, each with the sentence that answers it: a table for tests.

Every slip is a change of one or two lines of a walk or of an agent that are right. The tests run it in training, short
and long, off-policy and on-policy, repeated in one and in two threads, and in the environments that play an MDP. The
traceback must show the lines of the student and at most one of the package.
"""

import re
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import edugym
from edugym import repeat, train
from tests.compiled.cells import LEARNER, WALK, cell

PACKAGE = str(Path(edugym.__file__).parent)
ON_POLICY = LEARNER.replace("next_state, terminated)", "next_state, next_action, terminated)")


class Slip(NamedTuple):
    """A slip: what is replaced by what, and the words of the answer.

    Attributes:
        old: a text in the code that is right, found there once.
        new: what the student writes.
        says: a pattern for the whole sentence.
        line: the student's line at which the traceback ends; "" where what a method returns is wrong, or what it has.
        error: the class of the error.
    """

    old: str
    new: str
    says: str
    line: str = ""
    error: type[Exception] = ValueError


MOVE = "return max(0, state + 2 * action - 1)"
PAY = "return 1.0 if next_state == self.size else -0.25"
END = "return state == self.size"
SEE = "return state\n"
TRANSITION = "def transition(self, state, action, rng):"
LIMIT = "    def initial"

IN_MDP = {
    "transition without return": Slip(MOVE, MOVE[7:], r"transition of Walk must return the next state, but .* None"),
    "reward without return": Slip(
        PAY, "pass", r"reward of Walk must return a finite number, .* None for state 0, action"
    ),
    "a text for a reward": Slip(PAY, "return 'much'", "reward of Walk .* 'much'"),
    "NaN for a reward": Slip(PAY, "return float('nan')", "reward of Walk .* nan"),
    "a pair for a reward": Slip(PAY, "return -1.0, False", r"reward of Walk .* \(-1.0, False\)"),
    "terminal without return": Slip(END, "pass", "terminal of Walk must return True or False, but returned None"),
    "a text for an end": Slip(END, "return 'no'", "terminal of Walk .* 'no'"),
    "observation without return": Slip(SEE, "pass\n", r"observation of Walk must return an element of Discrete\(6\)"),
    "a float to see": Slip(SEE, "return float(state)\n", "observation of Walk .* 0.0 for state 0"),
    "beyond the space": Slip(SEE, "return state + 6\n", "observation of Walk .* returned 6 for state 0"),
    "below the space": Slip(SEE, "return state - 1\n", "observation of Walk .* returned -1 for state 0"),
    "a flag to see": Slip(SEE, "return state > 9\n", r"observation of Walk .* Discrete\(6\), but returned False"),
    "a list to see": Slip(SEE, "return [state]\n", r"observation of Walk .* returned \[0\] for state 0"),
    "initial without return": Slip(
        "return 0\n", "0\n", "initial of Walk must return the first state, but returned None"
    ),
    "rng forgotten": Slip(
        TRANSITION, TRANSITION.replace(", rng", ""), r"transition of Walk must take \(self, state, act"
    ),
    "self forgotten": Slip(
        TRANSITION, TRANSITION.replace("self, ", ""), r"transition .* but takes \(state, action, rng\)"
    ),
    "parameters in another order": Slip(
        TRANSITION, "def transition(self, action, state, rng):", r"transition .* but takes \(self, action, state, rng\)"
    ),
    "misspelt": Slip(
        TRANSITION, TRANSITION.replace("trans", "tans"), r"must have a method transition\(.* 'tansition' mi"
    ),
    "another name": Slip("def terminal", "def done", r"must have a method terminal\(self, state\); is 'done' misspelt"),
    "no action space": Slip("def action_space", "def actions", "Walk must have a property action_space"),
    "no property": Slip(
        "    @property\n    def action_space", "    def action_space", "action_space of Walk .* put @property above it"
    ),
    "actions from 1": Slip(
        "return spaces.Discrete(2)", "return spaces.Discrete(2, start=1)", "number the actions from 0"
    ),
    "a number for a space": Slip("return spaces.Discrete(2)", "return 2", "action_space of Walk .* but is 2"),
    "a typo in max_steps": Slip(
        LIMIT,
        f"    @property\n    def max_steps(self): return 4 * self.sise\n\n{LIMIT}",
        "sise",
        "self.sise",
        AttributeError,
    ),
    "a typo in a space": Slip("spaces.Discrete(2)", "space.Discrete(2)", "space", "space.Discrete(2)", NameError),
    "an attribute that a space needs": Slip(
        "spaces.Discrete(2)", "spaces.Discrete(self.n)", "'n'", "spaces.Discrete(self.n)", AttributeError
    ),
    "a half step limit": Slip(
        LIMIT, f"    max_steps = property(lambda self: 2.5)\n\n{LIMIT}", "max_steps must be a whole"
    ),
    "a typo": Slip(PAY, "return 1.0 if next_state == self.sise else 0.0", "sise", "self.sise", AttributeError),
    "an unknown name": Slip(MOVE, "return stat", "stat", "return stat", NameError),
    "a frozen field": Slip(
        MOVE,
        "self.size = 7; return state",
        r"transition of Walk assigns self.size, but the fields of a NamedTuple never change: .* self.size\[0\]",
        "self.size = 7",
        AttributeError,
    ),
    "a new attribute": Slip(
        MOVE, "self.n = 1; return 0", "transition of Walk assigns self.n, but", "self.n", AttributeError
    ),
    "numpy's randomness": Slip(
        MOVE,
        "return int(np.random.random() * 2)",
        "transition of Walk draws from random or np.random, .* draw from rng",
    ),
    "python's randomness": Slip(PAY, "import random; return random.random()", "reward of Walk draws from random or"),
    "no probabilities": Slip(MOVE, "return rng.choice(2, p=[0.5, 0.4])", "robabilities do not sum", "rng.choice"),
    "an error of one's own": Slip(PAY, "raise KeyError('x')", "x", "raise KeyError", KeyError),
    "division by zero": Slip(PAY, "return 1 / state", "division by zero", "1 / state", ZeroDivisionError),
}
ROOMS = (
    WALK.replace("return 0\n", "return np.zeros(1)\n")
    .replace(SEE, "return int(state[0])\n")
    .replace(MOVE, "return np.maximum(0, state + 2 * action - 1)")
    .replace(" == self.size", "[0] == self.size")
)
"""The walk with a state that is an array."""
IN_PLACE = {
    "transition": Slip(
        "return np.maximum(", "state[0] += 1; return np.maximum(", "transition of Walk must not change the"
    ),
    "reward": Slip("return 1.0 if", "next_state[0] = 2; return 1.0 if", "reward of Walk must not change the state"),
    "terminal": Slip("return state[0] ==", "state[0] += 1; return state[0] ==", "terminal of Walk must not change the"),
    "observation": Slip(
        "return int(", "state += 1; return int(", r"observation of Walk must not change .* from a copy"
    ),
}

ACT = "return best"
ACTS = "def act(self, state, rng):"
LEARNS = "def learn(self, state, action, reward, next_state,"
UPDATE = "self.Q[state, action] +="
FIRST = "value = 0.0"
IN_AGENT = {
    "act without return": Slip(
        ACT, "best", r"act of Learner must return an action, a whole .* None for state 0 \(is a"
    ),
    "a negative action": Slip(ACT, "return -1", "act of Learner .* from 0 to 1, but returned -1 for state"),
    "a float action": Slip(ACT, "return 1.0", "act of Learner .* but returned 1.0"),
    "a flag for an action": Slip(
        ACT, "return best == 1", "act of Learner .* from 0 to 1, but returned (Tru|Fals)e for"
    ),
    "a large action": Slip(ACT, "return 5", "act of Learner .* but returned 5"),
    "a text": Slip(ACT, "return 'left'", "act of Learner .* but returned 'left'"),
    "a row for an action": Slip(ACT, "return self.Q[state]", r"act of Learner .* but returned array\("),
    "a list of actions": Slip(ACT, "return [best]", r"act of Learner .* but returned \[\d\]"),
    "act misspelt": Slip(
        ACTS, "def akt(self, state, rng):", r"Learner must have a method act\(self, .* is 'akt' misspelt"
    ),
    "act by another name": Slip(ACTS, "def choose_action(self, state, rng):", "is 'choose_action' misspelt"),
    "act without rng": Slip(ACTS, "def act(self, state):", r"act of Learner must take \(self, state, rng\), but takes"),
    "act without self": Slip(ACTS, "def act(state, rng):", r"act of Learner must take .* but takes \(state, rng\)"),
    "act the wrong way round": Slip(
        ACTS, "def act(self, rng, state):", r"act of Learner .* takes \(self, rng, state\)"
    ),
    "act with more": Slip(ACTS, "def act(self, state, epsilon, rng):", r"act of Learner .* takes \(self, state, epsi"),
    "learn misspelt": Slip("def learn", "def lern", r"a method learn\(self, state, action, .*\); is 'lern' misspelt\?"),
    "learn by another name": Slip("def learn", "def update", r"must have a method learn\(.* is 'update' misspelt\?"),
    "learn with done": Slip(
        "terminated):", "terminated, done):", "learn of Learner has .* 'done': is 'terminated' meant"
    ),
    "learn misnames": Slip("reward, next", "rewrad, next", "learn of Learner has .* 'rewrad': is 'reward' meant"),
    "learn without self": Slip(
        "def learn(self, ", "def learn(", "learn of Learner must have self as its first parameter"
    ),
    "greedy misspelt": Slip(ACTS, f"def gredy(self, state, rng): return 0\n    {ACTS}", "greedy.*is 'gredy' misspelt"),
    "greedy without rng": Slip(
        ACTS, f"def greedy(self, state): return 0\n    {ACTS}", r"greedy of Learner must take \("
    ),
    "greedy without return": Slip(
        ACTS, f"def greedy(self, state, rng): pass\n    {ACTS}", "greedy of Learner must ret.* No"
    ),
    "greedy no method": Slip(ACTS, f"greedy = 1\n    {ACTS}", "greedy of Learner must be a method, but is 1"),
    "a generator": Slip(
        "rate: float = 0.5",
        "rate: object = (0.5 for _ in range(9))",
        "Learner holds a generator, which cannot be copied, but (evaluation acts by a copy|each run has a copy)",
    ),
    "a frozen field": Slip(
        FIRST,
        "self.rate *= 0.9; value = 0.0",
        r"learn of Learner assigns self.rate, but the fields of a NamedTuple never change: .* assign self.rate\[0\]",
        "self.rate *= 0.9",
        AttributeError,
    ),
    "a frozen table": Slip(
        FIRST,
        "self.Q += 0; value = 0.0",
        r"learn of Learner assigns self.Q, but .* never change: change the numbers in the array, as in self.Q\[:\] ",
        "self.Q += 0",
        AttributeError,
    ),
    "a method without self": Slip(
        FIRST,
        "self.late(state)\n\n    def late(state):\n        value = 0.0",
        r"takes 1 positional argument but 2 were given: the first parameter of a method is self: def late\(self, ",
        "self.late(state)",
        TypeError,
    ),
    "a new agent": Slip(
        FIRST, "return self._replace(rate=0.1)\n        value = 0.0", "learn of Learner returns a new Learn"
    ),
    "an unset variable": Slip(
        "value = 0.0 if terminated else", "valeu = 0.0 if terminated else", "value", UPDATE, NameError
    ),
    "NaN": Slip(
        FIRST, "reward = np.nan; value = 0.0", r"learn of Learner must leave numbers in Q, but Q\[0, .\] is nan"
    ),
    "numpy's randomness": Slip(
        "rng.random() < 0.1", "np.random.rand() < 0.1", "act of Learner draws from random or np."
    ),
    "a call of nothing": Slip(FIRST, "self.decay(); value = 0.0", "decay", "self.decay()", AttributeError),
    "another index": Slip(UPDATE, "self.Q[state, action, 0] +=", "too many indices", "action, 0] +=", IndexError),
}


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
START = "return self.place, {}"
IN_ENVIRONMENT = {
    "four values": Slip(
        STEP, "return self.place, -1.0, False, {}", r"step of Line must return \(observation, reward, term"
    ),
    "no return": Slip(STEP, "pass", "step of Line must return .* but returned None"),
    "no reward": Slip(STEP, "return self.place, None, False, False, {}", "step of Line .* reward, but returned None"),
    "no end": Slip(STEP, "return self.place, -1.0, None, False, {}", "step of Line .* terminated, but returned None"),
    "outside": Slip(STEP, "return -1, -1.0, False, False, {}", r"step of Line .* in Discrete\(6\), but returned -1"),
    "a float": Slip(STEP, "return 1.0, -1.0, False, False, {}", r"step of Line .* but returned 1.0"),
    "reset without info": Slip(START, "return self.place", r"reset of Line must return \(observation, info\), but ret"),
    "reset outside": Slip(START, "return 6, {}", "reset of Line must return an observation in Disc.* returned 6"),
    "a generator": Slip(
        "self.observation_space =",
        "self.rows = (k for k in range(6)); self.observation_space =",
        "Line holds a generator, which cannot be copied, but (evaluation plays a copy|each run has a copy)",
    ),
    "reset of the old kind": Slip(
        "def reset(self, *, seed=None, options=None):\n        super().reset(seed=seed)",
        "def reset(self):",
        r"reset of Line must take \(self, \*, seed=None, options=None\), but takes \(self\)",
    ),
    "step without action": Slip(
        "def step(self, action)", "def step(self)", r"step of Line must take \(self, action\), bu"
    ),
    "step misspelt": Slip("def step", "def stpe", r"Line must have a method step\(self, action\)"),
    "a flag to see": Slip(
        STEP, "return False, -1.0, False, False, {}", r"step of Line .* Discrete\(6\), but returned F"
    ),
    "no space": Slip("self.action_space =", "self.actions =", "Line must have a property action_space"),
    "a typo": Slip("+ 2 * action", "+ 2 * acton", "acton", "acton", NameError),
}


def changed(source: str, slip: Slip) -> str:
    """The code with the slip in it."""
    assert source.count(slip.old) == 1, slip
    return source.replace(slip.old, slip.new)


def task(source: str = WALK) -> Any:
    """A walk of five steps."""
    return cell(source)["Walk"](5)


def learner(source: str = LEARNER) -> Any:
    """An agent for it."""
    return cell(source)["Learner"](np.zeros((6, 2)))


WAYS: dict[str, Callable[[Any, Any], Any]] = {
    "short": lambda mdp, agent: train(mdp, agent, 30),
    "long": lambda mdp, agent: train(mdp, agent, 6_000, evaluate_every=3_000),
    "repeat": lambda mdp, agent: repeat(mdp, {"mine": agent}, 30, repetitions=2, jobs=1),
    "threads": lambda mdp, agent: repeat(mdp, {"mine": agent}, 30, repetitions=2, jobs=2),
}


def answered(slip: Slip, call: Callable[[], Any]) -> None:
    """The call ends with the sentence, in one line, and a traceback that is the student's."""
    with pytest.raises(slip.error) as caught:
        call()
    error = caught.value
    assert re.search(slip.says, str(error)), str(error)
    assert "\n" not in str(error)
    assert error.__suppress_context__ or error.__context__ is None
    assert error.__cause__ is None
    frames = traceback.extract_tb(error.__traceback__)
    ours = [frame for frame in frames if frame.filename.startswith(PACKAGE) or frame.filename == "<string>"]
    assert len(ours) <= 1, frames
    if slip.line:
        assert slip.line in (frames[-1].line or ""), frames
        assert frames[-1] not in ours
    else:
        assert not ours or ours == frames[-1:], frames
