"""Model-based learning in Supermarket: plans, maps, clocks, and what the claims measure."""

import math
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
import pandas as pd
import pytest
from matplotlib.text import Annotation

from edugym import DynaQ, PrioritisedSweeping, train, value_iteration
from edugym.agents.tabular_model import TabularModel
from edugym.envs.supermarket import Supermarket
from edugym_course.lessons.model_based import experiments, figures, maps, methods, plans, shops
from tests.course.lessons.made_up import finals, made_up, measured


def test_plans() -> None:
    """A plan with the right model is the best way; with large errors some plan never ends, most of them at a wall."""
    best = plans.follow_plan(0.0, 3)
    assert best.ends
    assert best.total == methods.OPTIMUM == value_iteration(methods.exact_model()).start
    wrong = [plans.follow_plan(1.5, seed) for seed in range(12)]
    assert all(plan.total <= methods.OPTIMUM for plan in wrong)
    assert not any(plan.ends for plan in wrong if plan.bumps)
    assert len(best.path) == 31
    assert (best.path[0], best.path[-1]) == (8, 80 * 9 + 8 * 8 + 7)
    lost = next(plan for plan in wrong if plan.bumps)
    assert lost.path[-1] == lost.path[-2]


def test_planning_with_the_right_model() -> None:
    """No look ahead is needed with the optimal values; 30 sweeps are enough; a given model needs no experience."""
    values = value_iteration(methods.exact_model(), 0.99).table()
    assert plans.look_ahead(np.nan_to_num(values), 0) == methods.OPTIMUM
    assert plans.look_ahead(None, 7) == -500.0
    assert plans.look_ahead(None, 12) == methods.OPTIMUM
    makers = {
        kind: partial(methods.make, PrioritisedSweeping, given=kind == "given", planning_steps=np.inf)
        for kind in ("given", "learned")
    }
    results = methods.compare(makers, n_steps=1, repetitions=2)
    assert results.final("given").tolist() == [methods.OPTIMUM, methods.OPTIMUM]
    assert (results.final("learned") < methods.OPTIMUM).all()


def test_maps() -> None:
    """The walk leaves with an empty bag; cells with a value above 0 have an arrow, but not the entrance."""
    walk = maps.random_walk()
    assert len(walk) == 518
    assert all(step[3] % 8 == 0 for step in walk)
    assert [step[4] for step in walk] == [False] * 517 + [True]
    assert maps.who_knows_the_way(0) == ()
    assert maps.who_knows_the_way(200) == ("prioritised sweeping",)
    assert np.nanmax(maps.after_walk(DynaQ, 0)) == 49.0
    assert np.isnan(maps.FloorMap(maps.after_walk(DynaQ, 0)).values()[7, 2])  # the blue item was never seen
    Q = np.full((800, 4), np.nan)
    Q[[8 * 5, 80 * 3 + 8 * 4, 80 * 6 + 8 * 2]] = 1.0  # in the row of the entrance, and in two others
    Q[80 * 7] = -1.0
    axes = maps.FloorMap(Q, arrows=True).draw()
    arrows = [text for text in axes.texts if isinstance(text, Annotation)]
    assert [(round(arrow.xy[0]), round(arrow.xy[1])) for arrow in arrows] == [(4, 3), (2, 6)]


