"""Exploration on Boulder: what is counted on walls, by hand, and what the claims measure."""

import math

import numpy as np
import pytest

from edugym import make_mdp
from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.exploration import climbs, exercises, figures, fork, methods, optimism, stalling
from tests.course.lessons.made_up import follower, made_up, measured


def test_visits_by_hand() -> None:
    """Of one wall and of two; with three grips random climbers fail more often."""
    assert [climbs.random_search_steps(*wall) for wall in ((2, 1), (2, 10), (3, 5), (7, 3))] == [2, 2046, 363, 399]
    # Four climbs: two fall at once, one from height 1, and one gets to the top of a wall of two.
    visits = np.array([[3, 1, 0], [1, 1, 1]])
    assert climbs.share_of_climbs(visits).tolist() == [1.0, 0.5, 0.25]
    assert climbs.frontier(visits) == 2
    assert climbs.first_at_top(visits, 1_000) == 500.0

    wall = make_mdp("Boulder", height=2)
    recorder = stalling.record_frontier(methods.METHODS[methods.EPSILON_GREEDY], wall)
    for state, next_state in ((0, 0), (0, 1), (1, 0), (0, 1), (1, 2)):
        recorder.learn(state, 0, 0.0, next_state, next_state == 2, False)
    assert recorder.visits[:3].tolist() == [2, 2, 0]
    assert recorder.right[:3].tolist() == [0, 2, 0]

    assert figures.highest_so_far(np.array([[3, 1, 0, 0], [2, 1, 1, 0], [4, 0, 0, 0]])).tolist() == [0, 1, 2, 2]

    # Ground, two positions on the left, two on the right; the run turns twice and gives up the right top.
    visits = np.array([[1, 3, 0, 1, 0], [1, 1, 0, 2, 1], [1, 4, 1, 1, 0], [1, 2, 0, 0, 0]])
    left, right = fork.branches(visits)
    assert left.tolist() == [[3, 0], [1, 0], [4, 1], [2, 0]]
    assert right.tolist() == [[1, 0], [2, 1], [1, 0], [0, 0]]
    assert fork.turns(visits) == 2
    assert not fork.returns_to(visits)
    visits[3, 4] = 1
    assert fork.returns_to(visits)

    assert methods.best_return(1, 1.0) == pytest.approx(1 - 0.5**10)
    assert methods.best_return(1, 1.0, 3) == pytest.approx(1 - (2 / 3) ** 10)
    assert methods.best_return(30) == 1.0


@pytest.mark.parametrize("height", range(60, 161))
def test_six_digits_are_enough(height: int) -> None:
    """Of every wall that a student may have: the nearest number and the one below, but not those of other walls."""

    def digits(number: float) -> tuple[float, float]:
        return round(number, 6), math.floor(1_000_000 * number) / 1_000_000

    for answer in digits(2 * (1 - 0.5 ** (1 / height))):
        assert "Right" in exercises.exercise_1(answer, 0, height)
    others = [2 * (1 - 0.5 ** (1 / (height + more))) for more in (-1, 1)]
    for answer in [*digits(2 * math.log(2) / height), *digits(others[0]), *digits(others[1])]:
        with pytest.raises(WrongAnswer):
            exercises.exercise_1(answer, 0, height)


def test_both_walls_of_the_fork() -> None:
    """Only the top of the right wall ends the episode; the top of the left one, and every wrong grip, is a fall."""
    forked, rng = fork.Fork.create(height=3, layout_seed=1), np.random.default_rng(0)
    assert [forked.transition(0, action, rng) for action in (0, 1)] == [1, 4]
    for state in (1, 2, 4, 5):
        right = int(forked.grips[state])
        assert (forked.transition(state, right, rng), forked.transition(state, 1 - right, rng)) == (state + 1, 0)
    assert [forked.transition(3, action, rng) for action in (0, 1)] == [0, 0]
    assert [forked.terminal(state) for state in range(7)] == [False] * 6 + [True]
    assert forked.reward(5, 0, 6, rng) == 1.0
    assert forked.reward(2, 0, 3, rng) == 0.0


