"""Annotations for the allowed values of the fields of agents and strategies, and `new`, which creates agents from them.

Each range or shape is declared once, in the annotation of the field:

    class QLearning(NamedTuple):
        Q: ActionValues                      # a table of shape (n_states, n_actions)
        learning_rate: LearningRate = 0.1    # above 0 and up to 1

`new(QLearning, environment, {"discount": 0.9})` creates the tables, uses the defaults of the other settings, and
raises ValueError for a value that is not allowed.
"""

import inspect
import math
import weakref
from collections.abc import Mapping
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple, TypeVar, get_args, get_origin, get_type_hints

import numpy as np

from edugym.checks.interfaces import require_method
from edugym.checks.parameters import (
    MOST_STEPS,
    a_number,
    above,
    as_float,
    at_least,
    between,
    in_short,
    true_or_false,
    whole_number,
)
from edugym.mdp.protocol import Integers, Reals
from edugym.mdp.task import table_size
from edugym.system.memory import require_memory
from edugym.system.packages import is_own

Made = TypeVar("Made")


class Range(NamedTuple):
    """The range of a number.

    Attributes:
        low: the lowest.
        high: the highest; with None any finite number is allowed (a whole one up to 2^62), with `math.inf` infinity as
            well.
        open: whether `low` itself is excluded.
    """

    low: float
    high: float | None = None
    open: bool = False

    def check(self, name: str, value: Any) -> None:
        """Check that a value is in the range.

        Raises:
            ValueError: the value is outside the range or is not a number.
        """
        if self.open:
            above(name, value, self.low, None if self.high == math.inf else self.high)
        elif self.high is None:
            at_least(name, value, self.low)
        else:
            between(name, value, self.low, self.high)
        if self.high is None:
            a_number(name, value)


class Table(NamedTuple):
    """An array of a new agent.

    Attributes:
        axes: the length of each axis: a number, or a name ("states", "actions", ...) whose length `new` is passed.
        fill: the first value of every entry: a number, or the name of a setting.
    """

    axes: tuple[int | str, ...]
    fill: float | str = 0.0


class Part(NamedTuple):
    """Marks a field that is not a setting, because `create` fills it."""


LearningRate = Annotated[float, Range(0, 1, open=True)]
Discount = Annotated[float, Range(0, 1)]
Probability = Annotated[float, Range(0, 1)]
ActionValues = Annotated[Reals, Table(("states", "actions"), fill="initial_value")]
"""Q, shape (n_states, n_actions). Agents that have it take the setting `initial_value` (0): high values are optimistic
and make an agent explore (Sutton and Barto, section 2.6)."""
Counter = Annotated[Integers, Table((1,))]
"""A whole number that changes during learning: an array of shape (1,), since fields of a NamedTuple are fixed."""


def new(
    kind: type[Made],
    environment: Any,
    settings: Mapping[str, Any],
    parts: Mapping[str, Any] = MappingProxyType({}),
    /,
    **sizes: int,
) -> Made:
    """Create an agent or a strategy: make its tables for an environment, and check its settings.

    Args:
        kind: its class, a NamedTuple whose fields are annotated as in this file.
        environment: an MDP or Gymnasium environment whose actions and observations are whole numbers (or tuples of
            them), or the shape (n_states, n_actions) of a table; None only if no table depends on it.
        settings: values for the fields that are not tables, and `initial_value`; the others keep their defaults.
        parts: values for the fields that the caller has made, by name.
        **sizes: lengths of axes that do not follow from the environment, by name.

    Raises:
        ValueError: a setting is unknown, or a value is not allowed.
    """
    marks = (_mark(hint, Table) for name, hint in _hints(kind).items() if name not in parts)
    tables = [table for table in marks if table is not None]
    needed = {axis for table in tables for axis in table.axes}
    if environment is not None or (needed & {"states", "actions"}) - sizes.keys():
        sizes["states"], sizes["actions"] = table_size(environment)
    allowed = settings_of(kind)
    for name in settings:
        if name not in allowed:
            create = getattr(kind, "create", None)  # which may take more than these
            known = inspect.signature(create).parameters if create is not None else allowed
            listed = ", ".join(setting for setting in known if setting != "environment")
            raise ValueError(f"{kind.__name__} has no setting {name!r}; it has {listed}")
    for name, default in allowed.items():
        if default is inspect.Parameter.empty and name not in settings:
            raise ValueError(f"{kind.__name__} needs the setting {name!r}")
    values = {**allowed, **settings}
    for table in tables:
        if isinstance(table.fill, str):
            a_number(table.fill, values[table.fill])
    missing = {name: hint for name, hint in _hints(kind).items() if name not in parts}
    made = kind(**{name: _field(name, hint, values, sizes) for name, hint in missing.items()}, **parts)
    check(made)
    _check_sizes(made, sizes)
    return made


def _check_sizes(value: Any, sizes: Mapping[str, int]) -> None:
    """Refuse a strategy with tables that were made for another environment.

    Raises:
        ValueError: a table inside `value` has another size.
    """
    for part in value:
        if not hasattr(part, "_fields") or isinstance(part, type):
            continue
        for name, hint in _hints(type(part)).items():
            table, array = _mark(hint, Table), getattr(part, name)
            for axis, length in enumerate(table.axes if table is not None else ()):
                if sizes.get(str(length), array.shape[axis]) != array.shape[axis]:
                    raise ValueError(
                        f"{type(part).__name__} was made for {array.shape[axis]} {length}, but the agent has"
                        f" {sizes[str(length)]}: give each environment its own"
                    )
        _check_sizes(part, sizes)


