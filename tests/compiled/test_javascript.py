# ruff: noqa: E501 (a table, with a program in each line)
"""Students' programs as JavaScript, in Node.js: the same bits as in Python, or interpreted with a sentence."""

import ast
import linecache
import traceback
import warnings
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import draws
import numpy as np
import pytest

import edugym
from edugym.compiled import execution
from edugym.compiled.javascript import operations
from edugym.compiled.javascript import program as javascript
from edugym.compiled.javascript.kinds import Untranslatable
from edugym.compiled.javascript.sources import source_of
from tests.compiled.cells import LEARNER, WALK, cell
from tests.compiled.javascript_engine import NODE, Node
from tests.compiled.late_programs import bits, method_program, outcome, task_program
from tests.compiled.oracle import played
from tests.compiled.programs import COMPILED, RAISE, REFUSED, SURPRISES, Q, program
from tests.compiled.test_execution import ADAPTED, SHUFFLED
from tests.compiled.test_late_programs import KEPT, REPEATED, TASKS
from tests.compiled.test_late_programs import REFUSED as REFUSED_LATE

pytestmark = pytest.mark.skipif(NODE is None, reason="needs Node.js: apt-get install nodejs")

REFUSED_HERE = {
    "whole at first": "whole numbers in one place and of real ones in another",
    "largest whole power": "more than 53 bits",
    "power of infinity": "a power of real numbers",
    "softmax": "it uses exp",
    "draws": "rng.poisson",
    "draws with defaults": "rng.poisson",
    "arrays of draws": "rng.normal is translated only for one draw",
    "choices": "np.argwhere",
    "picture": "an array of another type",
    "picture of bytes": "an array of another type",
    "whole fields and a picture": "an array of another type",
    "bounds of bytes and of what is left out": "an array of another type",
    "module with a function named as a draw": "the text of normal is not there",
    "max of whole and real": "whole numbers in one place and of real ones",
    "power": "a power of real numbers",
    "large whole numbers rounded": "more than 53 bits",
    "median of large whole numbers": "more than 53 bits",
    "parts of lists": "several places of a list at once",
    "numbers with a step": "it uses np.arange like this",
}
"""Programs that machine code can do and JavaScript cannot, and a word of the sentence that says why."""

