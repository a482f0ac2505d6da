"""Observations of several whole numbers as the row of a table, of MDPs and of any Gymnasium environment."""

import copy
import itertools
import math
import pickle
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given
from hypothesis import strategies as st

from edugym import QLearning, Tabular, TabularObservation, make_mdp, table_size, train
from edugym.adapters.fitting import tabular
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.compiled.compiler import compiled
from edugym.mdp.protocol import MDP, Random
from edugym.mdp.tabular import number_of_rows, table_sizes
from tests.compiled.cells import WALK, cell


class Clock(NamedTuple):
    """Counts 3 hours of 4 quarters; they are called 10, 11, 12 and -1, 0, 1, 2."""

    in_parts: bool
    max_steps: int = 50

    def initial(self, rng: Random) -> int:
        """Midnight."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """A quarter later, or (action 1) three quarters."""
        return (state + (1 if action == 0 else 3)) % 12

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """1 for a full hour."""
        return 1.0 if next_state % 4 == 0 else 0.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Random) -> tuple[int, int]:
        """Hour and quarter."""
        return 10 + state // 4, state % 4 - 1

    @property
    def observation_space(self) -> Any:
        """Hour and quarter, in one of two ways."""
        if self.in_parts:
            return spaces.Tuple([spaces.Discrete(3, start=10), spaces.Discrete(4, start=-1)])
        return spaces.MultiDiscrete([3, 4], start=[10, -1])

    @property
    def action_space(self) -> spaces.Discrete:
        """Wait a quarter or three."""
        return spaces.Discrete(2)


class Seen(NamedTuple):
    """A task of which only the space of its observations matters, and the one that it shows."""

    observation_space: Any
    shown: Any = None

    def observation(self, state: int, rng: Random) -> Any:
        """Always the same."""
        return self.shown


def seen(space: spaces.Space[Any], shown: Any = None) -> Any:
    """Such a task, which is not all that an MDP should be."""
    return Seen(space, shown)


class Shows(gymnasium.Env[Any, Any]):
    """A Gymnasium environment that shows the elements of a space that it is given, one after another."""

    def __init__(self, space: spaces.Space[Any], elements: list[Any], actions: int = 2) -> None:
        """Show these."""
        self.observation_space = space
        self.action_space = spaces.Discrete(actions)
        self.elements = elements
        self.shown = 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """The first."""
        super().reset(seed=seed)
        self.shown = 0
        return self.elements[0], {}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """The next."""
        self.shown += 1
        return self.elements[self.shown], 0.0, self.shown == len(self.elements) - 1, False, {}


def rows_shown(space: spaces.Space[Any], elements: list[Any]) -> list[int]:
    """The rows that stand for these elements."""
    env = TabularObservation(Shows(space, elements))
    rows = [env.reset()[0]] + [env.step(0)[0] for _ in elements[1:]]
    assert all(type(row) is int and env.observation_space.contains(row) for row in rows)
    return rows


def grid(*ranges: range) -> list[tuple[int, ...]]:
    """All tuples of these numbers, the last number fastest."""
    return list(itertools.product(*ranges))


@pytest.mark.parametrize(
    ("space", "elements"),
    [
        (spaces.Discrete(3), [0, 1, 2]),
        (spaces.Discrete(3, start=-1), [np.int64(-1), np.int64(0), np.int64(1)]),
        (spaces.MultiDiscrete([3, 4]), [np.array(e) for e in grid(range(3), range(4))]),
        (spaces.MultiDiscrete([2, 3], start=[5, -1]), [np.array(e) for e in grid(range(5, 7), range(-1, 2))]),
        (spaces.MultiDiscrete(np.array([[2], [3]])), [np.reshape(e, (2, 1)) for e in grid(range(2), range(3))]),
        (spaces.MultiBinary(3), [np.array(e, np.int8) for e in grid(range(2), range(2), range(2))]),
        (spaces.Tuple([spaces.Discrete(4), spaces.Discrete(2)]), grid(range(4), range(2))),
        (
            spaces.Tuple([spaces.Discrete(2, start=3), spaces.MultiDiscrete([2, 3], start=[0, 1])]),
            [(a, np.array([b, c])) for a, b, c in grid(range(3, 5), range(2), range(1, 4))],
        ),
        (
            spaces.Tuple([spaces.Tuple([spaces.Discrete(2), spaces.Discrete(3)]), spaces.Discrete(2)]),
            [((a, b), c) for a, b, c in grid(range(2), range(3), range(2))],
        ),
    ],
    ids=str,
)
def test_every_element_of_a_space_has_a_row_of_its_own(space: spaces.Space[Any], elements: list[Any]) -> None:
    """In order, the last number fastest, and no row is left over."""
    assert all(map(space.contains, elements))
    assert rows_shown(space, elements) == list(range(len(elements)))
    assert TabularObservation(Shows(space, elements)).observation_space == spaces.Discrete(len(elements))
    assert table_size(Shows(space, elements, actions=5)) == (len(elements), 5)


@pytest.mark.parametrize("in_parts", [True, False])
def test_an_mdp_has_the_same_rows(in_parts: bool) -> None:
    """Numbers need not begin at 0."""
    clock = tabular(Clock(in_parts))
    rng = np.random.default_rng(0)
    assert [clock.observation(state, rng) for state in range(12)] == list(range(12))
    assert clock.observation_space == spaces.Discrete(12)
    assert clock.action_space == spaces.Discrete(2)
    assert clock.max_steps == 50
    assert table_size(clock) == table_size(Clock(in_parts)) == (12, 2)


@given(st.lists(st.tuples(st.integers(1, 5), st.integers(-3, 3)), min_size=1, max_size=4), st.data())
def test_wrapper_and_mdp_number_alike(places: list[tuple[int, int]], data: st.DataObject) -> None:
    """Both give NumPy's index of an entry in an array of these sizes."""
    sizes, lows = zip(*places, strict=True)
    parts = [data.draw(st.integers(low, low + size - 1)) for size, low in places]
    shifted = [part - low for part, low in zip(parts, lows, strict=True)]
    space = spaces.MultiDiscrete(list(sizes), start=list(lows))
    row = tabular(seen(space, tuple(parts))).observation(0, np.random.default_rng(0))
    assert row == rows_shown(space, [np.array(parts)])[0] == np.arange(math.prod(sizes)).reshape(sizes)[tuple(shifted)]


