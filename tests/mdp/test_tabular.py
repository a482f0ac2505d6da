"""Observations of several whole numbers as the row of a table, of MDPs and of any Gymnasium environment."""

import itertools
import math
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given
from hypothesis import strategies as st

from edugym import QLearning, Tabular, TabularObservation, make_mdp, table_size
from edugym.adapters.fitting import tabular
from edugym.mdp.tabular import number_of_rows
from tests.compiled.cells import WALK, cell
from tests.mdp.watch import Shows
from tests.training.slips import named

Showing = cell("""
import gymnasium
class Showing(gymnasium.Env):
    def __init__(self, space, elements, actions=2):
        self.observation_space, self.action_space, self.elements = space, spaces.Discrete(actions), elements
        self.shown = 0
    def reset(self, *, seed=None, options=None):
        self.shown = 0
        return self.elements[0], {}
    def step(self, action):
        self.shown += 1
        return self.elements[self.shown], 0.0, self.shown == len(self.elements) - 1, False, {}
""")["Showing"]
"""A Gymnasium environment that shows the elements of a space that it is given, one after another."""


def rows_shown(space: spaces.Space[Any], elements: list[Any]) -> list[int]:
    """The rows that stand for these elements."""
    env = TabularObservation(Showing(space, elements))
    rows = [env.reset()[0]] + [env.step(0)[0] for _ in elements[1:]]
    assert all(type(row) is int and env.observation_space.contains(row) for row in rows)
    return rows


def grid(*ranges: range) -> list[tuple[int, ...]]:
    """All tuples of these numbers, the last number fastest."""
    return list(itertools.product(*ranges))


TWO = range(2)
ALL: list[tuple[spaces.Space[Any], list[Any]]] = [
    (spaces.Discrete(3), [0, 1, 2]),
    (spaces.Discrete(3, start=-1), [np.int64(-1), np.int64(0), np.int64(1)]),
    (spaces.MultiDiscrete([3, 4]), [np.array(e) for e in grid(range(3), range(4))]),
    (spaces.MultiDiscrete([2, 3], start=[5, -1]), [np.array(e) for e in grid(range(5, 7), range(-1, 2))]),
    (spaces.MultiDiscrete(np.array([[2], [3]])), [np.reshape(e, (2, 1)) for e in grid(TWO, range(3))]),
    (spaces.MultiBinary(3), [np.array(e, np.int8) for e in grid(TWO, TWO, TWO)]),
    (spaces.MultiBinary([2, 2]), [np.reshape(e, (2, 2)).astype(np.int8) for e in grid(TWO, TWO, TWO, TWO)]),
    (spaces.Tuple([spaces.Discrete(4), spaces.Discrete(2)]), grid(range(4), TWO)),
    (
        spaces.Tuple([spaces.Tuple([spaces.Discrete(2, start=3), spaces.MultiDiscrete([2, 3])]), spaces.Discrete(2)]),
        [((a, np.array([b, c])), d) for a, b, c, d in grid(range(3, 5), TWO, range(3), TWO)],
    ),
    (
        spaces.Dict(b=spaces.Discrete(2, start=1), a=spaces.MultiDiscrete([2, 3])),
        [{"a": np.array([b, c]), "b": a} for a, b, c in grid(range(1, 3), TWO, range(3))],
    ),
    (
        spaces.Dict(dict.fromkeys(("observation", "achieved_goal", "desired_goal"), spaces.MultiBinary(1))),
        [
            {"observation": np.array([s]), "achieved_goal": np.array([s]), "desired_goal": np.array([g])}
            for s, g in grid(TWO, TWO)
        ],
    ),
]


@pytest.mark.parametrize(("space", "elements"), ALL, ids=str)
def test_every_element_of_a_space_has_a_row_of_its_own(space: spaces.Space[Any], elements: list[Any]) -> None:
    """In order, the last number fastest, and no row is left over."""
    assert rows_shown(space, elements) == list(range(len(elements)))
    assert TabularObservation(Showing(space, elements)).observation_space == spaces.Discrete(len(elements))
    assert table_size(Showing(space, elements, actions=5)) == (len(elements), 5)


@given(st.lists(st.tuples(st.integers(1, 5), st.integers(-3, 3)), min_size=1, max_size=4), st.data())
def test_wrapper_and_mdp_number_alike(places: list[tuple[int, int]], data: st.DataObject) -> None:
    """Both give NumPy's index of an entry in an array of these sizes; numbers need not begin at 0."""
    sizes, lows = zip(*places, strict=True)
    parts = tuple(data.draw(st.integers(low, low + size - 1)) for size, low in places)
    shifted = [part - low for part, low in zip(parts, lows, strict=True)]
    space = spaces.MultiDiscrete(list(sizes), start=list(lows))
    row = np.arange(math.prod(sizes)).reshape(sizes)[tuple(shifted)]
    assert rows_shown(space, [np.array(parts)]) == [row]
    for same in (space, spaces.Tuple([spaces.Discrete(size, start=low) for size, low in places])):
        task: Any = Tabular.create(Shows(same, parts))
        assert (task.observation(0, None), task.observation_space) == (row, spaces.Discrete(math.prod(sizes)))
        assert table_size(task) == table_size(Shows(same, parts)) == (math.prod(sizes), 2)