FIRST = "class P(NamedTuple):\n    x: float\n    y: float"
TWO = "def g(self, a, b, c=0.5): return a + 2 * b * c\ndef one(self, rng): return self.g(rng.random(), c=rng.random(), b=rng.random())"
AB = {
    "fields": "A: np.ndarray\n    B: np.ndarray\n    N: np.ndarray",
    "values": "np.zeros((9, 2)), np.ones((9, 2)), np.zeros(9, np.int64)",
}
TRAPS = {
    "keywords in another order": program("return 0.25 * s + self.one(rng)", more=TWO),
    "nan in tuples": program("p = P(s, math.nan)\nq = p\nreturn s + (1.0 if p == q else 2.0)", before=FIRST),
    "array into an element": program("self.Q[0, 1] = self.Q[3]\nreturn s + 1", **Q),
    "array into an element of another size": program("self.Q[0, 1] = self.Q[3:4, 0]\nreturn s + 1", **Q),
    "the largest zero": program("self.Q[0] = (-0.0, 0.0) if s > 400 else (0.0, 0.5)\nreturn s + 1 + math.copysign(1, self.Q[0].max())", **Q),
    "sums of many": program(
        "n = int(s) % 40\nself.Q[n % 9] = rng.random(), 0.1 / (n + 1)\nx = np.zeros((n, 9))\nx[:, :] = self.Q[:, 0] * 0.37\n"
        "return (s + 1 + x.sum() * 1e-3 + self.Q[:, 1].sum() + self.Q.sum() + x[:, 0].sum() if n else s + 1.0) % 90", **Q),
    "products modulo": program("k = (int(s) * 0x1E3779B9 + 12345) % 2**31\nreturn float((k ^ (k >> 15)) * 0x2C1B3C6D % 2**31 % 1000)"),
    "products modulo beyond": program("return float((-5 - int(s)) * 0x7FFFFFFFFFF0000 % 1000)"),
    "list by two names": program("a = []\nb = a\nb.append(0.5)\na.append(int(s) % 3)\nreturn 0.5 * s + a[0] + b[1]"),
    "list from two places": program("a, b = [], [s + 1]\nif s >= 0: a = b\nreturn 0.5 * a[0]"),
    "tuples of two lengths": program("p, q = (s, 1.0), (s, 1.0, 2.0)\nreturn 0.5 * s + (1.0 if p == q else 2.0) + (q != p)"),
    "part of a tuple": program("p = (s, 1.0)\nif s > 700: p[0] = 2.0\nreturn s + p[1]"),
    "list in a helper": program("a = [1]\nself.h(a)\nreturn 0.5 * s + a[1] * 2", more="def h(self, a): a.append(2)"),
    "nested loops that break": program(
        "t = 0.0\nfor i in range(5):\n    for j in range(i, -1, -2):\n        if j * i > s: break\n        if j == 3: continue\n        t += j\n"
        "while True:\n    t += 1\n    if t > 7: break\nreturn 0.5 * s + t"),
    "floor and remainder of reals": program("x = (s - 700) * 0.3\nreturn s + 1 + 0 * sum([x // 0.7, x % 0.7, x % -0.7, x // -7, -x % 3])"),
    "zero divided": program("x = 0.0 * (s - 5)\nreturn s + 1 + math.copysign(1, x // 2) + math.copysign(1, x % -2) + math.copysign(1, -x)"),
    "rounding": program("return s + 0.5 + round(s) * 1e-3 + round(-s) * 1e-4 + int(-s) * 1e-5"),
    "picked from a tuple": program("return s + (1, 2, 4)[int(s) % 3] + (0.5, 2)[int(s) % -2]"),
    "in a list": program("best = [a for a in range(3) if self.Q[0, 0] >= 0 and a != 1]\nreturn s + 1 + (2 in best) + (int(s) not in (3, 4))", **Q),
    "chain with draws": program("return 0.5 * s + (0.1 < rng.random() < rng.random() < 0.9) + (rng.random() < 0.5 or rng.random() < 0.2)"),
    "normal numbers": program(
        "for i in range(20): s = 0.9 * s + rng.normal() + rng.normal(0.5) * rng.exponential() + rng.exponential(scale=0.5) - rng.normal(0.0, scale=2.0)\nreturn s"
    ),
    "a negative deviation": program("return s + 1 + 0 * rng.normal(0.0, 700 - s) + 0 * rng.exponential(800 - s)"),
    "numbered and alike": program(
        "a, b = np.arange(4), np.zeros_like(self.Q[0])\na[1] += int(s) % 3\nb[0] = s\nc = np.ones_like(self.Q)\nreturn 0.5 * b[0] + a.sum() + c[8, 1] + len(np.arange(-2))",
        **Q,
    ),
    "three dimensions": program(
        "x = np.zeros((2, 3, 4))\nx[1, int(s) % 3, -1] += s\nx[0] = 0.5\nreturn (0.5 * x[1].max() + x[0, 1, 2] + x.sum()) % 50",
    ),
    "four dimensions": program("x = np.zeros((2, 3, 4, 2))\nx[1, 0, 1, 1] += s\nreturn 0.5 * x[1, 0, 1, 1] + 1"),
    "values of and": program("k = int(s) % 3 and 7\nj = int(s) % 2 or 5\nreturn 0.5 * s + k + j"),
    "memory of another shape": program("x = self.Q.shape[0] + len(self.Q[0]) + self.Q.size + self.Q[2:].shape[0]\nreturn 0.5 * s + x", **Q),
    "numbers of NumPy, and less than what is less than 0": program(
        "x = np.floor(0.3 * s-K) + np.sqrt(s-K) + np.trunc(-s) * 1e-3 + np.ceil(s-K) * 1e-2\nreturn 0.5 * s + x + (1 if np.isnan(x) else 0)",
        before="K = -0.5"),
    "either of two fields": program(
        "X, Y = (self.A, self.B) if rng.random() < 0.5 else (self.B, self.A)\ni = int(s) % 9\nX[i, 0] += 0.1 * (s - Y[i, 1])\nrow = self.B[i]\n"
        "row[1] += 0.5\nself.N[i] += 2\nself.N[-1] += int(s) % 2\nbest, few = np.flatnonzero(self.N == self.N.max()), np.flatnonzero(X[i] > 0)\n"
        "return (0.5 * s + X[i, 0] + Y[i].max() + row.argmax() + len(best) + best[0] + len(few) + len(X) + self.A.shape[1]) % 50", **AB),
    "sums beyond 32 bits": program(
        "n = 700_000_000\nself.N[0] += n\nself.N[1] -= n\nself.N[2] += 3_000_000_000\n"
        "return s + 1 + self.N[0] * 1e-9 + self.N[1] * 1e-9 + self.N[2] * 1e-10", **AB),
    "private names": program(
        "__y = 0.5 * s\nreturn __y + __g + self.__K + self.__h(s)", before="__g, _T__g = 0.5, 1.5", more="__K = 0.25\ndef __h(self, s): return s * 0.125"),
    "keywords of clip in order": program("return np.clip(0.5 * s, a_min=rng.random(), a_max=1 + rng.random()) + np.clip(s, 0.2, a_max=1.5)"),
    "name that is no name": program("return half(s) + 1", before="def half(a): return 0.5 * a\nhalf.__name__ = 'a-half'"),
    "roots and squares of an array": program(
        "self.Q[:] = (self.Q + rng.random()) ** 0.5\nself.Q[:] = (self.Q ** 2.0 + self.Q ** 1.0) % 1.0\nreturn 0.5 * s + self.Q[3, 1]", **Q),
    "two rows at once": program("self.Q[0], self.Q[1] = self.Q[1] + 1, self.Q[0] * 0.5\nreturn (s + self.Q[0, 1]) % 50", **Q),
}  # fmt: skip
"""Programs in which JavaScript, left to itself, would do something else."""

