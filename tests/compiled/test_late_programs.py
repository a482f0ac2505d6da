"""What machine code may assume holds for lines that were never reached before: as Python does it, or refused."""

import traceback
from typing import Any

import numpy as np
import pytest

from edugym import QLearning, train
from edugym.compiled import compiler
from edugym.compiled.numba_setup import CompilationError
from tests.compiled.cells import WALK, cell
from tests.compiled.late_programs import both_ways, method_both_ways, method_program, task_program
from tests.compiled.oracle import loop
from tests.compiled.programs import program

FIELDS = "Q: np.ndarray\n    N: np.ndarray\n    n: np.ndarray"
VALUES = "np.zeros((9, 2)), np.arange(4), np.zeros(1, np.int64)"
BEFORE = """from numba import njit
G = np.zeros(2)
class C(enum.Enum):
    R = 1
    G = 2
class I(enum.IntEnum):
    B = 2
    M = -1
class P(NamedTuple):
    a: np.ndarray
p, pair, large, long = P(np.zeros(2)), (np.zeros(2), 1), np.zeros(50_000), tuple(range(500))
def put(array): array[0] += 1
def make(table):
    def write(): table[0] += 1
    return write
write, lib = make(np.zeros(1)), np
def fill(row): row[0] = 1
def grow(row, v): row += [v]
@njit(fastmath=True)
def fast(row): return row[0] * 0.1 + row[1] * 0.1
def apply(f, x): return f(x)
def mixed(x): return 1 if x > 2 else 0.5 * x
class W(NamedTuple):
    w: float
    def minus(self): return -self.w
"""
MORE = """M = (np.zeros(2), 1)
A, m, kind = np.arange(4.0), np.int64(3), C.G
def bump(self, memory=(0.5, 1)): self.M[0][0] += memory[0]
def remember(self, memory=(np.zeros(1),)): memory[0][0] += 1"""


def late(line: str, first: str = "x = 0.5", end: str = "x") -> str:
    """A method whose line is reached after 400 of 1 500 calls."""
    inside = line.replace("\n", "\n    ")
    begin = f"self.n[0] += 1\nn = int(self.n[0])\nk = n // 100\n{first}"
    body = f"{begin}\nif n > 400:\n    {inside}\nself.Q[n % 9, 0] = x\nreturn {end}"
    return program(body, FIELDS, VALUES, BEFORE, "0.5", MORE)


