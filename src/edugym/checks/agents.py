"""What a student's agent returns is checked, and what it may not change.

The first steps are checked in every way. Later steps that the interpreter runs are still checked for what would spread
silently: actions, rewards and observations that may not be. The checks change nothing: they draw no random numbers, and
each method is called as often as without them. The package's own classes are not checked here; the tests cover them.
"""

import inspect
import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.random import Generator as Random

from edugym.checks.contract import LEARN_PARAMETERS, METHODS, tables_of
from edugym.checks.mdps import CHECKED_STEPS, refuse_change
from edugym.checks.parameters import in_short
from edugym.checks.values import GlobalDraws, fits, kept
from edugym.system.packages import is_ours, is_own

SMALL = 10_000
"""A table with more entries is not searched for NaN after each step."""


def checked_agent(agent: Any, task: Any, steps: float = CHECKED_STEPS) -> Any:
    """Return the agent, in the form that the loops use, with checks around a student's agent inside it.

    Args:
        agent: a tuple with the student's agent somewhere in it.
        task: the MDP or environment in which it acts.
        steps: how many of its first actions are checked in every way.
    """
    if is_own(agent):
        return agent
    if is_ours(type(agent)) and "agent" in getattr(agent, "_fields", ()):  # what the loops need around an agent
        return tuple.__new__(type(agent), [checked_agent(part, task, steps) for part in tuple.__iter__(agent)])
    return CheckedAgent(agent, task, steps) if hasattr(agent, "act") else agent


def students_parts(agent: Any) -> list[str]:
    """Return the names of the student's classes, such as a strategy, that are parts of one of the package's agents."""
    if not isinstance(agent, tuple) or not is_ours(type(agent)):
        return []
    return [type(part).__name__ for part in tuple.__iter__(agent) if not is_own(part)]


