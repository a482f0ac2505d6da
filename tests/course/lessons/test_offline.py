"""Offline learning: what is measured of learning from data, of judging by data, and what a program may not know."""

from typing import Any

import numpy as np
import pytest

from edugym import fitted_q_iteration, pessimistic_q_iteration
from edugym.agents.dataset import Dataset, collect
from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.offline import methods, project, riddles
from edugym_course.lessons.offline.methods import AS_IT_IS, MORNING, PESSIMISTIC, UNSEEN_IS_WORST


def test_the_clocks_are_between_random_and_best() -> None:
    """A larger share is worth more; share 1 is the best, share 0 presses buttons at random."""
    worths = [MORNING.worth(methods.clock(MORNING, share)) for share in (0.0, 0.5, 0.97, 1.0)]
    assert worths == sorted(worths)
    assert worths[-1] == pytest.approx(MORNING.worth(methods.best_of(MORNING)))
    assert np.abs(methods.clock(MORNING, 0.0) - 1 / 3).max() < 1e-12


def test_no_night_is_below_the_lowest() -> None:
    """Eight rings, and oversleeping: in no state is a smaller return possible."""
    data = collect(MORNING.model, methods.clock(MORNING, 0.0), 5000, seed=1)
    assert data.returns().min() > MORNING.lowest
    assert MORNING.lowest == -42
    roadrunner = methods.ROADRUNNER
    assert collect(roadrunner.model, methods.clock(roadrunner, 0.0), 500, seed=1).returns().min() > roadrunner.lowest


def test_the_rules_are_those_that_the_lesson_names() -> None:
    """As it is, zero for what is unseen; the worst without a penalty; and with it."""
    data = collect(MORNING.model, methods.clock(MORNING, 0.9), 50, seed=1)
    for rule, expected in (
        (AS_IT_IS, fitted_q_iteration(data)),
        (UNSEEN_IS_WORST, fitted_q_iteration(data, unseen=-42.0)),
        (PESSIMISTIC, pessimistic_q_iteration(data, 3.0, -42.0)),
    ):
        assert np.array_equal(methods.learn(data, rule, MORNING, 3.0).Q, expected.Q), rule


def test_the_measures_of_learning() -> None:
    """Nothing keeps more than the best; runs repeat, and differ with the seed; what is promised is what was learned."""
    found = methods.learned(n_nights=100, repetitions=4, seed=3)
    assert all((kept <= found.best + 1e-9).all() for kept in found.kept.values())
    assert found.too_much(AS_IT_IS).tolist() == (found.promised[AS_IT_IS] - found.kept[AS_IT_IS]).tolist()
    again, other = (methods.learned(n_nights=100, repetitions=4, seed=seed) for seed in (3, 4))
    assert np.array_equal(found.gathered, again.gathered)
    assert not np.array_equal(found.gathered, other.gathered)
    assert (found.too_much(AS_IT_IS) > 2).all()
    assert found.too_much(PESSIMISTIC).mean() < 0


def test_the_measures_of_judging() -> None:
    """As many nights count as agree in all steps, and the exact value is that of the best clock."""
    found = methods.judged(n_nights=2000, repetitions=4, seed=1)
    assert found.exact == pytest.approx(10.325)
    assert found.effective.mean() == pytest.approx(2000 * (2 / 3) ** 8, rel=0.2)
    assert found.gathered.mean() == pytest.approx(MORNING.worth(methods.clock(MORNING, 0.5)), abs=0.5)
    assert found.errors("weighted").mean() < 2


def test_imitation_needs_a_good_clock() -> None:
    """The most frequent action of a good clock is the best one; that of random buttons is any."""
    assert methods.imitated(share=0.97, repetitions=3).min() > 10
    assert methods.imitated(share=0.0, repetitions=3).max() < 5


def test_states_of_the_project_have_new_numbers_each_time() -> None:
    """A policy that goes by the numbers of one log-book is worth little with another."""
    seen: list[set[Any]] = []

    def program(steps: Any, n_states: int, n_actions: int, seed: int) -> Any:
        seen.append({step[3] for step in steps if step[4]})  # in these a night ends
        return lambda state: 1

    for seed in (1, 2):
        project.run(program, seed)
    assert seen[0] != seen[1]
    with pytest.raises(WrongAnswer, match="it chooses the same action in every state"):
        project.project_16(program, 0)


@pytest.mark.parametrize("riddle", riddles.RIDDLES, ids=lambda riddle: riddle.asks)
def test_a_riddle_has_one_answer_for_whoever_is_careful(riddle: riddles.Riddle) -> None:
    """It is the same for small and for large penalties, and for any lowest value that no return is below."""
    for seed in range(3):
        book = riddles.log_book(riddle, np.random.default_rng(seed))
        states, actions, rewards, next_states, terminated = map(np.array, zip(*book.steps, strict=True))
        assert np.flatnonzero(terminated).tolist() == [*range(9, 800, 10)]
        assert not (states == next_states[-1]).any()
        data = Dataset.create(
            states,
            actions,
            rewards,
            next_states,
            terminated,
            truncated=np.zeros(800, bool),
            probabilities=np.ones(800),  # nobody asks for them
            n_states=book.n_states,
            n_actions=riddle.n_actions,
        )
        assert data.returns().min() >= -90
        for penalty, lowest in ((0.3, -90.0), (2.0, -90.0), (5.0, -90.0), (2.0, -1000.0)):
            Q = pessimistic_q_iteration(data, penalty, lowest).Q
            assert Q[book.first].argmax() == riddle.right, (seed, penalty, lowest)