KEPT = {
    "list of reals": late("row[1] = 0.3 * k", "x = 0.5\nrow = [0.0, 1.0]", "max(row)"),
    "list that begins with a whole number": late("row[1] = 0.3 * k", "x = 0.5\nrow = [0, 1.5]", "0.5 * max(row)"),
    "best so far, from 0": late("for j in range(2): x = max(x, self.Q[j, 0] + 0.1)", "x = 0"),
    "clamp": late("x = max(0, min(1, x + 0.3 * k - 1.2))"),
    "one or a half": late("x = mixed(0.5 * k)"),
    "sum of a list": late("x = sum([0.1 * k, 2]) - sum([k, 1])"),
    "power": late("x = pow(2, 3 + k % 3) + 3 ** (k % 5) + pow(0.5, k)"),
    "squares of whole numbers": late("x = float((self.N ** 2).sum())"),
    "parts of lists": late(
        "r = [k, 1, 2]\nr[1:] = [3] * k\nr[:1] = r[::-1]\nr[:1] = sorted(r)\nr += r\nx = 0.5 * sum(r)"
    ),
    "what is only read": late("x = G[0] + p.a[1] + pair[0][k % 2] + self.M[0][1]"),
    "what a class has": late("x = self.A[k % 4] + self.m + (1 if self.kind == C.G else 2)"),
    "large whole numbers rounded": late(
        "x = float((round(2 ** 60 + k) + math.floor(2 ** 59 + k) + int(2 ** 60 - k)) % 7)"
    ),
    "numbers with a step": late(
        "r = np.arange(1, 2, 0.1)\nx = r[2] + r[3] + np.arange(5, step=0.3)[k % 3] - np.arange(k)[-1]\n"
        "r = np.arange(0.4, 9)\nx += r[3] + r[7] + np.arange(1.1, 9, 3)[2] + np.arange(0.9, 5, 1, dtype=float)[k % 4]"
    ),
    "median of large whole numbers": late("x = np.median(np.array([2 ** 62, 2 ** 62 + k]))"),
    "division of whole numbers": late("x = (-7 * k) // 3 + (-7 * k) % 3 + divmod(k, 4)[0] + abs(3 - k) + -k"),
}
"""Programs that are to compile, and to come to the same."""
REPEATED = {
    "whole to a negative power": late("x = pow(2, 5 - k)"),
    "sum beyond 64 bits": late("x = float(sum([2 ** 61 + k] * 4))"),
    "the least whole number": late("x = abs(-2**62 - 2**62 + 0 * k) + 0.0"),
    "minus the least": late("x = -(-2**62 - 2**62 + 0 * k) + 0.0"),
    "the least by -1": late("x = (-2**62 - 2**62 + 0 * k) // (3 - 4) + 0.0"),
    "whole numbers beyond 2^53 that may be real": late("k = 3 ** 35 + k if k > 5 else k * 0.5\nk = k * 3\nx = k % 7"),
    "the same NaN": late("y = math.nan if k > 7 else 1.0\nx = 1.0 if y in [y, 0.7] else 2.0"),
    "minus 0 that may be whole": late("x = 0 if k % 2 else 0.5\nx = -x"),
    "minus 0 that may be whole, by a method": late("x = W(0 if k % 2 else 0.5).minus()"),
    "minus 0 that may be whole, in joined lists": late("x = -([0.5, 0 * k] + [1.5])[1]"),
}
"""Programs in which machine code stops, and the interpreter goes on."""
MAYBE = "best = None\nfor j in range(3):\n    if best is None or j > 0: best = "
SAME_NAN = "y, r = math.nan if k > 7 else 1.0, [2.0, 0.5]\na = (y, 1)\n"
REPEATED |= {
    name: late(line)
    for name, line in {
        "what may be None, beyond 64 bits": f"{MAYBE}2 ** 61 + k\nx = float(best * 4 % 7)",
        "what may be None, in place": f"{MAYBE}2 ** 62\nbest += 2 ** 62\nx = float(best % 5)",
        "what may be None, to a power": f"{MAYBE}2\nx = best ** -k",
        "what may be None, against a real number": f"{MAYBE}2 ** 53 + 1\nx = 1.0 if best == 2.0 ** 53 else 2.0",
        "a flag and the largest whole number": "x = float(((n > 5) + 9223372036854775807) % 7)",
        "a flag shifted": "x = float(((n > 5) << (k + 60)) % 7)",
        "an enum of whole numbers": "x = float((I.B << (k + 60)) % 7)",
        "an enum to a negative power": "x = 2 ** I.M + k % 2",
        "the same NaN in two tuples": f"{SAME_NAN}x = 1.0 if a == a else 2.0",
        "the same NaN in an order": f"{SAME_NAN}x = 1.0 if a < (y, 2) else 2.0",
        "the same NaN in a list that is compared": f"{SAME_NAN}r[0] = y\nx = 1.0 if r == r else 2.0",
        "the same NaN counted": f"{SAME_NAN}r[0] = y\nx = float(r.count(y))",
        "a tuple in a tuple": f"{SAME_NAN}x = 1.0 if a in (a, (2.0, 1)) else 2.0",
        "large whole numbers in a tuple": "x = 1.0 if (2 ** 53 + 1, 2) == (2.0 ** 53, 2) else 2.0",
        "a large whole number among real ones": "x = 1.0 if 2 ** 53 + 1 in (2.0 ** 53, 2.5) else 2.0",
        "a real number among large whole ones": "x = 1.0 if 2.0 ** 53 in [2 ** 53 + 1, 2] else 2.0",
        "NaN sorted": f"{SAME_NAN}r[0] = y\nr.sort()\nx = float(r[0] == r[0]) + r[1]",
        "zeros sorted": "r = sorted([0.0 if j % 3 else -0.0 for j in range(20)])\nx = math.copysign(1.0, r[3])",
        "a sum of what may be whole": "x = sum([2 ** 53 if k > 7 else 0.5, 1, 1]) % 7",
        "2^53 that may be whole, and one": "y = 2 ** 53 if k > 7 else 0.5\nx = (y + 1) % 7",
        "a product rounded to 2^53": "y = 3002399751580331 if k > 7 else 0.5\nx = (y * 3) % 7",
        "large whole numbers that extend a list": "r = [0.5]\nr.extend([2 ** 53 + 1, k])\nx = r[1] % 7",
        "whole numbers of a range in a list": "r = [0.5]\nr.extend(range(2 ** 53 + 1, 2 ** 53 + 2))\nx = r[1] % 7",
        "large whole numbers added to a list": "r = [0.5]\nr += [2 ** 53 + 1]\nx = ([0.5] + r)[2] % 7",
        "2^53 and one in a list with two names": "r = [0.5]\nq = r\nr += [k, 1]\nx = (q[2] + 2 ** 53) % 7",
        "the same NaN found": f"{SAME_NAN}r[0] = y\nx = float(r.index(y))",
        "the same NaN removed": f"{SAME_NAN}r[0] = y\nr.remove(y)\nx = r[0]",
        "large whole numbers removed": "r = [2.0 ** 53, 0.5]\nx = float(r.count(2 ** 53 + 1))",
        "the least in an array by -1": "self.N[0] = -2 ** 62 - 2 ** 62\nx = float((self.N // (k - k - 1))[0] % 7)",
        "the least in place by -1": "self.N[0] = -2 ** 62 - 2 ** 62\nself.N[:] //= -1\nx = float(self.N[0] % 7)",
        "the least by an array of -1": "y = -2 ** 62 - 2 ** 62 + 0 * k\nx = float((y // (0 * self.N - 1))[0] % 7)",
        "zeros in an array sorted": "r = np.sort(np.array([0.0, -0.0, 0.0, -0.0]))\nx = math.copysign(1.0, r[1])",
    }.items()
}
REFUSED = {
    "list of whole numbers": (
        late("row[1] = self.Q[0, 0]", "x = 0.5\nrow = [0, 0]", "max(row)"),
        "puts a real number in a list",
    ),
    "product of a list": (late("row[1] = 0.3", "x = 0.5\nrow = [0] * 3", "max(row)"), "puts a real number in a list"),
    "list in a helper": (late("fill(row)", "row = [0.5, 1.0]\nx = 0.5", "max(row)"), "whole number in a list"),
    "array of what may be whole": (
        late("x = np.array([y, y])[0] // 2", "x, y = 0.5, 0.5\nif k > 7: y = 2"),
        "to a function",
    ),
    "array in a class": (late("self.M[0][1] += 1"), "writes to an array"),
    "array alone in a class": (late("self.A[1] += 1"), "writes to an array"),
    "largest of one number": (late("x = max(x)"), "it calls max of one number"),
    "flag as a bound of a slice": (late("x = self.Q[self.N[0] < 1:, 0][0]"), "a whole one belongs: use int()"),
    "flag as a bound of a range": (
        late("for j in range(0, 3, self.N[1] > 0): x += j"),
        "a whole one belongs: use int()",
    ),
    "flag rounded": (late("x = round(self.N[1] > 0) + 0.5"), "True and False as if they were numbers"),
    "keyword that exp does not take": (late("x = math.exp(x=1.0)"), "it calls exp with other arguments than it takes"),
    "nothing for len": (late("x = len() + 0.5"), "it calls len with other arguments than it takes"),
    "name that stands for nothing": (late("x = alpa"), "there is no alpa"),
    "array alone in a class, all of it": (late("w = self.A\nw[:] *= 0.5"), "changes an array in place"),
    "two values for append": (late("row = [0.5]\nrow.append(1, 2)"), "cannot compile this line"),
    "array in a class, by a method": (late("self.bump()"), "writes to an array"),
    "array of a class, by another name": (late("part = self.M[0]\npart[0] += 1"), "writes to an array"),
    "array in a default": (late("self.remember()"), "a default of remember is an array"),
    "global array": (late("G[0] += 1"), "writes to an array"),
    "global array in place": (late("G[:] *= 2"), "writes to an array"),
    "global array, all of it": (late("g = G\ng += 1"), "writes to an array"),
    "global array filled": (late("G.fill(2.0)"), "writes to an array"),
    "global array shuffled": (late("rng.shuffle(G)"), "writes to an array"),
    "global array in a helper": (late("put(G)"), "writes to an array"),
    "part of a global array in a helper": (late("put(pair[0][1:])"), "writes to an array"),
    "array of a global value": (late("p.a[0] = 2.0"), "writes to an array"),
    "array of a closure": (late("write()"), "writes to an array"),
    "whole numbers to a power": (late("x = (self.N ** (6 - k)).sum() + 0.5"), "to a power that may be negative"),
    "array of a flag and a number": (late("x = [k, True][1] + 0.5"), "mixes True or False"),
    "draws by another name": (late("x = lib.random.random()"), "np.random"),
    "new generator": (late("x = np.random.default_rng(k).random()"), "np.random"),
    "large array": (late("x = large[k]"), "is an array of 0.4 MB"),
    "long tuple": (late("x = long[k] + 0.5"), "is a tuple of 500 numbers"),
    "two types of tuples": (late("y = (k, 0.5)", "x, y = 0.5, (0.5, 0.5)", "y[0]"), "tuples with whole and with real"),
    "mean of whole numbers": (late("x = self.N.mean()"), "the mean of whole numbers"),
    "flags to a power": (late("x = float(((self.N > 0) ** 2 * 100 + 100)[2])"), "True and False as if they were"),
    "part of an array flattened": (late("part = self.Q[:1, :1].ravel()\npart[0] = 9.0"), "it calls ravel of a part"),
    "functions handed on": (late("x = float(apply(abs, -2**62 - 2**62 + 0 * k) % 7)"), "hands on the function abs"),
    "another function handed on": (late("x = float(apply(round, 1e19 * k) % 7)"), "hands on the function round"),
    "class handed on": (late("x = float(apply(int, 1e19 * k) % 7)"), "hands on the function int"),
    "functions in a tuple": (late("x = float((abs, 1)[0](-2**62 - 2**62 + 0 * k) % 7)"), "hands on the function abs"),
    "helper with fastmath": (late("x = fast(self.Q[0])"), "fast has fastmath"),
    "array for the result": (late("np.add(self.Q[:, 0], 1.0, self.Q[::-1, 0])"), "an array for the result"),
    "array for the result, by name": (late("np.add(self.Q, 1.0, out=self.Q)"), "an array for the result"),
    "array for the product": (late("np.dot(self.Q[:2], self.Q[0], self.Q[1])"), "an array for the result"),
    "global array for the product": (late("np.dot(self.Q[:2], self.Q[0], G)"), "an array for the result"),
    "array for the outer product": (late("np.outer(G, G, self.Q[:2])"), "an array for the result"),
    "whole numbers from real ones": (late("x = np.arange(0.5, 9, 1.5, dtype=int)[2] + 0.5"), "Numba has no np.arange"),
    "short numbers in a row": (late("self.Q[:2, 0] = np.arange(0.4, 2, dtype=np.float32)"), "Numba has no np.arange"),
    "bytes full of 200": (late("self.N[:2] = np.full(2, 200, np.int8)"), "may not fit in an array of int8"),
    "list in a helper, in place": (late("r = [0.5]\ngrow(r, k)\nx = r[1]"), "whole number in a list"),
    "list of whole numbers, and real ones added": (
        late("r = [1]\nr += [2.5]\nx = r[1] + 0.5"),
        "puts a real number in a list",
    ),
    "number in a list of flags": (late("r = [True, False]\nr[0] = 2\nx = sum(r) + 0.5"), "mixes True or False"),
    "lists of flags and of numbers": (late("r = [True] + [2]\nx = sum(r) + 0.5"), "mixes True or False"),
    "list in a part of itself": (late("r = [1.0, x]\nr[1:] = r\nx = r[2]"), "it puts a list in a part of a list"),
    "bytes of large numbers": (late("self.N[:2] = np.array([300, k], np.int8)"), "may not fit in an array of int8"),
    "functions of flags": (late("self.Q[:4, 0] = np.exp(self.N > 1)"), "it gives True and False where numbers"),
    "sorted by a key": (late("x = 1.0 * sorted(range(40), key=mixed)[3]"), "it sorts by a key"),
    "list sorted by a key": (late("r = [0.5] * 40\nr.sort(key=mixed)"), "it sorts by a key"),
    "parts of what may be whole": (late("y = 7 if k > 7 else 0.5\nx = divmod(y, 3)[0]"), "it divides a number that"),
    "draw handed on": (late("x = apply(rng.exponential, 700.0 - n)"), "hands on the method exponential"),
}
"""Programs that are refused, and a word of the sentence that says why."""