class CheckedAgent:
    """An agent that checks the actions that it returns.

    Args:
        agent: the agent.
        task: the MDP or environment in which it acts.
        steps: for how many actions it also checks tables, states and global streams, which takes longer.
    """

    def __init__(self, agent: Any, task: Any, steps: float = CHECKED_STEPS) -> None:
        """See the class."""
        self._agent, self._task, self._left, self._space = agent, task, steps, task.action_space
        discrete = isinstance(self._space, spaces.Discrete) and self._space.start == 0
        self._n_actions = int(self._space.n) if discrete else 0
        self._name = ", with ".join([type(agent).__name__, *students_parts(agent)])
        self._draws = GlobalDraws(self._name)

    def __getattr__(self, name: str) -> Any:
        """Everything else that the agent has."""
        return getattr(self._agent, name)

    def act(self, state: Any, rng: Random) -> Any:
        """The agent's action.

        Raises:
            ValueError: it is not in the action space, or the state was changed.
        """
        return self._chosen("act", state, rng)

    def greedy(self, state: Any, rng: Random) -> Any:
        """The action by which it is evaluated.

        Raises:
            ValueError: it is not in the action space, or the state was changed.
        """
        return self._chosen("greedy", state, rng)

    def learn(self, **told: Any) -> None:
        """Let the agent learn.

        Raises:
            ValueError: a state was changed, a table has come to hold NaN, or `learn` returns a new agent.
        """
        if self._left <= 0:  # from here on without a detour
            vars(self).update(learn=self._agent.learn)
            self._agent.learn(**told)
            return
        before = kept((told.get("state"), told.get("next_state")))
        with self._draws.refused("learn"):
            returned = self._with_sizes(lambda: self._learned(told))
        refuse_change(self._agent, "learn", before, (told.get("state"), told.get("next_state")))
        if isinstance(returned, type(self._agent)):
            raise ValueError(
                f"learn of {self._name} returns a new {self._name}, which is lost: change its arrays instead"
            )
        for name, table in tables_of(self._agent).items():
            if table.size <= SMALL and table.dtype.kind == "f" and np.isnan(table).any():
                where = list(map(int, np.argwhere(np.isnan(table))[0]))
                given = ", ".join(f"{one} {in_short(value)}" for one, value in told.items())
                raise ValueError(
                    f"learn of {self._name} must leave numbers in {name}, but {name}{where} is nan after {given}"
                )

    def _learned(self, told: dict[str, Any]) -> Any:
        """Return what `learn` returns; where it looks for something that it was not told, say how it gets that."""
        try:
            return self._agent.learn(**told)
        except KeyError as error:
            takes = inspect.signature(self._agent.learn).parameters.values()
            rest = next((one.name for one in takes if one.kind is one.VAR_KEYWORD), None)
            if rest is None or str(error) not in map(repr, LEARN_PARAMETERS):
                raise
            named = ", ".join(["self", *METHODS["learn"]])
            says = f"learn of {self._name} is told only what its parameters name, and **{rest} gets nothing"
            raise ValueError(f"{says}: write learn({named})").with_traceback(error.__traceback__) from None

    def _chosen(self, method: str, state: Any, rng: Random) -> Any:
        choose = getattr(self._agent, method)
        if self._left > 0:
            self._left -= 1
            before = kept(state)
            with self._draws.refused(method):
                action = self._with_sizes(lambda: choose(state, rng))
            refuse_change(self._agent, method, before, state)
        else:
            action = self._with_sizes(lambda: choose(state, rng))
        if not (type(action) is int and 0 <= action < self._n_actions) and not is_action(self._space, action):
            row = isinstance(action, int | np.integer) and not isinstance(action, bool)
            sizes = self._sizes() if row else ""
            raise ValueError(wrong_action(f"{method} of {self._name}", self._space, action, state) + sizes)
        return np.int64(action) if isinstance(action, np.int32) else action  # NumPy's own in a browser, of 32 bits

    def _with_sizes(self, call: Callable[[], Any]) -> Any:
        """Return the result of a call; explain an index that is too large by the sizes of tables."""
        try:
            return call()
        except IndexError as error:
            found = re.search(r"out of bounds for axis (\d) with size (\d+)", str(error))  # no list, tuple or text
            if found:
                axis, size = int(found[1]), int(found[2])
                error.args = (f"{error}{self._sizes(axis, size) or self._counted(axis, size)}",)
            raise

    def _counted(self, axis: int, size: int) -> str:
        """Return what the indices of a table are that has this size along an axis; nothing if there is none."""
        for name, table in tables_of(self._agent).items():
            if table.ndim == 2 and table.shape[axis : axis + 1] == (size,):
                rows, columns = table.shape
                return f": {name}[state, action] has states from 0 to {rows - 1}, and actions from 0 to {columns - 1}"
        return ""

    def _sizes(self, axis: int = 0, size: int | None = None) -> str:
        """Return what is wrong with the size of a table, or of one with this size along an axis; nothing if all fit."""
        rows, actions = self._task.observation_space, self._task.action_space
        if not (isinstance(rows, spaces.Discrete) and isinstance(actions, spaces.Discrete)):
            return ""
        for name, table in tables_of(self._agent).items():
            meant = size is None or table.shape[axis : axis + 1] == (size,)
            if meant and table.ndim == 2 and table.shape != (rows.n, actions.n):
                return (
                    f": {name} of {self._name} has the shape {table.shape}, but this environment has {rows.n}"
                    f" observations and {actions.n} actions"
                )
        return ""


def wrong_action(chooser: str, space: spaces.Space[Any], action: Any, state: Any) -> str:
    """Return the sentence about a wrong action: what the chooser returned, and what it should return."""
    allowed = f"an action, an element of {space}"
    if isinstance(space, spaces.Discrete):
        allowed = f"an action, a whole number from {space.start} to {space.start + space.n - 1}"
    forgotten = " (is a return missing?)" if action is None else ""
    returned = f"returned {in_short(action)} for state {in_short(state)}{forgotten}"
    return f"{chooser} must return {allowed}, but {returned}"


def is_action(space: spaces.Space[Any], action: Any) -> bool:
    """Whether the loops can give the action to an MDP (which checks the bounds of real numbers itself)."""
    if isinstance(space, spaces.Discrete):
        scalar = action[()] if isinstance(action, np.ndarray) and action.ndim == 0 else action
        return isinstance(scalar, int | np.integer) and fits(space, scalar)
    if isinstance(space, spaces.Box):
        try:
            numbers = np.asarray(action)
        except ValueError:
            return False
        real = numbers.dtype.kind in "iuf" and bool(np.isfinite(numbers).all())
        return real and (numbers.shape == space.shape or math.prod(space.shape) == numbers.size == 1)
    return fits(space, action)
