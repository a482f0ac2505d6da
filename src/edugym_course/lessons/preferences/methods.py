"""What lesson 14 does: nights are compared, rewards are learned from the comparisons, and followed more or less far."""

import threading
from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.dataset import drawn
from edugym.agents.preferences import fit_rewards, preference
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.regularised import divergence, regularised_iteration, regularised_policy, with_rewards
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.wrapper import wrapper
from edugym_course.lessons.own_problem.morning import Morning, State

N_COMPARISONS = 100
NOISE = 1.0
"""τ, the noise of the teacher: rewards are learned in units of it."""
PRIOR = 0.1
REPETITIONS = 100
PENALTIES = (30.0, 10.0, 5.0, 3.0, 2.0, 1.0, 0.7, 0.5, 0.3, 0.2, 0.1, 0.0)
"""β, from hardly any change to none but the reward."""
MODEST = 0.5
"""The penalty with which policies without one are compared."""


class Comparisons(NamedTuple):
    """Pairs of nights, and which of the two the teacher preferred.

    Attributes:
        first: shape (n, S, A): how often the first night took each action in each state.
        second: the same of the second night.
        prefers_first: shape (n,): whether the first was preferred.
    """

    first: Reals
    second: Reals
    prefers_first: Any

    def with_more(self, more: "Comparisons") -> "Comparisons":
        """Return these comparisons and some more."""
        return Comparisons(*(np.concatenate(parts) for parts in zip(self, more, strict=True)))


@cache
def model_of(mdp: Any) -> FiniteModel:
    """Return the exact model of a morning."""
    return finite_model(mdp)


@cache
def half_right(mdp: Any) -> Reals:
    """Return the policy of the clock as it is sold: half of the time the best action, half of the time a random one."""
    best = value_iteration(model_of(mdp)).greedy_policy()
    return 0.5 * best + 0.5 / best.shape[1]


def nights(model: FiniteModel, policy: Reals, n: int, rng: Random) -> tuple[Reals, Reals]:
    """Play n nights at once.

    Returns:
        How often each took each action in each state, shape (n, S, A), and what each was worth, shape (n,).
    """
    every = np.arange(n)
    states = rng.choice(len(model.states), n, p=model.initial)
    visits, returns = np.zeros((n, *policy.shape)), np.zeros(n)
    while not model.terminal[states].all():
        actions = drawn(policy[states], rng)
        ways = drawn(model.probabilities[states, actions], rng)
        going_on = ~model.terminal[states]
        visits[every, states, actions] += going_on
        returns += model.rewards[states, actions, ways]  # it is 0 after the end
        states = model.successors[states, actions, ways]
    return visits, returns


def compared(model: FiniteModel, policy: Reals, n: int, noise: float, rng: Random) -> Comparisons:
    """Return n comparisons of two nights under a policy. With a noise of 0 the teacher is never wrong."""
    (first, first_returns), (second, second_returns) = (nights(model, policy, n, rng) for _ in range(2))
    if noise > 0:
        probability = preference(first_returns, second_returns, noise)
    else:
        probability = (1 + np.sign(first_returns - second_returns)) / 2
    return Comparisons(first, second, rng.random(n) < probability)


def tuned(model: FiniteModel, reference: Reals, penalty: float) -> Reals:
    """Return the policy that is best for the rewards of a model and a penalty; with a penalty of 0 for the rewards."""
    if penalty == 0:
        return value_iteration(model).greedy_policy()
    return regularised_policy(regularised_iteration(model, reference, penalty), reference, penalty)


