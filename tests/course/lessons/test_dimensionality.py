"""Tables over the images of Catch: the claims hold with other seeds than those the lesson shows."""

from typing import Any

import numpy as np
import pytest

from edugym.agents.dqn import DQN
from edugym.deep import baselines
from edugym.envs.catch import Catch, Fall
from edugym.mdp.brightness import Brightness
from edugym_course.lessons.dimensionality.baird import Baird, bairds_weights, weights_of_solid
from edugym_course.lessons.dimensionality.boards import Offset
from edugym_course.lessons.dimensionality.figures import ever_learned, policy_maps, shared_by_column, stored_networks
from edugym_course.lessons.dimensionality.layers import SmallCNN
from edugym_course.lessons.dimensionality.methods import (
    GENERAL,
    LINEAR,
    NETWORK,
    NUMBERS,
    OFFSET,
    TABLE,
    TILES,
    catch_numbers,
    generalise,
    learn,
    linear,
    network,
    pixels,
    play_on,
    returns_by_column,
    seen,
    thrown,
)
from edugym_course.lessons.dimensionality.networks import (
    CNN_SETTINGS,
    DQN_GRID,
    DQN_IMAGE,
    DQN_SETTINGS,
    PPO_DARK,
    PPO_GRID,
    PPO_IMAGE,
    PPO_SETTINGS,
    train_network,
    with_cnn,
)
from edugym_course.lessons.dimensionality.open_dqn import OpenDQN
from edugym_course.lessons.dimensionality.sharing import COLUMN, SMALL
from edugym_course.lessons.dimensionality.sizes import different_boards, n_weights, new_share, rows_of_table
from edugym_course.lessons.dimensionality.tasks import COLUMNS, ROWS, TRAINED, WITHHELD, catch
from edugym_course.lessons.dimensionality.triad import w_to_2w
from tests.course.lessons.figures import check_legends


def test_rows_of_tables() -> None:
    """250 for positions, and 2 and 256 to the power of how many numbers there are."""
    assert [rows_of_table(kind) for kind in ("vectorised", "grid", "rgb")] == [250, 2**50, 256**150]
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


@pytest.mark.parametrize(
    ("label", "rate"), [(TABLE, 0.5), (LINEAR, 0.1), (TILES, 0.5), (OFFSET, 0.1), (NETWORK, 0.001), (NUMBERS, 0.003)]
)
def test_settings_in_the_text(label: str, rate: float) -> None:
    """Each agent that is tested on withheld columns has the learning rate, γ and ε of the lesson's tables."""
    sees, make = GENERAL[label]
    agent = make()(thrown(sees, TRAINED))
    assert (agent.learning_rate, agent.discount, agent.exploration.epsilon) == (rate, 0.9, 0.1)


def test_what_generalises() -> None:
    """On trained columns both catch; on withheld ones only the features that fit."""
    results = generalise(repetitions=2, seed=4)
    table, offset = returns_by_column(results[TABLE]), returns_by_column(results[OFFSET])
    assert table.shape == (COLUMNS, 2)
    assert (table[[*TRAINED]] == 1.0).all()
    assert (table[[*WITHHELD]] < 0.5).all()
    assert (offset == 1.0).all()


def test_the_triad() -> None:
    """The weight grows by its factor, shrinks below a discount of one half, and on-policy it always does."""
    assert w_to_2w(10, 0.9, 0.1)[-1] == pytest.approx((1 + 0.1 * 0.8) ** 10)
    assert w_to_2w(100, 0.4, 0.1)[-1] < 0.2
    assert abs(w_to_2w(100, 1.0, 0.1, whole_way=True)[-1]) < 1e-6
    assert 1.0 < w_to_2w(100, 0.9, 0.1, copy_every=20)[-1] < w_to_2w(100, 0.9, 0.1)[-1]


def test_bairds_weights_by_hand() -> None:
    """The first update of the solid action: from a state i below 6 to state 6, whose value is 10 + 2 = 12.

    The value of i is 2 + 1 = 3, so the error is 0.99 * 12 - 3 = 8.88. Times α = 0.05, w_i gains twice that, w_8 once.
    """
    changes = np.diff(weights_of_solid(n_steps=40), axis=0)
    first = changes[changes.any(axis=1)][0]
    assert first[7] == pytest.approx(0.05 * 8.88)
    assert sorted(first[:7]) == pytest.approx([0.0] * 6 + [0.1 * 8.88])
    mdp, rng = Baird(), np.random.default_rng(0)
    assert mdp.observation(2, rng) @ np.arange(8) == 2 * 2 + 7
    assert mdp.observation(6, rng) @ np.arange(8) == 6 + 2 * 7


def test_the_figure_of_baird() -> None:
    """Off-policy the weights leave the page; on-policy they stay below where they began."""
    panels: Any = bairds_weights().rows[0]
    left, right = panels
    assert max(line.max() for line in left.lines.values()) > 50
    assert max(np.abs(line).max() for line in right.lines.values()) <= 10


