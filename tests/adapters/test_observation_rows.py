"""What n copies show is written into the rows of one array, whatever an observation is made of."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym.adapters.columns import RowsInPlace, WholeRows, observation_rows
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.envs.catch import CatchGrid, CatchImage
from edugym.mdp.protocol import Random


class Walk(NamedTuple):
    """Ten steps to the right; what is seen of them is a pair."""

    width: int

    def initial(self, rng: Random) -> int:
        """The first cell, or the second."""
        return int(rng.random() * 2)

    def transition(self, state: int, action: int, rng: Random) -> int:
        """A step."""
        return state + 1 + action

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """As far as one got."""
        return float(next_state)

    def terminal(self, state: int) -> bool:
        """The last cell."""
        return state >= 10

    def observation(self, state: int, rng: Random) -> Any:
        """The cell, and something about it."""
        return state, state * self.width

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """Two numbers."""
        return spaces.Box(-1e3, 1e3, (2,), np.float64)

    @property
    def action_space(self) -> spaces.Discrete:
        """Slow or fast."""
        return spaces.Discrete(2)


class Mixed(Walk):
    """Of several types."""

    __slots__ = ()

    def observation(self, state: int, rng: Random) -> Any:
        """A number and whether it is even."""
        return 0.5 * state, state % 2 == 0


class Noisy(Walk):
    """Drawn at random."""

    __slots__ = ()

    def observation(self, state: int, rng: Random) -> Any:
        """The cell, roughly."""
        return state + rng.random(), state


class Nested(Walk):
    """Of tuples in tuples."""

    __slots__ = ()

    def observation(self, state: int, rng: Random) -> Any:
        """A row of numbers and another one."""
        return (state, 1, 2), (3, state + 1, -state)

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """Two rows of three numbers."""
        return spaces.Box(-1e3, 1e3, (2, 3), np.float32)


class Array(Walk):
    """An array of its own."""

    __slots__ = ()

    def observation(self, state: int, rng: Random) -> Any:
        """Two numbers, the second drawn at random."""
        seen = np.zeros(2)
        seen[0] = state
        seen[1] = rng.random()
        return seen


class InPlace(Array):
    """The same, written where it belongs."""

    __slots__ = ()

    def observe_into(self, state: int, rng: Random, out: Any) -> None:
        """The same."""
        out[0] = state
        out[1] = rng.random()


class Changed(InPlace):
    """Overrides one of the two ways to observe and inherits the other."""

    __slots__ = ()

    def observation(self, state: int, rng: Random) -> Any:
        """Something else."""
        seen = np.zeros(2)
        seen[0] = -state
        return seen


def run(env: Any, shape: tuple[int, ...]) -> list[Any]:
    """All that is seen from seed 2 on, when every action is 1: observations, the last ones of episodes, and rewards."""
    seen = []
    observation, _ = env.reset(seed=2)
    seen.append(np.reshape(observation, shape).tolist())
    for _ in range(30):
        action = np.ones(1, np.int64) if isinstance(env, MDPVectorEnv) else 1
        observation, reward, terminated, _, infos = env.step(action)
        last = None
        if np.all(terminated):
            last = np.reshape(infos["final_obs"][0] if "final_obs" in infos else observation, shape).tolist()
            observation = observation if "final_obs" in infos else env.reset()[0]
        seen.append((np.reshape(observation, shape).tolist(), last, float(np.squeeze(reward))))
    return seen


@pytest.mark.parametrize("kind", [Walk, Mixed, Noisy, Nested, Array, InPlace, Changed])
def test_one_copy_shows_what_the_environment_shows(kind: type[Walk]) -> None:
    """Observations of every kind, last ones included, with the random numbers that they take."""
    env = MDPEnv(kind(3))
    shape = env.observation_space.shape or ()
    alone = run(env, shape)
    assert run(MDPVectorEnv(env, 1, "SameStep"), shape) == alone
    assert any(last is not None for _, last, _ in alone[1:])


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", [Walk, Mixed, Noisy, Nested, Array, InPlace, Changed])
def test_all_of_it_compiles(kind: type[Walk]) -> None:
    """No kind of observation makes the copies run interpreted, of which a warning would tell."""
    vector = MDPVectorEnv(MDPEnv(kind(3)), 4)
    observations, _ = vector.reset(seed=0)
    assert observations.shape == (4, *(vector.single_observation_space.shape or ()))
    vector.step(np.zeros(4, np.int64))
    assert vector.is_compiled


def test_in_place_only_where_it_is_the_same() -> None:
    """An MDP writes in place where it says how; not where a subclass says only what else is seen."""
    sample = np.zeros(2)
    assert observation_rows(InPlace(1), sample) is RowsInPlace
    assert observation_rows(CatchImage(3, 3), sample) is RowsInPlace
    assert observation_rows(Array(1), sample) is WholeRows
    assert observation_rows(Changed(1), sample) is WholeRows


@pytest.mark.parametrize("kind", [CatchGrid, CatchImage])
def test_nothing_is_left_over(kind: Any) -> None:
    """A row is filled as a whole: what was in the memory before does not show."""
    mdp, rng = kind(4, 3), np.random.default_rng(0)
    state = mdp.initial(rng)
    rows = observation_rows(mdp, mdp.observation(state, rng))(np.full((2, *mdp.observation_space.shape), 77, "uint8"))
    rows.put(1, mdp, state, rng)
    assert rows.rows[1].tolist() == mdp.observation(state, rng).tolist()
    assert (rows.rows[0] == 77).all()