def test_clocks() -> None:
    """A step takes as long as the world or its targets, whichever is longer; each run has a clock of its own."""
    makers = {label: methods.LEARNED[label] for label in (methods.Q_LEARNING, methods.DYNA_10, methods.SWEEPING)}
    results = methods.compare(makers, n_steps=2_000, repetitions=4)
    targets = methods.targets_computed(results)
    clock = figures.Clock(results, targets, step_ms=0.05, target_us=10.0)
    assert clock.seconds(methods.Q_LEARNING)[-1] == pytest.approx([2_000 * 5e-5] * 4)
    assert clock.seconds(methods.DYNA_10)[[0, 1]] == pytest.approx(np.array([[0.0] * 4, [50 * 1.1e-4] * 4]))
    assert clock.seconds(methods.SWEEPING)[-1] == pytest.approx(
        np.maximum(targets[methods.SWEEPING] * 1e-5, 5e-5).sum(axis=1)
    )
    assert figures.steps_to(results, methods.DYNA_10, 1_000.0) == clock.seconds_to(methods.DYNA_10, 1_000.0) == math.inf
    assert figures.steps_to(results, methods.DYNA_10, -600.0) == clock.seconds_to(methods.DYNA_10, -600.0) == 0.0

    # Of two runs the fast one learns from second 10 to 20, the slow one nothing: from second 20 on the mean is 50.
    curves = pd.DataFrame({0: [0.0, 0.0, 100.0], 1: [0.0, 0.0, 0.0]}, index=[0, 10, 20])
    two: Any = SimpleNamespace(curves=lambda method: curves)
    counts = {methods.SWEEPING: np.array([[1] * 20, [10] * 20])}
    moments, returns = figures.Clock(two, counts, step_ms=0.0, target_us=1e6).mean(methods.SWEEPING)
    assert moments[[0, -1]] == pytest.approx([10.0, 200.0])
    assert np.interp([15.0, 20.0, 100.0, 200.0], moments, returns) == pytest.approx([25.0, 50.0, 50.0, 50.0], abs=1.0)


def test_the_targets_of_prioritised_sweeping() -> None:
    """What counts them learns the same; priorities count, and with an empty queue one target a step is left."""
    how: dict[str, Any] = {"n_steps": 2_000, "repetitions": 3}
    results = methods.compare({methods.SWEEPING: methods.LEARNED[methods.SWEEPING]}, **how)
    counting = methods.compare({methods.SWEEPING: partial(methods.CountingSweeping.create, n_steps=2_000)}, **how)
    assert counting.curves(methods.SWEEPING).equals(results.curves(methods.SWEEPING))
    targets = methods.targets_computed(results)[methods.SWEEPING]
    assert (targets.shape, targets.min()) == ((3, 2_000), 1)


@pytest.mark.filterwarnings("ignore:.*cannot be compiled")
def test_the_count_is_that_of_the_code(monkeypatch: pytest.MonkeyPatch) -> None:
    """Interpreted, as many targets are computed as are counted."""
    computed = []
    expected_target = TabularModel.expected_target

    def counted(self: TabularModel, *rest: Any) -> float:
        computed.append(rest)
        return expected_target(self, *rest)

    monkeypatch.setattr(TabularModel, "expected_target", counted)
    shop = Supermarket.create()
    run = train(shop, methods.CountingSweeping.create(shop, 600), 600)
    assert run.agent.targets[0, :-1].sum() == len(computed) > 2_000


@pytest.mark.parametrize(("runs", "others", "mean"), [(3, 4, 4.0), (4, 3, 4.0), (4, 4, 7.0)])
def test_a_difference_is_paired_by_the_runs_of_both(runs: int, others: int, mean: float) -> None:
    """Of 1, 4, 9 and 20 less 0, 0, 2 and 4; the first result comes first."""
    one, other = finals({"a": [1.0, 4.0, 9.0, 20.0][:runs]}), finals({"b": [0.0, 0.0, 2.0, 4.0][:others]})
    found = experiments.difference(one, "a", other, "b")
    assert (found.estimate, found.n) == (mean, min(runs, others))


