"""Catch: falls that a person can follow, the three observations of one task, and which balls can be caught."""

import itertools
from contextlib import nullcontext
from typing import Any

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import strategies as st
from scipy import stats

import edugym
from edugym.adapters.registration import find
from edugym.envs.catch import Catch
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.contract.described import NO_WHOLE_NUMBER, Keywords, Parameters, refused

CatchEnv: Any = find("Catch").load()


@st.composite
def boards(draw: st.DrawFn) -> Keywords:
    """Boards on which every ball can be caught."""
    rows = draw(st.integers(2, 12))
    kind = draw(st.sampled_from(["grid", "default", "vectorised", "rgb"]))
    return {"rows": rows, "columns": draw(st.integers(1, 2 * rows - 1)), "observation_type": kind}


PARAMETERS = Parameters(
    valid=boards(),
    corners=(
        {},
        {"rows": 2, "columns": 1, "observation_type": "vectorised"},
        {"rows": 2, "columns": 3, "observation_type": "rgb"},
        {"rows": 20, "columns": 39, "observation_type": "default"},
        {"rows": 100, "columns": 199, "observation_type": "vectorised"},
    ),
    bad=(
        *refused("rows", 1, 0, -10, 1001, 10**9, *NO_WHOLE_NUMBER),
        *refused("columns", 0, -1, 20, 1000, 1001, 10**9, *NO_WHOLE_NUMBER),
        *refused("columns", 4, rows=2),
        *refused("observation_type", "pixels", "Grid", "", None, 0),
    ),
    finite=(
        {"observation_type": "vectorised"},
        {"rows": 4, "columns": 7},
        {"rows": 2, "columns": 2, "observation_type": "rgb"},
    ),
    informed=lambda info, _: 1 + (info["ball"][0] > info["paddle"]) - (info["ball"][0] < info["paddle"]),
)


LEFT, STAY, RIGHT = 0, 1, 2


def drop(env: Any, column: int) -> None:
    """Start an episode whose ball falls in a column."""
    for seed in range(1_000):
        env.reset(seed=seed)
        if env.state.ball_x == column:
            return
    pytest.fail(f"no ball falls in column {column}")


def fall(column: int, actions: list[int], **parameters: Any) -> list[tuple[Any, ...]]:
    """What each step gives of a ball in a column: ball x, ball y, paddle x, reward, terminated, truncated."""
    env = CatchEnv(observation_type="vectorised", **parameters)
    drop(env, column)
    steps = [env.step(action) for action in actions]
    return [(*observation.tolist(), *rest) for observation, *rest, _ in steps]


def test_caught_and_missed() -> None:
    """The paddle starts in the middle and goes a column a step while the ball falls a row; one column off is missed."""
    assert fall(0, [LEFT, STAY, LEFT], rows=4) == [
        (0, 1, 1, 0.0, False, False),
        (0, 2, 1, 0.0, False, False),
        (0, 3, 0, 1.0, True, False),
    ]
    assert fall(4, [RIGHT, STAY, STAY], rows=4)[-1] == (4, 3, 3, -1.0, True, False)
    assert fall(2, [STAY, STAY, RIGHT], rows=4)[-1] == (2, 3, 3, -1.0, True, False)


def test_edges() -> None:
    """The paddle stays on the board, and comes back from its edge at once."""
    assert [step[2] for step in fall(0, [LEFT] * 3 + [RIGHT], rows=5, columns=3)] == [0, 0, 0, 1]
    assert [step[2] for step in fall(0, [RIGHT] * 3 + [LEFT], rows=5, columns=3)] == [2, 2, 2, 1]
    assert [step[2] for step in fall(0, [RIGHT, LEFT, STAY, RIGHT], rows=5, columns=1)] == [0, 0, 0, 0]


