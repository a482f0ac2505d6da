"""Updates against their rule: which mistake is found, and that no two mistakes look the same."""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym_course.grading import WrongAnswer
from edugym_course.grading.agents import table_of
from edugym_course.grading.one_step import Q_LEARNING
from edugym_course.grading.updates import Case, Tables, Transition, Update
from tests.messages import named

SIZE = (5, 3)
RIGHT = {"learning_rate": 0.25, "discount": 0.75}


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
    return lambda self, state, action, reward, next_state, next_action, terminated, truncated: update.rule(
        self._asdict(), Transition(state, action, reward, next_state, next_action, terminated, truncated), **settings
    )


@pytest.mark.parametrize("seed", range(5))
def test_cases_are_of_every_kind(seed: int) -> None:
    """The first is the simplest, for it is in the sentence where all fail; one case repeats a pair."""
    cases = [case.transitions for case in Q_LEARNING.cases(SIZE, seed)]
    kinds = [[(now.terminated, now.truncated, now.state == now.next_state) for now in case] for case in cases]
    plain, ends, cut_off, stays = (False,) * 3, (True, False, False), (False, True, False), (False, False, True)
    assert kinds == 4 * [[plain], [ends], [cut_off], [stays], [plain] * 3, [plain, plain, cut_off, ends]]
    for first, second, third in cases[4::6]:
        assert first == second
        assert third == first._replace(reward=0.0) != first


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


