"""Worlds in which a state comes twice in an episode: there it matters whether each step is learned from at once."""

from collections.abc import Mapping
from typing import Any

import gymnasium
from gymnasium import spaces

from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.learners import Learner, Maker
from edugym_course.grading.programs import NAME, run_program, shape_of
from edugym_course.grading.replay import replay
from edugym_course.grading.small_world import SmallWorld
from edugym_course.grading.surprises import Surprises

NUMBERS, WORLDS, N_STEPS = 4, 2, 4_000
"""How many numbers all states share; the worlds, and the steps in each."""


def require_no_mistake(
    program: Any,
    seed: int,
    right: Maker,
    mistakes: Mapping[str, Maker],
    epsilon: float,
    *,
    truncates: bool = True,
) -> None:
    """Refuse a program that makes a mistake which only shows where states come twice in an episode.

    Args:
        program: the program.
        seed: the number from which the world is drawn.
        right: makes the right agent.
        mistakes: makers of agents with the mistakes, by the sentence that tells of each.
        epsilon: how often the program should try a random action.
        truncates: whether episodes are truncated.

    Raises:
        WrongAnswer: its actions fit a mistake better; or it breaks the contract.
    """
    worlds: list[Any] = [
        gymnasium.wrappers.TransformObservation(
            SmallWorld(number, truncates), lambda state: state % NUMBERS, spaces.Discrete(NUMBERS)
        )
        for number in range(WORLDS * seed, WORLDS * (seed + 1))
    ]
    runs = [run_program(program, world, N_STEPS, seed).steps for world in worlds]
    usual, *others = (
        Surprises.of(replay(runs, Learner(make), shape_of(worlds[0]), epsilon)) for make in (right, *mistakes.values())
    )
    sentence, wrong = max(zip(mistakes, others, strict=True), key=lambda one: float(one[1].logs.sum()))
    if wrong.explains_better_than(usual):
        raise WrongAnswer(
            f"where a state comes twice in an episode, the actions of {NAME} fit a usual mistake: {sentence}"
        )
