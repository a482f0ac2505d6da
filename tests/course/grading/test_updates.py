"""Updates against their rule: which mistake is found, and that no two mistakes look the same."""

from collections.abc import Callable
from functools import partial
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import WrongAnswer
from edugym_course.grading.one_step import Q_LEARNING
from edugym_course.grading.updates import Transition, Update
from edugym_course.lessons.exploration.exercises import EXPLORER
from edugym_course.lessons.on_off_policy.exercises import TWO_POLICIES
from edugym_course.lessons.stochasticity.exercises import TWO_WEIGHTS

SIZE = (5, 3)
RIGHT = {"learning_rate": 0.25, "discount": 0.75}
UPDATES = {
    "Q-learning": (Q_LEARNING, RIGHT),
    "explorer": (EXPLORER, {**RIGHT, "bonus": 3.0}),
    "two policies": (TWO_POLICIES, {**RIGHT, "epsilon": 0.2, "target_epsilon": 0.6}),
    "two weights": (TWO_WEIGHTS, {**RIGHT, "kappa": 0.6}),
}

ALIKE_WITH = {
    2: ("only the first two actions", "the minimum stands where the mean"),
    3: ("it divides by 3",),
}
"""Mistakes that are none with so many actions, or the same as another."""


def learns(body: Callable[..., Any], **fields: Any) -> type:
    """A class of agents whose `learn` is a function."""

    class Agent(NamedTuple):
        Q: Any

        def act(self, state: int, rng: Any) -> int:
            return 0

    return type("Agent", (Agent,), {"learn": body, **fields})


def said_of(body: Callable[..., Any], Q: Any = None) -> str:
    """What is said of an update."""
    kind = learns(body)
    with pytest.raises(WrongAnswer) as caught:
        Q_LEARNING.check(lambda: kind(np.zeros(SIZE) if Q is None else Q), SIZE, RIGHT, 0)
    return str(caught.value)


def by_rule(update: Update, settings: dict[str, Any]) -> Callable[..., None]:
    """A `learn` that does what the rule does with some settings."""

    def learn(
        self: Any,
        state: int,
        action: int,
        reward: float,
        next_state: int,
        next_action: int,
        terminated: bool,
        truncated: bool,
    ) -> None:
        now = (
            update.cases(SIZE, 0)[0]
            .transitions[0]
            ._replace(
                state=state,
                action=action,
                reward=reward,
                next_state=next_state,
                next_action=next_action,
                terminated=terminated,
                truncated=truncated,
            )
        )
        update.rule({name: getattr(self, name) for name in self._fields}, now, **settings)

    return learn


def test_the_packages_agent_is_right() -> None:
    """The rule agrees with Q-learning, with any settings, on any cases."""
    for seed in range(5):
        for learning_rate, discount in ((0.5, 0.75), (1.0, 0.0), (0.1, 1.0)):
            settings = {"learning_rate": learning_rate, "discount": discount}
            Q_LEARNING.check(partial(QLearning.create, SIZE, **settings), SIZE, settings, seed)


@pytest.mark.parametrize("name", UPDATES)
@pytest.mark.parametrize("seed", [0, 1])
def test_no_two_mistakes_look_the_same(name: str, seed: int) -> None:
    """Every mistake differs from the rule and from every other one in some case, with two actions as with three."""
    update, settings = UPDATES[name]
    for size in (SIZE, (6, 2)):
        cases = update.cases(size, seed)
        made = {said: update.outcomes(cases, {**settings, **change}) for said, change in update.mistakes.items()}
        made["right"] = update.outcomes(cases, settings)
        flat = {
            said: np.concatenate([np.ravel(t[n]) for steps in outcome for t in steps for n in t])
            for said, outcome in made.items()
        }
        flat = {said: row for said, row in flat.items() if not said.startswith(ALIKE_WITH[size[1]])}
        for (one, first), (two, second) in combinations(flat.items(), 2):
            assert not np.allclose(first, second, equal_nan=True), (one, two)


def kind(step: Transition) -> str:
    """What is special about a transition."""
    special = {"terminated": step.terminated, "truncated": step.truncated, "stays": step.state == step.next_state}
    return " ".join(name for name, so in special.items() if so) or "ordinary"


