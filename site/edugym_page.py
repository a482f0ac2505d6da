"""Runs a reader's program in the browser: in Pyodide, with the package's own checks and the translation to JavaScript.

`edugym_page.run` is called by worker `own.js`, which gives what only JavaScript has.
"""

import ast
import linecache
import traceback
import warnings
from typing import Any, NamedTuple

import numpy as np

import edugym
from edugym.compiled.javascript import program as javascript
from edugym.compiled.javascript.libraries import LIBM

FILE = "<ipython-page>"
"""Like a cell of a notebook: messages name its lines without it."""
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


def run(source: str, task: str, n_steps: int, seed: int, episodes: int) -> dict[str, Any]:
    """Train the agent of a reader's program.

    Args:
        source: the program, which makes `agent`; it finds the task as `mdp`.
        task: the lines that make `mdp`.
        n_steps: how many steps to train.
        seed: of the run.
        episodes: the evaluation episodes of each point of the curve.

    Returns:
        The learning `curve`, the `seconds` that it took, and what was `said`; or an `error` and its `line`.
    """
    linecache.cache[FILE] = len(source), None, source.splitlines(keepends=True), FILE
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        try:
            space: dict[str, Any] = dict(NAMES)
            exec(task, space)
            ast.parse(source, FILE)
            exec(compile(source, FILE, "exec"), space)
            if "agent" not in space:
                return {"error": "The code must make an agent, as in its last line: agent = ...", "line": None}
            done = edugym.train(space["mdp"], space["agent"], n_steps, seed=seed, evaluation_episodes=episodes)
        except Exception as error:
            return {"error": _told(error), "line": _line(error)}
    points = zip(done.steps.tolist(), done.returns.tolist(), strict=True)
    said = [str(one.message) for one in caught if issubclass(one.category, UserWarning)]
    return {"curve": [list(point) for point in points], "seconds": done.seconds, "said": said}


def _told(error: Exception) -> str:
    text = error.msg if isinstance(error, SyntaxError) else str(error)
    return f"{type(error).__name__}: {text}"


def _line(error: Exception) -> int | None:
    """The last line of the reader's code on the way to an error."""
    if isinstance(error, SyntaxError):
        return error.lineno
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == FILE]
    return lines[-1] if lines else None
