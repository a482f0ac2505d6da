"""An agent's `learn` is bound by the names of its parameters."""

import itertools
from functools import partial
from types import SimpleNamespace
from typing import Any, NamedTuple, cast

import numpy as np
import pytest

from edugym import QLearning, train
from edugym.mdp.protocol import Random
from edugym.training.contract import LEARN_PARAMETERS, is_on_policy, learner, learns_from
from tests.training.tasks import SlipperyWalk, Stairs

STEP = {
    "state": 3,
    "action": 1,
    "reward": -0.5,
    "next_state": 4,
    "next_action": 2,
    "terminated": True,
    "truncated": False,
}


def agent_that_takes(names: tuple[str, ...], more: str = "") -> Any:
    """A plain class whose `learn` takes these names, in this order, and notes what it was given."""
    scope: dict[str, Any] = {}
    given = ", ".join(f"{name}={name}" for name in names)
    source = f"""
class Noting:
    def __init__(self): self.noted = None
    def act(self, state, rng): return 0
    def learn(self, {", ".join(names)}{more}): self.noted = dict({given})
"""
    exec(source, scope)
    return scope["Noting"]()


@pytest.mark.parametrize("size", range(1, len(LEARN_PARAMETERS) + 1))
def test_any_names_in_any_order(size: int) -> None:
    """Whatever an agent asks for, it gets that, however it orders it."""
    orders = itertools.islice(itertools.permutations(LEARN_PARAMETERS, size), 0, None, 1 if size < 4 else 97)
    for names in orders:
        agent = agent_that_takes(names)
        told = [STEP[name] for name in LEARN_PARAMETERS if name != "next_action" or "next_action" in names]
        learner(agent).learn(*told)
        assert agent.noted == {name: STEP[name] for name in names}
        assert learns_from(agent) == names
        assert is_on_policy(agent) == ("next_action" in names)


def test_a_default_of_ones_own_is_left_alone() -> None:
    """A sixth parameter with a default used to receive `truncated`."""

    class Agent:
        seen: Any = None

        def act(self, state: int, rng: Random) -> int:
            return 0

        def learn(
            self, state: int, action: int, reward: float, next_state: int, terminated: bool, alpha: float = 0.5
        ) -> None:
            self.seen = (terminated, alpha)

    agent = Agent()
    learner(agent).learn(*(STEP[name] for name in LEARN_PARAMETERS if name != "next_action"))
    assert agent.seen == (True, 0.5)


class Patient(NamedTuple):
    """SARSA with its parameters in an order of its own, one of them with a default, and one by keyword."""

    Q: Any

    def act(self, state: int, rng: Random) -> int:
        """At random."""
        return int(rng.random() * 2)

    def learn(
        self,
        reward: float,
        next_action: int,
        next_state: int,
        state: int,
        action: int,
        terminated: bool,
        rate: float = 0.25,
    ) -> None:
        """The update of section 6.4."""
        target = reward if terminated else reward + 0.9 * self.Q[next_state, next_action]
        self.Q[state, action] += rate * (target - self.Q[state, action])


def test_compiled_as_interpreted(compiled_at_once: None) -> None:
    """Bound by name in machine code as well."""
    tables = []
    for every in (50, 20_000):  # a run of single chunks of 50 steps or one of 20 000
        agent = Patient(np.zeros((7, 2)))
        train(SlipperyWalk(), agent, 20_000, seed=3, evaluate_every=every)
        tables.append(agent.Q)
    short = Patient(np.zeros((7, 2)))
    for part in range(10):
        train(SlipperyWalk(), short, 500, seed=part)
    assert (tables[0] == tables[1]).all()
    assert tables[0].any()
    assert short.Q.any()


@pytest.mark.parametrize(
    ("more", "asked"),
    [
        (", rewrad", "'rewrad': is 'reward' meant"),
        (", *, done", "'done': is 'terminated' meant"),
        (", *rest", "'rest'"),
        (", *reward", "'reward'"),
        (", rng", "'rng': draw random numbers in act, which takes it"),
    ],
)
def test_unknown_names_are_refused(more: str, asked: str) -> None:
    """The message lists the names."""
    agent = agent_that_takes(("state", "action"), more)
    with pytest.raises(ValueError, match=f"learn of Noting has the parameter {asked}.* must be among state, action, "):
        train(Stairs(), agent, 10)


def test_learn_may_be_any_callable() -> None:
    """A function that an instance or a class holds has no `self`, and needs none."""
    seen = []

    def learn(state: int, action: int, terminated: bool) -> None:
        seen.append((state, action, terminated))

    agent = SimpleNamespace(act=lambda state, rng: 0, learn=partial(learn))
    train(Stairs(), agent, 3)
    assert len(seen) == 3
    assert {action for _, action, _ in seen} == {0}


class Forgetful(NamedTuple):
    """A student's agent whose values are in a dictionary, and that counts in an array."""

    Q: dict[tuple[int, int], float]
    seen: Any

    def act(self, state: int, rng: Random) -> int:
        """Right."""
        return 1

    def learn(self, state: int, action: int, reward: float) -> None:
        """The last reward."""
        self.Q[state, action] = reward


def test_values_may_be_in_a_dictionary() -> None:
    """Of a student's agent: only those of the package must be arrays."""
    agent = Forgetful({}, np.zeros(2, np.int64))
    train(Stairs(), agent, 3)
    assert agent.Q
    with pytest.raises(ValueError, match=r"Q of QLearning must be an array, but is \{\}: use QLearning.create"):
        train(Stairs(), QLearning(cast("Any", {})), 3)


def test_what_is_no_agent_is_refused() -> None:
    """A class, and a value without the methods."""
    for wrong in (QLearning, 3, None):
        with pytest.raises(ValueError, match="agent must be an object with the methods act and learn, but is"):
            train(Stairs(), wrong, 10)


@pytest.mark.parametrize(
    ("table", "message"),
    [
        (np.zeros((9, 2), int), "Q of QLearning must be an array of float, but its dtype is int64"),
        (np.full((9, 2), np.nan), r"Q of QLearning must hold numbers, but Q\[0, 0\] is nan"),
    ],
)
def test_a_table_that_cannot_learn_is_refused_in_the_packages_own_agents_too(table: Any, message: str) -> None:
    """Nothing would be learned, without a word."""
    with pytest.raises(ValueError, match=message):
        train(Stairs(), QLearning(table), 10)
