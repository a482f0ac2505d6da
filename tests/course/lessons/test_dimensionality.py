"""Tables over the images of Catch: what is seen, what is the same, and what the claims measure."""

import math
from typing import Any

import numpy as np
import pytest

from edugym import DQN, Brightness
from edugym.deep import baselines
from edugym.envs.catch import Catch, Fall
from edugym_course.lessons.dimensionality import (
    baird,
    experiments,
    figures,
    methods,
    networks,
    sharing,
    sizes,
    tasks,
    triad,
)
from edugym_course.lessons.dimensionality.boards import Offset
from edugym_course.lessons.dimensionality.layers import SmallCNN
from edugym_course.lessons.dimensionality.open_dqn import OpenDQN
from edugym_course.lessons.dimensionality.riddles import CHOOSY, DARK, GOOD, QUESTIONS, RIDDLES, Album, Move, Riddle
from edugym_course.lessons.model_based.figures import steps_to
from tests.course.lessons.answers import Answer, verdict
from tests.course.lessons.made_up import Curve, made_up, measured
from tests.course.lessons.test_answers import ANSWERS, checked_by, exercises_of
from tests.experiments.figures.samples import heights, new_axes


def test_sizes() -> None:
    """Rows are what numbers there are to the power of how many; boards are states, and with noise all are new."""
    assert [sizes.rows_of_table(kind) for kind in ("vectorised", "grid", "rgb")] == [250, 2**50, 256**150]
    assert sizes.rows_of_table("vectorised", 4, 3) == 36
    agent = methods.network()(tasks.catch("grid"))
    assert sizes.n_weights() == agent.weights.first.size + agent.weights.second.size
    falling, boards = sizes.different_boards()
    assert falling == boards < (tasks.ROWS - 1) * tasks.COLUMNS * tasks.COLUMNS
    assert sizes.new_share(methods.pixels()(0)) < 0.2
    assert sizes.new_share(methods.pixels(sigma=0.1)(0)) == 1.0