LEFT = {
    "abs(s, 2)": "it uses abs like this",
    "bool(s, 2)": "it uses bool like this",
    "divmod(s)[0]": "it uses divmod like this",
    "float(s, 2)": "it uses float like this",
    "int('12', 8)": "it uses int like this",
    "sorted([s], key=abs)[0]": "it uses sorted like this",
    "math.floor(s, 2)": "it gives math.floor 2 numbers",
    "math.sqrt()": "it gives math.sqrt 0 numbers",
    "math.log(s, 2)": "it gives math.log 2 numbers",
    "math.hypot(s, 3.0, 4.0)": "it gives math.hypot 3 numbers",
    "np.exp(s, 2.0)": "it uses np.exp like this",
    "np.exp(self.Q > 0)[0, 0]": "it uses np.exp like this",
    "np.clip(0.5, a_max=rng.random(), a_min=rng.random())": "it uses np.clip like this",
    "rng.random(3)[1]": "rng.random is translated only for one draw",
    "(f := s)": "it has a :=",
    "(s, 1.0, 2.0)[1:][0]": "it takes several parts of a tuple at once",
    "(np.eye(2) @ np.ones(2))[0]": "it uses np.eye like this",
    "(self.Q @ np.ones(2))[0]": "it multiplies matrices",
    "(self.Q ** -1)[0, 0]": "a power for which NumPy may know a shorter way",
    "half(s)": "it calls a lambda: write the function with def",
    "(s == I.A)": "it compares a real number with I.A, a member of an enum",
}
"""What is reached late, if at all, and is left to Python, and what is said of it."""
BEFORE_LEFT = "half = lambda x: 0.5 * x\nclass I(enum.IntEnum):\n    A = 3"


@pytest.fixture(scope="module")
def node(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Node]:
    """JavaScript, without the functions of mathematics whose last digit may be another."""
    file = tmp_path_factory.mktemp("draws") / "draws.wasm"
    file.write_bytes(draws.module())
    engine = Node(file)
    yield engine
    engine.close()


def both_ways(source: str, engine: Any) -> tuple[bool, str, str]:
    """Whether a method comes to the same as JavaScript and interpreted, what was said, and what differs."""
    slow = played(source, fast=False)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(javascript, "engine", engine)
        fast = played(source, fast=True)
    same = all(slow[key] == fast[key] for key in ("error", "line")) and bits(slow["result"]) == bits(fast["result"])
    return same, fast["said"], "" if same else repr((slow, fast))


def check(programs: dict[str, str], engine: Any) -> dict[str, str]:
    """All come to the same; what was said of those that were not translated to their end."""
    found = {name: both_ways(source, engine) for name, source in programs.items()}
    assert not {name: seen for name, (same, _, seen) in found.items() if not same}
    return {name: said for name, (_, said, _) in found.items() if said}


def floats(programs: dict[str, str]) -> dict[str, str]:
    """The same programs, which return a real number for sure: what a loop carries has to be of one type."""
    return {name: source.replace("    return x\n", "    return float(x)\n") for name, source in programs.items()}