def settings_of(kind: type) -> dict[str, Any]:
    """The settings that `new` takes for a class, with their defaults; `initial_value` comes last.

    The default is `inspect.Parameter.empty` if a setting has none.
    """
    defaults = getattr(kind, "_field_defaults", {})
    settings: dict[str, Any] = {}
    for name, hint in _hints(kind).items():
        table = _mark(hint, Table)
        if table is not None and isinstance(table.fill, str):
            settings[table.fill] = 0.0
        elif table is None and not hasattr(hint, "_fields") and _mark(hint, Part) is None:
            settings[name] = defaults.get(name, inspect.Parameter.empty)
    initial_value = {name: settings.pop(name) for name in ("initial_value",) if name in settings}
    return settings | initial_value


def check(value: Any) -> None:
    """Check every field of an agent or strategy, and of the strategies inside it.

    Raises:
        ValueError: a number is outside its range, an array has the wrong dtype or number of axes, or a field has a
        value
            of the wrong class.
    """
    for name, hint in _hints(type(value)).items():
        part = getattr(value, name)
        number, table = _mark(hint, Range), _mark(hint, Table)
        if table is not None:
            kind = _kind_of_numbers(hint)
            if not (isinstance(part, np.ndarray) and part.dtype == kind and part.ndim == len(table.axes)):
                given = f"{part.dtype} {part.shape}" if isinstance(part, np.ndarray) else repr(part)
                raise ValueError(
                    f"{name} must be an array of {kind.__name__} with {len(table.axes)} axes, but is {given}"
                )
        elif isinstance(hint, type) and hasattr(hint, "_fields") and not isinstance(part, hint):
            raise ValueError(f"{name} must be a {hint.__name__}, but is {in_short(part)}")
        elif number is not None:
            if get_args(hint)[0] is int:
                whole_number(name, part, int(number.low), MOST_STEPS if number.high is None else int(number.high))
            number.check(name, part)
        elif hint is bool:
            true_or_false(name, part)
        elif name == "exploration" and (isinstance(part, type | np.ndarray) or not hasattr(part, "choose")):
            raise ValueError(f"exploration must be a strategy such as EpsilonGreedy(0.1), but is {in_short(part)}")
        elif name == "exploration" and not is_own(part):
            require_method(part, "choose", ("Q", "state", "rng"))
        if hasattr(part, "_fields") and not isinstance(part, type):
            check(part)


def shows_settings(kind: type[Made]) -> type[Made]:
    """Class decorator for agents: add the settings to the signature of `create`, for help and completion."""
    create = inspect.getattr_static(kind, "create").__func__
    signature = inspect.signature(create)
    named = [part for part in signature.parameters.values() if part.kind is not part.VAR_KEYWORD]
    keyword = inspect.Parameter.KEYWORD_ONLY
    known = {part.name for part in named}
    named += [inspect.Parameter(n, keyword, default=v) for n, v in settings_of(kind).items() if n not in known]
    create.__signature__ = signature.replace(parameters=named)
    return kind


def _hints(kind: type) -> dict[str, Any]:
    """The annotated types of the fields of a NamedTuple class, in order; `Any` for a field without annotation."""
    written: dict[str, Any] = {}
    for base in reversed(kind.__mro__):
        written |= inspect.get_annotations(base)
    known = _known_hints.get(kind)
    if known is not None and known[0] == written:
        return dict(known[1])
    try:
        hints = get_type_hints(kind, include_extras=True)
    except NameError:  # a user's class inside a function, whose annotations use local names
        hints = {}
    found = {name: hints.get(name, Any) for name in getattr(kind, "_fields", ())}
    if all(hint is written.get(name) for name, hint in found.items()):  # no name in them that may come to mean another
        _known_hints[kind] = written, found
    return dict(found)


_known_hints: "weakref.WeakKeyDictionary[type, tuple[dict[str, Any], dict[str, Any]]]" = weakref.WeakKeyDictionary()
"""The hints of classes, each with what is written there. To look through them takes as long as a short run."""


def _mark(hint: Any, kind: type) -> Any:
    """The `Range`, `Table` or `Part` in an annotation, or None."""
    marks = getattr(hint, "__metadata__", ())
    return next((mark for mark in marks if isinstance(mark, kind)), None)


def _kind_of_numbers(hint: Any) -> type[np.generic]:
    """`np.float64` for a table of `Reals`, `np.int64` for one of `Integers`."""
    array = get_args(hint)[0]  # np.ndarray[shape, np.dtype[kind]]
    kind: type[np.generic] = get_args(get_args(array)[1])[0]
    return kind


def _field(name: str, hint: Any, values: Mapping[str, Any], sizes: Mapping[str, int]) -> Any:
    """The value of a field of a new agent."""
    table = _mark(hint, Table)
    if table is not None:
        shape = tuple(sizes[axis] if isinstance(axis, str) else axis for axis in table.axes)
        fill = values[table.fill] if isinstance(table.fill, str) else table.fill
        require_memory(name, shape, "show the agent less, or give rows only to what occurs (edugym.Hashed)")
        return np.full(shape, fill, _kind_of_numbers(hint))
    if isinstance(hint, type) and hasattr(hint, "_fields"):
        return new(hint, None, {}, **sizes)
    value = values[name]
    kind = get_args(hint)[0] if get_origin(hint) is Annotated else hint
    if kind is float and isinstance(value, int | np.number) and not isinstance(value, bool):
        return as_float(value)
    if kind is int and isinstance(value, np.integer):
        return int(value)
    return value