@pytest.mark.parametrize("columns", range(1, 9))
def test_start(columns: int) -> None:
    """The paddle starts in column columns // 2; the ball in a column drawn uniformly (chi-squared, 1 in 1 000)."""
    mdp, rng = Catch(9, columns), np.random.default_rng(columns)
    starts = [mdp.initial(rng) for _ in range(4_000)]
    assert {(start.ball_y, start.paddle_x) for start in starts} == {(0, columns // 2)}
    counts = np.bincount([start.ball_x for start in starts], minlength=columns)
    assert len(counts) == columns
    if columns > 1:
        assert stats.chisquare(counts).pvalue > 0.001


def test_grid() -> None:
    """A grid of zeros with a one at the ball and a one at the paddle."""
    env = CatchEnv(3, 4)
    drop(env, 3)
    assert env.step(LEFT)[0].tolist() == [[0, 0, 0, 0], [0, 0, 0, 1], [0, 1, 0, 0]]
    assert env.step(STAY)[0].tolist() == [[0, 0, 0, 0], [0, 0, 0, 0], [0, 1, 0, 1]]
    drop(env, 1)
    env.step(LEFT)
    assert env.step(STAY)[0].tolist() == [[0, 0, 0, 0], [0, 0, 0, 0], [0, 1, 0, 0]]


def test_image() -> None:
    """A yellow ball and a red paddle on black; a ball on the paddle hides it."""
    env, black, ball, paddle = CatchEnv(3, 3, "rgb"), [0] * 3, [255, 210, 63], [232, 80, 91]
    drop(env, 0)
    assert env.step(LEFT)[0].tolist() == [[black] * 3, [ball, black, black], [paddle, black, black]]
    assert env.step(STAY)[0].tolist() == [[black] * 3, [black] * 3, [ball, black, black]]


def test_kinds() -> None:
    """The observation types by name; the paper's "default" is the grid, and so is ours."""
    for kind, space in (
        ("grid", spaces.Box(0.0, 1.0, (7, 6), np.float32)),
        ("default", spaces.Box(0.0, 1.0, (7, 6), np.float32)),
        ("vectorised", spaces.MultiDiscrete([6, 7, 6])),
        ("rgb", spaces.Box(0, 255, (7, 6, 3), np.uint8)),
    ):
        assert CatchEnv(7, 6, kind).observation_space == space
    assert CatchEnv(7, 6).observation_space == CatchEnv(7, 6, "grid").observation_space


def test_every_ball_can_be_caught_exactly_when() -> None:
    """The best return is 1 on every board with columns // 2 <= rows - 1; the others are refused."""
    for rows, columns in itertools.product(range(2, 6), range(1, 13)):
        best = value_iteration(finite_model(Catch(rows, columns))).start
        assert (best == 1.0) == (columns // 2 <= rows - 1)
        refusal = f"columns must be at most {2 * rows - 1} with {rows} rows, .* but is {columns}"
        with nullcontext() if best == 1.0 else pytest.raises(ValueError, match=refusal):
            CatchEnv(rows, columns)


def test_info() -> None:
    """Where the ball and the paddle are."""
    env = CatchEnv(rows=4)
    drop(env, 1)
    assert (env.info()["ball"].tolist(), env.info()["paddle"]) == ([1, 0], 2)
    info = env.step(RIGHT)[4]
    assert (info["ball"].tolist(), info["paddle"]) == ([1, 1], 3)
    assert env.named_actions() == {"left": LEFT, "stay": STAY, "right": RIGHT}


def test_numbers_in_the_docstring() -> None:
    """At the defaults: 250 rows of a table, 220 states, optimum 1, and -0.6 = 2/5 - 1 for a random agent."""
    assert edugym.table_size(CatchEnv(observation_type="vectorised").mdp) == (250, 3)
    assert CatchEnv().observation_space.shape == (10, 5)
    for kind in ("vectorised", "grid"):
        model = CatchEnv(observation_type=kind).finite_model
        assert len(model.states) == 220
        assert value_iteration(model).start == 1.0
        assert value_iteration(model, epsilon=1.0).start == pytest.approx(-0.6)
