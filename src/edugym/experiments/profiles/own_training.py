"""Agents that train themselves, as those of deep learning do, on one rung of a ladder."""

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from edugym.experiments.configuration import Repetition
from edugym.system.files import write_whole

if TYPE_CHECKING:
    import pandas

TRAIN = "train"
"""The method of an agent that trains itself: train(n_steps, *, evaluate_every, evaluation_episodes, seed) -> Run."""


class Refused(Exception):
    """An agent did not train on a rung, for a reason that is told in a sentence."""


Points = tuple[list[int], list[float]]
"""The steps and the returns of a learning curve."""


def reason(error: Exception) -> str:
    """What an error says, with its kind where it is not one of the sentences of this package."""
    return str(error) if isinstance(error, ValueError) else f"{type(error).__name__}: {error}"


def trains_itself(agent: Any) -> bool:
    """Whether an agent is trained by a method of its own, not by `edugym.train`."""
    return hasattr(agent, TRAIN) and not hasattr(agent, "act")  # a step of its own training may be called `learn`


def curves(
    make: Callable[[Any], Any],
    task: Callable[..., Any],
    repetitions: Sequence[Repetition],
    how: dict[str, Any],
    jobs: int | None,
    kept_at: Callable[[int], Path | None],
) -> "dict[int, pandas.Series[float]]":
    """The learning curve of each repetition, by its number; each finished one is kept at once.

    Args:
        make: makes the agent for an environment.
        task: makes the environment for a `layout_seed`.
        repetitions: which runs to do.
        how: the arguments of the agent's method `train`, but for the seed.
        jobs: the number of processes, as in `repeat`.
        kept_at: the file for the run of a seed, or None.

    Raises:
        Refused: the agent cannot be trained so, as where it needs more steps.
    """
    import joblib
    import pandas

    found: dict[int, Points] = {}
    calls = []
    for repetition in repetitions:
        path = kept_at(repetition.seed)
        if path is not None and path.exists():
            found[repetition.number] = json.loads(path.read_text(encoding="utf-8"))
        else:
            calls.append(joblib.delayed(_run)(make, task, repetition, how, path))
    found |= dict(joblib.Parallel(jobs, return_as="generator_unordered", batch_size=1)(calls))
    return {number: pandas.Series(returns, steps) for number, (steps, returns) in found.items()}


def _run(
    make: Callable[[Any], Any], task: Callable[..., Any], repetition: Repetition, how: dict[str, Any], path: Path | None
) -> tuple[int, Points]:
    """Do one run, and keep it."""
    try:
        run = make(task(layout_seed=repetition.layout_seed)).train(**how, seed=repetition.seed)
    except Exception as error:  # a student's agent may fail in any way where it does not fit
        raise Refused(reason(error)) from error
    points = run.steps.tolist(), run.returns.tolist()
    if path is not None:
        write_whole(path, json.dumps(points).encode())
    return repetition.number, points
