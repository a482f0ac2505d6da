"""The rules of the challenge for a class: what the program checks of an agent before it is scored."""

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from types import FunctionType
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.contract import contract_of
from edugym.experiments.fingerprints import fingerprint, is_library
from edugym.experiments.profiles.ladders import Ladder
from edugym.mdp.protocol import Integers, Random
from edugym.mdp.tabular import tabular_mdp
from edugym.mdp.task import table_size
from edugym.mdp.wrapper import wrapper
from edugym.training.train import train
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.student_code import student_code

ROOM = 50
"""So many numbers an agent may keep beside its table: its settings, and a window of the last few steps."""
TRIED = 1_000
"""The training steps after which is looked at what an agent keeps, and at what it has learned."""
BITS = 64
"""A number has so many."""
KEPT = (int, float, complex, str, bytes, np.ndarray, np.generic, Mapping, Sequence, Set)
"""What can hold numbers."""


@wrapper
class Renumbered(NamedTuple):
    """A task whose states have other numbers, with more than as many again that never occur.

    Attributes:
        mdp: the task, whose observation is the row of a table.
        rows: shape (n_states,): the new number of each state.
    """

    mdp: Any
    rows: Integers

    @property
    def observation_space(self) -> spaces.Discrete:
        """The rows of a larger table."""
        return spaces.Discrete(_more(len(self.rows)))

    def observation(self, state: Any, rng: Random) -> int:
        """The new number."""
        return int(self.rows[self.mdp.observation(state, rng)])

    @classmethod
    def create(cls, mdp: Any) -> "Renumbered":
        """The wrapper for a task that a table can enter."""
        shown = tabular_mdp(mdp)
        n_states = int(shown.observation_space.n)
        return cls(shown, np.random.default_rng(0).permutation(_more(n_states))[:n_states])


def _more(n_states: int) -> int:
    return 2 * n_states + 7


def check_rules(agents: Mapping[str, Any], ladders: Sequence[Ladder]) -> None:
    """Refuse an agent that breaks a rule.

    Args:
        agents: as `by_the_rules` gives them.
        ladders: those that it will climb.

    Raises:
        ValueError: it names the rule, and what breaks it; or the agent's code raises an error, or does not end.
    """
    try:
        _check_rules(agents, ladders)
    except WrongAnswer as error:
        raise ValueError(str(error)) from error


def _check_rules(agents: Mapping[str, Any], ladders: Sequence[Ladder]) -> None:
    for label, make in agents.items():
        _check_settings(label, make, ladders)
        for ladder in ladders:
            task = ladder.make(ladder.strengths[0], layout_seed=0)
            with student_code(f"making {label} for {ladder.name}"):
                takes_rows = contract_of(make(task)).tabular
            if not takes_rows:
                raise ValueError(f"rule 1, one table: {label} must take observations as rows, but `tabular` is False")
            before = _reached(make)
            trained = _trained(label, make, task, ladder.name)
            _check_one_table(label, trained, table_size(task), ladder.name)
            if before != _reached(make):
                raise ValueError(
                    f"rule 1, one table: {label} may keep things in its own fields only, but while it learned in"
                    f" {ladder.name} something else changed: a global variable, an attribute of the class, or the"
                    " default of a parameter"
                )
        for ladder in ladders:
            for strength in ladder.strengths:
                _check_disguise(label, make, ladder, strength)


def _trained(label: str, make: Any, task: Any, where: str) -> Any:
    """A new agent after some steps; the seed is always the same."""
    with student_code(f"training {label} in {where}"):
        return train(task, make(task), TRIED, evaluate_every=TRIED).agent


def _reached(make: Any) -> str | None:
    """A hash of all that an agent's code can reach outside of the agent; None where that cannot be told."""
    try:
        return fingerprint(make)
    except Exception:  # each class has its own for what cannot be taken apart
        return None


def _check_disguise(label: str, make: Any, ladder: Ladder, strength: float) -> None:
    """Refuse an agent that does something else where the same task has other numbers for its states, and more of them.

    With the same random numbers, an agent that takes a state as the number of a row learns the same values, each in
    another row.
    """
    task = ladder.make(strength, layout_seed=0)
    disguised = Renumbered.create(task)
    plain, other = (_trained(label, make, one, ladder.name) for one in (task, disguised))
    sizes = len(disguised.rows), int(disguised.observation_space.n)
    for (name, values), (_, found) in zip(tables_in(plain), tables_in(other), strict=True):
        is_table = (len(np.atleast_1d(values)), len(np.atleast_1d(found))) == sizes
        if is_table and not np.array_equal(values, found[disguised.rows], equal_nan=True):
            raise ValueError(
                f"rule 2, nothing tuned: {label} must do the same whatever the numbers of its states are, and however"
                f" many there are, but in {ladder.name} ({ladder.strength} {strength:g}) its {name} has other values"
                f" after {TRIED:,} steps where the states are numbered otherwise, and some never occur"
            )


def _check_one_table(label: str, agent: Any, shape: tuple[int, int], where: str) -> None:
    """Refuse an agent that keeps more numbers than one table has."""
    entries = math.prod(shape)
    kept = {name: numbers_in(part, shape) for name, part in parts_of(agent)}
    for name, part in outside(agent):
        kept[name] = kept.get(name, 0) + numbers_in(part, shape)
    if sum(kept.values()) > entries + ROOM:
        largest = sorted(kept, key=lambda name: -kept[name])[:3]
        listed = ", ".join(f"{name} {kept[name]:,}" for name in largest)
        raise ValueError(
            f"rule 1, one table: {label} may keep {entries:,} numbers in {where}, one for each state and action, and"
            f" {ROOM} beside them, but after {TRIED:,} steps it keeps {sum(kept.values()):,} ({listed})"
        )


