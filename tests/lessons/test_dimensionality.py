"""Tables over the images of Catch: the claims hold with other seeds than those the lesson shows."""

import numpy as np

from edugym.envs.catch import Catch, Fall
from edugym.lessons.dimensionality import (
    COLUMNS,
    OFFSET,
    ROWS,
    TABLE,
    TRAINED,
    WITHHELD,
    catch,
    different_boards,
    generalise,
    learn,
    new_share,
    pixels,
    returns_by_column,
    rows_of_table,
)
from edugym.lessons.dimensionality.boards import Offset


def test_rows_of_tables() -> None:
    """250 for positions, and 2 and 256 to the power of how many numbers there are."""
    assert [rows_of_table(seen) for seen in ("vectorised", "grid", "rgb")] == [250, 2**50, 256**150]
    assert rows_of_table("vectorised", 4, 3) == 36


def test_boards_are_states() -> None:
    """While the ball falls each state has a board of its own; fewer than 225, since the paddle starts in the middle."""
    falling, boards = different_boards()
    assert falling == boards < (ROWS - 1) * COLUMNS * COLUMNS


def test_balls_come_from_the_columns() -> None:
    """And from all of them; the rest is that of the task."""
    task, rng = catch("grid", WITHHELD), np.random.default_rng(0)
    starts = [task.initial(rng) for _ in range(50)]
    assert {state.ball_x for state in starts} == set(WITHHELD)
    assert {(state.ball_y, state.paddle_x) for state in starts} == {(0, COLUMNS // 2)}
    board = np.zeros((ROWS, COLUMNS), np.float32)
    task.observe_into(starts[0], rng, board)
    assert (board == Catch.create().observation(starts[0], rng)).all()


def test_offset() -> None:
    """It sees where the ball is from the paddle, in every state."""
    features, task, rng = Offset.create(ROWS, COLUMNS), Catch.create(), np.random.default_rng(0)
    for ball in range(COLUMNS):
        for paddle in range(COLUMNS):
            features.see(task.observation(Fall(ball, 3, paddle), rng).ravel())
            assert features.active[0] == ball - paddle + COLUMNS - 1
    assert features.n_features == 2 * COLUMNS - 1


def test_new_share() -> None:
    """Few boards are new without noise, and all with noise of real numbers."""
    assert new_share(pixels()(0)) < 0.2
    assert new_share(pixels(sigma=0.1)(0)) == 1.0


def test_pixels_and_positions_are_one() -> None:
    """The same learning curve, number for number; with a noisy pixel it is another one."""
    curves = [
        learn(task, "one", n_steps=4_000, repetitions=2, seed=5).curves("one").to_numpy()
        for task in (catch("vectorised"), pixels(), pixels(levels=4))
    ]
    assert (curves[0] == curves[1]).all()
    assert (curves[0] != curves[2]).any()


def test_what_generalises() -> None:
    """On trained columns both catch; on withheld ones only the features that fit."""
    results = generalise(repetitions=2, seed=4)
    table, offset = returns_by_column(results[TABLE]), returns_by_column(results[OFFSET])
    assert table.shape == (COLUMNS, 2)
    assert (table[[*TRAINED]] == 1.0).all()
    assert (table[[*WITHHELD]] < 0.5).all()
    assert (offset == 1.0).all()
