"""Programs made at random from a grammar of students' Python, whose interesting line is reached late, or never.

`method_program(seed)` is a class with one method, for `tests.compiled.oracle`; `task_program(seed)` an MDP and an agent
to train, for `both_ways`.
"""

import random
import warnings
from typing import Any

import numpy as np
import pytest

import edugym
from edugym.compiled import execution
from tests.compiled.cells import cell
from tests.compiled.oracle import played
from tests.compiled.programs import program

WHOLE = """
0 1 2 3 -1 -2 7 i k k n i+1 n%5 n//7 int(self.N[i]) len(row) int(s) int(x) abs(k) -k k*k k%3 k-i least
"""
REAL = """
0.5 0.0 -0.25 1.5 s x x self.x self.Q[i,0] self.Q[i,1] -x 0.5*k abs(x) x*x k/2 rng.random() math.sqrt(abs(x)) 0 1 2 3 -1
-2 7 i
"""
FIELDS = "x: float\n    least: int\n    Q: np.ndarray\n    N: np.ndarray\n    n: np.ndarray"
VALUES = "0.5, -2**63, np.zeros((9, 2)), np.ones(9, np.int64), np.zeros(1, np.int64)"
BEFORE = """G = np.arange(4.0)
W = np.arange(3)
class P(NamedTuple):
    a: np.ndarray
    b: float = 2
    def first(self): return self.a[0] + self.b
    def move(self, v): self.a[0] += v
class S(NamedTuple):
    v: float
    w: int = 1
    def twice(self): return self.v * 2
p, pair = P(np.arange(3.0)), (np.zeros(2), np.arange(2))
K, small = 3, (1, 0.5, 2)
def h(a, b): return a if a > b else 2 * b
def zero(a): return 0 if a < 1 else a
def put(array, v): array[0] = v
def outer(c, table):
    def inner(a): return a * c + table[0]
    def write(a): table[0] += a
    return inner, write
inner, write = outer(2, np.ones(2))
"""
MORE = """M = (np.zeros(2), 3, np.arange(2))
t = 2
def m(self, a, b=0.5): return a * b + self.t
def bump(self, a): self.M[0][0] += a
def g(self, a, memory=(0, 1.5)): return a + memory[1]
"""