@pytest.mark.parametrize("part", [0, *(pytest.param(part, marks=pytest.mark.slow) for part in range(1, 12))])
def test_late_lines(part: int) -> None:
    """All come to the same bits, or are refused with a sentence that names the line."""
    for name, source in [*{**KEPT, **REPEATED}.items()][part::12]:
        same, said, seen = method_both_ways(source)
        assert same, (name, seen)
        stops = any(word in said for word in ("stops where Python goes on", "more than 64 bits"))
        assert bool(said) == stops == (name in REPEATED), (name, said)
    for name, (source, word) in [*REFUSED.items()][part::12]:
        same, said, seen = method_both_ways(source)
        assert same or "random" in source, (name, seen)  # those draws are not to be repeated
        assert word in said, (name, said)
        assert "line" in said or word.startswith("is a"), (name, said)


AGENT = """
class Agent(NamedTuple):
    V: np.ndarray
    n: np.ndarray
    MORE
    def late(self): return self.n[0] > 3_000
    def act(self, state, rng): return ACT
    def learn(self, state, action, reward):
        self.n[0] += 1
        self.V[int(INDEX)] += 0.1 * (reward - self.V[int(INDEX)])
mdp, agent = MDP, Agent(np.zeros(11), np.zeros(1, int))
G = W = np.zeros(1)
p, pair = P(np.zeros(1)), ()
"""
TASK = """
class P(NamedTuple):
    a: np.ndarray
class Task(NamedTuple):
    n: np.ndarray
    observation_space = property(lambda self: spaces.SPACE)
    action_space = property(lambda self: spaces.ACTIONS)
    max_steps = 30
    def initial(self, rng): return FIRST
    def transition(self, s, action, rng):
        self.n[0] += 1
        return NEXT
    def reward(self, s, action, next_state, rng): return REWARD
    def terminal(self, s): return ENDS
    def observation(self, s, rng): return SEEN
"""


