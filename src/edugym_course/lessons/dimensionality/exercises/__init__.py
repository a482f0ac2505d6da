"""The exercises of lesson 4: the size of a table, semi-gradient Q-learning, and the target and memory of DQN."""

from functools import partial
from types import MappingProxyType

from edugym.agents.linear_q_learning import LinearQLearning
from edugym_course.grading.challenge import Challenge
from edugym_course.lessons.dimensionality.exercises.linear import exercise_2
from edugym_course.lessons.dimensionality.exercises.sizes import exercise_1
from edugym_course.lessons.dimensionality.exercises.targets import exercise_3
from edugym_course.lessons.dimensionality.methods import DISCOUNT, network
from edugym_course.lessons.dimensionality.shuffled import shuffled_board

__all__ = ["CHALLENGE", "exercise_1", "exercise_2", "exercise_3"]

CHALLENGE = Challenge(
    environment=shuffled_board,
    parameters=MappingProxyType({}),
    n_steps=8_000,
    baselines=MappingProxyType(
        {"DQN": network(), "linear in the pixels": partial(LinearQLearning.create, discount=DISCOUNT)}
    ),
    optimum=1.0,
    best_average=1.0,
)
"""The open challenge: the average greedy return within 8 000 steps, on a noisy board whose pixels are shuffled.

1 is that of an agent that knows the task from the start.
"""
