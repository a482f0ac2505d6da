# ruff: noqa: E501 (a table, with a program in each line)
"""Programs as students write them, each of which does something that compilers do in a way of their own."""


def program(body: str, fields: str = "", values: str = "", before: str = "", start: str = "0.0", more: str = "") -> str:
    """A program: a class with a method `f(self, s, rng)` and an instance of it."""
    lines = "\n        ".join(body.split("\n"))
    members = "\n    ".join(more.split("\n"))
    return (
        f"{before}\nclass T(NamedTuple):\n    {fields or 'x: float'}\n    {members}\n    def f(self, s, rng):\n"
        f"        {lines}\nthing = T({values or '1.5'})\nstart = {start}\n"
    )


Q = {"fields": "Q: np.ndarray", "values": "np.zeros((9, 2))"}
N = {"fields": "N: np.ndarray", "values": "np.zeros(9, np.int64)"}

COMPILED = {
    "plain": program("return 0.5 * s + self.x * rng.random()"),
    "table": program("i = int(rng.random() * 9)\nself.Q[i, 0] += 0.1 * (s - self.Q[i, 0])\nreturn self.Q[i, 0] + 1", **Q),
    "median with nan": program("self.Q[0, 0] = s\nself.Q[3, 1] = math.nan if s > 30 else 1.0\nm = np.median(self.Q[:, 1])\n"
        "return s + (0.5 if m != m else 1.0 + m)", **Q),
    "whole power": program("return s + 3 ** int(rng.random() * 30) % 7"),
    "largest whole power": program("return s + 9223372036854775807 ** int(rng.random() * 2) % 7"),
    "power of minus one": program("return s % 9 + (int(s) % 3 - 1) ** int(rng.random() * 30)"),
    "power of infinity": program("return s % 9 + (2.0 if (2.0 + s) ** self.x > 9.0 else 1.0)", values="math.inf"),
    "ties": program(
        "best = [a for a in range(2) if self.Q[0, a] == max(self.Q[0, 0], self.Q[0, 1])]\n"
        "a = best[int(rng.random() * len(best))]\nself.Q[0, a] += rng.random()\nreturn a", start="0", **Q),
    "counts": program("i = int(rng.integers(0, 9))\nself.N[i] += 1\nreturn s + self.N[i] / 3", **N),
    "array functions": program("self.Q[:, 0] = self.Q[:, 1] + rng.random()\nreturn self.Q.max() + np.argmax(self.Q[0])", **Q),
    "largest and smallest": program(
        "i = int(s) % 9\nself.Q[i] = rng.random() - 0.5, math.nan if i == 7 else -0.5\n"
        "m = self.Q[i].max() + 2 * np.min(self.Q[i]) + 4 * np.max(self.Q[:, 0]) + 8 * self.Q[::2, 0].min() + self.Q.max()\n"
        "return s + self.N.max() - np.min(self.N) + (0.25 if m != m else m)", "Q: np.ndarray\n    N: np.ndarray", "np.zeros((9, 2)), np.arange(3)"),
    "largest by a method of one's own": program(
        "return 0.5 * s + self.max() + self.min(2.0)",
        more="def max(self): return self.x\ndef min(self, y): return y"),
    "whole at first": program(
        "self.Q[int(rng.random() * 4)] *= 0.5\nreturn self.m(k=s, s=max(int(rng.integers(0, 5)), -1))",
        start="1", more="def m(self, s, k, beta=0.5): return s * beta + k", **Q),
    "property": program("return 0.5 * s + self.half * self.x", more="@property\ndef half(self): return self.x / 2"),
    "softmax": program("p = np.exp(self.Q[0] - np.max(self.Q[0]))\np = p / np.sum(p)\nself.Q[0, 0] += p[0] - s\nreturn p[1] + (s in [1.0, 0.5])", **Q),
    "parts in place": program(
        "i = int(s) % 9\nself.Q[i] *= 0.5\nself.Q[i:, 1] += s\nself.Q[::-2, ::-1] -= 1\nself.Q[-1][:] /= 4\nself.Q[i], i = self.Q[3], 2\n"
        "row = self.Q[i]\nrow += 1\nself.Q[i + 1] = row\nrow -= 2\nself.Q[i] = row\nreturn (s + abs(self.Q[4, 1])) % 100", **Q),
    "row in place": program("self.Q[0] *= 0.5\nself.Q[:] += 0.25\nreturn self.Q.sum() + put(self.Q, self.Q[1])",
        before="def put(Q, row):\n    Q[2] = row\n    part = Q[3]\n    part += 1\n    Q[4] = part\n    return Q[2, 0] + Q[4, 1]", **Q),
    "draws": program(
        "k = int(s) % 4\nhigh = 1.7976931348623157e308 if k == 1 else k - 1.0\n"
        "return 0.5 * s % 99 + rng.normal(1.0, float(k)) + rng.exponential(float(k)) + rng.poisson(3.3 * k) + rng.binomial(10 * k, k / 3) + (rng.uniform(-1.0, high) > 0.5)"),
    "draws with defaults": program(
        "return 0.5 * s + rng.normal() + rng.exponential() + rng.uniform() + rng.poisson() + rng.integers(9) + rng.integers(0, 3, endpoint=True)"),
    "arrays of draws": program(
        "return 0.5 * s + rng.normal(0.0, 2.0, 3)[2] + rng.exponential(2.0, size=2)[0] + rng.integers(4, size=2)[1] + rng.uniform(size=int(s) % 3 + 1)[0]"),
    "choices": program(
        "i = int(s) % 9\nself.Q[i, 1] = rng.random() * (rng.random() < 0.5)\np = self.Q[:, 1] + 0.5\nbest = [k for k in range(9) if p[k] > 0.6] + [2]\n"
        "return 0.5 * s + rng.choice(best, None, True) + rng.choice((2, 5)) + rng.choice(np.argwhere(p == np.amax(p))[:, 0]) + rng.choice(a=p, p=np.arange(9) / 36)", **Q),
    "where it is not zero": program(
        "i = int(s) % 9\nself.Q[i] = math.nan if i == 4 else i % 3, -0.0\n"
        "return 0.5 * s + np.flatnonzero(self.Q).sum() + len(np.flatnonzero(self.Q[::2, 0] > 1)) + np.flatnonzero([k > s for k in range(9)]).sum()", **Q),
    "any and all": program(
        "i = int(s) % 9\nself.Q[i] = i - 4.0, math.nan if i == 3 else 0.0\na = any(self.Q[:, 1]) + 2 * all(self.Q[:, 0] < 4)\n"
        "return 0.5 * s + a + 4 * any([k > s for k in range(9)]) + 8 * all((s > 2.0, s < 5.0)) + 16 * all([s]) + any(self.Q[i:i, 0])", **Q),
    "choice of one's own": program("return s + self.choice(2, 3, p=rng.random())", more="def choice(self, a, b, p): return a * b * p"),
    "filled with whole numbers": program(
        "self.N.fill(int(s))\nself.N[1] = 4\na = np.full(3, 2, dtype=int)\nreturn s + self.N[0] % 2 + a[0] + np.full(2, 0.5)[0]", **N),
    "number of a flag": program("return 0.5 * s + float(rng.random() < 0.5) + 0.25 * float(int(s)) - (s > float('inf'))"),
    "value of an enum": program("return C.G.value * 0.25 * s + 1 if C.R != C.G else 0.0", before="class C(enum.Enum):\n    R = 1\n    G = 2"),
    "picture": program(
        "picture = np.zeros((3, 3), np.float32)\npicture[1] = 0.3\npicture[0, 1] = s\nself.Q[0] = s\nreturn self.g(picture) + s * 0.5",
        more="def g(self, picture):\n    return len(picture) + picture.shape[1]", **Q),
    "picture of bytes": program("picture = np.zeros((3, 3), np.uint8)\npicture[1, 2] = 100\nreturn len(picture) + s * 0.5"),
    "tuple": program("x, k = s\nreturn (x + rng.random(), k + 1)", start="(0.0, 0)"),
    "default omitted": program(
        "return self.g(s, terminated=True) + self.g(s=s, terminated=False, beta=2.0)",
        more="def g(self, s, terminated, alpha=0.5, beta=1.0):\n    return 0.0 if terminated else alpha * s / (1 + s * beta) + beta"),
    "closure": program("return g(s)", before="def make(k):\n    def g(x): return 0.5 * x + k\n    return g\ng = make(2)"),
    "closure as a method": program(
        "return self.g(s)",
        before="def make(k):\n    def g(self, x): return 0.5 * x + k + self.x\n    return g",
    ).replace("thing =", "T.g = make(3)\nthing ="),
    "max of whole and real": program("return max(int(s), 0.5, s) + min(1, rng.random())"),
    "unset in no way": program("if s > 5:\n    y = 1.0\nelse:\n    y = 2.0\nreturn (s + y) % 9"),
    "types of Python for arrays": program(
        "a, b, c = np.zeros(3, int), np.ones((2, 2), dtype=float), np.full(2, True, dtype=bool)\na[1] += int(s)\n"
        "return (a[1] / 3 + b[1, 1] + c[0] * 2.0 + rng.integers(0, 5, dtype=int)) % 7"),
    "clip": program("x = np.clip(s, 0, math.nan)\nreturn np.clip(s + 0.75, -1, 5) + np.clip(int(s), 1, 3) / 2 + (x == x) + np.clip(2.5, a_min=7, a_max=s)"),
    "fields left out": program(
        "return S(s.x + 1, key=s.key or s.x > 9) if s == S(3.0) or s.key else S(s.x + s.k * 0.5)",
        before="class S(NamedTuple):\n    x: float\n    k: int = 1\n    key: bool = False", start="S(0.0)"),
    "bounds of bytes and of what is left out": program(
        "self.N[:] += 5\nself.N[2:] //= 2\na, b = np.zeros(2, np.uint8), np.zeros(2, np.uint8)\na[0] = 127\na[1] = 0\nb[:] = a\n"
        "k, v = None if s > 3 else 1, S(1.0)\nreturn s * 0.5 + self.N[3] % 7 + np.int64(int(s)) % 3 + (1 if k is None else 2) + (v.low < 0 < v.high) + (v.no is None)",
        before="class S(NamedTuple):\n    x: float\n    low: int = -2**63\n    high: int = 2**63 - 1\n    no: object = None", **N),
    "numbered from one": program("for i, x in enumerate(self.Q[0], start=1): s += i * x + 0.25\n"
        "for x, y in zip(self.Q[0], range(9)): s -= x * y\nreturn 0.5 * s + round(s) % 2", **Q),
    "module with a function named as a draw": program(
        "return 0.5 * s + (m.normal(2.0) if s < 9 else m.max())",
        before="import types\nm = types.ModuleType('m')\nexec('def normal(x, scale=3.0): return x * scale\\ndef max(): return 2.5', m.__dict__)"),
    "elif without else": program(
        "return s + self.Q[self.transition(int(s) % 2), 1] + 1",
        more="def transition(self, action):\n    if action == 0:\n        return 3\n    elif action == 1:\n        return 4", **Q),
    "flags and numbers": program(
        "k = 1\nk += 0.5\nflag = (s > 3) == (s > 1)\nboth = (s > 3) & (s < 5) | flag\nneither = not flag\n"
        "return 0.5 * s + k + np.float64(s) % 2 + (1 if neither else 2) + (1 if both else 0) + (2 if self.word == 'abc' else 0)",
        more="word: str = 'abc'"),
    "whole fields and a picture": program(
        "return self.g(s) + h(np.zeros((2, 3), np.uint8))", "n: int", "2",
        before="def h(picture): return len(picture)", more="def g(self, x): return 0.5 * x + self.n"),
    "modulo": program("return (-7 + int(s)) // 3 + (-7 - int(s)) % 3 + (s + 1) % 5"),
}  # fmt: skip
"""Programs that are to compile, and to be the same."""

