"""The exercises of lesson 7: what counts as a mistake is one, and the challenge is worth its points."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from edugym_course.lessons.continuous_actions import exercises
from edugym_course.lessons.continuous_actions.exercises import episodes
from edugym_course.lessons.continuous_actions.exercises.episodes import MISTAKES, after, cases
from edugym_course.lessons.continuous_actions.methods import gaussian
from tests.course.lessons.answers import solution


def test_every_mistake_in_sizes_is_one() -> None:
    """For a case of the check each differs from the right number, and from the others."""
    wrong = exercises._size_mistakes(3, 5, 11)
    assert 2 * 11**3 * 5**3 not in wrong.values()
    assert len(set(wrong.values())) == len(wrong)


@pytest.mark.parametrize("formulas", [exercises.OF_MEAN, exercises.OF_LOG_SPREAD])
def test_every_mistake_in_scores_is_one(formulas: dict[str, Callable[..., float]]) -> None:
    """For the cases of the check each differs from the right formula, and from the others."""
    made = {why: tuple(rule(*case) for case in ((2.0, 0.5, 0.5), (-1.0, 0.2, 2.0))) for why, rule in formulas.items()}
    assert len({tuple(np.round(values, 9)) for values in made.values()}) == len(made)


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_every_mistake_in_updates_is_one(seed: int) -> None:
    """On the episodes of the check each differs from the right update, and from the others."""
    made = {why: [after(case, change) for case in cases(seed)] for why, change in {"": {}, **MISTAKES}.items()}
    numbers = {
        why: tuple(np.round(np.concatenate([np.ravel(part) for pair in pairs for part in pair]), 9))
        for why, pairs in made.items()
    }
    assert len(set(numbers.values())) == len(numbers)


def test_an_answer_is_told_the_whole_episode(monkeypatch: pytest.MonkeyPatch) -> None:
    """The next state and action of a step are those of the step after it; only the last step ends the episode."""
    told: list[dict[str, Any]] = []
    monkeypatch.setattr(episodes, "learn_step", lambda agent, step: told.append(step))
    for case in cases(0):
        told.clear()
        episodes._learned(solution("07_continuous_actions", 3, "MyREINFORCE"), case)
        assert [step["state"] for step in told] == case.states
        assert [(step["next_state"], step["next_action"]) for step in told[:-1]] == [
            (step["state"], step["action"]) for step in told[1:]
        ]
        ends = [(step["terminated"], step["truncated"]) for step in told]
        assert ends == [(False, False)] * (len(told) - 1) + [(case.terminates, not case.terminates)]


def test_the_challenge() -> None:
    """The lesson's agent gets half of the points or so, and every name has its container."""
    score = exercises.CHALLENGE.score(gaussian, "Ada")
    assert 20 < score.points < 80
    widths = {exercises.own_container(seed).container_width for seed in range(20)}
    assert len(widths) == 20
    assert min(widths) >= 0.4
    assert max(widths) <= 0.6


def test_what_is_told_of_a_wrong_entry() -> None:
    """Where it started, where it should be, and what it is."""
    case = episodes.Case(np.zeros(episodes.SHAPE), np.full(episodes.SHAPE[0], 0.5), [2], [1], [1.0], terminates=True)
    right = after(case)
    told = episodes._told(case, right, (right[0], case.V))
    assert told.endswith("V[2] should go from 0.5 to 0.625, but is 0.5")
    wrong = right[1].copy()
    wrong[3] = 1.0
    assert episodes._told(case, right, (right[0], wrong)).endswith("V[3] should stay at 0.5, but is 1")
