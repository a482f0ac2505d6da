"""Learning curves of agents that play many copies of an environment at a time, as the same `Run` as `train` gives."""

import math
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import gymnasium
import numpy as np
import torch
from gymnasium.vector import AutoresetMode, VectorEnv

from edugym.adapters.gymnasium_env import environment_of
from edugym.adapters.registration import ENVIRONMENTS, make_environment
from edugym.adapters.vector_env import MOST_COPIES, MDPVectorEnv
from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.parameters import in_short, whole_number
from edugym.mdp.task import full_id, task_of
from edugym.training.run import Run
from edugym.training.trainers import EVALUATION_LIMIT

Policy = Callable[[Any, Any], Any]
"""Actions of all copies, given what they observe and where an episode has just begun, shape (n,)."""


def copies(environment: Any, n: int, parameters: Mapping[str, Any]) -> Any:
    """Copies of an environment, reset in the step in which an episode ends.

    Args:
        environment: the name of an environment of this package, an id that Gymnasium knows, an environment of one's
            own such as `MDPEnv(Walk(7))`, or its MDP.
        n: how many, 1 or more.
        parameters: those of an environment that is given by name.

    Raises:
        ValueError: there is no such environment, it has no such parameter, or it is not given by name and there are
            parameters.
    """
    if isinstance(environment, str):
        name = full_id(environment)
        if name not in [entry.id for entry in ENVIRONMENTS]:
            options = {"autoreset_mode": AutoresetMode.SAME_STEP}
            made: VectorEnv[Any, Any, Any] = gymnasium.make_vec(
                name, n, "sync", vector_kwargs=options, **dict(parameters)
            )
            return made
        return MDPVectorEnv(make_environment(environment, **parameters), n, "SameStep")
    if parameters:
        raise ValueError(f"parameters are for an environment given by its name, but are {in_short(parameters)}")
    return MDPVectorEnv(environment_of(environment), n, "SameStep")


class Curve:
    """The learning curve of a run, while it is made.

    Args:
        environment: what is played, as for `copies`.
        parameters: those of an environment that is given by name.
        policy: makes the policy that is evaluated, for an evaluation.
        every: training steps between two points; the first is at 0.
        n_episodes: how many episodes each point averages.
        seed: from which the episodes are seeded.
    """

    def __init__(
        self,
        environment: Any,
        parameters: Mapping[str, Any],
        policy: Callable[[], Policy],
        every: int,
        n_episodes: int,
        seed: int,
    ) -> None:
        """See the class."""
        self._env = copies(environment, whole_number("evaluation_episodes", n_episodes, 1, MOST_COPIES), parameters)
        self._policy, self._every = policy, whole_number("evaluate_every", every, 1)
        self._rng = np.random.default_rng(seed)
        self._began = time.perf_counter()
        self._points: list[tuple[int, float, float, int]] = []
        self._sums: Any = 0.0  # of the rewards of the episodes under way
        self._ended: list[float] = []  # the returns of those that have ended since the last point

    def add(self, steps: int, rewards: Any, over: Any) -> None:
        """Take note of a step in every copy, after `steps` in all, and add a point where one is due."""
        self._sums = self._sums + rewards
        self._ended += self._sums[over].tolist()
        self._sums = np.where(over, 0.0, self._sums)
        if steps >= self._points[-1][0] + self._every:
            self.measure(steps)

    def measure(self, steps: int) -> None:
        """Add a point."""
        n = len(self._ended)
        self._points.append((steps, self._evaluate(), float(np.mean(self._ended)) if n else math.nan, n))
        self._ended = []

    def run(self, agent: Any, steps: int, seed: int) -> Run:
        """The run, with a last point after `steps`."""
        if self._points[-1][0] < steps:
            self.measure(steps)
        done, returns, training_returns, episodes = (np.array(column) for column in zip(*self._points, strict=True))
        return Run(
            steps=done,
            returns=returns,
            training_returns=training_returns,
            episodes=episodes,
            agent=agent,
            seed=seed,
            seconds=time.perf_counter() - self._began,
            complete=True,
        )

    def _evaluate(self) -> float:
        """The mean undiscounted return of an episode in each copy."""
        n, policy = self._env.num_envs, self._policy()
        observations, _ = self._env.reset(seed=int(self._rng.integers(2**31)))
        first, going_on, returns = np.ones(n, np.bool_), np.ones(n, np.bool_), np.zeros(n)
        for _ in range(_step_limit(self._env) or EVALUATION_LIMIT):
            observations, rewards, terminated, truncated, _ = self._env.step(policy(observations, first))
            returns += going_on * rewards
            first = terminated | truncated
            going_on &= ~first
            if not going_on.any():
                break
        return float(returns.mean())


def _step_limit(env: Any) -> int | None:
    """The step limit of the task, or None where it has none."""
    if isinstance(env, MDPVectorEnv):
        return task_of(env.mdp, "mdp", MDP_ONLY).max_steps
    limit: int | None = env.get_attr("spec")[0].max_episode_steps
    return limit


@contextmanager
def one_thread() -> Iterator[None]:
    """Let torch compute in one thread: more only get into each other's way in networks this small."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(before)
