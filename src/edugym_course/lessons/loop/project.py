"""The project of lesson 0: Q-learning and its loop, from a blank file."""

from dataclasses import dataclass, field
from functools import partial
from typing import Any

import gymnasium
import numpy as np

from edugym.agents.expected_sarsa import ExpectedSARSA
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.agents.tables import epsilon_greedy_action, greedy_action
from edugym.mdp.protocol import Integers, Reals
from edugym_course.grading.again import require_no_mistake
from edugym_course.grading.close_calls import require_close_calls
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.learners import (
    Learner,
    mistakes_of_loops,
    other_settings,
    other_tables,
    too_early,
    too_late,
)
from edugym_course.grading.rule import Rule
from edugym_course.lessons.loop.methods import DISCOUNT, EPSILON, LEARNING_RATE

N_STEPS = 10_000


def agent(
    shape: tuple[int, int], learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT, first: float = 0.0
) -> QLearning:
    """Make an agent with the settings of the project."""
    return QLearning.create(shape, learning_rate=learning_rate, discount=discount, initial_value=first)


class _LearnsTheMean(EpsilonGreedy):
    """Acts by ε-greedy, and takes the plain mean over the actions for the value of a state."""

    def expected_value(self, Q: Reals, state: int) -> float:
        """Return the mean."""
        return float(Q[state].mean())


def agent_of_the_mean(shape: tuple[int, int], weighs: Any = _LearnsTheMean) -> ExpectedSARSA:
    """Make an agent whose target has the mean over the next actions, by default the plain one."""
    settings = {"learning_rate": LEARNING_RATE, "discount": DISCOUNT}
    return ExpectedSARSA.create(shape, **settings, exploration=weighs(EPSILON))