def test_open_dqn_is_dqn() -> None:
    """The same run, number for number."""
    one, two = (
        learn(seen(), "one", network(kind), n_steps=1_000, repetitions=1, jobs=1).curves("one").to_numpy()
        for kind in (DQN, OpenDQN)
    )
    assert (one == two).all()


def test_coordinates() -> None:
    """From 0 to 1, from the first to the last column and row."""
    task, rng = catch_numbers(), np.random.default_rng(0)
    assert task.observation(Fall(4, 9, 0), rng).tolist() == [1.0, 1.0, 0.0]
    assert task.observation(Fall(2, 0, 1), rng).tolist() == [0.5, 0.0, 0.25]


def test_linear_weights_that_catch_every_ball_exist() -> None:
    """A step to the side pays as much as the ball is to that side of the paddle, and staying pays half."""
    agent, columns = linear()(catch("grid")), np.arange(COLUMNS)
    to_the_right = np.append(np.tile(columns, ROWS - 1), -columns)  # the paddle is in the last row
    agent.weights[:-1] = np.outer(to_the_right, [-1.0, 0.0, 1.0])
    agent.weights[-1] = [0.0, 0.5, 0.0]
    rng = np.random.default_rng(0)
    assert all(play_on(agent, "grid", Fall(ball, 0, COLUMNS // 2), rng)[1] for ball in range(COLUMNS))


def test_weights_that_never_learned() -> None:
    """Those from pixels where there was never a ball, nor the paddle."""
    agent = generalise([NETWORK], n_steps=2_000, repetitions=1, jobs=1)[NETWORK].agents[NETWORK][0]
    learned = ever_learned(agent)
    assert not learned[:-1, [*WITHHELD]].any()
    assert learned[:-1, [*TRAINED]].any()


def test_number_of_weights() -> None:
    """That of the network itself."""
    agent = network()(catch("grid"))
    assert n_weights() == agent.weights.first.size + agent.weights.second.size


def test_stored_networks_share_over_columns() -> None:
    """The network whose filters slide over the columns catches balls from new ones; the other one does not."""
    small, column = (shared_by_column(label)[[*WITHHELD]].mean() for label in (SMALL, COLUMN))
    assert column > 0.7
    assert small < 0.2


@pytest.mark.parametrize(
    ("label", "algorithm", "shape", "is_dark", "settings"),
    [
        (DQN_GRID, "DQN", (ROWS, COLUMNS), False, DQN_SETTINGS),
        (PPO_GRID, "PPO", (ROWS, COLUMNS), False, PPO_SETTINGS),
        (DQN_IMAGE, "DQN", (ROWS, COLUMNS, 3), False, {**DQN_SETTINGS, **with_cnn(SmallCNN)}),
        (PPO_IMAGE, "PPO", (ROWS, COLUMNS, 3), False, {**CNN_SETTINGS, **with_cnn(SmallCNN)}),
        (PPO_DARK, "PPO", (ROWS, COLUMNS, 3), True, {**CNN_SETTINGS, **with_cnn(SmallCNN)}),
    ],
)
def test_what_each_label_stands_for(
    label: str, algorithm: str, shape: tuple[int, ...], is_dark: bool, settings: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The algorithm, what it sees and its settings are what the label says."""

    def run(environment: Any, algorithm: str, n_steps: int, /, **how: Any) -> Any:
        is_dark = isinstance(environment.mdp, Brightness)
        return algorithm, environment.observation_space.shape, is_dark, n_steps, how

    monkeypatch.setattr(baselines, "stable_baselines3_run", run)
    how = {**settings, "evaluate_every": 7, "seed": 3}
    asked: Any = train_network(label, 9, evaluate_every=7, seed=3)
    assert asked == (algorithm, shape, is_dark, 9, how)


def test_a_network_of_now_is_drawn_beside_the_stored_ones() -> None:
    """With a line and a label of its own."""
    run = train_network(PPO_IMAGE, 1_024, seed=0)
    sheet = stored_networks({"now": run})
    check_legends(sheet)
    labels = [label for ax in sheet.draw().axes for label in ax.get_legend_handles_labels()[1]]
    assert "now" in labels


def test_arrows_point_where_the_paddle_goes() -> None:
    """Its column is on the horizontal axis: right of it the cell of an arrow to the right."""
    results = generalise([OFFSET], n_steps=4_000, repetitions=1, jobs=1)
    (ax,) = policy_maps(results, [OFFSET]).draw().axes
    arrows = {text.get_position(): text.get_text() for text in ax.texts}
    assert ax.get_xlabel() == "column of the paddle"
    assert [arrows[paddle, 2] for paddle in range(COLUMNS)][1::2] == ["→", "←"]


def test_panels_of_stored_networks_compare() -> None:
    """Both have the same vertical axis."""
    one, two = stored_networks().draw().axes
    assert one.get_ylim() == two.get_ylim()
