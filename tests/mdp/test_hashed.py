"""Hashed rows: exact, in order of first appearance, and as good for learning as the dense table they stand for."""

import copy
import pickle
from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import (
    FrameStack,
    Hashed,
    HashedTable,
    MDPEnv,
    NoisyObservation,
    QLearning,
    finite_model,
    make_mdp,
    train,
    value_iteration,
)
from edugym.envs.catch import Fall
from edugym.mdp.hashed_table import PRIME
from tests.mdp.watch import watched

NUMBERS = st.one_of(
    st.floats(allow_nan=False, allow_infinity=False),
    st.sampled_from([0.0, -0.0, 1.0, PRIME, 2.0 * PRIME, -1.0, 0.5, 1e-300, 5e-324]),
)


@given(st.lists(st.tuples(NUMBERS, NUMBERS), max_size=40))
@settings(max_examples=100, deadline=None)
def test_rows_are_those_of_a_dictionary(keys: list[tuple[float, float]]) -> None:
    """In order of first appearance; -0.0 is 0.0, and no two other keys are the same."""
    table = HashedTable.create(np.zeros(2), 40)
    known: dict[tuple[float, float], int] = {}
    for key in keys:
        assert table.row(np.array(key)) == known.setdefault(key, len(known))
    assert (table.used, table.capacity) == (len(known), 40)


def test_keys_that_belong_in_the_same_slot() -> None:
    """They take the next ones, to the last row, and around the end of the slots."""
    table = HashedTable.create(np.zeros(1, np.int64), 4)
    alike = [key for key in map(np.array, zip(range(999))) if table.slot(key) == 8][:4]  # the last of 9 slots
    assert [table.row(key) for key in alike + alike[::-1]] == [0, 1, 2, 3, 3, 2, 1, 0]


