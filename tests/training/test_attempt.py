"""One episode of training, to be watched."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym import SARSA, GoExplore, make_mdp
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


class Notebook(NamedTuple):
    """An agent that writes down each step."""

    steps: list[tuple[Any, ...]]

    def act(self, state: Any, rng: Any) -> int:
        """Always the action 0."""
        return 0

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Write it down."""
        self.steps.append((state, action, reward, next_state, terminated, truncated))


class Steps(NamedTuple):
    """The state counts steps up to 2, which is terminal; the agent sees ten more."""

    max_steps: int

    @property
    def observation_space(self) -> spaces.Discrete:
        """10, 11 and 12 occur."""
        return spaces.Discrete(13)

    @property
    def action_space(self) -> spaces.Discrete:
        """One action."""
        return spaces.Discrete(1)

    def initial(self, rng: Any) -> int:
        """No step."""
        return 0

    def transition(self, state: int, action: int, rng: Any) -> int:
        """One step more."""
        return state + 1

    def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
        """Three for the first step, five for the second."""
        return float(3 * next_state - state)

    def terminal(self, state: int) -> bool:
        """After two steps."""
        return state == 2

    def observation(self, state: int, rng: Any) -> int:
        """Ten more."""
        return state + 10


@pytest.mark.parametrize(
    ("max_steps", "steps"),
    [(1, [(10, 0, 3.0, 11, False, True)]), (2, [(10, 0, 3.0, 11, False, False), (11, 0, 5.0, 12, True, False)])],
)
def test_the_agent_gets_what_train_would_give(max_steps: int, steps: list[tuple[Any, ...]]) -> None:
    """Observations, not states; and the last step before the limit is not truncated where it is terminal."""
    agent = Notebook([])
    assert attempt(lambda mdp: agent, Steps(max_steps), after=0) == [0] * max_steps
    assert agent.steps == steps


@pytest.mark.parametrize(("after", "episodes"), [(0, 1), (1, 2), (2, 2), (3, 3), (4, 3), (5, 4)])
def test_how_much_is_trained_before(after: int, episodes: int) -> None:
    """Whole episodes of two steps, until there are as many steps as asked for; then comes the one that counts."""
    agent = Notebook([])
    assert attempt(lambda mdp: agent, Steps(2), after=after) == [0, 0]
    assert len(agent.steps) == 2 * episodes


def test_what_it_cannot_do_is_refused() -> None:
    """Agents that learn from the next action, and MDPs without a limit."""
    with pytest.raises(ValueError, match="make must give an off-policy agent, but learn of SARSA takes `next_action`"):
        attempt(SARSA.create, make_mdp("Boulder"), after=0)
    with pytest.raises(ValueError, match="mdp must have a step limit, `max_steps`, but Golf has none"):
        attempt(GoExplore.create, make_mdp("Golf"), after=0)
