"""Trainers train an agent and evaluate it: one in MDPs, one in any other Gymnasium environment.

`trainer` validates environment and agent (`task_of`, `contract_of`), fits the task to the agent, and chooses the
trainer.
"""

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Protocol

import numpy as np

from edugym.adapters.double_buffer import DoubleBuffer
from edugym.adapters.fitting import fitted
from edugym.checks.afterwards import before_training, warnings_after
from edugym.checks.agents import checked_agent
from edugym.checks.contract import Contract, contract_of, forget_episode, learner
from edugym.checks.envs import checked_env
from edugym.checks.mdps import CHECKED_STEPS, checked_mdp
from edugym.checks.values import deep_copy
from edugym.compiled.execution import COMPILE_FROM, executable
from edugym.mdp.guards import GUARDS, guarded
from edugym.mdp.task import Task, task_of
from edugym.system.interrupts import deferring_signals
from edugym.training import gymnasium_loops, loops
from edugym.training.evaluated import actor
from edugym.training.loops import Log
from edugym.training.machine_agent import MachineAgent
from edugym.training.run import Run
from edugym.training.steps import Learning

CALL_SECONDS = 0.02
"""About how long one call of `learn` takes: signals are looked at between two calls."""
FIRST_STEPS = 50
"""How many steps the first call takes, when it is not known how long a step takes."""
EPISODES = 100
"""Every so many interpreted evaluation episodes, try again to compile; most runs evaluate about as many."""
NO_LIMIT = 2**62
"""The step limit that stands for none: no episode reaches it."""
MOST_STEPS = 10_000
"""The steps that evaluation takes in one call of machine code, unless one episode is longer: some milliseconds."""
EVALUATION_LIMIT = 1_000
"""The step limit of an evaluation episode where the task has none: a greedy policy may never get anywhere."""


class Trainer(Learning, Protocol):
    """An agent in a task.

    Attributes:
        agent: the agent, whose tables change as it learns.
        log: sums over the training episodes that ended.
    """

    agent: Any
    log: Log

    def play_episodes(self, at_most: int) -> list[float]:
        """Play an episode or more without learning, as the agent believes best; return their undiscounted returns."""

    def warnings(self, run: Run) -> list[str]:
        """What is probably wrong with what has been trained, in a sentence each."""


def trainer(environment: Any, agent: Any, seed: int, max_steps: int | None, expected: int) -> Trainer:
    """The trainer for an environment and an agent.

    Args:
        environment: an MDP, a Gymnasium environment, or the name or id of one.
        agent: an agent for it.
        seed: from which the random streams of environment, agent and evaluation are spawned.
        max_steps: the step at which an episode is truncated; None for the environment's own limit.
        expected: the number of steps in all; fewer than some thousands are not worth compiling.

    Raises:
        ValueError: the environment or the agent is invalid, or they do not fit each other.
    """
    task, contract = task_of(environment), contract_of(agent)
    task = fitted(task, contract)
    forget_episode(contract.agent)
    kind = MDPTrainer if task.is_mdp else GymnasiumTrainer
    return kind(task, contract, seed, max_steps or task.max_steps, expected)


