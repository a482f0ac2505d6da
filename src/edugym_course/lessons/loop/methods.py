"""The three players of lesson 0: one that acts at random, one that learns rewards, one that learns returns."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple

from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Random

N_STEPS = 60_000
POINTS = 80
REPETITIONS = 20
LEARNING_RATE = 0.5
EPSILON = 0.1
DISCOUNT = 0.99
MAX_STEPS = 500
OPTIMUM = 95.0
RANDOM, MYOPIC, Q_LEARNING = "random", "Q-learning, γ = 0", f"Q-learning, γ = {DISCOUNT:g}"
ITEMS = {0.85: 1, 0.9: 2, 0.95: 3, 1.0: 3}
"""How many items the best policy collects with some discounts."""
RETURNS = {1: 59.0, 2: 78.0, 3: OPTIMUM}
"""The return of the shortest way with so many items (discount 1)."""


class RandomPlayer(NamedTuple):
    """Acts at random, and learns nothing."""

    n_actions: int

    def act(self, state: int, rng: Random) -> int:
        """Choose an action, each with the same probability."""
        return int(rng.random() * self.n_actions)

    def learn(self, state: int) -> None:
        """Learn nothing."""

    @classmethod
    def create(cls, environment: Any) -> "RandomPlayer":
        """Make a player for an environment."""
        return cls(int(environment.action_space.n))


def play_at_random(env: Any, episodes: int) -> tuple[list[float], list[bool]]:
    """Play with random actions in a Gymnasium environment.

    Returns:
        The sum of the rewards of each episode, and whether it was truncated.
    """
    totals, cut_off = list[float](), list[bool]()
    for _ in range(episodes):
        env.reset()
        total, terminated, truncated = 0.0, False, False
        while not (terminated or truncated):
            _, reward, terminated, truncated, _ = env.step(env.action_space.sample())
            total += float(reward)
        totals.append(total)
        cut_off.append(truncated)
    return totals, cut_off


def learner(
    epsilon: float = EPSILON, learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT
) -> Callable[..., QLearning]:
    """Return a function that makes a Q-learning agent for an environment.

    Args:
        epsilon: ε.
        learning_rate: α.
        discount: γ.
    """
    return partial(QLearning.create, learning_rate=learning_rate, discount=discount, exploration=EpsilonGreedy(epsilon))


def play_and_learn(
    own: Mapping[str, Callable[..., Any]] | None = None,
    *,
    n_steps: int = N_STEPS,
    learning_rate: float = LEARNING_RATE,
    **how: Any,
) -> Results:
    """Train the three: one that learns nothing, one that learns rewards, and one that learns returns.

    Args:
        own: by label, functions that make more agents for the environment.
        n_steps: the training steps of each run.
        learning_rate: α.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    methods = {
        Q_LEARNING: learner(EPSILON, learning_rate),
        MYOPIC: learner(EPSILON, learning_rate, discount=0.0),
        RANDOM: RandomPlayer.create,
        **(own or {}),
    }
    return repeat("Supermarket", methods, n_steps, evaluate_every=max(n_steps // POINTS, 1), **how)