class Writer:
    """Writes a program from a random stream."""

    def __init__(self, seed: int) -> None:
        """Begins one."""
        self.draw = random.Random(seed)

    def one(self, *texts: str) -> str:
        """One of the texts."""
        return self.draw.choice(texts)

    def whole(self, depth: int = 1) -> str:
        """A whole number, as far as one can see."""
        if depth <= 0 or self.draw.random() < 0.5:
            return self.one(*WHOLE.split())
        a, b = self.whole(depth - 1), self.whole(depth - 1)
        return self.one(
            f"({a} + {b})", f"({a} - {b})", f"({a} * {b})", f"({a}) // ({b} or 1)", f"({a}) % 5", f"({a}) ** 2",
            f"2 ** min(5 - {a}, 99)", f"pow(2, min(4 - {a}, 99))", f"max({a}, {b})", f"abs({a})",
            f"sum([{a}, {b}])", f"int({self.real()})", f"(1 << ({a}) % 70)", f"divmod({a}, 3)[1]", f"(2 ** 61 + {a})",
            f"round({self.real()})", f"-({a})",
            "np.sum(self.N[:i])", "self.N.max()", f"abs(self.least + ({a}) % 2)", f"3 ** (({a}) % 50)",
        )  # fmt: skip

    def real(self, depth: int = 1) -> str:
        """A number."""
        if depth <= 0 or self.draw.random() < 0.4:
            return self.one(*REAL.split())
        a, b = self.number(depth - 1), self.number(depth - 1)
        return self.one(
            f"({a} + {b})", f"({a} - {b})", f"({a} * {b})", f"({a}) / 3", f"max({a}, {b})", f"min({a}, {b})",
            f"({a} if {self.condition()} else {b})", f"h({a}, {b})", f"zero({a})", f"self.m({a})", f"self.m({a}, {b})",
            f"max(0, min(1, {a}))", f"sum([{a}, {b}])", f"abs({a})", f"S({a}, {self.whole(0)}).v", f"S({a}).twice()",
            f"self.g({a})", "p.first()", "G[k % 4]", "pair[1][k % 2]", f"inner({a})", "small[1]", "self.M[2][k % 2]",
            f"-({a})", f"({a}) % 3", f"({a}) // 2", f"math.floor({a})", f"np.sqrt(abs({a}))", f"float({a})",
            f"max([{a}, {b}])", f"sorted([{a}, {b}])[0]", f"({a}) ** 2", f"({a}, {b})[{self.one('0', '1')}]",
            f"np.array([{a}, {b}])[k % 2]", f"np.array([{a}, {b}]).sum()", f"rng.choice([{a}, {b}])", "p.b", "W[k % 3]",
        )  # fmt: skip

    def number(self, depth: int = 1) -> str:
        """A whole number or a real one."""
        return self.real(depth) if self.draw.random() < 0.6 else self.whole(depth)

    def condition(self) -> str:
        """What is true now and then."""
        return self.one("k > 2", "x > 0.5", "n % 7 == 0", "s < x", f"n > {self.draw.randrange(1500)}", "i == 3", "k")

    def simple(self) -> str:
        """One line."""
        a, b, k = self.number(), self.number(), self.whole()
        return self.one(
            f"x = {a}", f"x = {a}", f"k = {k}", f"x += {a}", f"x -= {a}", f"x *= {a}", f"k += {k}", "k *= 3", "x = -x",
            f"self.Q[i, k % 2] += 0.1 * ({a} - self.Q[i, 0])", f"self.Q[i, 1] = {a}", f"self.N[i] = {k}",
            f"self.N[i] += {k}", f"row = [{a}, {b}]", "row = [0, 0]", f"row[k % len(row)] = {a}", f"row.append({a})",
            "row = [0] * 3", f"row = [{a} for j in range(3)]", "x = max(row)", "x = sum(row)", "x = row[k % len(row)]",
            "for v in row: x = x + v", f"for j in range(3): x = x * {self.one('2', '3', '0.5', 'k')}",
            f"while k > 0: k = k // 2 - {self.one('1', '0.5')}", f"x, k = {a}, {k}", f"x, y = {a}, {b}", "y = x",
            f"for j in range(5): k *= {self.one('2', '10', '-3', 'n')}", f"y = (x, {a})\nx = y[0]",
            f"e = S({a}, {k})\nx = e.v * e.w", f"x = {a} if {self.condition()} else {b}", "k = int(x)",
            *(self.frozen(a, k) for _ in range(3)), "self.N[:] = self.N ** (3 - k)", "x += (self.N ** 2).sum()",
            "x = abs(self.least)", "self.N[:] += 1", f"row = row + [{a}]", "row.sort()",
            "x = np.mean(self.Q[i])", f"x = self.Q[i].max() - {a}",
            "best = 0\nfor j in range(2): best = max(best, self.Q[i, j])\nx = best",
        )  # fmt: skip

    def frozen(self, a: str, k: str) -> str:
        """A line that writes to what is no field."""
        return self.one(
            f"G[0] += {a}", f"self.M[0][{k} % 2] = {a}", f"self.bump({a})", f"pair[0][0] += {a}", f"p.a[1] = {a}",
            f"p.move({a})", f"put(G, {a})", f"put(self.M[0], {a})", f"write({a})", "W[:] += 1", f"G.fill({a})",
            "G[:] *= 0.5", "rng.shuffle(G)", "put(pair[0][1:], 2.0)", "part = self.M[0]\npart[k % 2] -= 1",
        )  # fmt: skip

    def statement(self, late: int) -> str:
        """A line, or one that is reached late."""
        line, place = self.simple(), self.draw.random()
        if place < 0.45:
            return line
        inside = line.replace("\n", "\n    ")
        condition = f"n > {late}" if place < 0.85 else self.condition()
        return f"if {condition}:\n    {inside}"


