"""Model-based learning in Supermarket: the claims hold with other seeds than those the lesson shows."""

import math
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
import pandas as pd
import pytest
from matplotlib.text import Annotation

from edugym.agents.dyna_q import DynaQ
from edugym.agents.prioritised_sweeping import PrioritisedSweeping
from edugym.agents.tabular_model import TabularModel
from edugym.envs.supermarket import Supermarket
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures import Sheet
from edugym_course.lessons.model_based.experiments import difference, early, warm_up
from edugym_course.lessons.model_based.figures import (
    OWN,
    STROKES,
    Clock,
    Close,
    Knowledge,
    look_ahead_lines,
    race,
    steps_to,
    strokes_of,
)
from edugym_course.lessons.model_based.maps import (
    FloorMap,
    after_walk,
    dynamic_programming,
    random_walk,
    spreading,
    who_knows_the_way,
    wrong_plan,
)
from edugym_course.lessons.model_based.methods import (
    DYNA_10,
    GIVEN,
    LEARNED,
    LOST,
    OPTIMUM,
    Q_LEARNING,
    R_MAX,
    REMEDIES,
    SWEEPING,
    CountingSweeping,
    compare,
    compare_planners,
    exact_model,
    make,
    targets_computed,
)
from edugym_course.lessons.model_based.plans import (
    best_by_what_was_seen,
    follow_plan,
    items_found,
    look_ahead,
    used_and_seen,
)
from tests.course.lessons.figures import check_legends
from tests.course.lessons.made_up import finals


def test_plans() -> None:
    """A plan with the right model is the best way; with large errors some plan never ends, most of them at a wall."""
    best = follow_plan(0.0, 3)
    assert best.ends
    assert best.total == OPTIMUM == value_iteration(exact_model()).start
    wrong = [follow_plan(1.5, seed) for seed in range(12)]
    assert any(plan.bumps for plan in wrong)
    assert all(plan.total <= OPTIMUM for plan in wrong)
    assert not any(plan.ends for plan in wrong if plan.bumps)


def test_layouts_differ_and_repeat() -> None:
    """The errors belong to the layout."""
    totals = [follow_plan(1.0, seed).total for seed in range(30)]
    assert len(set(totals)) > 1
    assert totals[:3] == [follow_plan(1.0, seed).total for seed in range(3)]


def test_a_policy_that_ends_returns_more_than_lost() -> None:
    """The longest way that visits no state twice costs less than 300; one that never ends costs 500.

    (A way passes through at most 4 of the 8 bags.)
    """
    assert -len(exact_model().states) / 2 > LOST > -500.0


def test_a_given_model_needs_no_experience() -> None:
    """Planned to the end before the first step; with a learned model one step teaches next to nothing."""
    methods = {
        kind: partial(make, PrioritisedSweeping, given=kind == "given", planning_steps=np.inf)
        for kind in ("given", "learned")
    }
    results = compare(methods, n_steps=1, repetitions=2)
    assert results.final("given").tolist() == [OPTIMUM, OPTIMUM]
    assert (results.final("learned") < OPTIMUM).all()


def test_without_planning_dyna_has_no_head_start() -> None:
    """Negative control of the speed: with no updates it learns at the pace of Q-learning, which ten updates beat."""
    methods = {"none": partial(make, DynaQ, planning_steps=0), DYNA_10: partial(make, DynaQ, planning_steps=10)}
    results = compare(methods, n_steps=4_000, repetitions=10, seed=2)
    assert early(results, "none").mean() < -200.0 < early(results, DYNA_10).mean()


def test_a_plan_keeps_its_path() -> None:
    """From the entrance to the exit with all items; a bump ends where it was."""
    best = follow_plan(0.0, 0)
    assert len(best.path) == 31
    assert (best.path[0], best.path[-1]) == (8, 80 * 9 + 8 * 8 + 7)
    lost = next(plan for plan in (follow_plan(1.5, seed) for seed in range(12)) if plan.bumps)
    assert lost.path[-1] == lost.path[-2]


def test_planning_to_act() -> None:
    """With the optimal values no look ahead is needed; with none it must see the next reward."""
    values = value_iteration(exact_model(), 0.99).table()
    assert look_ahead(np.nan_to_num(values), 0) == OPTIMUM
    assert look_ahead(None, 7) == -500.0
    assert look_ahead(None, 12) == OPTIMUM


