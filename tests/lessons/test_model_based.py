"""Model-based learning in Supermarket: the claims hold with other seeds than those the lesson shows."""

from functools import partial

import numpy as np

from edugym.agents.dyna_q import DynaQ
from edugym.agents.prioritised_sweeping import PrioritisedSweeping
from edugym.exact.value_iteration import value_iteration
from edugym.lessons.model_based import (
    DYNA_10,
    LOST,
    OPTIMUM,
    compare,
    early,
    exact_model,
    follow_plan,
    make,
)


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
    """The longest way to the exit without visiting a state twice costs less than 300; one that never ends costs 500."""
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
