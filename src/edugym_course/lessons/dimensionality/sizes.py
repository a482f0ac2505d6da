"""How many observations there are, and how many of them occur."""

import math
from typing import Any

import numpy as np

from edugym.envs.catch import Catch
from edugym.exact.model import finite_model
from edugym.mdp.tabular import table_sizes
from edugym_course.lessons.dimensionality.tasks import COLUMNS, ROWS


def new_share(task: Any, n_steps: int = 2_000, seed: int = 0) -> float:
    """Return the share of the observations of random play that were never seen before."""
    rng = np.random.default_rng(seed)
    state = task.initial(rng)
    for _ in range(n_steps):
        task.observation(state, rng)
        state = task.transition(state, int(rng.integers(3)), rng)
        if task.terminal(state):
            state = task.initial(rng)
    return int(task.used) / n_steps


def different_boards(rows: int = ROWS, columns: int = COLUMNS) -> tuple[int, int]:
    """Return the numbers of states in which the ball still falls, and of different boards among them."""
    task, rng = Catch.create(rows, columns), np.random.default_rng(0)
    falling = [state for state in finite_model(task).states if not task.terminal(state)]
    return len(falling), len({np.asarray(task.observation(state, rng)).tobytes() for state in falling})


def rows_of_table(observation_type: str, rows: int = ROWS, columns: int = COLUMNS) -> int:
    """Return the number of rows of a dense table over all observations of a type."""
    space = Catch.create(rows, columns, observation_type).observation_space
    if observation_type == "vectorised":
        return math.prod(table_sizes(space))
    levels = 2 if observation_type == "grid" else 256
    return int(levels ** math.prod(space.shape or ()))


def n_weights(rows: int = ROWS, columns: int = COLUMNS, hidden: int = 64, n_actions: int = 3) -> int:
    """Return the number of weights of a network with one hidden layer, on the grid."""
    return (rows * columns + 1) * hidden + (hidden + 1) * n_actions
