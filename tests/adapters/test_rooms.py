"""What agents without a table see in training: arrays as they are, or vectors."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.wrappers import FlattenObservation

from edugym import LinearQLearning, make_environment, make_mdp, train
from edugym.compiled import execution
from edugym.mdp.protocol import Random
from edugym.training import trainers
from edugym.training.trainers import trainer
from tests.agents.case import same


class Notes(NamedTuple):
    """An agent that always does the same, with room to write down what it is shown.

    Attributes:
        before: shape (n, ...): the observations before its steps.
        after: shape (n, ...): those after them.
        time: shape (1,): how many steps there were.
    """

    before: Any
    after: Any
    time: Any

    def act(self, state: Any, rng: Random) -> int:
        """Action 0."""
        return 0

    @property
    def tabular(self) -> bool:
        """It has no table."""
        return False


class OffPolicyNotes(Notes):
    """Writes what it sees down."""

    __slots__ = ()

    def learn(self, state: Any, action: Any, reward: float, next_state: Any) -> None:
        """Write it down, and forget the oldest."""
        t = self.time[0] % len(self.before)
        self.before[t] = state
        self.after[t] = next_state
        self.time[0] += 1


class VectorNotes(OffPolicyNotes):
    """The same for vectors."""

    __slots__ = ()

    @property
    def n_inputs(self) -> int:
        """Their length."""
        return int(self.before.shape[1])


class OnPolicyNotes(Notes):
    """The same for an agent that is told its next action."""

    __slots__ = ()

    def learn(self, state: Any, action: Any, reward: float, next_state: Any, next_action: Any) -> None:
        """Write it down, and forget the oldest."""
        t = self.time[0] % len(self.before)
        self.before[t] = state
        self.after[t] = next_state
        self.time[0] += 1


def notes(kind: type[Notes], *shape: int) -> Notes:
    """For 40 observations of a shape."""
    return kind(np.zeros((40, *shape)), np.zeros((40, *shape)), np.zeros(1, np.int64))


@pytest.mark.parametrize(
    ("name", "parameters", "n"),
    [
        ("Catch", {}, 50),
        ("Catch", {"observation_type": "rgb"}, 150),
        ("Catch", {"observation_type": "vectorised"}, 20),
        ("Boulder", {}, 11),
        ("Golf", {}, None),
        ("Tamagotchi", {}, None),
    ],
)
def test_vectors_are_those_of_flatten_observation(name: str, parameters: dict[str, Any], n: int | None) -> None:
    """What an agent is shown in `train` is what Gymnasium's wrapper shows in a loop by hand."""
    env = FlattenObservation(make_environment(name, **parameters))
    assert env.observation_space.shape is not None
    length = env.observation_space.shape[0]
    assert n in (None, length)
    agent = notes(VectorNotes, length)
    train(make_mdp(name, **parameters), agent, 40, seed=3)
    rng = np.random.SeedSequence(3).spawn(4)[0]
    by_hand = notes(VectorNotes, length)
    observation, _ = env.reset(seed=0)
    env.unwrapped.np_random = np.random.default_rng(rng)
    observation, _ = env.reset()  # from the stream that `train` has
    for t in range(40):
        by_hand.before[t] = observation
        observation, _, terminated, truncated, _ = env.step(0)
        by_hand.after[t] = observation
        if terminated or truncated:
            observation, _ = env.reset()
    assert np.array_equal(agent.before, by_hand.before)
    assert np.array_equal(agent.after, by_hand.after)


@pytest.mark.parametrize("kind", [OffPolicyNotes, OnPolicyNotes])
def test_other_agents_see_arrays_as_they_are(kind: type[Notes], monkeypatch: pytest.MonkeyPatch) -> None:
    """Compiled and not the same; an observation is not overwritten by the next, and is the next step's first one."""
    mdp, agents = make_mdp("Catch"), []
    for run_it in (execution.executable, lambda loop, *_, **__: loop):
        monkeypatch.setattr(trainers, "executable", run_it)
        agents.append(notes(kind, 10, 5))
        train(mdp, agents[-1], 6_000, seed=1, evaluate_every=6_000)
    assert same(agents[0], agents[1])
    before, after = agents[0].before, agents[0].after
    assert (before != after).any(axis=(1, 2)).all()  # the ball falls at every step
    goes_on = (after[:-1] == before[1:]).all(axis=(1, 2))
    assert 40 * 7 / 9 < goes_on.sum() < 39  # all but the last of nine steps


def test_the_loops_handle_no_arrays() -> None:
    """Between two steps there are only numbers: what machine code without reference counts asks for."""
    for agent in (LinearQLearning.create(make_mdp("Catch")), notes(OffPolicyNotes, 10, 5)):
        training: Any = trainer("Catch", agent, 0, None, expected=10)
        training.learn(7)
        assert all(isinstance(part, int | float) for part in training._carry[1:])


def test_an_agent_of_another_size_is_refused() -> None:
    """The message says which size the environment has."""
    with pytest.raises(ValueError, match="agent must be one for n_inputs = 50, as this environment has, but its is 11"):
        train("Catch", LinearQLearning.create(make_mdp("Boulder")), 10)
    with pytest.raises(ValueError, match="agent must be one for n_actions = 3, as this environment has, but its is 2"):
        train("Catch", LinearQLearning.create((50, 2)), 10)
    with pytest.raises(ValueError, match="a vector needs observations that are numbers"):
        LinearQLearning.create(_Texts())


class _Texts(NamedTuple):
    """Observes texts."""

    @property
    def observation_space(self) -> spaces.Text:
        """Up to five letters."""
        return spaces.Text(5)

    @property
    def action_space(self) -> spaces.Discrete:
        """Two actions."""
        return spaces.Discrete(2)


class Forgetful(NamedTuple):
    """Observes something else than it says.

    Attributes:
        seen: what it observes.
    """

    seen: Any

    def initial(self, rng: Random) -> int:
        """The only state."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """The same."""
        return state

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """None at all."""
        return 0.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Random) -> Any:
        """What was forgotten: a `return`, or a number."""
        return self.seen

    @property
    def observation_space(self) -> spaces.Box:
        """Two numbers."""
        return spaces.Box(-1.0, 1.0, (2,), np.float32)

    @property
    def action_space(self) -> spaces.Discrete:
        """Two actions."""
        return spaces.Discrete(2)


@pytest.mark.parametrize("seen", [None, 0.5, (0.5,), (0.5, 0.5, 0.5), np.zeros((2, 1))])
def test_an_observation_of_another_shape_is_refused(seen: Any) -> None:
    """It would be stretched to fit, or become NaN."""
    mdp = Forgetful(seen)
    with pytest.raises(ValueError, match="observation of Forgetful must give what its observation_space says, Box"):
        train(mdp, LinearQLearning.create(mdp), 10)


@pytest.mark.parametrize(
    ("space", "seen", "vector"),
    [
        (spaces.Discrete(3, start=5), 6, [0, 1, 0]),
        (spaces.MultiDiscrete([2, 3], start=[5, -1]), (6, -1), [0, 1, 1, 0, 0]),
    ],
)
def test_whole_numbers_that_do_not_start_at_0(space: spaces.Space[Any], seen: Any, vector: list[int]) -> None:
    """The lowest is the first place of a vector."""

    class Shifted(Forgetful):
        """Observes whole numbers."""

        __slots__ = ()
        observation_space: Any = property(lambda self: space)

    agent = notes(VectorNotes, len(vector))
    train(Shifted(seen), agent, 40, seed=0)
    assert agent.before.tolist() == agent.after.tolist() == [vector] * 40
