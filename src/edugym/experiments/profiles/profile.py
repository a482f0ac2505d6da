"""Profile agents: each on every ladder, with a fixed budget on each rung."""

import json
import math
import os
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from enum import Enum
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

import numpy as np
from gymnasium.error import DependencyNotInstalled
from gymnasium.spaces import Discrete

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.contract import METHODS, contract_of
from edugym.checks.parameters import a_path, in_short, true_or_false, whole_number
from edugym.experiments.configuration import Repetition, planned_runs
from edugym.experiments.fingerprints import deep_versions, fingerprint
from edugym.experiments.players import Player
from edugym.experiments.profiles.ladders import LADDERS, Ladder, bounds_of, checked, rung_in_words, steps_of
from edugym.experiments.profiles.own_training import TRAIN, Refused, curves, reason, trains_itself
from edugym.experiments.profiles.scores import COLUMNS, NEARLY, Profile
from edugym.experiments.repeat import MOST_REPETITIONS, Maker, checked_jobs, makers_of, repeat
from edugym.system.extras import require
from edugym.system.files import check_writable, write_whole
from edugym.system.interrupts import Interrupted, SignalGuard
from edugym.system.memory import in_digits
from edugym.training.progress import progress_bar
from edugym.training.train import train
from edugym.training.trainers import trainer

POINTS = 20
"""The evaluations of a run, besides the one before training."""
TRIED = 200
"""The steps for which a student's agent is tried on a challenge, to see whether it can enter."""

MOST_NUMBERS = 30_000_000
"""The largest table of a wrapped task: a quarter of a gigabyte for each run."""

Wrap = Callable[[Any], Any]
Row = dict[str, Any]


class Method(NamedTuple):
    """An agent to be profiled.

    Attributes:
        label: what it is called.
        make: makes it for an environment.
        wrap: makes the task as it sees it from the task; None where it sees the task itself.
        given: what the user gave, which determines both.
    """

    label: str
    make: Maker
    wrap: Wrap | None
    given: Any


class Training(Enum):
    """How an agent is trained."""

    BY_US = "by `edugym.train`"
    BY_ITSELF = "by its own method"
    NOT_AT_ALL = "not at all: it is a policy, and learns nothing"


class Trial(NamedTuple):
    """What is seen of an agent before it is trained.

    Attributes:
        errors: the challenges that it cannot enter, with what is raised there.
        reasons: the same in words, with the rung where it is not the first one.
        how: how it is trained.
    """

    errors: dict[str, Exception]
    reasons: dict[str, str]
    how: Training


class Rung(NamedTuple):
    """A ladder at one of its strengths."""

    ladder: Ladder
    strength: float


