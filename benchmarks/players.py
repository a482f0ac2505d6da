"""Two who learn against each other in soccer: EduGym's loop, and what one would write over PettingZoo's interface."""

from typing import Any

import numpy as np

from benchmarks.measure import Comparison, Contender, Work
from edugym import QLearning
from edugym.adapters.parallel_env import GameEnv
from edugym.games import MinimaxQ, Soccer, table_shape, train_players

ALPHA, GAMMA, EPSILON = 0.1, 0.9, 0.1


def comparisons() -> list[Comparison]:
    """Q-learning against itself, and minimax Q-learning, which solves a matrix game at every step."""
    alone, safe = Contender("EduGym", two_q_learners), Contender("EduGym", two_minimax_q_learners)
    loop = Contender("a loop over PettingZoo's interface", plain_loop)
    unit = "training steps"
    return [
        Comparison("two Q-learners in soccer", unit, alone, [loop], None, 100),
        Comparison("two minimax Q-learners in soccer", unit, safe, [loop]),
    ]


def two_q_learners() -> Work:
    """Two of the package's Q-learners, without points on the way."""
    shape = table_shape(Soccer.create(), 0)
    return pairs(lambda player: QLearning.create(shape, learning_rate=ALPHA, discount=GAMMA))


def two_minimax_q_learners() -> Work:
    """Two of the package's minimax Q-learners."""
    game = Soccer.create()
    return pairs(lambda player: MinimaxQ.create(game, player))


def pairs(create: Any) -> Work:
    """Training of new pairs of players."""
    game = Soccer.create()
    train_players(game, (create(0), create(1)), 10_000)  # compiled now

    def work(n: int) -> int:
        train_players(game, (create(0), create(1)), n, evaluate_every=n)
        return n

    return work


def plain_loop() -> Work:
    """Two tables and a parallel environment, as a tutorial has them. PettingZoo itself adds nothing to a step."""
    env: Any = GameEnv(Soccer.create())
    names = env.possible_agents

    def work(n: int) -> int:
        rng = np.random.default_rng(0)
        tables = {name: np.zeros((env.observation_space(name).n, env.action_space(name).n)) for name in names}
        seen, _ = env.reset(seed=0)
        for _ in range(n):
            actions = {}
            for name in names:
                Q = tables[name]
                explores = rng.random() < EPSILON
                actions[name] = int(rng.integers(Q.shape[1]) if explores else np.argmax(Q[seen[name]]))
            after, rewards, terminations, _, _ = env.step(actions)
            for name in names:
                Q = tables[name]
                target = rewards[name] if terminations[name] else rewards[name] + GAMMA * Q[after[name]].max()
                Q[seen[name], actions[name]] += ALPHA * (target - Q[seen[name], actions[name]])
            seen = after if env.agents else env.reset()[0]
        return n

    return work
