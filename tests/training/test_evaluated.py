"""The policy that is evaluated."""

from typing import Any

import numpy as np
import pytest

from edugym import SARSA, ActorCritic, DoubleQLearning, QLearning
from edugym.training.evaluated import actor


class Contrary(QLearning):
    """An agent of a student's own that takes another action than Q-learning."""

    def greedy(self, state: int, rng: Any) -> int:
        """The worst."""
        return int(self.Q[state].argmin())


@pytest.mark.parametrize(("kind", "table"), [(SARSA, "Q"), (DoubleQLearning, "Q"), (ActorCritic, "preferences")])
def test_agents_whose_best_action_stands_in_a_table_share_machine_code(kind: Any, table: str) -> None:
    """They are of the same types, and what is asked is the agent's own table."""
    agent, other = kind.create((2, 3)), QLearning.create((5, 4))
    shared = actor(agent)
    assert [type(shared), type(shared.agent)] == [type(actor(other)), type(actor(other).agent)]
    assert shared.agent.Q is getattr(agent, table)


def test_another_greedy_is_the_agents_own() -> None:
    """A class that inherits from an agent of the package, but chooses otherwise."""
    agent = Contrary.create((2, 3))
    agent.Q[0] = 3.0, 1.0, 2.0
    assert actor(agent).act(0, np.random.default_rng(0)) == 1