def profile(
    agents: Mapping[str, Any],
    *,
    challenges: Sequence[str | Ladder] | None = None,
    repetitions: int = 10,
    seed: int = 0,
    jobs: int | None = -1,
    progress: bool = False,
    checkpoints: str | os.PathLike[str] | None = None,
) -> Profile:
    """Train every agent on every challenge at several strengths, and score what it has learned.

        edugym.profile({"Q-learning": QLearning.create, "mine": make_my_agent})

    For each challenge there is a ladder of tasks, from easy to hopeless. On each rung an agent trains for a number of
    steps that does not depend on the agent, once for each repetition, which has a seed and a layout of its own. The
    score of a run is its greedy return at the end, where random play scores 0 and the best play 1; below 0 it is worse
    than random play. The score in a challenge is the mean over the rungs.

    Ctrl-C raises `Interrupted`, whose attribute `partial` is the profile so far. With `checkpoints`, the same call goes
    on from there.

    Args:
        agents: a dictionary from labels to agents, as `repeat` takes them. What a function makes may also train itself,
            as `edugym.deep.PPO` and `LibraryAgent` do: by a method `train(n_steps, *, evaluate_every,
            evaluation_episodes, seed)` that returns a `Run`, in processes, not threads. With a wrapper, give a pair of
            the agent and a function that wraps an MDP: `(QLearning.create, lambda mdp: FrameStack.create(mdp, 4))`.
        challenges: names of environments of the course, or ladders of your own; None is every environment that has one.
        repetitions: the number of runs on each rung, from 1 to 1 000 000.
        seed: the number from which the seeds of all repetitions are spawned, 0 or more.
        jobs: the number of runs at a time, as in `repeat`.
        progress: whether to show a progress bar.
        checkpoints: a folder in which what is done is kept; it is never deleted, and what was made with other settings
            or other code is never taken from it.

    Returns:
        The scores. An agent that cannot enter a challenge (as a table cannot choose actions that are real numbers), or
        that raises an error while it trains there, has no score there, and `Profile.blank` says why. An error while it
        trains is a warning, too.

    Raises:
        ValueError: an argument is not as above, or an agent cannot enter any challenge.
        OSError: a checkpoint cannot be written.
        Interrupted: Ctrl-C was pressed.
        gymnasium.error.DependencyNotInstalled: pandas or joblib is missing.
    """
    require("experiments", "joblib", "pandas")
    methods = _methods(agents)
    ladders = _ladders(challenges)
    repetitions = whole_number("repetitions", repetitions, 1, MOST_REPETITIONS)
    seed = whole_number("seed", seed, 0)
    checked_jobs(jobs)
    true_or_false("progress", progress)
    folder = None if checkpoints is None else a_path("checkpoints", checkpoints)
    if folder is not None:
        check_writable(folder / ".edugym")  # any file name: tests that the folder is writable
    blank: dict[str, dict[str, str]] = {method.label: {} for method in methods}
    training: dict[str, Training] = {}
    rows: list[Row] = []
    rungs = [Rung(ladder, strength) for ladder in ladders for strength in ladder.strengths]
    done = 0

    def so_far() -> Profile:
        import pandas

        agents = tuple(method.label for method in methods)
        return Profile(pandas.DataFrame(rows, columns=list(COLUMNS)), ladders, agents, blank)

    try:
        with SignalGuard() as guard, progress_bar(len(rungs), "rungs", shown=progress) as bar:
            for method in methods:
                errors, reasons, training[method.label] = _tried(method, ladders)
                if len(errors) == len(ladders):
                    _raise_for(method.label, errors, reasons)
                blank[method.label] |= reasons
            for rung in rungs:
                guard.should_stop()
                entering = [method for method in methods if rung.ladder.name not in blank[method.label]]
                rows += _climb(rung, entering, training, blank, repetitions, seed, jobs, folder)
                done += 1
                bar.update(1)
    except KeyboardInterrupt:
        kept = "; the same call goes on from there" if folder else ""
        raise Interrupted(f"{done} of {len(rungs)} rungs are complete{kept}", so_far) from None
    return so_far()


def _raise_for(label: str, errors: dict[str, Exception], reasons: dict[str, str]) -> NoReturn:
    """Say why an agent can enter none of the challenges.

    Raises:
        gymnasium.error.DependencyNotInstalled: it needs a package that is missing.
        ValueError: it fits none of them.
    """
    first, error = next(iter(errors.items()))
    if isinstance(error, DependencyNotInstalled):
        raise error
    told = f"can enter none of the challenges: in {first}, " if len(errors) > 1 else f"cannot enter {first}: "
    raise ValueError(f"agents[{label!r}] {told}{reasons[first]}") from error


def _methods(agents: Mapping[str, Any]) -> list[Method]:
    """The agents, looked at once."""
    wraps: dict[str, Wrap | None] = {}
    without: Any = agents
    if isinstance(agents, Mapping):
        wraps = {label: _wrap(label, agent) for label, agent in agents.items()}
        without = {label: agent[0] if wraps[label] else agent for label, agent in agents.items()}
    return [
        Method(label, make, wraps[label], agents[label])
        for label, make in makers_of(without, [*METHODS, TRAIN]).items()
    ]