def _check_settings(label: str, make: Any, ladders: Sequence[Ladder]) -> None:
    """Refuse an agent whose settings depend on the task."""
    first: dict[str, tuple[Any, str]] = {}
    for ladder in ladders:
        for strength in ladder.strengths:
            task = ladder.make(strength, layout_seed=0)
            sizes = table_size(task)
            with student_code(f"making {label} for {ladder.name}"):
                agent = make(task)
            for name, value in settings_in(agent):
                if any(value == size for size in (*sizes, math.prod(sizes))):
                    continue
                before, where = first.setdefault(name, (value, ladder.name))
                if value != before:
                    raise ValueError(
                        f"rule 2, nothing tuned: the settings of {label} must be the same in every task, but {name} is"
                        f" {before!r} in {where} and {value!r} in {ladder.name}"
                    )


def parts_of(value: Any) -> Iterator[tuple[str, Any]]:
    """The parts of something that an agent keeps, with their names; none of a number, an array or a function."""
    if isinstance(value, Mapping):
        yield from ((str(key), part) for key, part in value.items())
    elif hasattr(value, "_asdict"):
        yield from value._asdict().items()
    elif not isinstance(value, str | bytes | np.ndarray) and isinstance(value, Sequence | set | frozenset):
        yield from ((str(place), part) for place, part in enumerate(value))
    elif not isinstance(value, type) and not callable(value):
        slots = [name for kind in type(value).__mro__ for name in getattr(kind, "__slots__", ())]
        yield from getattr(value, "__dict__", {}).items()
        kept = [name for name in slots if not name.startswith("__") and hasattr(value, name)]
        yield from ((name, getattr(value, name)) for name in kept)


def numbers_in(value: Any, shape: tuple[int, int] | None = None) -> int:
    """How many numbers are kept in something; a text, and a whole number of many digits, is as many as it fills.

    The keys of a dictionary count too, but not those that are the place of a number in a table of `shape`: a state, an
    action, or a pair of both.
    """
    if isinstance(value, np.ndarray):
        return int(value.size)
    if isinstance(value, int) and not isinstance(value, bool):
        return max(1, -(-value.bit_length() // BITS))
    if isinstance(value, str | bytes):
        return max(1, -(-len(value) * 8 // BITS))
    if value is None or isinstance(value, bool | float | complex | np.generic):
        return 1
    keys = value.keys() if isinstance(value, Mapping) else ()
    addresses = sum(numbers_in(key, shape) for key in keys if not _is_place(key, shape))
    return addresses + sum(numbers_in(part, shape) for _, part in parts_of(value))


def _is_place(key: Any, shape: tuple[int, int] | None) -> bool:
    """Whether a key says where in a table a number stands, or is the name of a field."""
    if isinstance(key, str):
        return len(key) <= BITS
    if shape is None:
        return False
    if isinstance(key, int | np.integer):
        return 0 <= int(key) < max(shape)
    return (
        isinstance(key, tuple)
        and len(key) == len(shape)
        and all(isinstance(part, int | np.integer) and 0 <= part < size for part, size in zip(key, shape, strict=True))
    )


def outside(agent: Any) -> Iterator[tuple[str, Any]]:
    """What an agent's code keeps outside of the agent, with names: in its classes, functions and global variables.

    What belongs to a library is none of it, so agents of the package keep nothing there.
    """
    seen: set[int] = set()
    todo: list[Any] = [*type(agent).__mro__]
    for thing in todo:  # grows on the way
        if id(thing) in seen or is_library(thing):
            continue
        seen.add(id(thing))
        for name, part in _names_in(thing):
            inner = getattr(part, "__func__", getattr(part, "fget", part))  # of methods of a class, and properties
            if isinstance(inner, type | FunctionType):
                todo.append(inner)
            elif id(part) not in seen and (isinstance(part, KEPT) or not is_library(type(part))):
                seen.add(id(part))
                yield name, part


def _names_in(thing: Any) -> Iterator[tuple[str, Any]]:
    """What a class or a function has by name, and what a function remembers and can reach."""
    named = {**vars(thing)}
    if isinstance(thing, FunctionType):
        named |= {f"default {k}": part for k, part in enumerate(thing.__defaults__ or ())}
        named |= thing.__kwdefaults__ or {}
        named |= {f"cell {k}": cell.cell_contents for k, cell in enumerate(thing.__closure__ or ())}
        named |= thing.__globals__
    for name, part in named.items():
        if not (name.startswith("__") and name.endswith("__")) and name != "_fields":
            yield name, part


def tables_in(value: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    """The arrays in an agent, with the way to each."""
    if isinstance(value, np.ndarray):
        yield name, value
    else:
        for part, inside in parts_of(value):
            yield from tables_in(inside, f"{name}.{part}" if name else part)


def settings_in(value: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    """The numbers and texts in a new agent, with the way to each; of an array, the value with which it is filled."""
    if isinstance(value, np.ndarray):
        if value.size and (value == value.flat[0]).all():
            yield f"the first value of {name}", value.flat[0].item()
    elif isinstance(value, bool | int | float | str | np.generic):
        yield name, value
    else:
        for part, inside in parts_of(value):
            yield from settings_in(inside, f"{name}.{part}" if name else part)
