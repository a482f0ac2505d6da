"""The exercises of lesson 4: what counts as a mistake is one, and the challenge is worth its points."""

import numpy as np

from edugym_course.lessons.dimensionality.exercises import linear
from edugym_course.lessons.dimensionality.shuffled import shuffled_board


def test_pixels_are_shuffled() -> None:
    """The same pixels in an order of the seed's own, in every step the same one."""
    task, rng = shuffled_board(7), np.random.default_rng(0)
    state = task.initial(rng)
    one = task.observation(state, rng)
    assert one.shape == (50,)
    assert sorted(task.order.tolist()) == [*range(50)]
    assert (task.order == shuffled_board(7).order).all()
    assert (task.order != shuffled_board(8).order).any()
    bright = {int(task.order[k]) for k in np.flatnonzero(one > 0.5)}
    assert bright == {state.ball_x, 45 + state.paddle_x}


def test_what_is_told_of_a_wrong_weight() -> None:
    """Where it started, where it should be, and what it is."""
    x = np.array([1.0, 0.0])
    step = linear.Step(np.zeros((2, 2)), x, 0, 4.0, x, 0, terminated=True, truncated=False, alpha=0.5, gamma=0.5)
    told = linear._told_update(step, np.array([[1.0, 0.0], [0.0, 0.0]]))
    assert told.endswith("w[0, 0] should go from 0 to 2, but is 1")
