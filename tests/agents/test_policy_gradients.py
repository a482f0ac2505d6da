"""The agents that learn a policy: their updates by hand, their draws, and what a baseline is worth."""

import math
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import REINFORCE, ActorCritic, GaussianActorCritic, Identity, TileCoding, make_mdp, train
from edugym.agents.softmax import draw_action, follow_log_gradient, softmax


@pytest.mark.parametrize(
    ("terminated", "error"),
    [(False, 1 + 0.5 * 4 - 2), (True, 1 - 2)],  # = 1: the next state is worth 4; = -1: nothing comes after an end
)
def test_update_of_the_actor_critic(terminated: bool, error: float) -> None:
    """V = (2, 4), equal preferences for three actions: π = 1/3 each, ∇ln π(1) = (-1/3, 2/3, -1/3); I = 1."""
    agent = ActorCritic.create((2, 3), learning_rate=0.3, value_learning_rate=0.1, discount=0.5)
    agent.V[:] = [2, 4]
    agent.learn(0, 1, 1.0, 1, terminated, False)
    assert agent.V.tolist() == [2 + 0.1 * error, 4]
    assert agent.preferences[0] == pytest.approx(0.3 * error * np.array([-1, 2, -1]) / 3)
    assert not agent.preferences[1].any()


def test_later_steps_of_an_episode_count_less_for_the_actor() -> None:
    """I is 1, γ, γ², and 1 again after an end or a truncation."""
    agent, seen = ActorCritic.create((1, 2), discount=0.5), []
    for terminated, truncated in ((False, False), (False, False), (False, True), (True, False), (False, False)):
        seen.append(agent.weight[0])
        agent.learn(0, 0, 0.0, 0, terminated, truncated)
    assert seen == [1, 0.5, 0.25, 1, 1]


def test_softmax_and_draws_agree() -> None:
    """π = (1, 2, 5)/8 for the preferences 0, ln 2, ln 5; of 4 000 draws each action has its share, within 4 σ."""
    preferences, p = np.array([[0.0, math.log(2), math.log(5)]]), np.zeros(3)
    for shift in (0, 1e4):  # no exponential is too large
        softmax(preferences + shift, 0, p)
        assert p == pytest.approx(np.array([1, 2, 5]) / 8)
    rng = np.random.default_rng(0)
    counts = np.bincount([draw_action(p, rng) for _ in range(4_000)], minlength=3)
    assert (np.abs(counts - 4_000 * p) < 4 * np.sqrt(4_000 * p * (1 - p))).all()


def test_the_gradient_is_that_of_the_logarithm() -> None:
    """Against differences: (ln π(a|θ + h e_b) - ln π(a|θ - h e_b)) / 2h."""
    h, preferences, p = 1e-6, np.random.default_rng(1).normal(size=(1, 4)), np.zeros(4)

    def log_policy(action: int, b: int, change: float) -> float:
        moved = preferences.copy()
        moved[0, b] += change
        softmax(moved, 0, p)
        return math.log(p[action])

    for action in range(4):
        followed = preferences.copy()
        softmax(preferences, 0, p)
        follow_log_gradient(followed, 0, action, p, 1.0)
        slopes = [(log_policy(action, b, h) - log_policy(action, b, -h)) / (2 * h) for b in range(4)]
        assert (followed - preferences)[0] == pytest.approx(slopes, abs=1e-8)


@pytest.mark.parametrize(("terminated", "last"), [(True, 0.0), (False, 8.0)])
def test_an_episode_of_reinforce(terminated: bool, last: float) -> None:
    """States 0, 1 and 0 again, rewards 1, 2 and 3, γ = 1/2; it ends, or is truncated in state 2, which is worth 8.

    Returns: G₂ = 3 + last/2, G₁ = 2 + G₂/2, G₀ = 1 + G₁/2. Baseline: V(0) is updated before it is used again.
    """
    agent = REINFORCE.create((3, 2), learning_rate=0.2, value_learning_rate=0.1, discount=0.5)
    agent.V[:] = [1.0, 0.0, 8.0]
    agent.learn(0, 0, 1.0, 1, False, False)
    agent.learn(1, 1, 2.0, 0, False, False)
    assert not agent.preferences.any()  # nothing before the end of the episode
    agent.learn(0, 0, 3.0, 2, terminated, not terminated)
    G = [0.0, 0.0, 3 + last / 2]
    G[1] = 2 + G[2] / 2
    G[0] = 1 + G[1] / 2
    first = 1.0 + 0.1 * (G[0] - 1.0)
    assert pytest.approx([first + 0.1 * (G[2] - first), 0.1 * G[1], 8.0]) == agent.V
    step = 0.2 * (G[0] - 1.0) / 2  # π = 1/2 at first
    p = np.exp(step) / (np.exp(step) + np.exp(-step))
    step += 0.2 * 0.25 * (G[2] - first) * (1 - p)
    assert agent.preferences[0] == pytest.approx([step, -step])
    assert agent.preferences[1] == pytest.approx(0.2 * 0.5 * G[1] * np.array([-0.5, 0.5]))
    assert agent.episode.length[0] == 0


def test_a_long_episode_is_learned_from_in_parts() -> None:
    """With room for two steps the second one is treated as the last before a truncation."""
    agent = REINFORCE.create((2, 2), longest=2)
    agent.learn(0, 0, 1.0, 1, False, False)
    assert not agent.preferences.any()
    agent.learn(1, 0, 1.0, 0, False, False)
    assert agent.preferences.any()
    assert agent.episode.length[0] == 0


@pytest.mark.parametrize(("terminated", "error"), [(False, 1 + 0.5 * (3 * 2 + 1) - 3), (True, 1 - 3)])
def test_update_of_real_actions(terminated: bool, error: float) -> None:
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
    """It learns from what it drew; the environment gets what it allows, each time in an array of its own."""
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


FIVE: dict[str, Any] = {"features": Identity.create((3, 2)), "initial_value": 5}


@pytest.mark.parametrize(
    ("environment", "settings", "message"),
    [
        (make_mdp("Boulder"), {}, "vectors of real numbers, but the action space is"),
        (make_mdp("Trashbot"), {}, "leave numbers out by 1"),  # too many tiles
        ((3, 2), FIVE, "initial_value must be 0 for .* Identity, but is 5"),  # the values of states would differ
    ],
)
def test_what_does_not_fit_is_refused(environment: Any, settings: Any, message: str) -> None:
    """The message says what is allowed."""
    with pytest.raises(ValueError, match=message):
        GaussianActorCritic.create(environment, **settings)


def returns_in_trashbot(learning_rate: float) -> float:
    """The return of the mean action after 100 000 steps, on tiles over the wrist and holding."""
    mdp = make_mdp("Trashbot")
    features = TileCoding.create(mdp, tiles=[1, 1, 9, 9, 1, 1, 2])
    settings = {"learning_rate": learning_rate, "discount": 0.98, "initial_value": 1.0}
    agent = GaussianActorCritic.create(mdp, features=features, **settings)
    return float(train(mdp, agent, 100_000, seed=0, evaluate_every=100_000).returns[-1])


@pytest.mark.slow
def test_it_learns_continuous_trashbot() -> None:
    """It delivers the box (3 or more; in a trial in 20 of 20 runs), and not without learning."""
    assert returns_in_trashbot(0.01) > 3
    assert returns_in_trashbot(5e-324) < 3