def test_what_machine_code_can_do(node: Node) -> None:
    """All programs that compile are translated, to the same bits, but for those that are named above."""
    said = check(COMPILED | floats(KEPT), node)
    assert not {name for name in said if name not in REFUSED_HERE}, said
    for name, word in REFUSED_HERE.items():
        assert word in said[name]
        assert "line" in said[name] or "step to step" in said[name] or "stops where Python goes on" in said[name]


def test_traps(node: Node) -> None:
    """Nothing is silently different. What is in doubt at every step, or refused, has a sentence."""
    in_doubt = {"products modulo beyond", "part of a tuple", "the largest zero", "nan in tuples", "four dimensions"}
    with suppress(ValueError):  # newer NumPys refuse an array in the place of a number
        np.zeros(1)[0] = np.ones(1)
        in_doubt.add("array into an element of another size")
    assert check(TRAPS, node).keys() == in_doubt


def test_what_is_left_to_python(node: Node) -> None:
    """Late calls with other arguments than Python takes are errors there; the sentence names what JavaScript lacks."""
    sources = {late: program(f"return s + 1 if s < 700 else s + {late}", before=BEFORE_LEFT, **Q) for late in LEFT}
    for name, said in check(sources, node).items():
        assert LEFT[name] in said, (name, said)
        assert "line" in said


ONLY_READ = np.zeros(2)
ONLY_READ.flags.writeable = False


@pytest.mark.parametrize(
    ("values", "word"),
    [(np.zeros(()), "without dimensions"), (ONLY_READ, "may only be read"), (np.zeros(2, ">f8"), "memory")],
    ids=["no axis", "read only", "other bytes"],
)
def test_other_memory(values: Any, word: str, node: Node) -> None:
    """JavaScript would read other numbers there, or write where nothing may be written."""
    with pytest.raises(Untranslatable, match=word):
        javascript.translated(added_up, (values,), node)


def test_another_text() -> None:
    """A text that has changed since, be it in a constant only, is not that of the code that runs."""
    function = type(cell(COMPILED["plain"])["thing"]).f
    name = function.__code__.co_filename
    lines = [line.replace("0.5 * s", "0.7 * s") for line in linecache.getlines(name)]
    linecache.cache[name] = 0, None, lines, name
    with pytest.raises(Untranslatable, match="the text of f is not there"):
        source_of(function)


def test_what_ends_or_surprises(node: Node) -> None:
    """Late errors stop at the student's line; where Python goes on, it goes on."""
    check(RAISE | SURPRISES | floats(REPEATED), node)


def test_what_machine_code_refuses(node: Node) -> None:
    """Nothing is silently different."""
    sources = {name: source for name, (source, _) in (REFUSED | REFUSED_LATE).items() if "random" not in source}
    assert len(check(sources, node)) > len(sources) / 2


@pytest.mark.parametrize("seeds", [range(15), pytest.param(range(15, 300), marks=pytest.mark.slow)], ids=["15", "300"])
def test_methods_made_at_random(seeds: range, node: Node) -> None:
    """Each comes to the same bits, or the same error at the same line."""
    check({str(seed): method_program(seed) for seed in seeds}, node)


def outcomes(source: str, engine: Any) -> tuple[dict[str, Any], dict[str, Any], str]:
    """What training comes to, interpreted and as JavaScript, and what was said."""
    slow = outcome(source, fast=False)[0]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(javascript, "engine", engine)
        fast, said = outcome(source, fast=True)
    return slow, fast, said


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(60))
def test_tasks_made_at_random(seed: int, node: Node) -> None:
    """Each comes to the same tables and curve, or the same sentence."""
    slow, fast, _ = outcomes(task_program(seed), node)
    assert slow == fast


@pytest.mark.slow
@pytest.mark.parametrize("name", TASKS)
def test_late_tasks(name: str, node: Node) -> None:
    """Trained as JavaScript or interpreted: the same bits, or the same sentence."""
    slow, fast, _ = outcomes(TASKS[name][0], node)
    assert slow == fast


