"""Prioritised sweeping: what it updates and in which order, its fixed point, and what it is worth."""

from typing import Any

import numpy as np
import pytest

from edugym import PrioritisedSweeping, finite_model, make_mdp
from tests.agents.case import Case
from tests.agents.walk import Walk, exact_values

RNG = np.random.default_rng(0)
CASES = {
    "PrioritisedSweeping": Case(PrioritisedSweeping, PrioritisedSweeping.create),
    "PrioritisedSweeping, sampled": Case(
        PrioritisedSweeping, lambda env: PrioritisedSweeping.create(env, expected_updates=False, planning_steps=3)
    ),
}


def on_a_chain(planning_steps: int, **settings: Any) -> PrioritisedSweeping:
    """An agent that has walked 0 → 1 → 2 → 3, the end, where it was paid 8; α = 1, γ = 1/2."""
    agent = PrioritisedSweeping.create((4, 1), planning_steps=planning_steps, learning_rate=1, discount=0.5, **settings)
    for state in (0, 1, 2):
        agent.learn(state, 0, 8.0 if state == 2 else 0.0, state + 1, state == 2)
    return agent


@pytest.mark.parametrize("expected_updates", [True, False])
@pytest.mark.parametrize(
    ("planning_steps", "values"), [(0, [0, 0, 0, 0]), (1, [0, 0, 8, 0]), (2, [0, 4, 8, 0]), (9, [2, 4, 8, 0])]
)
def test_one_walk_is_enough(planning_steps: int, values: list[float], expected_updates: bool) -> None:
    """The reward goes back one state with every update."""
    agent = on_a_chain(planning_steps, expected_updates=expected_updates)
    agent.act(0, RNG)
    assert agent.Q[:, 0].tolist() == values


def test_what_changes_little_is_left_alone() -> None:
    """P = 8, then 4 for what leads there, then 2: with θ = 3 the last is not updated."""
    agent = on_a_chain(9, threshold=3)
    assert agent.queue.size[0] == 1
    agent.act(0, RNG)
    assert agent.Q[:, 0].tolist() == [0, 4, 8, 0]
    assert agent.queue.size[0] == 0


@pytest.mark.parametrize("threshold", [4.0, 0.0])
def test_a_change_as_large_as_the_threshold_is_left_alone(threshold: float) -> None:
    """Of 8, 4 and 2, after which nothing changes any more, only those above θ are made."""
    agent = on_a_chain(99, threshold=threshold)
    agent.act(0, RNG)
    assert agent.Q[:, 0].tolist() == ([0, 0, 8, 0] if threshold else [2, 4, 8, 0])
    agent.learn(2, 0, 8.0, 3, True)
    assert agent.queue.size[0] == 0


def test_the_largest_change_comes_first() -> None:
    """Three ends that pay 1, 5 and -9: one update a time."""
    agent = PrioritisedSweeping.create((4, 1), planning_steps=1, learning_rate=1)
    for state, reward in ((0, 1.0), (1, 5.0), (2, -9.0)):
        agent.learn(state, 0, reward, 3, True)
    order = []
    for _ in range(3):
        before = agent.Q.copy()
        agent.act(0, RNG)
        order.append(int(np.flatnonzero(before != agent.Q)[0]))
    assert order == [2, 1, 0]


def test_an_action_with_two_outcomes_counts_with_their_mean() -> None:
    """Pays 2 and 4 by turns: Q = 3 at α = 1."""
    agent = PrioritisedSweeping.create((2, 1), learning_rate=1)
    for reward, end in ((2.0, 0), (4.0, 1)):
        agent.learn(0, 0, reward, end, True)
    agent.act(0, RNG)
    assert agent.Q[0, 0] == 3.0


@pytest.mark.parametrize("slip", [0.0, 0.25])
def test_with_the_exact_model_it_finds_the_optimum(slip: float) -> None:
    """Until the queue is empty, in one act, without a step."""
    mdp = Walk(slip=slip)
    agent = PrioritisedSweeping.create(
        mdp, model=finite_model(mdp), planning_steps=np.inf, discount=0.9, learning_rate=1, threshold=1e-12
    )
    agent.act(1, RNG)
    assert agent.queue.size[0] == 0
    assert pytest.approx(exact_values(mdp, 0.9), abs=1e-9) == agent.Q


@pytest.mark.parametrize("settings", [{"expected_updates": False}, {"threshold": 0, "learning_rate": 0.5}])
def test_planning_without_an_end_is_refused(settings: Any) -> None:
    """Where the queue never becomes empty: with noisy updates, or with ever smaller ones."""
    PrioritisedSweeping.create((4, 2), planning_steps=np.inf, threshold=0, learning_rate=1)
    with pytest.raises(ValueError, match=r"planning_steps must be finite if updates are sampled, .* but is inf"):
        PrioritisedSweeping.create((4, 2), planning_steps=np.inf, **settings)


def test_a_model_that_is_given_needs_no_memory() -> None:
    """It does not learn."""
    wall = make_mdp("Boulder", height=3)
    with pytest.raises(ValueError, match=r"memory must be left out where a model is given, .* but is 9"):
        PrioritisedSweeping.create(wall, model=finite_model(wall), memory=9)
