"""The depth of credit assignment on Study: targets, what is handed back, and what the claims measure."""

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from edugym import NStepSARSA, QLearning, finite_model, policy_evaluation, value_iteration
from edugym.envs.study import Study
from edugym.rendering.scene import Text
from edugym_course.lessons.depth import (
    credit,
    cutting,
    experiments,
    figures,
    methods,
    off_policy,
    pictures,
    project,
    rates,
    slips,
    targets,
    traces,
)
from tests.course.lessons.made_up import made_up, measured


def test_returns_of_layouts() -> None:
    """Three runs have three layouts, whose best returns are those of planning."""
    tasks = methods.layouts(methods.compare(n_steps=200, repetitions=3, seed=1))
    assert len({task.lectures.tobytes() + task.action_rewards.tobytes() for task in tasks.values()}) == 3
    models = [finite_model(task) for task in tasks.values()]
    exact = [np.mean([value_iteration(model, epsilon=epsilon).start for model in models]) for epsilon in (0.0, 0.1)]
    assert methods.best_returns(tasks, 0.0, 0.1) == pytest.approx(exact)
    assert exact[1] < exact[0]


def test_hand_back_over_equal_episodes() -> None:
    """The reward is d steps back after k episodes as often as k tosses of a coin with α show ceil((d+1)/n) heads."""
    values = credit.handed_back(3, 0.1, 40)
    for d in range(targets.DAYS):
        heads = [math.comb(40, i) * 0.1**i * 0.9 ** (40 - i) for i in range(math.ceil((d + 1) / 3), 41)]
        assert values[-1, targets.DAYS - 1 - d] == pytest.approx(10 * sum(heads))
    assert [figures.episodes_until(credit.handed_back(n)) for n in (1, 3, 5, math.inf)] == [97, 37, 17, 7]
    assert figures.episodes_until(credit.handed_back(1, episodes=5)) == math.inf


def test_bias_and_variance_of_targets() -> None:
    """At the fixed point no n has a bias, and the variance, whose parts add up, grows with n."""
    low, high = figures.split(0.2), figures.split(1.0)
    noise, exploration = low
    np.testing.assert_allclose(low[exploration], high[exploration])
    np.testing.assert_allclose(high[noise], np.arange(1, targets.DAYS + 1))
    assert low[noise][-1] / (low[noise][-1] + low[exploration][-1]) == pytest.approx(targets.noise_share(0.2))
    np.testing.assert_allclose(figures.bias_series().lines["values learned"], 0.0, atol=1e-9)
    model = finite_model(Study.create())
    policy = targets.soft_policy(model, 0.1)
    Q = targets.true_values(model, policy)
    several = [targets.target(model, policy, Q, n, 0.2) for n in range(1, targets.DAYS + 1)]
    assert [one.mean for one in several] == pytest.approx([policy_evaluation(model, policy).start] * targets.DAYS)
    variances = [one.noise + one.exploration for one in several]
    assert variances == sorted(variances)


def test_uncorrected_targets() -> None:
    """One step of Q-learning has no bias; ten steps have that of an ε-greedy policy after a greedy first action."""
    model = finite_model(Study.create())
    bias, deviation = off_policy.uncorrected(model)
    assert bias[0] == pytest.approx(0.0)
    assert deviation[0] == pytest.approx(0.0)
    none, zero = off_policy.uncorrected(model, epsilon=0.0)
    np.testing.assert_allclose(none, 0.0, atol=1e-9)
    np.testing.assert_allclose(zero, 0.0, atol=1e-4)
    assert off_policy.weighted_deviation(9.0, 1) == 0.0
    assert off_policy.weighted_deviation(2.0, 2, 0.4, 4) == pytest.approx(2 * math.sqrt(1 / 0.7 - 1))


def test_weights_of_all_depths() -> None:
    """They average the n-step targets as the recursion of the λ-return does, G = R + (1 - λ) V(S') + λ G'."""
    rewards, values = [1.0, -2.0, 4.0], [3.0, 5.0, 0.0]  # V(S') after each day; nothing comes after the last
    by_depth = [1.0 + 3.0, 1.0 - 2.0 + 5.0, 1.0 - 2.0 + 4.0]
    average = 0.0
    for reward, value in zip(reversed(rewards), reversed(values), strict=True):
        average = reward + (1 - 0.8) * value + 0.8 * average
    assert traces.weights(0.8, 3) @ by_depth == pytest.approx(average)
    assert [traces.weights(decay, 3).tolist() for decay in (0.0, 1.0)] == [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]


def test_all_depths_at_once() -> None:
    """Without traces SARSA(λ) is one-step SARSA, run for run; the claims compare what it learns with every n."""
    by_rate = traces.through_rates((0.1, 0.3), n_steps=200, repetitions=3, seed=1)
    assert traces.over_rates(by_rate, "λ = 0").tolist() == traces.over_rates(by_rate, "n = 1").tolist()
    expected = [
        traces.over_rates(by_rate, "λ = 0.8") - traces.over_rates(by_rate, methods.label(n)) for n in methods.BY_DEPTH
    ]
    claims = traces.trace_claims({0.2: by_rate, 1.0: by_rate})
    assert [claim.measured.estimate for claim in claims[2:6]] == pytest.approx([gap.mean() for gap in expected])
    assert claims[-1].measured == claims[5].measured


