"""The project of lesson 8: a learner that avoids risk, from a blank file."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.agents.q_learning import QLearning
from edugym.agents.risk_sensitive_q_learning import RiskSensitiveQLearning
from edugym.agents.tables import epsilon_greedy_action, greedy_action, one_step_target
from edugym.mdp.protocol import Reals
from edugym_course.grading.again import require_no_mistake
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.learners import (
    Learner,
    mistakes_of_loops,
    other_settings,
    other_tables,
    too_early,
    too_late,
)
from edugym_course.grading.programs import run_program
from edugym_course.grading.rule import Rule

LEARNING_RATE, DISCOUNT, RISK, EPSILON = 0.4, 0.9, -0.5, 0.1
DISCOUNTED = "the reward is discounted, and γ should stand before the value of the next state alone"
N_STEPS, FORKS = 1_000, 5
SURE, GAIN, LOSS = 1.0, 5.0, -2.0


class Fork(gymnasium.Env[Any, Any]):
    """One decision: a sure payment, or a coin that pays more on average and may cost."""

    def __init__(self, risky: int) -> None:
        """Make a fork whose action `risky` throws the coin."""
        self.observation_space = spaces.Discrete(2)
        self.action_space = spaces.Discrete(2)
        self._risky = risky

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Stand at the fork, state 0."""
        super().reset(seed=seed)
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pay, and end in state 1."""
        coin = GAIN if self.np_random.random() < 0.5 else LOSS
        return 1, coin if action == self._risky else SURE, True, False, {}


def agent(
    shape: tuple[int, int], risk: float = RISK, learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT
) -> RiskSensitiveQLearning:
    """Make an agent with the settings of the project."""
    return RiskSensitiveQLearning.create(shape, risk=risk, learning_rate=learning_rate, discount=discount)


class NothingSubtracted(RiskSensitiveQLearning):
    """The agent without - Q(S, A) at the end of an episode: `R if terminated else R + ... - Q` has no brackets."""

    __slots__ = ()

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Learn from δ = R at the end."""
        old = float(self.Q[state, action]) if terminated else 0.0
        super().learn(state, action, reward + old, next_state, terminated)


def without_brackets(shape: tuple[int, int]) -> RiskSensitiveQLearning:
    """Make this agent with the settings of the project."""
    return NothingSubtracted.create(shape, risk=RISK, learning_rate=LEARNING_RATE, discount=DISCOUNT)


