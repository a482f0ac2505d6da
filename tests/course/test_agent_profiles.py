"""The stored profiles: what is made again, and when."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import edugym
from edugym.experiments.profiles import profile as profiles
from edugym.experiments.profiles.ladders import LADDERS
from edugym.training.run import Run
from edugym_course import agent_profiles
from edugym_course.stored import what_determines
from tests.course.test_arguments import ARM, LOW
from tests.course.test_commands import run

code_of = agent_profiles.code_of


def test_stored_profiles_and_those_that_are_stale(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Profiles are made for agents whose code has changed, and for no other; what is stored is what was measured."""
    monkeypatch.setattr(agent_profiles, "PATH", tmp_path / "stored.csv")
    monkeypatch.setattr(agent_profiles, "LADDERS", (LOW,))
    monkeypatch.setattr(profiles, "LADDERS", (LOW,))
    agents = {name: getattr(edugym, name).create for name in ("QLearning", "SARSA")}
    monkeypatch.setattr(agent_profiles, "agents", lambda: agents)
    assert agent_profiles.load() is None
    assert agent_profiles.stale() == {"QLearning": [LOW], "SARSA": [LOW]}
    done = run("profile", "--all", "--output", str(tmp_path / "out"))
    assert done.exit_code == 0, done.output
    assert "Made again: QLearning, SARSA." in done.output
    assert agent_profiles.stale() == {}
    stored = agent_profiles.load()
    assert stored is not None
    fresh = edugym.profile({"QLearning": edugym.QLearning.create}, challenges=[LOW])
    assert stored.scores("QLearning", "Boulder") == pytest.approx(fresh.scores("QLearning", "Boulder"), abs=1e-3)
    assert stored.steps("QLearning", "Boulder") == fresh.steps("QLearning", "Boulder")
    monkeypatch.setattr(
        agent_profiles, "code_of", lambda name, ladder: name if name == "SARSA" else code_of(name, ladder)
    )
    assert agent_profiles.stale() == {"SARSA": [LOW]}
    done = run("profile", "QLearning", "--repetitions", "2", "--output", str(tmp_path / "out"))
    assert "No stored profile was made from the present code of SARSA" in done.output
    assert "best other agent" in (tmp_path / "out" / "report.md").read_text()


