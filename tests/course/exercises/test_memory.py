"""The exercises of lesson 5: what counts as a mistake is one, and the challenge is worth its points."""

from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import repeat
from edugym_course.lessons.memory import exercises
from edugym_course.lessons.memory.secret import SECRET_DOORS, secret_corridor


class Knowing(NamedTuple):
    """An agent that keeps the right notes, and never tries a door for a sign that it could know to be another one."""

    possible: Any
    notes: Any
    place: Any

    def act(self, state: int, rng: np.random.Generator) -> int:
        """Open the noted door, or at a sign a door that is still possible."""
        n = self.possible.shape[1]
        if state == n:
            return int(self.notes[self.place[0]])
        doors = np.flatnonzero(self.possible[state])
        return int(doors[rng.integers(len(doors))])

    def learn(self, state: int, action: int, reward: float, terminated: bool, truncated: bool) -> None:
        """Note the door, and what its sign can mean."""
        n = self.possible.shape[1]
        if state < n:
            if reward > 0:
                self.possible[state] = 0
                self.possible[:, action] = 0
                self.possible[state, action] = 1
            else:
                self.possible[state, action] = 0
        self.notes[self.place[0]] = action
        self.place[0] = 0 if state < n or terminated or truncated else self.place[0] + 1


def knowing(task: object) -> Knowing:
    """Make one."""
    shape = (SECRET_DOORS, SECRET_DOORS)
    return Knowing(np.ones(shape, np.int64), np.zeros(128, np.int64), np.zeros(1, np.int64))


@pytest.mark.slow
def test_the_challenge() -> None:
    """The best average is that of an agent that makes no avoidable error; the baselines are far from it."""
    challenge = exercises.CHALLENGE
    results = repeat(
        secret_corridor, {"knowing": knowing}, challenge.n_steps, repetitions=200, evaluate_every=challenge.n_steps
    )
    mean = results.average("knowing", "training_return").mean()
    assert mean == pytest.approx(challenge.best_average, abs=1.5)
    score = challenge.score(knowing, "Ada")
    assert score.points > 90
    assert score.rows["good play, on average"] == (100.0, 64.0)  # luck can exceed it
    assert score.rows["Q-learning"][1] < 3
    assert score.rows["the lesson's notes"][1] < 3


def test_signs_belong_to_a_seed() -> None:
    """Each door has one sign, the same for the same seed."""
    signs = secret_corridor(7).signs
    assert sorted(signs.tolist()) == [*range(SECRET_DOORS)]
    assert np.array_equal(signs, secret_corridor(7).signs)
    assert not np.array_equal(signs, secret_corridor(8).signs)
