"""Training an agent on vectors of rewards."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from edugym.adapters.fitting import tabular
from edugym.checks.agents import checked_agent
from edugym.checks.contract import FOR_OBJECTIVES, Contract, contract_of, forget_episode, learner, tables_of
from edugym.checks.interfaces import NAMED, class_name
from edugym.checks.mdps import checked_mdp
from edugym.checks.parameters import number_of_steps, whole_number
from edugym.checks.tracebacks import end_at_students_line
from edugym.compiled.execution import executable
from edugym.mdp.multi_objective import require_objectives, vector
from edugym.mdp.protocol import Integers, Reals
from edugym.mdp.task import table_size
from edugym.system.interrupts import Interrupted
from edugym.system.memory import require_memory
from edugym.system.packages import is_own
from edugym.training.evaluated import actor
from edugym.training.steps import take_steps
from edugym.training.trainers import EVALUATION_LIMIT, NO_LIMIT, Chunk, streams
from edugym.training.vector_loops import Episodes, off_policy, play_episodes, start

MOST_EPISODES = 1_000_000
"""The most evaluation episodes of one point of a learning curve."""


@dataclass(frozen=True)
class VectorRun:
    """What one training run on vectors of rewards produced.

    Attributes:
        steps: shape (n_points,): the number of training steps to each point; the first is at 0.
        returns: shape (n_points, n_objectives): the mean undiscounted returns of the evaluation episodes.
        training_returns: shape (n_episodes, n_objectives): the undiscounted returns of each training episode that
            ended.
        training_ends: shape (n_episodes,): the training step at which each ended, from 1 on.
        agent: the trained agent. It shares its tables with the agent that you passed in.
        seed: the seed from which every random stream of this run comes.
        seconds: the time it took, with compiling.
        complete: False if it was stopped before its last point.
    """

    steps: Integers
    returns: Reals
    training_returns: Reals
    training_ends: Integers
    agent: Any
    seed: int
    seconds: float
    complete: bool


def train_vectors(
    environment: Any,
    agent: Any,
    n_steps: int,
    *,
    max_steps: int | None = None,
    evaluate_every: int | None = None,
    evaluation_episodes: int = 1,
    seed: int = 0,
    progress: bool = False,
    stop: Any = None,
) -> VectorRun:
    """Train an agent in a task with several objectives, and measure its returns in each objective.

        mdp = edugym.make_mdp("Diver")
        agent = ParetoQLearning.create(mdp, discount=1.0)
        run = train_vectors(mdp, agent, 10_000)

    An agent is as `edugym.train` takes it. Its `learn` may also have the parameter `rewards`: the vector of rewards, an
    array of shape (n_objectives,), which is a new one at each step. So agents that learn from the one number `reward`
    can be trained here as well, to see what they earn in each objective. Agents that learn from their next action,
    such as SARSA, are refused. From 5000 steps on the loop is compiled to machine code, if task and agent are the
    package's own; your own run interpreted, and are checked.

    Args:
        environment: a task with several objectives, an environment that plays one, or its name.
        agent: an agent with tables; they are changed in place.
        n_steps: the number of training steps, 1 or more.
        max_steps: the step at which an episode is truncated; by default the task's own limit, if it has one.
        evaluate_every: the steps between two points; by default `n_steps // 100`, at least 1.
        evaluation_episodes: the number of episodes that each point averages, from 1 to 1 000 000, as in `edugym.train`.
        seed: the seed of all random streams. If you create the agent anew and use the same seed, you get the same
            tables, bit for bit.
        progress: whether to show a progress bar.
        stop: a `threading.Event`. When it is set, training stops early and the `VectorRun` so far is returned.

    Raises:
        ValueError: a parameter is not as above, or the task or the agent does what it may not.
        Interrupted: Ctrl-C was pressed. Its `partial` is the `VectorRun` so far.
    """
    n_steps = number_of_steps("n_steps", n_steps)
    every = max(1, n_steps // 100) if evaluate_every is None else whole_number("evaluate_every", evaluate_every, 1)
    n_episodes = whole_number("evaluation_episodes", evaluation_episodes, 1, MOST_EPISODES)
    seed = whole_number("seed", seed, 0)
    mdp = require_objectives(environment, "environment", NAMED)
    contract = contract_of(agent, FOR_OBJECTIVES)
    limit = getattr(mdp, "max_steps", None) if max_steps is None else number_of_steps("max_steps", max_steps)
    n_objectives = int(mdp.reward_space.shape[0])
    require_memory("training_returns", (n_steps, n_objectives), "take fewer steps")
    _require_fitting(contract, mdp, n_objectives)
    began, points = time.perf_counter(), list[tuple[int, Reals]]()
    episodes = Episodes(np.zeros((n_steps, n_objectives)), np.zeros(n_steps, np.int64), np.zeros(2, np.int64))

    def begin(expected: int) -> "_Training":
        return _Training(mdp, contract, seed, limit, episodes, expected)

    def measure(steps: int, training: "_Training", _: Callable[[], bool]) -> None:
        points.append((steps, training.evaluate(n_episodes)))

    try:
        taken = take_steps(n_steps, begin, measure, measure_every=every, stop=stop, progress=progress)
    except Exception as error:
        end_at_students_line(error)
        raise
    ended = int(episodes.so_far[0])
    run = VectorRun(
        np.array([steps for steps, _ in points], np.int64),
        np.array([returns for _, returns in points]).reshape(-1, n_objectives),
        episodes.returns[:ended].copy(),
        episodes.ends[:ended].copy(),
        contract.agent,
        seed,
        time.perf_counter() - began,
        complete=bool(points) and points[-1][0] == n_steps,
    )
    if taken.interrupted:
        raise Interrupted(f"after {taken}; the agent keeps what it has learned", lambda: run)
    return run


def _require_fitting(contract: Contract, mdp: Any, n_objectives: int) -> None:
    """Refuse an agent without a table, or with one that was made for another task."""
    kind = class_name(contract.agent)
    if not contract.tabular:
        raise ValueError(f"agent must have a table, but is a {kind}")
    shape = table_size(mdp)
    table = tables_of(contract.agent).get("Q")
    if table is not None and table.shape not in (shape, (*shape, n_objectives)):
        raise ValueError(
            f"agent must have a table Q of shape {shape} or {(*shape, n_objectives)} for this task, but that of {kind}"
            f" has the shape {table.shape}"
        )


class _CheckedRewards:
    """A student's task with checks: what the methods return, the vector of rewards included."""

    def __init__(self, mdp: Any) -> None:
        self._mdp, self._checked = mdp, checked_mdp(tabular(mdp))

    def __getattr__(self, name: str) -> Any:
        return getattr(self._checked, name)

    def rewards(self, state: Any, action: int, next_state: Any) -> Reals:
        """The vector of rewards; an error names what is wrong with it."""
        return vector(self._mdp, state, action, next_state)