def test_claims() -> None:
    """Shares of runs with 95, of those that lose less than 50, of plans that never end, and what could be planned."""
    early = methods.EARLY
    names = methods.Q_LEARNING, methods.DYNA_10, methods.DYNA_50, methods.SWEEPING, methods.R_MAX
    shares = {method: k / 4 for k, method in enumerate(names)}
    learned = made_up(
        {
            method: [{early: 95.0 if i < 4 * share else 94.0, 10_000: 0.0} for i in range(4)]
            for method, share in shares.items()
        },
        10_000,
    )
    random, decaying = methods.REMEDIES
    remedied = finals({methods.DYNA_10: [10.0, 10.0], random: [15.0, 15.0], decaying: [20.0, 40.0]})
    assert measured(experiments.remedy_claims(learned, remedied)) == [20.0, 5.0, 1.0, 0.0, 0.25, 0.5, 0.75]
    given = finals({methods.SWEEPING: [95.0, 94.0], methods.DYNA_10: [95.0, 95.0]})
    assert measured(experiments.given_claims(given, given)) == [0.5, 1.0]

    # A loss of 50 is not less than 50.
    noisy = (methods.SWEEPING, methods.DYNA_10, methods.SLOW_DYNA)
    right = finals(dict(zip(noisy, ([95.0] * 2, [90.0] * 2, [95.0] * 2), strict=True)))
    wrong = finals(dict(zip(noisy, ([-500.0] * 2, [-400.0] * 2, [46.0, 45.0]), strict=True)))
    much = finals({experiments.MUCH_PLANNING: [-400.0, 45.0]})
    assert measured(experiments.noise_claims(right, wrong, much)) == [-595.0, -490.0, 0.5, -223.0]
    ends, bumps, walks = plans.Plan(95.0, False), plans.Plan(-500.0, True), plans.Plan(-500.0, False)
    planned = {noise: [ends] * 4 for noise in methods.NOISES} | {
        0.5: [ends, ends, ends, walks],
        1.0: [ends, ends, bumps, walks],
        1.5: [bumps, bumps, walks, ends, ends],
    }
    assert measured(experiments.plan_claims(planned)) == pytest.approx([0.25, 0.5, 0.6, 2 / 3], abs=1e-6)
    assert [plans.Plan(total, False).ends for total in (-299.0, -300.0)] == [True, False]

    # Who has tried everything can plan for 95, who has tried nothing never ends; one Dyna-10 of four tried all.
    everything, nothing = SimpleNamespace(known=np.ones((800, 4))), SimpleNamespace(known=np.zeros((800, 4)))
    many = {methods.Q_LEARNING: 4, methods.DYNA_10: 1, methods.DYNA_50: 2, methods.SWEEPING: 0}
    tried = {method: [everything] * k + [nothing] * (4 - k) for method, k in many.items()}
    planners = made_up({method: [{10: 2.0**k}] * 4 for k, method in enumerate(tried)}, agents=tried)
    assert measured(experiments.end_claims(planners, finals({decaying: [50.0] * 5}))) == [
        1.0, 3.0, 7.0, -595.0 * 3 / 4, -595.0 / 2, -595.0, -46.0, -42.0,
    ]  # fmt: skip


def test_other_shops() -> None:
    """A shop has the usual walls, and three items elsewhere; what is seen and used is in percent of its best."""
    usual, other = Supermarket.create(), shops.shop(3)
    assert ((usual.cells == -1) == (other.cells == -1)).all()
    assert sorted(other.cells[other.cells > 0]) == [1, 2, 4]
    assert (other.start, other.exit) == (usual.start, usual.exit)
    assert (shops.shop(3).cells == other.cells).all()
    assert (shops.shop(4).cells != other.cells).any()
    assert shops.best_return(3) == value_iteration(shops.model_of(3)).start
    everything = SimpleNamespace(known=np.ones((800, 4)))
    half = made_up({"one": [{10: shops.best_return(3) / 2}] * 2}, agents={"one": [everything] * 2})
    returns, seen = shops.in_shop(half, 3)["one"]
    assert (returns.tolist(), seen.tolist()) == ([50.0, 50.0], [100.0, 100.0])


def test_errors_at_walls() -> None:
    """Without them no plan walks into a wall for ever."""
    plans_without = [plans.follow_plan(1.5, seed, errors_at_walls=False) for seed in range(12)]
    assert not any(plan.bumps for plan in plans_without)


def test_items_that_were_found() -> None:
    """Item 1 counts 4 in a state, item 2 counts 2 and item 3 counts 1; a run has found what it has acted with."""
    tables = np.zeros((2, 800, 4))
    tables[0, 8 * 50 + 4, 2] = tables[0, 8 * 20 + 6, 0] = tables[1, 8 * 30 + 4, 1] = 1.0
    kinds = [
        [SimpleNamespace(Q=-table) for table in tables],
        [SimpleNamespace(Q=table, known=table) for table in tables],
        [SimpleNamespace(Q=table, last=table) for table in tables],
        [SimpleNamespace(Q=0 * table, model=SimpleNamespace(visits=table)) for table in tables],
    ]
    for agents in kinds:
        results = made_up({"one": [{10: 0.0}] * 2}, agents={"one": agents})
        assert plans.items_found(results, "one").tolist() == [1.0, 0.5, 0.0]
