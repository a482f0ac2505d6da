"""R-max: optimism by hand, its fixed points, and that it explores because it plans to."""

import numpy as np
import pytest

from edugym import RMax, finite_model
from tests.agents.case import Case
from tests.agents.walk import Walk, exact_values

RNG = np.random.default_rng(0)
CASES = {
    "RMax": Case(RMax, RMax.create),
    "RMax, known after 3": Case(RMax, lambda env: RMax.create(env, known_after=3, planning_steps=4)),
}


def test_the_unknown_is_hoped_for_and_feared() -> None:
    """U = 10, L = -10, γ = 1/2: (0, 0) pays 1 and leads to 1, of which nothing is known."""
    agent = RMax.create((3, 2), highest_return=10, lowest_return=-10, discount=0.5)
    agent.learn(0, 0, 1.0, 1, False)
    assert {agent.act(0, RNG) for _ in range(20)} == {1}
    assert agent.optimistic.tolist() == [[6, 10], [10, 10], [10, 10]]
    assert agent.Q.tolist() == [[-4, -10], [-10, -10], [-10, -10]]
    assert {agent.greedy(0, RNG) for _ in range(20)} == {0}


def test_it_goes_back_to_what_it_has_not_tried() -> None:
    """0 → 1 by action 0, and both actions of 0 tried: the way to the unknown actions of 1 is the best."""
    agent = RMax.create((3, 2), discount=0.9)
    agent.learn(0, 0, -1.0, 1, False)
    agent.learn(0, 1, 50.0, 2, True)
    assert agent.act(0, RNG) == 0  # -1 + 0.9 · 100 > 50
    agent.learn(1, 0, 0.0, 2, True)
    agent.learn(1, 1, 0.0, 2, True)
    assert agent.act(0, RNG) == 1  # now all is known


def test_a_sweep_that_changes_nothing_is_the_last() -> None:
    """Also with θ = 0: the first two updates make values of 1 and 1/2, and the next two change nothing."""
    agent = RMax.create((3, 1), discount=0.5, threshold=0, planning_steps=50)
    agent.learn(1, 0, 1.0, 2, True)
    agent.learn(0, 0, 0.0, 1, False)
    agent.act(0, RNG)
    assert agent.optimistic[:2, 0].tolist() == [0.5, 1.0]
    assert agent.sweep.settled[0] == 2
    assert agent.sweep.next[0] == 0


def test_a_pair_is_known_after_m_visits_and_then_stays_so() -> None:
    """M = 2: the mean of the first two rewards, whatever comes then."""
    agent = RMax.create((2, 1), known_after=2)
    values = []
    for reward in (2.0, 4.0, 99.0):
        agent.learn(0, 0, reward, 1, True)
        agent.act(0, RNG)
        values.append(float(agent.optimistic[0, 0]))
    assert values == [100, 3, 3]


def test_the_budget_spreads_the_sweep_over_the_steps() -> None:
    """One update an act: the known pairs by turns."""
    agent = RMax.create((3, 1), planning_steps=1, discount=0.5)
    agent.learn(0, 0, 0.0, 1, False)
    agent.learn(1, 0, 8.0, 2, True)
    values = []
    for _ in range(4):
        agent.act(0, RNG)
        values.append(agent.optimistic[:2, 0].tolist())
    assert values == [[50, 100], [50, 8], [4, 8], [4, 8]]


@pytest.mark.parametrize("slip", [0.0, 0.25])
def test_with_the_exact_model_it_has_the_optimum(slip: float) -> None:
    """Both tables, without a step."""
    mdp = Walk(slip=slip)
    agent = RMax.create(mdp, model=finite_model(mdp), discount=0.9, threshold=1e-12)
    agent.act(1, RNG)
    exact = exact_values(mdp, 0.9)
    assert agent.Q[1:-1] == pytest.approx(exact[1:-1], abs=1e-9)
    assert agent.optimistic[1:-1] == pytest.approx(exact[1:-1], abs=1e-9)
