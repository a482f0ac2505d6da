"""n-step SARSA on Study: how the depths are compared, and what their policies are really worth."""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.n_step_sarsa import NStepSARSA
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.study import Study
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.training.train import train
from edugym_course.lessons.depth.targets import DAYS, DISCOUNT, EPSILON

N_STEPS = 40_000
EARLY = 2_500
"""The steps, 250 episodes, after which methods are compared early in training."""
SHORT = 5_000
"""The training steps for the comparison of learning rates."""
REPETITIONS = 80
LEARNING_RATE = 0.1
DEPTHS = (1, math.inf, 5, 3)
"""All values of n. The first two are compared at every σ, the first three with ten actions and over learning rates."""
BY_DEPTH = (1, 3, 5, math.inf)
"""The same in their order, as the figures of the lesson show them."""
SIGMAS = (0.0, 0.2, 1.0)
PASSING = 5.0
"""A policy that passes the exam returns more than this, and one that fails less than 0; so with the exam's reward."""

Maker = Callable[..., Any]
NONE: Mapping[str, Maker] = MappingProxyType({})


def label(n: float) -> str:
    """Return the label of a depth."""
    return "Monte Carlo" if n == math.inf else f"n = {n:g}"


ONE_STEP, MONTE_CARLO = label(1), label(math.inf)


class Examinee(NamedTuple):
    """An agent, and how often it has passed the exam in training, whether or not it has learned from that.

    Attributes:
        agent: the agent.
        passes: shape (1,): how many rewards were that of the exam. (Their noise must be small.)
    """

    agent: Any
    passes: Integers

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
        """Count a pass, and let the agent learn."""
        if reward > PASSING:
            self.passes[0] += 1
        self.agent.learn(state, action, reward, next_state, next_action, terminated, truncated)

    def act(self, state: int, rng: Random) -> int:
        """What the agent does."""
        return int(self.agent.act(state, rng))

    def greedy(self, state: int, rng: Random) -> int:
        """What the agent takes for the best action."""
        return int(self.agent.greedy(state, rng))


def counted(make: Maker) -> Maker:
    """Return a function that makes agents whose passes are counted, from one that makes agents."""
    return partial(_make_counted, make)


def _make_counted(make: Maker, environment: Any) -> Examinee:
    return Examinee(make(environment), np.zeros(1, np.int64))


def maker(
    n: float,
    *,
    learning_rate: float = LEARNING_RATE,
    epsilon: float = EPSILON,
    discount: float = DISCOUNT,
    total_days: int = DAYS,
    initial_value: float = 0.0,
) -> Maker:
    """Return a function that makes an n-step SARSA agent for an environment, with the settings of the lesson."""
    return partial(
        NStepSARSA.create,
        n=n,
        learning_rate=learning_rate,
        discount=discount,
        exploration=EpsilonGreedy(epsilon),
        longest=total_days,
        initial_value=initial_value,
    )


