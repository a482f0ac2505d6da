"""Exploration on Boulder: the baseline fails, the remedies succeed, and without what makes them remedies they fail too.

"Solves" and "fails" are claims on the share of runs that end at the top, over walls and seeds, with its interval.
"""

import threading
from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np
import pytest

from edugym import EpsilonGreedy, QLearning, Results, make_mdp, train
from edugym.experiments.results.claims import Above, Below
from edugym.experiments.results.statistics import proportion_interval
from edugym.rendering.palette import CRACK, STONE
from edugym.rendering.shapes import Circle
from edugym_course.lessons.exploration import experiments, methods
from edugym_course.lessons.exploration.climbs import first_at_top, frontier, random_search_steps, share_of_climbs
from edugym_course.lessons.exploration.figures import highest_so_far, progress
from edugym_course.lessons.exploration.fork import Fork, branches, returns_to, turns
from edugym_course.lessons.exploration.methods import (
    EPSILON_GREEDY,
    GO_EXPLORE,
    METHODS,
    NOVELTY,
    best_return,
    compare,
    visits_of,
)
from edugym_course.lessons.exploration.stalling import record_frontier

SOLVES, FAILS = Above(0.5), Below(0.5)


@cache
def trained(height: int) -> Results:
    """The three methods of the paper's figure on walls of this height; other seeds than those the lesson shows."""
    return compare(height, repetitions=20, seed=1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("method", "height", "expected"),
    [
        (EPSILON_GREEDY, 10, SOLVES),
        (EPSILON_GREEDY, 30, FAILS),
        (EPSILON_GREEDY, 100, FAILS),
        (NOVELTY, 10, SOLVES),
        (NOVELTY, 30, SOLVES),
        (NOVELTY, 100, FAILS),
        (GO_EXPLORE, 10, SOLVES),
        (GO_EXPLORE, 30, SOLVES),
        (GO_EXPLORE, 100, SOLVES),
    ],
)
def test_who_solves_what(method: str, height: int, expected: Above | Below) -> None:
    """As in the paper."""
    share = trained(height).share(method, at_least=best_return(height))
    assert expected.holds(share), f"{method} at {height}: {share}"


@pytest.mark.slow
def test_remedies_are_better_on_the_same_walls() -> None:
    """The difference in return, paired by wall and seed, is above zero."""
    assert trained(30).difference(NOVELTY, EPSILON_GREEDY).low > 0
    assert trained(100).difference(GO_EXPLORE, NOVELTY).low > 0


def goes_nowhere(environment: Any) -> Any:
    """Go-Explore that never returns: the ground always counts as the state it has visited least."""
    agent = METHODS[GO_EXPLORE](environment)
    agent.visits[1:] = 10**9
    return agent


def optimistic(environment: Any) -> QLearning:
    """ε-greedy from high values: what has not been tried looks best."""
    return QLearning.create(environment, learning_rate=0.5, discount=0.9, initial_value=1.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("make", "height", "expected"),
    [
        (partial(METHODS[NOVELTY], bonus=0.0), 30, FAILS),
        (partial(METHODS[NOVELTY], exploration=EpsilonGreedy(0.0)), 30, FAILS),
        (goes_nowhere, 30, FAILS),
        (goes_nowhere, 10, SOLVES),  # random search from the ground, with a memory of how it got there
        (optimistic, 30, SOLVES),
    ],
)
def test_what_makes_the_remedy(make: Callable[..., Any], height: int, expected: Above | Below) -> None:
    """Without the bonus, without exploring steps, or without returning first, there is no remedy; optimism is one."""
    share = compare(height, methods={"control": make}, repetitions=20, seed=1).share("control", at_least=1.0)
    assert expected.holds(share), str(share)


@pytest.mark.slow
def test_what_was_learned_is_the_wall() -> None:
    """On a wall other than its own, an agent that solves its own one falls."""
    tops = 0
    for repetition, agent in trained(30).complete_agents(GO_EXPLORE).items():
        other = make_mdp("Boulder", height=30, layout_seed=repetition)
        still = agent.recorded._replace(learning_rate=1e-9)
        tops += train(other, still, 1, evaluation_episodes=1, seed=repetition).returns[0] == 1.0
    assert FAILS.holds(proportion_interval(int(tops), 20))


@pytest.mark.slow
def test_everything_that_the_lesson_claims(tmp_path: Any) -> None:
    """With the lesson's own settings and seed; and its data is where it says."""
    report = experiments.report(folder=tmp_path)
    assert len(report.claims) == 32
    assert [claim.statement for claim in report.claims if not claim.holds] == []
    assert [figure.name for figure in report.figures] == ["exploration", "visits", "climbs", "frontier", "fork"]
    assert [len(row) for figure in report.figures for row in figure.rows] == [2, 2, 3, 3, 1, 1, 2]
    for height in methods.HEIGHTS:
        assert Results.load(tmp_path / f"height_{height}.csv").complete


def test_an_interrupted_lesson_prepares_no_figures() -> None:
    """They would be thrown away."""
    stop = threading.Event()
    stop.set()
    assert experiments.report(repetitions=2, stop=stop).figures == []


