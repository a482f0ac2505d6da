"""The one-step update and its mistakes, each worked out by hand for one transition."""

from typing import Any

import numpy as np
import pytest

from edugym_course.grading.one_step import Q_LEARNING, one_step_update
from edugym_course.grading.updates import Transition

STEP = Transition(state=0, action=1, reward=4.0, next_state=2, next_action=4, terminated=False, truncated=False)
"""From Q(S, A) = 2 to max_a Q(S', a) = 12."""


def after(now: Transition = STEP, row: tuple[float, ...] = (-2.0, 6.0, 12.0, -18.0, 4.0), **how: Any) -> Any:
    """The table after a step at α = 0.25, γ = 0.5 and 2 added to the reward; `row` are the values of the next state."""
    Q = np.array([(1.0, 2.0, 8.0, 0.0, 0.0), (20.0, 0.0, 0.0, 0.0, 0.0), row])
    one_step_update({"Q": Q}, now, **{"learning_rate": 0.25, "discount": 0.5, "extra": 2.0, **how})
    return Q


BY_HAND = [
    ({}, 4.5),  # 2 + 0.25 * (4 + 2 + 0.5 * 12 - 2)
    ({"backup": "none"}, 3.0),
    ({"backup": "mean"}, 3.05),
    ({"backup": "min"}, 0.75),
    ({"backup": "sum"}, 3.25),
    ({"backup": "left"}, 4.0),
    ({"backup": "same action"}, 3.75),
    ({"backup": "next action"}, 3.5),
    ({"backup": "old"}, 3.25),
    ({"backup": "from zero"}, 4.5),
    ({"backup": "first"}, 2.75),
    ({"backup": "last"}, 3.5),
    ({"backup": "two"}, 3.75),
    ({"backup": "index"}, 3.25),
    ({"backup": "table"}, 5.5),
    ({"backup": "size"}, 5.25),
    ({"target": "no reward"}, 3.5),  # 2 + 0.25 * (2 + 6 - 2)
    ({"target": "discounted"}, 4.0),  # 2 + 0.25 * (2 + 2 + 6 - 2)
    ({"target": "all discounted"}, 3.75),  # 2 + 0.25 * (9 - 2)
    ({"target": "undiscounted"}, 6.0),  # 2 + 0.25 * (18 - 2)
    ({"target": "discounted twice"}, 3.75),  # 2 + 0.25 * (6 + 3 - 2)
    ({"target": "minus"}, 1.5),  # 2 + 0.25 * (6 - 6 - 2)
    ({"step": "no old"}, 5.0),  # 2 + 0.25 * 12
    ({"step": "only"}, 3.0),  # 0.25 * 12
    ({"step": "only difference"}, 2.5),  # 0.25 * (12 - 2)
    ({"step": "minus"}, -0.5),  # 2 - 0.25 * (12 - 2)
    ({"step": "weights"}, 9.5),  # 0.25 * 2 + 0.75 * 12
    ({"step": "rate on old"}, 13.5),  # 2 + 12 - 0.25 * 2
    ({"step": "shrunk first"}, 4.5),
    ({"step": "next row"}, 2.0),
]


@pytest.mark.parametrize(("how", "value"), BY_HAND)
def test_a_step_by_hand(how: dict[str, Any], value: float) -> None:
    """The rule, and what is usually taken for its V(S'), its target or its step; without a comment, 3 + V(S') / 8."""
    assert after(**how)[0, 1] == pytest.approx(value)


def test_every_mistake_stands_here() -> None:
    """Those of how an episode ends have a test of their own."""
    assert all(change in [how for how, _ in BY_HAND] or "ends" in change for change in Q_LEARNING.mistakes.values())


@pytest.mark.parametrize(
    ("ends", "terminated", "truncated", "ordinary"),
    [
        ("terminated", 3.0, 4.5, 4.5),
        ("never", 4.5, 4.5, 4.5),
        ("truncated", 3.0, 3.0, 4.5),
        ("inverted", 4.5, 3.0, 3.0),
        ("nothing", 1.5, 4.5, 4.5),
        ("skipped", 2.0, 4.5, 4.5),
    ],
)
def test_the_end_of_an_episode_by_hand(ends: str, terminated: float, truncated: float, ordinary: float) -> None:
    """Without a future the target is 6; with a target of 0 the value becomes 2 - 0.25 * 2."""
    assert after(STEP._replace(terminated=True), ends=ends)[0, 1] == terminated
    assert after(STEP._replace(truncated=True), ends=ends)[0, 1] == truncated
    assert after(ends=ends)[0, 1] == ordinary


def test_mistakes_that_need_another_step() -> None:
    """A state with negative values only, a step that stays in its state, and the row that changes."""
    assert after(row=(-4.0,) * 5)[0, 1] == 2.5
    assert after(row=(-4.0,) * 5, backup="from zero")[0, 1] == 3.0
    stays = STEP._replace(action=2, next_state=0)  # to 8 + 0.25 * (6 + 4 - 8); or Q(S, A) is 6 already
    assert after(stays)[0, 2] == 8.5
    assert after(stays, step="shrunk first")[0, 2] == 8.25
    assert after(step="next row")[2, 1] == 7.5  # 6 + 0.25 * (12 - 6)