@pytest.mark.parametrize("capacity", [1_000, 100_000])
@pytest.mark.parametrize(
    "numbers",
    [
        lambda k: (k, 0, 0),
        lambda k: (0, k, 0),
        lambda k: (k % 30, k // 30),
        lambda k: (k % 10, k // 10 % 10, k // 100),
        lambda k: (k / 1_000, 0.5),
        lambda k: (0.5, k / 1_000),
        lambda k: [(k >> bit) & 1 for bit in range(20)],
    ],
    ids=["first", "second", "places", "digits", "fraction first", "fraction last", "pixels"],
)
def test_keys_are_spread_over_the_slots(numbers: Any, capacity: int) -> None:
    """Wherever they differ, a search takes few steps; it would take as many as there are keys among full slots."""
    keys = [np.array(numbers(k)) for k in range(1_000)]
    table = HashedTable.create(keys[0], capacity)
    homes = np.array([table.slot(key) for key in keys])
    assert len(np.unique(homes)) > 700
    assert [table.row(key) for key in keys] == [*range(1_000)]
    places = np.flatnonzero(table.slots)[np.argsort(table.slots[table.slots > 0])]
    assert np.mean((places - homes) % len(table.slots)) < 1.5


def test_a_full_table() -> None:
    """A new key is an error that says what to do, or shares the last row; those that are known keep theirs."""
    table = HashedTable.create(np.zeros(1, np.int64), 2)
    assert [table.row(np.array([key])) for key in (5, 7, 5)] == [0, 1, 0]
    with pytest.raises(ValueError, match="the hashed table is full: give it a higher capacity, or overflow=True"):
        table.row(np.array([6]))
    assert table.used == 2
    sharing = HashedTable.create(np.zeros(1, np.int64), 2, overflow=True)
    assert [sharing.row(np.array([key])) for key in (5, 7, 6, 8, 5)] == [0, 1, 1, 1, 0]


def test_numbers_that_are_none_have_no_row() -> None:
    """NaN would be new at every step."""
    table = HashedTable.create(np.zeros(2), 2)
    for wrong in (np.nan, np.inf):
        with pytest.raises(ValueError, match="is not finite"):
            table.row(np.array([0.0, wrong]))
    assert table.used == 0


@pytest.mark.parametrize("capacity", [0, 2**28 + 1, 3.0, None])
def test_capacity(capacity: Any) -> None:
    """A whole number from 1 on."""
    with pytest.raises(ValueError, match="capacity must be"):
        Hashed.create(make_mdp("Boulder"), capacity)


def test_memory_is_checked() -> None:
    """Keys for which there is no memory are refused before anything is made."""
    with pytest.raises(ValueError, match=r"keys would be a table of .* terabytes .*: take a lower capacity"):
        HashedTable.create(np.zeros(10_000), 2**28)


@pytest.mark.parametrize("kind", ["grid", "rgb"])
def test_a_hashed_table_of_pixels_learns_exactly_as_one_of_positions(kind: str) -> None:
    """Lesson 4: images and states are one to one, so the same seed gives the same curve and the same values."""
    positions = make_mdp("Catch", observation_type="vectorised")
    pixels: Any = Hashed.create(make_mdp("Catch", observation_type=kind), capacity=250)
    agents = [QLearning.create(task, learning_rate=0.5, discount=1.0) for task in (positions, pixels)]
    runs = [
        train(task, agent, 4_000, seed=2, evaluate_every=1_000, evaluation_episodes=20)
        for task, agent in zip((positions, pixels), agents, strict=True)
    ]
    assert np.array_equal(runs[0].returns, runs[1].returns)
    assert runs[1].returns[-1] > runs[1].returns[0] + 0.3
    before = pixels.used
    assert 100 < before <= 250
    compared = 0
    for ball_x in range(5):
        for ball_y in range(9):
            for paddle_x in range(5):
                values = agents[0].Q[(ball_x * 10 + ball_y) * 5 + paddle_x]
                if values.any():
                    row = pixels.observation(Fall(ball_x, ball_y, paddle_x), None)
                    assert np.array_equal(agents[1].Q[row], values)
                    compared += 1
    assert compared > 50
    assert pixels.used == before


def test_evaluation_changes_nothing_in_the_training() -> None:
    """However often it is evaluated, the agent has learnt the same about every observation."""
    learnt = []
    for evaluate_every in (100, 3_000):
        task = Hashed.create(make_mdp("Catch"), 300)
        agent = QLearning.create(task, learning_rate=0.5)
        train(task, agent, 3_000, seed=1, evaluate_every=evaluate_every, evaluation_episodes=5)
        grids: dict[bytes, Any] = {}
        for row in range(task.used):
            if agent.Q[row].any():
                grids[task.table.keys[row].tobytes()] = agent.Q[row].tolist()
        learnt.append(grids)
    assert learnt[0] == learnt[1]


def test_every_image_is_new_under_noise_of_real_numbers() -> None:
    """Lesson 4: a table cannot generalise; one noisy pixel of few levels only makes more rows."""
    catch = make_mdp("Catch")
    real = Hashed.create(NoisyObservation.create(catch, sigma=0.1), 2_000)
    assert watched(real)[:, 0].tolist() == list(range(2_000))
    assert real.used == 2_000
    few = Hashed.create(NoisyObservation.create(catch, levels=3), 2_000)
    plain = Hashed.create(catch, 2_000)
    watched(few), watched(plain)
    assert 2 * plain.used < few.used <= 3 * plain.used + 5


def test_forms_of_observations() -> None:
    """Numbers, tuples, arrays and 62-bit rows; the row is the same for the same observation."""
    long = FrameStack.create(make_mdp("MemoryCorridor"), 31)
    for mdp in (long, make_mdp("Golf"), make_mdp("Trashbot"), make_mdp("Catch", observation_type="rgb")):
        task: Any = Hashed.create(mdp, 1_000)
        env, rng = MDPEnv(task), np.random.default_rng(0)
        known: dict[bytes, int] = {}
        env.action_space.seed(0)
        row, _ = env.reset(seed=0)
        over = False
        for _ in range(50):
            shown = np.array(mdp.observation(env.state, rng)).tobytes()
            assert row == known.setdefault(shown, len(known))
            if over:
                row, _ = env.reset()
            else:
                row, _, terminated, truncated, _ = env.step(env.action_space.sample())
            over = not over and (terminated or truncated)
        assert len(known) > 3


def test_machine_code_does_the_same() -> None:
    """Rows, rewards and the table itself."""
    tasks = [Hashed.create(FrameStack.create(make_mdp("MemoryCorridor"), 25, actions=False), 2_000) for _ in range(2)]
    assert np.array_equal(watched(tasks[0], machine_code=True), watched(tasks[1]))
    for one, other in zip(tasks[0].table, tasks[1].table, strict=True):
        assert np.array_equal(one, other)
    with pytest.raises(ValueError, match="the hashed table is full"):
        watched(Hashed.create(FrameStack.create(make_mdp("MemoryCorridor"), 25), 3), machine_code=True)


def test_copies_have_a_table_of_their_own() -> None:
    """Copied or pickled, a wrapper knows what it knew, and learns alone what comes after."""
    task: Any = Hashed.create(make_mdp("Boulder", height=3), 4)
    assert task.observation(2, None) == 0
    for same in (copy.deepcopy(task), pickle.loads(pickle.dumps(task))):
        assert same.observation(1, None) == 1
        assert same.observation(2, None) == 0
    assert task.used == 1


class Liar(NamedTuple):
    """Shows something else than its observation space says."""

    shown: Any
    observation_space: spaces.Space[Any]
    action_space: spaces.Space[Any] = spaces.Discrete(2)

    def initial(self, rng: Any) -> int:
        """The only state."""
        return 0

    def transition(self, state: int, action: int, rng: Any) -> int:
        """It stays."""
        return state

    def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
        """None."""
        return 0.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Any) -> Any:
        """Whatever."""
        return self.shown


def test_observations_that_have_no_row() -> None:
    """Each is refused when the wrapper is made, in one sentence."""
    with pytest.raises(ValueError, match="the observations of mdp must be numbers, but its observation space is Text"):
        Hashed.create(Liar("a", spaces.Text(3)), 10)
    with pytest.raises(ValueError, match=r"mdp observes \(1, 2, 3\), which is not as its observation space says"):
        Hashed.create(Liar((1, 2, 3), spaces.MultiDiscrete([5, 5])), 10)
    with pytest.raises(ValueError, match=r"mdp must be an MDP, .* but is 3"):
        Hashed.create(3, 10)


def test_the_exact_model_is_that_of_the_task() -> None:
    """A wrapper that only renames what is seen changes nothing that is computed."""
    wall = make_mdp("Boulder", height=3)
    hashed: Any = Hashed.create(wall, 10)
    values = [value_iteration(finite_model(task), discount=0.9) for task in (wall, hashed)]
    assert values[0].start == values[1].start == pytest.approx(0.9**2)
