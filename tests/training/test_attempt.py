"""One episode of training, to be watched."""

from typing import Any

import numpy as np
import pytest

from edugym import SARSA, GoExplore, make_mdp
from edugym.training.attempt import attempt
from tests.compiled.cells import cell
from tests.training.tasks import Stairs


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


Notebook: Any = cell("""
class Notebook(NamedTuple):
    steps: list
    def act(self, state, rng): return 0
    def learn(self, state, action, reward, next_state, terminated, truncated):
        self.steps.append((state, action, reward, next_state, terminated, truncated))
""")["Notebook"]
"""An agent that writes down each step."""
Hidden = type("Hidden", (Stairs,), {"observation": lambda self, state, rng: state + 10, "max_steps": 3})
"""Stairs in which the agent sees ten more than the state, with a limit."""
Cut = type("Cut", (Hidden,), {"max_steps": 2})
"""The limit comes first."""


@pytest.mark.parametrize(
    ("kind", "after", "episodes", "end"),
    [
        (Hidden, 0, 1, (12, 0, 3.0, 13, True, False)),  # an end at the limit is an end
        (Hidden, 1, 2, (12, 0, 3.0, 13, True, False)),
        (Hidden, 3, 2, (12, 0, 3.0, 13, True, False)),
        (Hidden, 4, 3, (12, 0, 3.0, 13, True, False)),
        (Cut, 0, 1, (11, 0, 2.0, 12, False, True)),
    ],
)
def test_the_agent_gets_what_train_would_give(kind: Any, after: int, episodes: int, end: tuple[Any, ...]) -> None:
    """Observations, in whole episodes until there are enough steps, and then in the one that counts."""
    agent, limit = Notebook([]), kind.max_steps
    assert attempt(lambda mdp: agent, kind(), after=after) == [0] * limit
    steps = [(10, 0, 1.0, 11, False, False), (11, 0, 2.0, 12, False, False)]
    assert agent.steps == [*steps[: limit - 1], end] * episodes


def test_what_it_cannot_do_is_refused() -> None:
    """Agents that learn from the next action, and MDPs without a limit."""
    with pytest.raises(ValueError, match=r"make .*off-policy.* SARSA .*next_action"):
        attempt(SARSA.create, make_mdp("Boulder"), after=0)
    with pytest.raises(ValueError, match=r"mdp .*max_steps.* Golf"):
        attempt(GoExplore.create, make_mdp("Golf"), after=0)