def task(**parts: str) -> str:
    """An MDP and an agent; LATE stands for a condition that holds after 3 000 steps."""
    usual = {
        "SPACE": "Discrete(6)", "ACTIONS": "Discrete(2)", "FIRST": "0", "NEXT": "(s + 1) % 6", "REWARD": "float(s)",
        "SEEN": "s", "ACT": "rng.integers(2)", "INDEX": "state", "MORE": "", "MDP": "Task(np.zeros(1, int))",
        "ENDS": "False",
    }  # fmt: skip
    source = TASK + AGENT
    for name, text in (usual | parts).items():
        source = source.replace(name, text)
    return source.replace("LATE", "self.n[0] > 3_000")


WHOLE = {"FIRST": "(0, 0)", "REWARD": "float(s[0])"}
PAIR = {"SPACE": "MultiDiscrete([5, 3])", "FIRST": "(0, 0)", "SEEN": "s"}
BOX = {"ACTIONS": "Box(-1.0, 1.0, (1,), np.float64)", "MORE": "tabular = False"}
AS_IT_IS = {"MORE": "tabular = False"}
PICTURE = {"SPACE": "Box(0.0, 9.0, (2, 2))", "INDEX": "state[0, 0]"}
PARTS = {"SPACE": "Tuple((spaces.Discrete(6), spaces.Discrete(2)))"}
SURPRISES = "(s + 1 + (int(0 * 10 ** -int(self.n[0] % 9)) if self.n[0] > 1_000 else 0)) % 6"
CLAMPED = {"FIRST": "0.0", "NEXT": "max(0, min(4, s + action - 0.4))"}
TASKS = {
    "state that becomes real": (task(NEXT="s + 0.3 * action", SEEN="int(s) % 6"), "the state is made of whole numbers"),
    "pair that becomes real": (
        task(**WHOLE, NEXT="(s[0] + 1, action) if not LATE else (s[0] + 0.5, action)", SEEN="int(s[0]) % 6"),
        "tuples with whole and with real numbers"),
    "observation that becomes real": (task(SEEN="s if not LATE else 2.0"), "the observation is made of whole numbers"),
    "flag for an observation": (task(SEEN="s if not LATE else True"), "one name stands for True or False"),
    "part of an observation that becomes real": (
        task(**PARTS, **AS_IT_IS, SEEN="(s, 1 if not LATE else 1.0)", INDEX="state[0]"), "the observation is made of"),
    "flag for a part of an observation": (task(**PARTS, **AS_IT_IS, SEEN="(s, s > 3)", INDEX="state[0]"), ""),
    "fraction for an action": (task(ACT="1 if not self.late() else 0.5"), "act returns a number that is whole"),
    "rewards of both types": (task(REWARD="1 if action else -0.5"), ""),
    "no answer to whether it ends": (task(ENDS="None if LATE else False"), ""),
    "number for whether it ends": (task(ENDS="0.5 if LATE else False"), "True or False and for numbers"),
    "nothing for a state": (task(NEXT="None if LATE else (s + 1) % 6", SEEN="0 if s is None else s"), ""),
    "array of one number for an action": (task(ACT="np.array(1)"), "an action is not in the action space"),
    "reward of NaN, interpreted by then": (
        task(NEXT=SURPRISES, REWARD="math.nan if LATE else 1.0"), "stops where Python goes on"),
    "action beyond, interpreted by then": (
        task(NEXT=SURPRISES, ACT="2 if self.late() else 1"), "stops where Python goes on"),
    "row beyond": (task(**PAIR, NEXT="((s[0] + 1) % 5, 1) if not LATE else (5, 0)", REWARD="1.0"), ""),
    "row that is another's": (task(**PAIR, NEXT="((s[0] + 1) % 5, 1) if not LATE else (0, 4)", REWARD="1.0"), ""),
    "row beyond, as it is": (
        task(**PAIR, **AS_IT_IS, NEXT="((s[0] + 1) % 5, 1) if not LATE else (0, -1)", REWARD="1.0", INDEX="state[0]"),
        ""),
    "action of NaN": (task(**BOX, ACT="np.array([math.nan if self.late() else 0.1])"), ""),
    "two actions": (task(**BOX, ACT="np.array([0.1]) if not self.late() else np.array([0.1, 0.2])"), ""),
    "number of NaN for an action": (task(**BOX, ACT="math.nan if self.late() else 0.1"), ""),
    "array of another shape": (
        task(**PICTURE, **AS_IT_IS, SEEN="np.ones((2, 2)) if not LATE else np.ones((2, 3))"), ""),
    "clamped state": (task(**CLAMPED, SEEN="int(s)", REWARD="max(0, s)"), ""),
}  # fmt: skip
"""An MDP and an agent, and a word of the sentence that says why they are not compiled, if they are not."""
QUICK = [
    "reward of NaN, interpreted by then",
    "state that becomes real",
]


