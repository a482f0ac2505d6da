"""Runs a reader's program in the browser: in Pyodide, with the package's own checks and the translation to JavaScript.

`edugym_page.run` is called by worker `own.js`, which gives what only JavaScript has.
"""

import ast
import linecache
import math
import re
import time
import traceback
import warnings
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

import edugym
import edugym.objectives
from edugym.adapters.fitting import fitted
from edugym.checks.contract import LEARN_PARAMETERS, contract_of, tables_of
from edugym.checks.values import deep_copy
from edugym.compiled.javascript import program as javascript
from edugym.compiled.javascript.libraries import LIBM
from edugym.mdp.task import Task, table_size, task_of
from edugym.training.evaluated import actor

FILE = "<ipython-page>"
"""Like a cell of a notebook: messages name its lines without it."""
PAUSE = 0.1
"""Seconds between two pictures."""
SHARE = 10
"""At least so many times as long as a picture takes, no other is made."""
GAMES = 3
"""Games that are shown at the end."""
MOST_STEPS = 100
"""Of a game that is shown: who has learned nothing may never come to its end."""
Show = Callable[[Any, Any, list[Any]], Any]
MAY_LEARN_FROM = (*LEARN_PARAMETERS, "rewards")
FORGOTTEN = (
    "learn of {} does not look at terminated, so it adds the value of a next state also where a game has ended. Where "
    "that value stays 0, as in Boulder, this changes nothing. Where an end looks like another place it can cost "
    "points, as in Golf with a learning rate of 0.1."
)
NAMES = {"edugym": edugym, "np": np, "NamedTuple": NamedTuple, "__name__": "__main__"}


class Browser:
    """Runs translations in the browser, on the memory that Python has.

    Args:
        make: from the text of a translation and numbers to numbers, in JavaScript.
        shared: from Python's arrays to JavaScript's.
        libm: the functions of mathematics of Pyodide's own that JavaScript can call.
    """

    def __init__(self, make: Any, shared: Any, libm: Any) -> None:
        """See the class."""
        self._make, self._shared = make, shared
        self.libm = LIBM & frozenset(libm)

    def load(self, text: str) -> Any:
        """See `edugym.compiled.javascript.program.Engine`."""
        program = self._make(text)

        def run(numbers: Any) -> list[float]:
            answer = program(self._shared(np.array(numbers, np.float64)))
            if isinstance(answer, str):
                raise javascript.Doubt(answer)
            return list(answer.to_py())

        return run

    def address(self, array: Any) -> int:
        """Where in the memory an array begins."""
        return int(array.ctypes.data)

    def stream(self, rng: np.random.Generator) -> int:
        """Where the state of a random stream is."""
        return int(rng.bit_generator.ctypes.state_address)


class Look(NamedTuple):
    """How the page decides a picture.

    Attributes:
        parts: which numbers in a state decide it, by their names, see `places.Map.look`.
        n_observations: how many observations there are: a row that remembers more begins again after so many.
    """

    parts: tuple[str, ...]
    n_observations: int

    def of(self, state: Any, row: Any) -> list[float]:
        """The numbers, in a state that is observed as this row of a table."""
        state = getattr(state, "inner", state)
        observed = {"": state, "observation": row % self.n_observations if "observation" in self.parts else None}
        return [float(observed[part] if part in observed else getattr(state, part[1:])) for part in self.parts]