def test_pupils() -> None:
    """Who never had time has not met the exam; after many episodes a pupil passes."""
    too_short = methods.compare(depths=(1,), n_steps=10, repetitions=2, count_passes=True)
    assert not methods.met_exam(too_short, "n = 1").any()
    assert math.isnan(methods.shortfall(too_short, "n = 1"))
    study = Study.create(layout_seed=5, action_reward_noise_sigma=0.2)
    early, late = (methods.greedy_return(study, methods.pupil(1, study, episodes)) for episodes in (60, 4_000))
    assert early < 0 < 5 < late


def study(seed: int) -> tuple[Study, Any, Any]:
    """Return a layout, an agent that knows the best way through it, and one that never studies and never passed."""
    task = Study.create(layout_seed=seed)
    best = np.nan_to_num(value_iteration(finite_model(task)).table())
    knowing = QLearning.create(task)._replace(Q=best)
    idle = knowing._replace(Q=np.where(np.arange(best.shape[1]) == 0, -1.0, np.zeros(best.shape)))
    return task, methods.Examinee(knowing, np.array([3])), methods.Examinee(idle, np.array([0]))


def test_depth() -> None:
    """Three layouts: who knows the way gets the optimum and passes; who never studies has not met the exam."""
    layouts = [study(seed) for seed in range(3)]
    knowing, idle = ([agents[which] for agents in layouts] for which in (1, 2))
    optimum = np.array([task.reward_threshold for task, *_ in layouts])
    makers = {methods.ONE_STEP: knowing, methods.MONTE_CARLO: [knowing[0], idle[1], knowing[2]], "n = 5": idle}
    settings: dict[str, Any] = {"environment.n_actions": 5, "environment.total_days": 10, "layout_seed": [0, 1, 2]}
    results = made_up({method: [{10: 0.0}] * 3 for method in makers}, agents=makers, **settings)
    assert methods.expected_returns(results, methods.ONE_STEP) == pytest.approx(optimum)
    for method, passing in zip(makers, ([1, 1, 1], [1, 0, 1], [0, 0, 0]), strict=True):
        assert methods.passes(results, method).tolist() == methods.met_exam(results, method).tolist() == passing
    assert methods.shortfall(results, methods.MONTE_CARLO) == pytest.approx(0.0)
    both = experiments.difference_where_both_pass(results, methods.MONTE_CARLO, methods.ONE_STEP)
    assert both.n == 2
    assert both.estimate == pytest.approx(0.0)
    lost = (optimum[1] - methods.expected_returns(results, methods.MONTE_CARLO)[1]) / 3
    assert experiments.final_difference(results, methods.MONTE_CARLO, methods.ONE_STEP).estimate == pytest.approx(-lost)
    assert experiments.difference_where_both_pass(results, "n = 5", methods.ONE_STEP).n == 0


def test_depth_of_those_who_met_the_exam() -> None:
    """The share that passes in the end less the share that ever did, and what ten actions cost beside five."""
    _, knowing, idle = study(0)
    forgot = idle._replace(passes=np.array([1]))
    settings: dict[str, Any] = {"environment.n_actions": 5, "environment.total_days": 10, "layout_seed": [0, 0, 0, 0]}
    makers = {
        methods.ONE_STEP: [knowing] * 4,
        methods.MONTE_CARLO: [knowing, forgot, idle, idle],
        "n = 5": [knowing, knowing, knowing, idle],
    }
    results = made_up({method: [{10: 0.0}] * 4 for method in makers}, agents=makers, **settings)
    assert measured(experiments.meeting_claims(results)) == [-0.5, -0.25, 0.5, -0.25]
    assert methods.passes_in_training(results, methods.MONTE_CARLO).tolist() == [3, 1, 0, 0]
    claims = experiments.start_claims(dict.fromkeys(experiments.START_VALUES, results))
    assert measured(claims) == [0.0] * 6 + [1.0] * 3 + [0.5] * 3 + [1.0] * 2


def test_what_the_learning_rate_does() -> None:
    """Of three runs of Monte Carlo two meet the exam with the small rate and pass, and with the large one none does."""
    _, knowing, idle = study(0)
    settings: dict[str, Any] = {"environment.n_actions": 5, "environment.total_days": 10, "layout_seed": [0, 0, 0]}

    def runs(value: float, *agents: Any) -> Any:
        makers = {methods.ONE_STEP: [idle] * 3, methods.MONTE_CARLO: list(agents)}
        returns = {methods.ONE_STEP: 1.0, methods.MONTE_CARLO: value}
        return made_up(
            {name: [{0: returns[name], 10: returns[name]}] * 3 for name in makers}, agents=makers, **settings
        )

    slow, quick = runs(4.0, knowing, knowing, idle), runs(1.0, idle, idle, idle)
    by_rate = {rates.SLOW: slow, rates.QUICK: quick, 1.0: quick}
    claims = rates.rate_claims(by_rate, {rates.SLOW: quick, rates.QUICK: slow})
    assert measured(claims[:5]) == [0.0, -3.0, 3.0, 0.666667, 1.0]
    assert claims[5].measured.n == 0
    assert measured(claims[6:]) == [3.0, 0.0]


