"""Targets that are cut at exploring actions, as in exercise 3: what noise of the rewards does to their values."""

from functools import partial
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.settings import ActionValues, Counter, Table, new
from edugym.agents.strategies import EpsilonGreedy
from edugym.agents.tables import best_value, greedy_action
from edugym.mdp.protocol import Integers, Random, Reals
from edugym_course.lessons.depth.methods import LEARNING_RATE, compare, expected_returns, layouts
from edugym_course.lessons.depth.targets import EPSILON

AFTER, WHEN_TAKEN = "cut where the action is not the best after the update", "cut where it was not when taken"


class Cutting(NamedTuple):
    """Learns at the end of an episode, as deep as its actions were greedy.

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        states: shape (longest,): the state of each step of this episode.
        actions: shape (longest,): the action.
        rewards: shape (longest,): the reward after it.
        explored: shape (longest,): 1 where the action was not the best one when it was taken, else 0.
        length: shape (1,): how many steps this episode has so far.
        when_taken: whether an action counts as exploring if it was not the best one when it was taken, instead of after
            its update.
        learning_rate: α.
        exploration: how actions are chosen.
    """

    Q: ActionValues
    states: Annotated[Integers, Table(("longest",))]
    actions: Annotated[Integers, Table(("longest",))]
    rewards: Annotated[Reals, Table(("longest",))]
    explored: Annotated[Integers, Table(("longest",))]
    length: Counter
    when_taken: bool = False
    learning_rate: float = LEARNING_RATE
    exploration: EpsilonGreedy = EpsilonGreedy(EPSILON)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Store the step; at the end of the episode, hand the rewards back and begin anew."""
        k = self.length[0]
        self.states[k], self.actions[k], self.rewards[k] = state, action, reward
        self.explored[k] = int(self.Q[state, action] < best_value(self.Q, state))
        self.length[0] = k + 1
        if terminated:
            self.hand_back(k + 1)
            self.length[0] = 0

    def hand_back(self, length: int) -> None:
        """Learn from an episode of so many steps, from its last step to its first."""
        G = 0.0
        for k in range(length - 1, -1, -1):
            s, a = self.states[k], self.actions[k]
            G = self.rewards[k] + G
            self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
            best = best_value(self.Q, s)
            if (self.explored[k] == 1) if self.when_taken else (self.Q[s, a] < best):
                G = best

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, *, longest: int = 100, **settings: Any) -> "Cutting":
        """Create an agent with a new Q, for episodes that are not longer than that."""
        return new(cls, environment, settings, longest=longest)


def value_above_return(sigma: float, learning_rate: float = LEARNING_RATE, **how: Any) -> dict[str, Reals]:
    """Return how much more the agent expects at the start than its greedy policy gets, of every run, by the rule.

    Args:
        sigma: the standard deviation of the reward noise.
        learning_rate: α.
        **how: more arguments of `compare`.
    """
    own = {
        label: partial(Cutting.create, when_taken=when_taken, learning_rate=learning_rate)
        for label, when_taken in ((AFTER, False), (WHEN_TAKEN, True))
    }
    results = compare(depths=(), own=own, sigma=sigma, points=1, **how)
    above = {}
    for label in own:
        learned = np.full(len(results.final(label)), np.nan)
        for repetition, agent in results.complete_agents(label).items():
            learned[repetition] = agent.Q[_start(layouts(results)[repetition])].max()
        above[label] = learned - expected_returns(results, label)
    return above


def _start(study: Any) -> int:
    """Return the row of the first day."""
    rng = np.random.default_rng(0)
    return int(np.ravel_multi_index(study.observation(study.initial(rng), rng), study.observation_space.nvec))
