"""The methods of lesson 2 and their settings, how they are compared, and what is read off the runs."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.agents.expected_sarsa import ExpectedSARSA
from edugym.agents.q_learning import QLearning
from edugym.agents.sarsa import SARSA
from edugym.agents.strategies import EpsilonGreedy, LinearDecay, ScheduledEpsilonGreedy
from edugym.envs.roadrunner import Roadrunner, Runner
from edugym.experiments.repeat import repeat
from edugym.experiments.results.statistics import Interval, paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.wrapper import wrapper

N_STEPS = 200_000
POINTS = 20
REPETITIONS = 30
DISCOUNT = 1.0
EPSILON = 0.1
LEARNING_RATE = 0.03
Q_LEARNING, SARSA_, EXPECTED_SARSA = "Q-learning", "SARSA", "expected SARSA"
KINDS: Mapping[str, Any] = MappingProxyType({Q_LEARNING: QLearning, SARSA_: SARSA, EXPECTED_SARSA: ExpectedSARSA})
CLIFF = "CliffWalking-v1"
CLIFF_STEPS = 500
"""The step limit of an episode of CliffWalking, which has none of its own."""

Maker = Callable[..., Any]


@wrapper
class Icy(NamedTuple):
    """A road that makes the runner slip."""

    mdp: Any  # the dry road
    ice: float  # the probability of a slip

    def transition(self, state: Runner, action: int, rng: Random) -> Any:
        """Take the action, or with the probability of a slip a random one."""
        if rng.random() < self.ice:
            action = int(rng.random() * 3)
        return self.mdp.transition(state, action, rng)


def methods_with(
    epsilon: float = EPSILON, learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT
) -> dict[str, Maker]:
    """Return the three methods, by label: functions that make an agent for an environment.

    Args:
        epsilon: ε of all three, from 0 to 1.
        learning_rate: α of all three.
        discount: γ of all three.
    """
    return {
        label: partial(kind.create, learning_rate=learning_rate, discount=discount, exploration=EpsilonGreedy(epsilon))
        for label, kind in KINDS.items()
    }


def compare(
    *,
    epsilon: float = EPSILON,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    own: Mapping[str, Maker] = MappingProxyType({}),
    n_steps: int = N_STEPS,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    parameters: Mapping[str, Any] = MappingProxyType({}),
    environment: Any = "Roadrunner",
    **how: Any,
) -> Results:
    """Train the three methods: one panel of the figure.

    Args:
        epsilon: ε of all three, from 0 to 1.
        learning_rate: α of all three.
        discount: γ of all three.
        own: by label, functions that make agents to train beside the three.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each method.
        seed: the number from which all seeds are spawned.
        parameters: those of the environment, such as `stop_zone`.
        environment: its name or id, or a task itself, as for `repeat`.
        **how: more arguments of `edugym.experiments.repeat`, such as `jobs`, `progress` and `stop`.
    """
    methods = {**methods_with(epsilon, learning_rate, discount), **own}
    return _train(
        methods, n_steps, environment=environment, parameters=parameters, repetitions=repetitions, seed=seed, **how
    )


def compare_on_cliff(*, n_steps: int = 20_000, repetitions: int = 5, learning_rate: float = 0.1, **how: Any) -> Results:
    """Train the three methods on the cliff walk of Gymnasium; arguments as in `compare`."""
    return compare(
        environment=CLIFF,
        learning_rate=learning_rate,
        n_steps=n_steps,
        repetitions=repetitions,
        max_steps=CLIFF_STEPS,
        **how,
    )


def compare_on_ice(**how: Any) -> Results:
    """Train the three methods on the road with ice, which makes the runner slip with probability 0.1."""
    return compare(environment=Icy(make_mdp("Roadrunner"), ice=EPSILON), **how)


def let_epsilon_decay(*, n_steps: int = 2_000_000, **how: Any) -> Results:
    """Train the three methods while ε falls evenly from 0.1 to 0.001; arguments as in `compare`."""

    def decaying(kind: Any, environment: Any) -> Any:
        exploration = ScheduledEpsilonGreedy.create(LinearDecay(EPSILON, 0.001, n_steps))
        return kind.create(environment, learning_rate=LEARNING_RATE, discount=DISCOUNT, exploration=exploration)

    return _train({label: partial(decaying, kind) for label, kind in KINDS.items()}, n_steps, **how)


def _train(methods: Mapping[str, Maker], n_steps: int, *, environment: Any = "Roadrunner", **how: Any) -> Results:
    return repeat(environment, methods, n_steps, evaluate_every=max(1, n_steps // POINTS), **how)


def online(results: Results, method: str) -> Reals:
    """Return the mean return of the training episodes in the second half of training, shape (n_repetitions,)."""
    returns = results.curves(method, "training_return").to_numpy(float)
    episodes = results.curves(method, "episodes").to_numpy(float)
    half = len(returns) // 2 + 1  # the first point is step 0, and the point at half time is about the steps before it
    total = np.nansum(returns[half:] * episodes[half:], axis=0)
    mean: Reals = total / episodes[half:].sum(axis=0)
    return mean


def online_lead(results: Results, method: str, other: str = Q_LEARNING) -> Interval:
    """Return how much more `method` earns online than `other`, paired by repetition."""
    return paired_difference(online(results, method), online(results, other))


def stopping_places(results: Results, method: str, **parameters: Any) -> list[int]:
    """Return where each complete run of a method ends up when it acts greedily: the last x."""
    return [greedy_run(agent, **parameters)[-1].x for agent in results.complete_agents(method).values()]


def greedy_run(agent: Any, **parameters: Any) -> list[Runner]:
    """Return the states of one greedy episode on a road."""
    task = Roadrunner.create(**parameters)
    rng = np.random.default_rng(0)  # for ties
    state = task.initial(rng)
    states = [state]
    while not task.terminal(state) and len(states) <= task.max_steps:
        state = task.transition(state, agent.greedy(_row(task, state), rng), rng)
        states.append(Runner(int(state.x), int(state.dx)))
    return states


def first_fall(agent: Any, seed: int = 0) -> tuple[list[int], int]:
    """Play episodes as the agent does while it explores, until one ends over the edge; it learns nothing meanwhile.

    Returns:
        The actions of that episode, and how many episodes were played.
    """
    task, rng, episodes = Roadrunner.create(), np.random.default_rng(seed), 0
    while True:
        state, actions = task.initial(rng), list[int]()
        episodes += 1
        while not task.terminal(state) and len(actions) < task.max_steps:
            actions.append(int(agent.act(_row(task, state), rng)))
            state = task.transition(state, actions[-1], rng)
        if state.x == task.size:
            return actions, episodes


FAST_RUN: Mapping[tuple[int, int], int] = MappingProxyType({(0, 0): 2, (1, 1): 2, (3, 2): 2, (6, 3): 1})
"""The actions of the fast run on the usual road, by state."""


def go_on(agent: SARSA, share: float, n_steps: int = 20_000, seed: int = 0) -> SARSA:
    """Return what SARSA has learned after more steps with ε = 0.001, with the fast run on purpose in some episodes.

    Args:
        agent: what it has learned so far; it is left as it is.
        share: of the episodes, those with the fast run on purpose, without slips, from 0 to 1.
        n_steps: how many steps, at least; the last episode is played to its end.
        seed: of all random numbers.
    """
    task, rng = Roadrunner.create(), np.random.default_rng(seed)
    strategy = EpsilonGreedy(0.001)
    after = SARSA.create(agent.Q.shape, learning_rate=LEARNING_RATE, discount=DISCOUNT, exploration=strategy)
    after.Q[:] = agent.Q
    taken = 0
    while taken < n_steps:
        plan = FAST_RUN if rng.random() < share else {}

        def act(state: Runner, plan: Mapping[tuple[int, int], int] = plan) -> int:
            return plan[state] if state in plan else int(after.act(_row(task, state), rng))

        state, over = task.initial(rng), False
        action = act(state)
        while not over:
            following = Runner(*task.transition(state, action, rng))
            over, next_action = task.terminal(following), act(following)
            reward = task.reward(state, action, following, rng)
            after.learn(_row(task, state), action, reward, _row(task, following), next_action, over)
            state, action, taken = following, next_action, taken + 1
    return after


def mean_values(results: Results, method: str, *, x: int, dx: int) -> Reals:
    """Return the values of the three actions in a state of the usual road, a mean over the complete runs."""
    row = _row(Roadrunner.create(), Runner(x, dx))
    mean: Reals = np.mean([agent.Q[row] for agent in results.complete_agents(method).values()], axis=0)
    return mean


def _row(task: Roadrunner, state: Runner) -> int:
    """Return the row of a table for a state."""
    return int(state.x) * (task.max_speed + 1) + max(int(state.dx), 0)


def walk(agent: Any, max_steps: int = 60) -> list[tuple[int, int]]:
    """Return the cells, as (column, row), of one greedy episode on the cliff walk of Gymnasium."""
    env, rng = gymnasium.make(CLIFF), np.random.default_rng(0)
    state, _ = env.reset(seed=0)
    cells, over = [divmod(int(state), 12)[::-1]], False
    while not over and len(cells) <= max_steps:
        state, _, over, _, _ = env.step(int(agent.greedy(int(state), rng)))
        cells.append(divmod(int(state), 12)[::-1])
    return cells


def most_frequent(paths: Sequence[Sequence[tuple[int, int]]]) -> list[tuple[int, int]]:
    """Return the path that most runs take; among equals, the first."""
    keys = [tuple(map(tuple, path)) for path in paths]
    return [*paths[keys.index(max(keys, key=keys.count))]]
