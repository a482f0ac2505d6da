"""Train several agents several times, in parallel, and collect everything in one table."""

import importlib
import inspect
import os
import signal
import threading
import warnings
from collections.abc import Callable, Collection, Generator, Mapping
from contextlib import suppress
from functools import partial
from numbers import Integral
from pathlib import Path
from typing import Any, NamedTuple

from edugym.checks.contract import METHODS
from edugym.checks.parameters import a_path, in_short, number_of_steps, true_or_false, whole_number
from edugym.checks.tracebacks import end_at_students_line
from edugym.checks.values import deep_copy
from edugym.experiments.checkpoints import Checkpoints, checkpoints_in
from edugym.experiments.configuration import GIVE_A_FUNCTION, ExperimentTask, Planned, described, planned_runs, task
from edugym.experiments.fingerprints import versions
from edugym.experiments.killed_workers import again_if_killed
from edugym.experiments.players import Player, is_policy, made_by, takes_observations
from edugym.experiments.results.rows import MEASURED, Rows
from edugym.experiments.results.tables import Results
from edugym.system.extras import require
from edugym.system.files import check_writable
from edugym.system.interrupts import Interrupted, SignalGuard, StopFlag, stop_flag
from edugym.system.other_threads import call_interruptibly
from edugym.training.progress import progress_bar
from edugym.training.run import Run
from edugym.training.steps import check_stop
from edugym.training.train import train

MOST_JOBS = 1_000
"""The most runs at a time: each is a thread or a process."""
MOST_REPETITIONS = 1_000_000

Maker = Callable[[Any], Any]


class Experiment(NamedTuple):
    """What `repeat` does.

    Attributes:
        task: the task of each repetition.
        makers: for each label, a function from an environment to a new agent.
        plan: the runs, in order.
        configuration: for each label, what the results say about the method: task, agent, arguments, versions.
    """

    task: ExperimentTask
    makers: dict[str, Maker]
    plan: list[Planned]
    configuration: dict[str, dict[str, Any]]


Runs = dict[Planned, Run]


