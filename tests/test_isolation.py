"""The isolation matrix: what its page says follows from what was measured, and the clearest of its cells are true."""

import importlib.util
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import edugym
from edugym import DQN, FrameStack, QLearning, SARSALambda
from edugym.experiments.profiles.ladders import LADDERS

FILE = Path(__file__).parents[1] / "docs" / "isolation.py"


def loaded() -> Any:
    """The program that writes the page."""
    spec = importlib.util.spec_from_file_location("isolation", FILE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


isolation = loaded()


def test_the_page_is_that_of_the_data() -> None:
    """Else run docs/isolation.py."""
    data = json.loads(isolation.DATA.read_text(encoding="utf-8"))
    assert isolation.PAGE.read_text(encoding="utf-8") == isolation.page(data)


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
    assert isolation.gain(gains).low > isolation.OWN