@pytest.mark.parametrize("adapted", [False, True])
def test_students_agents_learn(adapted: bool, node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    """A student's agent in a student's task learns the same, also by keywords, with defaults and in another order."""
    runs = []
    for engine in (None, node):
        monkeypatch.setattr(javascript, "engine", engine)
        monkeypatch.setattr(execution, "may_compile", lambda: False)
        notebook = cell(WALK + (SHUFFLED + ADAPTED if adapted else LEARNER))
        learner = notebook["Learner"](np.zeros((6, 2)))
        agent = notebook["Adapted"](learner) if adapted else learner
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            run = edugym.train(notebook["Walk"](5), agent, 12_000, evaluate_every=1500, seed=3)
        runs.append((run.returns.tolist(), run.training_returns[1:].tolist(), learner.Q.tobytes()))
    assert runs[0] == runs[1]


AGENTS: list[Any] = [edugym.QLearning, edugym.SARSA, edugym.ExpectedSARSA, edugym.DoubleQLearning]


ENVIRONMENTS = ["Boulder", "MemoryCorridor", "Roadrunner", "Supermarket", "Study", "Golf"]
QUICK = [("Boulder", edugym.QLearning), ("Golf", edugym.SARSA), ("MemoryCorridor", edugym.DoubleQLearning)]
SLOW = [pytest.param(one, kind, marks=pytest.mark.slow) for one in ENVIRONMENTS for kind in AGENTS]


@pytest.mark.parametrize(("environment", "kind"), [*QUICK, *SLOW])
def test_the_packages_agents(environment: str, kind: Any, node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tables and curve are those of `train`, to the last bit."""
    runs = []
    for engine in (None, node):
        monkeypatch.setattr(javascript, "engine", engine)
        monkeypatch.setattr(execution, "may_compile", lambda: False)
        mdp = edugym.make_mdp(environment)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            run = edugym.train(mdp, kind.create(mdp), 6_000, seed=2)
        arrays = [part for part in run.agent if isinstance(part, np.ndarray)]
        runs.append((run.returns.tobytes(), run.training_returns.tobytes(), [part.tobytes() for part in arrays]))
    assert runs[0] == runs[1]


def added_up(n: int, values: Any) -> float:
    """Read and write single numbers of an array with one axis by `flat`, as wrappers do for arrays of any size."""
    total = 0.0
    for k in range(n):
        values.flat[k % 3] += 0.5 * k
        values.flat[-2] = values.flat[0] - total
        total += values.flat[2]
    return total


def copied(n: int, values: Any) -> float:
    """Write into what is a copy in NumPy."""
    values.flat[:n][0] = 1.0
    return 0.0


def test_flat(node: Node) -> None:
    """It stands for single numbers of one axis; a part of it is a copy, and refused."""
    here, there = np.ones(3), np.ones(3)
    assert added_up(9, here) == javascript.translated(added_up, (there,), node)(9, there)
    assert here.tobytes() == there.tobytes()
    for loop, values in ((added_up, np.ones((3, 3))), (copied, np.ones(3))):
        with pytest.raises(Untranslatable, match=r"it uses \.flat"):
            javascript.translated(loop, (values,), node)


def test_other_arrays(node: Node) -> None:
    """A translation keeps what it knows of its arrays only as long as they are the same, however often they change."""
    first, second = np.zeros(3), np.ones((5, 2))[:, 1]
    call = javascript.translated(added_up, (first,), node)
    for values in (first, second) * javascript.MOST_LOADS:
        expected = values.copy()
        assert (call(7, values), values.tolist()) == (added_up(7, expected), expected.tolist())


def test_a_slip_after_many_steps(node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    """It stops at the student's line, with the tables as they were in that step."""
    monkeypatch.setattr(javascript, "engine", node)
    slip = "if self.calls[0] == 50_000: self.Q[state, action + 7] = 1.0"
    head = "def learn(self, state, action, reward, next_state, terminated):"
    source = LEARNER.replace(head, f"{head}\n        self.calls[0] += 1\n        {slip}")
    notebook = cell(WALK + source.replace("rate: float = 0.5", "calls: np.ndarray\n    rate: float = 0.5"))
    agent = notebook["Learner"](np.zeros((6, 2)), np.zeros(1, np.int64))
    with pytest.raises(IndexError) as caught:
        edugym.train(notebook["Walk"](5), agent, 120_000, seed=1)
    assert traceback.extract_tb(caught.value.__traceback__)[-1].line == slip
    assert agent.calls.tolist() == [50_000]


def test_another_last_digit_is_not_accepted(node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first steps are compared to the last bit."""
    monkeypatch.setitem(operations.REAL, ast.Mult, "({}*{}*1.0000000000000002)")
    said = check({"plain": COMPILED["plain"]}, node)
    assert "comes to something else than Python in the first steps" in said["plain"]