def compare(
    *,
    depths: Sequence[float] = DEPTHS,
    learning_rate: float = LEARNING_RATE,
    epsilon: float = EPSILON,
    discount: float = DISCOUNT,
    n_steps: int = N_STEPS,
    sigma: float = 0.2,
    n_actions: int = 5,
    total_days: int = DAYS,
    initial_value: float = 0.0,
    own: Mapping[str, Maker] = NONE,
    points: int = 16,
    count_passes: bool = False,
    **how: Any,
) -> Results:
    """Train n-step SARSA with several n: one panel of the figure.

    Args:
        depths: the values of n.
        learning_rate: α of all.
        epsilon: ε of all.
        discount: γ of all.
        n_steps: the training steps of each run; an episode takes `total_days`.
        sigma: the standard deviation of the reward noise.
        n_actions: the number of actions.
        total_days: the number of days of an episode.
        initial_value: the value of everything that was not tried yet.
        own: by label, functions that make other agents for an environment, such as a reader's own.
        points: the number of points of the learning curve.
        count_passes: whether to count how often n-step SARSA passes the exam in training, for `met_exam`.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    make = partial(
        maker,
        learning_rate=learning_rate,
        epsilon=epsilon,
        discount=discount,
        total_days=total_days,
        initial_value=initial_value,
    )
    methods = {label(n): counted(make(n)) if count_passes else make(n) for n in depths}
    parameters = {"action_reward_noise_sigma": sigma, "n_actions": n_actions, "total_days": total_days}
    every = max(n_steps // points, total_days)
    return repeat(
        "Study", {**methods, **own}, n_steps, parameters=parameters, evaluate_every=every, evaluation_episodes=3, **how
    )


def pupil(n: float, study: Study, episodes: int, *, seed: int = 0) -> Any:
    """Return an n-step SARSA agent after so many episodes."""
    return train(study, maker(n, total_days=study.total_days)(study), episodes * study.total_days, seed=seed).agent


def layouts(results: Results) -> dict[int, Study]:
    """Return the task of each repetition of an experiment, which differ in their layouts."""
    if results.table.empty:
        return {}
    first = results.table.iloc[0]
    n_actions, days = int(first["environment.n_actions"]), int(first["environment.total_days"])
    seeds = results.table.groupby("repetition")["layout_seed"].first()
    return {i: Study.create(days, n_actions, layout_seed=int(seeds.loc[i])) for i in seeds.index.tolist()}


def expected_returns(results: Results, method: str) -> Reals:
    """Return the exact return of the final greedy policy of every complete run, shape (n_repetitions,); else NaN."""
    returns = np.full(len(results.final(method)), np.nan)
    tasks = layouts(results)
    for repetition, agent in results.complete_agents(method).items():
        returns[repetition] = greedy_return(tasks[repetition], agent)
    return returns


def greedy_return(task: Study, agent: Any) -> float:
    """Return the expected return of an agent's greedy policy: the rewards along its path, without their noise."""
    quiet = task._replace(sigma=0.0)
    rng = np.random.default_rng(0)  # for ties
    state, total = quiet.initial(rng), 0.0
    sizes = [int(size) for size in quiet.observation_space.nvec]
    while not quiet.terminal(state):
        row = int(np.ravel_multi_index(quiet.observation(state, rng), sizes))
        action = agent.greedy(row, rng)
        next_state = quiet.transition(state, action, rng)
        total += quiet.reward(state, action, next_state, rng)
        state = next_state
    return total


def passes(results: Results, method: str) -> Reals:
    """Return for every complete run whether its final greedy policy passes the exam: 1, 0 or NaN."""
    returns = expected_returns(results, method)
    return np.where(np.isnan(returns), np.nan, returns > PASSING)


def shortfall(results: Results, method: str) -> float:
    """Return how far the final policies that pass are below the optimum of their layouts, in the mean."""
    returns = expected_returns(results, method)
    optimum = np.array([task.reward_threshold for task in layouts(results).values()])
    passing = returns > PASSING
    return float((optimum - returns)[passing].mean()) if passing.any() else math.nan


def passes_in_training(results: Results, method: str) -> Reals:
    """Return for every complete run how often it passed the exam in training, where that was counted; else NaN."""
    passes = np.full(len(results.final(method)), np.nan)
    for repetition, agent in results.complete_agents(method).items():
        passes[repetition] = agent.passes[0]
    return passes


def met_exam(results: Results, method: str) -> Reals:
    """Return for every complete run whether it ever passed the exam in training: 1, 0 or NaN."""
    passes = passes_in_training(results, method)
    return np.where(np.isnan(passes), np.nan, passes > 0)


def kept(results: Results, method: str) -> Reals:
    """Return for every run that ever passed the exam in training whether it passes in the end: 1 or 0."""
    final: Reals = passes(results, method)[met_exam(results, method) == 1]
    return final


def best_returns(tasks: Mapping[int, Study], *epsilons: float) -> list[float]:
    """Return for each ε the best expected return with random actions with this probability, a mean over layouts."""
    seeds = [_key(task) for task in tasks.values()]
    return [float(np.mean([_best_return(key, one) for key in seeds])) for one in epsilons]


def _key(task: Study) -> tuple[tuple[int, ...], tuple[float, ...]]:
    """Return what tells the layouts of one kind of task apart."""
    return tuple(task.lectures.tolist()), tuple(task.action_rewards.tolist())


@cache
def _best_return(key: tuple[tuple[int, ...], tuple[float, ...]], epsilon: float) -> float:
    """Plan on the exact model of a layout, once."""
    lectures, rewards = (np.array(part) for part in key)
    standard = Study.create(len(lectures), len(rewards))
    task = standard._replace(lectures=lectures, action_rewards=rewards)
    return task.reward_threshold if epsilon == 0 else value_iteration(finite_model(task), epsilon=epsilon).start
