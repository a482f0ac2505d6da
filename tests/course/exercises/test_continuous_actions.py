"""The exercises of lesson 7: what counts as a mistake is one, and the challenge is worth its points."""

from typing import Any

import pytest

from edugym_course.lessons.continuous_actions.exercises import episodes
from edugym_course.lessons.continuous_actions.exercises.episodes import cases
from tests.course.lessons.answers import solution


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
