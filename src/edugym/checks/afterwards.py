"""What is probably wrong with a student's task or agent after training, though no step has failed: for warnings."""

import dis
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.checks.contract import Contract, recorded, tables_of
from edugym.checks.interfaces import class_name
from edugym.checks.mdps import innermost
from edugym.checks.values import kept, same
from edugym.system.packages import is_own

ENDLESS = 1_000
"""From so many training steps on there is a warning if no episode has ended, or if the agent has learned nothing."""


class BeforeTraining(NamedTuple):
    """What is kept of a student's agent before training, to compare it with afterwards.

    Attributes:
        shared: copies of the mutable values that it shares with its class: see `shared_by_class`.
        blank: the number that each blank table holds: see `blank_tables`.
    """

    shared: dict[str, Any]
    blank: dict[str, float]


def before_training(contract: Contract) -> BeforeTraining | None:
    """What is kept of an agent before training; nothing of the package's own."""
    agent = recorded(contract.agent)
    return None if contract.is_own else BeforeTraining(shared_by_class(agent), blank_tables(agent))


def warnings_after(task: Any, agent: Any, limit: int | None, run: Any, before: BeforeTraining | None) -> list[str]:
    """What is probably wrong with a student's task or agent after training, in a sentence each.

    Args:
        task: the MDP or environment.
        agent: the agent.
        limit: the step limit of its episodes, if there is one.
        run: what training has produced: a `Run`.
        before: what `before_training` kept of the agent.
    """
    agent, found = recorded(agent), [] if limit else _endless(task, run)
    if before is not None:
        found += _not_a_number(agent) + _changed_for_all(agent, before.shared) + _nothing_learned(agent, before, run)
    return found


def _endless(task: Any, run: Any) -> list[str]:
    """A sentence about a student's task, if no episode has ended."""
    is_env = isinstance(task, gymnasium.Env)
    student = task.unwrapped if is_env else innermost(task)
    if is_own(student) or run.episodes.sum() or run.steps[-1] < ENDLESS:
        return []
    method = "step never returned terminated" if is_env else "terminal never returned"
    return [
        f"no episode of {class_name(student)} has ended in {run.steps[-1]} steps: {method} True, and there is no limit"
        " (max_steps)"
    ]


def _not_a_number(agent: Any) -> list[str]:
    """A sentence about each table that holds NaN."""
    return [
        f"{name} of {class_name(agent)} holds nan after training: some update came to no number"
        for name, table in tables_of(agent).items()
        if table.dtype.kind == "f" and np.isnan(table).any()
    ]


def shared_by_class(agent: Any) -> dict[str, Any]:
    """Copies of the lists, dictionaries, sets and arrays that an agent has from its class, by name.

    Those are attributes of the class, and defaults of its fields, or of its `__init__`, that this agent has.
    """
    own, kind = _own_values(agent), type(agent)
    members = {name: member for base in reversed(kind.__mro__) for name, member in vars(base).items()}
    makers: list[Any] = [getattr(kind, name) for name in ("__init__", "__new__")]
    defaults = {id(value) for maker in makers for value in getattr(maker, "__defaults__", None) or ()}
    shared = {name: member for name, member in members.items() if name not in own}
    shared |= {name: value for name, value in own.items() if id(value) in defaults}
    return {
        name: kept(member)
        for name, member in shared.items()
        if isinstance(member, list | dict | set | np.ndarray) and name[0] != "_"
    }


def _own_values(agent: Any) -> dict[str, Any]:
    """What an agent has of its own: its fields, or the attributes of an ordinary object."""
    return agent._asdict() if hasattr(agent, "_asdict") else getattr(agent, "__dict__", {})


def _changed_for_all(agent: Any, before: dict[str, Any]) -> list[str]:
    """A sentence about each value of the class that training has changed."""
    kind, own = class_name(agent), _own_values(agent)
    return [
        f"{name} of {kind} has changed, which is not the agent's own: all agents of the class share it, so that the"
        " next one begins with it. Give each its own: "
        + (f"pass it, {kind}(...), without a default" if name in own else f"self.{name} = ... in __init__, or a field")
        for name, value in before.items()
        if not same(value, getattr(agent, name, None))
    ]


def blank_tables(agent: Any) -> dict[str, float]:
    """The tables of an agent that hold one number everywhere, by name, with the number.

    An agent whose `learn` computes nothing, or assigns to an element of an array, is left out: it either intends no
    change or already assigns in place.
    """
    code = getattr(getattr(agent, "learn", None), "__code__", None)
    does = {instruction.opname for instruction in dis.get_instructions(code)} if code else set()
    if "BINARY_OP" not in does or "STORE_SUBSCR" in does:
        return {}
    tables = {name: table for name, table in tables_of(agent).items() if table.size > 1}
    return {name: table.flat[0] for name, table in tables.items() if (table == table.flat[0]).all()}


def _nothing_learned(agent: Any, before: BeforeTraining, run: Any) -> list[str]:
    """A sentence about the agent, if all its tables are as blank as before although rewards came."""
    blank, rewarded = before.blank, np.nansum(np.abs(run.training_returns)) > 0 and run.steps[-1] >= ENDLESS
    if not (blank and rewarded and len(blank) == len(tables_of(agent)) and blank_tables(agent) == blank):
        return []
    return [
        f"learn of {class_name(agent)} has changed nothing in {' and '.join(blank)} in {run.steps[-1]} steps, although"
        f" rewards came: assign to the table itself, as in self.{next(iter(blank))}[...] += ...; what learn returns is"
        " ignored"
    ]
