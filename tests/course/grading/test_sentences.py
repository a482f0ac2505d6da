"""What is said of a wrong update, to the letter: the case in which it shows, worked out by hand."""

from typing import Any

import numpy as np
import pytest

from edugym_course.grading import WrongAnswer
from edugym_course.grading.updates import Case, Tables, Transition, Update
from tests.course.grading.test_updates import learns

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


def said_of(learn: Any) -> str:
    """What is said of a `learn`."""
    kind = learns(learn)

    def make() -> Any:
        agent = type("Own", (kind,), {})(np.zeros((4, 2)))
        agent.n, agent.w = np.zeros(4, int), np.zeros(4)
        return agent

    with pytest.raises(WrongAnswer) as caught:
        UPDATE.check(make, (4, 2), HALF, 0)
    return str(caught.value)


def test_a_value_that_goes_elsewhere() -> None:
    """In the second step it goes from 2 to 2.5; the case is all that is needed to follow it."""

    def learn(self: Any, state: int, action: int, reward: float, next_state: int) -> None:
        self.Q[state, action] += 0.5 * (reward - self.Q[state, action]) * (1 if self.n[next_state] == 4 else 1.5)
        self.n[next_state] += 1

    assert said_of(learn).startswith(
        "after learn(state=1, action=0, reward=3, next_state=2), where rate = 0.5, Q[2] = [0.1235, -2], n[2] = 5,"
        " w[2] = 0.25, Q[1, 0] should go from 2 to 2.5, but is 2.75: "
    )


def test_a_value_that_should_stay() -> None:
    """Nothing is left out of a row."""

    def learn(self: Any, state: int, next_state: int) -> None:
        self.Q[3, 1] = 1 / 3
        self.Q[state, 0] = (self.Q[state, 0] + 3.0) / 2
        self.n[next_state] += 1

    case = "after learn(state=1, next_state=2), where rate = 0.5, Q[2] = [0.1235, -2], n[2] = 4, w[2] = 0.25,"
    assert (
        said_of(learn) == f"{case} Q[3, 1] should stay 0, but is 0.3333: 2 entries of `Q` change, and only one should"
    )


@pytest.mark.parametrize(
    ("now", "says"),
    [
        (4, "go from 4 to 5, but is 4: `n` does not change there, and every time it should be one more"),
        (6, "go from 4 to 5, but is 6: `n` changes by +2 there, and every time it should be one more"),
        (3, "go from 4 to 5, but is 3: `n` changes by -1 there, and every time it should be one more"),
        (1, "go from 4 to 5, but is 1: `n` is set to 1 there, and it should become one more: write `+= 1`"),
    ],
)
def test_a_count(now: int, says: str) -> None:
    """The call is enough to follow it."""

    def learn(self: Any, state: int, next_state: int) -> None:
        self.Q[state, 0] = (self.Q[state, 0] + 3.0) / 2
        self.n[next_state] = now

    assert said_of(learn) == f"after learn(state=1, next_state=2), n[2] should {says}"


def test_numbers_that_are_wrong() -> None:
    """A rate is told with four digits."""

    def learn(self: Any, state: int, next_state: int) -> None:
        self.Q[state, 0] += (3.0 - self.Q[state, 0]) / 3
        self.n[next_state] += 1

    assert said_of(learn).endswith(
        "Q[1, 0] should go from 1 to 2, but is 1.667: a rate of 0.3333, and it should be 0.5"
    )


def test_a_number_that_is_zero() -> None:
    """It is told where no missing term explains it better."""

    def learn(self: Any, next_state: int) -> None:
        self.n[next_state] += 1

    assert said_of(learn).endswith("Q[1, 0] should go from 1 to 2, but is 1: a rate of 0, and it should be 0.5")


def test_a_value_that_grows_by_one_is_no_count() -> None:
    """Only tables of whole numbers count."""

    def learn(self: Any, state: int, next_state: int) -> None:
        self.Q[state, 0] = 77.0
        self.n[next_state] += 1

    assert said_of(learn).endswith(
        "Q[1, 0] should go from 1 to 2, but is 77: that is none of the usual mistakes, so compare your code with the"
        " equation, term by term"
    )
