"""The project of lesson 3: n-step SARSA from its definition, from a blank file."""

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import gymnasium
import numpy as np

from edugym.adapters.fitting import tabular
from edugym.agents.n_step_sarsa import NStepSARSA
from edugym.agents.strategies import EpsilonGreedy
from edugym.mdp.protocol import Random
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.learners import Learner, mistakes_of_loops, other_settings, other_tables
from edugym_course.grading.programs import NAME, Environment, run_program, shape_of
from edugym_course.grading.replay import Rule, replay
from edugym_course.grading.small_world import SmallWorld
from edugym_course.grading.surprises import NATS, Surprises
from edugym_course.lessons.depth.targets import EPSILON

N_STEPS, N, LEARNING_RATE, DISCOUNT = 5_000, 3, 0.5, 0.8
"""A discount far below 1, so that a program whose powers of γ are wrong takes other actions."""


def agent(
    shape: tuple[int, int], n: float = N, learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT
) -> NStepSARSA:
    """Make an agent with the settings of the project."""
    return NStepSARSA.create(shape, n=n, learning_rate=learning_rate, discount=discount)


def discounted(rewards: Sequence[float], first: int = 0) -> float:
    """Return the sum of rewards, weighted by powers of γ from the first exponent on."""
    return sum(DISCOUNT ** (first + k) * reward for k, reward in enumerate(rewards))


class FromDefinition:
    """n-step SARSA from lists, with a mistake in its target.

    Args:
        shape: that of the table.
        largest: whether the largest value of the state after n steps stands in the place of that of the action taken.
        bootstrap: the weight of this value.
        total: the weighted sum of the rewards of a target.
        from_start: whether the power of γ of a reward is that of its place in the episode.
        early: whether the value is that of the pair one step earlier.
        last_only: whether at the end of an episode only the pair of n steps before is learned.
        again: whether at the end of an episode all its pairs are learned, also those that were before.
        cut: what is learned where an episode is truncated: "rewards" alone, the largest "value" too, or "nothing".
    """

    def __init__(
        self,
        shape: tuple[int, int],
        *,
        largest: bool = False,
        bootstrap: float = DISCOUNT**N,
        total: Callable[[Sequence[float]], float] = discounted,
        from_start: bool = False,
        early: bool = False,
        last_only: bool = False,
        again: bool = False,
        cut: str = "rewards",
    ) -> None:
        """Begin with zeros."""
        self.Q = np.zeros(shape)
        self._largest, self._bootstrap, self._from_start, self._last_only = largest, bootstrap, from_start, last_only
        self._cut, self._total, self._early, self._again = cut, total, early, again
        self.forget_episode()

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        return EpsilonGreedy(EPSILON).choose(self.Q, state, rng)

    def forget_episode(self) -> None:
        """Begin an episode."""
        self._pairs: list[tuple[int, int]] = []
        self._rewards: list[float] = []

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
        self._rewards.append(reward)
        steps = len(self._pairs)
        over = terminated or truncated
        if terminated or (truncated and self._cut == "rewards"):
            after = 0.0
        elif truncated or self._largest:
            after = float(self.Q[next_state].max())
        elif self._early:
            after = float(self.Q[state, action])
        else:
            after = float(self.Q[next_state, next_action])
        left = steps if over and not self._last_only else steps - N + 1
        begin = 0 if over and self._again else max(steps - N, 0)
        for tau in range(begin, 0 if truncated and self._cut == "nothing" else left):
            rewards = self._rewards[tau : tau + N]
            target = discounted(rewards, first=tau) if self._from_start else self._total(rewards)
            weight = self._bootstrap * DISCOUNT ** (len(rewards) - N)  # of fewer rewards than n
            self.Q[self._pairs[tau]] += LEARNING_RATE * (target + weight * after - self.Q[self._pairs[tau]])
        if over:
            self.forget_episode()


def study() -> Environment:
    """Make the environment, eight days with numbered states."""
    made: Environment = tabular(gymnasium.make("edugym/Study-v0", total_days=8))
    return made


