"""Agents of several objectives on Diver: EduGym's loop, and what one would write over MO-Gymnasium's interface."""

from typing import Any

import numpy as np

from benchmarks.measure import Comparison, Contender, Work
from edugym import make_mdp
from edugym.objectives import ChebyshevQLearning, ParetoQLearning, VectorRewardEnv, train_vectors

ALPHA, GAMMA, EPSILON = 0.1, 1.0, 0.1
WEIGHTS = (1.0, 12.0)


def comparisons() -> list[Comparison]:
    """Chebyshev distances, and sets of vectors, whose size changes: these run in the interpreter."""
    closest, sets = Contender("EduGym", chebyshev), Contender("EduGym, in the interpreter", pareto)
    loop = Contender("a loop over MO-Gymnasium's interface", plain_loop)
    unit = "training steps"
    return [
        Comparison("Chebyshev Q-learning on Diver", unit, closest, [loop]),
        Comparison("Pareto Q-learning on Diver", unit, sets, []),
    ]


def chebyshev() -> Work:
    """The package's Q-learning of vectors."""
    return trained(lambda mdp: ChebyshevQLearning.create(mdp, WEIGHTS, learning_rate=ALPHA, discount=GAMMA))


def pareto() -> Work:
    """The package's Q-learning of sets."""
    return trained(lambda mdp: ParetoQLearning.create(mdp, discount=GAMMA))


def trained(create: Any) -> Work:
    """Training of new agents, without points on the way."""
    mdp = make_mdp("Diver")
    train_vectors(mdp, create(mdp), 10_000)  # compiled now, where it can be

    def work(n: int) -> int:
        train_vectors(mdp, create(mdp), n, evaluate_every=n)
        return n

    return work


def plain_loop() -> Work:
    """A table of vectors and an environment that returns vectors. MO-Gymnasium itself adds nothing to a step."""
    env: Any = VectorRewardEnv(make_mdp("Diver"))
    weights = np.array(WEIGHTS)

    def work(n: int) -> int:
        rng = np.random.default_rng(0)
        Q, best, total = np.zeros((env.observation_space.n, env.action_space.n, 2)), np.zeros(2), np.zeros(2)
        seen, _ = env.reset(seed=0)
        for _ in range(n):
            explores = rng.random() < EPSILON
            distances = (weights * np.abs(best - Q[seen])).max(axis=1)
            action = int(rng.integers(len(distances)) if explores else np.argmin(distances))
            after, rewards, terminated, truncated, _ = env.step(action)
            total += rewards
            closest = (weights * np.abs(best - Q[after])).max(axis=1).argmin()
            target = rewards if terminated else rewards + GAMMA * Q[after, closest]
            Q[seen, action] += ALPHA * (target - Q[seen, action])
            seen = after
            if terminated or truncated:
                best, total = np.maximum(best, total), np.zeros(2)
                seen, _ = env.reset()
        return n

    return work
