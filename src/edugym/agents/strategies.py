"""Exploration strategies: how an agent chooses between what looks best and what it does not know yet.

A strategy is a NamedTuple that an agent holds, as in `QLearning.create(env, exploration=EpsilonGreedy(0.1))`. `create`
checks its settings. The agent asks it to choose:

    action = exploration.choose(Q, state, rng)

`Q` is the whole table, of shape (n_states, n_actions), and `state` is the index of a row. `UCB` and
`ScheduledEpsilonGreedy` count their choices: make one for each agent, with their `create`. A strategy whose
probabilities are known also has `probability(Q, state, action)` and `expected_value(Q, state)`, for expected SARSA and
tree backup.

References: Sutton and Barto, Reinforcement Learning, 2nd edition, sections 2.2 (ε-greedy) and 2.7 (UCB).
"""

import math
from typing import Annotated, Any, NamedTuple, Protocol

from edugym.agents.settings import Counter, Probability, Range, Table, check, new
from edugym.agents.tables import (
    best_value,
    epsilon_greedy_action,
    epsilon_greedy_probability,
    epsilon_greedy_value,
    greedy_action,
)
from edugym.checks.parameters import between, in_short
from edugym.mdp.protocol import Integers, Random, Reals


class Exploration(Protocol):
    """A rule for choosing an action from a table of action values."""

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """Choose an action in `state`, given the action values `Q` of shape (n_states, n_actions)."""


class Policy(Exploration, Protocol):
    """A rule for choosing an action whose probabilities are known."""

    def probability(self, Q: Reals, state: int, action: int) -> float:
        """The probability that the next choice in `state` is `action`: π(a|s)."""

    def expected_value(self, Q: Reals, state: int) -> float:
        """The mean action value under these probabilities: Σ_a π(a|s) Q(s, a)."""


def check_policy(name: str, strategy: Any) -> None:
    """Check that a strategy knows the probabilities of its actions.

    Raises:
        ValueError: it has no `probability` or no `expected_value`.
    """
    if isinstance(strategy, type) or not (hasattr(strategy, "probability") and hasattr(strategy, "expected_value")):
        given = f"the class {strategy.__name__}" if isinstance(strategy, type) else type(strategy).__name__
        raise ValueError(
            f"{name} must be a strategy that knows the probability of each action, such as EpsilonGreedy(0.1) (or"
            f" Greedy, ScheduledEpsilonGreedy or Softmax), but is {given}"
        )


class Greedy(NamedTuple):
    """Never explore: always the action with the highest value, ties broken at random."""

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """The best action in `state`."""
        return greedy_action(Q, state, rng)

    def probability(self, Q: Reals, state: int, action: int) -> float:
        """1/k for each of the k best actions, 0 for the others."""
        return epsilon_greedy_probability(Q, state, action, 0.0)

    def expected_value(self, Q: Reals, state: int) -> float:
        """The highest value."""
        return best_value(Q, state)


class EpsilonGreedy(NamedTuple):
    """Explore with probability ε, else exploit (section 2.2). An exploring step may happen to choose the best action.

    Attributes:
        epsilon: ε, the probability of a uniformly random action, from 0 to 1.
    """

    epsilon: Probability = 0.1

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """A random action with probability ε, else the best one."""
        return epsilon_greedy_action(Q, state, self.epsilon, rng)

    def probability(self, Q: Reals, state: int, action: int) -> float:
        """ε/n for each of the n actions; the best ones share a further 1 - ε equally."""
        return epsilon_greedy_probability(Q, state, action, self.epsilon)

    def expected_value(self, Q: Reals, state: int) -> float:
        """ε mean_a Q(s, a) + (1 - ε) max_a Q(s, a)."""
        return epsilon_greedy_value(Q, state, self.epsilon)


class LinearDecay(NamedTuple):
    """A number that falls (or rises) evenly, and then stays: a schedule for ε.

    Attributes:
        start: its value at step 0, from 0 to 1.
        end: its value from step `steps` on, from 0 to 1.
        steps: over how many steps it changes, 1 or more.
    """

    start: Probability
    end: Probability
    steps: Annotated[int, Range(1)]

    def value(self, step: int) -> float:
        """The value after `step` steps."""
        return self.start + (self.end - self.start) * min(step / self.steps, 1.0)


class ExponentialDecay(NamedTuple):
    """A number that is multiplied by the same factor at every step, down to a lowest value: a schedule for ε.

    Attributes:
        start: its value at step 0 (if it is not below `end`), from 0 to 1.
        end: its lowest value, from 0 to 1.
        rate: the factor, above 0 and up to 1.
    """

    start: Probability
    end: Probability
    rate: Annotated[float, Range(0, 1, open=True)]

    def value(self, step: int) -> float:
        """The value after `step` steps."""
        return max(self.end, self.start * math.exp(step * math.log(self.rate)))