class Watch:
    """Shows what an agent knows while `train` asks it, between two short calls, whether to stop. It never says so.

    Args:
        mdp: the task.
        agent: the agent.
        n_steps: how many steps it will be trained for.
        show: is given flat arrays: the visits of all rows of the table, the action values, none if it has no such
            table, and a list of games: of each the numbers that decide the picture, moment after moment.
        look: which numbers these are; None if the task has no picture on the page.

    Attributes:
        agent: the agent; its visits are counted where it has a table.
    """

    def __init__(self, mdp: Any, agent: Any, n_steps: int, show: Show, look: Look | None) -> None:
        """See the class."""
        contract = contract_of(agent, MAY_LEARN_FROM)
        self._mdp, self._look, self._games = mdp, look, 0
        self._agent, self._show, self._next = contract.agent, show, -math.inf
        self.agent = edugym.record_visits(agent, mdp, n_steps, n_intervals=1) if contract.tabular else agent
        self._shape = table_size(mdp) if contract.tabular else None

    def is_set(self) -> bool:
        """Show it, some times a second."""
        began = time.perf_counter()
        if began > self._next:
            self.show()
            now = time.perf_counter()
            self._next = now + max(PAUSE, SHARE * (now - began))
        return False

    def set(self) -> None:
        """The page stops a run by ending the worker."""

    def show(self, n_games: int = 1) -> None:
        """Show visits and values as they are now, and games that the agent plays with them."""
        tabular = self._shape is not None
        visits = np.array(self.agent.visits[0] if tabular else [], np.float64)
        self._show(visits, self._values() if tabular else visits, [self._game() for _ in range(n_games)])

    def _values(self) -> Any:
        """The action values by its fields' names; Go-Explore's are those of the goal that is its best state so far."""
        tables = tables_of(self._agent)
        Q = tables.get("Q", next(iter(tables.values()), np.zeros(0)))
        if Q.ndim == 3 and hasattr(self._agent, "best_state"):
            Q = Q[self._agent.best_state[0]]
        return np.array(Q if Q.shape == self._shape else np.zeros(0), np.float64).ravel()

    def _game(self) -> Any:
        """A game without exploring; a copy plays, with random numbers of its own, so that the run stays as it is."""
        self._games += 1
        try:
            agent = contract_of(deep_copy(self._agent, "the page shows how a copy plays"), MAY_LEARN_FROM)
            task = task_of(self._mdp)  # where rewards are vectors, it has rows, and Q another shape
            task = task if "rewards" in agent.learns_from else fitted(task, agent)
            moments = play(task, actor(agent), self._look, self._games) if self._look else []
        except Exception:  # what is wrong with the agent, `train` says
            moments = []
        return np.array(moments, np.float64).ravel()


def play(task: Task, player: Any, look: Look, seed: int) -> list[list[float]]:
    """Play a game, of `MOST_STEPS` at most, and return the numbers that decide the picture of each of its moments."""
    mdp, rng = task.played, np.random.default_rng(seed)
    state = mdp.initial(rng)
    observation = mdp.observation(state, rng)
    moments = [look.of(state, observation)]
    while len(moments) <= min(MOST_STEPS, task.max_steps or MOST_STEPS) and not mdp.terminal(state):
        state = mdp.transition(state, player.act(observation, rng), rng)
        observation = mdp.observation(state, rng)
        moments.append(look.of(state, observation))
    return moments


def run(
    source: str,
    task: str,
    n_steps: int,
    seed: int,
    episodes: int,
    show: Show,
    parts: Any,
    n_observations: int,
    measured: str | None = None,
) -> dict[str, Any]:
    """Train the agent of a reader's program.

    Args:
        source: the program, which makes `agent`; it finds the task as `mdp`.
        task: the lines that make `mdp`.
        n_steps: how many steps to train.
        seed: of the run.
        episodes: the evaluation episodes of each point of the curve.
        show: is told what the agent knows, again and again, see `Watch`.
        parts: which numbers decide the picture of the task, see `Look`.
        n_observations: how many observations the task has, see `Look`.
        measured: where rewards are vectors, the numbers of the curve, from the `VectorRun` called `run`.

    Returns:
        The learning `curve`, the `seconds` that it took, and what was `said`; or an `error` and its `line`.
    """
    linecache.cache[FILE] = len(source), None, source.splitlines(keepends=True), FILE
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        try:
            space: dict[str, Any] = dict(NAMES)
            exec(task, space)
            given = space["mdp"]
            ast.parse(source, FILE)
            exec(compile(source, FILE, "exec"), space)
            if "agent" not in space:
                return {"error": "The code must make an agent, as in its last line: agent = ...", "line": None}
            _refuse_lists(space["agent"])
            mdp = space["mdp"]
            look = Look(tuple(parts), n_observations) if mdp is given else None  # the picture is of the page's task
            watch = Watch(mdp, with_64_bits(space["agent"]), n_steps, show, look)
            train = edugym.objectives.train_vectors if measured else edugym.train
            done: Any = train(mdp, watch.agent, n_steps, seed=seed, evaluation_episodes=episodes, stop=watch)
            watch.show(GAMES)
        except (Exception, SystemExit, KeyboardInterrupt) as error:
            return {"error": _told(error), "line": _line(error) or _place(source, str(error))}
    values = eval(measured, {"run": done}) if measured else done.returns
    points = zip(done.steps.tolist(), values.tolist(), strict=True)
    said = [str(one.message) for one in caught if issubclass(one.category, UserWarning)]
    if forgets_the_end(source, type(space["agent"]).__name__):
        said.append(FORGOTTEN.format(type(space["agent"]).__name__))
    return {"curve": [list(point) for point in points], "seconds": done.seconds, "said": said}