def test_random_search_formula() -> None:
    """(N^(H+1) - N)/(N - 1), by first-step analysis: E_s = 1 + E_{s+1}/N + (1 - 1/N) E_0, E_H = 0."""
    for n_grips, height in ((2, 1), (2, 10), (3, 5), (7, 3)):
        p = 1 / n_grips
        equations = np.eye(height)
        for state in range(height):
            equations[state, 0] -= 1 - p
            if state + 1 < height:
                equations[state, state + 1] -= p
        steps = np.linalg.solve(equations, np.ones(height))[0]
        assert steps == pytest.approx(random_search_steps(n_grips, height))
    assert random_search_steps(2, 10) == 2046


def test_share_of_climbs_by_hand() -> None:
    """Four climbs: two fall at once, one from height 1, and one gets to the top of a wall of two."""
    visits = np.array([[3, 1, 0], [1, 1, 1]])
    assert share_of_climbs(visits).tolist() == [1.0, 0.5, 0.25]
    assert frontier(visits) == 2
    assert first_at_top(visits, 1_000) == 500.0


@pytest.mark.slow
def test_visits_of_the_figure() -> None:
    """Every step of every run is somewhere on the wall."""
    for method in METHODS:
        for visits in visits_of(trained(30), method):
            assert visits[:, :30].sum() == methods.N_STEPS


def test_frontier_recorder_by_hand() -> None:
    """On a wall of two: wrong, right at the ground; then from the ground up, wrong and right at height 1."""
    wall = make_mdp("Boulder", height=2)
    recorder = record_frontier(METHODS[EPSILON_GREEDY], wall)
    for state, next_state in ((0, 0), (0, 1), (1, 0), (0, 1), (1, 2)):
        recorder.learn(state, 0, 0.0, next_state, next_state == 2, False)
    assert recorder.visits[:3].tolist() == [2, 2, 0]
    assert recorder.right[:3].tolist() == [0, 2, 0]


def test_highest_so_far_by_hand() -> None:
    """It never falls."""
    assert highest_so_far(np.array([[3, 1, 0, 0], [2, 1, 1, 0], [4, 0, 0, 0]])).tolist() == [0, 1, 2, 2]


def test_both_walls_of_the_fork() -> None:
    """Only the top of the right wall ends the episode; the top of the left one, and every wrong grip, is a fall."""
    fork, rng = Fork.create(height=3, layout_seed=1), np.random.default_rng(0)
    assert [fork.transition(0, action, rng) for action in (0, 1)] == [1, 4]
    for state in (1, 2, 4, 5):
        right = int(fork.grips[state])
        assert (fork.transition(state, right, rng), fork.transition(state, 1 - right, rng)) == (state + 1, 0)
    assert [fork.transition(3, action, rng) for action in (0, 1)] == [0, 0]
    assert [fork.terminal(state) for state in range(7)] == [False] * 6 + [True]
    assert fork.reward(5, 0, 6, rng) == 1.0
    assert fork.reward(2, 0, 3, rng) == 0.0


@pytest.mark.parametrize("height", [3, 30])
def test_the_picture_of_the_fork(height: int) -> None:
    """The climber stands before its wall, below the two grips that it can reach; the one that holds is grey."""
    fork = Fork.create(height=height, layout_seed=1)
    for state in range(2 * height + 1):
        scene = fork.scene(state)
        circles = [shape for shape in scene.shapes if isinstance(shape, Circle)]
        (face,) = (shape for shape in circles if shape.radius == 0.42)
        assert face.x == (4.0 if state == 0 else 2.0 if state <= height else 6.0)
        assert 0.42 < face.y < scene.height
        colours = {c.x - face.x: c.fill for c in circles if (c.radius, c.y) == (0.3, face.y - 0.5) and state % height}
        grey = [fork.grips[state] == grip for grip in (0, 1)] if state % height else []
        near = {x: colour for x, colour in colours.items() if abs(x) < 1}
        assert near == {x: STONE if holds else CRACK for x, holds in zip((-0.5, 0.5), grey, strict=False)}


def test_visits_of_two_branches_by_hand() -> None:
    """Ground, two positions on the left, two on the right; the run turns twice and gives up the right top."""
    visits = np.array([[1, 3, 0, 1, 0], [1, 1, 0, 2, 1], [1, 4, 1, 1, 0], [1, 2, 0, 0, 0]])
    left, right = branches(visits)
    assert left.tolist() == [[3, 0], [1, 0], [4, 1], [2, 0]]
    assert right.tolist() == [[1, 0], [2, 1], [1, 0], [0, 0]]
    assert turns(visits) == 2
    assert not returns_to(visits)
    visits[3, 4] = 1
    assert returns_to(visits)


@pytest.mark.slow
def test_progress_is_drawn_over_the_whole_training() -> None:
    """From the ground at the start to the top of a low wall at the end."""
    ax = progress(compare(2, repetitions=2), 2).draw()
    assert ax.get_xlim() == (0.0, methods.N_STEPS)
    curves = [np.asarray(line.get_ydata()) for line in ax.get_lines()]
    assert [(curve[0], curve[-1]) for curve in curves] == [(0, 2)] * 3


def test_best_returns_by_hand() -> None:
    """On a wall of one a random climber fails ten times with probability 1 / 2^10; with three grips more often."""
    assert best_return(1, 1.0) == pytest.approx(1 - 0.5**10)
    assert best_return(1, 1.0, 3) == pytest.approx(1 - (2 / 3) ** 10)
    assert best_return(30) == 1.0
