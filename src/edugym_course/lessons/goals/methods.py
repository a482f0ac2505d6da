"""The agents of lesson 11 on Switches: a network and a table, with several kinds of hindsight, and what they know."""

import math
from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.adapters.registration import make_mdp
from edugym.agents.hindsight import FinalGoal, FutureGoals, Hindsight, NoHindsight
from edugym.agents.hindsight_dqn import HindsightDQN
from edugym.agents.hindsight_q_learning import HindsightQLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.switches import Panel, Switches
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.training.train import train

N_SWITCHES = 8
N_STEPS = 15_000
REPETITIONS = 5
POINTS = 10
EPISODES = 100
"""The greedy episodes of each point: each has another goal."""
DISCOUNT = 0.99
EPSILON = 0.1
LEARNING_RATE = 1.0
"""α of the table: no step depends on chance, so one look is enough."""
NONE, FINAL, FUTURE, OTHERS = "no hindsight", "final", "future", "goals of other episodes"
FAR_BACK = 64
"""From how many of the latest transitions before an episode `OtherEpisodes` takes its goals."""

Maker = Callable[[Any], Any]


class OtherEpisodes(NamedTuple):
    """The negative control: the goals are patterns that *other* episodes achieved, a little earlier.

    Attributes:
        goals: how many for each step.
    """

    goals: int = 4

    def achieved_after(self, t: int, length: int, draw: float) -> int:
        """The number of a step before the episode, so below 0; in the memory of a network it is there."""
        return -1 - int(draw * FAR_BACK)


STRATEGIES: Mapping[str, Hindsight] = MappingProxyType(
    {NONE: NoHindsight(), FINAL: FinalGoal(), FUTURE: FutureGoals(4), OTHERS: OtherEpisodes(4)}
)


def network(strategy: str, **settings: Any) -> Maker:
    """Return a function that makes a network with hindsight, by the name of the strategy."""
    return partial(HindsightDQN.create, hindsight=STRATEGIES[strategy], **settings)


def table(strategy: str, **settings: Any) -> Maker:
    """Return a function that makes a table with hindsight, by the name of the strategy."""
    defaults = {"learning_rate": LEARNING_RATE, "hindsight": STRATEGIES[strategy]}
    return partial(HindsightQLearning.create, **{**defaults, **settings})


def learn(n_switches: int, methods: Mapping[str, Maker], n_steps: int = N_STEPS, **how: Any) -> Results:
    """Train methods on Switches.

    Args:
        n_switches: how many switches there are.
        methods: by label, functions that make an agent for an environment.
        n_steps: the training steps of each run.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    settings = {
        "repetitions": REPETITIONS,
        "evaluate_every": max(1, n_steps // POINTS),
        "evaluation_episodes": EPISODES,
    }
    return repeat(make_mdp("Switches", n_switches=n_switches), methods, n_steps, **{**settings, **how})


def networks(n_switches: int = N_SWITCHES, strategies: tuple[str, ...] = (NONE, FUTURE, FINAL), **how: Any) -> Results:
    """Train networks with some strategies of hindsight; other arguments as in `learn`."""
    return learn(n_switches, {strategy: network(strategy) for strategy in strategies}, **how)


def at_random(**how: Any) -> Results:
    """Train networks that flip at random as long as they learn, with 'future' and without hindsight; as in `learn`."""
    random = EpsilonGreedy(1.0)
    return learn(
        N_SWITCHES, {f"{strategy}, ε = 1": network(strategy, exploration=random) for strategy in (NONE, FUTURE)}, **how
    )


def tables(
    n_switches: int = N_SWITCHES,
    strategies: tuple[str, ...] = (NONE, FUTURE),
    first_value: float = 0.0,
    **how: Any,
) -> Results:
    """Train tables whose values start at `first_value`, with strategies of hindsight; other arguments as in `learn`."""
    made = {strategy: table(strategy, initial_value=first_value) for strategy in strategies}
    return learn(n_switches, made, **how)


def best_return(n_switches: int) -> float:
    """Return the best expected return of an episode: -(d - 1) for the distance d at the start, in the mean."""
    best: float = make_mdp("Switches", n_switches=n_switches).reward_threshold
    return best


def chance_of_random_play(n_switches: int, max_steps: int | None = None) -> float:
    """Return how likely random flips reach the goal within an episode, exactly.

    A random flip brings the distance d down to d - 1 with probability d / n, and else up to d + 1.
    """
    n = n_switches
    at = np.array([0.0, *(math.comb(n, d) for d in range(1, n + 1))]) / (2**n - 1)  # the distance at the start
    for _ in range(n if max_steps is None else max_steps):
        after = np.zeros(n + 1)
        after[0] = at[0]
        for d in range(1, n + 1):
            after[d - 1] += at[d] * d / n
            if d < n:
                after[d + 1] += at[d] * (n - d) / n
        at = after
    return float(at[0])


def rewarded_share(strategy: str, n_switches: int = N_SWITCHES, n_steps: int = 1_000, seed: int = 0) -> float:
    """Return which share of the transitions in a memory reach their goal; the network does not learn."""
    task = make_mdp("Switches", n_switches=n_switches)
    agent = network(strategy, learn_from=10 * n_steps, memory_size=10 * n_steps)(task)
    memory, steps = agent.dqn.memory, agent.dqn.steps
    train(task, agent, n_steps, seed=seed, evaluate_every=n_steps)
    return float(memory.terminated[: int(steps[0])].mean())


def far_shares(results: Results, method: str, far: int = 6) -> Reals:
    """Return the share of transitions in each network's memory whose goal is `far` flips away, or more."""
    shares = []
    for agent in results.complete_agents(method).values():
        held, size = agent.dqn.memory.states[: int(agent.dqn.steps[0])], agent.goal_size
        wrong = np.abs(held[:, :size] - held[:, size:]).sum(axis=1) / 2  # each switch is seen as two numbers
        shares.append((wrong > far - 0.5).mean())
    return np.array(shares)


def true_value(distance: int, discount: float = DISCOUNT) -> float:
    """Return the value of the best action, so many flips from the goal."""
    return -sum(discount**k for k in range(distance - 1))


def greedily(task: Switches, agent: Any) -> Callable[[Any], int]:
    """Return what a network does without exploring, as a function of what is seen, for `frames`."""
    rng = np.random.default_rng(0)  # for ties
    return lambda seen: int(agent.greedy(spaces.flatten(task.observation_space, seen), rng))


def values_by_distance(results: Results, method: str, pairs: int = 50) -> Reals:
    """Return what the networks of a method believe of the best action, by distance from 1 on: shape (n, n_repetitions).

    Args:
        results: of networks on Switches.
        method: its label.
        pairs: over how many pairs of a pattern and a goal at this distance the mean is taken.
    """
    agents = results.complete_agents(method).values()
    n = next(iter(agents)).n_actions
    task, rng = Switches.create(n), np.random.default_rng(0)
    means = np.zeros((n, len(agents)))
    for d in range(1, n + 1):
        for _ in range(pairs):
            goal = int(rng.integers(2**n))
            wrong = rng.choice(n, d, replace=False)
            state = Panel(goal ^ int(np.sum(1 << wrong)), goal)
            seen = spaces.flatten(task.observation_space, task.observation(state, rng))
            for i, agent in enumerate(agents):
                agent.dqn.write_values(seen)
                means[d - 1, i] += agent.Q.max() / pairs
    return means
