"""Training several agents several times, in parallel, and collecting it all in one table."""

import copy
import os
import signal
import tempfile
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.checks import whole_number
from edugym.extras import require
from edugym.files import check_writable
from edugym.results.tables import MEASURED, Results, with_types
from edugym.training.configuration import Task, described, task, versions
from edugym.training.progress import progress_bar
from edugym.training.train import Run, train

if TYPE_CHECKING:
    import pandas

Maker = Callable[[Any], Any]


class Repetition(NamedTuple):
    """What every method's run of one repetition has in common.

    Attributes:
        number: 0, 1, ...
        seed: what all random streams of the run come from.
        layout_seed: what the task is drawn from, where it has a layout.
    """

    number: int
    seed: int
    layout_seed: int


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
    stop: threading.Event | None = None,
) -> Results:
    """Train every agent `repetitions` times in an environment, and collect the learning curves.

    Repetition i has the same seed for every method and, in a task with a layout (a parameter `layout_seed` that
    `parameters` does not fix), the same layout, another one than the other repetitions: methods are compared in pairs.
    The first repetitions of a longer experiment are those of a shorter one. Results do not depend on `jobs`.

    Ctrl-C returns what is done within a tenth of a second, half-finished runs included, and warns of how much that is.

    Args:
        environment: the name of an environment of this package ("Boulder"), an id that Gymnasium knows, an MDP, or a
            Gymnasium environment (each run gets a copy).
        agents: by label, the methods: agents (each run gets a copy) or functions that make one for an environment, such
            as `lambda environment: QLearning.create(environment, discount=0.9)`.
        n_steps: the training steps of each run, 1 or more.
        repetitions: how many runs each method gets, 1 or more.
        seed: from which the seeds of all repetitions are spawned, 0 or more.
        parameters: those of an environment that is given by name.
        max_steps: after how many steps an episode is truncated, as in `train`.
        evaluate_every: steps between two points of the curve, as in `train`.
        evaluation_episodes: episodes a point, as in `train`.
        jobs: how many runs at a time, in threads, which machine code keeps busy; -1 is one a core, None is as many as
            `joblib.parallel_config` says. That function also chooses other back ends: processes for tasks that run in
            the interpreter, `joblib.parallel_config(backend="loky")`, or a Dask or Ray cluster. (In processes of the
            same machine Ctrl-C works as in threads, and `stop` does not; those elsewhere finish the runs they have
            begun.)
        progress: whether to show a progress bar, which moves when a run is done (in threads only).
        save_to: a CSV file to which the results are saved, also when interrupted, unless there are none; that it can be
            written is checked before the work starts.
        stop: an event that, when set, ends the work as Ctrl-C does. Ctrl-C sets it, so that what comes after can be
            left out: with an event that is set already nothing is done, and there is no warning.

    Raises:
        ValueError: an argument is not as above, or an environment or agent refuses its parameters.
        OSError: `save_to` cannot be written.
        gymnasium.error.DependencyNotInstalled: pandas or joblib is missing.
    """
    require("experiments", "joblib", "pandas")
    whole_number("n_steps", n_steps, 1)
    whole_number("repetitions", repetitions, 1)
    whole_number("seed", seed, 0)
    if jobs is not None and jobs != -1:
        whole_number("jobs", jobs, 1)
    if not isinstance(agents, Mapping):
        raise ValueError(f"agents must be a dictionary of agents by their labels, but is {agents!r}")
    the_task, makers = task(environment, parameters), {label: _maker(label, agent) for label, agent in agents.items()}
    if not makers:
        raise ValueError("agents must have one method or more, but is empty")
    if save_to is not None:
        check_writable(save_to)
    curve = {"max_steps": max_steps, "evaluate_every": evaluate_every, "evaluation_episodes": evaluation_episodes}
    plan = [(label, repetition) for repetition in _repetitions(seed, repetitions) for label in makers]
    stop = stop or threading.Event()
    stopped_before = stop.is_set()
    arguments = {"n_steps": n_steps, "repetitions": repetitions, "runs": len(plan), "experiment_seed": seed, **curve}
    configuration = _configuration(the_task, makers, plan[0][1], arguments)

    runs = _do_all(plan, the_task, makers, {"n_steps": n_steps, **curve}, jobs, progress, stop)
    results = _collected(plan, runs, the_task, list(makers), configuration)
    if save_to is not None and not results.table.empty:
        results.save(save_to)
    if not results.complete and not stopped_before:
        done, partly = (sum(run is not None and run.complete is way for run in runs) for way in (True, False))
        warnings.warn(f"interrupted: of {len(plan)} runs {done} are complete, and {partly} are in part", stacklevel=2)
    return results


def _maker(label: str, agent: Any) -> Maker:
    """The function that gives each run an agent of its own."""
    if isinstance(agent, type) or not (hasattr(agent, "act") or callable(agent)):
        raise ValueError(
            f"agents[{label!r}] must be an agent or a function that makes one for an environment, but is {agent!r}"
        )
    return (lambda _: copy.deepcopy(agent)) if hasattr(agent, "act") else agent


def _repetitions(seed: int, n: int) -> list[Repetition]:
    """The seeds of `n` repetitions: independent streams from one number."""
    children = np.random.SeedSequence(seed).spawn(n)
    return [Repetition(i, *map(int, child.generate_state(2))) for i, child in enumerate(children)]


