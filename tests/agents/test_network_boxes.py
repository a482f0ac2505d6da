"""The network with hindsight, written a second time with NumPy: to 1e-12 it learns the same from random episodes."""

from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import FinalGoal, FutureGoals, HindsightDQN, NoHindsight
from edugym.mdp.protocol import Reals

SIZE, N_ACTIONS, MEMORY, EVERY, FROM, COPIED, RATE, GAMMA, CLIP = 2, 3, 60, 2, 9, 3, 0.01, 0.9, 0.4


class Transition(NamedTuple):
    """What happened, with the goal as the second half of both states."""

    state: Reals
    action: int
    reward: float
    next_state: Reals
    terminated: bool

    def for_goal(self, goal: Reals) -> "Transition":
        """As if this had been the goal."""
        state, then = (np.append(seen[:SIZE], goal) for seen in (self.state, self.next_state))
        reached = bool((then[:SIZE] == goal).all())
        return Transition(state, self.action, 2.0 if reached else -1.0, then, reached)


class Reference:
    """DQN: the latest transitions, two layers of weights, those of the target, and the averages of Adam."""

    def __init__(self, weights: list[Reals]) -> None:
        """With these weights."""
        self.weights, self.target = [layer.copy() for layer in weights], [layer.copy() for layer in weights]
        self.m, self.v = ([np.zeros_like(layer) for layer in weights] for _ in range(2))
        self.memory: dict[int, Transition] = {}
        self.count = self.updates = 0

    def remember(self, transition: Transition) -> None:
        """The oldest goes."""
        self.memory[self.count % MEMORY] = transition
        self.count += 1

    def learn(self, batch: list[int]) -> None:
        """A step of Adam down the gradient of Huber's loss."""
        gradients = [np.zeros_like(layer) for layer in self.weights]
        for one in (self.memory[row] for row in batch):
            future = values(self.target, one.next_state)[1].max()
            hidden, Q = values(self.weights, one.state)
            error = Q[one.action] - one.reward - GAMMA * future * (not one.terminated)
            slope = np.eye(N_ACTIONS)[one.action] * np.clip(error, -CLIP, CLIP) / len(batch)
            gradients[1] += np.outer(np.append(hidden, 1), slope)
            gradients[0] += np.outer(np.append(one.state, 1), (self.weights[1][:-1] @ slope) * (hidden > 0))
        self.updates += 1
        correction = np.sqrt(1 - 0.999**self.updates) / (1 - 0.9**self.updates)
        for layer, gradient, m, v in zip(self.weights, gradients, self.m, self.v, strict=True):
            m[:], v[:] = 0.9 * m + 0.1 * gradient, 0.999 * v + 0.001 * gradient**2
            layer -= RATE * correction * m / (np.sqrt(v) + 1e-8)
        if self.updates % COPIED == 0:
            self.target = [layer.copy() for layer in self.weights]


def values(weights: list[Reals], state: Reals) -> tuple[Reals, Reals]:
    """The hidden units and the action values."""
    hidden = np.maximum(0, np.append(state, 1) @ weights[0])
    return hidden, np.append(hidden, 1) @ weights[1]


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("hindsight", [NoHindsight(), FinalGoal(), FutureGoals(3)])
def test_the_network_is_its_box(hindsight: Any, seed: int) -> None:
    """Its weights, over some sixty episodes that achieve goals now and then, and more than the memory holds."""
    how: dict[str, Any] = {"hidden": 5, "memory_size": MEMORY, "batch_size": 4, "discount": GAMMA, "error_clip": CLIP}
    how |= {"learning_rate": RATE, "learn_every": EVERY, "learn_from": FROM, "copy_every": COPIED}
    agent = HindsightDQN.create((2 * SIZE, N_ACTIONS), goal_size=SIZE, hindsight=hindsight, reward_at_goal=2.0, **how)
    rng, world = np.random.default_rng(seed), np.random.default_rng(seed + 100)
    dqn, reference = agent.dqn, Reference([*agent.dqn.weights])
    for episode in range(60):
        goal, achieved = world.integers(0, 2, (2, SIZE)).astype(float)
        steps, draws = [], []
        for t in range(5):
            state, then = np.append(achieved, goal), world.integers(0, 2, SIZE).astype(float)
            agent.act(state, rng)
            if episode == t == 0:
                reference = Reference([*dqn.weights])
            ends, action, reward = bool(world.random() < 0.2), int(world.integers(N_ACTIONS)), world.normal()
            steps.append(Transition(state, action, reward, np.append(then, goal), ends))
            draws.append(agent.draws[t].copy())
            agent.learn(*steps[-1], t == 4 and not ends)
            reference.remember(steps[-1])
            if reference.count >= FROM and reference.count % EVERY == 0:
                reference.learn(dqn.batch.tolist())
            achieved = then
            if ends:
                break
        wanted = len(steps) * hindsight.goals
        for copy in range(wanted + wanted % EVERY):
            t, k = copy % len(steps), copy // len(steps) % hindsight.goals
            later = steps[t:] if isinstance(hindsight, FutureGoals) else steps[-1:]
            reference.remember(steps[t].for_goal(later[int(draws[t][k] * len(later))].next_state[:SIZE]))
    assert reference.updates == dqn.updates[0] > 80
    for mine, expected in zip((*dqn.weights, *dqn.target), (*reference.weights, *reference.target), strict=True):
        assert np.abs(mine - expected).max() < 1e-12
