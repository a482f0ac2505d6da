"""How long our PPO and that of Stable-Baselines3 take to solve a task, with the same networks, batches and settings.

A task is solved at the first evaluation whose greedy return reaches a threshold. Time is wall-clock time on one core,
evaluations left out. Both take turns, seed after seed; a ratio is taken within each seed that both have solved, and the
median over these seeds is reported. Seeds are runs of their own: what a seed draws differs between the two.
"""

import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NamedTuple, TypeAlias
from unittest.mock import patch

from benchmarks.agents import settings_for_baselines
from benchmarks.measure import Spread, on_one_core, spread_of

SEEDS = 5
OURS, THEIRS = "EduGym's PPO", "Stable-Baselines3's PPO"

Train: TypeAlias = Callable[[int, int], Any]
"""Trains for so many steps with this seed, and gives the `Run`."""


class Task(NamedTuple):
    """Something to be solved.

    Attributes:
        environment: its name.
        parameters: those of the environment.
        threshold: the greedy return from which on it counts as solved.
        n_steps: after so many training steps a run is over, solved or not.
        episodes: how many episodes an evaluation averages; there is one after each update.
        settings: those of PPO that are not its defaults.
    """

    environment: str
    parameters: Mapping[str, Any]
    threshold: float
    n_steps: int
    episodes: int
    settings: Mapping[str, Any]

    @property
    def name(self) -> str:
        """What is measured."""
        return f"time to solve {self.environment}: a greedy return of {self.threshold} or more"


LONG_ROUNDS = {"num_envs": 128, "length": 64, "minibatches": 8, "epochs": 6, "learning_rate": 1e-3, "discount": 0.999}
TASKS = (
    Task("Catch", {}, 0.95, 30_720, 100, {}),
    Task("Trashbot", {"n_bins": 3}, 3.0, 393_216, 1, LONG_ROUNDS),  # as in lesson 7; it always starts alike
)


class Solved(NamedTuple):
    """When a task was solved.

    Attributes:
        task: the task.
        seconds: by name, the seconds of each seed; None where it was not solved.
    """

    task: Task
    seconds: dict[str, list[float | None]]

    @property
    def times(self) -> dict[str, Spread]:
        """By name, the seconds over the seeds that were solved."""
        found = {name: [value for value in seconds if value is not None] for name, seconds in self.seconds.items()}
        return {name: spread_of(seconds) for name, seconds in found.items() if seconds}

    @property
    def ratio(self) -> Spread | None:
        """How many times as fast EduGym is, over the seeds that both have solved; None where there are none."""
        both = zip(self.seconds[OURS], self.seconds[THEIRS], strict=True)
        ratios = [theirs / ours for ours, theirs in both if ours is not None and theirs is not None]
        return spread_of(ratios) if ratios else None

    def unsolved(self, name: str) -> list[int]:
        """The seeds with which it was not solved."""
        return [seed for seed, seconds in enumerate(self.seconds[name]) if seconds is None]


def times_to_solve(task: Task, seeds: int) -> Solved:
    """Train with each seed, ours and theirs in turns.

    Args:
        task: what is to be solved.
        seeds: how many seeds: 0, 1, 2 and so on.
    """
    seconds: dict[str, list[float | None]] = {OURS: [], THEIRS: []}
    with on_one_core():
        contenders = {OURS: our_ppo(task), THEIRS: their_ppo(task)}
        for train in contenders.values():
            train(1, 0)  # one round: compiled and loaded now
        for seed in range(seeds):
            for name, train in contenders.items():
                with clock() as stamps:
                    returns = train(task.n_steps, seed).returns
                reached = (stamp for stamp, value in zip(stamps, returns, strict=True) if value >= task.threshold)
                seconds[name].append(next(reached, None))
    return Solved(task, seconds)


@contextmanager
def clock() -> Iterator[list[float]]:
    """The seconds before each point of the learning curve that is measured meanwhile, without the points themselves."""
    from edugym.deep.curves import Curve

    stamps: list[float] = []
    original, away = Curve.measure, time.perf_counter()

    def measure(curve: Curve, steps: int) -> None:
        nonlocal away
        arrived = time.perf_counter()
        stamps.append(arrived - away)
        original(curve, steps)
        away += time.perf_counter() - arrived

    with patch.object(Curve, "measure", measure):
        yield stamps


def ours(task: Task) -> Any:
    """Our PPO with the settings of the task."""
    from edugym.deep import PPO

    return PPO.create(task.environment, task.parameters, **task.settings)


def our_ppo(task: Task) -> Train:
    """Our PPO, for training."""
    algorithm = ours(task)
    a_round = algorithm.num_envs * algorithm.length

    def train(n_steps: int, seed: int) -> Any:
        n_steps = max(n_steps, a_round)
        return algorithm.train(n_steps, evaluate_every=a_round, evaluation_episodes=task.episodes, seed=seed)

    return train


def their_ppo(task: Task) -> Train:
    """Stable-Baselines3's PPO with the settings of ours."""
    from edugym.deep import stable_baselines3_run

    same = ours(task)
    a_round = same.num_envs * same.length
    settings = {
        **settings_for_baselines(same),
        "num_envs": same.num_envs,
        "learning_rate": lambda left: left * same.learning_rate,  # it falls evenly to 0
    }
    n_steps_a_round = settings.pop("n_steps")

    def train(n_steps: int, seed: int) -> Any:
        how: dict[str, Any] = {"evaluate_every": a_round, "evaluation_episodes": task.episodes, "seed": seed}
        how |= {"parameters": task.parameters, "n_steps": n_steps_a_round}
        return stable_baselines3_run(task.environment, "PPO", n_steps, **how, **settings)

    return train
