"""Observations and actions that are tuples or arrays of real numbers, of agents as students write them."""

from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import make_environment, make_mdp, train
from edugym.compiled import execution
from edugym.mdp.protocol import Random
from edugym.training import trainers
from tests.agents.case import same

pytestmark = pytest.mark.usefixtures("compiled_at_once")


class Turning(NamedTuple):
    """Turns both joints at random, and has a place for what it is told.

    Attributes:
        sums: shape (4,): of a number that it sees, of both numbers of its actions, and of the rewards.
    """

    sums: Any

    def act(self, state: Any, rng: Random) -> Any:
        """A tuple of two numbers."""
        return 0.5 * rng.random() - 0.25 + 0.1 * state[2], 0.5 * rng.random() - 0.25

    @property
    def tabular(self) -> bool:
        """It has no table."""
        return False


class Swinger(Turning):
    """Sums up what it is told."""

    __slots__ = ()

    def learn(self, state: Any, action: Any, reward: float, next_state: Any) -> None:
        """Add it up."""
        self.sums[0] += next_state[3] - state[2]
        self.sums[1] += action[0]
        self.sums[2] += action[1]
        self.sums[3] += reward


class ArraySwinger(Swinger):
    """The same with an array."""

    __slots__ = ()

    def act(self, state: Any, rng: Random) -> Any:
        """An array of two numbers."""
        return np.array([0.5 * rng.random() - 0.25 + 0.1 * state[2], 0.5 * rng.random() - 0.25])


class OnPolicySwinger(Turning):
    """The same, with what it will do next."""

    __slots__ = ()

    def learn(self, state: Any, action: Any, reward: float, next_state: Any, next_action: Any) -> None:
        """Add it up."""
        self.sums[0] += next_state[3] - state[2]
        self.sums[1] += action[0]
        self.sums[2] += next_action[1]
        self.sums[3] += reward


class OnPolicyArraySwinger(OnPolicySwinger):
    """The same with an array."""

    __slots__ = ()

    def act(self, state: Any, rng: Random) -> Any:
        """An array of two numbers."""
        return np.array([0.5 * rng.random() - 0.25 + 0.1 * state[2], 0.5 * rng.random() - 0.25])


@pytest.mark.parametrize("kind", [Swinger, ArraySwinger, OnPolicySwinger, OnPolicyArraySwinger])
def test_compiled_is_interpreted(kind: type[Turning], monkeypatch: pytest.MonkeyPatch) -> None:
    """Tuples and arrays are one, and machine code does what the interpreter does."""
    agents, compiled = [], []

    def noted(loop: Any, *arguments: Any, **options: Any) -> Any:
        fast = execution.executable(loop, *arguments, **options)
        compiled.append(fast is not loop)
        return fast

    for run_it in (noted, lambda loop, *_, **__: loop):
        monkeypatch.setattr(trainers, "executable", run_it)
        agents.append(kind(np.zeros(4)))
        run = train(make_mdp("Trashbot"), agents[-1], 6_000, seed=2, evaluate_every=3_000)
        assert run.complete
    assert compiled == [True, True]
    assert same(agents[0], agents[1])
    assert agents[0].sums.all()


def test_a_gymnasium_environment_gets_arrays() -> None:
    """A tuple of numbers does, too, where the environment asks for an array of its own type."""
    agent = Swinger(np.zeros(4))
    run = train("Pendulum-v1", _Pusher(np.zeros(4)), 300)
    assert run.episodes.sum() == 1
    env = make_environment("Trashbot")
    trainers.GymnasiumTrainer(env, agent, 0, None, 50).learn(50)
    assert agent.sums[1:3].all()


class _Pusher(Turning):
    """Pushes one way."""

    __slots__ = ()

    def act(self, state: Any, rng: Random) -> Any:
        """A tuple of one number."""
        return (0.5,)

    def learn(self, state: Any, action: Any, reward: float) -> None:
        """What it did is what it is told."""
        assert action == (0.5,)