WHOLE = "table whole numbers"
REFUSED: list[tuple[spaces.Space[Any], str, str]] = [  # in a Gymnasium environment, in an MDP
    (spaces.Box(0, 1, (2,)), f"{WHOLE} Box", f"{WHOLE} Box"),
    (spaces.Dict(a=spaces.Discrete(2)), "", f"{WHOLE} Dict"),
    (spaces.Dict(a=spaces.Box(0, 1)), f"{WHOLE} Box", f"{WHOLE} Dict"),
    (spaces.Tuple([spaces.Box(0, 1)]), f"{WHOLE} Box", f"{WHOLE} Box"),
    (spaces.MultiDiscrete([2**31] * 3), "table 63 edugym.Hashed", "table 63 edugym.Hashed"),
    (spaces.MultiDiscrete(np.array([[2, 3]])), "", "flat MultiDiscrete"),
    (spaces.MultiBinary([2, 2]), "", "flat MultiBinary"),
    (spaces.Tuple([spaces.Discrete(2), spaces.MultiDiscrete([2, 3])]), "", "flat Tuple"),
    (spaces.Tuple([spaces.Discrete(2), spaces.Tuple([spaces.Discrete(2)])]), "", "flat Tuple"),
    (spaces.Discrete(3, start=1), "", "0 start=1"),
    (spaces.MultiBinary(3), "", ""),
]


@pytest.mark.parametrize(("space", "of_env", "of_mdp"), REFUSED, ids=str)
def test_what_is_not_whole_numbers_is_refused(space: spaces.Space[Any], of_env: str, of_mdp: str) -> None:
    """The message shows the space; an MDP shows its numbers side by side, an environment may nest them."""
    env, mdp = (lambda: TabularObservation(Showing(space, []))), (lambda: tabular(Shows(space)))
    for names, make in ((of_env, env), (of_mdp, mdp)):
        named(names, make) if names else make()


def test_where_a_table_ends() -> None:
    """Machine code counts to 2^63 - 1; one number needs no wrapper."""
    mdp, env = make_mdp("Boulder"), gymnasium.make("edugym/Boulder-v0")
    assert tabular(mdp) is mdp
    assert tabular(env) is env
    assert number_of_rows([2**32 - 1, 2**31]) == 2**63 - 2**31
    assert number_of_rows([2**63 - 1]) == 2**63 - 1
    named("9,223,372,036,854,775,808 63", lambda: number_of_rows([2**32, 2**31]))
    named("mdp Discrete(6) Tabular", lambda: Tabular.create(cell(WALK)["Walk"](5)))


@pytest.mark.parametrize("space", [spaces.Box(-1, 1, (2,)), spaces.MultiDiscrete([2, 2]), spaces.Discrete(2, start=1)])
def test_actions_that_do_not_fit_a_table_are_refused(space: spaces.Space[Any]) -> None:
    """The columns of the table are the actions 0, 1, ..."""
    env = Showing(spaces.Discrete(2), [])
    env.action_space = space
    named(f"table actions 0, 1, {space}", lambda: table_size(env))


@pytest.mark.parametrize(
    ("thing", "names"),
    [
        ("FrozenLake-v1", "environment 'FrozenLake-v1'"), (5, "environment 5"), (None, "environment None"),
        (Shows, "environment Shows(...)"), (QLearning, "environment QLearning.create(...)"),
        ((3,), "(n_states, n_actions) (3,)"), ((3, 0), "(3, 0)"), ((3, 2.0), "(3, 2.0)"),
    ],
)  # fmt: skip
def test_what_is_no_environment_is_refused(thing: Any, names: str) -> None:
    """Such as the id of one, which only `train` takes; a shape is two whole numbers."""
    named(names, lambda: table_size(thing))
    assert table_size((3, np.int64(1))) == (3, 1)


TWOS, THREES = spaces.MultiDiscrete([2, 2]), spaces.Discrete(3, start=1)
OUTSIDE: list[tuple[Any, Any]] = [
    *((TWOS, e) for e in (np.array([0, 2]), np.array([0.5, 1.0]), (1,), np.array([[0, 1], [1, 1]]))),
    *((TWOS, e) for e in (10**30, np.inf, None, "01", {"a": 1})),
    *((spaces.Dict(a=TWOS), e) for e in ({"a": np.array([0, 2])}, {"b": np.array([0, 1])}, np.array([0, 1]), {})),
    *((THREES, e) for e in (0, 4, 1.5, np.float32(2.5), np.array(4), np.array([1, 2]), -1, np.nan)),
]


@pytest.mark.parametrize(("space", "outside"), OUTSIDE, ids=str)
def test_an_observation_outside_the_space_is_an_error(space: Any, outside: Any) -> None:
    """Rather than a wrong row, or an error of NumPy's."""
    named(f"observation {space}", lambda: TabularObservation(Showing(space, [outside])).reset())


def test_whole_numbers_of_any_type() -> None:
    """2.0 stands for 2, and so do arrays of one number."""
    shown = [1, np.uint8(2), 3.0, np.float32(1.0), np.array(2), np.array([3]), np.array([1.0]), True]
    assert rows_shown(spaces.Discrete(3, start=1), shown) == [0, 1, 2, 0, 1, 2, 0, 0]
    assert rows_shown(spaces.MultiDiscrete([2, 3]), [np.array([1.0, 2.0]), (0.0, 1)]) == [5, 1]


def test_what_is_written_in_place_is_one_row() -> None:
    """The row of what the task has written last."""
    writing = """
class Writing(NamedTuple):
    observation_space: object = spaces.MultiDiscrete([3, 4])
    def observe_into(self, state, rng, out): out[:] = state // 4, state % 4
"""
    task: Any = Tabular.create(cell(writing)["Writing"]())
    assert [task.observation(state, None) for state in (7, 0, 11)] == [7, 0, 11]
