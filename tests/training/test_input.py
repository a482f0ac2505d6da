"""What `train` says to agents and environments that it cannot take, or cannot compile."""

import threading
import time
import warnings
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest

from edugym import QLearning, make_mdp, repeat, train
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.mdps import require_task
from edugym.compiled import execution
from edugym.mdp.protocol import Random, Reals
from tests.compiled.cells import LEARNER, cell

pytestmark = pytest.mark.usefixtures("compiled_at_once")

WALL = make_mdp("Boulder", height=3)


class Chooser(NamedTuple):
    """An agent that uses what machine code has not."""

    Q: Reals

    def act(self, state: int, rng: Random) -> int:
        """Choose at random."""
        return int(rng.geometric(0.5) > 1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Learn nothing."""


class Plain:
    """An agent of an ordinary class."""

    def act(self, state: int, rng: Random) -> int:
        """Choose at random."""
        return int(rng.random() * 2)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Learn nothing."""


def said_of(agent: Any, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The warnings of a training run that is worth compiling."""
    monkeypatch.setattr(execution, "_warned", set())
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        train(WALL, agent, execution.COMPILE_FROM)
    assert all(warning.filename == __file__ for warning in caught)  # the line that has called `train`
    return [str(warning.message) for warning in caught]


def test_one_warning_names_the_class_the_reason_and_the_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """Training and evaluation are two loops, and the student hears of one thing: the line of their own."""
    line = next(n for n, text in enumerate(Path(__file__).read_text().splitlines(), 1) if "rng.geometric(0.5)" in text)
    (message,) = said_of(Chooser(np.zeros((4, 2))), monkeypatch)
    assert message.startswith("Chooser cannot be compiled and runs interpreted")
    assert "it uses rng's geometric" in message
    assert message.endswith(f"{Path(__file__).name}, line {line})")


def test_a_class_that_is_defined_again_is_told_again() -> None:
    """A student who has mended one thing hears of the next; the same class is told once."""
    for statement, reason in (("print(state)", "it prints"), ("x = {}", "it makes a dict")):
        source = LEARNER.replace(
            "        best = 0\n", f"        if state < 0:\n            {statement}\n        best = 0\n"
        )
        kind = cell(source)["Learner"]
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            for _ in range(2):
                train(WALL, kind(np.zeros((4, 2))), execution.COMPILE_FROM)
        (warning,) = caught
        assert reason in str(warning.message)


STILL = """
class Still(NamedTuple):
    observation_space = spaces.Discrete(4)
    action_space = spaces.Discrete(2)
    def initial(self, rng):
        return FIRST
    def transition(self, state, action, rng):
        return state
    def reward(self, state, action, next_state, rng):
        return -1.0
    def terminal(self, state):
        return False
    def observation(self, state, rng):
        return 0
"""


@pytest.mark.parametrize(("first", "reason"), [("[1, 2]", "a state is a list"), ("(0, [1])", r"state\[1\] is a list")])
def test_a_state_that_is_a_list_is_named(first: str, reason: str) -> None:
    """Also where only a part of it is one."""
    task = cell(STILL.replace("FIRST", first))["Still"]()
    with pytest.warns(UserWarning, match=f"slower: {reason}: use an array or a tuple$"):
        train(task, QLearning.create((4, 2)), execution.COMPILE_FROM, max_steps=9)


def test_an_ordinary_class_is_told_that_it_is_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """It runs, interpreted, and no class of the package is blamed."""
    (message,) = said_of(Plain(), monkeypatch)
    assert message == "Plain cannot be compiled and runs interpreted, some hundred times slower: it is no NamedTuple"


@pytest.mark.parametrize(
    ("environment", "agent", "message"),
    [
        (3, Plain(), "environment must be an MDP, a Gymnasium environment or a name, but is 3"),
        ((1, 2), Plain(), r"environment must be an MDP, a Gymnasium environment or a name, but is \(1, 2\)$"),
        (Plain(), WALL, "environment must come first, before the agent, but is the agent Plain"),
        (QLearning, WALL, "environment must come first, before the agent, but is the agent QLearning"),
        (
            WALL,
            QLearning,
            r"agent must be an object with .* but is the class QLearning: make one with QLearning.create\(",
        ),
        (WALL, 0.5, "agent must be an object with the methods act and learn, but is 0.5"),
        (WALL, QLearning.create((3, 2)), r"agent must have a table Q of shape \(4, 2\) for this environment, but its"),
    ],
)
def test_what_cannot_be_trained_is_refused(environment: Any, agent: Any, message: str) -> None:
    """The error names the argument, its value and what is allowed."""
    with pytest.raises(ValueError, match=message):
        train(environment, agent, 10)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (
            {"stop": threading.Event},
            r"stop must be a threading.Event or None, but is the class Event: add brackets, \(\)",
        ),
        ({"stop": SimpleNamespace(is_set=bool)}, "stop must be a threading.Event or None, but is namespace"),
        ({"stop": SimpleNamespace(set=bool)}, "stop must be a threading.Event or None, but is namespace"),
        ({"max_steps": 2**70}, r"max_steps must be at most 4611686018427387904, but is 1180591620717411303424"),
        ({"seed": -1}, "seed must be 0 or more, but is -1"),
    ],
)
def test_settings_of_train_are_checked(settings: Any, message: str) -> None:
    """The error names the argument, its value and what is allowed."""
    with pytest.raises(ValueError, match=message):
        train(WALL, QLearning.create(WALL), 10, **settings)


def test_small_whole_numbers_of_numpy_do_not_overflow() -> None:
    """They become Python's."""
    n_steps: Any = np.int8(100)
    run = train(WALL, QLearning.create(WALL), n_steps, evaluate_every=1_000)
    assert run.steps.tolist() == [0, 100]


def test_agents_of_repeat_have_labels() -> None:
    """The obvious slip is named."""
    slip: Any = QLearning.create
    with pytest.raises(ValueError, match="agents must be a dictionary of agents by their labels"):
        repeat("Boulder", slip, 10)


@pytest.mark.parametrize("name", ["Boulder", "edugym/Boulder-v0", "edugym:edugym/Boulder-v0"])
def test_names_mean_the_same_everywhere(name: str) -> None:
    """`train` and `repeat` take the name, the id, and the id with the prefix that README recommends."""
    agent = QLearning.create(make_mdp("Boulder"))
    assert train(name, agent, 10).complete
    assert repeat(name, {"Q": agent}, 10, repetitions=1).complete


def test_a_long_evaluation_stops_between_episodes() -> None:
    """Each of the 100 000 episodes takes a millisecond or more: all of them would take minutes."""
    stop = threading.Event()
    threading.Timer(0.5, stop.set).start()
    wall = make_mdp("Boulder", height=100, max_steps=100_000)
    began = time.perf_counter()
    run = train(wall, QLearning.create(wall), 1_000_000, evaluation_episodes=100_000, stop=stop)
    assert not run.complete
    assert time.perf_counter() - began < 30


@pytest.mark.parametrize(
    ("shape", "fits"), [((4, 1), False), ((4, 2), True), ((4, 3), True), ((2, 1), True), ((4,), True)]
)
def test_a_table_with_too_few_actions(shape: tuple[int, ...], fits: bool) -> None:
    """Of a student's agent, and only if it has a row for each observation: others may see something else."""

    class Zeros(NamedTuple):
        Q: Reals

        def act(self, state: int, rng: Random) -> int:
            return 0

        def learn(self, state: int, action: int, reward: float, next_state: int) -> None:
            """Learn nothing."""

    agent = Zeros(np.zeros(shape))
    if fits:
        assert train(WALL, agent, 10).complete
        return
    expected = r"Q of Zeros has the shape \(4, 1\), but this environment has 4 observations and 2 actions"
    with pytest.raises(ValueError, match=expected):
        train(WALL, agent, 10)


def test_the_limit_of_a_wrapped_task() -> None:
    """It is known also where no specification says it."""

    class Unchanged(gymnasium.Wrapper[Any, Any, Any, Any]):
        """Does nothing."""

    assert require_task(Unchanged(MDPEnv(WALL))) == require_task(WALL) == 30
    assert require_task(gymnasium.make("CartPole-v1")) == 500