RAISE = {
    "exp": program("self.Q[0, 0] += 1.0\nreturn math.exp(self.Q[0, 0])", **Q),
    "exp by its name": program("return s + 1 + 0 * exp(s)", before="from math import exp"),
    "late exp": program("return s + math.exp(s * 0.1) if s < 0 else s + 1 + 0 * math.exp(s * 0.9)"),
    "int of nan": program("return int(s + 1 if s < 700 else s * math.nan) + 0.0"),
    "int of inf": program("return int(s + 1 if s < 700 else s * math.inf) + 0.0"),
    "round": program("return s + 1 + 0 * round(s if s < 700 else math.nan)"),
    "normal": program("return s + 1 + 0 * rng.normal(0.0, 700 - s)"),
    "normal with a deviation of -0.0": program("return s + 1 + 0 * rng.normal(0.0, 1.0 if s < 700 else -0.0)"),
    "exponential": program("return s + 1 + 0 * rng.exponential(700 - s)"),
    "integers": program("return s + 1 + 0 * rng.integers(0, 700 - int(s))"),
    "integers of a range that is turned round": program("return s + 1 + 0 * rng.integers(0, 5 - 10 * int(s > 700))"),
    "integers below": program("return s + 1 + 0 * rng.integers(700 - int(s))"),
    "poisson": program("return s + 1 + 0 * rng.poisson(700 - s if s > 695 else 5.0)"),
    "binomial": program("return s + 1 + 0 * rng.binomial(700 - int(s) if s > 695 else 5, 0.5)"),
    "binomial probability": program("return s + 1 + 0 * rng.binomial(5, s / 700)"),
    "choice": program("return s + 1 + 0 * rng.choice(700 - int(s))"),
    "choice of nothing": program("return s + 1 + rng.choice(np.flatnonzero(self.Q[:, 0] + 700 > s))", **Q),
    "choice with a negative probability": program("return s + 1 + rng.choice(2, p=(0.5, 0.5) if s < 700 else (1.5, -0.5))"),
    "choice with a probability too many": program("n = 3 - int(s < 700)\nreturn s + 1 + rng.choice(2, p=np.ones(n) / n)"),
    "choice with probability nan": program("return s + 1 + rng.choice(2, p=[0.5, 0.5 if s < 700 else math.nan])"),
    "choice with probabilities of more than 1": program("return s + 1 + rng.choice([1], p=[1.0 if s < 700 else 1.000001])"),
    "choice of nothing with probabilities": program("p = np.ones(int(s < 700))\nreturn s + 1 + rng.choice(len(p), p=p)"),
    "uniform": program("return s + 1 + 0 * rng.uniform(0, 700 - s)"),
    "endless uniform": program("return s + 1 + 0 * (rng.uniform(0, 1 if s < 700 else math.inf) > 0)"),
    "division by zero": program("return s + 1 + 0 * 1 / (700 - s)"),
    "modulo of zero": program("return s + 1 + 0 * (5 % (700 - int(s)))"),
    "zero to a negative power": program("return s + 1 + 0 * (700 - s) ** -1"),
    "power too large": program("return s + 1 + 0 * 10.0 ** s"),
    "normals with a negative deviation": program("return s + 1 + 0 * rng.normal(0.0, 700 - s, 3)[0]"),
    "negative shift": program("return s + 1 + 0 * (1 << (40 - int(s) if s > 20 else 1))"),
    "index": program("self.Q[int(s / 70), 0] += 1\nreturn s + 1", **Q),
    "index of an array that is made": program("a = np.append(self.Q[:, 0], s)\nreturn s + 1 + a[int(s / 70)]", **Q),
    "second index": program("self.Q[0, int(s / 350)] += 1\nreturn s + 1", **Q),
    "row index": program("q = self.Q[3]\nq[int(s / 350)] += 1\nreturn s + 1", **Q),
    "assertion": program("assert s < 700, 'too late'\nreturn s + 1"),
    "field assigned": program("if s > 700: self.x = 3.0\nreturn s + 1"),
    "error of the author": program("if s > 700: raise ValueError('late')\nreturn s + 1"),
    "list index": program("a = [1.0, 2.0]\nreturn s + a[int(s / 350)]"),
    "tuple index": program("return s + (1, 2)[int(s / 350)]"),
    "argmax of nothing": program("return s + 1 + np.argmax(self.Q[int(s / 70):, 0])", **Q),
    "largest of nothing": program("return s + 1 + self.Q[int(s / 70):, 0].max()", **Q),
    "largest as NumPy has it": program("return s + np.max(self.Q, 2)", **Q),
    "of another shape": program("a = np.zeros(3)\nb = np.zeros(2 + int(s < 700))\nreturn s + 1 + (a + b)[0]"),
    "unset, after a line that may be": program(
        "for j in range(1): self.Q[0] = 0.5\nfor j in range(int(self.N[0]) % 3): self.N[0] *= 1\nk = j\nu -= 1.0\nreturn 7",
        "Q: np.ndarray\n    N: np.ndarray", "np.zeros((4, 2)), np.ones(4, np.int64)"),
    "misspelt": program("return s + self.y"),
    "unknown name": program("return s + unknown"),
}  # fmt: skip
"""Programs that end with an error, soon or late."""

