"""Who trains an agent, and evaluates it: one for MDPs, one for any other Gymnasium environment.

`trainer` resolves what a user gave (a name, an environment, a wrapped one, an MDP) once; from there on there is one
form of everything.
"""

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Protocol

import gymnasium
import numpy as np

from edugym.adapters.fitting import fitting, takes_vectors
from edugym.adapters.registration import full_id
from edugym.adapters.rooms import View
from edugym.checks.mdps import CHECKED_STEPS, checked_mdp, is_own, require_task
from edugym.checks.values import own_copy
from edugym.compiled.execution import COMPILE_FROM, executable
from edugym.mdp.protocol import coerced
from edugym.system.interrupts import held
from edugym.training import gymnasium_loops, loops
from edugym.training.checked_env import checked_env
from edugym.training.checking import before_training, checked_agent, doubts
from edugym.training.contract import actor, forget_episode, is_on_policy, learner, learns_from, tables_of
from edugym.training.guarded import GUARDS, guarded
from edugym.training.loops import Log
from edugym.training.machine_agent import MachineAgent
from edugym.training.run import Run

CALL_SECONDS = 0.02
"""About how long one call of `learn` takes: signals are looked at between two calls."""
FIRST_STEPS = 50
"""How many steps the first call takes, when it is not known how long a step takes."""
EPISODES = 100
"""After so many interpreted evaluation episodes it is asked again whether machine code pays; most runs have as many."""
NO_LIMIT = 2**62
MOST_STEPS = 10_000
"""The steps that evaluation takes in one call of machine code, unless one episode is longer: some milliseconds."""
EVALUATION_LIMIT = 1_000
"""The step limit of an evaluation episode where the task has none: a greedy policy may never get anywhere."""


class Trainer(Protocol):
    """An agent in a task.

    Attributes:
        agent: the agent, whose tables change as it learns.
        log: sums over the training episodes that ended.
    """

    agent: Any
    log: Log

    @property
    def is_compiled(self) -> bool:
        """Whether training runs as machine code by now."""

    def learn(self, at_most: int) -> int:
        """Take training steps, as many as take about `CALL_SECONDS`; return their number."""

    def play_episodes(self, at_most: int) -> list[float]:
        """Play an episode or more without learning, as the agent believes best; return their undiscounted returns."""

    def doubts(self, run: Run) -> list[str]:
        """Return what is probably wrong with what has been trained, in a sentence each."""


def trainer(environment: Any, agent: Any, seed: int, max_steps: int | None, expected: int) -> Trainer:
    """Return the trainer for an environment and an agent.

    Args:
        environment: an MDP, a Gymnasium environment, or the name or id of one.
        agent: an agent for it.
        seed: from which the random streams of environment, agent and evaluation are spawned.
        max_steps: the step at which an episode is truncated; None for the environment's own limit.
        expected: the number of steps in all; fewer than some thousands are not worth compiling.

    Raises:
        ValueError: one is no environment or no agent, or they do not fit each other.
    """
    if isinstance(environment, str):
        environment = gymnasium.make(full_id(environment))
    limit = require_task(environment)
    learns_from(agent)  # refuses what is no agent
    agent = coerced(agent)
    task = coerced(fitting(environment, agent, tables_of(agent)))
    forget_episode(agent)
    kind = GymnasiumTrainer if isinstance(task, gymnasium.Env) else MDPTrainer
    return kind(task, agent, seed, max_steps or limit, expected)


