"""The exercises of lesson 4: what counts as a mistake is one, and the challenge is worth its points."""

from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym.agents.dqn import DQN
from edugym_course.lessons.dimensionality.exercises import CHALLENGE, linear, sizes, targets
from edugym_course.lessons.dimensionality.shuffled import shuffled_board


@pytest.mark.parametrize("kind", ["vectorised", "grid", "rgb"])
def test_every_mistake_in_sizes_is_one(kind: str) -> None:
    """For a board of the check each differs from the right number."""
    for sentence, wrong in sizes.MISTAKES[kind].items():
        assert wrong(6, 4) != sizes.ENTRIES[kind](6, 4), sentence


@pytest.mark.parametrize("seed", [0, 1, 53, 71])
def test_every_mistake_in_the_update_is_one(seed: int) -> None:
    """Over the cases of a check each differs from the right weights, and from those of the other mistakes."""
    rules = {"right": linear.right_update, **linear.UPDATES}
    cases = linear.steps_for(seed)
    made = {why: np.array([rule(case) for case in cases]) for why, rule in rules.items()}
    for one in made:
        for other in made:
            assert one == other or not np.allclose(made[one], made[other]), (one, other)
    assert [(case.terminated, case.truncated) for case in cases[:3]] == [(False, False), (False, True), (True, False)]


@pytest.mark.parametrize("seed", [0, 1, 123])
def test_every_mistake_in_the_value_is_one(seed: int) -> None:
    """Over the cases of a check each differs from the right value, and from the other mistakes."""
    places = [(case, action) for case in linear.steps_for(seed) for action in range(3)]
    made = {why: [rule(*place) for place in places] for why, rule in linear.VALUES.items()}
    made["right"] = [float(case.x @ case.w[:, action]) for case, action in places]
    for one in made:
        for other in made:
            assert one == other or not np.allclose(made[one], made[other]), (one, other)


@pytest.mark.parametrize("seed", [0, 1, 13])
def test_every_mistake_in_the_target_is_one(seed: int) -> None:
    """Over the cases of a check each differs from the right target, and from the other mistakes."""
    agent = DQN.create((2, 3), hidden=2, memory_size=4, batch_size=2, discount=0.5)
    cases = [case for _, case in targets.made_up_memories(agent, targets.drawn_for(agent, seed))]
    made = {why: [float(rule(case)) for case in cases] for why, rule in targets.TARGETS.items()}
    made["right"] = [targets._bootstrapped(case, float(case.old_next.max())) for case in cases]
    for one in made:
        for other in made:
            assert one == other or not np.allclose(made[one], made[other]), (one, other)


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


class Cleaning(NamedTuple):
    """A table of boards without their noise: a row for the two brightest pixels."""

    Q: Any

    def row(self, state: Any) -> int:
        """Return the number of a row for the pixels above one half."""
        row = 0
        for k in range(50):
            if state[k] > 0.5:
                row = (row * 50 + k) % 2_500
        return row

    def act(self, state: Any, rng: np.random.Generator) -> int:
        """Choose an action, ε-greedy."""
        if rng.random() < 0.1:
            return int(rng.random() * 3)
        return int(np.argmax(self.Q[self.row(state)]))

    def learn(self, state: Any, action: int, reward: float, next_state: Any, terminated: bool) -> None:
        """Make the update of Q-learning."""
        target = reward if terminated else reward + 0.9 * np.max(self.Q[self.row(next_state)])
        row = self.row(state)
        self.Q[row, action] += 0.5 * (target - self.Q[row, action])

    @property
    def tabular(self) -> bool:
        """It sees pixels."""
        return False


def cleaning(task: object) -> Cleaning:
    """Make one."""
    return Cleaning(np.zeros((2_500, 3)))


def test_the_challenge() -> None:
    """An agent that takes the noise away first is far ahead of DQN, and short of the optimum while it learns."""
    score = CHALLENGE.score(cleaning, "Ada")
    assert 55 < score.points < 99
    assert score.rows["DQN"][1] < score.rows["your agent"][1]
    assert score.rows["linear in the pixels"][1] < 0.3


def test_what_is_told_of_a_wrong_weight() -> None:
    """Where it started, where it should be, and what it is."""
    x = np.array([1.0, 0.0])
    step = linear.Step(np.zeros((2, 2)), x, 0, 4.0, x, 0, terminated=True, truncated=False, alpha=0.5, gamma=0.5)
    told = linear._told_update(step, np.array([[1.0, 0.0], [0.0, 0.0]]))
    assert told.endswith("w[0, 0] should go from 0 to 2, but is 1")