def test_exploration() -> None:
    """Visits by hand on a wall of 100: a frontier at 2, and half of the later climbs get back to it."""
    visits = np.zeros((4, 101), np.int64)
    visits[:, :3] = [[4, 1, 0], [4, 2, 1], [6, 4, 3], [2, 1, 1]]
    assert climbs.return_to_frontier(visits) == pytest.approx(0.5 / 0.95**2)
    assert fork.higher_frontier(visits) == 2
    visits[3, 100] = 1
    late, never = follower({}, visits=visits), follower({}, visits=visits * (np.arange(101) < 100))
    early = follower({}, visits=np.roll(visits, -1, axis=0))
    results = made_up(
        {
            method: [{0: value, 10: 1.0}, {0: value, 10: value}]
            for method, value in zip(optimism.OPTIMISTS, (0.5, 1.0, 0.0, 0.0, 0.5, 0.25, 1.0), strict=True)
        },
        agents={methods.OPTIMISM: [early, late], methods.GO_EXPLORE: [late, never]},
    )
    quarter = methods.N_STEPS / 4
    of_one_wall, by_digit = [0.5, 0.5, -quarter], [-0.1875, 0.375, 0.0]
    assert optimism.first(results, methods.GO_EXPLORE) == [3 * quarter, 4 * quarter]
    leaders = made_up({methods.OPTIMISM: [{0: 0.75, 10: 0.75}] * 2, methods.GO_EXPLORE: [{0: 0.5, 10: 0.5}] * 2})
    claims = optimism.optimism_claims(dict.fromkeys(optimism.WALLS, results), leaders)
    assert measured(claims) == [*of_one_wall * 3, 0.5, 0.5, -0.375, 0.25, 1.0, *by_digit * 2]
    assert {one for claim in claims for one in claim.tested_by} <= {claim.statement for claim in claims}


def test_who_knows_the_wall() -> None:
    """Who takes the right grips of its own wall leads to its frontier; on a wall of three 0.95³ of all climbs do."""
    walls = [make_mdp("Boulder", height=5, layout_seed=seed).grips.tolist() for seed in (3, 4)]
    assert walls[0][:3] != walls[1][:3]
    visits = np.array([[3, 2, 0, 0, 0, 0], [3, 1, 1, 1, 0, 0]])
    right = [follower(dict(enumerate([*wall[:3], 1 - wall[3]])), visits=visits) for wall in walls]
    method = methods.NOVELTY
    results = made_up({method: [{10: 0.0}] * 2}, agents={method: right}, layout_seed=[3, 4])
    assert climbs.greedy_leads_to_frontier(results, method, 5) == [True, True]
    exchanged = made_up({method: [{10: 0.0}] * 2}, agents={method: right[::-1]}, layout_seed=[3, 4])
    assert climbs.greedy_leads_to_frontier(exchanged, method, 5) == [False, False]
    share = climbs.watch_climbs(3, n_steps=20_000, repetitions=2, jobs=1)
    assert share.estimate == pytest.approx(0.95**3, abs=0.012)


def test_claims_of_frontiers() -> None:
    """Three turns and one, frontiers of 2 and 1; at a frontier 3 of 4 grips are right on first visits, later 1 of 4."""
    runs = [
        follower({}, visits=np.array(visits))
        for visits in (
            [[1, 3, 0, 1, 0], [1, 1, 0, 2, 1], [1, 4, 1, 1, 0], [1, 2, 0, 3, 1]],
            [[1, 3, 0, 1, 0], [1, 3, 0, 1, 0], [1, 3, 0, 0, 0], [1, 0, 0, 0, 0]],
        )
    ]
    wall = follower({}, visits=np.array([[2, 1, 1, 0], [1, 1, 1, 1]]))
    method = methods.NOVELTY
    results, one_wall = (made_up({method: [{10: 0.0}] * 2}, agents={method: agents}) for agents in (runs, [wall, wall]))
    assert measured(fork.fork_claims(results, one_wall)) == [2.0, 0.5, -1.5]

    visits, right = np.zeros((2, 2, 10), np.int64)
    visits[0, :3], right[0, :2], visits[1, 0], right[1, 0] = [4, 3, 1], [3, 1], 2, 1
    runs = [follower({}, visits=one, right=other) for one, other in zip(visits, right, strict=True)]
    watched = made_up(dict.fromkeys(stalling.CAUSES, [{10: 0.0}] * 2), agents=dict.fromkeys(stalling.CAUSES, runs))
    assert stalling.right_grips(watched, method, 1, 1) == [0.75, 0.5]
    assert stalling.right_grips(watched, method, 2) == [0.25]
    claims = stalling.stalling_claims({100: watched})
    assert measured(claims) == [0.625, 0.25, 0.25, 0.25]
    assert claims[1].tested_by == (claims[3].statement,)
    visits[:, 1] = 15
    line = stalling.frontier_lines(watched).lines[method]
    assert line[1] == 1 / 30
    assert math.isnan(line[0])
