"""Where the project of lesson 7 tries programs: three boxes, and REINFORCE with a Gaussian policy, right and wrong."""

import math
from collections.abc import Callable, Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.programs import APART, Step
from edugym_course.lessons.continuous_actions.release import reward

POLICY_RATE, VALUE_RATE, DISCOUNT = 0.005, 0.1, 0.8
SMALLEST, LARGEST = 0.2, 2.0
"""σ never leaves these bounds."""
BOXES, WIDTH, FARTHEST = 3, 2, 1.0
HARDLY_FARTHER = 6.0
"""Three times the largest σ: farther actions are rare."""
CUT_OFF = 0.05
"""How likely an episode is truncated after a box, where episodes are truncated at all."""


class Boxes(gymnasium.Env[Any, Any]):
    """An arm lets go of three boxes, one after another, over containers whose middles it does not know.

    A state is the container below the arm. The reward is that of the lesson. After a good place another container
    comes than after a bad one. No state comes twice in an episode.

    Args:
        seed: the number from which the middles and the numbers of the states are drawn.
        truncates: whether some episodes are cut off before the last box.
        in_a_row: whether there are six boxes, each over a container of its own.
    """

    def __init__(self, seed: int, truncates: bool = False, in_a_row: bool = False) -> None:
        """Draw the containers."""
        self._boxes, self._width = (BOXES * WIDTH, 1) if in_a_row else (BOXES, WIDTH)
        n, rng = BOXES * WIDTH, np.random.default_rng(APART + seed)
        self.observation_space = spaces.Discrete(n)
        self.action_space = spaces.Box(-math.inf, math.inf, (), np.float64)
        self._middles, self._states = rng.uniform(-FARTHEST, FARTHEST, n), rng.permutation(n)
        self._place, self._truncates = 0, truncates

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin with one of the first containers."""
        super().reset(seed=seed)
        self._place = int(self.np_random.integers(self._width))
        return int(self._states[self._place]), {}

    def step(self, action: float) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Let go of a box."""
        pays = float(reward(np.array(action - self._middles[self._place])))
        layer = self._place // self._width + 1
        self._place = layer % self._boxes * self._width + min(pays < 2.0, self._width - 1)
        terminated = layer == self._boxes
        truncated = bool(self._truncates and not terminated and self.np_random.random() < CUT_OFF)
        return int(self._states[self._place]), pays, terminated, truncated, {}


class FarPays(gymnasium.Env[Any, Any]):
    """One action an episode, in a single state: the farther from 0 it is, up to `HARDLY_FARTHER`, the more it pays.

    So σ grows, until something stops it.
    """

    observation_space = spaces.Discrete(BOXES * WIDTH)
    action_space = spaces.Box(-math.inf, math.inf, (), np.float64)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin in state 0."""
        super().reset(seed=seed)
        return 0, {}

    def step(self, action: float) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pay, and end in state 1."""
        return 1, min(abs(float(action)), HARDLY_FARTHER), True, False, {}


Returns = Sequence[float]
Score = Callable[[float, float], float]


def returns_from(rewards: Returns, discount: float) -> Returns:
    """The return from each step on, G_t."""
    returns = [0.0]
    for one in reversed(rewards):
        returns.append(one + discount * returns[-1])
    return returns[:0:-1]


def returns_until(rewards: Returns, discount: float) -> Returns:
    """What a program gets that sums up from the wrong end."""
    return returns_from(rewards[::-1], discount)[::-1]


def score_of_mean(off: float, spread: float) -> float:
    """The derivative of ln π with respect to μ, `off` = a − μ from it."""
    return off / spread**2


def score_of_log(off: float, spread: float) -> float:
    """The derivative of ln π with respect to ln σ."""
    return off / spread * (off / spread) - 1


