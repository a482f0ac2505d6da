"""What holds for the experiments of every lesson."""

import threading

import pytest

from edugym.lessons import lesson_names, load_experiments

CLAIMS = {
    "loop": 14,
    "on_off_policy": 18,
    "depth": 20,
    "dimensionality": 25,
    "memory": 19,
    "signal": 24,
    "continuous_actions": 20,
    "stochasticity": 15,
    "model_based": 20,
    "own_problem": 25,
}
"""How many claims a lesson makes at least; those of exploration have a test of their own."""


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
    assert len(claims) >= CLAIMS[lesson]