def repeat(
    environment: Any,
    agents: Mapping[str, Any],
    n_steps: int,
    *,
    repetitions: int = 10,
    seed: int = 0,
    parameters: Mapping[str, Any] | None = None,
    max_steps: int | None = None,
    evaluate_every: int | None = None,
    evaluation_episodes: int = 1,
    jobs: int | None = -1,
    progress: bool = False,
    save_to: str | os.PathLike[str] | None = None,
    checkpoints: str | os.PathLike[str] | None = None,
    stop: threading.Event | None = None,
) -> Results:
    """Train every agent `repetitions` times in an environment, and collect the learning curves.

    In repetition i all methods get the same seed and the same layout, so they can be compared in pairs. Each repetition
    has another seed. It also has another layout if `environment` is a name with a parameter `layout_seed` that
    `parameters` does not fix, or a function of `layout_seed`; an MDP or an environment has one layout. With more
    `repetitions`, the first ones stay the same. Results do not depend on `jobs`.

    With `save_to`, every finished run is kept on the disk as soon as it is done (if its agent can be pickled; otherwise
    there is a warning). After any interruption (Ctrl-C, a crash, a full disk), repeat the same call: it loads the
    finished runs and does the others, and the results are the same. It never loads a run that was made with other
    settings, seeds or code.

    Ctrl-C ends the work within a fifth of a second. `repeat` then raises `Interrupted`, whose attribute `partial` has
    what is done, half-finished runs included: in a notebook or at the prompt, `sys.last_value.partial`.

    Args:
        environment: the name of an environment of this package ("Boulder"), an id that Gymnasium knows, an MDP or a
            Gymnasium environment (each run gets a copy), or a function that makes an MDP or an environment for a
            `layout_seed`, such as `lambda layout_seed: Boulder.create(height=10, layout_seed=layout_seed)`.
        agents: a dictionary from labels to methods. A method is an agent, or a function that makes an agent for an
            environment, such as `lambda environment: QLearning.create(environment, discount=0.9)`. Each run gets a
            copy, so that runs share nothing. In place of an agent it may be a policy that was written for Gymnasium and
            learns nothing here: an object with `predict(observation)`, or a function from observations to actions,
            whose only parameter is called `observation` or `obs`, or which the method makes.
        n_steps: the training steps of each run, 1 or more.
        repetitions: the number of runs of each method, from 1 to 1 000 000.
        seed: the number from which the seeds of all repetitions are spawned, 0 or more.
        parameters: those of an environment that is given by name.
        max_steps: the step at which an episode is truncated, as in `train`.
        evaluate_every: the steps between two points of the curve, as in `train`.
        evaluation_episodes: the episodes of each point, as in `train`.
        jobs: the number of runs at a time, 1 to 1000; -1 is one for each core, and None what `joblib.parallel_config`
            says. The runs are threads of one process, which is fast for machine code. For code that is not compiled use
            processes, `joblib.parallel_config(backend="loky")`; for a cluster see docs/clusters.md.
        progress: whether to show a progress bar, which moves when a run is done.
        save_to: a CSV file for the results. It is written, with a JSON file beside it (see `Results.save`), when all
            runs are complete; until then finished runs are kept in a folder `<save_to>.unfinished`. `repeat` first
            checks that it can write the file.
        checkpoints: a folder for finished runs. Unlike `<save_to>.unfinished`, it is not deleted at the end.
        stop: an event that, when set, ends the work: `repeat` returns what is done, with a warning. If the event is
            already set, it trains nothing and does not warn.

    Returns:
        The learning curves of all runs, with their settings, and the trained agents.

    Raises:
        ValueError: an argument is not as above, or an environment or agent refuses its parameters.
        OSError: `save_to` or a checkpoint cannot be written.
        Interrupted: Ctrl-C was pressed. Its `partial` are the `Results` so far.
        gymnasium.error.DependencyNotInstalled: joblib is missing, or pandas, which `save_to` needs.
    """
    libraries = ["joblib"] if save_to is None else ["joblib", "pandas"]
    require("experiments", *libraries)
    n_steps = number_of_steps("n_steps", n_steps)
    repetitions = whole_number("repetitions", repetitions, 1, MOST_REPETITIONS)
    seed = whole_number("seed", seed, 0)
    checked_jobs(jobs)
    true_or_false("progress", progress)
    check_stop(stop)
    stop = stop or threading.Event()
    for name, path in (("save_to", save_to), ("checkpoints", checkpoints)):
        if path is not None:
            a_path(name, path)
    if save_to is not None:
        save_to = check_writable(save_to)
    curve = {"max_steps": max_steps, "evaluate_every": evaluate_every, "evaluation_episodes": evaluation_episodes}
    training = {"n_steps": n_steps, **curve}
    try:
        experiment = _experiment(environment, parameters, agents, repetitions, seed, training)
    except Exception as error:
        end_at_students_line(error)
        raise
    if checkpoints is not None:
        check_writable(Path(checkpoints, ".edugym"))  # any file name: tests that the folder is writable
    plan = experiment.plan
    stopped_before, runs = stop.is_set(), Runs()
    # The caller's event `stop` ends the work; a `StopFlag` hands it on to the runs, in other processes as well. The
    # `SignalGuard` makes the first Ctrl-C set that flag, and `Interrupted` then gives the caller what is done.
    try:
        with SignalGuard() as guard:
            for library in libraries:  # Ctrl-C during an import would leave half a library
                call_interruptibly(importlib.import_module, library)
            store = checkpoints_in(checkpoints, save_to, experiment.task, agents, training)
            if not stop.is_set():
                runs |= store.found(plan)
            missing = partial(_do_all, experiment, training, runs, store, jobs, progress, stop, guard)
            again_if_killed(missing, runs, guard)
            if guard.stop_ordered:
                raise KeyboardInterrupt
            results = _collected(experiment, runs)
            if save_to is not None and results.complete:
                results.save(save_to)
                if checkpoints is None:
                    store.remove()
    except KeyboardInterrupt:
        kept = "; the same call goes on from there" if save_to or checkpoints else ""
        raise Interrupted(_so_far(plan, runs) + kept, lambda: _collected(experiment, runs)) from None
    except Exception as error:
        end_at_students_line(error)
        raise
    if not results.complete and not stopped_before:
        warnings.warn(f"stopped: {_so_far(plan, runs)}", stacklevel=2)
    return results