class Gaussians:
    """REINFORCE with a Gaussian policy that has μ and ln σ of its own in each state; the values are its baseline.

    Args:
        n_states: the number of states.
        returns: gives the returns of the rewards of an episode, and γ.
        of_mean: the score of μ, of a − μ and σ.
        of_log: the score of ln σ.
        policy_rate: α^θ.
        value_rate: α^w.
        fades: whether later steps count less, by γ^t; "backwards", whether the earlier ones do; "μ" or "ln σ", whether
            only the steps of one of them do; "V", whether those of V do, too; "later", whether it is γ^(t+1).
        discount: γ.
        averages: whether the baseline is the mean of the returns of the episode.
        goes_on: whether the returns of a truncated episode go on with the value of its last state.
        bounds: of σ.
        shared: which of "μ", "σ" and "V" all states share.
        first: σ at first.
        power: the standard deviation of an action is this power of σ.
        fresh: whether the policy learns from G less the V that has just moved.
        moves: what changes before the score of the other is computed, "μ" or "σ"; with "", nothing.
        all_steps: whether it learns from the last step of an episode, too.
        cut: the size at which it cuts off the actions that it learns from.
        bootstraps: whether it learns from the TD error in the place of G less V; "V", whether the values alone do.
        keeps: whether its list of steps is never emptied.
        backwards: whether it learns from the last step first.
        itself: whether it is σ that moves, by its own score, and not ln σ.
        cut_short: whether it learns from episodes that are truncated, too.
        skips: how many of the first steps of an episode it does not learn from.
        stale: whether it takes the last state of an episode for the first one of the next.
        to_the_end: whether it learns from the last episode, too, which time has cut off.
        first_value: V at first.
        after: whether it learns of the states after the actions.
    """

    def __init__(
        self,
        n_states: int,
        returns: Callable[[Returns, float], Returns] = returns_from,
        of_mean: Score = score_of_mean,
        of_log: Score = score_of_log,
        policy_rate: float = POLICY_RATE,
        value_rate: float = VALUE_RATE,
        fades: bool | str = True,
        discount: float = DISCOUNT,
        averages: bool = False,
        goes_on: bool = False,
        bounds: tuple[float, float] = (SMALLEST, LARGEST),
        shared: str = "",
        first: float = 1.0,
        power: float = 1.0,
        fresh: bool = False,
        moves: str = "",
        all_steps: bool = True,
        cut: float = math.inf,
        bootstraps: bool | str = False,
        keeps: bool = False,
        backwards: bool = False,
        itself: bool = False,
        cut_short: bool = True,
        skips: int = 0,
        stale: bool = False,
        to_the_end: bool = False,
        first_value: float = 0.0,
        after: bool = False,
    ) -> None:
        """Begin with μ = 0."""
        # Lists: Python reads one entry of them sooner than one of an array.
        self.mean, self._log, self._V = [0.0] * n_states, [math.log(first)] * n_states, [first_value] * n_states
        self._returns, self._of_mean, self._of_log = returns, of_mean, of_log
        self._policy_rate, self._value_rate = policy_rate, value_rate
        self._fades, self._shared, self._power, self._fresh, self._moves = fades, shared, power, fresh, moves
        self._cut, self._bootstraps, self._itself, self._cut_short = cut, bootstraps, itself, cut_short
        self._all_steps, self.keeps, self._backwards = all_steps, keeps, backwards
        self._discount, self._averages, self._goes_on = discount, averages, goes_on
        self._skips, self.stale, self.to_the_end, self.after = skips, stale, to_the_end, after
        self._least, self._most = map(math.log, bounds)

    def gaussian(self, state: int) -> tuple[float, float]:
        """The mean and the standard deviation of the action."""
        return self.mean[self._row("μ", state)], math.exp(self._log[self._row("σ", state)] * self._power)

    def _row(self, what: str, state: int) -> int:
        """The number of a state, or 0 for what all states share."""
        return 0 if what in self._shared else state

    def learn(self, episode: Sequence[Step]) -> None:
        """Learn from an episode."""
        if episode[-1].truncated and not self._cut_short:
            return
        rewards = [step.reward for step in episode]
        if self._goes_on and episode[-1].truncated:
            rewards[-1] += self._discount * self._V[episode[-1].next_state]
        returns = self._returns(rewards, self._discount)
        times = range(self._skips, len(episode) if self._all_steps else len(episode) - 1)
        for t in reversed(times) if self._backwards else times:
            step = episode[t]
            G, mean, log = returns[t], self._row("μ", step.state), self._row("σ", step.state)
            one_step = step.reward + (DISCOUNT * self._V[step.next_state] if t + 1 < len(episode) else 0.0)
            G = one_step if self._bootstraps is True else G
            value = self._row("V", step.state)
            delta = G - (sum(returns) / len(returns) if self._averages else self._V[value])
            power = len(episode) - 1 - t if self._fades == "backwards" else t + (self._fades == "later")
            fade = self._discount**power if self._fades else 1.0
            off_value = one_step - self._V[value] if self._bootstraps == "V" else delta
            self._V[value] += self._value_rate * (fade if self._fades == "V" else 1.0) * off_value
            delta = G - self._V[value] if self._fresh else delta
            action, spread = min(max(step.action, -self._cut), self._cut), math.exp(self._log[log])
            off = action - self.mean[mean]
            rate_of_mean = self._policy_rate * (1.0 if self._fades == "ln σ" else fade)
            rate = self._policy_rate * (1.0 if self._fades == "μ" else fade)
            if self._moves == "μ":
                self.mean[mean] += rate_of_mean * delta * self._of_mean(off, spread)
                off = action - self.mean[mean]
            moved = self._log[log] + rate * delta * self._of_log(off, spread)
            if self._itself:
                moved = math.log(max(spread + rate * delta * self._of_log(off, spread) / spread, 1e-9))
            self._log[log] = min(max(moved, self._least), self._most)  # NaN stays NaN
            if self._moves != "μ":
                spread = math.exp(self._log[log]) if self._moves == "σ" else spread
                self.mean[mean] += rate_of_mean * delta * self._of_mean(off, spread)
