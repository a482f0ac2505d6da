"""What holds for the experiments of every lesson."""

import ast
import re
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

import edugym_course.lessons
from edugym_course.lessons import lesson_names, load_experiments

CLAIMS = {
    "loop": 15,
    "on_off_policy": 22,
    "depth": 28,
    "dimensionality": 25,
    "memory": 19,
    "signal": 24,
    "continuous_actions": 20,
    "stochasticity": 20,
    "model_based": 27,
    "own_problem": 25,
}
"""How many claims a lesson makes at least; those of exploration have a test of their own."""

NO_SENTENCE = re.compile(
    r"(?i:and|but|nor|or|so|than|then|that|which|who|whose|it|its|they|their|this|these|too|also)\b|[a-z]{2,}"
)
"""What begins a statement that needs the one before it: such a word, or a small letter (but `n = 1` may begin one)."""


def statements() -> Iterator[tuple[str, str]]:
    """Yield file and line of every claim in the code of the lessons, and how its statement begins.

    The beginning is empty where it is computed, as in `f"{method} solves ..."`.
    """
    root = Path(edugym_course.lessons.__path__[0])
    for path in sorted(root.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Claim":
                text = node.args[0]
                begins = text.values[0] if isinstance(text, ast.JoinedStr) else text
                place = f"{path.relative_to(root)}:{node.lineno}"
                if isinstance(begins, ast.FormattedValue):
                    yield place, ""
                else:
                    assert isinstance(begins, ast.Constant), f"{place}: a claim's statement stands in the call"
                    yield place, str(begins.value)


def test_every_claim_is_a_sentence() -> None:
    """It can be understood without the claim above it, as far as its first word tells."""
    found = [*statements()]
    assert len(found) > 150
    assert [(place, statement) for place, statement in found if NO_SENTENCE.match(statement)] == []


@pytest.mark.parametrize("statement", ["and worse at discount 1", "Which costs most", "where it learns", "It stalls"])
def test_what_is_no_sentence(statement: str) -> None:
    """In whatever case its first letter is."""
    assert NO_SENTENCE.match(statement)


@pytest.mark.parametrize(
    "statement", ["n = 1 learns faster", "Where rewards differ, ...", "5 bins", "Italy", "ε-greedy"]
)
def test_what_is_a_sentence(statement: str) -> None:
    """A number, a symbol, a subordinate clause."""
    assert not NO_SENTENCE.match(statement)


@pytest.mark.parametrize("lesson", lesson_names())
def test_a_stopped_lesson_claims_nothing(lesson: str) -> None:
    """Comparisons of incomplete results would mean nothing; finished runs are kept in the folder, if one is given."""
    stop = threading.Event()
    stop.set()
    assert load_experiments(lesson).report(repetitions=2, stop=stop) == ([], [])


@pytest.mark.slow
@pytest.mark.parametrize("lesson", sorted({*lesson_names()} - {"exploration"}))
def test_every_claim_holds(lesson: str) -> None:
    """With other seeds than those that the lesson shows."""
    claims = load_experiments(lesson).report(seed=7).claims
    assert [claim.statement for claim in claims if not claim.holds] == []
    assert [claim.statement for claim in claims if NO_SENTENCE.match(claim.statement)] == []
    assert len(claims) >= CLAIMS[lesson]