def _so_far(plan: list[Planned], runs: Runs) -> str:
    complete = sum(run.complete for run in runs.values())
    return f"{complete} of {len(plan)} runs are complete, {len(runs) - complete} are unfinished"


def _experiment(
    environment: Any,
    parameters: Mapping[str, Any] | None,
    agents: Mapping[str, Any],
    repetitions: int,
    seed: int,
    training: dict[str, Any],
) -> Experiment:
    """What to do."""
    makers = makers_of(agents)
    the_task = task(environment, parameters)
    plan = planned_runs(list(makers), repetitions, seed)
    counts = {"n_steps": training["n_steps"], "repetitions": repetitions, "runs": len(plan), "experiment_seed": seed}
    arguments = counts | training
    return Experiment(the_task, makers, plan, _configuration(the_task, makers, plan[0], arguments))


def checked_jobs(jobs: Any) -> None:
    """Refuse what is no number of runs at a time, as `repeat` takes it."""
    is_number = isinstance(jobs, Integral) and not isinstance(jobs, bool)
    if jobs is not None and not (is_number and (jobs == -1 or 1 <= jobs <= MOST_JOBS)):
        raise ValueError(f"jobs must be a whole number from 1 to {MOST_JOBS}, -1 or None, but is {in_short(jobs)}")


def makers_of(agents: Mapping[str, Any], methods: Collection[str] = METHODS) -> dict[str, Maker]:
    """For each label, a function that makes an agent for one run, which shares nothing with those of other runs.

    Args:
        agents: as `repeat` takes them.
        methods: what has one of these methods is an agent.

    Raises:
        ValueError: `agents` is not a dictionary from labels to methods, as `repeat` takes it.
    """
    if not isinstance(agents, Mapping):
        raise ValueError(f"agents must be a dictionary of agents by their labels, but is {in_short(agents)}")
    for label in agents:
        if not isinstance(label, str) or not label:
            raise ValueError(f"the labels of agents must be texts that are not empty, but one is {label!r}")
    if not agents:
        raise ValueError("agents must have one agent or more, but is empty")
    return {label: _maker(label, agent, methods) for label, agent in agents.items()}


def _maker(label: str, agent: Any, methods: Collection[str]) -> Maker:
    """A function that makes an agent for one run, which shares nothing with those of other runs."""
    needed = f"agents[{label!r}] must be an agent or a function that makes one for an environment, but is"
    if isinstance(agent, type):
        made = f"{agent.__name__}.create" if hasattr(agent, "create") else f"{agent.__name__}(...)"
        raise ValueError(f"{needed} the class {agent.__name__}: give {made}")
    if any(hasattr(agent, name) for name in methods) and not is_policy(agent):
        return lambda _: deep_copy(agent, f"{GIVE_A_FUNCTION} that makes one")
    if is_policy(agent) or takes_observations(agent):
        return lambda environment: Player(agent, environment)
    if not callable(agent):
        raise ValueError(f"{needed} {in_short(agent)}")
    try:
        inspect.signature(agent).bind("environment")
    except ValueError:  # a partial with an argument that its function does not have: let the call say which
        pass
    except TypeError:
        raise ValueError(
            f"agents[{label!r}] must take the environment, and nothing else: write `lambda environment: ...`"
        ) from None

    def make(environment: Any) -> Any:
        made = made_by(agent, environment)
        is_agent = any(hasattr(made, name) for name in methods)
        if is_policy(made) or (callable(made) and not is_agent and not isinstance(made, type)):
            return Player(made, environment)
        if not is_agent:
            raise ValueError(
                f"agents[{label!r}] must be a function of the environment that returns an agent or a policy, but it"
                f" returned {in_short(made)}"
            )
        return deep_copy(made, f"{GIVE_A_FUNCTION} that makes all of it")

    return make


def _configuration(
    task: ExperimentTask, makers: dict[str, Maker], first: Planned, arguments: dict[str, Any]
) -> dict[str, dict[str, Any]]:
    """What the results say about each method: task, agent, arguments, versions."""
    settings = {**task.settings, **arguments, "versions": versions()}
    settings.pop("layout_seed", None)  # each row has its own
    environment = task.make(first.repetition.layout_seed)
    return {label: settings | described(maker(environment), "agent") for label, maker in makers.items()}