def test_the_walk_of_the_maps() -> None:
    """It leaves with an empty bag, and 200 updates in the right places are enough to know the way."""
    walk = random_walk()
    assert len(walk) == 518
    assert all(step[3] % 8 == 0 for step in walk)
    assert [step[4] for step in walk] == [False] * 517 + [True]
    assert who_knows_the_way(0) == ()
    assert who_knows_the_way(200) == ("prioritised sweeping",)
    assert np.nanmax(after_walk(DynaQ, 0)) == 49.0
    assert np.isnan(FloorMap(after_walk(DynaQ, 0)).values()[7, 2])  # the blue item was never seen


def test_planning_invents_no_knowledge() -> None:
    """Perfect planning makes nothing more of what planners have seen, and something more of what Q-learning has."""
    results = compare({label: LEARNED[label] for label in (Q_LEARNING, DYNA_10, R_MAX)}, repetitions=20, seed=4)
    known = used_and_seen(results)
    for policy, seen in known.values():
        assert (seen >= policy).mean() > 0.9  # the best by discounted returns
    assert known[DYNA_10][1].mean() - known[DYNA_10][0].mean() < 1.0
    assert known[Q_LEARNING][1].mean() > known[Q_LEARNING][0].mean()
    assert items_found(results, R_MAX).tolist() == [1.0, 1.0, 1.0]
    assert best_by_what_was_seen(DynaQ.create((800, 4))) == -500.0


def test_the_clock() -> None:
    """A step takes as long as the world or as its targets need, whichever is longer."""
    methods = {label: LEARNED[label] for label in (Q_LEARNING, DYNA_10, SWEEPING)}
    results = compare(methods, n_steps=2_000, repetitions=4)
    targets = targets_computed(results)
    clock = Clock(results, targets, step_ms=0.05, target_us=10.0)
    assert clock.seconds(Q_LEARNING)[-1] == pytest.approx([2_000 * 5e-5] * 4)
    assert clock.seconds(DYNA_10)[[0, 1]] == pytest.approx(np.array([[0.0] * 4, [50 * 1.1e-4] * 4]))
    assert clock.seconds(SWEEPING)[-1] == pytest.approx(np.maximum(targets[SWEEPING] * 1e-5, 5e-5).sum(axis=1))
    assert steps_to(results, DYNA_10, 1_000.0) == clock.seconds_to(DYNA_10, 1_000.0) == math.inf
    assert steps_to(results, DYNA_10, -600.0) == clock.seconds_to(DYNA_10, -600.0) == 0.0


def test_each_run_has_a_clock_of_its_own() -> None:
    """Of two runs the fast one learns from second 10 to 20, the slow one nothing: from second 20 on the mean is 50."""
    curves = pd.DataFrame({0: [0.0, 0.0, 100.0], 1: [0.0, 0.0, 0.0]}, index=[0, 10, 20])
    results: Any = SimpleNamespace(curves=lambda method: curves)
    targets = {SWEEPING: np.array([[1] * 20, [10] * 20])}
    moments, returns = Clock(results, targets, step_ms=0.0, target_us=1e6).mean(SWEEPING)
    assert moments[[0, -1]] == pytest.approx([10.0, 200.0])
    assert np.interp([15.0, 20.0, 100.0, 200.0], moments, returns) == pytest.approx([25.0, 50.0, 50.0, 50.0], abs=1.0)


def test_the_targets_of_prioritised_sweeping() -> None:
    """What counts them learns the same; priorities count, and with an empty queue one target a step is left."""
    how: dict[str, Any] = {"n_steps": 2_000, "repetitions": 3}
    results = compare({SWEEPING: LEARNED[SWEEPING]}, **how)
    counting = compare({SWEEPING: partial(CountingSweeping.create, n_steps=2_000)}, **how)
    assert counting.curves(SWEEPING).equals(results.curves(SWEEPING))
    targets = targets_computed(results)[SWEEPING]
    assert targets.shape == (3, 2_000)
    assert targets.min() == 1
    assert targets[:, :500].sum(axis=1).min() > 1_000
    assert targets[:, 1_000:].mean() < 3


