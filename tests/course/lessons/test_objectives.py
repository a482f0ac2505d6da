"""Several objectives on Diver: what is computed exactly, the seas of the project, and the claims."""

from typing import Any

import numpy as np
import pytest

from edugym.training.train_vectors import VectorRun
from edugym_course.lessons.objectives import experiments, methods, project
from tests.course.lessons.made_up import measured


@pytest.mark.parametrize("concavity", experiments.CONCAVITIES)
def test_what_is_asked_for(concavity: float) -> None:
    """Every treasure is the closest for some weight, without a tie; the prices find all that some weights prefer."""
    front = methods.front_of(concavity)
    assert [methods.treasure_of(returns) for returns in front] == [*range(9)]
    assert set(methods.closest(concavity)) == set(range(9))
    assert len(methods.planned_by_weights(concavity)) == experiments.n_supported(concavity)
    for weights in methods.TIME_WEIGHTS:
        missing = ((front.max(axis=0) - front) * (1.0, weights)).max(axis=1)
        assert np.diff(np.sort(missing))[0] > 0.01
    for price in methods.PRICES:
        assert np.diff(np.sort(front @ (1.0, price)))[-1] > 0.001


def test_a_dive_that_does_not_end() -> None:
    """It picks up nothing."""
    assert methods.treasure_of((0.0, -100.0)) == methods.N_TREASURES


@pytest.mark.parametrize("best", range(4))
def test_seas(best: int) -> None:
    """The best treasure within the limit is the one that was asked for; the mistakes pick up others."""
    picks = dict.fromkeys(project.MISTAKES, 0)
    for seed in range(20):
        values = project.sea(best, np.random.default_rng(seed))
        within = values[methods.too_long(np.array([[0.0, -steps] for steps in project.STEPS_TO])) == 0]
        assert within.argmax() == best
        assert values[4:].min() > within.max() + 30
        for why, rule in project.MISTAKES.items():
            picks[why] += rule(values) == best
    always = sum(count == 20 for count in picks.values())
    assert always == {0: 2}.get(best, 1)


def run(*returns: tuple[float, float]) -> Any:
    """A run with such training dives."""
    dives = np.array(returns)
    return VectorRun(np.array([0]), dives[:1], dives, np.arange(len(dives)), None, 0, 0.0, complete=True)


def test_claims() -> None:
    """Each is about what it names."""
    assert measured(experiments.weight_claims({1.0: [[0, 8, 8], [8, 3]]})) == [2.5, 2.0]  # treasure 3 is none
    assert measured(experiments.set_claims({0.5: [[*range(9)], [*range(8), 9]]})) == [8.0]
    asked = methods.closest(0.5)
    deeper = [min(treasure + 1, 8) for treasure in asked]
    found = measured(experiments.distance_claims({0.5: [asked, asked]}, {0.5: [deeper, asked]}))
    same = np.mean(np.array(asked) == deeper)
    assert found == pytest.approx([1.0, (1 + same) / 2, (1 - same) / 2], abs=1e-6)
    dives = run((10, -1), (10, -1), (90, -17), (10, -1), (10, -1), (90, -17))
    claims = experiments.limit_claims({(1.0, 7): [dives, dives], (0.0, 7): [dives, dives]})
    value, steps = 110 / 3 - 40, 19 / 3 - 7
    assert measured(claims) == pytest.approx([1 / 3, value, steps, 0.0], abs=1e-6)
    short = [(10, -1)] * 200
    free, dear, never = run(*[(90, -17)] * 100, *short), run(*[(10, -1)] * 80, *[(90, -17)] * 20, *short), run(*short)
    stuck = run(*[(90, -17)] * 300)
    runs = {name: [never, stuck, never] for name in experiments.BEGINNINGS}
    runs |= {experiments.FREE: [free, stuck, free], experiments.DEAR: [dear, dear, stuck]}
    found = measured(experiments.learning_claims((0.0, 7), runs))
    assert found == [100.0, 20.0, 0.0, 0.0, 0.0, 0.0, 20.0 - 0.5 * 100.0]  # what does not settle does not count


def test_late_prices() -> None:
    """By hand, for a limit of 7 and a rate of 0.01: 10 steps too many, then 6 too few twice, and never below 0."""
    dives = run((90, -17), (10, -1), (10, -1), (90, -17))
    assert methods.late_prices(dives).tolist() == pytest.approx([0.0, 0.1])


@pytest.mark.slow
def test_known_values() -> None:
    """Only the price begins anew: with a high one, no dive goes where the values of before do not lead."""
    known, new = (methods.lagrangian(0.0, first_price=30.0, n_steps=9_000, known=known) for known in (True, False))
    assert methods.too_long(known.training_returns).sum() == 0
    assert methods.too_long(new.training_returns).sum() > 40
