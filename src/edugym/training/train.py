"""Training one agent in one environment, with its learning curve."""

import copy
import inspect
import math
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import gymnasium
import numpy as np
from gymnasium.wrappers import OrderEnforcing, PassiveEnvChecker

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks import whole_number
from edugym.compiled.execution import executable
from edugym.mdp.protocol import Integers, Reals, coerced, step_limit
from edugym.mdp.tabular import table_size, tabular
from edugym.registration import full_id
from edugym.training.gymnasium_loops import learn_in_gymnasium, play_in_gymnasium, start_in_gymnasium
from edugym.training.interrupts import interrupts
from edugym.training.loops import (
    GreedyActor,
    Log,
    Moment,
    OneStepAgent,
    OneStepOnPolicyAgent,
    off_policy,
    on_policy,
    play_episodes,
    start,
)
from edugym.training.progress import progress_bar

CHUNK = 100_000  # steps between two looks at the keyboard: a millisecond of machine code
INTERPRETED_CHUNK = 1_000
NO_LIMIT = 2**62
EVALUATION_LIMIT = 1_000
"""How long an evaluation episode may take where the task has no step limit: a greedy policy may never get anywhere."""


@dataclass(frozen=True)
class Run:
    """What one training run produced.

    Attributes:
        steps: shape (n_points,): after how many training steps each point of the curve was measured, the first at 0.
        returns: shape (n_points,): the mean undiscounted return of the evaluation episodes, played without exploring.
        training_returns: shape (n_points,): the mean undiscounted return of the training episodes that ended since the
            point before, exploring steps included; NaN where none ended.
        episodes: shape (n_points,): how many training episodes ended since the point before.
        agent: the trained agent: the one that was given, whose tables have changed in place.
        seed: the seed from which every random stream of this run comes.
        seconds: how long it took.
        complete: False when it was stopped before its last step.
    """

    steps: Integers
    returns: Reals
    training_returns: Reals
    episodes: Integers
    agent: Any
    seed: int
    seconds: float
    complete: bool