def test_what_is_a_row_already_stays_as_it_is() -> None:
    """No wrapper where none is needed."""
    mdp, env = make_mdp("Boulder"), gymnasium.make("edugym/Boulder-v0")
    assert tabular(mdp) is mdp
    assert tabular(env) is env


def test_the_dynamics_are_those_of_the_task() -> None:
    """Only what is seen changes."""
    golf = make_mdp("Golf")
    wrapped: MDP[Any, Any] = tabular(golf)
    one, other = np.random.default_rng(4), np.random.default_rng(4)
    state = golf.initial(one)
    assert wrapped.initial(other) == state
    for action in (2, 1, 0):
        following = golf.transition(state, action, one)
        assert wrapped.transition(state, action, other) == following
        assert wrapped.reward(state, action, following, other) == golf.reward(state, action, following, one)
        assert wrapped.terminal(following) == golf.terminal(following)
        state = following
    assert not hasattr(wrapped, "max_steps")  # Golf has no step limit


def count_rows(n: int, mdp: Any, rng: Random, counts: Any) -> None:
    """Walk at random and count the rows that are shown."""
    state = mdp.initial(rng)
    for _ in range(n):
        counts[mdp.observation(state, rng)] += 1
        state = mdp.transition(state, int(rng.random() * 2), rng)


