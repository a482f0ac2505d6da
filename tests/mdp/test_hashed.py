"""Hashed rows: exact, in order of first appearance, and as good for learning as the dense table they stand for."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given
from hypothesis import strategies as st

from edugym import FrameStack, Hashed, HashedTable, QLearning, make_mdp, train
from edugym.envs.catch import CatchGrid, Fall
from edugym.mdp.hashed_table import PRIME
from edugym.mdp.in_place import SeveralNumbers, WholeArray, blank, in_place
from edugym.mdp.protocol import writes_in_place
from tests.mdp.watch import Shows
from tests.training.slips import named

NUMBERS = st.one_of(
    st.floats(allow_nan=False, allow_infinity=False),
    st.sampled_from([0.0, -0.0, 1.0, PRIME, 2.0 * PRIME, -1.0, 0.5, 1e-300, 5e-324]),
)


@given(st.lists(st.tuples(NUMBERS, NUMBERS), max_size=40), st.integers(1, 40))
def test_rows_are_those_of_a_dictionary(keys: list[tuple[float, float]], capacity: int) -> None:
    """In order of first appearance; -0.0 is 0.0, and no two other keys are the same; who comes late may share a row."""
    table, sharing = HashedTable.create(np.zeros(2), 40), HashedTable.create(np.zeros(2), capacity, overflow=True)
    known: dict[tuple[float, float], int] = {}
    for key in keys:
        row = known.setdefault(key, len(known))
        assert table.row(np.array(key)) == row
        assert sharing.row(np.array(key)) == min(row, capacity - 1)
    assert (table.used, table.capacity) == (len(known), 40)
    assert (sharing.used, sharing.capacity) == (min(len(known), capacity), capacity)


def test_keys_that_belong_in_the_same_slot() -> None:
    """They take the next ones, to the last row, and around the end of the slots; then the table is full."""
    table = HashedTable.create(np.zeros(1, np.int64), 4)
    alike = [key for key in map(np.array, zip(range(999))) if table.slot(key) == 8][:4]  # the last of 9 slots
    assert [table.row(key) for key in alike + alike[::-1]] == [0, 1, 2, 3, 3, 2, 1, 0]
    named("full capacity overflow=True", lambda: table.row(np.array([1_000])))
    assert table.used == 4


SPREAD: dict[str, Any] = {
    "first": lambda k: (k, 0, 0),
    "second": lambda k: (0, k, 0),
    "digits": lambda k: (k % 10, k // 10 % 10, k // 100),
    "fraction first": lambda k: (k / 1_000, 0.5),
    "fraction last": lambda k: (0.5, k / 1_000),
    "pixels": lambda k: [(k >> bit) & 1 for bit in range(20)],
}


@pytest.mark.parametrize("capacity", [1_000, 100_000])
@pytest.mark.parametrize("numbers", SPREAD.values(), ids=SPREAD)
def test_keys_are_spread_over_the_slots(numbers: Any, capacity: int) -> None:
    """Wherever they differ, a search takes few steps; it would take as many as there are keys among full slots."""
    keys = [np.array(numbers(k)) for k in range(1_000)]
    table = HashedTable.create(keys[0], capacity)
    homes = np.array([table.slot(key) for key in keys])
    assert len(np.unique(homes)) > 700
    assert [table.row(key) for key in keys] == [*range(1_000)]
    places = np.flatnonzero(table.slots)[np.argsort(table.slots[table.slots > 0])]
    assert np.mean((places - homes) % len(table.slots)) < 1.5


BOULDER = make_mdp("Boulder")
REFUSED: list[tuple[Any, str]] = [
    (lambda: Hashed.create(BOULDER, 0), "capacity 1 0"),
    (lambda: Hashed.create(BOULDER, 3.0), "capacity 1 3.0"),  # type: ignore[arg-type]
    (lambda: Hashed.create(BOULDER, 2**28 + 1), f"capacity {2**28} {2**28 + 1}"),
    (lambda: HashedTable.create(np.zeros(10_000), 2**28), "keys terabytes capacity"),
    (lambda: Hashed.create(Shows(spaces.Text(3), "a"), 10), "mdp numbers Text"),
    (lambda: Hashed.create(Shows(spaces.MultiDiscrete([5, 5]), (1, 2, 3)), 10), "mdp (1, 2, 3) MultiDiscrete"),
    (lambda: Hashed.create(3, 10), "mdp 3"),
    (lambda: HashedTable.create(np.zeros(2), 2).row(np.array([0.0, np.nan])), "finite"),
    (lambda: HashedTable.create(np.zeros(2), 2).row(np.array([np.inf, 0.0])), "finite"),
]


def test_what_is_refused() -> None:
    """Capacities, memory that there is not, and observations that have no row."""
    for call, names in REFUSED:
        named(names, call)


@pytest.mark.parametrize("kind", ["grid", pytest.param("rgb", marks=pytest.mark.slow)])
def test_a_hashed_table_of_pixels_learns_exactly_as_one_of_positions(kind: str) -> None:
    """Lesson 4: images and states are one to one, so the same seed gives the same curve and the same values."""
    tasks: list[Any] = [make_mdp("Catch", observation_type="vectorised")]
    tasks.append(Hashed.create(make_mdp("Catch", observation_type=kind), capacity=250))
    agents = [QLearning.create(task, learning_rate=0.5, discount=1.0) for task in tasks]
    how: dict[str, Any] = {"seed": 2, "evaluate_every": 1_000, "evaluation_episodes": 20}
    runs = [train(task, agent, 4_000, **how) for task, agent in zip(tasks, agents, strict=True)]
    assert np.array_equal(runs[0].returns, runs[1].returns)
    assert runs[1].returns[-1] > runs[1].returns[0] + 0.3
    before = tasks[1].used
    assert 100 < before <= 250
    met = [k for k in range(250) if agents[0].Q[k].any()]
    for k in met:
        fall = Fall(k // 50, k // 5 % 10, k % 5)
        assert np.array_equal(agents[1].Q[tasks[1].observation(fall, None)], agents[0].Q[k])
    assert len(met) > 50
    assert tasks[1].used == before


FORMS: dict[str, tuple[Any, Any]] = {
    "a row": (make_mdp("Boulder"), np.int64),
    "62 bits": (FrameStack.create(make_mdp("MemoryCorridor"), 31), np.int64),
    "numbers": (make_mdp("Golf"), np.int64),
    "tuples": (make_mdp("Trashbot"), np.float64),
    "what is written": (make_mdp("Catch"), np.float64),
    "arrays": (make_mdp("Catch", observation_type="rgb"), np.int64),
}


@pytest.mark.parametrize(("mdp", "kind"), FORMS.values(), ids=FORMS)
def test_forms_of_observations(mdp: Any, kind: Any) -> None:
    """They are written over what was there, in the right kind of numbers; the same have the same row."""
    task, hashed, out = in_place(mdp), Hashed.create(mdp, 1_000), blank(in_place(mdp))
    assert (task is mdp) == hasattr(mdp, "observe_into")
    assert out.dtype == kind
    rng, known = np.random.default_rng(0), dict[bytes, int]()
    state, actions = mdp.initial(rng), mdp.action_space  # which may be a new one each time
    actions.seed(0)
    for _ in range(50):
        shown = np.array(mdp.observation(state, rng))
        out[...] = 77
        task.observe_into(state, rng, out)
        assert np.array_equal(np.ravel(out), np.ravel(shown))
        assert hashed.observation(state, rng) == known.setdefault(shown.tobytes(), len(known))
        state = mdp.initial(rng) if mdp.terminal(state) else mdp.transition(state, actions.sample(), rng)
    assert len(known) > 3


@pytest.mark.parametrize("seen", [-0.75, (-0.75,), np.array([-0.75]), (0.25, -0.5), np.array([[0.25], [-0.5]])])
def test_real_numbers_stay_what_they_are(seen: Any) -> None:
    """One alone, several, or an array."""
    task = in_place(Shows(spaces.Box(-1.0, 1.0, np.shape(seen) or (1,), np.float64), seen))
    out = blank(task)
    task.observe_into(0, None, out)
    assert out.dtype == np.float64
    assert np.array_equal(out, np.reshape(seen, out.shape))
    if np.ndim(seen):  # machine code copies an array at once, and a tuple number by number
        assert type(task) is (WholeArray if isinstance(seen, np.ndarray) else SeveralNumbers)


def test_other_forms() -> None:
    """A tuple space is one row, as in `Tabular`; another number of numbers than is said is refused."""
    task = in_place(Shows(spaces.Tuple((spaces.Discrete(3, start=1), spaces.Discrete(2))), (2, 0)))
    out = blank(task)
    task.observe_into(0, None, out)
    assert out.tolist() == [2]
    for seen, shape in (((0.25, -0.5), (1,)), (0.25, (2,)), (np.zeros((1, 2)), (2,))):
        space = spaces.Box(-1.0, 1.0, shape, np.float64)
        named(f"mdp {seen!r} {space}", lambda: in_place(Shows(space, seen)))  # noqa: B023


def test_a_subclass_that_overrides_observation_alone() -> None:
    """What it observes is written, not what its parent does."""
    half = {"__slots__": (), "observation": lambda self, *of: CatchGrid.observation(self, *of) / 2}
    darker: Any = type("Darker", (CatchGrid,), half)(4, 3)
    assert writes_in_place(CatchGrid(4, 3))
    assert not writes_in_place(darker)
    task, out = in_place(darker), np.zeros((4, 3))
    task.observe_into(darker.initial(np.random.default_rng(0)), None, out)
    assert out.max() == 0.5