def train(
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
) -> Run:
    """Train `agent` in `environment` for `n_steps` steps and measure its learning curve.

    Long runs of an MDP or of an EduGym environment run as machine code; other Gymnasium environments run in a plain
    loop. Ctrl-C stops at once and returns what is done.

    Args:
        environment: an MDP, a Gymnasium environment, or the name or id of one.
        agent: an agent for it; its tables are changed in place.
        n_steps: how many training steps to take, 1 or more.
        max_steps: after how many steps an episode is truncated; by default the environment's own limit, if it has one.
        evaluate_every: steps between two points of the curve; by default a hundredth of `n_steps`.
        evaluation_episodes: how many episodes each point averages, played with `agent.greedy` (or `act` without one) on
            random streams of their own, so that evaluating changes nothing in the training.
        seed: the same seed gives the same run, bit for bit.
        progress: whether to show a progress bar.
        stop: a `threading.Event` that ends the run when it is set.

    Raises:
        ValueError: a parameter is not as above, or the observations or actions do not fit a table.
    """
    whole_number("n_steps", n_steps, 1)
    every = max(1, n_steps // 100) if evaluate_every is None else evaluate_every
    whole_number("evaluate_every", every, 1)
    whole_number("evaluation_episodes", evaluation_episodes, 1)
    whole_number("seed", seed, 0)
    if max_steps is not None:
        whole_number("max_steps", max_steps, 1)
    began = time.perf_counter()
    agent = coerced(agent)
    task = coerced(_task(environment, agent))
    streams = map(np.random.default_rng, np.random.SeedSequence(seed).spawn(4))
    environment_rng, agent_rng, evaluation_rng, actor_rng = streams
    limit = max_steps or _step_limit(task)
    log = Log(np.zeros(1), np.zeros(1, np.int64))
    rest = (task, told_of_truncation(agent), limit or NO_LIMIT, environment_rng, agent_rng, log)
    scores = np.zeros(evaluation_episodes)
    evaluation_limit = limit or EVALUATION_LIMIT
    learn: Callable[..., Moment]
    advance: Callable[..., Moment]
    play: Callable[..., None]
    if isinstance(task, gymnasium.Env):
        play, played = play_in_gymnasium, copy.deepcopy(task)  # before it draws anything that cannot be copied
        learn = advance = learn_in_gymnasium
        moment = start_in_gymnasium(task, agent, environment_rng, agent_rng)
    else:
        moment = start(task, agent, environment_rng, agent_rng)
        learn = on_policy if getattr(agent, "on_policy", False) else off_policy
        advance = executable(learn, (*rest, moment), expected=n_steps)
        watch = (task, _actor(agent), evaluation_limit, evaluation_rng, actor_rng, scores)
        play = executable(play_episodes, watch, expected=n_steps, rehearsed=1)
        played = task
    chunk = INTERPRETED_CHUNK if advance is learn else CHUNK

    points: list[tuple[int, float, float, int]] = []

    def measure(steps: int, let_come: Callable[[], None]) -> None:
        actor = _actor(agent)
        for k in range(evaluation_episodes):
            play(1, played, actor, evaluation_limit, evaluation_rng, actor_rng, scores[k : k + 1])
            let_come()
            if stop is not None and stop.is_set() and k + 1 < evaluation_episodes:
                return
        episodes = int(log.episodes[0])
        points.append((steps, scores.mean(), log.returns[0] / episodes if episodes else math.nan, episodes))
        log.returns[0] = log.episodes[0] = 0

    done = 0
    bar = progress_bar(n_steps, "steps") if progress else None
    try:
        with interrupts(deferred=advance is not learn) as let_come:
            measure(0, let_come)
            while done < n_steps and not (stop is not None and stop.is_set()):
                take = min(chunk, n_steps - done, every - done % every)
                moment = advance(take, *rest, moment)
                done += take
                if done % every == 0 or done == n_steps:
                    measure(done, let_come)
                if bar is not None:
                    bar.update(take)
                let_come()
    except KeyboardInterrupt:
        if stop is None:
            warnings.warn(f"interrupted after {done} of {n_steps} steps: this is what was done", stacklevel=2)
    finally:
        if bar is not None:
            bar.close()
    curve = np.array(points).reshape(-1, 4)
    return Run(
        steps=curve[:, 0].astype(np.int64),
        returns=curve[:, 1],
        training_returns=curve[:, 2],
        episodes=curve[:, 3].astype(np.int64),
        agent=agent,
        seed=seed,
        seconds=time.perf_counter() - began,
        complete=done == n_steps,
    )


def told_of_truncation(agent: Any) -> Any:
    """The agent in the form that the loops ask for, whether its `learn` takes `truncated` or not."""
    parameters = len(inspect.signature(agent.learn).parameters)
    if getattr(agent, "on_policy", False):
        return OneStepOnPolicyAgent(agent) if parameters == 6 else agent
    return OneStepAgent(agent) if parameters == 5 else agent


def _actor(agent: Any) -> Any:
    """The agent as it acts when it is evaluated; where that may leave traces in it, a copy of it."""
    return GreedyActor(agent) if hasattr(agent, "greedy") else copy.deepcopy(agent)


def _task(environment: Any, agent: Any) -> Any:
    """The MDP behind an environment, if there is one and nothing changes it; else the Gymnasium environment."""
    if isinstance(environment, str):
        environment = gymnasium.make(full_id(environment))
    if not hasattr(environment, "observation_space"):
        raise ValueError(f"environment must be an MDP, a Gymnasium environment or a name, but is {environment!r}")
    if isinstance(agent, type) or not (hasattr(agent, "act") and hasattr(agent, "learn")):
        raise ValueError(f"agent must be a value with the methods act and learn, but is {agent!r}")
    inside = environment
    while isinstance(inside, PassiveEnvChecker | OrderEnforcing):
        inside = inside.env
    if isinstance(inside, MDPEnv) and inside.only_plays_its_mdp:
        environment = inside.mdp
    if getattr(agent, "tabular", True) is False:
        return environment
    _check_table(agent, environment)
    return tabular(environment)


def _check_table(agent: Any, environment: Any) -> None:
    """Refuse one of the package's agents that was made for another environment."""
    Q = getattr(agent, "Q", None)
    if type(agent).__module__.startswith("edugym.agents.") and isinstance(Q, np.ndarray):
        shape = table_size(environment)
        if Q.shape[-2:] != shape:
            raise ValueError(
                f"agent must have a table Q of shape {shape} for this environment, but its is {Q.shape[-2:]}"
            )


def _step_limit(task: Any) -> int | None:
    """The step limit of an MDP or Gymnasium environment, as far as it is known."""
    if not isinstance(task, gymnasium.Env):
        return step_limit(task)
    if isinstance(task.unwrapped, MDPEnv):
        return step_limit(task.unwrapped.mdp)
    return task.spec.max_episode_steps if task.spec else None
