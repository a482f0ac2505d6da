"""The depth of credit assignment on Study: the claims hold with other seeds than those the lesson shows."""

import math

import numpy as np
import pytest

from edugym.envs.study import Study
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures import Sheet
from edugym_course.lessons.depth.credit import credit_maps, handed_back
from edugym_course.lessons.depth.figures import (
    best_rates,
    bias_series,
    episodes_until,
    rate_series,
    split,
    through_rates,
    variance_sheet,
)
from edugym_course.lessons.depth.methods import (
    MONTE_CARLO,
    best_returns,
    compare,
    expected_returns,
    greedy_return,
    layouts,
    met_exam,
    passes,
    pupil,
    shortfall,
)
from edugym_course.lessons.depth.off_policy import off_policy_sheet, uncorrected, weighted_deviation
from edugym_course.lessons.depth.targets import DAYS, noise_share, soft_policy, target, true_values
from tests.course.lessons.figures import check_legends


def test_target_against_samples() -> None:
    """Mean and variance of the three-step target agree with sampled episodes of a random policy."""
    task = Study.create(action_reward_noise_sigma=0.5)
    model = finite_model(task)
    policy = np.full(model.successors.shape[:2], 0.2)
    Q = true_values(model, policy) + 1.0
    rng = np.random.default_rng(0)
    targets = []
    for _ in range(10_000):
        state, total = task.initial(rng), 0.0
        for _ in range(3):
            action = int(rng.integers(5))
            next_state = task.transition(state, action, rng)
            total += task.reward(state, action, next_state, rng)
            state = next_state
        targets.append(total + Q[model.row(state), rng.integers(5)])
    exact = target(model, policy, Q, 3, 0.5)
    assert np.mean(targets) == pytest.approx(exact.mean, abs=0.04)
    assert np.var(targets) == pytest.approx(exact.noise + exact.exploration, rel=0.06)


def test_target_at_the_fixed_point() -> None:
    """With the values of the policy every n has the same mean; the variance grows with n."""
    model = finite_model(Study.create())
    policy = soft_policy(model, 0.1)
    Q = true_values(model, policy)
    targets = [target(model, policy, Q, n, 0.2) for n in range(1, DAYS + 1)]
    assert [one.mean for one in targets] == pytest.approx([policy_evaluation(model, policy).start] * DAYS)
    variances = [one.noise + one.exploration for one in targets]
    assert variances == sorted(variances)


def test_noise_share() -> None:
    """Without noise there is none in the variance, and more noise is a larger part of it."""
    assert noise_share(0.0) == 0.0
    assert noise_share(0.05) < noise_share(0.2) < noise_share(1.0) < 1.0


def test_expected_returns_are_within_the_optimum() -> None:
    """The exact greedy return of every run is at most the optimum of its layout, and differs between layouts."""
    results = compare(n_steps=2_000, repetitions=3, seed=1)
    tasks = layouts(results)
    assert len({task.lectures.tobytes() + task.action_rewards.tobytes() for task in tasks.values()}) == 3
    returns = expected_returns(results, MONTE_CARLO)
    for repetition, task in tasks.items():
        [optimum] = best_returns({0: task}, 0.0)
        assert returns[repetition] <= optimum + 1e-9
    optimum, soft = best_returns(tasks, 0.0, 0.1)
    assert soft < optimum


def test_hand_back_over_equal_episodes() -> None:
    """The reward is d steps back after k episodes as often as k tosses of a coin with α show ceil((d+1)/n) heads."""
    alpha, episodes = 0.1, 40
    for n in (1, 3, 5, math.inf):
        values = handed_back(n, alpha, episodes)
        for d in range(DAYS):
            heads = 1 if n == math.inf else math.ceil((d + 1) / n)
            expected = [
                10 * sum(math.comb(k, i) * alpha**i * (1 - alpha) ** (k - i) for i in range(heads, k + 1))
                for k in range(episodes + 1)
            ]
            np.testing.assert_allclose(values[:, DAYS - 1 - d], expected, atol=1e-9)
    assert [episodes_until(handed_back(n)) for n in (1, 3, 5, math.inf)] == [97, 37, 17, 7]
    assert episodes_until(handed_back(1, episodes=5)) == math.inf


