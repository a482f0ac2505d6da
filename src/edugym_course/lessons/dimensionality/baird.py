"""Baird's counterexample (Sutton and Barto, section 11.2): off-policy, the weights of linear features grow for ever.

The book's example is prediction: one vector of weights, importance ratios and α = 0.01. This is its form for
Q-learning, which the section mentions: each action has weights of its own, there are no ratios, and α = 0.05.
"""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.agents.features import Identity
from edugym.agents.linear_q_learning import LinearQLearning
from edugym.agents.semi_gradient_sarsa import SemiGradientSARSA
from edugym.checks.contract import is_on_policy
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.sheet import Sheet
from edugym.mdp.protocol import Random, Reals

SOLID = 1


class Baird(NamedTuple):
    """Seven states, observed as their features. There is no reward, so all values are 0.

    Action 0 (dashed) leads to any of the states 0 to 5, action 1 (solid) to state 6.
    """

    max_steps: int = 1_000

    def initial(self, rng: Random) -> int:
        """Any state."""
        return int(rng.random() * 7)

    def transition(self, state: int, action: int, rng: Random) -> int:
        """As the action says, wherever it starts."""
        return 6 if action == SOLID else int(rng.random() * 6)

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """Always 0."""
        return 0.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Random) -> Any:
        """The values are 2w_i + w_8 for the states 0 to 5, and w_7 + 2w_8 for state 6."""
        x = np.zeros(8)
        x[state] = 1.0 if state == 6 else 2.0
        x[7] = 2.0 if state == 6 else 1.0
        return x

    @property
    def observation_space(self) -> spaces.Box:
        """Eight features."""
        return spaces.Box(0.0, 2.0, (8,), np.float64)

    @property
    def action_space(self) -> spaces.Discrete:
        """Dashed and solid."""
        return spaces.Discrete(2)


class DashedMostly(NamedTuple):
    """Dashed with probability 6/7, solid with 1/7: each state comes as often as any other."""

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """Whatever the values are."""
        return 0 if rng.random() < 6 / 7 else SOLID


def weights_of_solid(
    kind: Any = LinearQLearning, exploration: Any = None, n_steps: int = 1_000, seed: int = 0
) -> Reals:
    """Return the weights w_1 to w_8 of the solid action after 0, 1, ... steps, learned with α = 0.05 and γ = 0.99.

    They start at (1, 1, 1, 1, 1, 1, 10, 1), and those of the dashed action at 0.

    Args:
        kind: `LinearQLearning`, which learns the value of the best action, or `SemiGradientSARSA`, on-policy.
        exploration: the behaviour; by default `DashedMostly`.
        n_steps: how many steps.
        seed: of the steps.

    Returns:
        Shape (n_steps + 1, 8).
    """
    mdp, rng = Baird(), np.random.default_rng(seed)
    settings: dict[str, Any] = {"learning_rate": 0.05, "discount": 0.99, "exploration": exploration or DashedMostly()}
    agent = kind.create(mdp, features=Identity.create(mdp, 0.0), **settings)
    agent.weights[:8, SOLID] = [1, 1, 1, 1, 1, 1, 10, 1]
    weights = [agent.weights[:8, SOLID].copy()]
    state = mdp.initial(rng)
    x = mdp.observation(state, rng)
    action = agent.act(x, rng)
    on_policy = is_on_policy(agent)
    for _ in range(n_steps):
        state = mdp.transition(state, action, rng)
        next_x = mdp.observation(state, rng)
        next_action = agent.act(next_x, rng)
        arrived: tuple[Any, ...] = (next_x, next_action) if on_policy else (next_x,)
        agent.learn(x, action, 0.0, *arrived, False)
        x, action = next_x, next_action
        weights.append(agent.weights[:8, SOLID].copy())
    return np.array(weights)


def growth_of_weights(weights: Reals) -> float:
    """Return how many times as large the largest weight is in the end as at the start."""
    return float(np.abs(weights[-1]).max() / np.abs(weights[0]).max())


def bairds_weights(n_steps: int = 1_000) -> Sheet:
    """Return the weights over the steps: the same behaviour and features, off-policy and on-policy."""
    panels = []
    for kind, title in ((LinearQLearning, "off-policy (Q-learning)"), (SemiGradientSARSA, "on-policy (SARSA)")):
        weights = weights_of_solid(kind, n_steps=n_steps)
        lines = {"w₁ to w₆ (mean)": weights[:, :6].mean(axis=1), "w₇": weights[:, 6], "w₈": weights[:, 7]}
        panels.append(Lines(np.arange(n_steps + 1.0), lines, title, "steps", "weights of the solid action"))
    return Sheet("baird", [panels])
