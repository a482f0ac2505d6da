"""Agents that are right, but whose methods also change a table that is not theirs to change."""

from typing import Any

import numpy as np
import pytest

from edugym_course.grading import WrongAnswer
from edugym_course.lessons.continuous_actions import exercises as continuous_actions
from edugym_course.lessons.depth import exercises as depth
from edugym_course.lessons.dimensionality import exercises as dimensionality
from edugym_course.lessons.exploration import exercises as exploration
from edugym_course.lessons.loop import exercises as loop
from edugym_course.lessons.model_based import exercises as model_based
from edugym_course.lessons.on_off_policy import exercises as on_off_policy
from edugym_course.lessons.signal import exercises as signal
from edugym_course.lessons.stochasticity import exercises as stochasticity
from tests.course.exercises.test_places import Exercise, right_answer

CHANGES: list[tuple[Exercise, tuple[str, int, str], str, list[str]]] = [
    (loop.exercise_3, ("00_loop", 3, "MyAgent"), "learn", ["Q"]),
    (exploration.exercise_3, ("01_exploration", 3, "MyExplorer"), "act learn", ["Q", "visits", "tries"]),
    (on_off_policy.exercise_3, ("02_on_off_policy", 3, "TwoPolicies"), "learn", ["Q"]),
    (depth.exercise_3, ("03_depth", 3, "MyAgent"), "hand_back", ["Q"]),
    (dimensionality.exercise_2, ("04_dimensionality", 2, "MyAgent"), "learn", ["w"]),
    (signal.exercise_3, ("06_signal", 3, "Listener"), "act", ["last"]),
    (continuous_actions.exercise_3, ("07_continuous_actions", 3, "MyREINFORCE"), "look", ["preferences", "V"]),
    (continuous_actions.exercise_3, ("07_continuous_actions", 3, "MyREINFORCE"), "update", ["preferences", "V"]),
    (stochasticity.exercise_3, ("08_stochasticity", 3, "TwoWeights"), "learn", ["Q"]),
    (
        model_based.exercise_2,
        ("09_model_based", 2, "DynaPlus"),
        "imagine",
        ["Q", "rewards", "next_states", "ends", "last", "clock", "seen", "n_seen"],
    ),
    (
        model_based.exercise_3,
        ("09_model_based", 3, "MyRMax"),
        "learn sweep",
        ["Q", "known", "rewards", "next_states", "ends"],
    ),
]


@pytest.mark.parametrize(
    ("exercise", "place", "method", "table"),
    [
        pytest.param(exercise, place, method, table, id=f"{place[2]}-{method}-{table}")
        for exercise, place, methods, tables in CHANGES
        for method in methods.split()
        for table in tables
    ],
)
def test_no_table_changes_unnoticed(exercise: Exercise, place: tuple[str, int, str], method: str, table: str) -> None:
    """Each time it is called, the method adds 1 to one entry, and each time to another one."""
    right: Any = right_answer(*place)
    calls = 0

    def changed(self: Any, *arguments: Any, **named: Any) -> Any:
        nonlocal calls
        returned, values = getattr(right, method)(self, *arguments, **named), getattr(self, table)
        calls += 1
        values.flat[7 * calls % np.size(values)] += 1
        return returned

    with pytest.raises(WrongAnswer):
        exercise(type(place[2], (right,), {"__slots__": (), method: changed}), 0)
