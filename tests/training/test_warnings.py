"""What `train` doubts or cannot compile: one warning, which names the class, the reason and the remedy."""

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from edugym import QLearning, make_mdp, train
from edugym.compiled import execution
from tests.compiled.cells import LEARNER, WALK, cell
from tests.training.slips import END, ENVIRONMENT, LIMIT, MOVE, PAY, changed, learner, walk
from tests.training.tasks import Ring

ENDLESS = changed(changed(WALK, END, "return False"), MOVE, "return min(5, max(0, state + 2 * action - 1))")
LINE = changed(ENVIRONMENT, "self.place == 5, False", "False, False").replace(
    "max(0, self.place + 2 * action - 1)", "(self.place + 1) % 6"
)


def said(call: Callable[[], Any]) -> list[str]:
    """The warnings of a call: each shows the line that has called the package."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    assert all(warning.filename == __file__ for warning in caught)
    return [str(warning.message) for warning in caught]


def one_warning(names: str, call: Callable[[], Any]) -> None:
    """There is one, with these names; without names there is none."""
    messages = said(call)
    assert len(messages) == bool(names), messages
    assert all(name in messages[0] for name in names.split()), messages


@pytest.mark.parametrize(
    ("task", "n_steps", "limit", "names"),
    [
        (lambda: walk(ENDLESS), 1_000, None, "Walk 1000 terminal max_steps"),
        (lambda: walk(ENDLESS), 999, None, ""),
        (lambda: walk(ENDLESS), 1_000, 2_000, ""),
        (lambda: cell(LINE)["Line"](), 1_000, None, "Line 1000 step terminated max_steps"),
        (lambda: walk(changed(ENDLESS, LIMIT, f"    max_steps = 2_000\n\n{LIMIT}")), 1_000, None, ""),
        (walk, 1_000, None, ""),
        (lambda: Ring(None), 1_000, None, "Ring terminal"),
    ],
)
def test_episodes_that_never_end(task: Any, n_steps: int, limit: int | None, names: str) -> None:
    """A warning says so after training, unless there is a step limit or there were only few steps."""
    environment = task()
    agent = QLearning.create(environment)
    one_warning(names, lambda: train(environment, agent, n_steps, max_steps=limit, evaluate_every=n_steps))


AGENT = """
class Agent:
    {body}
    def act(self, state, rng): return 1
    def learn(self, state, action, reward):
        {learn}