def test_parts_of_the_variance() -> None:
    """They add up to the variance of the target, and more noise changes its own part only."""
    low, high = split(0.2), split(1.0)
    noise, exploration = low
    np.testing.assert_allclose(low[exploration], high[exploration])
    np.testing.assert_allclose(high[noise], np.arange(1, DAYS + 1))
    assert low[noise][-1] / (low[noise][-1] + low[exploration][-1]) == pytest.approx(noise_share(0.2))


def test_bias_is_zero_at_the_fixed_point_only() -> None:
    """With values of 0 all but the last target miss the exam."""
    lines = bias_series().lines
    np.testing.assert_allclose(lines["values learned"], 0.0, atol=1e-9)
    assert (lines["values still 0"][:-1] < -5).all()
    assert lines["values still 0"][-1] == pytest.approx(0.0)


def test_uncorrected_targets() -> None:
    """One step of Q-learning has no bias; ten steps have that of an ε-greedy policy after a greedy first action."""
    model = finite_model(Study.create())
    bias, deviation = uncorrected(model)
    assert bias[0] == pytest.approx(0.0)
    assert deviation[0] == pytest.approx(0.0)
    assert (np.diff(bias) <= 1e-9).all()
    assert bias[-1] < -1
    none, zero = uncorrected(model, epsilon=0.0)
    np.testing.assert_allclose(none, 0.0, atol=1e-9)
    np.testing.assert_allclose(zero, 0.0, atol=1e-4)
    assert weighted_deviation(9.0, 1) == 0.0
    assert weighted_deviation(2.0, 2, 0.4, 4) == pytest.approx(2 * math.sqrt(1 / 0.7 - 1))


def test_what_the_figures_show() -> None:
    """Every panel has a line for each method, and draws itself alone as well as on a sheet."""
    by_rate = through_rates((0.1, 0.3), n_steps=100, repetitions=2)
    assert [*rate_series(by_rate).measured] == ["n = 1", "n = 3", "n = 5", "Monte Carlo"]
    assert set(best_rates(by_rate)) == {1, 3, 5, math.inf}
    assert [[panel.title for panel in row] for row in credit_maps().rows] == [["n = 1", "n = 3", "Monte Carlo"]]
    for sheet in (credit_maps(), variance_sheet(), off_policy_sheet(), Sheet("rates", [[rate_series(by_rate)]])):
        assert sheet._repr_png_()[:4] == b"\x89PNG"
        check_legends(sheet)
        for row in sheet.rows:
            assert row[0].draw().get_title() == row[0].title


def test_the_best_returns_are_those_of_planning() -> None:
    """The optimum comes from a formula, the ε-soft one from the exact model."""
    for seed in range(5):
        task = Study.create(layout_seed=seed)
        model = finite_model(task)
        assert best_returns({0: task}, 0.0, 0.1) == pytest.approx(
            [value_iteration(model).start, value_iteration(model, epsilon=0.1).start]
        )


def test_who_met_the_exam() -> None:
    """Whoever passes in the end has met it, and who never had time has not."""
    results = compare(depths=(1, math.inf), n_steps=3_000, repetitions=6, seed=2)
    for method in results.methods:
        assert (passes(results, method) <= met_exam(results, method)).all()
        short = shortfall(results, method)
        assert math.isnan(short) or short >= 0
    assert not met_exam(compare(depths=(1,), n_steps=10, repetitions=2), "n = 1").any()
    assert math.isnan(shortfall(compare(depths=(1,), n_steps=10, repetitions=2), "n = 1"))


def test_a_pupil_learns() -> None:
    """After many episodes it passes on the layout that the lesson shows."""
    study = Study.create(layout_seed=5, action_reward_noise_sigma=0.2)
    early, late = (greedy_return(study, pupil(1, study, episodes)) for episodes in (60, 4_000))
    assert early < 0 < 5 < late
