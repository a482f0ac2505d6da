"""Steps all copies of an MDP in a vector environment: as machine code, or interpreted if results would differ.

The storage of their states is columns (compiled) or loose (interpreted): a list of Python states.
"""

import copy
import dis
import math
import warnings
from collections.abc import Callable
from importlib.util import find_spec
from types import CodeType
from typing import Any

import numpy as np

from edugym.adapters.columns import Listed, as_sampled, copy_of, head, loose
from edugym.adapters.copies import OVER_AT_START, STATE_LOST, Batch
from edugym.checks.mdps import checked_mdp
from edugym.compiled.code import Code, is_foreign
from edugym.compiled.execution import executable
from edugym.compiled.snapshot import Snapshot
from edugym.system.interrupts import SignalGuard

Loop = Callable[..., int]
REHEARSED = 100  # copies
STORING = ("STORE_SUBSCR", "STORE_SLICE", "DELETE_SUBSCR")
IN_PLACE = {"fill", "partition", "put", "shuffle", "sort"} | {
    name for name, value in vars(np).items() if isinstance(value, np.ufunc)
}
"""Functions and methods that may change an array that they are given: a ufunc may be given one for its result."""
MOST_CHANGES = 3  # so often is machine code rebuilt because the student's code changed


class Runner:
    """Runs loops over the copies of an MDP, whose states it keeps.

    Before a call of machine code made from a student's classes it keeps a copy of what the call changes. If the call
    raises an error, a reward is not finite, or a state does not fit its storage, it is repeated interpreted, and
    the copies stay interpreted from then on: an error then shows the student's line, and no digit is lost.

    Args:
        mdp: the task.
        n: how many copies there are.
        states: storage for their states.
        sample: a state, whose numbers are of the types that the MDP uses.

    Attributes:
        states: the storage.
    """

    def __init__(self, mdp: Any, n: int, states: Any, sample: Any) -> None:
        """See the class."""
        self.states = states
        self._mdp, self._n, self._sample = mdp, n, sample
        self._code: dict[Loop, Loop] = {}
        self._watched: list[Code] = []
        self._tables, self._changes_large = Snapshot(), False
        self._is_students, self._changes = False, 0
        self._interpreted = _is_loose(states)
        if self._interpreted and find_spec("numba"):
            warnings.warn(
                f"{type(mdp).__name__} cannot be compiled and runs interpreted, some hundred times slower: its states"
                " must be numbers, or tuples of numbers and arrays, always of the same types",
                stacklevel=4,
            )

    @property
    def is_compiled(self) -> bool:
        """Whether the loops run as machine code."""
        return not self._interpreted

    def state(self, i: int, storage: Any = None) -> Any:
        """The i-th state; of another storage, if one is given."""
        storage = self.states if storage is None else storage
        return storage.load(i) if isinstance(storage, Listed) else as_sampled(storage.load(i), self._sample)

    def run(
        self, loop: Loop, rng: np.random.Generator, batch: Batch, make_batch: Callable[[int], Batch], *arguments: Any
    ) -> int:
        """Run a loop over all copies.

        Args:
            loop: `reset_copies` or `step_copies`.
            rng: the random stream of all.
            batch: what the loop reads and writes besides the states.
            make_batch: `make_batch(n)` makes the same for n copies, to rehearse with.
            *arguments: what the loop takes between the random stream and the states. Arrays have one element per copy.
        """
        if self._watched and (changed := next(filter(None, (code.first_change() for code in self._watched)), None)):
            self._code.clear()
            self._watched.clear()
            self._changes += 1
            if self._changes > MOST_CHANGES:
                self._interpret()
                self._say_why(f"{changed} changes again and again: what changes should be a field")
        if loop not in self._code:
            self._prepare(loop, rng, make_batch, arguments)
        if self._interpreted and self._is_students:
            return self._run_interpreted_and_explain(loop, rng, batch, arguments)
        if self._interpreted:
            return self._run_loop(loop, self._mdp, rng, batch, _plain(arguments))
        machine_code = self._code[loop]
        if not self._is_students:
            return self._run_loop(machine_code, self._mdp, rng, batch, arguments)
        saved = self._saved(rng, batch)
        succeeded, reason = False, "its states have changed their type"
        with SignalGuard() as guard:
            guard.defer(machine_code=True)
            try:
                done = machine_code(self._n, self._mdp, rng, *arguments, self.states, batch)
                succeeded = done not in (STATE_LOST, OVER_AT_START) and bool(np.isfinite(batch.rewards).all())
                if succeeded:
                    return done
            except Exception as error:  # the interpreter shows it, at the student's line
                reason = f"machine code stops where Python goes on ({error or type(error).__name__})"
            finally:
                if not succeeded:  # also after Ctrl-C
                    self._put_back(saved, rng, batch)
        self._interpret()
        done = self._run_interpreted_and_explain(loop, rng, batch, arguments)
        self._say_why(reason)
        return done

    def _say_why(self, reason: str) -> None:
        name = type(self._mdp).__name__
        warnings.warn(f"{name} runs interpreted from here on, some hundred times slower: {reason}", stacklevel=4)

    def _run_loop(
        self, loop: Loop, mdp: Any, rng: np.random.Generator, batch: Batch, arguments: tuple[Any, ...]
    ) -> int:
        """Run a loop as it is, and refuse a state that its storage cannot hold, and one that is over at the start."""
        done: int = loop(self._n, mdp, rng, *arguments, self.states, batch)
        if done == STATE_LOST:
            raise TypeError(f"states of {type(self._mdp).__name__} do not fit the storage that was made for them")
        if done == OVER_AT_START:
            raise ValueError(f"initial of {type(self._mdp).__name__} must return a state that is not terminal")
        return done

    def _run_interpreted_and_explain(
        self, loop: Loop, rng: np.random.Generator, batch: Batch, arguments: tuple[Any, ...]
    ) -> int:
        """Run a loop interpreted over a student's MDP; where it fails, run it again with checks that say why."""
        arguments, saved = _plain(arguments), self._saved(rng, batch)
        failure: Exception | None = None
        try:
            done = self._run_loop(loop, self._mdp, rng, batch, arguments)
        except Exception as error:
            failure = error
        if failure or not np.isfinite(batch.rewards).all() or _has_none(self.states):
            self._put_back(saved, rng, batch)
            done = self._run_loop(loop, checked_mdp(self._mdp, math.inf), rng, batch, arguments)
        if failure:  # the checks have found nothing to explain it by, so it is raised as it came
            raise failure
        return done

    def _saved(self, rng: np.random.Generator, batch: Batch) -> tuple[Any, ...]:
        """A copy of what a loop changes and goes on from; of the MDP's large arrays only if a step may change them."""
        self._tables.take((self._mdp,), large=self._changes_large)
        return copy_of(self.states), rng.bit_generator.state, batch.steps.copy(), batch.over.copy()

    def _put_back(self, saved: tuple[Any, ...], rng: np.random.Generator, batch: Batch) -> None:
        """Go back to where a loop began."""
        self.states, rng.bit_generator.state, batch.steps[:], batch.over[:] = saved
        self._tables.put_back()

    def _prepare(
        self, loop: Loop, rng: np.random.Generator, make_batch: Callable[[int], Batch], arguments: tuple[Any, ...]
    ) -> None:
        """Find the fastest safe way to run a loop, from a few of the copies."""
        n = min(self._n, REHEARSED)
        batch = make_batch(n)
        some = [part[:n] if isinstance(part, np.ndarray) else part for part in arguments]
        states = head(self.states, n)
        code = Code(loop, (self._mdp, rng, *some, states, batch))
        self._is_students = code.foreign
        self._tables.take((self._mdp,), large=False)
        if self._is_students and not self._tables.is_whole:
            self._changes_large |= any(
                _may_change_arrays(function.__code__) for function in code.functions if is_foreign(function)
            )
        if not self._interpreted:
            if code.foreign:
                self._watched.append(code)
            try:
                values = (self._mdp, copy.deepcopy(rng), *some, states, batch)
                self._code[loop] = executable(loop, values, rehearsed=n, replayed=False)
            except Exception:  # a student's mistake, which the interpreter will meet again and show
                self._code[loop] = loop
        if self._interpreted or self._code[loop] is loop:
            self._code[loop] = loop
            self._interpret()

    def _interpret(self) -> None:
        """Run interpreted from here on, with the states as the MDP makes them."""
        self._interpreted = True
        self._watched.clear()
        if not _is_loose(self.states):
            self.states = loose([self.state(i) for i in range(self._n)])

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the machine code, to be pickled or copied."""
        return {**self.__dict__, "_code": {}, "_watched": []}


def _may_change_arrays(code: CodeType) -> bool:
    """Whether code, or an inner function of it, stores into an array, or calls what changes one in place."""
    return any(
        instruction.opname in STORING
        or (instruction.opname == "BINARY_OP" and instruction.argrepr.endswith("="))
        or (instruction.opname in ("LOAD_ATTR", "LOAD_METHOD") and instruction.argval in IN_PLACE)
        for instruction in dis.get_instructions(code)
    ) or any(_may_change_arrays(constant) for constant in code.co_consts if isinstance(constant, CodeType))


def _plain(arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """The arguments with actions that are Python's whole numbers, as a single environment gives them: of any size."""
    return tuple(
        part.tolist() if isinstance(part, np.ndarray) and part.ndim == 1 and part.dtype == np.int64 else part
        for part in arguments
    )


def _has_none(states: Any) -> bool:
    """Whether a state is None, which a method without a `return` gives."""
    return isinstance(states, Listed) and any(state is None for state in states.values)


def _is_loose(states: Any) -> bool:
    return isinstance(states, Listed) and isinstance(states.values, np.ndarray)