def _wrap(label: str, agent: Any) -> Wrap | None:
    """The wrapper of an agent that is given as a pair."""
    if type(agent) is not tuple:  # an agent may be a NamedTuple
        return None
    if len(agent) != 2 or not callable(agent[1]):
        raise ValueError(
            f"agents[{label!r}] must be an agent or a pair of an agent and a function that wraps an MDP, but is"
            f" {in_short(agent)}"
        )
    wrap: Wrap = agent[1]
    return wrap


def _ladders(challenges: Sequence[str | Ladder] | None) -> tuple[Ladder, ...]:
    """The ladders that are meant."""
    known = {ladder.name: ladder for ladder in LADDERS}
    if challenges is None:
        return LADDERS
    allowed = f"challenges must be a list with names among {', '.join(known)}, or a Ladder, but"
    if not isinstance(challenges, list | tuple) or isinstance(challenges, Ladder) or not challenges:
        raise ValueError(f"{allowed} is {in_short(challenges)}")
    chosen = []
    for one in challenges:
        ladder = known.get(one) if isinstance(one, str) else one
        if not isinstance(ladder, Ladder):
            raise ValueError(f"{allowed} has {in_short(one)}")
        chosen.append(checked(ladder))
    names = [ladder.name for ladder in chosen]
    if len({*names}) < len(names):
        raise ValueError(f"challenges must have different names, but are {', '.join(names)}")
    return tuple(chosen)


def why_not_entered(agents: Mapping[str, Any], ladders: Sequence[Ladder]) -> dict[str, dict[str, str]]:
    """For each agent, the challenges that it cannot enter, with the reason; arguments as in `profile`."""
    return {method.label: _tried(method, ladders).reasons for method in _methods(agents)}


def _tried(method: Method, ladders: Sequence[Ladder]) -> Trial:
    """An agent, tried on all rungs."""
    errors: dict[str, Exception] = {}
    reasons: dict[str, str] = {}
    how = Training.BY_US
    for ladder in ladders:
        for strength in ladder.strengths:
            try:
                how = _try(method, ladder, strength)
            except Exception as error:  # a student's agent may fail in any way where it does not fit
                where = "" if strength == ladder.strengths[0] else f"at {rung_in_words(ladder, strength)}, "
                errors[ladder.name], reasons[ladder.name] = error, f"{where}{reason(error)}"
                break
    return Trial(errors, reasons, how)


def _try(method: Method, ladder: Ladder, strength: float) -> Training:
    """Make an agent for a rung; a student's also takes some steps on the easiest one. Return how it is trained.

    Raises:
        Exception: it does not fit.
    """
    environment = _task(ladder, strength, method.wrap, layout_seed=0)
    made = method.make(environment)
    if trains_itself(made):  # it has refused what does not fit when it was made
        return Training.BY_ITSELF
    contract = contract_of(made)
    trainer(environment, contract, 0, None, 0)
    is_policy = isinstance(made, Player)
    if (is_policy or not contract.is_own) and strength == ladder.strengths[0]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            train(environment, contract.agent, TRIED, evaluate_every=TRIED)
    return Training.NOT_AT_ALL if is_policy else Training.BY_US


def _task(ladder: Ladder, strength: float, wrap: Wrap | None, layout_seed: int) -> MDPEnv[Any]:
    """The environment of a rung as an agent sees it.

    Raises:
        ValueError: a table for what the wrapper shows would be too large.
    """
    mdp = ladder.make(strength, layout_seed=layout_seed)
    if wrap is None:
        return MDPEnv(mdp)
    wrapped = wrap(mdp)
    spaces = wrapped.observation_space, wrapped.action_space
    if all(isinstance(space, Discrete) for space in spaces):
        numbers = math.prod(int(space.n) for space in spaces)
        if numbers > MOST_NUMBERS:
            raise ValueError(
                f"with the wrapper, a table for {ladder.strength} {strength:g} would have {in_digits(numbers)} numbers,"
                f" and a profile allows {in_digits(MOST_NUMBERS)}"
            )
    return MDPEnv(wrapped)