class Followed(NamedTuple):
    """What comes of following learned rewards, for each penalty and each run.

    The first three are gains over the reference policy; shape (penalties, runs).

    Attributes:
        learned: by the rewards that were followed.
        second: by rewards that were learned from other comparisons, as many and of the same kind.
        meant: by the rewards that were meant.
        nats: how far the policy goes from the reference.
        penalties: the penalties.
        best: the best gain that there is.
    """

    learned: Reals
    second: Reals
    meant: Reals
    nats: Reals
    penalties: Sequence[float]
    best: float

    def at(self, penalty: float) -> Reals:
        """Return the meant gains of all runs with one penalty."""
        gains: Reals = self.meant[[*self.penalties].index(penalty)]
        return gains

    def fall(self) -> Reals:
        """Return how much less is gained without a penalty than with a modest one, by run."""
        return self.at(MODEST) - self.at(0.0)


def learned_rewards(
    mdp: Any,
    n_comparisons: int,
    noise: float,
    prior: float,
    rng: Random,
    *,
    rounds: int = 1,
    at_random: bool = False,
) -> Reals:
    """Return rewards that were learned from comparisons.

    Args:
        mdp: the morning, with the rewards that are meant.
        n_comparisons: how many comparisons there are in all.
        noise: τ of the teacher; 0 for one that is never wrong.
        prior: how strongly rewards are kept near 0.
        rng: where all chance comes from.
        rounds: in how many rounds the teacher is asked. After each, the nights to compare are those of a policy that
            follows what was learned so far, with the modest penalty.
        at_random: whether nights of random actions are compared, instead of those of the reference policy.
    """
    model, reference = model_of(mdp), half_right(mdp)
    shown = np.full_like(reference, 1 / reference.shape[1]) if at_random else reference
    asked = compared(model, shown, n_comparisons // rounds, noise, rng)
    for _ in range(rounds - 1):
        rewards = fit_rewards(*asked, prior=prior)
        shown = tuned(with_rewards(model, rewards), reference, MODEST)
        asked = asked.with_more(compared(model, shown, n_comparisons // rounds, noise, rng))
    return fit_rewards(*asked, prior=prior)


def followed(
    mdp: Any = Morning(),  # noqa: B008
    n_comparisons: int = N_COMPARISONS,
    noise: float = NOISE,
    prior: float = PRIOR,
    *,
    penalties: Sequence[float] = PENALTIES,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
    **how: Any,
) -> Followed:
    """Learn rewards from comparisons, and follow them, over repetitions; other arguments as in `learned_rewards`."""
    model, reference = model_of(mdp), half_right(mdp)
    before = policy_evaluation(model, reference).start
    rows = []
    for child in np.random.SeedSequence(seed).spawn(repetitions):
        if stop is not None and stop.is_set():
            break
        one, other = (
            with_rewards(model, learned_rewards(mdp, n_comparisons, noise, prior, np.random.default_rng(part), **how))
            for part in child.spawn(2)
        )
        policies = [tuned(one, reference, penalty) for penalty in penalties]
        gains = [
            [policy_evaluation(judge, policy).start - policy_evaluation(judge, reference).start for policy in policies]
            for judge in (one, other, model)
        ]
        rows.append([*gains, [divergence(model, policy, reference) for policy in policies]])
    measured = np.moveaxis(np.array(rows).reshape(-1, 4, len(penalties)), 0, -1)  # shape (4, penalties, runs)
    learned, second, meant, nats = measured
    return Followed(learned, second, meant, nats, penalties, value_iteration(model).start - before)


@wrapper
class LearnedReward(NamedTuple):
    """A morning whose reward was learned.

    Attributes:
        mdp: the morning.
        rewards: shape (T + 1, 3, 3): the reward, by time, depth of sleep and action.
    """

    mdp: Any
    rewards: Reals

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Return what was learned for the state and the action."""
        return float(self.rewards[state[0], state[1], action])


def learned_reward(mdp: Any, rewards: Reals) -> LearnedReward:
    """Return a morning with learned rewards, given by the rows of its model, shape (S, A)."""
    by_state = np.zeros((mdp.length + 1, 3, 3))
    for row, (time, depth) in enumerate(model_of(mdp).states):
        by_state[time, depth] = rewards[row]
    return LearnedReward(mdp, by_state)
