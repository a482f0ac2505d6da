"""Observations as vectors of numbers, for agents without a table: how long they are, and how large their numbers.

An array is taken row after row. A whole number becomes a 1 among zeros, as Gymnasium's `FlattenObservation` has it, so
that no number counts as larger than another; several whole numbers become one such part after the other.
"""

from typing import Any

import numpy as np
from gymnasium import spaces

from edugym.checks.interfaces import SHAPED
from edugym.mdp.protocol import Reals
from edugym.mdp.task import checked_shape, is_shape, task_of, vector_length

UNBOUNDED = 1e9
"""A bound of this size or more counts as none: many environments give the largest float32 for infinity."""


def vector_size(environment: Any, actions: type[spaces.Space[Any]] = spaces.Discrete) -> tuple[int, int]:
    """How many numbers an agent sees in an environment, and how many actions (or, of reals, numbers in one) it has.

    Args:
        environment: an MDP, a Gymnasium environment, or (n_inputs, n_actions) itself.
        actions: the kind of actions that the agent can take: `Discrete` or `Box`.

    Raises:
        ValueError: it is no environment, its observations are not numbers, or its actions are of another kind.
    """
    if is_shape(environment):
        return checked_shape(environment, "(n_inputs, n_actions)")
    task = task_of(environment, allowed=SHAPED)
    space = task.played.action_space
    if isinstance(space, actions):
        if isinstance(space, spaces.Discrete) and space.start == 0:
            return task.n_inputs, int(space.n)
        if isinstance(space, spaces.Box) and len(space.shape) == 1:
            return task.n_inputs, space.shape[0]
    needed = "the actions 0, 1, ..." if actions is spaces.Discrete else "actions that are vectors of real numbers"
    raise ValueError(f"this agent needs {needed}, but the action space is {space}")


def vector_bounds(environment: Any) -> tuple[Reals, Reals]:
    """The lowest and highest values of the numbers that an agent sees, shape (n_inputs,) each; they may be infinite.

    Those of whole numbers, which become ones and zeros, and of a mere shape are 0 and 1.
    """
    space: Any = getattr(environment, "observation_space", None)
    if isinstance(space, spaces.Box):
        return np.ravel(space.low).astype(float), np.ravel(space.high).astype(float)
    n_inputs = environment[0] if is_shape(environment) else vector_length(space)
    return np.zeros(n_inputs), np.ones(n_inputs)


def input_scale(low: Any, high: Any) -> Reals:
    """What the inputs of a network are multiplied by, given their bounds as vectors: 1 over the largest number allowed.

    Where there are no bounds, or nothing but 0 is allowed, it is 1.
    """
    largest = np.maximum(np.abs(np.asarray(low, float)), np.abs(np.asarray(high, float)))
    bounded = (largest > 0) & (largest < UNBOUNDED)
    scale: Reals = 1 / np.where(bounded, largest, 1.0)
    return scale
