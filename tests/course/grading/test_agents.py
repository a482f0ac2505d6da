"""What an answer must be before it is tried: each thing that it is not has its sentence."""

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


def test_a_class_and_a_function() -> None:
    """Each is no other, and a placeholder is not solved yet."""
    require_class("Mine", Player)
    require_function("f", len, "a list")
    for name, says in (
        ("Mine", "Mine should be the class itself, but is of the type Player"),
        ("Player", r"Player should be the class itself, but is what Player\(...\) makes: leave"),
    ):
        with pytest.raises(WrongAnswer, match=says):
            require_class(name, Player(None))
    for answer, says in ((Player, "but is the class Player"), (2.0, "but is of the type float")):
        with pytest.raises(WrongAnswer, match=f"f should be a function of a list, {says}"):
            require_function("f", answer, "a list")
    with pytest.raises(Unsolved):
        require_class("Mine", ...)
    with pytest.raises(Unsolved):
        require_function("f", None, "a list")


def test_what_makes_no_agent() -> None:
    """None, the class, something without `learn`, a class without `create`."""
    assert isinstance(agent_created_by("QLearning", QLearning, "wall", (3, 2)), QLearning)
    for make, says in (
        (lambda task: None, "is a `return` missing"),
        (lambda task: Player, r"gives the class Player: write Player\.create"),
        (lambda task: object(), "of the type object, has no `act`"),
        (lambda task: 1 / 0, "raises ZeroDivisionError"),
    ):
        with pytest.raises(WrongAnswer, match=says):
            agent_made_by("mine(task)", make, None)
    with pytest.raises(WrongAnswer, match="Player should keep its method `create`, which makes a new agent for a wall"):
        agent_created_by("Player", Player, "wall", None)


def test_settings() -> None:
    """They are given to a named tuple and a plain object; a field that is gone and a wrong setting are named."""

    class Plain:
        rate = 0.5

        def __init__(self, w: Any = None, **settings: float) -> None:
            self.w = w

        def learn(self) -> None: ...

    assert with_settings("Player", Player(None), {"rate": 0.25}, "learn").rate == 0.25
    assert with_settings("Plain", Plain(), {"rate": 0.25}, "learn").rate == 0.25
    with pytest.raises(WrongAnswer, match="Player should keep its field `speed`, from which `learn` reads the number"):
        with_settings("Player", Player(None), {"speed": 1.0}, "learn")
    made = agent_with_table("Player", Player, (3, 2), {"rate": 0.25})
    assert made.Q.shape == (3, 2)
    assert agent_with_table("Plain", Plain, (3, 2), {"rate": 0.25}, "w").w.shape == (3, 2)
    with pytest.raises(WrongAnswer, match="Player should keep its field `w`, the table that `learn` changes"):
        agent_with_table("Player", Player, (3, 2), {"rate": 0.25}, "w")
    with pytest.raises(WrongAnswer, match="Player should keep its field `speed`"):
        agent_with_table("Player", Player, (3, 2), {"speed": 1.0})
    with pytest.raises(WrongAnswer, match=r"^Table should have a method `learn`$"):
        agent_with_table("Table", NamedTuple("Table", [("Q", Any)]), (3, 2), {})
    assert agent_created_by("QLearning", QLearning, "wall", (3, 2), {"learning_rate": 0.25}).learning_rate == 0.25
    with pytest.raises(WrongAnswer, match="QLearning has no setting 'speed'; it has learning_rate"):
        agent_created_by("QLearning", QLearning, "wall", (3, 2), {"speed": 1})


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