def method_program(seed: int) -> str:
    """A class with one method of a few lines."""
    writer = Writer(seed)
    late, kind = writer.draw.randrange(210, 1400), writer.draw.random()
    lines = [writer.statement(late) for _ in range(writer.draw.randrange(1, 6))]
    begin = [
        "self.n[0] += 1",
        "n = int(self.n[0])",
        "i = int(rng.random() * 9)",
        f"x = {writer.one('s', '0', '0.0', '1')}",
    ]
    begin += [f"k = {writer.one('1', 'i', 'n')}", f"row = {writer.one('[0, 0]', '[0.0, 1.0]', '[0.5, 1]', '[k, i]')}"]
    begin += ["least = -5"]
    end = [
        "self.Q[i, 0] = x",
        f"return {writer.one('0.5', '0.25 * (x % 7)', 'x % 3', 'abs(x) % 5', 'x', 'k % 9', 'max(0, min(9, x))')}",
    ]
    if kind < 0.2:  # what is carried is of another type late
        end[1] = f"return {writer.one('0.5', '1', 'i')} if n < {late} else {writer.number()}"
    start = writer.one("0.0", "0.5", "0")
    return program("\n".join([*begin, *lines, *end]), FIELDS, VALUES, BEFORE, start, MORE)


STATES = [
    ("0", "s % 5", ["(s + a) % 5", "(s + 1) % 5", "s"], ["s + 0.5", "s / 2", "7", "-1", "True"]),
    (
        "(0, 0)",
        "s[0] % 5",
        ["((s[0] + 1) % 5, a)", "(s[0], 1 - s[1])"],
        ["(s[0] + 0.5, a)", "(s[0], 0.5)", "(7, a)", "(s[0], a, 1)"],
    ),
    (
        "0.0",
        "int(s) % 5",
        ["s + 0.3 * a", "max(0, min(4, s + a - 0.4))", "s * 0.5"],
        ["0", "int(s)", "math.nan", "s * 3", "1e9"],
    ),
    (
        "T(0, 0.5)",
        "s.x % 5",
        ["T((s.x + 1) % 5, s.v * 0.9)", "T(s.x, max(0, s.v - 0.1))"],
        ["T(s.x + 0.5, s.v)", "T(s.x, 1)", "T(s.x)"],
    ),
]
"""States: the first, what is observed, those that follow, and what comes late."""
SPACES = [
    ("Discrete(5)", ["i", "0", "4"], ["5", "-1", "0.5", "2.0"]),
    ("Discrete(5)", ["i", "2"], ["True", "7"]),
    ("MultiDiscrete([5, 3])", ["(i, 1)", "(i, 2)"], ["(i, 3)", "(i, -1)", "(i, 0.5)", "(i, 1, 1)", "(5, 0)"]),
    ("Box(0.0, 4.0, (2,))", ["(float(i), 1.5)"], ["(5.0, 1.0)", "(math.nan, 1.0)", "(1, 1)", "(i, 0.5)"]),
    (
        "Box(0.0, 4.0, (2,), np.float32)",
        ["np.array([i, 0.5])"],
        ["np.array([9.0, 1.0])", "np.array([1.0])", "np.zeros(3)"],
    ),
]
"""Spaces of observations: what is seen, and what is seen late."""


def task_program(seed: int) -> str:
    """An MDP `mdp` and an agent `agent`, each of which may do another thing late."""
    writer = Writer(seed)
    draw, one = writer.draw, writer.one
    first, shown, following, late_states = draw.choice(STATES)
    space, seen, late_seen = draw.choice(SPACES)
    late = draw.randrange(210, 4_000)
    slip = draw.choice(["state", "reward", "seen", "act", "learn", "learn", "learn", "none"])
    when = f"self.n[0] > {late}" if draw.random() < 0.8 else f"rng.random() < {1 / late}"
    step, row = one(*following), space == "Discrete(5)"
    transition = f"return {step}" if slip != "state" else f"return {step} if not ({when}) else {one(*late_states)}"
    reward = one("1.0 if a else -0.5", "1 if a else 0.5", "0 if a else 0.5", "a", "0.1 * a", "-1")
    if slip == "reward":
        wrong = one("0.5", "2", "math.nan", "2**60", "-0.0", "True", "1e300")
        reward = f"{one('1.0', '1', '0')} if not ({when}) else {wrong}"
    sight = one(*seen) if slip != "seen" else f"{one(*seen)} if not ({when}) else {one(*late_seen)}"
    index = "state" if row else "int(state[0])"
    act = "rng.integers(2)" if one("a", "b") == "a" else "int(rng.random() < 0.5)"
    if slip == "act":
        wrong = one("2", "-1", "0.5", "1.0", "True", "np.argmax(self.Q[i])", "rng.integers(3)")
        act = f"{act} if not ({when}) else {wrong}"
    lines = [writer.statement(late) for _ in range(draw.randrange(1, 4))] if slip == "learn" else []
    indent = "\n        "
    begin = ["x, k, row, least, s = reward, action, [0, 0], -5, self.x", "n = int(self.n[0])"]
    body = indent.join("\n".join([*begin, *lines]).split("\n")).replace("rng.", "self.")  # `learn` has none
    tail = one("x", "0.1 * x", "reward", "-reward", "x - self.Q[i, 0]", "reward * 2 + k", "max(0, reward)")
    more = "\n    ".join(MORE.split("\n"))
    return f"""{BEFORE}
class T(NamedTuple):
    x: int
    v: float = 2.0
class Task(NamedTuple):
    n: np.ndarray
    max_steps = 40
    observation_space = property(lambda self: spaces.{space})
    action_space = property(lambda self: spaces.Discrete(2))
    def initial(self, rng): return {first}
    def transition(self, s, a, rng):
        self.n[0] += 1
        {transition}
    def reward(self, s, a, next_state, rng): return {reward}
    def terminal(self, s): return False
    def observation(self, s, rng):
        i = {shown}
        return {sight}
class Agent(NamedTuple):
    {FIELDS}
    {more}
    {"tabular = False" if not row else ""}
    def act(self, state, rng):
        i = {index}
        return {act}
    def learn(self, state, action, reward, next_state):
        self.n[0] += 1
        i = {index}
        {body}
        self.Q[i, 0] += {tail}
        self.Q[i, 1] = x
        self.N[i] += k % 2
mdp, agent = Task(np.zeros(1, np.int64)), Agent({VALUES})
"""


