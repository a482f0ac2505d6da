"""The open challenge: seeds from names, scores against what is possible, and slips."""

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import pandas
import pytest

from edugym import QLearning
from edugym.experiments.results.statistics import Interval
from edugym.experiments.results.tables import Results
from edugym_course.grading import WrongAnswer, challenge, seed_from_name
from edugym_course.lessons.exploration.exercises import CHALLENGE, best_average
from tests.course.grading.test_checking import noted_limits
from tests.messages import named


class Systematic(NamedTuple):
    """An explorer that never takes a grip again from which it fell: as good as one can be."""

    fell: Any

    def act(self, state: int, rng: Any) -> int:
        """The first grip from which it did not fall yet."""
        return int(self.fell[state].argmin())

    def learn(self, state: int, action: int, next_state: int) -> None:
        """Remember a fall."""
        if next_state == 0:
            self.fell[state, action] = 1


def systematic(wall: Any) -> Systematic:
    """Make one, from the spaces alone."""
    return Systematic(np.zeros((int(wall.observation_space.n), int(wall.action_space.n)), np.int64))


def test_seeds_from_names() -> None:
    """The same for the same name on every machine, however it is written; others for other names."""
    assert seed_from_name("Ada Lovelace") == seed_from_name("  ada LOVELACE") == 2350958316
    assert seed_from_name(1234567) == seed_from_name("1234567")
    assert len({seed_from_name(f"student {i}") for i in range(1000)}) == 1000
    assert seed_from_name("Zoë") == seed_from_name("Zoe\u0308") != seed_from_name("Zoe")
    refused: list[Any] = ["", "  ", None, 1.5, True, ["Ada"]]
    for name in refused:
        with pytest.raises(ValueError, match="name must"):
            seed_from_name(name)


def test_what_is_trained(monkeypatch: pytest.MonkeyPatch) -> None:
    """The student's agent and all baselines, on ten tasks of the name; the settings are those of the challenge."""
    asked: dict[str, Any] = {}

    def repeat(environment: Any, methods: dict[str, Any], n_steps: int, **how: Any) -> None:
        asked.update(how, environment=environment, methods=[*methods], n_steps=n_steps)
        raise WrongAnswer("enough")

    limits = noted_limits(monkeypatch, challenge)
    monkeypatch.setattr(challenge, "repeat", repeat)
    agent = systematic(CHALLENGE._task(0))
    with pytest.raises(WrongAnswer, match="enough"):
        CHALLENGE.score(lambda wall: agent, "Ada Lovelace")
    assert not agent.fell.any()  # the first steps, by which code that never ends is found, leave nothing in it
    assert limits == [("making your agent", 30.0), ("training your agent", 30.0), ("training your agent", math.inf)]
    settings = {"n_steps": 5_000, "repetitions": 10, "seed": 2350958316, "parameters": {"height": 60}}
    assert asked == {"environment": "Boulder", "methods": ["your agent", *CHALLENGE.baselines], **settings}


@pytest.mark.parametrize(
    ("best", "average", "points"),
    [
        *((4.0, 3.0, 75.0), (4.0, 5.0, 100.0), (4.0, -1.0, 0.0), (4.0, math.nan, 0.0)),
        *((-2.0, -8.0, 25.0), (-2.0, -1.0, 100.0), (-2.0, 0.0, 100.0), (-2.0, math.nan, 0.0)),
    ],
)
def test_points(best: float, average: float, points: float) -> None:
    """The share of the best average; where returns are negative it is divided the other way round."""
    assert replace(CHALLENGE, best_average=best)._points(average) == pytest.approx(points)


@pytest.mark.parametrize(
    ("low", "high", "where"),
    [
        (0.1, 0.7, "ahead of"),
        (-0.1, 0.9, "not clearly apart from"),
        (0.0, 0.0, "not clearly apart from"),
        (-0.9, -0.1, "behind"),
    ],
)
def test_the_table_of_a_score(low: float, high: float, where: str) -> None:
    """As text and in a notebook."""
    ahead = Interval((low + high) / 2, low, high, 10)
    rows = {"possible": (1.0, 0.8), "your agent": (12.5, 0.25)}
    score = challenge.Score("Ada", 62.4, rows, ahead, "novelty", Results(pandas.DataFrame()))
    verdict = f"Ada: 62 of 100 points, {where} novelty (difference {ahead.estimate:+.2f}, "
    verdict += f"95 % interval {low:+.2f} to {high:+.2f})."
    assert repr(score).splitlines()[2:] == ["your agent              12.50                    0.25", "", verdict]
    assert score._repr_markdown_().splitlines()[3:] == ["| your agent | 12.50 | 0.25 |", "", verdict]


def test_what_is_possible() -> None:
    """Checked by hand: a wall of height 1 with 2 grips needs 1 step, or 2; one of height 2 needs 1 + 1 + 1/2 + 2/2."""
    assert best_average(1, 2, 10) == pytest.approx(1 - 1.5 / 10)
    assert best_average(2, 2, 10) == pytest.approx(1 - 3.5 / 10)
    assert best_average(60, 2, 5_000) == pytest.approx(1 - 975 / 5_000)
    assert best_average(60, 2, 100) == 0


def test_an_agent_that_never_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is stopped in its first steps, with one sentence."""

    def act(self: Systematic, state: int, rng: Any) -> int:
        while state < 100:
            pass
        return 0

    endless = type("Endless", (Systematic,), {"__slots__": (), "act": act})
    monkeypatch.setattr(challenge, "LIMIT", 0.5)
    with pytest.raises(WrongAnswer, match=r"training your agent has not ended after 0\.5 seconds"):
        CHALLENGE.score(lambda wall: endless(systematic(wall).fell), "Ada")


@pytest.mark.parametrize(
    ("agent", "says"),
    [
        (None, "Not solved yet"),
        (..., "Not solved yet"),
        (QLearning, "such as QLearning.create, but is the class"),
        (Systematic, "that makes one, but is the class Systematic"),
        (QLearning.create((61, 2)), "that makes a new agent"),
        (3, "a function that makes an agent, but is 3"),
        (lambda wall: None, "gives None: is a `return` missing"),
        (lambda wall: QLearning, "must be an object with the methods act and learn"),
        (lambda wall: QLearning.create(wall, alpha=1), named("QLearning", "alpha")),
        (lambda wall: np.zeros(wall.shape), r"where an array should, which has 'shape': is `\.create` missing"),
        (lambda wall: wall.unwrapped.mdp.grips, "told `observation_space` and `action_space` only, not 'unwrapped'"),
        (lambda wall: QLearning.create((3, 2)), r"must have a table Q of shape \(61, 2\)"),
    ],
)
def test_what_makes_no_agent(agent: Any, says: str) -> None:
    """Each gets its sentence; the task cannot be looked at."""
    with pytest.raises(WrongAnswer, match=says):
        CHALLENGE.score(agent, "Ada")
