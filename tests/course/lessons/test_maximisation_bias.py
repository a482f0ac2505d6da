"""Maximisation bias: what is counted, the negative controls, and what a program may not know."""

from typing import Any

import numpy as np
import pytest

from edugym import expected_choice, expected_maximum, make_mdp, mean_interval, paired_difference
from edugym.envs.casino import STREET
from edugym_course.lessons.maximisation_bias import methods, project
from edugym_course.lessons.maximisation_bias.methods import DOUBLE, EIGHT, PAYING, Q_LEARNING, Walks


class Stubborn:
    """Goes in, and plays machine 0; or goes home."""

    def __init__(self, goes_in: bool) -> None:
        """See the class."""
        self._street = 0 if goes_in else 1

    def act(self, state: int, rng: np.random.Generator) -> int:
        """Always the same."""
        return self._street if state == STREET else 0

    def learn(self, *step: object) -> None:
        """Nothing."""


def test_what_is_counted() -> None:
    """Episodes that lead into the casino, and what they return."""
    mdp = make_mdp("Casino", noise=0.0, loss=0.25)
    for goes_in in (True, False):
        went_in, earned = methods.walk(mdp, Stubborn(goes_in), 5, seed=0)
        assert went_in.tolist() == [goes_in] * 5
        assert earned.tolist() == [-0.25 * goes_in] * 5
    walked = Walks(np.eye(4), np.arange(16.0).reshape(4, 4))
    assert walked.share(slice(1, 3)).tolist() == [0, 0.5, 0.5, 0]
    assert walked.income(slice(2, 4)).tolist() == [2.5, 6.5, 10.5, 14.5]


def test_it_takes_noise_and_a_choice() -> None:
    """Q-learning goes in far more often than double Q-learning, and not without noise or with one machine."""
    how: Any = {"n_episodes": 100, "repetitions": 25, "seed": 3}
    share = {method: methods.walks(method, **how).share() for method in (Q_LEARNING, DOUBLE)}
    assert paired_difference(share[Q_LEARNING], share[DOUBLE]).low > 0.3
    assert mean_interval(methods.walks(Q_LEARNING, noise=0.0, **how).share()).high < 0.15
    assert mean_interval(methods.walks(Q_LEARNING, n_machines=1, **how).share()).high < 0.25


def test_pessimism_costs_where_a_machine_pays() -> None:
    """Eight tables stay outside; without noise they do not."""
    how: Any = {"n_episodes": methods.LONG, "repetitions": 20, "seed": 3, **PAYING}
    assert mean_interval(methods.walks(EIGHT, **how).income()).high < 0.3
    assert mean_interval(methods.walks(EIGHT, noise=0.0, **how).income()).low > 0.6
    assert methods.best_income() == pytest.approx(14 / 15 * (14 / 15 * 0.9 - 1 / 15 * 0.1))


def test_sample_means_are_those_of_the_exact_sums() -> None:
    """The largest, of one table and of three, and the second opinion; runs repeat, and differ with the seed."""
    payoffs = make_mdp("Casino", n_machines=4, advantage=0.5).payoffs
    for n_tables in (1, 3):
        found = methods.tried(4, n_tables, n_machines=4, advantage=0.5, repetitions=2_000, seed=1)
        for measured, exact in (
            (found.largest, expected_maximum(payoffs, 4, n_tables=n_tables)),
            (found.second_opinion, expected_choice(payoffs, 4, n_tables=n_tables)),
        ):
            interval = mean_interval(measured, confidence=0.999)
            assert interval.low < exact < interval.high
    again, other = (methods.tried(4, repetitions=5, seed=seed).largest for seed in (3, 4))
    assert again.tolist() == methods.tried(4, repetitions=5, seed=3).largest.tolist()
    assert again.tolist() != other.tolist()


def test_casinos_of_the_project_have_new_numbers_each_time() -> None:
    """Whoever knows the numbers of one casino finds nothing in another."""
    streets = {project.Shuffled(project.GOOD, seed).shown(STREET) for seed in range(20)}
    assert streets == {0, 1, 2}
    doors = {project.Shuffled(project.BAD, seed).meant(0) for seed in range(60)}
    assert len(doors) > 5

    def program(environment: Any, n_steps: int, seed: int) -> Any:
        rng = np.random.default_rng(seed)
        environment.reset(seed=seed)
        for _ in range(n_steps):
            *_, terminated, truncated, _ = environment.step(int(rng.integers(3)))
            if terminated or truncated:
                environment.reset()
        return lambda state: 0

    played = [project.visit(program, project.GOOD, 200, seed).plays for seed in range(60)]
    assert np.mean([machine == project.GOOD.n_machines - 1 for machine in played]) < project.FEWEST / 2
