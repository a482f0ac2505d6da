"""The page of the agents: it says what the stored profiles say, and which parts are missing."""

import agents
import pandas
import pytest

from edugym import Profile
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.scores import COLUMNS
from edugym_course import agent_profiles

LADDER = LADDERS[0]._replace(strengths=(8, 10))


@pytest.mark.parametrize(
    ("scores", "cells"),
    [
        ((1.0, 1.0), ("**1.00 ± 0.00**", "never", "good 1.00 (of 1 tried)")),
        ((1.0, 0.0), ("**0.50 ± 0.00**", "8–10", "good 0.50 (of 1 tried)")),
        ((0.4, 0.4), ("0.40 ± 0.00", "at once", "nobody of 1 tried is good: no score is above 0.40")),
        ((-0.1, 0.0), ("-0.05 ± 0.00", "at once", "nobody of 1 tried is better than random play")),
    ],
)
def test_the_page_says_what_the_profile_says(scores: tuple[float, float], cells: tuple[str, str, str]) -> None:
    """The score, in bold for who is to be taken; where it breaks; whom to take; and who cannot enter, and why."""
    rows = [
        dict.fromkeys(COLUMNS, 0.0)
        | {"agent": "good", "challenge": "Boulder", "strength": strength, "repetition": k, "score": score}
        for strength, score in zip(LADDER.strengths, scores, strict=True)
        for k in range(3)
    ]
    profile = Profile(
        pandas.DataFrame(rows), (LADDER,), ("good", "blank", "new"), {"blank": {"Boulder": "it is afraid"}}
    )
    page = agents.page(profile, {"blank": ["Boulder"], "good": ["Golf"]}, "torch 1").replace("\N{NO-BREAK SPACE}", " ")
    score, broken, take = cells
    for line in (
        f"| good | 3 | {score} |",
        f"| good | {broken} |",
        f"| {take} |",
        "| blank | 0 | – |",
        "| new | 0 | ? |",
    ):
        assert line in page
    assert "Boulder, blank: it is afraid." in page
    assert "made from earlier code: good: Golf; blank: everywhere" in page
    assert "measured with torch 1" in page
    assert "Roadrunner has no ladder yet." in page


def test_versions_of_agents_that_were_measured_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    """One line where all were measured with the same; else each line has its agents."""
    versions = {"SARSA": "edugym 1", "QLearning": "edugym 1"}
    monkeypatch.setattr(agent_profiles, "_about", lambda: {"versions": versions})
    assert agent_profiles.made_with() == "edugym 1"
    versions["DQN"] = "edugym 2"
    assert agent_profiles.made_with() == "edugym 2 (DQN); edugym 1 (QLearning, SARSA)"
