"""On- and off-policy learning on Roadrunner: the claims hold with other seeds than those the lesson shows."""

import numpy as np
import pytest

from edugym import Results, finite_model, make_mdp
from edugym.experiments.figures import Sheet
from edugym_course.lessons.on_off_policy import figures, methods
from edugym_course.lessons.on_off_policy.exact import (
    FAST,
    ROAD,
    best_run,
    best_soft_return,
    deadly_actions,
    share_lost,
    soft_return_of,
    switch,
)
from edugym_course.lessons.on_off_policy.figures import in_the_plane, shortfall_against_epsilon, switch_lines
from edugym_course.lessons.on_off_policy.methods import (
    EXPECTED_SARSA,
    KINDS,
    Q_LEARNING,
    SARSA_,
    compare,
    first_fall,
    greedy_run,
    mean_values,
    most_frequent,
    online_lead,
    stopping_places,
    walk,
)
from tests.course.lessons.figures import check_legends


def test_exact_returns() -> None:
    """At ε = 0 the fast run returns -2 and the safe one -3; a soft policy is never better than the best one."""
    model = finite_model(make_mdp("Roadrunner"))
    assert best_soft_return(model, 0.0) == -2.0
    assert soft_return_of(model, 0.0, planned_for=0.1) == -3.0
    for epsilon in (0.01, 0.05, 0.1):
        best = best_soft_return(model, epsilon)
        runs = [soft_return_of(model, epsilon, planned_for) for planned_for in (0.01, 0.1)]
        assert max(runs) <= best + 1e-9
        assert best == pytest.approx(max(runs), abs=0.05)
    assert 0.03 < switch(model) < 0.05


def test_without_exploring_nobody_pays_for_slips() -> None:
    """Negative control of the online lead: at ε = 0 there is none, and both find the optimum or no better."""
    results = compare(epsilon=0.0, n_steps=4_000, repetitions=4, seed=3)
    assert online_lead(results, SARSA_).estimate == pytest.approx(0.0, abs=0.5)
    for method in (Q_LEARNING, SARSA_):
        assert (results.final(method) == FAST).all()


def test_stopping_places() -> None:
    """A trained runner ends within the stop zone or at the edge."""
    results = compare(epsilon=0.2, learning_rate=0.1, parameters={"stop_zone": 2}, n_steps=20_000, repetitions=3)
    for method in (Q_LEARNING, SARSA_, EXPECTED_SARSA):
        assert set(stopping_places(results, method, stop_zone=2)) <= {7, 8, 9}
    assert np.mean(stopping_places(results, Q_LEARNING, stop_zone=2)) >= np.mean(
        stopping_places(results, SARSA_, stop_zone=2)
    )


def test_best_runs() -> None:
    """The fast run passes the state where one action of three is deadly, and the safe one does not."""
    fast, safe = best_run(0.0), best_run(0.1)
    assert [tuple(state) for state in fast] == [(0, 0), (1, 1), (3, 2), (6, 3), (9, 3)]
    assert len(safe) == 6
    assert tuple(safe[-2]) == (6, 2)
    second = [(0, 0), (1, 1), (3, 2), (4, 1), (6, 2), (9, 3)]
    assert [tuple(state) for state in best_run(0.1, start=fast[2])] == second[2:]
    assert [*in_the_plane().paths.values()] == [[*map(tuple, fast)], [*map(tuple, safe)], second]
    deadly = deadly_actions(ROAD)
    assert deadly[3, 6] == 1
    assert deadly[2, 6] == 0
    assert deadly[3, 8] == 3
    assert np.isnan(deadly[3, 0])


def test_share_lost() -> None:
    """Nobody is lost without slips. Of the safe runs nearly all losses are stalls at the start, ε/3."""
    model = finite_model(ROAD)
    assert share_lost(model, 0.0, 0.01) == share_lost(model, 0.0, 0.1) == 0.0
    assert share_lost(model, 0.1, 0.01) == pytest.approx(0.068, abs=0.001)
    assert share_lost(model, 0.1, 0.1) == pytest.approx(0.041, abs=0.001)
    assert share_lost(model, 0.1, 0.1) > 0.1 / 3
    with pytest.raises(ValueError, match="model must be that of a road, but is <model of Catch"):
        share_lost(finite_model(make_mdp("Catch", observation_type="vectorised")), 0.1, 0.1)


@pytest.fixture(scope="module")
def trained() -> Results:
    """The three methods, trained for a quarter of the lesson's steps."""
    return compare(n_steps=50_000, repetitions=4, seed=5)


def test_runs_of_trained_agents(trained: Results) -> None:
    """Greedy runs are those of the text; a fall is found, and it ends beyond the edge."""
    assert greedy_run(trained.agents[Q_LEARNING][0]) == best_run(0.0)
    assert len(greedy_run(trained.agents[EXPECTED_SARSA][0])) == 6
    actions, episodes = first_fall(trained.agents[Q_LEARNING][0])
    state = ROAD.initial(np.random.default_rng(0))
    for action in actions:
        state = ROAD.transition(state, action, np.random.default_rng(0))
    assert state.x == ROAD.size
    assert episodes >= 1
    slower, _, faster = mean_values(trained, Q_LEARNING, x=3, dx=2)
    assert faster > slower


def test_figures(trained: Results) -> None:
    """They show the three methods in the same order, and draw."""
    assert switch_lines(finite_model(ROAD)).change == pytest.approx(0.032, abs=0.001)
    shortfall = shortfall_against_epsilon([0.05, 0.1], repetitions=2, n_steps=2_000)
    assert [*shortfall.measured] == [*KINDS]
    rates = figures.online_against_rate([0.03, 0.5], repetitions=2, n_steps=2_000)
    sheets = [
        figures.learning_curves(trained),
        figures.learning_curves(trained, epsilon=None, title="ε falls"),
        Sheet("more", [[in_the_plane(), switch_lines(finite_model(ROAD)), shortfall, rates]]),
        figures.race({"mine": KINDS[SARSA_].create}, repetitions=2, n_steps=2_000),
    ]
    for sheet in sheets:
        check_legends(sheet)
        figure = sheet.draw()
        assert all(ax.get_xlabel() for ax in figure.axes)
    for panel in (in_the_plane(), shortfall):
        ax = panel.draw()
        assert ax.get_legend() is not None


def test_another_cliff() -> None:
    """The walk begins in the lower left corner; the most frequent path is found."""
    results = methods.compare_on_cliff(n_steps=600, repetitions=1)
    assert walk(results.agents[Q_LEARNING][0], max_steps=5)[0] == (0, 3)
    assert len(figures.cliff_figure(results).draw().axes) == 2
    assert most_frequent([[(0, 0)], [(1, 1)], [(1, 1)]]) == [(1, 1)]