class MDPTrainer:
    """Trains and evaluates an agent in an MDP, as machine code where that pays.

    The first training steps and the first evaluation episode of students' code run interpreted and checked (see
    `edugym.training.checking`). They are part of the run: nothing happens twice.
    """

    def __init__(self, mdp: Any, agent: Any, seed: int, limit: int | None, expected: int) -> None:
        """See `trainer`; the limit is None where the task has none."""
        self.agent, self.log, self._pace, self._task, self._expected = agent, new_log(), Pace(), mdp, expected
        self._before = before_training(agent)
        environment_rng, agent_rng, self._evaluation_rng, self._actor_rng = streams(seed)
        self._evaluation_limit = limit or EVALUATION_LIMIT
        training, self._playing = (View(mdp, agent, on_policy, guarded) for on_policy in (is_on_policy(agent), False))
        self._is_own = is_own(mdp) and is_own(agent)
        self._steps_to_check = 0 if self._is_own else CHECKED_STEPS
        self._rest = (
            training.mdp,
            training.of(learner(agent)),
            limit or NO_LIMIT,
            environment_rng,
            agent_rng,
            self.log,
        )
        self._first = mdp, learning, *_ = self._checked(*self._rest)
        self._loop: Callable[..., Any]
        self._advance: Callable[..., Any]
        self._moment: Any
        if is_on_policy(agent):
            self._loop, self._moment = loops.on_policy, loops.start_on_policy(mdp, learning, environment_rng, agent_rng)
        else:
            self._loop, self._moment = loops.off_policy, loops.start_off_policy(mdp, environment_rng)
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
            arguments = self._rest if self.is_compiled else self._first
            with self._pace.steps(at_most) as n_steps:
                self._moment = self._advance(n_steps, *arguments, self._moment)
            return n_steps
        with self._pace.steps(min(at_most, self._steps_to_check)) as n_steps:
            self._moment = self._loop(n_steps, *self._first, self._moment)
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
        together = compiled and hasattr(self.agent, "greedy")
        n_episodes = min(at_most, max(1, MOST_STEPS // self._evaluation_limit)) if together else 1
        evaluation = self._evaluation(n_episodes)
        with held(machine_code=compiled):
            if compiled:
                self._play(n_episodes, *evaluation)
            else:
                steps = 0 if self._is_own or self._interpreted_episodes else CHECKED_STEPS
                self._play(n_episodes, *self._checked(*evaluation, steps=steps))
                self._interpreted_episodes += 1
                if not self._is_own and self._interpreted_episodes % EPISODES == 1:
                    self._compile_playing()
        returns: list[float] = evaluation[-1].tolist()
        return returns

    def doubts(self, run: Run) -> list[str]:
        """Return what is probably wrong with what has been trained, in a sentence each."""
        limit = self._rest[2]
        known = None if limit == NO_LIMIT else limit
        return doubts(self._task, self.agent, known, run, self._before)

    def _compile_training(self) -> None:
        """From now on train by machine code, if that pays and is possible; where that fails, checks say why."""
        self._advance = executable(
            self._loop,
            (*self._rest, self._moment),
            expected=self._expected,
            replay=lambda n, *rest: self._loop(n, *self._checked(*rest, steps=math.inf)),
        )

    def _compile_playing(self) -> None:
        mdp, agent, limit, *rest = self._evaluation()
        self._play = executable(
            loops.play_episodes,
            (mdp, agent, min(limit, CHECKED_STEPS), *rest),
            expected=self._expected if self._is_own else EPISODES * (self._expected >= COMPILE_FROM),
            rehearsed=1,
            replay=lambda n, *rest: loops.play_episodes(n, *self._checked(*rest, steps=math.inf)),
        )

    def _checked(self, mdp: Any, agent: Any, *rest: Any, steps: float = CHECKED_STEPS) -> tuple[Any, ...]:
        """Return the arguments of a loop with a student's MDP and agent checked."""
        return checked_mdp(mdp, steps, instead_of=GUARDS), checked_agent(agent, self._task, steps), *rest

    def _evaluation(self, n_episodes: int = 1) -> tuple[Any, ...]:
        """Return the arguments of `play_episodes` after the number of episodes; it writes returns into the last."""
        limit, evaluation_rng, actor_rng = self._evaluation_limit, self._evaluation_rng, self._actor_rng
        playing = self._playing
        return playing.mdp, playing.of(actor(self.agent)), limit, evaluation_rng, actor_rng, np.zeros(n_episodes)


class GymnasiumTrainer:
    """Trains and evaluates an agent in any Gymnasium environment, in plain Python; the first steps are checked."""

    is_compiled = False

    def __init__(self, env: gymnasium.Env[Any, Any], agent: Any, seed: int, limit: int | None, expected: int) -> None:
        """See `trainer`; the limit is None where it is not known."""
        self.agent, self.log, self._pace, self._expected = agent, new_log(), Pace(), expected
        environment_rng, self._agent_rng, self._evaluation_rng, self._actor_rng = streams(seed)
        self._evaluated = own_copy(env, "evaluation plays a copy: make it in reset")  # before anything is drawn
        self._env, self._limit, self._before = env, limit, before_training(agent)
        self._learner: Any = checked_agent(learner(agent), env)
        self._actor: Any = None
        self._steps_to_check, self._has_played = CHECKED_STEPS, False
        with checked_env(env) as checked:
            observation, _ = checked.reset(seed=gymnasium_loops.draw_seed(environment_rng))
        self._moment: Any = (None, observation, 0, 0.0)
        self._loop: Callable[..., Any] = gymnasium_loops.off_policy
        if is_on_policy(agent):
            self._loop = gymnasium_loops.on_policy
            self._moment = (None, observation, self._learner.act(observation, self._agent_rng), 0, 0.0)
        if is_own(agent):
            self._compile(observation)

    def learn(self, at_most: int) -> int:
        """Take training steps, as many as take about `CALL_SECONDS`; return their number."""
        if not self._steps_to_check:
            with self._pace.steps(at_most) as n_steps, checked_env(self._env, steps=0) as env:
                self._advance(n_steps, env)
            return n_steps
        with self._pace.steps(min(at_most, self._steps_to_check)) as n_steps, checked_env(self._env) as env:
            self._advance(n_steps, env)
        self._steps_to_check -= n_steps
        if not self._steps_to_check and not is_own(self.agent):
            self._compile(self._moment[1])
        return n_steps

    def play_episodes(self, at_most: int) -> list[float]:
        """Play one episode without learning, as the agent believes best; return its undiscounted return."""
        steps, self._has_played = 0 if self._has_played else CHECKED_STEPS, True
        with checked_env(self._evaluated, steps) as env:
            return [self._played(env, self._actor or checked_agent(actor(self.agent), self._evaluated, steps))]

    def doubts(self, run: Run) -> list[str]:
        """Return what is probably wrong with what has been trained, in a sentence each."""
        return doubts(self._env, self.agent, self._limit, run, self._before)

    def _advance(self, n_steps: int, env: Any) -> None:
        limit = self._limit or NO_LIMIT
        self._moment = self._loop(n_steps, env, self._learner, limit, self._agent_rng, self.log, self._moment)

    def _played(self, env: Any, player: Any) -> float:
        limit = self._limit or EVALUATION_LIMIT
        return gymnasium_loops.play_episode(env, player, limit, self._evaluation_rng, self._actor_rng)

    def _compile(self, observation: Any) -> None:
        """From now on the agent alone runs as machine code, where it takes vectors and that pays."""
        self._learner = checked_agent(learner(self.agent), self._env, steps=0)
        if takes_vectors(self.agent):
            self._learner = MachineAgent(learner(self.agent), self._agent_rng, observation, self._expected)
            self._actor = MachineAgent(actor(self.agent), self._actor_rng, observation, self._expected)


class Pace:
    """How many steps to take at a time. How a run is cut into calls does not change its results."""

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
    """Return the random streams of environment, agent, evaluation, and of the agent while it is evaluated."""
    return [np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(4)]


def new_log() -> Log:
    """Return a log of no episodes."""
    return Log(np.zeros(1), np.zeros(1, np.int64))
