"""Experiments in few runs, or with made-up results, for tests of what lessons show; other tests see to claims."""

import functools
import warnings
import zlib
from dataclasses import replace
from typing import Any

import numpy as np

from edugym.checks.contract import tables_of
from edugym.experiments import repeat as repeating
from edugym.experiments.profiles import profile as profiling
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.scores import Profile
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.training import train as training
from edugym.training.run import Run
from edugym.training.train import train
from edugym.training.train_players import GameRun, train_players
from edugym.training.train_vectors import VectorRun, train_vectors
from edugym_course.notebook.prediction import Comparison, Prediction
from tests.course.lessons.records import run as run_in_words

ANY_RETURN, SOLVED_OR_NOT = (-20.0, 100.0), (0.0, 1.0)


class Again(dict[int, Any]):
    """The agents of a few runs, which stand for those of all others too."""

    def __missing__(self, run: int) -> Any:
        """Return an agent of the runs that there are."""
        return self[run % len(self)]


@functools.wraps(repeat)
def few_runs(*arguments: Any, most: int = 2, **how: Any) -> Results:
    """Return the results of `repeat` with so many repetitions at most."""
    results = repeat(*arguments, **how | {"repetitions": min(how.get("repetitions", 10), most)})
    return Results(results.table, {method: Again(agents) for method, agents in results.agents.items()})


@functools.wraps(profile)
def few_profiles(agents: Any, *, most: int = 2, **how: Any) -> Profile:
    """Return the profile with so many repetitions at most."""
    return profile(agents, **how | {"repetitions": min(how.get("repetitions", 10), most)})


def made_up_run(
    environment: Any, agent: Any, n_steps: int, *, returns: tuple[float, float] = ANY_RETURN, most: int = 50, **how: Any
) -> Run:
    """Let an agent train for a few steps, and return a run with made-up returns, by task, agent, steps and seed."""
    how = {name: value for name, value in how.items() if name not in ("stop", "progress") and value is not None}
    told = f"{run_in_words(environment, agent, {'steps': n_steps})}, seed {how.get('seed')}"
    rng = np.random.default_rng(zlib.crc32(told.encode()))
    few = min(n_steps, most)
    run = train(environment, agent, few, **how | {"evaluate_every": few, "evaluation_episodes": 1})
    every = how.get("evaluate_every", max(1, n_steps // 100))
    steps = np.unique(np.append(np.arange(0, n_steps, every), n_steps))
    made = np.round(rng.uniform(*returns, (2, len(steps))), 0 if returns == SOLVED_OR_NOT else 2)
    made[:, 0] = returns[0]
    return Run(steps, made[0], made[1], rng.integers(1, 9, len(steps)), run.agent, run.seed, 0.0, complete=True)


def short_match(game: Any, agents: Any, n_steps: int, *, most: int = 50, **how: Any) -> GameRun:
    """Let two players train for a few steps, and return a run that looks as long as it was asked for."""
    few = min(n_steps, most)
    run = train_players(game, agents, few, evaluate_every=few, seed=how.get("seed", 0))
    every = how.get("evaluate_every", n_steps)
    steps = np.unique(np.append(np.arange(0, n_steps, every), n_steps))
    policies = [run.policies[0], *[run.policies[-1]] * (len(steps) - 1)]
    returns, episodes = np.zeros((len(steps), 2)), np.ones(len(steps), np.int64)
    return replace(run, steps=steps, policies=policies, training_returns=returns, episodes=episodes)


def short_vectors(environment: Any, agent: Any, n_steps: int, *, most: int = 50, **how: Any) -> VectorRun:
    """Let an agent of several objectives train for a few steps; return a run with an episode in each step asked for."""
    few = min(n_steps, most)
    run = train_vectors(environment, agent, few, evaluate_every=few, seed=how.get("seed", 0))
    ended = run.training_returns if len(run.training_returns) else np.zeros_like(run.returns)
    return replace(run, training_returns=np.resize(ended, (n_steps, ended.shape[1])))


def random_run(*arguments: Any, **how: Any) -> Run:
    """Return a made-up run whose agent has random numbers in its tables, others with each setting."""
    run = made_up_run(*arguments, **how)
    rng = np.random.default_rng(zlib.crc32(run.returns.tobytes()))
    for table in tables_of(run.agent).values():
        table[...] = rng.random(table.shape)
    return run


def limit_runs() -> None:
    """Let all experiments of this process, in whatever module is imported from now on, take two runs."""
    repeating.repeat = few_runs
    profiling.profile = few_profiles


def make_runs_up() -> None:
    """Let all runs of this process be made up, in whatever module is imported from now on; they need not make sense."""
    measured = Prediction.measured

    def one_of_the_options(asked: Prediction, value: Any, explanation: str = "") -> Comparison:
        options = asked.options or [value if np.isfinite(value) else 0.0]  # the mean over no runs is not a number
        return measured(asked, value if value in options else options[0], explanation)

    warnings.simplefilter("ignore", RuntimeWarning)
    limit_runs()
    for owner, name, instead in (
        (repeating, "train", random_run),
        (training, "train", random_run),
        (Prediction, "measured", one_of_the_options),
    ):
        setattr(owner, name, instead)