def forgets_the_end(source: str, name: str) -> bool:
    """Whether the class of this name learns from the next state, and never looks at whether the episode terminated."""
    for part in ast.walk(ast.parse(source)):
        for method in part.body if isinstance(part, ast.ClassDef) and part.name == name else []:
            if isinstance(method, ast.FunctionDef) and method.name == "learn" and method.args.kwarg is None:
                used = [one.id for one in ast.walk(method) if isinstance(one, ast.Name)]
                return "next_state" in used and "terminated" not in used
    return False


def with_64_bits(value: Any) -> Any:
    """The agent, with whole numbers of 64 bits in its arrays, as `np.zeros(n, int)` has them outside a browser."""
    known = dict[int, Any]()

    def changed(part: Any) -> Any:
        if isinstance(part, np.ndarray) and part.dtype == np.int32:
            return known.setdefault(id(part), part.astype(np.int64))
        if isinstance(part, tuple) and hasattr(part, "_fields"):
            return tuple.__new__(type(part), map(changed, tuple.__iter__(part)))
        return part

    return changed(value)


def _told(error: BaseException) -> str:
    text = error.msg if isinstance(error, SyntaxError) else str(error)
    if isinstance(error, ModuleNotFoundError):
        text += ". The page has edugym, numpy and the modules of Python itself"
    text = re.sub(
        r"np\.(?:u?int|float)\d*\(([^()]*)\)|np\.(?=True_|False_)|(?<=True|alse)_\b", r"\1", text
    )  # plain numbers
    return f"{type(error).__name__}: {text}{_hint(text)}".removesuffix(": ")


def _hint(text: str) -> str:
    """What may be behind a message of Python's, or of numbers that grow without end."""
    if re.search(r"'(float|int|numpy\.\w+)' object is not callable", text):
        return ". Is a * missing before a bracket?"
    if re.search(r"has no attribute '(n|num|number)_?\w*(states|actions|observations)'", text):
        return ". edugym.table_size(mdp) gives the numbers of states and actions"
    if text == "setting an array element with a sequence.":
        return " One number belongs there: is .max() or an index such as [action] missing?"
    return ". Is the learning rate too large, or a value divided by 0?" if re.search(r"\bis nan\b", text) else ""


def _refuse_lists(agent: Any) -> None:
    """Lists where an agent says that it has an array: the message would name a line that is right.

    Raises:
        TypeError: there is one.
    """
    for name, kind in getattr(type(agent), "__annotations__", {}).items():
        if kind is np.ndarray and isinstance(getattr(agent, name, None), list | tuple | int | float):
            given = type(getattr(agent, name)).__name__
            raise TypeError(f"{name} must be an array, but is a {given}: make it with np.array(...) or np.zeros(...)")


def _place(source: str, text: str) -> int | None:
    """The line of which a message tells that comes from no line: a method by its name, else where `agent` is made."""
    named = re.match(r"(act|greedy|learn) of \w+", text)
    try:
        parts = list(ast.walk(ast.parse(source)))
    except SyntaxError:
        return None
    if named:
        return next(
            (part.lineno for part in parts if isinstance(part, ast.FunctionDef) and part.name == named[1]), None
        )
    makes = [part.lineno for part in parts if isinstance(part, ast.Assign) and ast.unparse(part.targets[0]) == "agent"]
    return makes[-1] if makes and "must be an array" in text else None


def _line(error: BaseException) -> int | None:
    """The last line of the reader's code on the way to an error."""
    if isinstance(error, SyntaxError):
        return error.lineno
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == FILE]
    return lines[-1] if lines else None
