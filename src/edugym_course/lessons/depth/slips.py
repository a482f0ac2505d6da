"""n-step SARSA from its definition, and the slips that a program with lists may make."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from edugym.agents.strategies import EpsilonGreedy
from edugym.mdp.protocol import Random, Reals
from edugym_course.lessons.depth.targets import EPSILON

N, LEARNING_RATE, DISCOUNT = 3, 0.5, 0.8
"""A discount far below 1, so that a program whose powers of γ are wrong takes other actions."""


def discounted(rewards: Sequence[float], first: int = 0) -> float:
    """Return the sum of rewards, weighted by powers of γ from the first exponent on."""
    return sum(DISCOUNT ** (first + k) * reward for k, reward in enumerate(rewards))


@dataclass
class FromDefinition:
    """n-step SARSA from lists, but for one thing.

    Attributes:
        Q: the table, of shape (n_states, n_actions).
        largest: whether the largest value of the state after n steps stands in the place of that of the action taken.
        bootstrap: the weight of this value.
        total: the weighted sum of the rewards of a target.
        from_start: whether the power of γ of a reward is that of its place in the episode.
        early: whether the value is that of the pair one step earlier.
        late: whether each pair is learned one step too late, with the value of the pair that is then reached; at the
            end of an episode one pair is left out.
        keeps: whether the lists are not emptied at the end of an episode.
        stale_action: whether the value is that of the state after n steps, with the action before.
        shift: how many steps too early the rewards of a target are.
        newest: whether the newest pair moves, not that of step τ.
        begin: the first pair that is learned.
        last_only: whether at the end of an episode only the pair of n steps before is learned.
        forgotten: how many of the last pairs of an episode are not learned.
        again: whether at the end of an episode all its pairs are learned, also those that were before.
        backwards: whether an episode is learned when it is over, from its last pair to its first.
        old: whether the value that is subtracted is that from the time of the step.
        cut: what is learned where an episode is truncated: "rewards" alone, the largest "value" too, that of the pair
            "before", all rewards but the "last", or "nothing"; or nothing of "all" the episode, as in a program that
            learns when an episode is over.
        cut_weight: the weight of that value after so many rewards.
        cut_total: the weighted sum of the rewards there.
    """

    Q: Reals
    largest: bool = False
    bootstrap: float = DISCOUNT**N
    total: Callable[[Sequence[float]], float] = discounted
    from_start: bool = False
    early: bool = False
    late: bool = False
    keeps: bool = False
    stale_action: bool = False
    shift: int = 0
    newest: bool = False
    begin: int = 0
    last_only: bool = False
    forgotten: int = 0
    again: bool = False
    backwards: bool = False
    old: bool = False
    cut: str = "rewards"
    cut_weight: Callable[[int], float] = lambda k: DISCOUNT**k
    cut_total: Callable[[Sequence[float]], float] = discounted
    _pairs: list[tuple[int, int]] = field(init=False, default_factory=list)
    _rewards: list[float] = field(init=False, default_factory=list)
    _values: list[float] = field(init=False, default_factory=list)

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        return EpsilonGreedy(EPSILON).choose(self.Q, state, rng)

    def forget_episode(self) -> None:
        """Begin an episode."""
        self._pairs, self._rewards, self._values = [], [], []

    def learn(
        self,
        state: int,
        action: int,
        reward: float,
        next_state: int,
        next_action: int,
        terminated: bool,
        truncated: bool,
    ) -> None:
        """Learn the pairs whose rewards are complete."""
        self._pairs.append((state, action))
        self._values.append(float(self.Q[state, action]))
        self._rewards.append(0.0 if truncated and self.cut == "last" else reward)
        over = terminated or truncated
        value_at_end = self._value_at_end(next_state, terminated)
        for tau in self._learned(over, truncated):
            if tau + N < len(self._pairs) and not (self.again or self.late):
                after = self.bootstrap * self._value(tau, *self._pairs[tau + N])
            elif not over:
                after = self.bootstrap * self._value(tau, next_state, action if self.stale_action else next_action)
            else:
                after = self.cut_weight(len(self._pairs) - tau) * value_at_end
            first = max(tau - self.shift, 0)
            rewards = self._rewards[first : first + N]
            total = self.cut_total if truncated else self.total
            target = discounted(rewards, first=tau) if self.from_start else total(rewards)
            moved = self._pairs[-1 if self.newest else tau]
            self.Q[moved] += LEARNING_RATE * (target + after - (self._values[tau] if self.old else self.Q[moved]))
        if over and not self.keeps:
            self.forget_episode()

    def _learned(self, over: bool, truncated: bool) -> range:
        """Return the steps whose pairs are learned now."""
        steps = len(self._pairs)
        if self.backwards:
            return range(steps - 1, -1, -1) if over else range(0)
        if self.cut == "all":
            return range(steps if over and not truncated else 0)
        if truncated and self.cut == "nothing":
            return range(0)
        first = 0 if over and self.again else max(steps - N - (self.late and not over), 0)
        left = steps - self.forgotten if over and not self.last_only else steps - N + 1 - self.late
        return range(max(first, self.begin), left)

    def _value(self, tau: int, state: int, action: int) -> float:
        """Return the value after n rewards."""
        if self.largest:
            return float(self.Q[state].max())
        return float(self.Q[self._pairs[tau + N - 1] if self.early else (state, action)])

    def _value_at_end(self, next_state: int, terminated: bool) -> float:
        """Return the value after the last reward of an episode."""
        if terminated or self.cut not in {"value", "before"}:
            return 0.0
        return float(self.Q[next_state].max() if self.cut == "value" else self.Q[self._pairs[-1]])


def slips(shape: tuple[int, int], **how: Any) -> FromDefinition:
    """Make an agent that makes a slip, one of the attributes of `FromDefinition`."""
    return FromDefinition(np.zeros(shape), **how)