def test_the_count_is_that_of_the_code(monkeypatch: pytest.MonkeyPatch) -> None:
    """Interpreted, as many targets are computed as are counted."""
    computed = []
    expected_target = TabularModel.expected_target

    def counted(self: TabularModel, *rest: Any) -> float:
        computed.append(rest)
        return expected_target(self, *rest)

    shop, rng = Supermarket.create(), np.random.default_rng(0)
    agent = CountingSweeping.create(shop, 600)
    monkeypatch.setattr(TabularModel, "expected_target", counted)
    state = shop.initial(rng)
    for _ in range(600):
        action = agent.act(state, rng)
        next_state = shop.transition(state, action, rng)
        ended = shop.terminal(next_state)
        agent.learn(state, action, shop.reward(state, action, next_state, rng), next_state, ended)
        state = shop.initial(rng) if ended else next_state
    assert agent.targets[0, :-1].sum() == len(computed) > 2_000


@pytest.mark.parametrize(("runs", "others", "mean"), [(3, 4, 4.0), (4, 3, 4.0), (4, 4, 7.0)])
def test_a_difference_is_paired_by_the_runs_of_both(runs: int, others: int, mean: float) -> None:
    """Of 1, 4, 9 and 20 less 0, 0, 2 and 4; the first result comes first."""
    one, other = finals({"a": [1.0, 4.0, 9.0, 20.0][:runs]}), finals({"b": [0.0, 0.0, 2.0, 4.0][:others]})
    found = difference(one, "a", other, "b")
    assert (found.estimate, found.n) == (mean, min(runs, others))


def test_methods_keep_their_colours() -> None:
    """Whatever else is in a figure; each of a reader's own has another one."""
    assert strokes_of(["Dyna-30"])["Dyna-30"] == strokes_of(LEARNED)[DYNA_10]
    methods = {*LEARNED, *GIVEN}
    looks = strokes_of([*LEARNED, *GIVEN, "mine", "Dyna-Q+", "Dyna-30", "last"])
    assert len({look["color"] for look in looks.values()}) == len(methods) + len(OWN) == len(looks)
    assert methods <= {*STROKES}
    assert len({look["color"] for look in strokes_of([DYNA_10, *REMEDIES]).values()}) == 1 + len(REMEDIES)


def test_thirty_sweeps_are_enough() -> None:
    """As the lesson says: with an empty bag, and with any other."""
    after_30, at_last = (value_iteration(exact_model(), 0.99, horizon=sweeps).V for sweeps in (30, 200))
    assert np.allclose(after_30, at_last)


def test_figures_are_drawn() -> None:
    """Each of them, from few runs; the warm-up trains what they need."""
    warm_up()
    results = compare_planners(4, 0.1, 1.0, 0.99, n_steps=400, repetitions=2)
    assert results.methods == [Q_LEARNING, "Dyna-4", "prioritised sweeping"]
    for sheet in (
        spreading(20),
        dynamic_programming((1, 2)),
        wrong_plan(1.5, 0),
        Sheet("one", [[Knowledge(used_and_seen(results)), Clock(results, targets_computed(results), 1.0, 1.0)]]),
        Sheet("two", [[look_ahead_lines(results, (0, 1)), Close(look_ahead_lines(results, (0, 1)), (50.0, 100.0))]]),
        race({"mine": lambda shop: DynaQ.create(shop)}, 2, n_steps=400),
    ):
        assert sheet._repr_png_()[:4] == b"\x89PNG"
        check_legends(sheet)


def test_arrows_where_something_is_known() -> None:
    """One in each cell with a value above 0, but not at the entrance, which has its label."""
    Q = np.full((800, 4), np.nan)
    Q[[8 * 5, 80 * 3 + 8 * 4, 80 * 6 + 8 * 2]] = 1.0  # in the row of the entrance, and in two others
    Q[80 * 7] = -1.0
    axes = FloorMap(Q, arrows=True).draw()
    arrows = [text for text in axes.texts if isinstance(text, Annotation)]
    assert [(round(arrow.xy[0]), round(arrow.xy[1])) for arrow in arrows] == [(4, 3), (2, 6)]