@dataclass
class _Slips:
    """Updates like Q-learning, but for one thing.

    Attributes:
        Q: the table, of shape (n_states, n_actions).
        adds_up: whether the old value is not subtracted from the target.
        subtracts: whether the value moves away from the target.
        place: whether the number of the best action stands in the place of its value.
        grows: whether all of the target is added to a half of the old value.
        only_best: whether nothing is learned from an action that does not look best.
        counts: whether the learning rate is one over the number of updates of a state and action, not 0.5.
        same_action: whether the next state has the value of the action just taken, not the highest.
        discounts_all: whether the reward is discounted, too, where the episode goes on.
        forgets: whether the old value is not added to the step.
        whole_row: whether the values of all actions move.
        of_the_best: whether the value of the action that looks best moves, not that of the one that was taken.
        next_action: whether it has that of the action that is taken next; after a cut nobody sees that one, so it has
            the highest there.
    """

    Q: Reals
    adds_up: bool = False
    subtracts: bool = False
    place: bool = False
    grows: bool = False
    only_best: bool = False
    counts: bool = False
    same_action: bool = False
    discounts_all: bool = False
    forgets: bool = False
    whole_row: bool = False
    of_the_best: bool = False
    next_action: bool = False
    _updates: Integers = field(init=False)
    _waiting: tuple[int, int, float, int] | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        """Begin to count."""
        self._updates = np.zeros(self.Q.shape, np.int64)

    def act(self, state: int, rng: np.random.Generator) -> int:
        """Choose an action by ε-greedy."""
        return int(epsilon_greedy_action(self.Q, state, EPSILON, rng))

    def greedy(self, state: int, rng: np.random.Generator) -> int:
        """Choose the action with the highest value."""
        return int(greedy_action(self.Q, state, rng))

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Update one value."""
        if self._waiting:
            before, taken, earlier, reached = self._waiting
            self._move(before, taken, earlier + DISCOUNT * float(self.Q[reached, action]))
        self._waiting = None
        row = self.Q[next_state]
        if self.next_action and not (terminated or truncated):
            self._waiting = state, action, reward, next_state
        else:
            future = row[action] if self.same_action else row.argmax() if self.place else row.max()
            moved = int(self.Q[state].argmax()) if self.of_the_best else action
            earned = DISCOUNT * reward if self.discounts_all and not terminated else reward
            target = earned + (0.0 if terminated else DISCOUNT * float(future))
            self._move(state, moved, target)

    def _move(self, state: int, action: int, target: float) -> None:
        if self.only_best and self.Q[state, action] < self.Q[state].max():
            return
        self._updates[state, action] += 1
        rate = 1 / self._updates[state, action] if self.counts else LEARNING_RATE
        rate = -rate if self.subtracts else 1.0 if self.grows else rate
        old = float(self.Q[state, action])
        moved = slice(None) if self.whole_row else action
        less = 0.0 if self.adds_up else LEARNING_RATE * old if self.grows else old
        self.Q[state, moved] = (0.0 if self.forgets else old) + rate * (target - less)


def slips(shape: tuple[int, int], **how: Any) -> _Slips:
    """Make an agent that makes a mistake in its update."""
    return _Slips(np.zeros(shape), **how)


RULE = Rule(
    Learner(agent),
    mistakes_of_loops(agent)
    | too_early(agent)
    | {
        "γ max_a Q(S', a), the value of the next state, is missing in the target": Learner(
            partial(agent, discount=0.0)
        ),
        "the mean over the actions of the next state stands where the maximum should": Learner(agent_of_the_mean),
        "the mean over the actions of ε-greedy stands where the maximum should: that is expected SARSA": Learner(
            partial(agent_of_the_mean, weighs=EpsilonGreedy)
        ),
        "Q(S', A'), the value of the action that is taken next, stands where the maximum should": Learner(
            partial(slips, next_action=True), leaves=0.5
        ),
        "the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)": Learner(
            agent, lambda step, before: step._replace(next_state=step.state)
        ),
        "the old value is lost, as with a learning rate of 1: it should move halfway to the target": Learner(
            partial(agent, learning_rate=1.0)
        ),
        "− Q(S, A) is missing in the brackets, so the values grow and grow": Learner(partial(slips, adds_up=True)),
        "a minus sign stands where a plus should, so that the values move away from their targets: the update is"
        " Q(S, A) + α [target − Q(S, A)]": Learner(partial(slips, subtracts=True)),
        "the brackets are missing, and α multiplies the target alone: it is α [target − Q(S, A)]": Learner(
            partial(slips, forgets=True, adds_up=True)
        ),
        "the target is not multiplied by α: it is Q(S, A) + α [target − Q(S, A)]": Learner(partial(slips, grows=True)),
        "the target has the *number* of the best next action, as `argmax` gives it; it should be its value, `max`": (
            Learner(partial(slips, place=True))
        ),
        "nothing is learned from random actions: a step teaches something whatever chose its action": Learner(
            partial(slips, only_best=True)
        ),
        "the old value is lost: `=` stands where `+=` should, so that Q(S, A) + is missing before the step": Learner(
            partial(slips, forgets=True)
        ),
        "in its table all actions of a state are worth the same, or it does not look there: does the update change the"
        " value of the action taken, and no other, are the actions chosen by the values with probability 1 − ε, and is"
        " the table made once, and not in each episode?": Learner(partial(slips, whole_row=True)),
        "the last reward of an episode is lost: after a terminated step the target is R, and not 0": Learner(
            agent, lambda step, before: step._replace(reward=0.0) if step.terminated else step
        ),
        "the learning rate falls with the number of updates, and it is 0.5 in the text": Learner(
            partial(slips, counts=True)
        ),
        "the value of the action that looks best moves, and it should be that of the action that was taken": Learner(
            partial(slips, of_the_best=True)
        ),
        "Q(S', A), the value of the *same* action, stands where the maximum over all actions should": Learner(
            partial(slips, same_action=True)
        ),
    }
    | other_settings(
        agent,
        discount=("γ", DISCOUNT, (0.95, 0.9, 0.5)),
        learning_rate=("α", LEARNING_RATE, (0.1, 0.25, 0.75)),
    )
    | other_tables(agent),
    EPSILON,
    otherwise="; the target has max_a Q(S', a), the *largest* value of S', and not that of an action that is drawn",
)
CLOSE_MISTAKES = {
    "γ is larger than 0.99; is it missing?": Learner(partial(agent, discount=1.0)),
    "γ is smaller than 0.99": Learner(partial(agent, discount=0.97)),
    "the reward is discounted as well, and γ belongs to the value of the next state alone": Learner(
        partial(slips, discounts_all=True)
    ),
    "the first values are below 0": Learner(partial(agent, first=-1.0)),
    "the first values are above 0": Learner(partial(agent, first=0.5)),
}
"""Those that change actions only where small differences decide."""
SHOP = Race(partial(gymnasium.make, "edugym/Supermarket-v0"), N_STEPS, program_of(agent))


def project_0(answer: Any, seed: int) -> str:
    """Check a program with Q-learning."""
    RULE.check(answer, seed)
    require_close_calls(answer, seed, RULE.right, CLOSE_MISTAKES, EPSILON)
    require_no_mistake(answer, seed, agent, too_late(agent), EPSILON)
    return f"Right: that is all of it, the loop and the learner. {compare_with_ours(answer, SHOP, seed)}"
