"""The exercises of lesson 6: their numbers are the package's, and every mistake is one."""

import numpy as np
import pytest

from edugym_course.lessons.signal import exercises
from edugym_course.lessons.signal.exercises.listener import HEARD, LISTENER_MISTAKES, probabilities
from edugym_course.lessons.signal.moody import best_return
from edugym_course.lessons.signal.words import bits, information


def test_the_number_of_words() -> None:
    """22 words carry 0.4 bit, and 21 do not."""
    assert information(0.1, exercises.WORDS - 1) < exercises.ENOUGH <= information(0.1, exercises.WORDS)


def test_every_mistake_in_a_table_is_one() -> None:
    """In some table it differs from the information, and so the check refuses it."""
    for seed in (0, 1):
        tables = exercises._tables(np.random.default_rng(seed))
        assert all(table.sum() == pytest.approx(1.0) for table in tables)
        assert any((table == 0).any() for table in tables)
        for sentence in exercises.bits_mistakes(tables[0]):
            assert any(abs(exercises.bits_mistakes(table)[sentence] - bits(table)) > 1e-3 for table in tables), sentence


def test_every_mistake_of_a_listener_is_one() -> None:
    """In some case it chooses otherwise; and the last action is never chosen."""
    for sentence, change in LISTENER_MISTAKES.items():
        cases = HEARD
        assert any(not np.allclose(probabilities(case, **change), probabilities(case)) for case in cases), sentence
    for case in HEARD:
        chosen = probabilities(case)
        assert chosen.sum() == pytest.approx(1.0)
        assert case.last < 0 or chosen[case.last] == 0.0


def test_the_optimum_of_the_challenge() -> None:
    """It is planned on the whole state; without moods planning gives the optimum of the toy."""
    assert best_return(0.1, 20) == pytest.approx(exercises.CHALLENGE.optimum, abs=0.01)
    assert best_return(0.0, 20) == pytest.approx(6706.85, abs=0.01)


@pytest.mark.slow
def test_the_challenge() -> None:
    """The vote gets two thirds of the points, and is level with itself."""
    score = exercises.CHALLENGE.score(exercises.CHALLENGE.baselines["majority vote"], "Ada")
    assert score.points == pytest.approx(65, abs=4)
    assert score.best_baseline == "majority vote"