@dataclass
class _Slips:
    """The agent, but for one thing.

    Attributes:
        Q: the table, of shape (n_states, n_actions).
        future: the value of the next state, from its row and the action that was taken.
        weighed: what the weight is made of, from the reward, the target and δ.
        moves: by how much the value moves, from the weight, δ and the target; it is multiplied by α.
    """

    Q: Reals
    future: Callable[[Reals, int], float] = lambda row, action: float(row.max())
    weighed: Callable[[float, float, float], float] = lambda reward, target, delta: delta
    moves: Callable[[float, float, float], float] = lambda weight, delta, target: weight * delta

    def act(self, state: int, rng: np.random.Generator) -> int:
        """Choose an action by ε-greedy."""
        return int(epsilon_greedy_action(self.Q, state, EPSILON, rng))

    def greedy(self, state: int, rng: np.random.Generator) -> int:
        """Choose the action with the highest value."""
        return int(greedy_action(self.Q, state, rng))

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Move Q(S, A) by δ, weighted."""
        target = one_step_target(reward, DISCOUNT, self.future(self.Q[next_state], action), terminated)
        delta = target - float(self.Q[state, action])
        weight = 1.0 + math.tanh(RISK * self.weighed(reward, target, delta) / 2.0)
        self.Q[state, action] += LEARNING_RATE * self.moves(weight, delta, target)


def slips(shape: tuple[int, int], **how: Any) -> _Slips:
    """Make an agent that makes a mistake in its update."""
    return _Slips(np.zeros(shape), **how)


def neutral(shape: tuple[int, int]) -> QLearning:
    """Make an agent that does not mind risk."""
    return QLearning.create(shape, learning_rate=LEARNING_RATE, discount=DISCOUNT)


RULE = Rule(
    Learner(agent),
    mistakes_of_loops(agent)
    | too_early(agent)
    | {
        "all surprises weigh the same: that is Q-learning": Learner(neutral),
        "good surprises weigh more than bad ones: β is below 0": Learner(partial(agent, risk=-RISK)),
        "the steps are half as large as they should be: 2σ(βδ), not σ(βδ), is 1 where δ = 0, and α is 0.4": Learner(
            partial(agent, learning_rate=LEARNING_RATE / 2)
        ),
        "− Q(S, A) is missing at the end of an episode: put brackets around `... if terminated else ...`": Learner(
            without_brackets
        ),
        "γ max_a Q(S', a) is missing in the target": Learner(partial(agent, discount=0.0)),
        "the weight is made of the reward, and it should be made of δ": Learner(
            partial(slips, weighed=lambda reward, target, delta: reward)
        ),
        "the weight is made of the target, and it should be made of δ": Learner(
            partial(slips, weighed=lambda reward, target, delta: target)
        ),
        "the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)": Learner(
            agent, lambda step, before: step._replace(next_state=step.state)
        ),
        "δ is missing in the weight: it is 2σ(βδ), and not 2σ(β) for all surprises": Learner(
            partial(slips, weighed=lambda reward, target, delta: 1.0)
        ),
        "the weight stands before the target alone, and it should be before δ: α 2σ(βδ) δ is the step": Learner(
            partial(slips, moves=lambda weight, delta, target: weight * target - (target - delta))
        ),
        "δ is missing behind the weight: the step is α times the weight 2σ(βδ), times δ": Learner(
            partial(slips, moves=lambda weight, delta, target: weight)
        ),
        "the mean over the actions of the next state stands where the maximum should": Learner(
            partial(slips, future=lambda row, action: float(row.mean()))
        ),
        "Q(S', A) stands in the target, the value of the action that was taken before; it should be the maximum over"
        " the actions in S'": Learner(partial(slips, future=lambda row, action: float(row[action]))),
        "the mean by ε-greedy over the next actions stands where the maximum should: that is expected SARSA": Learner(
            partial(slips, future=lambda row, action: (1 - EPSILON) * row.max() + EPSILON * row.mean())
        ),
        DISCOUNTED: Learner(
            agent, lambda step, before: step if step.terminated else step._replace(reward=DISCOUNT * step.reward)
        ),
        f"{DISCOUNTED}, at the end of an episode, too": Learner(
            agent, lambda step, before: step._replace(reward=DISCOUNT * step.reward)
        ),
        "the maximum starts from 0, and all values may be lower: start from the first one": Learner(
            partial(slips, future=lambda row, action: max(0.0, float(row.max())))
        ),
    }
    | other_settings(
        agent,
        learning_rate=("α", LEARNING_RATE, (0.1, 0.5, 1.0)),
        discount=("γ", DISCOUNT, (0.5, 0.8, 0.95, 1.0)),
        risk=("β", RISK, (-2.0, -1.0, -0.7, -0.4, -0.3, -0.1)),
    )
    | other_tables(agent),
    EPSILON,
    otherwise="; look at two places: the target is R + γ max_a Q(S', a), and R alone where `terminated` is True; and"
    " the weight 2σ(βδ) = 2/(1 + exp(−βδ)) has the whole TD error δ in it",
)


def project_8(answer: Any, seed: int) -> str:
    """Check a program with risk-sensitive Q-learning."""
    RULE.check(answer, seed)
    require_no_mistake(answer, seed, agent, too_late(agent), EPSILON)
    careful = 0
    for number in range(FORKS * seed, FORKS * (seed + 1)):
        risky = number % 2
        careful += int(run_program(answer, Fork(risky), N_STEPS, number).policy(0)) != risky
    if careful <= FORKS // 2:
        raise WrongAnswer(
            f"a sure payment of {SURE:g}, or a coin that pays {GAIN:g} or {LOSS:g}: with β = {RISK:g} the sure payment"
            f" is worth more, but the policy takes it in {careful} of {FORKS} runs only; does it take the best action?"
        )
    return (
        f"Right: it takes a sure payment of {SURE:g} in {careful} of {FORKS} runs, although a coin that pays {GAIN:g}"
        f" or {LOSS:g} brings more on average."
    )
