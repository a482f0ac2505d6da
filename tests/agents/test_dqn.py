"""DQN: its network against differences and torch's, its memory and targets by hand, and Catch."""

import copy
import math
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import DQN, LinearDecay, ScheduledEpsilonGreedy, make_mdp, train
from edugym.agents.dqn import adam
from edugym.agents.vectors import input_scale
from edugym.mdp.protocol import Reals
from tests.agents.cases import same
from tests.agents.cases import small_dqn as small


def random_agent(seed: int = 0) -> DQN:
    """With weights, biases and a memory of random numbers."""
    agent, rng = small((6, 3)), np.random.default_rng(seed)
    for layers in (agent.weights, agent.target):
        for layer in layers:
            layer[:] = rng.normal(size=layer.shape)
    agent.memory.states[:] = rng.normal(size=(64, 6)) * (rng.random((64, 6)) < 0.6)  # some inputs are 0
    agent.memory.next_states[:] = rng.normal(size=(64, 6))
    agent.memory.actions[:] = rng.integers(3, size=64)
    agent.memory.rewards[:] = rng.normal(size=64)
    agent.memory.terminated[:] = rng.random(64) < 0.3
    return agent


def loss(agent: DQN, rows: list[int]) -> float:
    """The mean of Huber's loss, or without a limit of the squared loss, over some rows of the memory, with NumPy."""

    def network(layers: Any, x: Reals) -> Any:
        hidden = np.maximum(0, x @ layers.first[:-1] + layers.first[-1])
        return hidden @ layers.second[:-1] + layers.second[-1]

    total = 0.0
    for row in rows:
        best = network(agent.target, agent.memory.next_states[row]).max()
        target = agent.memory.rewards[row] + agent.discount * best * (agent.memory.terminated[row] == 0)
        error = abs(network(agent.weights, agent.memory.states[row])[agent.memory.actions[row]] - target)
        c = agent.error_clip
        total += error**2 / 2 if error <= c else c * (error - c / 2)
    return total / len(rows)


@pytest.mark.parametrize(("seed", "error_clip"), [(0, 1.0), (1, 1.0), (0, 0.5), (0, math.inf)])
def test_the_gradient_is_that_of_the_loss(seed: int, error_clip: float) -> None:
    """Every one of its numbers, biases included, against (L(θ + h) - L(θ - h)) / 2h over a batch of four."""
    agent, rows, h = random_agent(seed)._replace(error_clip=error_clip), [3, 14, 15, 9], 1e-6
    for row in rows:
        agent.add_gradient(row)
    for layer, gradient in zip(agent.weights, agent.gradient, strict=True):
        for place in np.ndindex(layer.shape):
            kept, losses = float(layer[place]), []
            for moved in (kept + h, kept - h):
                layer[place] = moved
                losses.append(loss(agent, rows))
            layer[place] = kept
            assert gradient[place] == pytest.approx((losses[0] - losses[1]) / (2 * h), abs=1e-7)


def test_adam_by_hand() -> None:
    """Two steps with gradients 2 and 1, from averages of 0, which are corrected for that."""
    agent, first = small((1, 1), learning_rate=0.01), 5.0
    weights, mean, square = np.array([[first]]), np.zeros((1, 1)), np.zeros((1, 1))
    m = v = 0.0
    for t, slope in ((1, 2.0), (2, 1.0)):
        agent.updates[0], gradient = t, np.array([[slope]])
        adam(weights, gradient, mean, square, agent.adam_rate)
        m, v = 0.9 * m + 0.1 * slope, 0.999 * v + 0.001 * slope**2
        first -= 0.01 * (m / (1 - 0.9**t)) / math.sqrt(v / (1 - 0.999**t))
        assert (weights[0, 0], mean[0, 0], square[0, 0]) == pytest.approx((first, m, v))
        assert gradient[0, 0] == 0.0


def test_the_memory_keeps_the_latest() -> None:
    """Seven transitions in a memory of four: the first three are gone."""
    agent = small((1, 2), memory_size=4)
    for t in range(7):
        agent.learn(np.array([t / 10]), t % 2, float(t), np.array([t / 10 + 0.1]), t == 5)
    assert agent.memory.rewards.tolist() == [4, 5, 6, 3]
    assert agent.memory.states[:, 0] == pytest.approx([0.4, 0.5, 0.6, 0.3])
    assert agent.memory.next_states[:, 0] == pytest.approx([0.5, 0.6, 0.7, 0.4])
    assert agent.memory.actions.tolist() == [0, 1, 0, 1]
    assert agent.memory.terminated.tolist() == [0, 1, 0, 0]


