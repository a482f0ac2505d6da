"""The isolation matrix: what its page says follows from what was measured, and the clearest of its cells are true."""

import json
import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import isolation
import numpy as np
import other_measures
import pytest

import edugym
from edugym import DQN, FrameStack, QLearning, SARSALambda, mean_interval
from edugym.experiments.profiles.ladders import LADDERS
from edugym_course import agent_profiles
from edugym_course.remedies import REMEDIES, gain


def test_the_data_are_those_of_the_profiles(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Else run docs/isolation.py --measure: here all that it measures is what the data say, so that nothing changes."""
    data = json.loads(isolation.DATA.read_text(encoding="utf-8"))
    stored = agent_profiles.load()
    assert stored is not None

    def scores(label: str, name: str) -> Any:
        if label == "Frames":
            return stored.scores("QLearning", name) + data["gains"]["memory: 4 frames"][name]
        remedy = next(one for one in REMEDIES if name in data["gains"][one.name])
        return stored.scores(remedy.agent, name) - data["gains"][remedy.name][name]

    asked = []

    def profile(agents: dict[str, Any], *, challenges: list[str], **how: Any) -> Any:
        asked.append((agents, challenges))
        return SimpleNamespace(scores=scores)

    monkeypatch.setattr(isolation, "other_measures", lambda: data["others"])
    monkeypatch.setattr(isolation, "UNFINISHED", tmp_path / "unfinished")
    isolation.UNFINISHED.mkdir()
    monkeypatch.setattr(edugym, "profile", profile)
    found = isolation.measure()
    assert asked == [({label: agent}, [on]) for label, them in isolation.MEASURED.items() for on, agent in them.items()]
    assert found["base"] == pytest.approx(data["base"], abs=1e-4)
    assert found["gains"].keys() == data["gains"].keys()
    for name, gains in found["gains"].items():
        assert gains.keys() == data["gains"][name].keys()
        assert all(np.allclose(rungs, data["gains"][name][on], atol=1e-9) for on, rungs in gains.items()), name


def made(own: float, other: float, harder: float) -> dict[str, Any]:
    """Data in which Go-Explore gains `own` on Boulder and `other` on Study, there `harder` more on the harder half."""
    noise = np.linspace(-0.01, 0.01, 10)
    study = np.array([[other - harder / 2]] * 3 + [[other + harder / 2]] * 3) + noise
    boulder = np.full((6, 1), own) + noise
    gains = {"exploration: Go-Explore": {"Boulder": boulder.tolist(), "Study": study.tolist()}}
    return {"versions": "", "base": {"Boulder": 0.4, "Study": 0.6}, "gains": gains}


@pytest.mark.parametrize(
    ("data", "own", "others", "strengths"),
    [
        (made(0.5, 0.0, 0.0), "whole interval above", 0, 0),
        (made(0.1, 0.0, 0.0), "**not above**", 0, 0),
        (made(0.5, -0.3, 0.0), "whole interval above", 1, 0),
        (made(0.5, 0.0, 0.4), "whole interval above", 0, 1),
        (made(0.5, 0.3, -0.4), "whole interval above", 1, 1),
    ],
)
def test_findings_follow_from_the_data(data: dict[str, Any], own: str, others: int, strengths: int) -> None:
    """What is so, and what is not."""
    found = isolation.findings(data)
    assert own in found.own[0]
    assert [len(found.others), len(found.strengths)] == [others, strengths]
    assert ("does not raise" in found.follows[0]) == ("not" in own)


def test_what_other_measures_say_follows_from_the_data() -> None:
    """Each number stands beside what it was measured for."""
    names = [f"{name}: {what}" for name in other_measures.GOLF for what in ("spread", "worst", "mean")]
    others = {name: [[k / 100, k / 100 + 0.02]] * 7 for k, name in enumerate(names)}
    others |= {"Roadrunner": [[-0.1, -0.1], [0.2, 0.2], [0.3, 0.3], [0.4, 0.4]], "Catch": [[-0.5, -0.5]]}
    others[other_measures.LIT] = [[0.7, 0.7], [0.8, 0.8], [0.9, 0.9]]
    text = " ".join(" ".join(other_measures.by_other_measures(others)).split())
    for part in ("adds 0.10 [0.10, 0.10] at -10", "saves 0.40 [0.40, 0.40] at -300", "+0.90 [0.90, 0.90] at 8"):
        assert part in text
    assert re.search(r"risk of -1, the spread .* by \+0.01 .* worst tenth by \+0.02 .* mean by \+0.03", text)
    assert "DQN needs 0.50 [0.50, 0.50] more of the budget than the table" in text


@pytest.mark.slow
def test_sarsa_saves_while_it_learns_where_a_fall_is_dear() -> None:
    """And costs where it is cheap."""
    assert mean_interval(other_measures.saved_while_learning(-300.0)).low > 0.1
    assert mean_interval(other_measures.saved_while_learning(-10.0)).high < -0.2


@pytest.mark.parametrize(
    ("name", "strength", "n_steps", "base", "remedy"),
    [
        ("MemoryCorridor", 2, 4_900, QLearning.create, (QLearning.create, lambda mdp: FrameStack.create(mdp, 2))),
        pytest.param("Study", 80, 20_000, QLearning.create, SARSALambda.create, marks=pytest.mark.slow),
        pytest.param("Boulder", 20, 20_000, QLearning.create, edugym.GoExplore.create, marks=pytest.mark.slow),
        ("Supermarket", 2_000, 2_000, QLearning.create, edugym.DynaQ.create),
        pytest.param("Switches", 6, 10_000, DQN.create, edugym.HindsightDQN.create, marks=pytest.mark.slow),
    ],
)
def test_an_environments_own_remedy_gains_there(
    name: str, strength: float, n_steps: int, base: Any, remedy: Any
) -> None:
    """More than 0.2 on one rung, with the whole interval; paired with the agent without the remedy."""
    ladder = next(ladder for ladder in LADDERS if ladder.name == name)._replace(strengths=(strength,), n_steps=n_steps)
    found = edugym.profile({"base": base, "remedy": remedy}, challenges=[ladder], repetitions=5)
    gains = found.scores("remedy", name) - found.scores("base", name)
    assert gain(gains).low > isolation.OWN


def test_what_a_report_says_helps_is_what_was_measured() -> None:
    """In MemoryCorridor, where no agent by itself is good."""
    data = json.loads(isolation.DATA.read_text(encoding="utf-8"))
    alone = data["base"]["MemoryCorridor"]
    with_frames = alone + gain(data["gains"]["memory: 4 frames"]["MemoryCorridor"]).estimate
    helps = next(ladder for ladder in LADDERS if ladder.name == "MemoryCorridor").words.helps
    assert re.findall(r"\d\.\d", helps) == [f"{alone:.1f}", f"{with_frames:.1f}"]