SURPRISES = {
    "events with a large mean": program("return 0.5 * s + rng.poisson(10.0) + rng.binomial(31, 0.5)"),
    "choice with a sum that NumPy just allows": program("return 0.5 * s + rng.choice(2, p=(0.5, 0.500000012))"),
    "whole to a negative power": program("k = int(s)\nreturn 10 ** -k + s + 1"),
    "three to 101": program("return 3 ** (101 + int(s) * 0) % 7 + s"),
    "large power late": program("return 3 ** int(s / 10) % 7 + s + 1"),
    "the largest of two zeros": program("self.Q[0] = -0.0, 0.0\nreturn s + 1 + math.copysign(1, self.Q[0].max())", **Q),
    "the smallest of two zeros": program("self.Q[:] = -0.0\nself.Q[3, 1] = 0.0\nreturn s + 1 + math.copysign(1, np.min(self.Q))", **Q),
    "the sign of a late NaN": program("x = math.inf - math.inf if s > 700 else 1.0\nreturn s + 1 + 0.25 * math.copysign(1.0, x)"),
    "a wide range": program(
        "low = -9223372036854775807 if s > 700 else 9223372036854775000\nn = 0\nfor k in range(9223372036854775807, low, -2):\n"
        "    n += 1\n    if n > 5: break\nreturn s + 1 + 0.25 * n"),
    "a range down to the least number": program(
        "low = -9223372036854775807 - 1 if s > 700 else -5\nn = 0\nfor k in range(0, low, -1):\n    n += 1\n    if n > 9: break\nreturn s + 1 + 0.25 * n"),
    "a range of wide steps": program(
        "low = -9223372036854775807 - 1 if s > 700 else -5\nn = 0\nfor k in range(0, low, -1 - int(self.N[0])):\n    n += 1\n    if n > 9: break\n"
        "return s + 1 + 0.25 * n", **N),
    "the length of a wide range": program(
        "low = 2 if s < 700 else -9223372036854775807\nreturn s + 1 + len(range(low, 9223372036854775807)) % 4"),
    "sum": program("return s + 9007199254740993", start="2**62"),
    "product": program("return s * 3 + 1 if s < 10 ** 400 else 1", start="1"),
    "generator of numbers": program("return (s * 6364136223846793005 + 1442695040888963407) % 2 ** 64", start="1"),
    "shift": program("return s + (1 << 64) % 3 if s > 2 else s + 1", start="0"),
    "int of a large number": program("return int(1e19 + s) % 7 + s"),
    "whole against real": program("x = 2.0 ** 53\nreturn s + 1 + (s + 9007199254740500 > x)", start="0"),
    "real against whole": program("x = 2.0 ** 53\nreturn s + 1 + (x < s + 9007199254740500)", start="0"),
    "whole against real, below zero": program("x = -(2.0 ** 53)\nreturn s - 1 - (s - 9007199254740500 < x)", start="0"),
    "int of a large negative number": program("return int(-1e16 * s) % 7 + s + 1"),
    "power of a negative number": program("return (-3) ** min(s // 20, 40) % 7 + s + 1", start="0"),
    "large division": program("return int((s + 2 ** 60) / 3 % 7 // 1)", start="1"),
    "complex": program("x = (-5.0 - s) ** 0.5\nreturn s + 1"),
    "numpy's zero": program("return s + 1 + 0 * (self.Q[0, 0] / self.Q[0, 1] > 1)", **Q),
    "sum of whole numbers": program("return sum([2 ** 62 + s, 2 ** 62 + s]) % 7 + s", start="0"),
    "largest of booleans": program("a = np.array([s > 3, s > 700])\nreturn s + 1 if a.max() else s + 2"),
    "largest of a list": program("return s + np.max([1.5, 0.5]) + np.min((1, 2))"),
    "largest of rows": program("self.Q[0] += 0.5\nreturn s + np.max(self.Q, axis=0)[1] + self.Q.min(1)[0]", **Q),
    "largest by name": program("return s + np.max(a=self.Q) + 1", **Q),
    "nothing returned": program("k = self.act(s)\nreturn s + 1 if k is None else s + k", more="def act(self, s):\n    if s < 500: return 2"),
    "sum in an array": program("self.N[0] += 2 ** 61\nreturn self.N[0] % 7 + 0 * s", **N),
}  # fmt: skip
"""Programs in which Python goes on where machine code cannot."""