"""
TABLE = "def __init__(self): self.Q = np.zeros((6, 2))"
DOUBTS = [
    # What all agents of a class share.
    ("seen = {}", "self.seen[state] = 1", "seen Agent self.seen __init__"),
    ("seen = []", "self.seen.append(state)", "seen Agent self.seen __init__"),
    ("seen = set()", "self.seen.add(state)", "seen Agent self.seen __init__"),
    ("Q = np.zeros((6, 2))", "self.Q[state, action] += 1", "Q Agent self.Q __init__"),
    ("def __init__(self, Q=np.zeros((6, 2))): self.Q = Q", "self.Q[state, action] += 1", "Q Agent(...) default"),
    ("_seen = []", "self._seen.append(state)", ""),
    ("moves = [0, 1]", "len(self.moves)", ""),
    ("seen = []\n    def __init__(self): self.seen = []", "self.seen.append(state)", ""),
    ("def __init__(self): self.Q = {}", "self.Q[state, action] = reward", ""),
    # A table that comes to hold no number, late; and one of which nobody knows.
    (f"{TABLE}; self.n = 0", "self.n += 1; self.Q[0, 1] = np.nan if self.n > 300 else 0.0", "Q Agent nan"),
    (TABLE.replace("2)", "2), object"), "self.Q[state, action] += 1", ""),
    # A table that stays as blank as it was, although rewards came.
    (TABLE, "return self.Q[state, action] + reward", "learn Agent Q 1000 self.Q[...]"),
    (TABLE, "q = self.Q[state, action]; q += reward", "learn Agent Q 1000 self.Q[...]"),
    (f"{TABLE}; self.V = np.ones(6)", "return self.V[state] + reward", "learn Agent Q V 1000"),
    (TABLE, "pass", ""),  # it does not try
    (TABLE, "if state < 0:\n            self.Q[state, action] += reward", ""),  # it has no reason to
    (TABLE.replace("zeros", "eye").replace("(6, 2)", "6"), "return self.Q[state, action] + reward", ""),  # a planner's
    ("def __init__(self): self.weights = np.zeros(1)", "return self.weights + reward", ""),  # one number
    ("def __init__(self): self.weights = np.zeros(3)", "self.weights += reward", ""),  # all at once
    (f"{TABLE}; self.weights = np.arange(3.0)", "self.weights += reward", ""),  # one table of two
    ("total = 0.0", "self.total = self.total + reward", ""),  # no table
    (f"{TABLE}; self.learn = __import__('functools').partial(lambda by, reward: by * reward, 2)", "pass", ""),
]


@pytest.mark.parametrize(("body", "learn", "names"), DOUBTS, ids=[f"{k}" for k in range(len(DOUBTS))])
def test_what_training_has_done(body: str, learn: str, names: str) -> None:
    """A warning says so where it is a slip."""
    agent = cell(AGENT.format(body=body, learn=learn))["Agent"]()
    one_warning(names, lambda: train(Ring(), agent, 1_000, evaluate_every=1_000))


def test_what_need_not_be_learned() -> None:
    """In a short run, or where no reward came."""
    thinks = cell(AGENT.format(body=TABLE, learn="return self.Q[state, action] + reward"))["Agent"]
    free = walk(changed(changed(WALK, "1.0 if", "0.0 if"), "-0.25", "0.0"))
    one_warning("", lambda: train(walk(), thinks(), 999, max_steps=9))
    one_warning("", lambda: train(free, thinks(), 1_000, max_steps=9))


def test_a_table_that_is_the_default_of_a_field() -> None:
    """The next agent would begin with it, unless it has its own."""
    kind = cell(changed(LEARNER, "Q: np.ndarray", "Q: np.ndarray = np.zeros((6, 2))"))["Learner"]
    one_warning("Q Learner(...) default", lambda: train(walk(), kind(), 300))
    one_warning("", lambda: train(walk(), kind(np.zeros((6, 2))), 300))


def test_the_size_of_a_table() -> None:
    """With a row for each observation, it must have a column for each action; others may see something else."""
    agent = cell(AGENT.format(body="", learn="pass"))["Agent"]()
    for shape in ((6,), (6, 2), (6, 3), (2, 1), (3, 2)):
        agent.Q = np.zeros(shape)
        assert train(walk(), agent, 10).complete
    agent.Q = np.zeros((6, 1))
    with pytest.raises(ValueError, match=r"Q of Agent .*\(6, 1\)"):
        train(walk(), agent, 10)
    agent.weights = np.zeros((6, 1))  # which may be of any size
    del agent.Q
    assert train(walk(), agent, 10).complete


WALL = make_mdp("Boulder", height=5)


def compiled_from(agent: Any, task: Any = WALL) -> Callable[[], Any]:
    """A run that is worth compiling."""
    return lambda: train(task, agent, execution.COMPILE_FROM, max_steps=9, evaluate_every=5_000)


@pytest.mark.usefixtures("compiled_at_once")
@pytest.mark.parametrize(
    ("statement", "names"),
    [("print(state)", "prints"), ("x = {}", "dict"), ("rng.geometric(0.5)", "geometric line")],
)
def test_what_cannot_be_compiled(statement: str, names: str) -> None:
    """It is said once for training and evaluation, and again of a class that is defined again, not of the same."""
    source = changed(LEARNER, "best = 0\n", f"if state < 0:\n            {statement}\n        best = 0\n")
    for _ in range(2):
        agent = learner(source)
        one_warning(f"Learner interpreted {names} <cell", compiled_from(agent))
        one_warning("", compiled_from(agent))


def test_an_ordinary_class_is_told_that_it_is_one() -> None:
    """It runs, interpreted, and no class of the package is blamed."""
    agent = cell(AGENT.format(body="", learn="pass"))["Agent"]()
    one_warning("Agent interpreted NamedTuple", compiled_from(agent))


@pytest.mark.parametrize("first", ["[1, 2]", "(0, [1])"])
def test_a_state_that_is_a_list_is_named(first: str) -> None:
    """Also where only a part of it is one."""
    source = changed(changed(WALK, "return 0\n", f"return {first}\n"), MOVE, "return state")
    source = changed(changed(source, END, "return False"), "return state\n\n    @", "return 0\n\n    @")
    source = changed(source, PAY, "return -1.0")
    names = f"{'state[1]' * first.startswith('(')} list array tuple"
    one_warning(names, compiled_from(QLearning.create((6, 2)), walk(source)))