@pytest.mark.parametrize("names", [QUICK, pytest.param([*TASKS], marks=pytest.mark.slow)], ids=["quick", "all"])
def test_late_tasks(names: list[str]) -> None:
    """Trained compiled or interpreted: the same bits, or the same sentence."""
    for name in names:
        source, word = TASKS[name]
        same, said, seen = both_ways(source)
        assert same, (name, seen)
        assert bool(said) == bool(word), (name, said)
        assert word in said


@pytest.mark.parametrize("seeds", [range(1), pytest.param(range(1, 180), marks=pytest.mark.slow)], ids=["1", "179"])
def test_methods_made_at_random(seeds: range) -> None:
    """Each comes to the same bits, or the same error at the same line."""
    wrong = {seed: seen for seed in seeds if not (seen := method_both_ways(method_program(seed)))[0]}
    assert not wrong


@pytest.mark.parametrize("seeds", [range(1), pytest.param(range(1, 22), marks=pytest.mark.slow)], ids=["1", "21"])
def test_tasks_made_at_random(seeds: range) -> None:
    """Each comes to the same tables and curve, or the same sentence."""
    wrong = {seed: seen for seed in seeds if not (seen := both_ways(task_program(seed)))[0]}
    assert not wrong


@pytest.mark.usefixtures("compiled_at_once")
def test_compiling_that_takes_too_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is given up with a sentence, and the run goes on; the build stops, but only between two passes of Numba."""
    stopped_in, build = list[str](), compiler._build

    def watched(*arguments: Any) -> Any:
        try:
            return build(*arguments)
        except BaseException as error:
            stopped_in.append(traceback.extract_tb(error.__traceback__)[-1].name)
            raise

    monkeypatch.setattr(compiler, "MOST_SECONDS", 0.0)
    monkeypatch.setattr(compiler, "_build", watched)
    notebook = cell(WALK.replace("-0.25", "-0.75"))  # which no other test has compiled
    with pytest.warns(UserWarning, match="compiling takes longer than 0 s"):
        run = train(notebook["Walk"](5), QLearning.create((6, 2)), 6_000)
    assert run.complete
    assert stopped_in == ["on_start"]  # the loop of evaluations reaches the same class, and is not tried


SMALL = """class Small(NamedTuple):
    row: tuple
    def f(self, x, rng):
        return x + self.row[0] + G[0]
G = (1.0,)
"""


def test_what_was_given_up_is_tried_again_once_something_is_different(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tuples of another length may take less; so may a method that reads another value."""
    notebook, rng, out = cell(SMALL), np.random.default_rng(0), np.zeros(1)

    def other_loop(n: int, thing: Any, rng: Any, out: Any, carry: Any) -> Any:
        return thing.f(carry, rng)

    def build(run: Any, row: tuple[float, ...]) -> None:
        compiler.compiled(run, 1, notebook["Small"](row), rng, out, 0.0)

    with monkeypatch.context() as at_once:
        at_once.setattr(compiler, "MOST_SECONDS", 0.0)
        with pytest.raises(CompilationError, match="takes longer"):
            build(loop, (0.5,))
    with pytest.raises(CompilationError, match="takes longer"):
        build(other_loop, (0.5,))
    build(other_loop, (0.5, 0.25))
    notebook["G"] = (2.0,)
    build(other_loop, (0.5,))


def test_a_mistake_comes_at_the_step_at_which_python_has_it() -> None:
    """In this task evaluations count as well, and the steps that are rehearsed have none in between."""
    assert both_ways(task_program(321222))[0]