def test_what_fits_by_accident_is_not_named() -> None:
    """No discount is above 1; a mistake that fits one case and not most of them is none."""
    said = said_of(by_rule(Q_LEARNING, {**RIGHT, "discount": 2.8}))
    assert said.endswith("in your code Q[4, 1] counts 0.7 times, and should count 0.1875 times")
    first = Q_LEARNING.cases(SIZE, 0)[0].transitions[0]

    def now_and_then(mistake: str, otherwise: str) -> Callable[..., None]:
        """A `learn` with one mistake in the step of the first case, and with another one in all others."""

        def learn(
            self: Any, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool
        ) -> None:
            now = Transition(state, action, reward, next_state, first.next_action, terminated, truncated)
            backup = mistake if now == first else otherwise
            Q_LEARNING.rule(self._asdict(), now, **RIGHT, backup=backup)

        return learn

    assert "looks like this" not in said_of(now_and_then("mean", "min"))
    assert "looks like this" not in said_of(now_and_then("min", "mean"))
    ends = [case.transitions[0].next_state for case in Q_LEARNING.cases(SIZE, 0)[1::6]]
    spared = next(state for state in ends if state != ends[0])

    def at_ends(self: Any, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Goes on at every end but one."""
        now = Transition(state, action, reward, next_state, 0, terminated, truncated=False)
        Q_LEARNING.rule(self._asdict(), now, **RIGHT, ends="terminated" if next_state == spared else "never")

    assert "looks like this: a terminal state has no future" in said_of(at_ends)


def test_no_change_and_bad_parameters() -> None:
    """A parameter of another name is not passed; a table has a wrong shape or type, or is missing."""
    assert "(5, 3), but has (3, 5)" in said_of(lambda self, state: None, np.zeros((3, 5)))
    assert "which cannot hold fractions" in said_of(lambda self, state: None, np.zeros(SIZE, int))
    assert "is 'terminated' meant?" in said_of(lambda self, state, done: None)
    assert "raises IndexError" in said_of(lambda self, state: self.Q[state, 9])
    kind = type("Agent", (), {"act": lambda self, state, rng: 0, "learn": lambda self, state: None})
    with pytest.raises(WrongAnswer, match="should have a table `Q`, but Agent has none"):
        Q_LEARNING.check(kind, SIZE, RIGHT, 0)


def test_tables_that_are_replaced_are_found() -> None:
    """A plain class may assign a new array to its field; it is the new one that counts."""

    def learn(self: Any, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        self.Q = self.Q.copy()
        value = 0.0 if terminated else self.Q[next_state].max()
        self.Q[state, action] += 0.25 * (reward + 0.75 * value - self.Q[state, action])

    methods = {"__init__": lambda self: setattr(self, "Q", np.zeros(SIZE)), "act": lambda self, state, rng: 0}
    Q_LEARNING.check(type("Plain", (), {**methods, "learn": learn}), SIZE, RIGHT, 0)


HALF = {"rate": 0.5}


def rule(tables: Tables, now: Transition, *, rate: float, counts: int = 1) -> None:
    """Move to the reward, and count the state that is entered."""
    tables["Q"][now.state, now.action] += rate * (now.reward - tables["Q"][now.state, now.action])
    tables["n"][now.next_state] += counts


class Twice(Update):
    """One case: two steps from state 1 to state 2."""

    def cases(self, size: tuple[int, int], seed: int) -> list[Case]:
        """Return it."""
        step = Transition(1, 0, 3.0, 2, 1, terminated=False, truncated=False)
        return [Case(self.tables(*size, np.random.default_rng(seed)), [step, step])]


def made_up(n_states: int, n_actions: int, rng: np.random.Generator) -> Tables:
    """Return a value of 1 that the steps change, and values of the state that is entered."""
    Q = np.zeros((n_states, n_actions))
    Q[1, 0], Q[2] = 1.0, (0.123456, -2.0)
    return {"Q": Q, "n": np.full(n_states, 4), "w": np.arange(n_states) / 8}


UPDATE = Twice(rule, made_up, {}, {"rate": "a rate of {found:.4g}, and it should be {right:.4g}"})
SEEN = "after learn(state=1, action=0, reward=3, next_state=2)"
SAID = [
    ([2.0, 2.75], [5, 6], f"{SEEN}, where rate = 0.5, Q[2] = [0.1235, -2], n[2] = 5, w[2] = 0.25, Q[1, 0] should "),
    ([2.0, 2.75], [5, 6], "Q[1, 0] should go from 2 to 2.5, but is 2.75: "),
    ([2.0, 2.5], [4, 4], f"{SEEN}, n[2] should go from 4 to 5, but is 4: `n` does not change there"),
    ([2.0, 2.5], [6, 8], "but is 6: `n` changes by +2 there"),
    ([2.0, 2.5], [3, 2], "but is 3: `n` changes by -1 there"),
    ([2.0, 2.5], [1, 1], "but is 1: `n` is set to 1 there"),
    ([5 / 3, 19 / 9], [5, 6], "should go from 1 to 2, but is 1.667: a rate of 0.3333, and it should be 0.5"),
    ([1.0, 1.0], [5, 6], "should go from 1 to 2, but is 1: a rate of 0, and it should be 0.5"),
    ([77.0, 77.0], [5, 6], "but is 77: in your code the reward counts 0 times, and should count 0.5 times; Q[1, 0] "),
]
"""The value and the count after both steps, 2 and 5, 2.5 and 6 if all is right; and what is said of it."""


@pytest.mark.parametrize(("values", "counts", "says"), SAID)
def test_what_is_said_of_a_wrong_update(values: list[float], counts: list[int], says: str) -> None:
    """The first step that is wrong, with all that is needed to follow a value; for a count the call is enough."""
    assert says in said_of_steps(values, counts)


@pytest.mark.parametrize(
    ("table", "names"),
    [
        (None, ("`Q`", "Agent")), ([[0.0], [0.0]], ("`Q`", "array", "list")),
        (np.zeros(3), ("`Q`", "(2, 1)", "(3,)")), (np.zeros((2, 1), int), ("`Q`", "int64")),
    ],
)  # fmt: skip
def test_what_is_no_table(table: Any, names: tuple[str, ...]) -> None:
    """What should be there is told, and what is there."""
    with pytest.raises(WrongAnswer, match=named(*names)):
        table_of(learns(lambda self: None)(table), "Q", (2, 1))


def test_a_value_that_should_stay() -> None:
    """Of a row nothing is left out, and the entries that change are counted."""
    said = said_of_steps([2.0, 2.5], [5, 6], stays=1 / 3)
    assert f"{SEEN}, where rate = 0.5, Q[2] = [0.1235, -2], n[2] = 4," in said
    assert said.endswith("Q[3, 1] should stay 0, but is 0.3333: 2 entries of `Q` change, and only one should")


def said_of_steps(values: list[float], counts: list[int], stays: float = 0.0) -> str:
    """What is said of a `learn` that makes these values and counts."""

    def learn(self: Any, state: int, action: int, reward: float, next_state: int) -> None:
        again = bool(self.steps)
        self.Q[1, 0], self.n[2], self.Q[3, 1] = values[again], counts[again], stays
        self.steps.append(state)

    kind = learns(learn)

    def make() -> Any:
        agent = type("Own", (kind,), {})(np.zeros((4, 2)))
        agent.n, agent.w, agent.steps = np.zeros(4, int), np.zeros(4), []
        return agent

    with pytest.raises(WrongAnswer) as caught:
        UPDATE.check(make, (4, 2), HALF, 0)
    return str(caught.value)