REFUSED = {
    "state becomes a list": (program("return [s[0] + 1, s[1]]", start="(0, 1)"), ""),
    "unset on a rare path": (program("if s > 290: y = 1.0\nif s < 600: y = 2.0\nreturn s + y"), "y"),
    "unset at first": (program("if rng.random() < 0.99: y = 1.0\nreturn s + y"), "y"),
    "unset after a loop": (program("for i in range(int(s)): pass\nreturn s + 1 + i"), "i"),
    "overridden field": (program("return s + self.x").replace("thing = T", "class H(T):\n    __slots__ = ()\n    x = 5.0\nthing = H"), "x"),
    "attribute of an instance": (program("return s + self.k", more="k = 1.0").replace("thing = T(1.5)", "class H(T): pass\nthing = H(1.5)\nthing.k = 7.0"), "k"),
    "float32 array computed with": (program("a = np.ones(2, np.float32)\nb = a * 0.1\nself.Q[0, 0] = 1.0\nreturn s + b.sum()", **Q), "float32"),
    "float32 summed": (program("a = np.full(2, 0.1, np.float32)\nreturn s + a.sum()"), "float32"),
    "float32 by function": (program("a = np.full(2, 0.1, np.float32)\nreturn s + np.max(a)"), "float32"),
    "filled with real numbers": (program("a = np.full(2, s if s < 900 else math.nan, dtype=int)\nreturn s + 1 + a[0] % 2"), "puts a real number"),
    "array like one of whole numbers": (program("a = np.full_like(self.N, s)\nreturn s + 1 + a[0] % 2", **N), "puts a real number"),
    "whole numbers made of real ones": (program("a = np.array([s, 1.0], dtype=int)\nreturn s + 1 + a[0] % 2"), "puts a real number"),
    "array of real numbers put in": (program("self.N[:2] = self.N[2:4] * 0.5\nreturn s + 1 + self.N[0]", **N), "puts a real number"),
    "whole numbers in place by real ones": (program("self.N[:] *= 0.5\nreturn s + 1 + self.N[0]", **N), "in place by real ones"),
    "choice of a row": (program("return 0.5 * s + rng.choice(self.Q)[0]", **Q), "rng.choice is compiled only for one draw"),
    "choice without putting back": (program("return 0.5 * s + rng.choice(9, None, False)"), "rng.choice is compiled only for one draw"),
    "bytes filled": (program("a = np.zeros(2, np.uint8)\na.fill(200)\nreturn s + len(a)"), "computes with numbers of type uint8"),
    "filled in place with real numbers": (program("self.N.fill(s)\nreturn s + 1 + self.N[0] % 2", **N), "puts a real number"),
    "too large for a byte": (program("a = np.zeros(2, np.uint8)\na[0] = int(s) % 300\nreturn s + 1"), "uint8"),
    "negative byte": (program("a = np.zeros(2, np.uint8)\na[0] = -1 if s > 700 else 1\nreturn s + 1"), "uint8"),
    "just too large for some bytes": (program("a = np.zeros(2, np.uint8)\na[0] = 128\nreturn s + len(a)"), "may not fit in an array of uint8"),
    "float32 alone": (program("return s + np.float32(0.1)"), "computes with numbers of type float32"),
    "whole number of a type of NumPy's": (program("return s + np.int64(s) % 3 + 1"), "use int()"),
    "power of whole numbers in place": (program("self.N[:] **= 2\nreturn s + 1 + self.N[0]", **N), "in place by real ones"),
    "list of tuples": (program("k = [(1, 2), (2, 3)]\nreturn s + k[1][0]"), "list of other things than numbers"),
    "list of rows": (program("k = [self.Q[0], self.Q[1]]\nreturn s + 1 + k[1][0]", **Q), "list of other things than numbers"),
    "put where indices say": (program("self.Q[0, np.array([0, 1])] = 2.0\nreturn s + 1 + self.Q[0, 1]", **Q), "picks"),
    "texts joined": (program("k = 'abc'\nif s > 3: k = 'b'\nk = k + 'd'\nreturn s + len(k)"), "it makes text"),
    "too large a number left out": (program("return s + S(1.0).x", before="class S(NamedTuple):\n    x: float\n    k: int = 2**63"), "it makes a S without k"),
    "float32 made": (program("a = np.zeros(2, np.float32)\na[0] = 0.1 + s\nreturn float(a[0])"), "float32"),
    "flat": (program("self.Q.flat[3] = 1.0\nreturn s + self.Q.flat[2]", **Q), "it uses .flat"),
    "strict zip": (program("for k, q in zip(range(9), self.Q[:, 0], strict=True): s = k + q - 0.5 * s\nreturn s", **Q), "it calls zip with strict"),
    "matrices of two types": (program("return 0.5 * s + (np.ones((2, 2)) @ np.ones(2, np.int64))[0]"), "it multiplies matrices of whole numbers, or of two types"),
    "matrices of whole numbers": (program("return 0.5 * s + (np.ones((2, 2), np.int64) @ np.ones((2, 2), np.int64))[0, 0]"), "it multiplies matrices of whole numbers, or of two types"),
    "decorator that passes all on": (
        program("return self.g(s)", more="@passing\ndef g(self, s): return 0.5 * s + 1", before="def passing(f):\n    def g(*a): return f(*a)\n    return g"),
        "it calls a function with *, as a decorator may"),
    "mask": (program("m = self.Q[:, 0] > 1\nreturn s + self.Q[m].sum()", **Q), "picks"),
    "array of another shape in place": (program("x = np.zeros(3)\nx += np.ones((3, 3))\nreturn s + x[0]"), "place"),
    "overlap": (program("self.N[1:] += self.N[:-1] + 1\nreturn s + self.N[8]", **N), "place"),
    "not of a boolean": (program("flag = s > 3\nreturn s + 1 if ~flag else s + 2"), "True and False"),
    "sum of booleans": (program("a = np.array([True, True])\nreturn s + (a[0] + a[1])"), "True and False"),
    "flag and number": (program("k = 1 if s < 700 else s > 3\nreturn s + k"), "True or False and for numbers"),
    "range with a star": (program(
        "low = (0, -9223372036854775807 - 1, -1) if s > 700 else (0, -5, -1)\nn = 0\nfor k in range(*low):\n    n += 1\n    if n > 9: break\n"
        "return s + 1 + 0.25 * n"), "a star"),
    "number, late a flag": (program("k = 1\nif s > 700: k = s > 3\nreturn s + k"), "True or False and for numbers"),
    "flag or number returned": (program("return s + g(s)", before="def g(s):\n    if s > 700: return True\n    return 2"), "True or False"),
    "minus a flag": (program("flag = s > 3\nreturn s + 1 + -flag"), "True and False"),
    "product of flags": (program("a = np.array([s > 3, True])\nreturn s + 1 + (a * a)[0]"), "True and False"),
    "is True": (program("return s + 1 if (self.Q[0, 0] > -1) is True else s + 2", **Q), "is"),
    "round to decimals": (program("return round(s + 0.15, 1)"), "decimals"),
    "a draw of another kind": (program("return s + rng.gamma(2.0)"), "it uses rng's gamma"),
    "recursion": (program("return g(int(s) % 40) + s + 1", before="def g(n): return 0 if n == 0 else 1 + g(n - 1)"), "it calls itself"),
    "two that call each other": (
        program("return g(int(s) % 9) + s + 1", before="def g(n): return 0 if n == 0 else h(n - 1)\ndef h(n): return 1 if n == 0 else g(n - 1)"), ""),
    "global array written": (program("A[0] += 1\nreturn s + A[0]", before="A = np.zeros(2)"), "an array that is not its own"),
    "array of a class in tuples written": (program("self.A[1][0][0] += 1\nreturn s + self.A[1][0][0]", more="A = (1, (np.zeros(2),))"), "an array that is not its own"),
    "comparison by is": (
        program("x = C.G if s > 3 else C.R\nreturn s + 1 if x is C.R else s + 2", before="class C(enum.Enum):\n    R = 1\n    G = 2"), "compares with 'is'"),
    "enum against a number": (program("return s + 1 if int(s) == C.R else s + 2", before="class C(enum.Enum):\n    R = 1"), "Numba has no eq"),
    "real in an array of whole numbers": (program("self.N[0] += 0.5\nreturn s + self.N[0]", **N), "whole"),
    "lambda": (program("return s + max(range(2), key=lambda a: self.Q[0, a])", **Q), "a lambda"),
    "list of all kinds": (program("k = [1.0, 2, 'x'][0]\nreturn s + k"), "a list of other things"),
    "array left out of a state": (program("return s + S(1).q[0]", before="class S(NamedTuple):\n    x: int\n    q: np.ndarray = np.zeros(2)"), "it makes a S without q"),
    "kept in a name": (program("f = math.exp\nreturn f(900) if s > 700 else s + 1"), None),
}  # fmt: skip
"""Programs that are not to be compiled, and a word of the sentence that says why."""

RARE = [
    "median with nan", "where it is not zero", "arrays of draws", "choices", "any and all", "draws", "clip",
    "types of Python for arrays", "filled with whole numbers", "bounds of bytes and of what is left out",
    "binomial probability", "binomial", "poisson", "of another shape", "argmax of nothing",
    "normals with a negative deviation", "integers of a range that is turned round", "list index", "endless uniform",
    "choice with a probability too many", "choice with probability nan", "choice with probabilities of more than 1",
    "largest of booleans", "large power late", "power of a negative number",
    "events with a large mean", "sum of whole numbers", "texts joined", "matrices of whole numbers",
    "matrices of two types", "comparison by is", "float32 summed", "float32 array computed with",
    "row in place", "picture of bytes", "power too large", "largest by name", "whole fields and a picture",
    "array functions", "draws with defaults", "largest and smallest", "parts in place", "the smallest of two zeros",
    "whole power", "choice of nothing with probabilities", "power of infinity", "power of minus one",
]  # fmt: skip
"""Programs of all these kinds with which slow tests only are concerned."""
