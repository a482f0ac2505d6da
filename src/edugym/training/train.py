"""Training one agent in one environment, with its learning curve."""

import math
import time
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np

from edugym.checks.parameters import number_of_steps, whole_number
from edugym.checks.tracebacks import end_at_students_line
from edugym.mdp.protocol import Integers, Reals
from edugym.system.interrupts import Interrupted
from edugym.training.run import Run
from edugym.training.steps import take_steps
from edugym.training.trainers import Trainer, trainer

MOST_EPISODES = 1_000_000
"""The most evaluation episodes of one point of a learning curve."""


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

    ```python
    from edugym import QLearning, Supermarket, train

    shop = Supermarket.create()
    agent = QLearning.create(shop)
    run = train(shop, agent, 20_000, evaluate_every=5_000, seed=1)
    for steps, value in zip(run.steps, run.returns):
        print(f"return {value:4.0f} after {steps:5} steps")
    ```

    ```text
    return -450 after     0 steps
    return -500 after  5000 steps
    return   78 after 10000 steps
    return   78 after 15000 steps
    return   78 after 20000 steps
    ```

    Three kinds of environments are trained by the loops of `edugym.training.gymnasium_loops`, which are never compiled:
    (1) Gymnasium environments that do not come from EduGym; (2) EduGym environments inside a wrapper that you have
    added; (3) the environment Supermarket if you set its `step_timeout`, which makes each step last some time. All
    others, such as your own MDP in an `edugym.MDPEnv`, are trained by the loops of `edugym.training.loops`. In runs of
    5000 steps or more these are compiled to machine code where possible, and your own classes if that saves time.

    Ctrl-C ends the run within a fifth of a second. The agent keeps what it has learned, and `train` raises
    `Interrupted`. Its attribute `partial` holds the `Run` so far. In a notebook or at the prompt, read it as
    `sys.last_value.partial`.

    Args:
        environment: an MDP, a Gymnasium environment, or the name or id of one.
        agent: an agent for it; its tables are changed in place. Any object with `act(observation, rng)`, which gives an
            action, and `learn(...)`, which takes by name what it needs of state, action, reward, next_state,
            next_action, terminated and truncated; it may have `greedy(observation, rng)`, to be evaluated by. See the
            guide *Write your own environment and agent in plain Python*.
        n_steps: the number of training steps, 1 or more.
        max_steps: the step at which an episode is truncated; by default the environment's own limit, if it has one.
            `max_steps` replaces that limit, except in the three kinds of environments above: there both limits hold,
            and the lower one ends the episode.
        evaluate_every: the steps between two points of the curve; by default `n_steps // 100`, at least 1.
        evaluation_episodes: the number of episodes that each point averages, from 1 to 1 000 000. The agent plays them
            with `greedy`. If it has no `greedy`, a copy of it plays with `act`, and so explores. The evaluation
            episodes have their own random streams, so evaluation does not change training. If there is no step limit,
            an evaluation episode ends after at most 1000 steps.
        seed: the seed of all random streams. If you create the agent anew and use the same seed, you get the same curve
            and the same tables, bit for bit.
        progress: whether to show a progress bar.
        stop: a `threading.Event`. When it is set, `train` stops early and returns the `Run` so far.

    Warns:
        UserWarning: `train` warns, once for each class, when it cannot compile your code. At the end of a complete run
            it also warns if (1) your environment has no step limit, the run has 1000 steps or more, and no episode has
            ended in it; (2) an array of your agent with a usual name, such as Q, V or weights, holds NaN; (3) training
            has changed a table that is a class attribute. (All agents of the class share such a table.)

    Raises:
        ValueError: a parameter is not as above, or the observations or actions do not fit a table.
        Interrupted: Ctrl-C was pressed. Its `partial` is the `Run` so far.
    """
    n_steps = number_of_steps("n_steps", n_steps)
    every = max(1, n_steps // 100) if evaluate_every is None else whole_number("evaluate_every", evaluate_every, 1)
    evaluation_episodes = whole_number("evaluation_episodes", evaluation_episodes, 1, MOST_EPISODES)
    seed = whole_number("seed", seed, 0)
    if max_steps is not None:
        max_steps = number_of_steps("max_steps", max_steps)
    began, curve = time.perf_counter(), _Curve()

    def begin(expected: int) -> Trainer:
        return trainer(environment, agent, seed, max_steps, expected)

    def measure(steps: int, training: Trainer, should_stop: Callable[[], bool]) -> None:
        curve.measure(steps, training, evaluation_episodes, should_stop)

    try:
        taken = take_steps(n_steps, begin, measure, measure_every=every, stop=stop, progress=progress)
    except Exception as error:
        end_at_students_line(error)
        raise
    trained = agent if taken.learning is None else taken.learning.agent
    run = Run(*curve.columns(), trained, seed, time.perf_counter() - began, complete=curve.last == n_steps)
    if run.complete and taken.learning is not None:
        for warning in taken.learning.warnings(run):
            warnings.warn(warning, stacklevel=2)
    if taken.interrupted:
        raise Interrupted(f"after {taken}; the agent keeps what it has learned", lambda: run)
    return run


class _Curve:
    """The learning curve so far."""

    def __init__(self) -> None:
        self._points: list[tuple[int, float, float, int]] = []

    @property
    def last(self) -> int:
        """The number of steps at the last point; -1 before the first."""
        return self._points[-1][0] if self._points else -1

    def measure(self, steps: int, training: Trainer, n_episodes: int, stopped: Callable[[], bool]) -> None:
        """Play the evaluation episodes and add a point. If the run stops before all are played, add no point."""
        returns = training.play_episodes(n_episodes)
        while len(returns) < n_episodes:
            if stopped():
                return
            returns += training.play_episodes(n_episodes - len(returns))
        log = training.log
        ended = int(log.episodes[0])
        mean = log.returns[0] / ended if ended else math.nan
        self._points.append((steps, float(np.mean(returns)), mean, ended))  # Ctrl-C cannot leave half a point
        log.returns[0] = log.episodes[0] = 0

    def columns(self) -> tuple[Integers, Reals, Reals, Integers]:
        """Return the steps, returns, training returns and episodes, as in `Run`."""
        steps, returns, training_returns, episodes = zip(*self._points, strict=True) if self._points else ((),) * 4
        return (
            np.array(steps, np.int64),
            np.array(returns, float),
            np.array(training_returns, float),
            np.array(episodes, np.int64),
        )