class ScheduledEpsilonGreedy(NamedTuple):
    """ε-greedy with an ε that changes with the number of actions chosen.

    Make one with, for example, `ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.1, 10_000))`.

    Attributes:
        schedule: gives ε after so many actions: `LinearDecay`, `ExponentialDecay`, or anything with `value(step)`.
        step: shape (1,): how many actions have been chosen.
    """

    schedule: Any
    step: Counter

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """A random action with the present probability ε, else the best one."""
        epsilon = self.schedule.value(self.step[0])
        self.step[0] += 1
        return epsilon_greedy_action(Q, state, epsilon, rng)

    def probability(self, Q: Reals, state: int, action: int) -> float:
        """As ε-greedy with the ε of the next choice."""
        return epsilon_greedy_probability(Q, state, action, self.schedule.value(self.step[0]))

    def expected_value(self, Q: Reals, state: int) -> float:
        """As ε-greedy with the ε of the next choice."""
        return epsilon_greedy_value(Q, state, self.schedule.value(self.step[0]))

    @classmethod
    def create(cls, schedule: Any) -> "ScheduledEpsilonGreedy":
        """A strategy at step 0 of its schedule.

        Raises:
            ValueError: the schedule has no `value(step)`, its settings are not as its class says, or its first value is
                not from 0 to 1.
        """
        if isinstance(schedule, type) or not callable(getattr(schedule, "value", None)):
            raise ValueError(
                "schedule must have a method value(step), as LinearDecay(1.0, 0.1, 1000) has, but is"
                f" {in_short(schedule)}"
            )
        check(schedule)
        between("schedule.value(0)", schedule.value(0), 0, 1)
        return new(cls, None, {"schedule": schedule})


class Softmax(NamedTuple):
    """Choose better actions more often (Boltzmann exploration): π(a|s) ∝ exp(Q(s, a)/τ).

    Compare the softmax over preferences of equations 2.11 and 13.2, which has no temperature.

    Attributes:
        temperature: τ, greater than 0: near 0 it is greedy, and the higher, the more random; infinity is uniform.
    """

    temperature: Annotated[float, Range(0, math.inf, open=True)] = 1.0

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """An action drawn with probability proportional to exp((Q - max Q)/τ); the subtraction avoids overflow."""
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

    def probability(self, Q: Reals, state: int, action: int) -> float:
        """exp(Q(s, a)/τ), divided by the sum over all actions."""
        highest = best_value(Q, state)
        total = 0.0
        for other in range(Q.shape[1]):
            total += math.exp((float(Q[state, other]) - highest) / self.temperature)
        return math.exp((float(Q[state, action]) - highest) / self.temperature) / total

    def expected_value(self, Q: Reals, state: int) -> float:
        """Σ_a π(a|s) Q(s, a)."""
        highest = best_value(Q, state)
        total = 0.0
        weighted = 0.0
        for action in range(Q.shape[1]):
            weight = math.exp((float(Q[state, action]) - highest) / self.temperature)
            total += weight
            weighted += weight * float(Q[state, action])
        return weighted / total


class UCB(NamedTuple):
    """Optimism in the face of uncertainty: the action with the highest Q(s, a) + c √(ln t / N(s, a)), equation 2.10.

    An action that was never chosen in a state comes first. Equation 2.10 is for bandits; here each state has
    its own counts: t is the number of choices made there, the present one included.

    Attributes:
        counts: shape (n_states, n_actions): N(s, a), how often each action was chosen in each state.
        bounds: shape (1, n_actions): the upper bounds in the present state.
        c: how much uncertainty is worth, a finite number of 0 or more.
    """

    counts: Annotated[Integers, Table(("states", "actions"))]
    bounds: Annotated[Reals, Table((1, "actions"))]
    c: Annotated[float, Range(0)] = 1.0

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """Choose the action with the highest upper bound (ties at random), and count it."""
        t = 1
        for action in range(Q.shape[1]):
            t += self.counts[state, action]
        for action in range(Q.shape[1]):
            n = self.counts[state, action]
            self.bounds[0, action] = Q[state, action] + self.c * math.sqrt(math.log(t) / n) if n > 0 else math.inf
        chosen = greedy_action(self.bounds, 0, rng)
        self.counts[state, chosen] += 1
        return chosen

    @classmethod
    def create(cls, environment: Any, c: float = 1.0) -> "UCB":
        """A strategy that has chosen nothing yet, for an environment (or the shape of its table).

        Raises:
            ValueError: c is not as above, or the environment does not fit a table.
        """
        return new(cls, environment, {"c": c})
