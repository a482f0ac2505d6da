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
from edugym_course.grading.updates import Case, Tables, Transition, Update
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

ALIKE_WITH = {2: ("only the first two actions", "the minimum stands where the mean"), 3: ("it divides by 3",)}
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
    return lambda self, state, action, reward, next_state, next_action, terminated, truncated: update.rule(
        self._asdict(), Transition(state, action, reward, next_state, next_action, terminated, truncated), **settings
    )


def test_the_packages_agent_is_right() -> None:
    """The rule agrees with Q-learning, with any settings, on any cases."""
    for seed, (learning_rate, discount) in enumerate([(0.5, 0.75), (1.0, 0.0), (0.1, 1.0)]):
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
    """A value that is returned is not learned; a parameter of another name is not passed; a table is missing."""
    assert said_of(lambda self, state: None).endswith("`learn` changes no table at all")
    assert said_of(lambda self, reward: reward).endswith("it returns something instead, which nobody reads")
    assert "is 'terminated' meant?" in said_of(lambda self, state, done: None)
    assert "raises IndexError" in said_of(lambda self, state: self.Q[state, 9])
    kind = type("Agent", (), {"act": lambda self, state, rng: 0, "learn": lambda self, state: None})
    with pytest.raises(WrongAnswer, match="should have a table `Q`, but Agent has none"):
        Q_LEARNING.check(kind, SIZE, RIGHT, 0)


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
    ([77.0, 77.0], [5, 6], "should go from 1 to 2, but is 77: that is none of the usual mistakes"),
]
"""The value and the count after both steps, 2 and 5, 2.5 and 6 if all is right; and what is said of it."""


@pytest.mark.parametrize(("values", "counts", "says"), SAID)
def test_what_is_said_of_a_wrong_update(values: list[float], counts: list[int], says: str) -> None:
    """The first step that is wrong, with all that is needed to follow a value; for a count the call is enough."""
    assert says in said_of_steps(values, counts)


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
