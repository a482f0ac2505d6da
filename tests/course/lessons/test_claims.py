"""What claims measure, on runs that are made up and look like those of agents that have learned."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym.adapters.registration import make_mdp
from edugym.agents.q_learning import QLearning
from edugym.envs.roadrunner import Roadrunner
from edugym.envs.study import Study
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym_course.lessons.continuous_actions import experiments as continuous_actions_experiments
from edugym_course.lessons.continuous_actions import ppo as continuous_actions_ppo
from edugym_course.lessons.depth import experiments as depth_experiments
from edugym_course.lessons.depth import methods as depth_methods
from edugym_course.lessons.dimensionality import experiments as dimensionality_experiments
from edugym_course.lessons.dimensionality import methods as dimensionality_methods
from edugym_course.lessons.dimensionality import sharing as dimensionality_sharing
from edugym_course.lessons.exploration import climbs, fork, stalling
from edugym_course.lessons.exploration import experiments as exploration_experiments
from edugym_course.lessons.exploration import methods as exploration_methods
from edugym_course.lessons.loop import exact as loop_exact
from edugym_course.lessons.loop import experiments as loop_experiments
from edugym_course.lessons.loop import methods as loop_methods
from edugym_course.lessons.model_based import experiments as model_based_experiments
from edugym_course.lessons.model_based import methods as model_based_methods
from edugym_course.lessons.model_based.plans import Plan
from edugym_course.lessons.on_off_policy import experiments as on_off_policy_experiments
from edugym_course.lessons.on_off_policy import methods as on_off_policy_methods
from edugym_course.lessons.stochasticity import experiments as stochasticity_experiments
from edugym_course.lessons.stochasticity import methods as stochasticity_methods
from edugym_course.lessons.stochasticity.methods import Played
from tests.course.lessons.made_up import finals, follower, made_up, measured


def test_loop() -> None:
    """One of four runs, and one of two, ends with 95; random play is compared with the exact model."""
    results = made_up(
        {
            loop_methods.Q_LEARNING: [{10: 95.0}, {10: 94.0}, {10: 78.0}, {10: -500.0}],
            loop_methods.MYOPIC: [{10: 95.0}, {10: 95.0}, {10: 0.0}, {10: -500.0}],
            loop_methods.RANDOM: [{10: loop_exact.random_return()}] * 4,
        }
    )
    assert measured(loop_experiments.player_claims(results)) == [1.0, 95.0, 0.25]
    assert measured(loop_experiments.reward_claims(results))[-1] == 0.5


def road(epsilon: float, **parameters: Any) -> QLearning:
    """Return a runner who has learned what is best with such exploration; it never stands still on its way."""
    task = Roadrunner.create(**parameters)
    best = value_iteration(finite_model(task), epsilon=epsilon)
    agent = QLearning.create(task)
    for (x, speed), values in zip(best.model.states, best.Q, strict=True):
        if speed >= 0:
            agent.Q[x * (task.max_speed + 1) + speed] = values
    return agent


def test_on_off_policy_at_the_edge() -> None:
    """Longer runs count only if they are the safe one; the lead is that of the second half of training."""
    q, sarsa, expected = on_off_policy_methods.KINDS
    ends = {q: (-2.0, -3.0, -2.0, -2.0), sarsa: (-3.0, -2.0, -4.0, -3.0), expected: (-3.0, -3.0, -3.0, -100.0)}
    edge = made_up({method: [{0: -50.0, 5: -60.0, 10: end} for end in returns] for method, returns in ends.items()})
    leads = [-3.0 + 2.25, -27.25 + 2.25]
    assert measured(on_off_policy_experiments.edge_claims(edge)) == [0.75, 0.5, 0.75, *leads]


def test_on_off_policy_elsewhere() -> None:
    """Every share counts the runs with the return that its claim names."""
    q, sarsa, expected = on_off_policy_methods.KINDS
    ends = {q: [-2.0, -2.0, -3.0, -3.0], sarsa: [-3.0, -2.0, -4.0, -5.0], expected: [-2.0, -2.0, -2.0, -3.0]}
    runs, cliff = (
        made_up({method: [{0: 0.0, 5: 0.0, 10: end} for end in found] for method, found in of.items()})
        for of in (ends, {q: [-13.0, -14.0], sarsa: [-15.0, -13.0], expected: [-15.0, -15.0]})
    )
    assert measured(on_off_policy_experiments.condition_claims(runs, runs, runs, runs)) == [
        -1.0, 0.25, 0.25, -1.0, 0.25, -1.0, 0.25, 0.75,
    ]  # fmt: skip
    ice = made_up({q: [{10: 0.0}] * 4}, agents={q: [road(0.1), road(0.1), road(0.1), road(0.0)]})
    assert measured(on_off_policy_experiments.other_cliff_claims(ice, cliff)) == [0.75, 0.5, 0.5, 1.0, -0.5, -1.5]


def test_on_off_policy_in_the_zone() -> None:
    """Where the greedy runs of agents end that have learned the best run with slips and without."""
    q, sarsa, expected = on_off_policy_methods.KINDS
    bold, careful = road(0.0, stop_zone=2), road(0.2, stop_zone=2)
    zone = made_up({method: [{10: 0.0}] for method in (q, sarsa, expected)}, agents={q: [bold], sarsa: [careful]})
    assert measured(on_off_policy_experiments.zone_claims(zone)) == [9.0, -1.0]


def study(seed: int) -> tuple[Study, Any, Any]:
    """Return a layout, an agent that knows the best way through it, and one that never studies."""
    task = Study.create(layout_seed=seed)
    best = np.nan_to_num(value_iteration(finite_model(task)).table())
    knowing = QLearning.create(task)._replace(Q=best)
    idle = knowing._replace(Q=np.where(np.arange(best.shape[1]) == 0, -1.0, np.zeros(best.shape)))
    return task, knowing, idle


def test_depth() -> None:
    """Three layouts: who knows the way gets the optimum and passes; who never studies has not met the exam."""
    layouts = [study(seed) for seed in range(3)]
    knowing, idle = ([agents[which] for agents in layouts] for which in (1, 2))
    optimum = np.array([task.reward_threshold for task, *_ in layouts])
    methods = {
        depth_methods.ONE_STEP: knowing,
        depth_methods.MONTE_CARLO: [knowing[0], idle[1], knowing[2]],
        "n = 5": idle,
    }
    settings: dict[str, Any] = {"environment.n_actions": 5, "environment.total_days": 10, "layout_seed": [0, 1, 2]}
    results = made_up({method: [{10: 0.0}] * 3 for method in methods}, agents=methods, **settings)
    assert depth_methods.expected_returns(results, depth_methods.ONE_STEP) == pytest.approx(optimum)
    for method, passing in (
        (depth_methods.ONE_STEP, [1, 1, 1]),
        (depth_methods.MONTE_CARLO, [1, 0, 1]),
        ("n = 5", [0, 0, 0]),
    ):
        assert (
            depth_methods.passes(results, method).tolist()
            == depth_methods.met_exam(results, method).tolist()
            == passing
        )
    assert depth_methods.shortfall(results, depth_methods.MONTE_CARLO) == pytest.approx(0.0)
    both = depth_experiments.difference_where_both_pass(results, depth_methods.MONTE_CARLO, depth_methods.ONE_STEP)
    assert both.n == 2
    assert both.estimate == pytest.approx(0.0)
    lost = (optimum[1] - depth_methods.expected_returns(results, depth_methods.MONTE_CARLO)[1]) / 3
    assert depth_experiments.final_difference(
        results, depth_methods.MONTE_CARLO, depth_methods.ONE_STEP
    ).estimate == pytest.approx(-lost)
    assert depth_experiments.difference_where_both_pass(results, "n = 5", depth_methods.ONE_STEP).n == 0


def test_depth_of_those_who_met_the_exam() -> None:
    """The share that passes in the end less the share that ever did, and what ten actions cost beside five."""
    _, knowing, idle = study(0)
    Q = np.where(knowing.Q > depth_methods.MET, 0.51, knowing.Q)
    forgot = idle._replace(Q=np.where(np.arange(Q.shape[1]) == 0, np.where(Q == 0.51, 0.51, -1.0), 0.6))
    settings: dict[str, Any] = {"environment.n_actions": 5, "environment.total_days": 10, "layout_seed": [0, 0, 0, 0]}
    methods = {
        depth_methods.ONE_STEP: [knowing] * 4,
        depth_methods.MONTE_CARLO: [knowing, forgot, idle, idle],
        "n = 5": [knowing, knowing, knowing, idle],
    }
    results = made_up({method: [{10: 0.0}] * 4 for method in methods}, agents=methods, **settings)
    assert measured(depth_experiments.meeting_claims(results, results)) == [-0.5, -0.25, 0.5, -0.25, -0.75]


def test_stochasticity() -> None:
    """Four runs of each player; 1 ball in 500 is no more hardly a ball, and 0.02 no more within 0.02."""

    def player(lost: list[float], spread: list[float], mean: float, hits: int) -> Played:
        games = np.zeros((4, 11))
        games[:, hits] = 1.0
        return Played(np.full(4, mean), np.array(spread), np.array(lost), games)

    players = {
        stochasticity_methods.AVERSE: player([0.0, 0.001, 0.0019, 0.01], [0.1] * 4, 0.7, 3),
        stochasticity_methods.NEUTRAL: player([0.0, 0.0021, 0.01, 0.02], [0.119, 0.0, 0.3, 0.081], 0.8, 2),
        stochasticity_methods.SEEKING: player([0.04] * 4, [0.5] * 4, 0.75, 1),
    }
    lost = [(0.0321 - 0.0129) / 4, 0.04 - 0.0321 / 4]
    spread = [0.1 - 0.125, 0.5 - 0.125]
    claims = stochasticity_experiments.risk_claims(players)
    assert measured(claims) == pytest.approx([0.75, *lost, *spread, -0.1, 1.0, -0.05, -1.0], abs=1e-6)
    assert claims[1].reason == "25% of the neutral runs hardly lose any either"
    assert measured(stochasticity_experiments.noisy_claims(players)) == [0.25, 0.5, -0.05]
    assert measured(stochasticity_experiments.hidden_claims(players)) == pytest.approx([-0.05, lost[1]], abs=1e-6)


def test_model_based() -> None:
    """Shares of runs with 95 after 2000 steps and at the end, and of those that lose less than 50."""
    early = model_based_methods.EARLY
    names = (
        model_based_methods.Q_LEARNING,
        model_based_methods.DYNA_10,
        model_based_methods.DYNA_50,
        model_based_methods.SWEEPING,
        model_based_methods.R_MAX,
    )
    shares = {method: k / 4 for k, method in enumerate(names)}
    learned = made_up(
        {
            method: [{early: 95.0 if i < 4 * share else 94.0, 10_000: 0.0} for i in range(4)]
            for method, share in shares.items()
        },
        10_000,
    )
    random, decaying = model_based_methods.REMEDIES
    remedied = finals({model_based_methods.DYNA_10: [10.0, 10.0], random: [15.0, 15.0], decaying: [20.0, 40.0]})
    assert measured(model_based_experiments.remedy_claims(learned, remedied)) == [20.0, 5.0, 1.0, 0.0, 0.25, 0.5, 0.75]
    right = finals({model_based_methods.SWEEPING: [95.0, 94.0], model_based_methods.DYNA_10: [95.0, 95.0]})
    assert measured(model_based_experiments.given_claims(right, right)) == [0.5, 1.0]


def test_model_based_by_what_was_seen() -> None:
    """Who has tried everything can plan for 95, who has tried nothing never ends; one Dyna-10 of four tried all."""
    everything, nothing = SimpleNamespace(known=np.ones((800, 4))), SimpleNamespace(known=np.zeros((800, 4)))
    tried = {
        method: [everything] * k + [nothing] * (4 - k)
        for method, k in (
            (model_based_methods.Q_LEARNING, 4),
            (model_based_methods.DYNA_10, 1),
            (model_based_methods.DYNA_50, 2),
            (model_based_methods.SWEEPING, 0),
        )
    }
    learned = made_up({method: [{10: 2.0**k}] * 4 for k, method in enumerate(tried)}, agents=tried)
    remedied = finals({[*model_based_methods.REMEDIES][1]: [50.0] * 5})
    assert measured(model_based_experiments.end_claims(learned, remedied)) == [
        1.0, 3.0, 7.0, -595.0 * 3 / 4, -595.0 / 2, -595.0, -46.0, -42.0,
    ]  # fmt: skip


def test_model_based_with_a_wrong_model() -> None:
    """A loss of 50 is not less than 50; of plans the share is that of those that never end."""
    names = (model_based_methods.SWEEPING, model_based_methods.DYNA_10, model_based_methods.SLOW_DYNA)
    right = finals(dict(zip(names, ([95.0] * 2, [90.0] * 2, [95.0] * 2), strict=True)))
    wrong = finals(dict(zip(names, ([-500.0] * 2, [-400.0] * 2, [46.0, 45.0]), strict=True)))
    assert measured(model_based_experiments.noise_claims(right, wrong)) == [-595.0, -490.0, 0.5]
    ends, bumps, walks = Plan(95.0, False), Plan(-500.0, True), Plan(-500.0, False)
    plans = {noise: [ends] * 4 for noise in model_based_methods.NOISES} | {
        0.5: [ends, ends, ends, walks],
        1.0: [ends, ends, bumps, walks],
        1.5: [bumps, bumps, walks, ends, ends],
    }
    assert measured(model_based_experiments.plan_claims(plans)) == pytest.approx([0.25, 0.5, 0.6, 2 / 3], abs=1e-6)
    assert [Plan(total, False).ends for total in (-299.0, -300.0)] == [True, False]


def test_continuous_actions() -> None:
    """Steps to a return of 3.5, and the late returns: the mean of the last five points."""
    three, five, nine = ({0: 0.0, step: 3.5, 60: 4.0, 70: 4.0, 80: 4.0, 90: 4.0, 100: 4.0} for step in (10, 20, 50))
    curves = {"3 bins": [three, three], "5 bins": [five, five], "9 bins": [nine, nine]}
    fast: dict[int, float] = {0: 0.0, 10: 3.49, 30: 3.6, 60: 4.3, 70: 4.3, 80: 4.3, 90: 4.3, 100: 4.3}
    curves[continuous_actions_ppo.CONTINUOUS] = [
        fast,
        {step: value + 0.02 * (step > 50) for step, value in fast.items()},
    ]
    narrow = {
        method: [{step: value - shift for step, value in run.items()} for run in runs]
        for (method, runs), shift in zip(curves.items(), (4.0, 1.0, 0.0, 2.0), strict=True)
    }
    claims = continuous_actions_experiments.learning_claims(made_up(curves, 100), made_up(narrow, 100))
    assert measured(claims) == [0.0, 0.5, -10.0, -30.0, -20.0, 0.0, -1.0, -2.0]


def test_dimensionality_on_columns_of_training_and_others() -> None:
    """Of each column k two runs return k² and 3 more: 20/3 on columns 0, 2 and 4, and 5 on 1 and 3; then the mean."""
    labels = (*dimensionality_methods.GENERAL, dimensionality_sharing.SMALL, dimensionality_sharing.COLUMN)
    squares = np.arange(5.0)[:, None] ** 2 + [[0.0, 3.0]]
    tests = {label: squares + 100.0 * k for k, label in enumerate(labels)}
    at = {label: 100.0 * k + 1.5 for k, label in enumerate(labels)}
    table, linear, offset = (
        at[label]
        for label in (dimensionality_methods.TABLE, dimensionality_methods.LINEAR, dimensionality_methods.OFFSET)
    )
    assert measured(dimensionality_experiments.general_claims(tests)) == pytest.approx(
        [table + 20 / 3, table + 5.0, linear + 20 / 3, offset + 5.0]
    )
    networks = (dimensionality_methods.NETWORK, dimensionality_sharing.SMALL, dimensionality_sharing.COLUMN)
    assert measured(dimensionality_experiments.sharing_claims(tests)) == [at[label] + 5.0 for label in networks]


def test_exploration() -> None:
    """Visits by hand on a wall of 100: a frontier at 2, and half of the later climbs get back to it."""
    visits = np.zeros((4, 101), np.int64)
    visits[:, :3] = [[4, 1, 0], [4, 2, 1], [6, 4, 3], [2, 1, 1]]
    assert climbs.return_to_frontier(visits) == pytest.approx(0.5 / 0.95**2)
    assert fork.higher_frontier(visits) == 2
    visits[3, 100] = 1
    seen = [follower({}, visits=visits), follower({}, visits=visits[:, :100])]
    two = made_up(
        {
            exploration_methods.OPTIMISM: [{0: 0.0, 10: 1.0}, {0: 0.0, 10: 0.0}],
            exploration_methods.GO_EXPLORE: [{0: 1.0, 10: 1.0}, {0: 1.0, 10: 1.0}],
        },
        agents={
            exploration_methods.OPTIMISM: [follower({}, visits=np.roll(visits, -1, axis=0)), seen[0]],
            exploration_methods.GO_EXPLORE: [seen[0]] * 2,
        },
    )
    three = made_up(
        {exploration_methods.OPTIMISM: [{10: 0.0}] * 4, exploration_methods.GO_EXPLORE: [{10: 1.0}] * 4},
        agents={exploration_methods.OPTIMISM: [seen[0], *[follower({}, visits=visits * (np.arange(101) < 100))] * 3]},
    )
    patient = finals({exploration_methods.OPTIMISM: [1.0, 1.0, 0.0, 1.0]})
    quarter = exploration_methods.N_STEPS / 4
    assert measured(exploration_experiments.optimism_claims({2: two, 3: three}, patient)) == [
        0.5, -quarter / 2, -0.75, 0.25, 0.0, 1.0, 0.75,
    ]  # fmt: skip


def test_who_leads_to_the_frontier() -> None:
    """Who takes the right grips of its own wall up to its frontier, whatever it does beyond."""
    walls = [make_mdp("Boulder", height=5, layout_seed=seed).grips.tolist() for seed in (3, 4)]
    assert walls[0][:3] != walls[1][:3]
    visits = np.array([[3, 2, 0, 0, 0, 0], [3, 1, 1, 1, 0, 0]])
    right = [follower(dict(enumerate([*wall[:3], 1 - wall[3]])), visits=visits) for wall in walls]
    method = exploration_methods.NOVELTY
    results = made_up({method: [{10: 0.0}] * 2}, agents={method: right}, layout_seed=[3, 4])
    assert climbs.greedy_leads_to_frontier(results, method, 5) == [True, True]
    exchanged = made_up({method: [{10: 0.0}] * 2}, agents={method: right[::-1]}, layout_seed=[3, 4])
    assert climbs.greedy_leads_to_frontier(exchanged, method, 5) == [False, False]


def test_climbs_of_who_knows_the_wall() -> None:
    """On a wall of three 0.95³ of the climbs get up; a wrong grip is a new climb."""
    share = climbs.watch_climbs(3, n_steps=20_000, repetitions=2, jobs=1)
    assert share.estimate == pytest.approx(0.95**3, abs=0.012)


def test_two_branches() -> None:
    """Three turns and one, half of the runs come back to both frontiers, and the frontiers are 2 and 1, below 3."""
    runs = [
        follower({}, visits=np.array(visits))
        for visits in (
            [[1, 3, 0, 1, 0], [1, 1, 0, 2, 1], [1, 4, 1, 1, 0], [1, 2, 0, 3, 1]],
            [[1, 3, 0, 1, 0], [1, 3, 0, 1, 0], [1, 3, 0, 0, 0], [1, 0, 0, 0, 0]],
        )
    ]
    wall = follower({}, visits=np.array([[2, 1, 1, 0], [1, 1, 1, 1]]))
    method = exploration_methods.NOVELTY
    results, one_wall = (made_up({method: [{10: 0.0}] * 2}, agents={method: agents}) for agents in (runs, [wall, wall]))
    assert measured(fork.fork_claims(results, one_wall)) == [2.0, 0.5, -1.5]


def test_grips_at_the_frontier() -> None:
    """On first visits 3 of 4 and 1 of 2 are right, later 1 of 4; of a frontier with few visits nothing is drawn."""
    visits, right = np.zeros((2, 2, 10), np.int64)
    visits[0, :3], right[0, :2], visits[1, 0], right[1, 0] = [4, 3, 1], [3, 1], 2, 1
    method = exploration_methods.NOVELTY
    runs = [follower({}, visits=one, right=other) for one, other in zip(visits, right, strict=True)]
    watched = made_up({method: [{10: 0.0}] * 2}, agents={method: runs})
    assert stalling.right_grips(watched, method, 1, 1) == [0.75, 0.5]
    assert stalling.right_grips(watched, method, 2) == [0.25]
    assert measured(stalling.stalling_claims(watched)) == [0.625, 0.25]
    visits[:, 1] = 15
    [line] = stalling.frontier_lines(watched).lines.values()
    assert line[1] == 1 / 30
    assert math.isnan(line[0])
