"""Bins and continuous actions on Trashbot: the parts of the lesson are right, and its claims hold."""

from functools import partial

import numpy as np
import pytest

from edugym.envs.trashbot.planning import best_plan
from edugym.envs.trashbot.task import Trashbot
from edugym_course.grading import WrongAnswer
from edugym_course.lessons.continuous_actions import draws, exact, experiments, methods, ppo, project, release
from tests.course.lessons.made_up import made_up, measured


@pytest.mark.parametrize("n_bins", [2, 3, 4])
def test_deliveries_are_those_of_the_exact_search(n_bins: int) -> None:
    """The best return, the number of places, and the place nearest to the middle."""
    plan, found = best_plan(Trashbot.create(n_bins)), exact.deliveries(n_bins)
    assert found.best_return == pytest.approx(3.0 + plan.centring)
    assert len(found.places) == plan.places
    assert found.fewest_steps == plan.fewest_steps
    assert 2.0 * (1.0 - np.abs(found.places).min() / 0.1) == pytest.approx(plan.centring)


@pytest.mark.parametrize("baseline", [0.0, 3.0])
def test_the_estimate_is_right_on_average(baseline: float) -> None:
    """Of both slopes, whatever the baseline."""
    found = release.estimates(0.6, 0.5, 200_000, baseline=baseline, seed=5)
    assert found.mean(axis=1) == pytest.approx(release.slopes(0.6, 0.5), abs=0.05)


@pytest.mark.slow
def test_claims_that_need_no_training() -> None:
    """They hold."""
    claims = [
        *experiments.exact_claims(),
        *experiments.gradient_claims(),
        *experiments.peak_claims(),
        *experiments.ppo_claims(ppo.STORED.load()),
    ]
    assert [claim.statement for claim in claims if not claim.holds] == []
    assert len(claims) >= 12


def test_tables_of_bins() -> None:
    """Holding the box is seen; a run that never gets to a goal counts whole; no delivery is worth nothing."""
    task, rng = methods.in_a_table(5), np.random.default_rng(0)
    state = task.initial(rng)
    before, after = (tuple(task.observation(state._replace(holding=held), rng)) for held in (False, True))
    assert before[:-1] == after[:-1]
    assert before[-1] != after[-1]
    results = methods.learn_bins(3, n_steps=500, repetitions=2)
    assert methods.steps_to(results, "3 bins", -10.0).tolist() == [0.0, 0.0]
    assert methods.steps_to(results, "3 bins", 10.0).tolist() == [500.0, 500.0]
    assert exact.deliveries(3, 0.3)[1:] == (0.0, 0)
    assert len(exact.deliveries(3, 0.3).places) == 0


@pytest.mark.slow
def test_a_short_run_of_ppo() -> None:
    """Its policy can be drawn from, and the same seed draws the same."""
    run = ppo.trainer("continuous", 16_384)(16_384, seed=0)
    seen = np.zeros(7, np.float32)
    actions = [methods.Drawing(run.agent, seed)(seen).tolist() for seed in (0, 0, 1)]
    assert actions[0] == actions[1] != actions[2]


def test_the_mean_of_a_policy_in_bins_is_its_likeliest_action() -> None:
    """Not the one that it took: only the right one of two pays, and the left one is still tried now and then.

    The first update changes nothing, since the baseline is the first reward.
    """
    found = release.climb_in_bins(2, n_updates=300, n_runs=50, pays=lambda a: np.where(a > 0, 1.0, 0.0))
    assert found.means.shape == (301, 50)
    assert (found.means[:2] == -3.0).all()
    assert (found.means[-20:] == 3.0).all()
    assert 0.8 < found.values[-20:].mean() < 1.0


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (2, 3))])
def test_a_program_that_draws_its_actions(seed: int) -> None:
    """Our program passes; with a mistake it is told as this one."""
    project.check_equations(project.reinforce, seed)
    for sentence, make in (project.MISTAKES | draws.WRONG_SPREADS).items():
        with pytest.raises(WrongAnswer) as refused:
            project.check_equations(partial(project.reinforce, make=make), seed)
        assert str(refused.value).endswith(sentence)


def test_continuous_actions() -> None:
    """Steps to a return of 3.5, and the late returns: the mean of the last five points."""
    three, five, nine = ({0: 0.0, step: 3.5, 60: 4.0, 70: 4.0, 80: 4.0, 90: 4.0, 100: 4.0} for step in (10, 20, 50))
    curves = {"3 bins": [three, three], "5 bins": [five, five], "9 bins": [nine, nine]}
    fast: dict[int, float] = {0: 0.0, 10: 3.49, 30: 3.6, 60: 4.3, 70: 4.3, 80: 4.3, 90: 4.3, 100: 4.3}
    curves[ppo.CONTINUOUS] = [fast, {step: value + 0.02 * (step > 50) for step, value in fast.items()}]
    narrow = {
        method: [{step: value - shift for step, value in run.items()} for run in runs]
        for (method, runs), shift in zip(curves.items(), (4.0, 1.0, 0.0, 2.0), strict=True)
    }
    claims = experiments.learning_claims(made_up(curves, 100), made_up(narrow, 100))
    assert measured(claims) == [0.0, 0.5, -10.0, -30.0, -20.0, 0.0, -1.0, -2.0]