class MDPTrainer:
    """Trains and evaluates an agent in an MDP, as machine code where that pays.

    The first training steps and the first evaluation episode of students' code run interpreted and checked (see
    `edugym.checks`). They are part of the run: nothing happens twice.
    """

    def __init__(self, task: Task, contract: Contract, seed: int, limit: int | None, expected: int) -> None:
        """See `trainer`; without a limit, `limit` is None."""
        self.agent, self._task, self._expected = contract.agent, task.played, expected
        self.log, self._chunk = new_log(), Chunk()
        self._contract, self._before = contract, before_training(contract)
        environment_rng, agent_rng, self._evaluation_rng, self._actor_rng = streams(seed)
        self._limit, self._evaluation_limit = limit, limit or EVALUATION_LIMIT
        training = DoubleBuffer(task.played, self.agent, contract.is_on_policy, guarded)
        self._playing = DoubleBuffer(task.played, self.agent, False, guarded)
        self._is_own = contract.is_own and task.is_own
        self._steps_to_check = 0 if self._is_own else CHECKED_STEPS
        self._plain_arguments = (
            training.mdp,
            training.of(learner(contract)),
            limit or NO_LIMIT,
            environment_rng,
            agent_rng,
            self.log,
        )
        self._checked_arguments = self._checked(*self._plain_arguments)
        mdp, learning, *_ = self._checked_arguments
        self._loop: Callable[..., Any]
        self._advance: Callable[..., Any]
        self._carry: Any
        if contract.is_on_policy:
            self._loop, self._carry = loops.on_policy, loops.start_on_policy(mdp, learning, environment_rng, agent_rng)
        else:
            self._loop, self._carry = loops.off_policy, loops.start_off_policy(mdp, environment_rng)
        self._advance, self._play = self._loop, loops.play_episodes
        self._interpreted_episodes = 0
        if self._is_own:
            self._compile_training()
            self._compile_playing()

    @property
    def is_compiled(self) -> bool:
        """Whether the training loop runs as machine code by now."""
        return self._advance is not self._loop

    def learn(self, at_most: int) -> int:
        """Take training steps, as many as take about `CALL_SECONDS`; return their number."""
        if not self._steps_to_check:
            arguments = self._plain_arguments if self.is_compiled else self._checked_arguments
            with self._chunk.steps(at_most) as n_steps:
                self._carry = self._advance(n_steps, *arguments, self._carry)
            return n_steps
        with self._chunk.steps(min(at_most, self._steps_to_check)) as n_steps:
            self._carry = self._loop(n_steps, *self._checked_arguments, self._carry)
        self._steps_to_check -= n_steps
        if not self._steps_to_check:
            self._compile_training()
        return n_steps

    def play_episodes(self, at_most: int) -> list[float]:
        """Play an episode without learning, as the agent believes best, or several in one call of machine code.

        Several only if they are short, and if the agent has `greedy`: others play each episode with a new copy.

        Returns:
            The undiscounted return of each.
        """
        compiled = self._play is not loops.play_episodes
        together = compiled and self._contract.has_greedy
        n_episodes = min(at_most, max(1, MOST_STEPS // self._evaluation_limit)) if together else 1
        evaluation = self._evaluation(n_episodes)
        with deferring_signals(machine_code=compiled):
            if compiled:
                self._play(n_episodes, *evaluation)
            else:
                steps = 0 if self._is_own or self._interpreted_episodes else CHECKED_STEPS
                self._play(n_episodes, *self._checked(*evaluation, steps=steps))
                self._interpreted_episodes += 1
                if not self._is_own and self._interpreted_episodes % EPISODES == 1:  # after the first, 101st, ...
                    self._compile_playing()
        returns: list[float] = evaluation[-1].tolist()
        return returns

    def warnings(self, run: Run) -> list[str]:
        """What is probably wrong with what has been trained, in a sentence each."""
        return warnings_after(self._task, self.agent, self._limit, run, self._before)

    def _compile_training(self) -> None:
        """From now on train by machine code, if that pays and is possible; where that fails, checks say why."""
        self._advance = executable(
            self._loop,
            (*self._plain_arguments, self._carry),
            expected=self._expected,
            replay=lambda n, *rest: self._loop(n, *self._checked(*rest, steps=math.inf)),
        )

    def _compile_playing(self) -> None:
        mdp, agent, limit, *rest = self._evaluation()
        of_students = EPISODES if self._expected >= COMPILE_FROM else 0
        self._play = executable(
            loops.play_episodes,
            (mdp, agent, min(limit, CHECKED_STEPS), *rest),
            expected=self._expected if self._is_own else of_students,
            rehearsed=1,
            replay=lambda n, *rest: loops.play_episodes(n, *self._checked(*rest, steps=math.inf)),
        )

    def _checked(self, mdp: Any, agent: Any, *rest: Any, steps: float = CHECKED_STEPS) -> tuple[Any, ...]:
        """The arguments of a loop with a student's MDP and agent checked."""
        return checked_mdp(mdp, steps, instead_of=GUARDS), checked_agent(agent, self._task, steps), *rest

    def _evaluation(self, n_episodes: int = 1) -> tuple[Any, ...]:
        """The arguments of `play_episodes` after the number of episodes; it writes returns into the last."""
        limit, evaluation_rng, actor_rng = self._evaluation_limit, self._evaluation_rng, self._actor_rng
        playing = self._playing
        return playing.mdp, playing.of(actor(self._contract)), limit, evaluation_rng, actor_rng, np.zeros(n_episodes)


class GymnasiumTrainer:
    """Trains and evaluates an agent in any Gymnasium environment, in plain Python; the first steps are checked."""

    is_compiled = False

    def __init__(self, task: Task, contract: Contract, seed: int, limit: int | None, expected: int) -> None:
        """See `trainer`; the limit is None where it is not known."""
        env = task.played
        self.agent, self._env, self._expected = contract.agent, env, expected
        self.log, self._chunk = new_log(), Chunk()
        environment_rng, self._agent_rng, self._evaluation_rng, self._actor_rng = streams(seed)
        self._evaluated = deep_copy(env, "evaluation plays a copy: make it in reset")  # before anything is drawn
        self._limit, self._contract, self._before = limit, contract, before_training(contract)
        self._learner: Any = checked_agent(learner(contract), env)
        self._actor: Any = None
        self._steps_to_check, self._has_played = CHECKED_STEPS, False
        with checked_env(env) as checked:
            observation, _ = checked.reset(seed=gymnasium_loops.draw_seed(environment_rng))
        self._carry: Any = (None, observation, 0, 0.0)
        self._loop: Callable[..., Any] = gymnasium_loops.off_policy
        if contract.is_on_policy:
            self._loop = gymnasium_loops.on_policy
            self._carry = (None, observation, self._learner.act(observation, self._agent_rng), 0, 0.0)
        if contract.is_own:
            self._compile(observation)

    def learn(self, at_most: int) -> int:
        """Take training steps, as many as take about `CALL_SECONDS`; return their number."""
        if not self._steps_to_check:
            with self._chunk.steps(at_most) as n_steps, checked_env(self._env, steps=0) as env:
                self._advance(n_steps, env)
            return n_steps
        with self._chunk.steps(min(at_most, self._steps_to_check)) as n_steps, checked_env(self._env) as env:
            self._advance(n_steps, env)
        self._steps_to_check -= n_steps
        if not self._steps_to_check and not self._contract.is_own:
            self._compile(self._carry[1])
        return n_steps

    def play_episodes(self, at_most: int) -> list[float]:
        """Play one episode without learning, as the agent believes best; return its undiscounted return."""
        steps, self._has_played = 0 if self._has_played else CHECKED_STEPS, True
        with checked_env(self._evaluated, steps) as env:
            return [self._played(env, self._actor or checked_agent(actor(self._contract), self._evaluated, steps))]

    def warnings(self, run: Run) -> list[str]:
        """What is probably wrong with what has been trained, in a sentence each."""
        return warnings_after(self._env, self.agent, self._limit, run, self._before)

    def _advance(self, n_steps: int, env: Any) -> None:
        limit = self._limit or NO_LIMIT
        self._carry = self._loop(n_steps, env, self._learner, limit, self._agent_rng, self.log, self._carry)

    def _played(self, env: Any, player: Any) -> float:
        limit = self._limit or EVALUATION_LIMIT
        return gymnasium_loops.play_episode(env, player, limit, self._evaluation_rng, self._actor_rng)

    def _compile(self, observation: Any) -> None:
        """From now on the agent alone runs as machine code, where it takes vectors and that pays."""
        self._learner = checked_agent(learner(self._contract), self._env, steps=0)
        if self._contract.takes_vectors:
            self._learner = MachineAgent(learner(self._contract), self._agent_rng, observation, self._expected)
            self._actor = MachineAgent(actor(self._contract), self._actor_rng, observation, self._expected)


class Chunk:
    """How many steps a call takes. How a run is cut into calls does not change its results."""

    def __init__(self) -> None:
        """Begin with few."""
        self._steps = FIRST_STEPS

    @contextmanager
    def steps(self, at_most: int) -> Iterator[int]:
        """Yield a number of steps, and measure how long they take."""
        steps, began = min(self._steps, at_most), time.perf_counter()
        yield steps
        seconds = time.perf_counter() - began
        if seconds > CALL_SECONDS:
            self._steps = max(1, int(steps * CALL_SECONDS / seconds))
        elif steps == self._steps and seconds < CALL_SECONDS / 2:
            self._steps *= 2


def streams(seed: int) -> list[np.random.Generator]:
    """The random streams of environment, agent, evaluation, and of the agent while it is evaluated."""
    return [np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(4)]


def new_log() -> Log:
    """A log of no episodes."""
    return Log(np.zeros(1), np.zeros(1, np.int64))
