"""Deep agents trained several times, each run in a process of its own, as the same table that `edugym.repeat` gives."""

import dataclasses
import functools
import json
import math
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from edugym.checks.parameters import whole_number
from edugym.experiments.checkpoints import Checkpoints
from edugym.experiments.configuration import Planned, planned_runs
from edugym.experiments.fingerprints import deep_versions
from edugym.experiments.results.rows import MEASURED, with_types
from edugym.experiments.results.tables import Results
from edugym.system.extras import require
from edugym.training.run import Run

TOLERANCE = 0.1
"""A run may take so much more or less than `n_steps`, as a share."""
Trainer = Callable[..., Run]
"""What trains an agent: it is called with the number of steps and `seed`."""


def repeat_deep(
    trainers: Mapping[str, Trainer],
    n_steps: int,
    *,
    repetitions: int = 10,
    seed: int = 0,
    jobs: int = -1,
    checkpoints: str | os.PathLike[str] | None = None,
) -> Results:
    """Train every agent `repetitions` times, and collect the learning curves.

        repeat_deep({"PPO": PPO.create("Catch").train}, 50_000)
        repeat_deep({"DQN": partial(stable_baselines3_run, "Catch", "DQN", num_envs=8)}, 50_000)

    Args:
        trainers: by label, functions that train an agent and return its `Run`. They must be pickled, so none is defined
            inside another function.
        n_steps: the training steps of each run. Algorithms that play whole rounds may take a few more or fewer; the
            last point of each curve counts as `n_steps` in the table.
        repetitions: the number of runs of each method, 1 or more.
        seed: the number from which the seeds of all repetitions are spawned, 0 or more; the same for every method.
        jobs: the number of processes, 1 or more; -1 is one for each core.
        checkpoints: a folder in which finished runs are kept. The same call goes on from there.

    Returns:
        The table of `edugym.repeat`, with the settings of each method, and no agents.

    Raises:
        ValueError: an argument is not as above, or a run took over a tenth more or fewer steps than `n_steps`.
        gymnasium.error.DependencyNotInstalled: pandas or joblib is missing.
    """
    require("experiments", "joblib", "pandas")
    import joblib

    if not trainers:
        raise ValueError("trainers must have one method or more, but is empty")
    whole_number("n_steps", n_steps, 1)
    whole_number("repetitions", repetitions, 1)
    if jobs != -1:
        whole_number("jobs", jobs, 1)
    plan = planned_runs(list(trainers), repetitions, whole_number("seed", seed, 0))
    store = Checkpoints(None if checkpoints is None else Path(checkpoints))
    for label, trainer in trainers.items():
        store.describe(label, trainer, n_steps)
    runs = store.found(plan)
    to_do = [planned for planned in plan if planned not in runs]
    calls = (joblib.delayed(_do)(trainers[planned.method], n_steps, planned) for planned in to_do)
    for planned, run in joblib.Parallel(jobs, return_as="generator_unordered", batch_size=1)(calls):
        store.save(planned, run)
        runs[planned] = run
    return _collected(trainers, plan, runs, n_steps, repetitions, seed)


def _do(trainer: Trainer, n_steps: int, planned: Planned) -> tuple[Planned, Run]:
    """Do one run; the agent stays in its process.

    Raises:
        ValueError: it took far more or fewer steps than asked for.
    """
    run = trainer(n_steps, seed=planned.repetition.seed)
    taken = int(run.steps[-1])
    if run.complete and abs(taken - n_steps) > TOLERANCE * n_steps:
        raise ValueError(
            f"n_steps must be about as many steps as a run takes, but is {n_steps}, and a run of {planned.method!r}"
            f" took {taken}: choose a multiple of the steps of one round, which all copies take between two updates"
        )
    return planned, dataclasses.replace(run, agent=None)


def _to(n_steps: int, run: Run) -> Run:
    """Return a complete run with its last point at `n_steps`, where points from there on before it are part of it."""
    if not run.complete:
        return run
    last = run.steps >= n_steps
    last[-1] = True
    n, returns = run.episodes[last], run.training_returns[last]
    mean = float(np.average(returns[n > 0], weights=n[n > 0])) if n.any() else math.nan
    return dataclasses.replace(
        run,
        steps=np.append(run.steps[~last], n_steps),
        returns=np.append(run.returns[~last], run.returns[-1]),
        training_returns=np.append(run.training_returns[~last], mean),
        episodes=np.append(run.episodes[~last], n.sum()),
    )


def _collected(
    trainers: Mapping[str, Trainer], plan: list[Planned], runs: Mapping[Planned, Run], n_steps: int, n: int, seed: int
) -> Results:
    import pandas

    parts = []
    for planned in plan:
        run = _to(n_steps, runs[planned])
        columns = {
            "method": planned.method,
            "repetition": planned.repetition.number,
            "seed": planned.repetition.seed,
            "layout_seed": None,
            "step": run.steps,
            "return": run.returns,
            "training_return": run.training_returns,
            "episodes": run.episodes,
            "complete": run.complete,
        }
        same = {"n_steps": n_steps, "repetitions": n, "runs": len(plan), "experiment_seed": seed}
        settings = json.dumps(_settings(trainers[planned.method]), default=str)
        parts.append(pandas.DataFrame(columns | same | {"settings": settings, "versions": deep_versions()}))
    table = pandas.concat(parts, ignore_index=True)
    return Results(with_types(table.astype({"layout_seed": "Int64"})[[*MEASURED, *table.columns.drop(list(MEASURED))]]))


def _settings(trainer: Any) -> Any:
    """Return what determines a trainer, in plain values: its function, and what is bound to it."""
    if isinstance(trainer, functools.partial):
        return [_settings(trainer.func), *map(_settings, trainer.args), trainer.keywords]
    if hasattr(trainer, "__self__"):  # a method of an agent
        return [trainer.__name__, trainer.__self__._asdict()]
    return getattr(trainer, "__qualname__", trainer)