def test_only_what_has_changed_is_made_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A new ladder alone; who cannot enter is blank, what was there stays, and a new agent has nothing yet."""
    monkeypatch.setattr(agent_profiles, "PATH", tmp_path / "stored.csv")
    monkeypatch.setattr(agent_profiles, "agents", lambda: {"QLearning": edugym.QLearning.create})
    arm = ARM._replace(strengths=(0.9,), n_steps=10)
    shorter = LOW._replace(n_steps=100)
    for ladders, changed in (((LOW,), LOW), ((LOW, arm), arm), ((shorter, arm), shorter)):
        monkeypatch.setattr(agent_profiles, "LADDERS", ladders)
        assert agent_profiles.stale() == {"QLearning": [changed]}
        found = agent_profiles.make_again(agent_profiles.stale(), tmp_path / "unfinished")
        assert agent_profiles.stale() == {}
        assert found.score("QLearning", "Boulder").n == agent_profiles.REPETITIONS
        assert list(found.blank["QLearning"]) == [ladder.name for ladder in ladders[1:]]
    monkeypatch.setattr(agent_profiles, "agents", lambda: {"SARSA": edugym.SARSA.create})
    later = agent_profiles.load()
    assert later is not None
    assert later.agents == ("SARSA",)
    assert later.score("SARSA", "Boulder").n == 0


class Fixed(NamedTuple):
    """An agent that trains itself and scores 1: it knows the way up the wall."""

    environment: Any

    def train(self, n_steps: int, *, evaluate_every: int, evaluation_episodes: int, seed: int) -> Run:
        """A curve of two points."""
        ends = np.array([1.0, 1.0])
        return Run(np.array([0, n_steps]), ends, ends, ends, self, seed, 0.0, True)


def test_stored_profiles_of_libraries(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """They are made by a command of their own, ladder by ladder; what has other code or another version is stale."""
    other = LOW._replace(name="Other")
    monkeypatch.setattr(agent_profiles, "PATH", tmp_path / "stored.csv")
    monkeypatch.setattr(agent_profiles, "LADDERS", (LOW, other))
    monkeypatch.setattr(agent_profiles, "agents", lambda: {"QLearning": edugym.QLearning.create})
    monkeypatch.setattr(agent_profiles, "LIBRARY_AGENTS", {"SB3 DQN": "DQN"})
    monkeypatch.setattr(agent_profiles, "library_agents", lambda: {"SB3 DQN": lambda environment: Fixed(environment)})
    monkeypatch.setattr(agent_profiles, "library_versions", lambda: {"torch": "1"})
    agent_profiles.store("QLearning", [], {"Boulder": code_of("QLearning", LOW)}, {})
    stored = agent_profiles.load()
    assert stored is not None
    assert stored.agents == ("QLearning",)
    assert agent_profiles.stale_of_libraries() == {"SB3 DQN": [LOW, other]}
    agent_profiles.make_again({"SB3 DQN": [LOW]}, tmp_path / "unfinished", jobs=1)
    assert agent_profiles.stale_of_libraries() == {"SB3 DQN": [other]}
    done = run("profile", "--libraries", "--jobs", "1", "--output", str(tmp_path / "out"))
    assert done.exit_code == 0, done.output
    assert "Made again: SB3 DQN." in done.output
    found = agent_profiles.load()
    assert found is not None
    assert found.agents == ("QLearning", "SB3 DQN")
    assert found.score("SB3 DQN", "Boulder") == (1.0, 1.0, 1.0, agent_profiles.LIBRARY_REPETITIONS)
    assert agent_profiles.stale_of_libraries() == {}
    assert agent_profiles.libraries_with() == "torch 1"
    monkeypatch.setattr(agent_profiles, "library_versions", lambda: {"torch": "2"})
    assert agent_profiles.stale_of_libraries() == {"SB3 DQN": [LOW, other]}
    assert agent_profiles.stale_of_libraries(installed=False) == {}
    monkeypatch.setattr(agent_profiles, "library_versions", dict)  # where they are not installed, nobody can tell
    assert agent_profiles.stale_of_libraries() == {}


def test_the_code_of_an_agent_is_its_own_and_that_of_the_task() -> None:
    """Those of two agents, of two tasks and of two sets of rungs differ; what a task only shows does not count."""
    hashes = [code_of(agent, ladder) for agent in ("QLearning", "SARSA") for ladder in (*LADDERS, LOW)]
    assert len({*hashes}) == 2 * (len(LADDERS) + 1)
    assert len(agent_profiles.agents()) > 20
    code = "class Task:\n    def step(self):\n        return {}\n    def info(self):\n        return {}\n"
    shown = [what_determines(code.format(step, info), shown=("info",)) for step, info in ((1, 1), (1, 2), (2, 1))]
    assert shown[0] == shown[1] != shown[2]


def test_what_each_agent_is_in_a_line() -> None:
    """Those of the package and of libraries, and given ones: the first line of a docstring, or that it is yours."""

    class Told:
        """It climbs."""

        @classmethod
        def create(cls, environment: Any) -> "Told":
            return cls()

    class Plain(NamedTuple):
        Q: Any = 0

    abouts = agent_profiles.abouts({"told": Told.create, "wrapped": (Told.create, id), "plain": Plain})
    assert [abouts[label] for label in ("told", "wrapped", "plain")] == ["It climbs.", "It climbs.", "yours"]
    assert all(abouts[name] for name in (*agent_profiles.agents(), *agent_profiles.LIBRARY_AGENTS))