class _Watch:
    """The order to stop and the progress bar, for the runs in this process; those in other ones see a file appear."""

    def __init__(self, stop: threading.Event, bar: Any, folder: str) -> None:
        self._stop: threading.Event | None = stop
        self._bar = bar
        self._lock: Any = threading.Lock()
        self._file = Path(folder) / "stop"
        self.process = os.getpid()

    def set(self) -> None:
        """Order every run to stop."""
        if self._stop is not None:
            self._stop.set()  # first, so that no new run is handed out when one has seen the file
        self._file.touch()

    def is_set(self) -> bool:
        """Whether to stop."""
        return self._file.exists() if self._stop is None else self._stop.is_set()

    def advance(self, n_steps: int) -> None:
        """Show progress."""
        if self._bar is not None:  # which is so in this process only
            with self._lock:
                self._bar.update(n_steps)

    def __getstate__(self) -> dict[str, Any]:
        """What another process gets: the name of the file."""
        return {**self.__dict__, "_stop": None, "_bar": None, "_lock": None}


def _do_all(
    plan: list[tuple[str, Repetition]],
    the_task: Task,
    makers: dict[str, Maker],
    arguments: dict[str, Any],
    jobs: int | None,
    progress: bool,
    stop: threading.Event,
) -> list[Run | None]:
    """Every run of the plan; None for those that had not begun when the order to stop came."""
    import joblib

    with (
        tempfile.TemporaryDirectory(prefix="edugym-") as folder,
        progress_bar(len(plan) * arguments["n_steps"], "steps", shown=progress) as bar,
    ):
        watch = _Watch(stop, bar, folder)
        try:
            if not watch.is_set():
                _compile(the_task, makers, plan[0][1], arguments)
        except KeyboardInterrupt:  # nothing has begun
            watch.set()
        work = (
            joblib.delayed(_do)(the_task, makers[label], repetition, arguments, watch)
            for label, repetition in plan
            if not watch.is_set()
        )
        parallel = joblib.Parallel(jobs, prefer="threads", pre_dispatch="n_jobs", batch_size=1, max_nbytes=None)
        with _ctrl_c_sets(watch):
            runs: list[Run | None] = list(parallel(work))
    return runs + [None] * (len(plan) - len(runs))


def _compile(the_task: Task, makers: dict[str, Maker], first: Repetition, arguments: dict[str, Any]) -> None:
    """Compile what will run, once and before there are threads: Ctrl-C can end that only in the main one."""
    stopped = threading.Event()
    stopped.set()
    for maker in makers.values():
        environment = the_task.make(first.layout_seed)
        train(environment, maker(environment), **arguments, seed=first.seed, stop=stopped)


def _do(the_task: Task, maker: Maker, repetition: Repetition, arguments: dict[str, Any], watch: _Watch) -> Run:
    """One run of one method."""
    if os.getpid() != watch.process and threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches the workers too; the file is what stops them
    environment = the_task.make(repetition.layout_seed)
    run = train(environment, maker(environment), **arguments, seed=repetition.seed, stop=watch)
    watch.advance(arguments["n_steps"])
    return run


@contextmanager
def _ctrl_c_sets(watch: _Watch) -> Iterator[None]:
    """Within it Ctrl-C orders the runs to stop, and interrupts nothing by itself; a second one does."""
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(before):
        yield  # only the main thread is ever interrupted, and a program that ignores Ctrl-C goes on ignoring it
        return

    def order(number: int, frame: Any) -> None:
        if watch.is_set():
            before(number, frame)
        watch.set()

    signal.signal(signal.SIGINT, order)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _configuration(
    the_task: Task, makers: dict[str, Maker], first: Repetition, arguments: dict[str, Any]
) -> "pandas.DataFrame":
    """What is done, one row a method: task, agent, arguments of the experiment, versions."""
    import pandas

    done = {**the_task.settings, **arguments, "versions": versions()}
    environment = the_task.make(first.layout_seed)
    rows = {label: {**done, **described(maker(environment), "agent")} for label, maker in makers.items()}
    table = pandas.DataFrame.from_dict(rows, orient="index")
    return table.drop(columns="layout_seed", errors="ignore").dropna(axis="columns", how="all")


def _collected(
    plan: list[tuple[str, Repetition]],
    runs: list[Run | None],
    the_task: Task,
    methods: list[str],
    configuration: "pandas.DataFrame",
) -> Results:
    """The table of the runs, and their agents."""
    import pandas

    rows: list[dict[str, Any]] = []
    agents: dict[str, dict[int, Any]] = {method: {} for method in methods}
    for (method, repetition), run in zip(plan, runs, strict=True):
        if run is None:
            continue
        agents[method][repetition.number] = run.agent
        common = {
            "method": method,
            "repetition": repetition.number,
            "seed": repetition.seed,
            "layout_seed": repetition.layout_seed if the_task.has_layout else the_task.settings.get("layout_seed"),
            "complete": run.complete,
        }
        points = zip(run.steps, run.returns, run.training_returns, run.episodes, strict=True)
        rows += [
            {**common, "step": step, "return": value, "training_return": training, "episodes": episodes}
            for step, value, training, episodes in points
        ]
    table = pandas.DataFrame(rows, columns=list(MEASURED))
    return Results(with_types(table.join(configuration, on="method")), agents)