def test_it_compiles() -> None:
    """To the same."""
    clock = tabular(Clock(in_parts=False))
    interpreted, machine = np.zeros(12, np.int64), np.zeros(12, np.int64)
    count_rows(500, clock, np.random.default_rng(1), interpreted)
    compiled(count_rows, 500, clock, np.random.default_rng(1), machine)(500, clock, np.random.default_rng(1), machine)
    assert machine.tolist() == interpreted.tolist()
    assert machine.all()


def test_training_does_not_care_how_the_numbers_begin() -> None:
    """The same run, bit for bit, for an MDP and for a Gymnasium environment."""
    tables = []
    for environment in (Clock(False), Clock(True), gymnasium.Wrapper(MDPEnv(Clock(False)))):
        agent = QLearning.create(environment)
        train(environment, agent, 2_000, seed=3)
        tables.append(agent.Q)
    assert tables[0].any()
    assert np.array_equal(tables[0], tables[1])
    assert np.array_equal(tables[0], tables[2])


@pytest.mark.parametrize(
    "space", [spaces.Box(0, 1, (2,)), spaces.Dict(a=spaces.Discrete(2)), spaces.Tuple([spaces.Box(0, 1)])], ids=str
)
def test_what_is_not_whole_numbers_is_refused(space: spaces.Space[Any]) -> None:
    """The message shows the space."""
    for refuse in (lambda: TabularObservation(Shows(space, [])), lambda: tabular(seen(space))):
        with pytest.raises(ValueError, match=r"a table needs observations that are whole numbers, but .*(Box|Dict)"):
            refuse()


@pytest.mark.parametrize(
    "space",
    [
        spaces.MultiDiscrete(np.array([[2, 3], [2, 3]])),
        spaces.MultiBinary([2, 2]),
        spaces.Tuple([spaces.Discrete(2), spaces.MultiDiscrete([2, 3])]),
        spaces.Tuple([spaces.Discrete(2), spaces.Tuple([spaces.Discrete(2)])]),
    ],
    ids=str,
)
def test_numbers_in_one_another_are_refused(space: spaces.Space[Any]) -> None:
    """An MDP shows its numbers side by side; a Gymnasium environment may nest them."""
    with pytest.raises(ValueError, match=r"observation_space of an MDP must be flat for a table, but is (Multi|Tuple)"):
        tabular(seen(space))
    assert TabularObservation(Shows(space, [])).observation_space == spaces.Discrete(math.prod(table_sizes(space)))
    assert tabular(seen(spaces.MultiBinary(3))).observation_space == spaces.Discrete(8)


def test_an_mdp_that_does_not_number_from_0_is_refused() -> None:
    """A Discrete space that starts elsewhere would need another MDP; a Gymnasium environment is wrapped."""
    with pytest.raises(ValueError, match=r"an MDP must number its observations from 0, but .* Discrete\(3, start=1\)"):
        tabular(seen(spaces.Discrete(3, start=1)))


@pytest.mark.parametrize("space", [spaces.Box(-1, 1, (2,)), spaces.MultiDiscrete([2, 2]), spaces.Discrete(2, start=1)])
def test_actions_that_do_not_fit_a_table_are_refused(space: spaces.Space[Any]) -> None:
    """The columns of the table are the actions 0, 1, ..."""
    env = Shows(spaces.Discrete(2), [])
    env.action_space = space
    with pytest.raises(ValueError, match=r"a table needs the actions 0, 1, \.\.\., but the action space is"):
        table_size(env)


@pytest.mark.parametrize("thing", ["FrozenLake-v1", 5, None])
def test_what_is_no_environment_is_refused(thing: Any) -> None:
    """Such as the id of one, which only `train` takes."""
    with pytest.raises(ValueError, match="environment must be an MDP, a Gymnasium environment or a shape, but is"):
        table_size(thing)