def _do_all(
    experiment: Experiment,
    training: dict[str, Any],
    runs: Runs,
    store: Checkpoints,
    jobs: int | None,
    progress: bool,
    event: threading.Event,
    guard: SignalGuard,
) -> None:
    """Do every run of the plan that is not among `runs` yet, and add it there and to the checkpoints."""
    import joblib

    to_do = [planned for planned in experiment.plan if planned not in runs]
    total = len(experiment.plan) * training["n_steps"]
    done = Runs()  # those of threads of this process, as soon as they end: joblib hands them over later

    def keep(planned: Planned, run: Run) -> None:
        runs[planned] = run
        if run.complete:
            store.save(planned, run)

    with stop_flag(event) as stop, progress_bar(total, "steps", shown=progress) as bar:
        bar.update(len(runs) * training["n_steps"])
        calls = (
            joblib.delayed(_do)(planned, experiment.task, experiment.makers[planned.method], training, stop, done)
            for planned in to_do
            if not stop.is_set()
        )
        backend, _ = joblib.parallel.get_active_backend(prefer="threads")
        at_once = "generator_unordered" if backend.supports_return_generator else "list"
        parallel = joblib.Parallel(
            jobs, prefer="threads", return_as=at_once, pre_dispatch="n_jobs", batch_size=1, max_nbytes=None
        )
        error: Exception | None = None
        outcomes: Any = None
        try:
            with guard.on_ctrl_c(stop.set):
                outcomes = parallel(calls)
                for planned, run in outcomes:
                    if isinstance(run, Exception):
                        error = error or run
                        stop.set()
                        continue
                    keep(planned, run)
                    bar.update(training["n_steps"])
        except KeyboardInterrupt:  # not all runs have ended in time, but some may have ended meanwhile
            for planned in done.keys() - runs.keys():
                keep(planned, done[planned])
            if isinstance(outcomes, Generator):
                with suppress(KeyboardInterrupt):
                    outcomes.throw(KeyboardInterrupt)  # else joblib would warn that they have not been used
            raise
        if error is not None:
            raise error


def _do(
    planned: Planned, task: ExperimentTask, maker: Maker, training: dict[str, Any], stop: StopFlag, done: Runs
) -> tuple[Planned, Run | Exception]:
    """Do one run of one method; return an error rather than raise it, so that its traceback shows no joblib.

    In a thread of this process the run is also added to `done`. (Another process adds it to a copy, which is dropped.)
    """
    in_other_process = os.getpid() != stop.process
    if in_other_process and threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # what ends a worker is the file that `stop` creates
    try:
        environment = task.make(planned.repetition.layout_seed)
        run = train(environment, maker(environment), **training, seed=planned.repetition.seed, stop=stop)
    except Interrupted as interrupted:
        run = interrupted.partial
    except Exception as error:
        if in_other_process:
            raise
        return planned, error
    done[planned] = run
    return planned, run


def _collected(experiment: Experiment, runs: Runs) -> Results:
    """The rows of the runs, and their agents."""
    fixed_layout = experiment.task.settings.get("layout_seed")
    parts: dict[str, list[Any]] = {column: [] for column in MEASURED}
    agents: dict[str, dict[int, Any]] = {method: {} for method in experiment.makers}
    for planned in experiment.plan:
        if planned not in runs:
            continue
        run, repetition = runs[planned], planned.repetition
        agents[planned.method][repetition.number] = run.agent
        columns = {
            "method": planned.method,
            "repetition": repetition.number,
            "seed": repetition.seed,
            "layout_seed": repetition.layout_seed if experiment.task.has_layout else fixed_layout,
            "step": run.steps.tolist(),
            "return": run.returns.tolist(),
            "training_return": run.training_returns.tolist(),
            "episodes": run.episodes.tolist(),
            "complete": run.complete,
        }
        for column, values in columns.items():
            parts[column] += values if isinstance(values, list) else [values] * len(run.steps)
    return Results(Rows(parts, experiment.configuration), agents)
