"""Ctrl-C in a student's agent of which one method is machine code and another is not."""

import signal
import threading
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

import edugym
from edugym import QLearning
from edugym.compiled import execution
from edugym.mdp.protocol import Random, Reals
from edugym.system.interrupts import Interrupted, Work
from edugym.training import trainers
from tests.training.tasks import Ring

CALLS: list[int] = []
"""One item for each call of `pressing`. A method that changes a global list is not compiled."""


def pressing(at: int) -> None:
    """Press Ctrl-C at one of the calls."""
    CALLS.append(at)
    if len(CALLS) == at:
        signal.raise_signal(signal.SIGINT)


class Learner(NamedTuple):
    """Its `learn` runs interpreted, while evaluation is machine code."""

    Q: Reals
    at: int

    def act(self, state: int, rng: Random) -> int:
        """Any action."""
        return int(rng.random() * 2)

    def greedy(self, state: int, rng: Random) -> int:
        """The first action."""
        return 0

    def learn(self, state: int, action: int, reward: float) -> None:
        """Learn the reward."""
        pressing(self.at)
        self.Q[state, action] += 0.1 * (reward - self.Q[state, action])


class Player(NamedTuple):
    """Its `greedy` runs interpreted, while training is machine code."""

    Q: Reals
    at: int

    def act(self, state: int, rng: Random) -> int:
        """Any action."""
        return int(rng.random() * 2)

    def greedy(self, state: int, rng: Random) -> int:
        """The first action."""
        pressing(self.at)
        return 0

    def learn(self, state: int, action: int, reward: float) -> None:
        """Learn the reward."""
        self.Q[state, action] += 0.1 * (reward - self.Q[state, action])


@pytest.mark.filterwarnings("ignore:.*interpreted")
@pytest.mark.parametrize("at", [3, 2_345])
@pytest.mark.parametrize("agent", [Learner, Player])
def test_ctrl_c_ends_the_method_that_runs_interpreted(agent: Any, at: int) -> None:
    """It does so at once, not after the other steps of the call: among the first, checked steps, and after them."""
    CALLS.clear()
    mdp = edugym.make_mdp("Boulder")
    with pytest.raises(Interrupted) as interrupted:
        edugym.train(mdp, agent(np.zeros((mdp.height + 1, 10)), at), 100_000, evaluate_every=1_000)
    assert len(CALLS) == at
    assert not interrupted.value.partial.complete


@pytest.mark.parametrize("given_up", [False, True])
def test_ctrl_c_ends_the_interpreter_where_machine_code_failed(given_up: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """While it plays the failed call again, and once it has taken over."""
    monkeypatch.setattr(execution, "MOST_SURPRISES", 1)
    monkeypatch.setattr(execution, "_warn_once", lambda *_: None)
    ended = []

    def fails(*_: Any) -> None:
        raise ZeroDivisionError

    def presses(*_: Any) -> None:
        signal.raise_signal(signal.SIGINT)
        ended.append(True)

    code: Any = SimpleNamespace(first_change=lambda: None)
    run = execution._with_replay(fails, presses, code, (lambda *_: None) if given_up else presses)

    def work() -> None:
        with Work() as work:
            work.hold(machine_code=True)
            for _ in range(1 + given_up):
                run(1)

    with pytest.raises(KeyboardInterrupt):
        work()
    assert not ended


@pytest.mark.parametrize(("is_set", "expected"), [(None, 300), (False, 300), (True, 0)])
def test_nothing_is_compiled_for_a_run_that_is_stopped_already(
    is_set: bool | None, expected: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has no steps to come; one that may be stopped has all of them."""
    seen: list[int] = []

    def trainer(environment: Any, agent: Any, seed: int, max_steps: int | None, expected: int) -> Any:
        seen.append(expected)
        return trainers.trainer(environment, agent, seed, max_steps, expected)

    monkeypatch.setattr("edugym.training.train.trainer", trainer)
    stop = None if is_set is None else threading.Event()
    if stop is not None and is_set:
        stop.set()
    run = edugym.train(Ring(), QLearning.create(Ring()), 300, stop=stop)
    assert (seen, run.complete) == ([expected], not is_set)
