"""Small programs of the kind that students write, made at random: compiled or interpreted, they come to the same."""

import hypothesis
import pytest
from hypothesis import strategies as st

from tests.compiled.programs import program
from tests.compiled.test_subset import verdicts

NUMBERS = st.sampled_from(
    ["0", "1", "2", "0.5", "-1", "7", "3.0", "100", "1e-3", "s", "t", "k", "self.x", "self.Q[i, 0]"]
)
NUMBERS |= st.sampled_from(["self.N[i]", "len(self.Q)", "rng.random()", "self.Q[i, 1]", "int(rng.integers(0, 5))", "i"])

FUNCTIONS = "abs int float max min round bool math.exp math.sqrt math.log math.floor math.sin np.sqrt np.exp np.floor"


def _more(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    """Expressions of expressions."""
    operators = st.sampled_from(["+", "-", "*", "/", "//", "%", "**", "+", "-", "*", "<<", ">>", "&"])
    functions = st.sampled_from(FUNCTIONS.split())
    compared = st.sampled_from(["<", "<=", "==", "!=", ">", ">="])
    return st.one_of(
        st.builds("({} {} {})".format, inner, operators, inner),
        st.builds("{}({})".format, functions, inner),
        st.builds("{}({}, {})".format, st.sampled_from(["max", "min", "math.atan2", "divmod"]), inner, inner),
        st.builds("({} if {} {} {} else {})".format, inner, inner, compared, inner, inner),
        st.builds("self.Q[{}, {}]".format, inner, inner),
        st.builds("sum([{} for j in range(3)])".format, inner),
        st.builds("g({}, {})".format, inner, inner),
        st.builds("self.m(k={}, s={})".format, inner, inner),
    )


EXPRESSIONS = st.recursive(NUMBERS, _more, max_leaves=5)
TARGETS = st.sampled_from(["t", "k", "self.Q[i, 0]", "self.Q[i, 1]", "self.N[i]", "u", "t", "k"])
SIMPLE = st.one_of(
    st.builds("{} {} {}".format, TARGETS, st.sampled_from(["=", "=", "+=", "-=", "*="]), EXPRESSIONS),
    st.just("self.Q[i] = 0.5 * self.Q[i]"),
    st.just("t, k = k, t"),
)
STATEMENTS = st.one_of(
    SIMPLE,
    st.builds("if {} > {}: {}".format, EXPRESSIONS, EXPRESSIONS, SIMPLE),
    st.builds("for j in range({}): {}".format, st.integers(0, 3), SIMPLE),
    st.builds("for j in range(int(self.N[i]) % 3): {}\nk = j".format, SIMPLE),
)
BODIES = st.builds("\n".join, st.lists(STATEMENTS, min_size=1, max_size=4))
HELPER = "def g(x, y):\n    if x > y:\n        return {}\n    return {}"


@st.composite
def written(draw: st.DrawFn) -> str:
    """A program of a few lines."""
    inner = st.sampled_from(["x", "y", "x + y", "x * 0.5", "x / y", "x ** y", "x // 2", "0", "x % y"])
    body = draw(BODIES)
    begin = f"t = {draw(st.sampled_from(['s', '0', '0.0', '2 * s']))}\nk = 1\ni = int(rng.random() * 4)"
    return program(
        f"{begin}\n{body}\nreturn {draw(EXPRESSIONS)}",
        fields="x: float\n    Q: np.ndarray\n    N: np.ndarray",
        values=f"{draw(st.sampled_from(['1.5', '2', '0.1']))}, np.zeros((4, 2)), np.ones(4, np.int64)",
        before=HELPER.format(draw(inner), draw(inner)),
        start=draw(st.sampled_from(["0.0", "1", "0.5"])),
        more="def m(self, s, k, beta=0.5):\n    return s * beta + k",
    )


def run(programs: list[str]) -> None:
    """Most of them compile; every one gives the same results, or stops with the same error at the same line."""
    found = verdicts(programs)
    wrong = [(source, verdict["seen"]) for source, verdict in zip(programs, found, strict=True) if not verdict["same"]]
    assert not wrong, "\n".join(f"{source}\n{seen}" for source, seen in wrong)
    assert sum(verdict["compiled"] for verdict in found) >= len(programs) // 10


FIFTY = st.lists(written(), min_size=50, max_size=50, unique=True)  # else the simplest, fifty times
GENERATE = [hypothesis.Phase.generate]
long_reports = pytest.mark.filterwarnings("ignore:Generating overly large repr")  # it would hide the difference


@long_reports
@hypothesis.settings(max_examples=4, phases=GENERATE)
@hypothesis.given(FIFTY)
def test_two_hundred_random_programs(programs: list[str]) -> None:
    """The same in every run of the tests."""
    run(programs)


@pytest.mark.slow
@long_reports
@hypothesis.settings(max_examples=10, phases=GENERATE, derandomize=False)
@hypothesis.given(FIFTY)
def test_hundreds_of_random_programs(programs: list[str]) -> None:
    """Others in every run."""
    run(programs)
