"""The project of lesson 9: Dyna, from a blank file."""

from functools import partial
from typing import Any

import gymnasium
import numpy as np

from edugym.agents.dyna_q import DynaQ
from edugym.agents.q_learning import QLearning
from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Random
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.replay import Learner, Rule, mistakes_of_loops
from edugym_course.lessons.model_based.methods import EPSILON, LEARNING_RATE

N_STEPS, PLANNING_STEPS, DISCOUNT, SWEEPS = 2_000, 10, 0.95, 8

CLEARLY = 300.0
"""How many nats tell that nothing is planned: 445 to 936 where it is so (six seeds), and up to 115 for a program that
draws each pair as often as it was tried, whose rare pairs lag behind ours."""


class Planner:
    """What Dyna comes to: after each step it plans with all that it has seen, until nothing changes.

    Which steps a program imagines cannot be told from its actions. But it imagines so many in a small world without
    chance that its values are soon those of its model.
    """

    def __init__(self, shape: tuple[int, int], discount: float = DISCOUNT, untried: bool = False) -> None:
        """Know nothing; with `untried`, take what was never tried for a step to state 0 that brings nothing."""
        self.Q = np.zeros(shape)
        self.discount = discount
        self.known = np.full(shape, untried)
        self.rewards, self.next_states, self.goes_on = np.zeros(shape), np.zeros(shape, int), np.ones(shape)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Remember the step, and sweep over all that is known."""
        pair = (state, action)
        self.known[pair], self.rewards[pair] = True, reward
        self.next_states[pair], self.goes_on[pair] = next_state, not terminated
        for _ in range(SWEEPS):
            targets = self.rewards + self.discount * self.goes_on * self.Q.max(axis=1)[self.next_states]
            self.Q = np.where(self.known, targets, self.Q)

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        return int(rng.random() * self.Q.shape[1]) if rng.random() < EPSILON else greedy_action(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)


def dyna(shape: tuple[int, int]) -> DynaQ:
    """Make an agent with the settings of the project."""
    return DynaQ.create(shape, planning_steps=PLANNING_STEPS, learning_rate=LEARNING_RATE, discount=DISCOUNT)


def q_learning(shape: tuple[int, int]) -> QLearning:
    """Make an agent that does not plan."""
    return QLearning.create(shape, learning_rate=LEARNING_RATE, discount=DISCOUNT)


RULE = Rule(
    Learner(Planner),
    mistakes_of_loops(Planner)
    | {
        "nothing is planned: are the imagined steps learned from, and enough of them?": Learner(
            q_learning, nats=CLEARLY
        ),
        "pairs are imagined that were never tried: the model knows nothing of them": Learner(
            partial(Planner, untried=True)
        ),
        "γ max_a Q(S', a) is missing in the target": Learner(partial(Planner, discount=0.0)),
    },
    EPSILON,
    otherwise="; the model must keep reward, next state and whether the episode ended, for each state *and* action, and"
    " where it ended an imagined step has no future either",
    noisy=False,
    worlds=8,
    n_steps=500,
)
SHOP = Race(partial(gymnasium.make, "edugym/Supermarket-v0"), N_STEPS, program_of(dyna))


def project_9(answer: Any, seed: int) -> str:
    """Check a program with Dyna."""
    RULE.check(answer, seed)
    return f"Right: it plans with what it has seen. {compare_with_ours(answer, SHOP, seed)}"
