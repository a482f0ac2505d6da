"""The actor-critic for real actions: its update by hand, its draws, and continuous Trashbot."""

import math
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import GaussianActorCritic, Identity, TileCoding, make_mdp, train
from tests.agents.case import Case


def small(environment: Any, **settings: Any) -> GaussianActorCritic:
    """With two tiles a number."""
    features = TileCoding.create(environment, 2) if hasattr(environment, "action_space") else None
    return GaussianActorCritic.create(environment, features=features, **settings)


CASES = {"GaussianActorCritic": Case(GaussianActorCritic, small, real_actions=True)}


@pytest.mark.parametrize(
    ("terminated", "error"), [(False, 1 + 0.5 * (3 * 2 + 1) - (2 * 1 + 1)), (True, 1 - (2 * 1 + 1))]
)
def test_update(terminated: bool, error: float) -> None:
    """W = (1, 2, 1), S = (2, 0), S' = (0, 3), a constant of 1; μ(S) = (0.5, 0), drawn (0.9, -0.2), σ = 0.4."""
    agent = GaussianActorCritic.create(
        (2, 2), features=Identity.create((2, 2)), learning_rate=0.1, value_learning_rate=0.2, discount=0.5, spread=0.4
    )
    agent.value_weights[:, 0] = [1, 2, 1]
    agent.weights[:, 0] = [0.25, 7, 0]
    agent.drawn[:] = [0.9, -0.2]
    before = agent.weights.copy()
    agent.learn(np.array([2.0, 0.0]), 1.0, np.array([0.0, 3.0]), terminated)
    x = np.array([2.0, 0.0, 1.0])
    assert agent.value_weights[:, 0] == pytest.approx(np.array([1, 2, 1]) + 0.2 * error * x)
    slope = (np.array([0.9, -0.2]) - [0.5, 0.0]) / 0.16
    assert agent.weights == pytest.approx(before + 0.1 * error * np.outer(x, slope))


def test_it_draws_around_the_mean_and_cuts_off_at_the_bounds() -> None:
    """It learns from what it drew; the environment gets what it allows."""
    env = gymnasium.make("Pendulum-v1")  # from -2 to 2
    agent, rng, state = GaussianActorCritic.create(env, spread=3.0), np.random.default_rng(0), np.zeros(3, np.float32)
    agent.weights[:] = 1 / 8  # the mean is 1 everywhere
    given, drawn = [], []
    for _ in range(2_000):
        given.append(agent.act(state, rng))
        drawn.append(agent.drawn[0])
    assert np.mean(drawn) == pytest.approx(1.0, abs=4 * 3 / math.sqrt(2_000))
    assert np.std(drawn) == pytest.approx(3.0, rel=0.1)
    assert np.concatenate(given) == pytest.approx(np.clip(drawn, -2, 2))
    assert all(env.action_space.contains(action) for action in given)
    assert agent.greedy(state, rng) == pytest.approx([1.0])
    agent.weights[:] = 1.0
    assert agent.greedy(state, rng).tolist() == [2.0]


def test_every_action_is_an_array_of_its_own() -> None:
    """One that was kept does not change at the next step."""
    agent, rng = small((2, 2)), np.random.default_rng(0)
    first = agent.act(np.zeros(2), rng)
    kept = first.copy()
    agent.act(np.zeros(2), rng)
    assert np.array_equal(first, kept)


def test_what_does_not_fit_is_refused() -> None:
    """Actions that are whole numbers, a spread of 0, too many tiles."""
    with pytest.raises(ValueError, match="needs actions that are vectors of real numbers, but the action space is"):
        GaussianActorCritic.create(make_mdp("Boulder"))
    with pytest.raises(ValueError, match="spread must be greater than 0, but is 0"):
        small((2, 2), spread=0)
    with pytest.raises(ValueError, match="leave numbers out by 1"):
        GaussianActorCritic.create(make_mdp("Trashbot"))


def returns_in_trashbot(learning_rate: float, seed: int) -> float:
    """The return of the mean action after 100 000 steps, on tiles over the wrist and holding."""
    mdp = make_mdp("Trashbot")
    agent = GaussianActorCritic.create(
        mdp,
        features=TileCoding.create(mdp, tiles=[1, 1, 9, 9, 1, 1, 2]),
        learning_rate=learning_rate,
        discount=0.98,
        initial_value=1.0,
    )
    return float(train(mdp, agent, 100_000, seed=seed, evaluate_every=100_000).returns[-1])


def test_it_learns_continuous_trashbot() -> None:
    """It delivers the box (3 or more; in a trial in 20 of 20 runs), and not without learning."""
    assert returns_in_trashbot(0.01, 0) > 3
    assert returns_in_trashbot(5e-324, 0) < 3


def test_an_initial_value_needs_features_that_are_all_alike() -> None:
    """With the observation itself as features, the first value would differ from state to state."""
    assert GaussianActorCritic.create((3, 2), features=Identity.create((3, 2))).value_weights.max() == 0.0
    with pytest.raises(ValueError, match="initial_value must be 0 for the features Identity, but is 5"):
        GaussianActorCritic.create((3, 2), 5, features=Identity.create((3, 2)))