def outcome(source: str, *, fast: bool, n_steps: int = 6_000) -> tuple[dict[str, Any], str]:
    """What training comes to, to the last bit, and what is said of how it ran."""
    notebook = cell(source)
    found: dict[str, Any] = {}
    with warnings.catch_warnings(record=True) as caught, pytest.MonkeyPatch.context() as patch:
        warnings.simplefilter("always")
        patch.setattr(execution, "seconds_to_build", lambda: 0.0)
        execution._warned.clear()
        if not fast:
            patch.setattr(execution, "may_compile", lambda: False)
        try:
            run = edugym.train(notebook["mdp"], notebook["agent"], n_steps, seed=1)
            curve = (run.steps, run.returns, run.training_returns, run.episodes)
            found["curve"] = [column.tobytes() for column in curve]
        except Exception as error:
            found["error"] = f"{type(error).__name__}: {error}"
    arrays = [
        *notebook["agent"][2:],
        notebook["mdp"].n,
        notebook["G"],
        notebook["W"],
        notebook["p"].a,
        *notebook["pair"],
    ]
    found["arrays"] = [array.tobytes() for array in arrays] if "error" not in found else []
    said = [str(one.message) for one in caught if "interpreted" in str(one.message)]
    return found, " ".join(said)


def bits(value: Any) -> Any:
    """A value to its last bit, and the sign of zero; a whole number is the same as the real one."""
    if isinstance(value, tuple):
        return tuple(map(bits, tuple.__iter__(value)))
    if isinstance(value, np.ndarray):
        return value.tobytes()
    if isinstance(value, np.random.Generator):
        return str(value.bit_generator.state)
    if isinstance(value, int) and abs(value) >= 2**53:
        return hex(value)
    is_number = isinstance(value, int | float | np.number)
    return float(value).hex() if is_number and abs(float(value)) < 2**53 else str(value)


def method_both_ways(source: str) -> tuple[bool, str, str]:
    """Whether a method comes to the same compiled and interpreted, what was said, and what differs."""
    slow, fast = played(source, fast=False), played(source, fast=True)
    same = all(slow[key] == fast[key] for key in ("error", "line")) and bits(slow["result"]) == bits(fast["result"])
    return same, fast["said"], "" if same else repr((slow, fast))


def both_ways(source: str) -> tuple[bool, str, str]:
    """Whether training comes to the same compiled and interpreted, what was said, and what differs."""
    slow, fast = outcome(source, fast=False)[0], outcome(source, fast=True)
    differing = [name for name in {*slow, *fast[0]} if slow.get(name) != fast[0].get(name)]
    seen = "; ".join(f"{name}: {str(slow.get(name))[:200]} or {str(fast[0].get(name))[:200]}" for name in differing)
    return not differing, fast[1], seen