class _Training:
    """An agent that learns from vectors."""

    def __init__(
        self, mdp: Any, contract: Contract, seed: int, limit: int | None, episodes: Episodes, expected: int
    ) -> None:
        forget_episode(contract.agent)
        mdp_rng, agent_rng, self._evaluation_rng, self._actor_rng = streams(seed)
        compilable = is_own(mdp) and contract.is_own and tabular(mdp) is mdp
        self._mdp: Any = mdp if compilable else _CheckedRewards(mdp)
        learning = learner(contract, FOR_OBJECTIVES)
        agent = learning if compilable else checked_agent(learning, self._mdp)
        self._contract, self._limit = contract, limit or EVALUATION_LIMIT
        self._arguments = (self._mdp, agent, limit or NO_LIMIT, mdp_rng, agent_rng, episodes)
        self._carry = start(self._mdp, episodes.returns.shape[1], mdp_rng)
        self._n_objectives, self._chunk = episodes.returns.shape[1], Chunk()
        self._learn: Callable[..., Any] = off_policy
        self._play: Callable[..., Any] = play_episodes
        if compilable and getattr(contract.agent, "can_be_compiled", True):
            self._learn = executable(off_policy, (*self._arguments, self._carry), expected=expected)
            self._play = executable(play_episodes, self._evaluation(1), expected=expected)

    @property
    def is_compiled(self) -> bool:
        """Whether it runs as machine code."""
        return self._learn is not off_policy

    def learn(self, at_most: int) -> int:
        """Take training steps for about 0.02 s; return their number."""
        with self._chunk.steps(at_most) as n_steps:
            self._carry = self._learn(n_steps, *self._arguments, self._carry)
        return n_steps

    def evaluate(self, n_episodes: int) -> Reals:
        """The mean returns of episodes that the agent plays as it believes best, shape (n_objectives,)."""
        evaluation = self._evaluation(n_episodes)
        self._play(n_episodes, *evaluation)
        mean: Reals = evaluation[-1].mean(axis=0)
        return mean

    def _evaluation(self, n_episodes: int) -> tuple[Any, ...]:
        """The arguments of `play_episodes` but for the first."""
        returns = np.zeros((n_episodes, self._n_objectives))
        return self._mdp, actor(self._contract), self._limit, self._evaluation_rng, self._actor_rng, returns
