"""Exploration strategies: how an agent chooses between what looks best and what it does not know yet.

A strategy is a value. An agent holds one, `QLearning(..., exploration=EpsilonGreedy(0.1))`, and asks it to choose:

    action = exploration.choose(Q, state, rng)

`Q` is the whole table, of shape (n_states, n_actions), and `state` its row. The loops below run over single entries of
that row instead of slicing it: compiled, that is five times as fast.

References: Sutton and Barto, Reinforcement Learning, 2nd edition, sections 2.2 (ε-greedy), 2.7 (UCB) and 2.8 (softmax).
"""

import math
from typing import Any, NamedTuple, Protocol

import numpy as np

from edugym.checks import above, at_least, between, whole_number
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.tabular import table_size


class Exploration(Protocol):
    """A rule for choosing an action from a table of action values."""

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """Choose an action in `state`, given the action values `Q` of shape (n_states, n_actions)."""


def greedy_action(Q: Reals, state: int, rng: Random) -> int:
    """The action with the highest value in `state`; among equals, one at random (argmax_a Q(s, a))."""
    best = 0
    ties = 1
    for action in range(1, Q.shape[1]):
        if Q[state, action] > Q[state, best]:
            best = action
            ties = 1
        elif Q[state, action] == Q[state, best]:
            ties += 1
            if rng.random() * ties < 1.0:  # the k-th of the equals replaces the one kept so far with probability 1/k
                best = action
    return best


def best_value(Q: Reals, state: int) -> float:
    """The highest action value in `state`: max_a Q(s, a)."""
    value = Q[state, 0]
    for action in range(1, Q.shape[1]):
        value = max(value, Q[state, action])
    return float(value)


class Greedy(NamedTuple):
    """Never explore: always the action with the highest value, ties broken at random."""

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """The best action in `state`."""
        return greedy_action(Q, state, rng)


class EpsilonGreedy(NamedTuple):
    """Explore with probability ε, else exploit (section 2.2). An exploring step may happen to choose the best action.

    Attributes:
        epsilon: ε, the probability of a uniformly random action, from 0 to 1.
    """

    epsilon: float = 0.1

    def check(self) -> None:
        """Refuse an ε that is no probability.

        Raises:
            ValueError: it is none.
        """
        between("epsilon", self.epsilon, 0, 1)

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """A random action with probability ε, else the best one."""
        if rng.random() < self.epsilon:
            return int(rng.random() * Q.shape[1])
        return greedy_action(Q, state, rng)


class LinearDecay(NamedTuple):
    """A number that falls (or rises) evenly, and then stays: a schedule for ε.

    Attributes:
        start: its value at step 0.
        end: its value from step `steps` on.
        steps: over how many steps it changes, 1 or more.
    """

    start: float
    end: float
    steps: int

    def check(self) -> None:
        """Refuse ends that are no probabilities, and a number of steps that is not 1 or more.

        Raises:
            ValueError: one of them is so.
        """
        between("start", self.start, 0, 1)
        between("end", self.end, 0, 1)
        whole_number("steps", self.steps, 1)

    def value(self, step: int) -> float:
        """The value after `step` steps."""
        return self.start + (self.end - self.start) * min(step / self.steps, 1.0)


class ExponentialDecay(NamedTuple):
    """A number that falls by the same share at every step, but not below an end: a schedule for ε.

    Attributes:
        start: its value at step 0.
        end: what it does not fall below.
        rate: by what it is multiplied at every step, above 0 and up to 1.
    """

    start: float
    end: float
    rate: float

    def check(self) -> None:
        """Refuse ends that are no probabilities, and a rate that is not above 0 and up to 1.

        Raises:
            ValueError: one of them is so.
        """
        between("start", self.start, 0, 1)
        between("end", self.end, 0, 1)
        above("rate", self.rate, 0, 1)

    def value(self, step: int) -> float:
        """The value after `step` steps."""
        return max(self.end, self.start * math.exp(step * math.log(self.rate)))


class ScheduledEpsilonGreedy(NamedTuple):
    """ε-greedy with an ε that changes with the number of actions chosen.

    Attributes:
        schedule: gives ε after so many actions: `LinearDecay`, `ExponentialDecay`, or any value with `value(step)`.
        step: shape (1,): how many actions have been chosen.
    """

    schedule: Any
    step: Integers

    @classmethod
    def create(cls, schedule: Any) -> "ScheduledEpsilonGreedy":
        """A strategy at step 0 of its schedule.

        Raises:
            ValueError: the schedule has no `value(step)`, or its settings are not as its class says.
        """
        if not hasattr(schedule, "value"):
            raise ValueError(f"schedule must have a method value, but is {schedule!r}")
        if hasattr(schedule, "check"):
            schedule.check()
        return cls(schedule, np.zeros(1, np.int64))

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """A random action with the present probability ε, else the best one."""
        epsilon = self.schedule.value(self.step[0])
        self.step[0] += 1
        if rng.random() < epsilon:
            return int(rng.random() * Q.shape[1])
        return greedy_action(Q, state, rng)


class Softmax(NamedTuple):
    """Choose better actions more often (Boltzmann exploration): π(a|s) ∝ exp(Q(s, a)/τ), as in equation 2.11.

    Attributes:
        temperature: τ, greater than 0: near 0 it is greedy, and the higher, the more random.
    """

    temperature: float = 1.0

    def check(self) -> None:
        """Refuse a temperature that is not above 0.

        Raises:
            ValueError: it is not.
        """
        above("temperature", self.temperature, 0)

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """An action drawn by its share of the sum of exp(Q/τ), from which the highest value is subtracted first."""
        highest = best_value(Q, state)
        total = 0.0
        for action in range(Q.shape[1]):
            total += math.exp((float(Q[state, action]) - highest) / self.temperature)
        left = rng.random() * total
        for action in range(Q.shape[1] - 1):
            left -= math.exp((float(Q[state, action]) - highest) / self.temperature)
            if left < 0.0:
                return action
        return Q.shape[1] - 1


class UCB(NamedTuple):
    """Optimism in the face of uncertainty: the action with the highest Q(s, a) + c √(ln t / N(s, a)), equation 2.10.

    An action that was never chosen in a state comes first. Equation 2.10 is for bandits; here every state counts for
    itself: t is the number of choices made there, the present one included.

    Attributes:
        counts: shape (n_states, n_actions): N(s, a), how often each action was chosen in each state.
        c: how much uncertainty is worth, 0 or more.
    """

    counts: Integers
    c: float = 1.0

    @classmethod
    def create(cls, environment: Any, c: float = 1.0) -> "UCB":
        """A strategy that has chosen nothing yet, for an environment (or the shape of its table).

        Raises:
            ValueError: c is negative, or the environment does not fit a table.
        """
        at_least("c", c, 0)
        return cls(np.zeros(table_size(environment), np.int64), c)

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """The action with the highest upper bound, ties broken at random, and count it."""
        t = 1
        for action in range(Q.shape[1]):
            t += self.counts[state, action]
        best = 0
        ties = 0
        highest = 0.0
        for action in range(Q.shape[1]):
            bound = math.inf
            if self.counts[state, action] > 0:
                bound = Q[state, action] + self.c * math.sqrt(math.log(t) / self.counts[state, action])
            if ties == 0 or bound > highest:
                best = action
                highest = bound
                ties = 1
            elif bound == highest:
                ties += 1
                if rng.random() * ties < 1.0:
                    best = action
        self.counts[state, best] += 1
        return best
