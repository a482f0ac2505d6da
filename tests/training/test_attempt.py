"""One episode of training, to be watched."""

import numpy as np

from edugym import GoExplore, make_mdp
from edugym.training.attempt import attempt


def test_attempt_is_an_episode_of_training() -> None:
    """It begins after the steps asked for, and what it does can be replayed."""
    wall = make_mdp("Boulder", height=3)
    actions = attempt(GoExplore.create, wall, after=500)
    rng, state = np.random.default_rng(0), 0
    for action in actions:
        assert not wall.terminal(state)
        state = wall.transition(state, action, rng)
    assert wall.terminal(state) or len(actions) == wall.max_steps
    assert actions == attempt(GoExplore.create, wall, after=500)