def test_what_is_seen() -> None:
    """Balls come from all columns that are given; coordinates go from 0 to 1; the offset is that to the paddle."""
    task, rng = tasks.catch("grid", tasks.WITHHELD), np.random.default_rng(0)
    starts = [task.initial(rng) for _ in range(50)]
    assert {state.ball_x for state in starts} == set(tasks.WITHHELD)
    assert {(state.ball_y, state.paddle_x) for state in starts} == {(0, tasks.COLUMNS // 2)}
    board = np.zeros((tasks.ROWS, tasks.COLUMNS), np.float32)
    task.observe_into(starts[0], rng, board)
    assert (board == Catch.create().observation(starts[0], rng)).all()
    numbers = methods.catch_numbers()
    assert numbers.observation(Fall(4, 9, 0), rng).tolist() == [1.0, 1.0, 0.0]
    assert numbers.observation(Fall(2, 0, 1), rng).tolist() == [0.5, 0.0, 0.25]
    features, whole = Offset.create(tasks.ROWS, tasks.COLUMNS), Catch.create()
    for ball in range(tasks.COLUMNS):
        for paddle in range(tasks.COLUMNS):
            features.see(whole.observation(Fall(ball, 3, paddle), rng).ravel())
            assert features.active[0] == ball - paddle + tasks.COLUMNS - 1
    assert features.n_features == 2 * tasks.COLUMNS - 1


@pytest.mark.slow
def test_what_is_the_same_is_so_number_for_number() -> None:
    """Tables over pixels and positions learn the same, and so do DQN and its open copy; with more levels it is not."""
    curves = [
        methods.learn(task, "one", n_steps=2_000, repetitions=1, seed=5).curves("one").to_numpy()
        for task in (tasks.catch("vectorised"), methods.pixels(), methods.pixels(levels=4))
    ]
    assert (curves[0] == curves[1]).all()
    assert (curves[0] != curves[2]).any()
    how: Any = {"n_steps": 500, "repetitions": 1, "jobs": 1}
    one, two = (methods.learn(methods.seen(), "one", methods.network(kind), **how) for kind in (DQN, OpenDQN))
    assert one.curves("one").equals(two.curves("one"))


def test_settings_in_the_text() -> None:
    """Each agent that is tested on withheld columns has the learning rate, γ, ε and tiles of the lesson's tables."""
    agents = {label: make()(methods.thrown(sees, tasks.TRAINED)) for label, (sees, make) in methods.GENERAL.items()}
    rates = {methods.TABLE: 0.5, methods.LINEAR: 0.1, methods.TILES: 0.5, methods.OFFSET: 0.1, methods.NETWORK: 0.001}
    assert {label: agent.learning_rate for label, agent in agents.items()} == {**rates, methods.NUMBERS: 0.003}
    assert {(agent.discount, agent.exploration.epsilon) for agent in agents.values()} == {(0.9, 0.1)}
    assert list(agents[methods.TILES].features.tiles) == [2, 4, 2]


def test_the_triad() -> None:
    """W grows by its factor, and shrinks below γ = 1/2; Baird's first error is 0.99 (10 + 2) - (2 + 1) = 8.88."""
    assert triad.w_to_2w(10, 0.9, 0.1)[-1] == pytest.approx((1 + 0.1 * 0.8) ** 10)
    assert triad.w_to_2w(100, 0.4, 0.1)[-1] < 0.2
    assert abs(triad.w_to_2w(100, 1.0, 0.1, whole_way=True)[-1]) < 1e-6
    assert 1.0 < triad.w_to_2w(100, 0.9, 0.1, copy_every=20)[-1] < triad.w_to_2w(100, 0.9, 0.1)[-1]
    changes = np.diff(baird.weights_of_solid(n_steps=40), axis=0)
    first = changes[changes.any(axis=1)][0]
    assert first[7] == pytest.approx(0.05 * 8.88)
    assert sorted(first[:7]) == pytest.approx([0.0] * 6 + [0.1 * 8.88])
    mdp, rng = baird.Baird(), np.random.default_rng(0)
    assert mdp.observation(2, rng) @ np.arange(8) == 2 * 2 + 7
    assert mdp.observation(6, rng) @ np.arange(8) == 6 + 2 * 7


@pytest.mark.slow
def test_weights_that_never_learned() -> None:
    """Those from pixels where there was never a ball, nor the paddle."""
    results = methods.generalise([methods.NETWORK], n_steps=2_000, repetitions=1, jobs=1)[methods.NETWORK]
    learned = figures.ever_learned(results.agents[methods.NETWORK][0])
    assert not learned[:-1, [*tasks.WITHHELD]].any()
    assert learned[:-1, [*tasks.TRAINED]].any()


GRID, CNN = (tasks.ROWS, tasks.COLUMNS), networks.with_cnn(SmallCNN)


@pytest.mark.parametrize(
    ("label", "algorithm", "shape", "is_dark", "settings"),
    [
        (networks.DQN_GRID, "DQN", GRID, False, networks.DQN_SETTINGS),
        (networks.PPO_GRID, "PPO", GRID, False, networks.PPO_SETTINGS),
        (networks.DQN_IMAGE, "DQN", (*GRID, 3), False, {**networks.DQN_SETTINGS, **CNN}),
        (networks.PPO_IMAGE, "PPO", (*GRID, 3), False, {**networks.CNN_SETTINGS, **CNN}),
        (networks.PPO_DARK, "PPO", (*GRID, 3), True, {**networks.CNN_SETTINGS, **CNN}),
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
    asked: Any = networks.train_network(label, 9, evaluate_every=7, seed=3)
    assert asked == (algorithm, shape, is_dark, 9, how)


def test_figures_of_columns() -> None:
    """Arrows point where the paddle goes; full dots for trained columns stand above empty ones, with bars."""
    results = methods.generalise([methods.OFFSET], n_steps=4_000, repetitions=1, jobs=1)
    (ax,) = figures.policy_maps(results, [methods.OFFSET]).draw().axes
    arrows = {text.get_position(): text.get_text() for text in ax.texts}
    assert ax.get_xlabel() == "column of the paddle"
    assert [arrows[paddle, 2] for paddle in range(tasks.COLUMNS)][1::2] == ["→", "←"]
    by_column = np.array([[0.9, 0.7], [-0.5, 0.1], [0.9, 0.7], [-0.5, 0.1], [0.9, 0.7]])
    dotted = figures.Dots({"one": by_column, "other": np.ones((5, 3))}).draw(new_axes())
    bars, dots = dotted.lines[0:4:2], dotted.lines[1:4:2]
    places = [(float(np.asarray(dot.get_xdata())[0]), heights(dot)[0]) for dot in dots]
    assert places == [pytest.approx((0.8, -0.14)), pytest.approx((-0.2, 0.14))]
    assert [str(dot.get_markerfacecolor()) for dot in dots] == [str(dots[0].get_color()), "white"]
    ends = [np.asarray(bar.get_xdata()).tolist() for bar in bars]
    assert ends == [pytest.approx([-0.4706, 1.0], abs=1e-3), [-1.0, 1.0]]
    assert [label.get_text() for label in dotted.get_yticklabels()] == ["one", "other"]
    assert dotted.get_ylim()[0] > dotted.get_ylim()[1]


def test_dimensionality_on_columns_of_training_and_others() -> None:
    """Of each column k two runs return k² and 3 more: 20/3 on columns 0, 2 and 4, and 5 on 1 and 3; then the mean."""
    labels = (*methods.GENERAL, sharing.SMALL, sharing.COLUMN)
    squares = np.arange(5.0)[:, None] ** 2 + [[0.0, 3.0]]
    tests = {label: squares + 100.0 * k for k, label in enumerate(labels)}
    at = {label: 100.0 * k + 1.5 for k, label in enumerate(labels)}
    table, offset = at[methods.TABLE], at[methods.OFFSET]
    assert measured(experiments.general_claims(tests)) == pytest.approx([table + 20 / 3, table + 5.0, offset + 5.0])
    labels_of_networks = (methods.NETWORK, sharing.SMALL, sharing.COLUMN)
    assert measured(experiments.sharing_claims(tests)) == [at[label] + 5.0 for label in labels_of_networks]


def test_claims_on_learning_rates() -> None:
    """Of two runs with 0.1 none catches all balls from columns 0, 2 and 4; with smaller rates one of two does."""
    runs = {
        rate: np.array([[1.0, 1.0], [-1.0, -0.5], [1.0, 1.0], [-1.0, 0.5], [1.0, 0.9]]) for rate in experiments.RATES
    }
    runs[experiments.RATES[0]] = -np.ones((5, 2))
    assert measured(experiments.rate_claims(runs)) == [0.0, 0.5, -1.0, -0.5, -0.5, -0.5]


FAST: Curve = {0: 0.0, 10: 0.99, 20: 0.0, 60: 0.0}
SLOW_AND_FAST = [FAST, {0: 0.0, 10: 0.98, 20: 0.99, 60: 1.0}, {0: 0.0, 10: 0.0, 20: 0.0, 60: 1.0}]
SELDOM = [FAST, *[{0: 0.0, 10: 0.5, 20: 0.5, 60: 0.5}] * 2]


@pytest.mark.parametrize(("curves", "median"), [(SLOW_AND_FAST, 20.0), (SELDOM, math.inf)])
def test_the_run_in_the_middle(curves: list[Curve], median: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """A level counts when it is reached for the first time; a run that never gets there takes for ever."""
    results = made_up({"one": curves}, 60)
    assert steps_to(results, "one", 0.99) == median
    monkeypatch.setattr(methods, "learn", lambda task, label, *more, **how: made_up({label: curves}, 60))
    assert {*methods.steps_to_solve(3).values()} == {median}


LESSON, DISCOUNT = "04_dimensionality", 0.9


def program() -> Answer:
    """The lesson's own program, and the one in PyTorch."""
    return Answer(LESSON, 0, True, "program", (), checked_by(Answer(LESSON, 0, True, "", (), "")).solution)


def value(
    riddle: Riddle,
    move: Move,
    follows: bool = True,
    masked: bool = True,
    truncated_ends: bool = False,
    mean: bool = False,
    discount: float = DISCOUNT,
) -> float:
    """The target of a move when the good image is worth what it pays for ever or once, and the bad one what it pays."""
    worth = riddle.good.reward / (1.0 if riddle.good.terminated else 1.0 - discount)
    if mean and riddle.choosy:
        worth = (worth - 1.0 - 1.0) / 3
    ends = masked and (move.terminated or (truncated_ends and move.truncated))
    return move.reward + (0.0 if ends else discount * follows * (worth if move.image == GOOD else riddle.bad.reward))


@pytest.mark.parametrize(
    ("mistake", "solved"),
    [
        ({}, [True, True, True, True, True, True]),
        ({"follows": False}, [True, False, True, False, True, False]),
        ({"mean": True}, [True, True, True, True, True, False]),
        ({"masked": False}, [True, True, False, True, False, True]),
        ({"truncated_ends": True}, [True, True, True, False, True, True]),
        ({"discount": 0.95}, [True, True, True, True, False, True]),
        ({"discount": 0.5}, [True, True, True, False, True, True]),
    ],
)
def test_what_a_riddle_asks_for(mistake: dict[str, Any], solved: list[bool]) -> None:
    """With right targets the right action is the best one; with a mistake not in the riddles that ask for it."""
    riddles = [*RIDDLES, CHOOSY]
    found = [value(riddle, riddle.right, **mistake) > value(riddle, riddle.wrong, **mistake) for riddle in riddles]
    assert found == solved


@pytest.mark.parametrize("seed", range(20))
def test_an_album(seed: int) -> None:
    """The same seed gives the same riddle; every action is right for a question, and chance takes a third of them."""
    album, again = (Album(RIDDLES[0], seed) for _ in range(2))
    first, second = ([one.reset(seed=number)[0].tobytes() for number in range(60)] for one in (album, again))
    assert first == second
    assert len(set(first)) == QUESTIONS + 2
    right = set()
    for number in range(200):
        album.reset(seed=number)
        album.step(number % 3)
        right |= {action for action, is_right in album.answers if is_right}
    assert right == {0, 1, 2}


@pytest.mark.parametrize("seed", range(20))
def test_a_dark_album(seed: int) -> None:
    """Only the black image counts, and the first of equal values is wrong for it."""
    album = Album(DARK, seed)
    for number in range(60):
        is_black = not album.reset(seed=number)[0].any()
        counted = len(album.answers)
        album.step(number % 3)
        assert len(album.answers) == counted + is_black
    assert {right for action, right in album.answers if action == 0} == {False}
    assert len({action for action, right in album.answers if right}) == 1


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(
    "answer",
    [program(), *(answer for answer in ANSWERS if answer.lesson == LESSON and answer.exercise == 0)],
    ids=lambda answer: answer.name,
)
def test_an_answer_at_another_seed(answer: Answer, seed: int) -> None:
    """Right ones pass, and wrong ones are told as the same mistake; the quick tests have seed 0."""
    asked = checked_by(answer)
    asked = asked._replace(check=asked.check.replace("my_program)", f"my_program, seed={seed}, quiet=True)"))
    said = verdict(answer, asked, exercises_of(LESSON)[0])
    assert (said == "") == answer.right, said
    assert answer.right or all(words in said for words in answer.says), said


@pytest.mark.slow
@pytest.mark.parametrize("check", ["check_riddle(my_torch_program, RIDDLES[1], 0)", ""])
def test_pytorch(check: str) -> None:
    """The program in PyTorch solves a riddle, and it passes."""
    pytest.importorskip("torch").set_num_threads(1)
    asked = checked_by(program())
    imports = "from edugym_course.lessons.dimensionality.project import check_riddle\n"
    imports += "from edugym_course.lessons.dimensionality.riddles import RIDDLES\n"
    asked = asked._replace(check=imports + check if check else asked.check.replace("my_program", "my_torch_program"))
    assert verdict(program(), asked, exercises_of(LESSON)[0]) == ""