def _climb(
    rung: Rung,
    methods: list[Method],
    training: dict[str, Training],
    blank: dict[str, dict[str, str]],
    repetitions: int,
    seed: int,
    jobs: int | None,
    folder: Path | None,
) -> Iterator[Row]:
    """The rows of a rung: those that are in the folder, and the others made.

    An agent that raises an error while it trains has no score in the challenge: `blank` gets the reason.
    """
    ladder, strength = rung
    n_steps = steps_of(ladder, strength)
    for method in methods:
        task = partial(_task, ladder, strength, method.wrap)
        path = _kept_at(folder, rung, method, repetitions, seed)
        if path is not None and path.exists():
            rows = json.loads(path.read_text(encoding="utf-8"))
        else:
            measured: dict[str, Any] = {
                "evaluate_every": max(1, n_steps // POINTS),
                "evaluation_episodes": ladder.evaluation_episodes,
            }
            plan = [planned.repetition for planned in planned_runs([method.label], repetitions, seed)]
            found: Any
            try:
                if training[method.label] is Training.BY_ITSELF:
                    kept_at = partial(_kept_at, folder, rung, method, deep_versions())
                    found = curves(method.make, task, plan, {"n_steps": n_steps, **measured}, jobs, kept_at)
                else:
                    learns = training[method.label] is not Training.NOT_AT_ALL
                    how = {"repetitions": repetitions, "seed": seed, "jobs": jobs, **measured}
                    how |= {} if learns else {"evaluate_every": 1}  # at the end of a single step
                    trained = repeat(task, {method.label: method.make}, n_steps if learns else 1, **how)
                    found = trained.curves(method.label)
            except OSError:  # the disk is full, perhaps
                raise
            except Refused as refused:
                blank[method.label][ladder.name] = f"{rung_in_words(ladder, strength)}: {refused}"
                continue
            except Exception as error:  # a student's agent may fail in any way, and late
                why = f"{rung_in_words(ladder, strength)}: {reason(error)}"
                blank[method.label][ladder.name] = why
                warnings.warn(f"{method.label!r} has no score in {ladder.name}: {why}", stacklevel=4)
                continue
            rows = _scored(found, rung, plan)
            if path is not None:
                write_whole(path, json.dumps(rows).encode())
        yield from ({**row, "agent": method.label} for row in rows)


def _kept_at(folder: Path | None, rung: Rung, method: Method, *more: Any) -> Path | None:
    """The file for what an agent does on a rung, with `more` that determines it.

    None where there is no folder and, with a warning, where what determines it cannot be told.
    """
    if folder is None:
        return None
    try:
        name = fingerprint(rung, method.given, *more)
    except Exception as error:  # each class has its own for what cannot be taken apart
        warnings.warn(f"what {method.label!r} does cannot be kept on the disk: {error}", stacklevel=2)
        return None
    return folder / f"{name}.json"


def _scored(curves: Mapping[int, Any], rung: Rung, repetitions: Sequence[Repetition]) -> list[Row]:
    """A row for each repetition on a rung, of which the learning curves are given."""
    ladder, strength = rung
    rows = []
    for repetition in repetitions:
        bounds = bounds_of(ladder, strength, repetition.layout_seed)
        scores = bounds.score(curves[repetition.number])
        reached = scores.index[scores >= NEARLY]
        rows.append(
            {
                "challenge": ladder.name,
                "strength": strength,
                "repetition": repetition.number,
                "return": float(curves[repetition.number].iloc[-1]),
                "random": bounds.random,
                "best": bounds.best,
                "score": float(scores.iloc[-1]),
                "steps": steps_of(ladder, strength),
                "steps_to_0.9": float(reached[0]) if len(reached) else np.nan,
            }
        )
    return rows