@pytest.mark.parametrize(
    ("when_taken", "expected"),
    [(False, 4.5), (True, 2.5)],  # the second action looks best after its update, but was not when it was taken
)
def test_where_targets_are_cut(when_taken: bool, expected: float) -> None:
    """Two steps with rewards 1 and 8, α = 1/2: the last value rises from 0 to 4, above 2, which was the largest."""
    agent = cutting.Cutting.create((3, 2), when_taken=when_taken, learning_rate=0.5)
    agent.Q[1] = [2.0, 0.0]
    agent.learn(0, 0, 1.0, 1, terminated=False)
    agent.learn(1, 1, 8.0, 2, terminated=True)
    assert agent.Q[1].tolist() == [2.0, 4.0]
    assert agent.Q[0, 0] == expected
    assert agent.length[0] == 0


def test_values_above_returns() -> None:
    """Of every run and each rule; what agents have not learned yet is 0, less what their policies get."""
    above = cutting.value_above_return(0.2, n_steps=500, repetitions=2)
    assert {label: len(values) for label, values in above.items()} == {cutting.AFTER: 2, cutting.WHEN_TAKEN: 2}
    claims = experiments.cutting_claims(dict.fromkeys(experiments.CUTTING, above))
    assert len(claims) == 7


def test_the_best_rate_of_each_depth() -> None:
    """By the return averaged over training, not by that of the end."""
    names = [methods.label(n) for n in methods.BY_DEPTH]
    low = made_up({name: [{0: 0.0, 5: 2.0 * k, 10: 0.0}] for k, name in enumerate(names)})
    high = made_up({name: [{0: 0.0, 5: 3.0, 10: 9.0 - 4.0 * k}] for k, name in enumerate(names)})
    assert figures.best_rates({0.1: low, 0.3: high}) == dict(zip(methods.BY_DEPTH, (0.3, 0.3, 0.1, 0.1), strict=True))


@pytest.mark.parametrize(("n", "t"), [(1, 3), (3, 5), (4, 4)])
def test_the_picture_of_the_buffer(n: int, t: int) -> None:
    """What it shows in each place is what n-step SARSA has stored."""
    agent = NStepSARSA.create((20, 2), n=n)
    for step in range(t + 1):
        agent.learn(step, 0, float(step + 1), step + 1, 0, terminated=False, truncated=False)
    shown = [shape.content for shape in pictures.buffer(n, t).shapes if isinstance(shape, Text)]
    below = shown[shown.index(f"states, place k % {n + 1}") + 1 :]
    assert below[: n + 1] == [f"S{int(state)}" for state in agent.steps.states]
    assert below[n + 2 : 2 * n + 2] == [f"A{int(reward) - 1}, R{int(reward)}" for reward in agent.steps.rewards]


def test_n_step_sarsa_from_its_definition() -> None:
    """Without a mistake it learns what the agent learns, in short and long episodes, of which some are cut off."""
    both, rng = (slips.slips((5, 2), cut="value"), project.agent((5, 2))), np.random.default_rng(0)
    for length in (1, 2, 3, 4, 9):
        pairs = rng.integers((5, 2), size=(length + 1, 2)).tolist()
        for k, ((s, a), (then, chosen)) in enumerate(pairwise(pairs), start=1):
            if over := k == length:
                chosen = int(both[0].Q[then].argmax())
            for agent in both:
                agent.learn(s, a, float(k), then, chosen, over and length % 2 == 0, over and length % 2 == 1)
        np.testing.assert_allclose(both[0].Q, both[1].Q)


@pytest.mark.parametrize(
    ("mistake", "target"),
    [
        ({}, 1 + 2 * 0.8 + 3 * 0.64 + 0.512 * 8),
        ({"largest": True}, 1 + 2 * 0.8 + 3 * 0.64 + 0.512 * 9),
        ({"bootstrap": 0.0}, 1 + 2 * 0.8 + 3 * 0.64),
        ({"bootstrap": 1.0}, 1 + 2 * 0.8 + 3 * 0.64 + 8),
        ({"early": True}, 1 + 2 * 0.8 + 3 * 0.64 + 0.512 * 5),
        ({"total": sum}, 1 + 2 + 3 + 0.512 * 8),
    ],
)
def test_mistakes_in_the_first_target(mistake: dict[str, Any], target: float) -> None:
    """Of three steps from state 0 to 3, with action 1 in each; α = 0.5."""
    agent = slips.slips((4, 2), **mistake)
    agent.Q[1:] = [2, 3], [4, 5], [9, 8]
    for state in range(3):
        agent.learn(state, 1, state + 1.0, state + 1, 1, False, False)
    assert agent.Q[0, 1] == pytest.approx(target / 2)