@pytest.mark.parametrize(
    "outside",
    [np.array([0, 2]), np.array([0.5, 1.0]), (1,), np.array([[0, 1], [1, 1]]), 10**30, np.inf, None, "01", {"a": 1}],
    ids=str,
)
def test_an_observation_outside_the_space_is_an_error(outside: Any) -> None:
    """Rather than a wrong row, or an error of NumPy's."""
    env = TabularObservation(Shows(spaces.MultiDiscrete([2, 2]), [outside]))
    with pytest.raises(ValueError, match=r"observation .* is not in the observation space MultiDiscrete\(\[2 2\]\)"):
        env.reset()


@pytest.mark.parametrize("outside", [0, 4, 1.5, np.float32(2.5), np.array(4), np.array([1, 2]), -1, np.nan], ids=str)
def test_an_observation_that_is_no_element_of_a_discrete_space(outside: Any) -> None:
    """It is refused in the same words, whatever its type."""
    env = TabularObservation(Shows(spaces.Discrete(3, start=1), [outside]))
    with pytest.raises(ValueError, match=r"observation .* is not in the observation space Discrete\(3, start=1\)"):
        env.reset()


def test_whole_numbers_of_any_type() -> None:
    """2.0 stands for 2, and so do arrays of one number."""
    shown = [1, np.uint8(2), 3.0, np.float32(1.0), np.array(2), np.array([3]), np.array([1.0]), True]
    assert rows_shown(spaces.Discrete(3, start=1), shown) == [0, 1, 2, 0, 1, 2, 0, 0]
    assert rows_shown(spaces.MultiDiscrete([2, 3]), [np.array([1.0, 2.0]), (0.0, 1)]) == [5, 1]


def test_a_wrapped_environment_can_be_copied_and_pickled() -> None:
    """As evaluation and processes do."""
    env = TabularObservation(gymnasium.make("edugym/Golf-v0"))
    env.reset(seed=0)
    for other in (copy.deepcopy(env), pickle.loads(pickle.dumps(env))):
        assert other.step(2)[:4] == copy.deepcopy(env).step(2)[:4]
        assert other.observation_space == env.observation_space


def test_the_wrapped_mdp_is_a_value() -> None:
    """It holds the task, the sizes and the lowest values."""
    wrapped = tabular(make_mdp("Golf"))
    assert isinstance(wrapped, Tabular)
    assert wrapped.mdp == make_mdp("Golf")
    assert (wrapped.sizes.tolist(), wrapped.lows.tolist()) == ([7, 17], [0, 0])


def test_a_table_that_is_too_large_is_refused() -> None:
    """In words, for a Gymnasium environment as for an MDP."""
    space = spaces.MultiDiscrete([2**31] * 3)
    for refuse in (lambda: TabularObservation(Shows(space, [])), lambda: tabular(seen(space))):
        with pytest.raises(ValueError, match=r"the rows of a table over .* observations do not fit 63 bits"):
            refuse()
    assert number_of_rows([2**32 - 1, 2**31]) == 2**63 - 2**31
    assert number_of_rows([2**63 - 1]) == 2**63 - 1
    with pytest.raises(ValueError, match="over 9,223,372,036,854,775,808 observations do not fit 63 bits"):
        number_of_rows([2**32, 2**31])


def test_one_number_needs_no_table() -> None:
    """What is a row already is refused, with a word on what to do."""
    with pytest.raises(ValueError, match=r"mdp observes one whole number already, an element of Discrete\(6\)"):
        Tabular.create(cell(WALK)["Walk"](5))


class Writing(NamedTuple):
    """A task that writes two whole numbers in place."""

    observation_space: Any = spaces.MultiDiscrete([3, 4])

    def observe_into(self, state: int, rng: Any, out: Any) -> None:
        """Write them."""
        out[:] = state // 4, state % 4


def test_what_is_written_in_place_is_one_row() -> None:
    """The row of what the task has written last."""
    writing: Any = Writing()
    task: Any = Tabular.create(writing)
    assert [task.observation(state, None) for state in (7, 0, 11)] == [7, 0, 11]
