"""Training one agent in one environment, with its learning curve."""

import math
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from edugym.checks import whole_number
from edugym.mdp.protocol import Integers, Reals
from edugym.training.interrupts import interrupts
from edugym.training.progress import progress_bar
from edugym.training.trainers import Trainer, trainer


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
    loop (both are in `edugym.training.loops` and `gymnasium_loops`). Ctrl-C stops at once and returns what is done.

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
    training = trainer(environment, agent, seed, max_steps, expected=n_steps)
    curve = _Curve()
    done = 0
    try:
        with interrupts(training.is_compiled) as deliver, progress_bar(n_steps, "steps", shown=progress) as bar:

            def stopped() -> bool:
                deliver()
                return stop is not None and stop.is_set()

            curve.measure(done, training, evaluation_episodes, stopped)
            while done < n_steps and not stopped():
                steps = min(training.chunk, n_steps - done, every - done % every)
                training.learn(steps)
                done += steps
                if done % every == 0 or done == n_steps:
                    curve.measure(done, training, evaluation_episodes, stopped)
                bar.update(steps)
    except KeyboardInterrupt:
        if stop is None:
            warnings.warn(f"interrupted after {done} of {n_steps} steps: this is what was done", stacklevel=2)
    return Run(
        steps=np.array(curve.steps, np.int64),
        returns=np.array(curve.returns, float),
        training_returns=np.array(curve.training_returns, float),
        episodes=np.array(curve.episodes, np.int64),
        agent=training.agent,
        seed=seed,
        seconds=time.perf_counter() - began,
        complete=done == n_steps,
    )


class _Curve:
    """The learning curve so far; its lists are those of `Run`."""

    def __init__(self) -> None:
        self.steps: list[int] = []
        self.returns: list[float] = []
        self.training_returns: list[float] = []
        self.episodes: list[int] = []

    def measure(self, steps: int, training: Trainer, n_episodes: int, stopped: Callable[[], bool]) -> None:
        """Evaluate the agent over some episodes, and add a point to the curve unless the run is stopped meanwhile."""
        returns = [training.play_episode()]
        while len(returns) < n_episodes:
            if stopped():
                return
            returns.append(training.play_episode())
        log = training.log
        ended = int(log.episodes[0])
        self.steps.append(steps)
        self.returns.append(float(np.mean(returns)))
        self.training_returns.append(log.returns[0] / ended if ended else math.nan)
        self.episodes.append(ended)
        log.returns[0] = log.episodes[0] = 0
