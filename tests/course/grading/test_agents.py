"""What an answer must be before it is tried: each thing that it is not has its sentence."""

from collections import namedtuple
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import Unsolved, WrongAnswer
from edugym_course.grading.agents import (
    agent_created_by,
    agent_made_by,
    agent_with_table,
    learn_step,
    require_class,
    require_function,
    with_settings,
)

STEP = {"state": 1, "action": 0, "reward": 2.0, "next_state": 3, "next_action": 1, "terminated": True}


class Player(NamedTuple):
    """A student's agent."""

    Q: Any
    rate: float = 0.5

    def act(self, state: int, rng: Any) -> int:
        """Do nothing."""
        return 0

    def learn(self, reward: float, state: int) -> None:
        """Take the reward for the value."""
        self.Q[state] = reward


class Plain:
    """A student's agent that is no named tuple, and takes whatever settings there are."""

    rate = 0.5

    def __init__(self, w: Any = None, **settings: float) -> None:
        """Keep the table."""
        self.w = w

    def learn(self) -> None:
        """Learn nothing."""


SIZE, RATE = (3, 2), {"rate": 0.25}
REFUSED: list[tuple[Callable[[], Any], str]] = [
    (lambda: require_class("Mine", Player(None)), "Mine should be the class itself, but is of the type Player"),
    (lambda: require_class("Player", Player(0)), r"the class itself, but is what Player\(...\) makes: leave"),
    (lambda: require_function("f", Player, "a list"), "f should be a function of a list, but is the class Player"),
    (lambda: require_function("f", 2.0, "a list"), "f should be a function of a list, but is of the type float"),
    (lambda: agent_made_by("mine(task)", lambda task: None, None), "is a `return` missing"),
    (lambda: agent_made_by("mine(task)", lambda task: Player, None), r"gives the class Player: write Player\.create"),
    (lambda: agent_made_by("mine(task)", lambda task: object(), None), "of the type object, has no `act`"),
    (lambda: agent_made_by("mine(task)", lambda task: 1 / 0, None), "raises ZeroDivisionError"),
    (
        lambda: agent_created_by("A", Player, "wall", None),
        "A should keep its method `create`, which makes a new agent for a wall",
    ),
    (lambda: agent_created_by("Q", QLearning, "wall", SIZE, {"speed": 1}), "no setting 'speed'; it has learning_rate"),
    (lambda: with_settings("A", Player(0), {"speed": 1.0}, "learn"), "`speed`, from which `learn` reads the number"),
    (lambda: agent_with_table("A", Player, SIZE, RATE, "w"), "keep its field `w`, the table that `learn` changes"),
    (lambda: agent_with_table("A", Player, SIZE, {"speed": 1.0}), "A should keep its field `speed`"),
    (lambda: agent_with_table("A", namedtuple("Table", "Q"), SIZE, {}), "^A should have a method `learn`$"),
]


@pytest.mark.parametrize(("make", "says"), REFUSED)
def test_what_is_no_agent(make: Callable[[], Any], says: str) -> None:
    """No class, no function, something without a method, a field that is gone, a setting that there is not."""
    with pytest.raises(WrongAnswer, match=says):
        make()


def test_agents_and_placeholders() -> None:
    """Settings are given to a named tuple and a plain object; a placeholder is not solved yet."""
    require_class("Mine", Player)
    require_function("f", len, "a list")
    for make in (partial(require_class, "Mine", ...), partial(require_function, "f", None, "a list")):
        with pytest.raises(Unsolved):
            make()
    for agent in (Player(None), Plain()):
        assert with_settings("Mine", agent, RATE, "learn").rate == 0.25
    assert agent_with_table("Player", Player, SIZE, RATE).Q.shape == SIZE
    assert agent_with_table("Plain", Plain, SIZE, RATE, "w").w.shape == SIZE
    assert isinstance(agent_created_by("QLearning", QLearning, "wall", SIZE), QLearning)
    assert agent_created_by("QLearning", QLearning, "wall", SIZE, {"learning_rate": 0.25}).learning_rate == 0.25


def test_a_step_is_told_by_names() -> None:
    """In whatever order `learn` has them; a name that there is not is refused."""
    player = Player(np.zeros(4))
    assert learn_step(player, STEP) == "learn(reward=2, state=1)"
    assert player.Q.tolist() == [0.0, 2.0, 0.0, 0.0]
    silent = type("Silent", (tuple,), {"learn": lambda self: None, "_actual": None})
    with pytest.raises(WrongAnswer, match=r"^Silent must have a method act\(self, state, rng\)$"):
        learn_step(silent(), STEP)
    other = type("Other", (Player,), {"learn": lambda self, state, done: None})
    with pytest.raises(WrongAnswer, match="is 'terminated' meant"):
        learn_step(other(None), STEP)