@pytest.mark.parametrize("seed", range(5))
def test_cases_are_of_every_kind(seed: int) -> None:
    """The first is the simplest, for it is in the sentence where all fail; one case repeats a pair."""
    cases = [case.transitions for case in Q_LEARNING.cases(SIZE, seed)]
    assert [[kind(step) for step in case] for case in cases] == 4 * [
        ["ordinary"],
        ["terminated"],
        ["truncated"],
        ["stays"],
        ["ordinary"] * 3,
        ["ordinary", "ordinary", "truncated", "terminated"],
    ]
    for first, second, third in cases[4::6]:
        assert first == second
        assert third == first._replace(reward=0.0) != first


@pytest.mark.parametrize("sentence", Q_LEARNING.mistakes)
def test_each_mistake_is_named(sentence: str) -> None:
    """An answer that makes it is told so, in one sentence with the case in it."""
    settings = {**RIGHT, **Q_LEARNING.mistakes[sentence]}
    said = said_of(by_rule(Q_LEARNING, settings))
    assert said.endswith(f": {sentence}")
    assert said.startswith("after learn(state=")


def test_two_mistakes_at_once_and_wrong_numbers() -> None:
    """Both are named; numbers are computed from what came out."""
    rule = partial(by_rule, Q_LEARNING)
    said = said_of(rule({**RIGHT, "backup": "mean", "ends": "never"}))
    assert "the mean over the actions" in said
    assert "a terminal state has no future" in said
    said = said_of(rule({"learning_rate": 0.125, "discount": 0.99}))
    assert "a learning rate of 0.125, and it should be 0.25" in said
    assert "a discount of 0.99, and it should be 0.75" in said
    said = said_of(rule({**RIGHT, "learning_rate": 1 / 3, "backup": "none"}))
    assert "without bootstrapping" in said
    assert "a learning rate of 0.3333" in said


def test_what_fits_no_mistake() -> None:
    """What a mistake explains in the first case only is said with care; else the entries that change are counted."""

    def in_part(self: Any, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        value = 0.0 if terminated or reward > 0 else self.Q[next_state].max()
        self.Q[state, action] += 0.25 * (reward + 0.75 * value - self.Q[state, action])

    def row(self: Any, state: int, reward: float) -> None:
        self.Q[state] += 0.5 * (reward - self.Q[state])

    def odd(self: Any, state: int, action: int) -> None:
        self.Q[state, action] = 77.0

    assert ": in this case it looks like this: " in said_of(in_part)
    assert said_of(row).endswith(" entries of `Q` change, and only one should")
    assert said_of(odd).endswith("so compare your code with the equation, term by term")


def test_no_change_and_bad_parameters() -> None:
    """A value that is returned is not learned; a parameter with another name is not passed."""
    assert said_of(lambda self, state: None).endswith("`learn` changes no table at all")
    assert said_of(lambda self, reward: reward).endswith("it returns something instead, which nobody reads")
    assert "is 'terminated' meant?" in said_of(lambda self, state, done: None)
    assert "raises IndexError" in said_of(lambda self, state: self.Q[state, 9])


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ([[0.0] * 3] * 5, "should be a NumPy array, but is a list"),
        (np.zeros((3, 5)), r"should have the shape (5, 3), but has (3, 5)"),
        (np.zeros(SIZE, int), "which cannot hold fractions"),
    ],
)
def test_tables_that_are_none(table: Any, says: str) -> None:
    """A list, a wrong shape, whole numbers."""
    assert says in said_of(lambda self, state: None, table)


def test_a_missing_table() -> None:
    """It is named."""
    kind = type("Agent", (), {"act": lambda self, state, rng: 0, "learn": lambda self, state: None})
    with pytest.raises(WrongAnswer, match="should have a table `Q`, but Agent has none"):
        Q_LEARNING.check(kind, SIZE, RIGHT, 0)


def test_tables_that_are_replaced_are_found() -> None:
    """A plain class may assign a new array to its field; it is the new one that counts."""

    class Plain:
        def __init__(self) -> None:
            self.Q = np.zeros(SIZE)

        def act(self, state: int, rng: Any) -> int:
            return 0

        def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
            Q = self.Q.copy()
            value = 0.0 if terminated else Q[next_state].max()
            Q[state, action] += 0.25 * (reward + 0.75 * value - Q[state, action])
            self.Q = Q

    Q_LEARNING.check(Plain, SIZE, RIGHT, 0)