def test_when_it_learns_and_copies() -> None:
    """From step 8 on every 4 steps; every third update is copied to the target network."""
    agent, rng, copied = small((2, 2)), np.random.default_rng(0), []
    for t in range(1, 33):
        state = rng.random(2)
        agent.learn(state, agent.act(state, rng), 1.0, rng.random(2), False)
        assert agent.updates[0] == max(0, t // 4 - 1)
        copied.append(same(agent.weights, agent.target))
    assert [t + 1 for t, equal in enumerate(copied) if equal] == [1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 28, 29, 30, 31]


def test_batches_are_drawn_from_what_is_in_memory() -> None:
    """Evenly from the rows that are filled: with 11 of 64, each about as often."""
    agent, rng = small((1, 2), batch_size=3_000, learn_from=12, learn_every=4), np.random.default_rng(3)
    for _ in range(11):
        agent.learn(np.zeros(1), 0, 0.0, np.zeros(1), False)
    agent.act(np.zeros(1), rng)
    counts = np.bincount(agent.batch, minlength=11)
    assert len(counts) == 11
    assert np.abs(counts - 3_000 / 11).max() < 4 * math.sqrt(3_000 / 11)


def test_every_seed_has_its_own_first_weights() -> None:
    """They come from the agent's random stream once, evenly from ±√(6/n), and the target network is a copy."""
    first = []
    for seed in (0, 0, 1):
        agent, rng = DQN.create((50, 3)), np.random.default_rng(seed)
        agent.act(np.zeros(50), rng)
        first.append(copy.deepcopy(agent.weights))
        agent.act(np.zeros(50), rng)
        assert same(agent.weights, first[-1])
        assert same(agent.weights, agent.target)
        for layer in agent.weights:
            n = len(layer) - 1
            assert not layer[n].any()
            assert np.abs(layer[:n]).max() == pytest.approx(math.sqrt(6 / n), rel=0.05)
            assert layer[:n].std() == pytest.approx(math.sqrt(2 / n), rel=0.1)
    assert same(first[0], first[1])
    assert not same(first[0], first[2])
    agent = small((2, 2))
    agent.weights.second[:] = 3.0  # weights that were put in stay
    agent.act(np.ones(2), np.random.default_rng(0))
    assert (agent.weights.second == 3).all()
    assert same(agent.weights, agent.target)


def test_a_board_is_refused() -> None:
    """In a loop of one's own; `train` flattens it."""
    board = gymnasium.make("edugym/Catch-v0")
    agent, (observation, _) = DQN.create(board), board.reset(seed=0)
    assert observation.shape == (10, 5)
    with pytest.raises(ValueError, match="state must be a flat vector with a number for each input of DQN: flatten"):
        agent.act(observation, np.random.default_rng(0))
    train(gymnasium.make("edugym/Catch-v0"), agent, 20)


def test_inputs_are_scaled_by_the_bounds_of_the_observation_space() -> None:
    """Colours by 255, CartPole's position by 4.8 and its speeds, which have no bounds, not at all."""
    assert pytest.approx(1 / 255) == DQN.create(make_mdp("Catch", observation_type="rgb")).scale
    assert DQN.create(gymnasium.make("CartPole-v1")).scale == pytest.approx([1 / 4.8, 1, 1 / 0.41887903, 1])
    assert (DQN.create(make_mdp("Boulder")).scale == 1).all()
    largest = float(np.finfo(np.float32).max)
    assert input_scale([-largest, -1e9, -2, 0, -np.inf], [largest, 0, 1, 0, 5]).tolist() == [1, 1, 0.5, 1, 1]


def test_defaults_are_the_stated_shares_of_the_papers() -> None:
    """Extended data table 1 of Mnih et al.: 10^6 transitions, a start after 50 000, a copy every 10 000, 0.00025."""
    agent = DQN.create((4, 2))
    memory, batch = len(agent.memory.actions), len(agent.batch)
    assert (memory, agent.learn_from, agent.copy_every) == (1_000_000 / 100, 50_000 / 50, 10_000 / 40)
    assert (batch, agent.learn_every, agent.learning_rate, agent.discount) == (32, 4, 4 * 0.00025, 0.99)


@pytest.mark.slow
def test_it_learns_catch_from_the_grid() -> None:
    """Nearly every ball in 15 000 steps, from 50 numbers; without learning, few."""
    mdp, returns = make_mdp("Catch"), []
    for learning_rate in (1e-3, 5e-324):
        agent = DQN.create(mdp, learning_rate=learning_rate)
        returns.append(train(mdp, agent, 15_000, seed=0, evaluate_every=15_000, evaluation_episodes=50).returns[-1])
    assert returns[0] > 0.9
    assert returns[1] < 0.5


def cart_pole(seed: int, phases: dict[float, int], error_clip: float = math.inf) -> float:
    """The mean greedy return in CartPole at the end, after some steps with each learning rate."""
    env = gymnasium.make("CartPole-v1", disable_env_checker=True)
    settings: dict[str, Any] = {"hidden": 256, "memory_size": 60_000, "learn_every": 1, "copy_every": 50}
    exploration = ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.05, 25_000))
    agent = DQN.create(env, exploration=exploration, error_clip=error_clip, **settings)
    returns = 0.0
    for learning_rate, n in phases.items():
        agent = agent._replace(learning_rate=learning_rate)
        returns = float(train(env, agent, n, seed=seed, evaluate_every=n, evaluation_episodes=50).returns[-1])
    return returns


@pytest.mark.slow
def test_it_learns_cart_pole() -> None:
    """Above 440 of 500 on average at the end (475 ± 12 over ten seeds); with errors cut off at 1 it plays badly."""
    assert np.mean([cart_pole(seed, {3e-4: 30_000, 5e-5: 30_000}) for seed in range(2)]) > 440
    assert cart_pole(0, {3e-4: 20_000}, error_clip=1.0) < 15
