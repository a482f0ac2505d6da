"""On- and off-policy learning on Roadrunner: exact returns, runs, and what the claims measure."""

from typing import Any

import numpy as np
import pytest

from edugym import QLearning, finite_model, make_mdp, value_iteration
from edugym.envs.roadrunner import Roadrunner
from edugym_course.lessons.on_off_policy import exact, experiments, figures, methods
from tests.course.lessons.made_up import made_up, measured
from tests.experiments.figures.samples import new_axes


def test_exact_returns() -> None:
    """At ε = 0 the fast run returns -2 and the safe one -3; of the safe runs nearly all losses are stalls, ε/3."""
    model = finite_model(make_mdp("Roadrunner"))
    assert exact.best_soft_return(model, 0.0) == -2.0
    assert exact.soft_return_of(model, 0.0, planned_for=0.1) == -3.0
    for epsilon in (0.01, 0.1):
        assert exact.best_soft_return(model, epsilon) == pytest.approx(exact.soft_return_of(model, epsilon, epsilon))
    assert 0.03 < exact.switch(model) < 0.05
    model = finite_model(exact.ROAD)
    assert exact.share_lost(model, 0.0, 0.01) == exact.share_lost(model, 0.0, 0.1) == 0.0
    assert exact.share_lost(model, 0.1, 0.1) == pytest.approx(0.041, abs=0.001)
    with pytest.raises(ValueError, match="model must be that of a road, but is <model of Catch"):
        exact.share_lost(finite_model(make_mdp("Catch", observation_type="vectorised")), 0.1, 0.1)


def test_best_runs() -> None:
    """The fast run passes the state where one action of three is deadly, and the safe one does not."""
    fast, safe = exact.best_run(0.0), exact.best_run(0.1)
    assert [tuple(state) for state in fast] == [(0, 0), (1, 1), (3, 2), (6, 3), (9, 3)]
    assert len(safe) == 6
    assert tuple(safe[-2]) == (6, 2)
    second = [(0, 0), (1, 1), (3, 2), (4, 1), (6, 2), (9, 3)]
    assert [tuple(state) for state in exact.best_run(0.1, start=fast[2])] == second[2:]
    assert [*figures.in_the_plane().paths.values()] == [[*map(tuple, fast)], [*map(tuple, safe)], second]
    drawn = figures.in_the_plane().draw(new_axes())
    assert {text.get_text() for text in drawn.texts} == {"0", "1", "2", "3"}
    deadly = exact.deadly_actions(exact.ROAD)
    assert deadly[3, 6] == 1
    assert deadly[2, 6] == 0
    assert deadly[3, 8] == 3
    assert np.isnan(deadly[3, 0])


@pytest.mark.slow
def test_runs_of_trained_agents() -> None:
    """Greedy runs are those of the text; a fall is found, and it ends beyond the edge."""
    trained = methods.compare(n_steps=50_000, repetitions=4, seed=5)
    assert methods.greedy_run(trained.agents[methods.Q_LEARNING][0]) == exact.best_run(0.0)
    assert len(methods.greedy_run(trained.agents[methods.EXPECTED_SARSA][0])) == 6
    actions, episodes = methods.first_fall(trained.agents[methods.Q_LEARNING][0])
    state = exact.ROAD.initial(np.random.default_rng(0))
    for action in actions:
        state = exact.ROAD.transition(state, action, np.random.default_rng(0))
    assert state.x == exact.ROAD.size
    assert episodes >= 1
    slower, _, faster = methods.mean_values(trained, methods.Q_LEARNING, x=3, dx=2)
    assert faster > slower


def test_another_cliff() -> None:
    """The walk begins in the lower left corner; the most frequent path is found."""
    results = methods.compare_on_cliff(n_steps=600, repetitions=1)
    assert methods.walk(results.agents[methods.Q_LEARNING][0], max_steps=5)[0] == (0, 3)
    assert len(figures.cliff_figure(results).draw().axes) == 2
    assert methods.most_frequent([[(0, 0)], [(1, 1)], [(1, 1)]]) == [(1, 1)]


def test_claims() -> None:
    """The lead is that of the second half of training; every share counts the runs with the return that it names."""
    q, sarsa, expected = methods.KINDS
    ends = {q: (-2.0, -3.0, -2.0, -2.0), sarsa: (-3.0, -2.0, -4.0, -3.0), expected: (-3.0, -3.0, -3.0, -100.0)}
    edge = made_up({method: [{0: -50.0, 5: -60.0, 10: end} for end in returns] for method, returns in ends.items()})
    leads = [-3.0 + 2.25, -27.25 + 2.25]
    assert measured(experiments.edge_claims(edge)) == [0.75, 0.5, 0.75, *leads]

    elsewhere = {q: [-2.0, -2.0, -3.0, -3.0], sarsa: [-3.0, -2.0, -4.0, -5.0], expected: [-2.0, -2.0, -2.0, -3.0]}
    runs, cliff = (
        made_up({method: [{0: 0.0, 5: 0.0, 10: end} for end in found] for method, found in of.items()})
        for of in (elsewhere, {q: [-13.0, -14.0], sarsa: [-15.0, -13.0], expected: [-15.0, -15.0]})
    )
    assert measured(experiments.condition_claims(runs, runs, runs)) == [-1.0, 0.25, -1.0, 0.25, 0.25, 0.75]
    both = (methods.LEARNING_RATE, experiments.TINY)
    rare = experiments.rare_claims({(size, rate): runs for size in experiments.ROADS for rate in both})
    assert measured(rare) == [0.25, *[-1.0] * 3, *[0.25] * 3, *[-1.0] * 3]
    ice = made_up({q: [{10: 0.0}] * 4}, agents={q: [road(0.1), road(0.1), road(0.1), road(0.0)]})
    assert measured(experiments.other_cliff_claims(ice, cliff)) == [0.75, 0.5, 0.5, 1.0, -0.5, -1.5]
    bold, careful = road(0.0, stop_zone=2), road(0.2, stop_zone=2)
    zone = made_up({method: [{10: 0.0}] for method in (q, sarsa, expected)}, agents={q: [bold], sarsa: [careful]})
    assert measured(experiments.zone_claims(zone, {"cheap falls": zone})) == [9.0, -1.0, 8.0]


def road(epsilon: float, **parameters: Any) -> QLearning:
    """Return a runner who has learned what is best with such exploration; it never stands still on its way."""
    task = Roadrunner.create(**parameters)
    best = value_iteration(finite_model(task), epsilon=epsilon)
    agent = QLearning.create(task)
    for (x, speed), values in zip(best.model.states, best.Q, strict=True):
        if speed >= 0:
            agent.Q[x * (task.max_speed + 1) + speed] = values
    return agent
