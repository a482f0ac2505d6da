"""Dyna-Q: its updates by hand, what it plans with, and what planning is worth."""

import math

import numpy as np
import pytest

from edugym import DynaQ, EpsilonGreedy, finite_model, train
from tests.agents.case import Case
from tests.agents.walk import Walk, exact_values

RNG = np.random.default_rng(0)
CASES = {
    "DynaQ without planning": Case(
        DynaQ, lambda env: DynaQ.create(env, planning_steps=0, learning_rate=0.5, discount=0.5), True
    ),
    "DynaQ": Case(DynaQ, DynaQ.create),
    "Dyna-Q+, expected": Case(DynaQ, lambda env: DynaQ.create(env, exploration_bonus=0.1, expected_updates=True)),
}


def test_planning_repeats_the_update() -> None:
    """One pair, α = γ = 1/2: the real step gives Q = 1, and each imagined one halves what is missing to 2."""
    agent = DynaQ.create((2, 1), planning_steps=3, learning_rate=0.5, discount=0.5)
    agent.learn(0, 0, 2.0, 1, True)
    assert agent.Q[0, 0] == 1.0
    agent.act(0, RNG)
    assert agent.Q[0, 0] == 2.0 - 1.0 / 8
    agent.learn(1, 0, 0.0, 0, False)  # Q(1) = (0 + Q(0)/2)/2; nothing is known of an end that bootstraps
    assert agent.Q[1, 0] == (2.0 - 1.0 / 8) / 4


def test_with_a_bonus_it_imagines_what_it_has_not_tried_for_long() -> None:
    """κ = 2, α = 1, γ = 1/2: after 9 steps of action 0, it is worth 3 + 2 √0, and action 1, never tried, 2 √9 + Q/2."""
    agent = DynaQ.create((2, 2), planning_steps=1, learning_rate=1, discount=0.5, exploration_bonus=2)
    for _ in range(9):
        agent.learn(0, 0, 3.0, 1, True)
    assert agent.imagined_target(0, 0, RNG) == 3.0
    assert agent.imagined_target(0, 1, RNG) == 2 * math.sqrt(9) + 0.5 * 3.0
    agent.model.steps[0] += 16
    assert agent.imagined_target(0, 0, RNG) == 3.0 + 2 * math.sqrt(16)


def test_without_a_bonus_it_imagines_only_what_it_has_tried() -> None:
    """Action 1 keeps its value."""
    agent = DynaQ.create((3, 2), planning_steps=500)
    agent.learn(0, 0, 3.0, 1, False)
    agent.learn(2, 1, 3.0, 1, False)
    agent.act(0, RNG)
    assert np.argwhere(agent.Q).tolist() == [[0, 0], [2, 1]]


@pytest.mark.parametrize("given", [True, False])
def test_expected_planning_finds_the_optimum(given: bool) -> None:
    """With the exact model, and with one that was learned from very many steps."""
    mdp = Walk()
    model = finite_model(mdp) if given else None
    agent = DynaQ.create(
        mdp, model=model, discount=0.9, learning_rate=1, expected_updates=True, exploration=EpsilonGreedy(1)
    )
    if given:
        for _ in range(300):
            agent.act(1, RNG)
        tolerance = 1e-8
    else:
        train(mdp, agent, 50_000, seed=1, evaluate_every=50_000)
        for _ in range(100):
            agent.act(1, RNG)
        tolerance = 0.03
    assert pytest.approx(exact_values(mdp, 0.9), abs=tolerance) == agent.Q
    assert pytest.approx(exact_values(mdp, 0.8), abs=tolerance) != agent.Q


def test_sampled_planning_comes_near_it() -> None:
    """With the exact model as a generator, without a single real step."""
    mdp = Walk()
    agent = DynaQ.create(mdp, model=finite_model(mdp), discount=0.9, learning_rate=0.01, planning_steps=200)
    for _ in range(300):
        agent.act(1, RNG)
    assert pytest.approx(exact_values(mdp, 0.9), abs=0.1) == agent.Q


def test_planning_for_some_time(compiled_at_once: None) -> None:
    """Interpreted, and as long as it was told."""
    agent = DynaQ.create((2, 1), planning_seconds=0.02, learning_rate=0.5)
    agent.learn(0, 0, 2.0, 1, True)
    agent.act(0, RNG)
    assert agent.Q[0, 0] > 1.99
    with pytest.warns(UserWarning, match="cannot be compiled and runs interpreted"):
        train(Walk(), DynaQ.create((5, 2), planning_seconds=1e-9), 6_000, seed=0, evaluate_every=6_000)