RULE = Rule(
    Learner(agent),
    mistakes_of_loops(agent, on_policy=True)
    | {
        "the target has one reward only: that is SARSA": Learner(partial(agent, n=1)),
        "the target has two rewards, and it should have three": Learner(partial(agent, n=2)),
        "the target has four rewards, and it should have three": Learner(partial(agent, n=4)),
        "the target has all rewards to the end of the episode: that is Monte Carlo": Learner(
            partial(agent, n=math.inf)
        ),
        "the target has the next reward alone": Learner(partial(agent, n=1, discount=0.0)),
        "after the rewards comes the largest value of S_τ+n, or a mean near it; it should be that of the action taken,"
        " A_τ+n: with the maximum the target is the uncorrected one of this lesson": Learner(
            partial(FromDefinition, largest=True)
        ),
        "no value comes after the n rewards: γⁿ Q(S_τ+n, A_τ+n) is missing": Learner(
            partial(FromDefinition, bootstrap=0.0)
        ),
        "at the end of an episode only one pair is learned, and the others that are left have rewards to learn from"
        " too": Learner(partial(FromDefinition, last_only=True)),
        "the value after the n rewards is not discounted: it is γⁿ Q(S_τ+n, A_τ+n)": Learner(
            partial(FromDefinition, bootstrap=1.0)
        ),
        "the rewards are discounted from the start of the episode, and they should be from step τ: the first reward of"
        " a target has the weight 1": Learner(partial(FromDefinition, from_start=True)),
        "the value after the n rewards has the weight γⁿ⁻¹, and it should be γⁿ": Learner(
            partial(FromDefinition, bootstrap=DISCOUNT ** (N - 1))
        ),
        "the value after the n rewards has the weight γⁿ⁺¹, and it should be γⁿ": Learner(
            partial(FromDefinition, bootstrap=DISCOUNT ** (N + 1))
        ),
        "the value after the n rewards has the weight γ, and it should be γⁿ": Learner(
            partial(FromDefinition, bootstrap=DISCOUNT)
        ),
        "the value is that of S_τ+n-1 and A_τ+n-1, one step too early": Learner(partial(FromDefinition, early=True)),
        "all rewards have the same weight: the first one has the weight 1, the second γ, and the third γ²": Learner(
            partial(FromDefinition, total=sum)
        ),
        "the powers of γ run backwards: the *first* reward of a target has the weight 1": Learner(
            partial(FromDefinition, total=lambda rewards: discounted(rewards[::-1]))
        ),
        "the first reward is left out of the target, that of step τ itself, R_τ+1": Learner(
            partial(FromDefinition, total=lambda rewards: discounted(rewards[1:]))
        ),
        "the mean of the rewards stands where their sum should": Learner(
            partial(FromDefinition, total=lambda rewards: discounted(rewards) / len(rewards))
        ),
        "at the end of an episode all its pairs are learned, also those that have learned before": Learner(
            partial(FromDefinition, again=True)
        ),
    }
    | other_settings(
        agent,
        discount=("γ", DISCOUNT, (1.0, 0.99, 0.95, 0.9, 0.85, 0.75, 0.7, 0.6, 0.5)),
        learning_rate=("α", LEARNING_RATE, (0.1, 0.25, 0.4, 0.6, 0.75, 1.0)),
    )
    | other_tables(agent),
    EPSILON,
    truncates=False,
    otherwise="; look at two places: at the end of an episode the targets of *all* pairs that are left are made of"
    " rewards alone, and elsewhere the value γⁿ Q(S_τ+n, A_τ+n) comes after the n rewards; and the lists hold the"
    " actions that were taken, in this episode",
)
CUT = {cut: Learner(partial(FromDefinition, cut=cut)) for cut in ("nothing", "rewards", "value")}
"""What may be learned where an episode is truncated. The two right ones differ; both are in use."""


def check_cut(program: Any, seed: int) -> None:
    """Check that a program learns from truncated episodes.

    Raises:
        WrongAnswer: it does not, or it breaks the contract.
    """
    world = SmallWorld(seed)
    runs = [run_program(program, world, RULE.n_steps, seed).steps]
    logs = {
        cut: float(Surprises.of(replay(runs, learner, shape_of(world), EPSILON)).logs.sum())
        for cut, learner in CUT.items()
    }
    if logs["nothing"] > max(logs["rewards"], logs["value"]) + NATS:
        raise WrongAnswer(
            f"{NAME} learns nothing at the end of an episode that is truncated: there, too, all pairs that are left"
            " have the rewards that there are"
        )


STUDY = Race(study, N_STEPS, program_of(agent), episodes=20)


def project_3(answer: Any, seed: int) -> str:
    """Check a program with n-step SARSA."""
    RULE.check(answer, seed)
    check_cut(answer, seed)
    return f"Right: n rewards, and then a value. {compare_with_ours(answer, STUDY, seed)}"
