"""What a student's answer must be before it is tried: a function, a class, an agent with its methods and fields."""

import inspect
from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym.checks.contract import learns_from
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given

DEFAULTS: Mapping[str, Any] = MappingProxyType({})
"""No settings: `create` takes its own."""


def require_class(name: str, answer: Any) -> None:
    """Refuse what is no class.

    Raises:
        WrongAnswer: it is something else, such as an instance.
    """
    given(name, answer)
    if not isinstance(answer, type):
        kind = type(answer).__name__
        what = f"what {name}(...) makes: leave the brackets out" if kind == name else f"of the type {kind}"
        raise WrongAnswer(f"{name} should be the class itself, but is {what}")


def require_function(name: str, answer: Any, of: str) -> None:
    """Refuse what is no function.

    Args:
        name: the name of the answer.
        answer: the student's value.
        of: what the function takes, for the sentence: "the model".

    Raises:
        WrongAnswer: it is something else, such as a class or what the function returned.
    """
    given(name, answer)
    if isinstance(answer, type) or not callable(answer):
        kind = f"the class {answer.__name__}" if isinstance(answer, type) else f"of the type {type(answer).__name__}"
        raise WrongAnswer(f"{name} should be a function of {of}, but is {kind}")


def agent_made_by(call: str, make: Callable[[Any], Any], task: Any) -> Any:
    """Make a student's agent.

    Args:
        call: the call, for the sentence: "optimist(wall)".
        make: makes the agent.
        task: what it is made for.

    Raises:
        WrongAnswer: the call fails, or what it gives is no agent.
    """
    with student_code(call):
        made = make(task)
    given(call, made)
    if isinstance(made, type):
        raise WrongAnswer(
            f"{call} should give an agent, but gives the class {made.__name__}: write {made.__name__}.create"
        )
    missing = [name for name in ("act", "learn") if not hasattr(made, name)]
    if missing:
        uncalled = ": call it, with the environment in brackets" if callable(made) else ""
        raise WrongAnswer(
            f"{call} should give an agent, but what it gives, of the type {type(made).__name__}, has no"
            f" `{missing[0]}`{uncalled}"
        )
    return made


def agent_created_by(name: str, answer: Any, what: str, task: Any, settings: Mapping[str, Any] = DEFAULTS) -> Any:
    """Make an agent by the `create` of a student's class.

    Args:
        name: the name of the class.
        answer: the class.
        what: the task, for the sentence: "wall".
        task: what the agent is made for.
        settings: what else `create` is given, by name.

    Raises:
        WrongAnswer: there is no `create`, it fails, or what it gives is no agent.
    """
    if not hasattr(answer, "create"):
        raise WrongAnswer(f"{name} should keep its method `create`, which makes a new agent for a {what}")
    call = ", ".join([what, *(f"{setting}={value}" for setting, value in settings.items())])
    return agent_made_by(f"{name}.create({call})", partial(answer.create, **settings), task)


def with_settings(name: str, agent: Any, settings: Mapping[str, float], method: str) -> Any:
    """Give a student's agent other settings than its own.

    Args:
        name: the name of its class.
        agent: the agent.
        settings: the numbers, by field.
        method: what reads them, for the sentence: "learn".

    Raises:
        WrongAnswer: it has no such field.
    """
    _require_fields(name, [setting for setting in settings if not hasattr(agent, setting)], method)
    if hasattr(agent, "_replace"):
        return agent._replace(**settings)
    for setting, value in settings.items():
        setattr(agent, setting, value)
    return agent


def agent_with_table(
    name: str, answer: Any, shape: tuple[int, ...], settings: Mapping[str, float], table: str = "Q"
) -> Any:
    """Make a student's agent from its class, with a table of zeros.

    Args:
        name: the name of the class.
        answer: the class.
        shape: the shape of the table.
        settings: its other fields.
        table: the field of the table.

    Raises:
        WrongAnswer: a field is missing, making it fails, or it does not learn.
    """
    missing = [field for field in (table, *settings) if not _takes(answer, field)]
    if table in missing:
        raise WrongAnswer(f"{name} should keep its field `{table}`, the table that `learn` changes")
    _require_fields(name, missing, "learn")
    with student_code(f"{name}({table}, ...)"):
        made = answer(**{table: np.zeros(shape)}, **settings)
    if not hasattr(made, "learn"):
        raise WrongAnswer(f"{name} should have a method `learn`")
    return made


def _takes(kind: Any, field: str) -> bool:
    """Whether a value of a class can be made with this field, by its name."""
    parameters = inspect.signature(kind).parameters
    return field in parameters or any(one.kind is one.VAR_KEYWORD for one in parameters.values())


def _require_fields(name: str, missing: list[str], method: str) -> None:
    if missing:
        raise WrongAnswer(f"{name} should keep its field `{missing[0]}`, from which `{method}` reads the number")


def learn_step(agent: Any, step: Mapping[str, Any]) -> str:
    """Let a student's agent learn from a step, with whatever its `learn` asks for.

    Args:
        agent: the agent.
        step: all that `learn` may ask for, by name.

    Returns:
        The call, for a sentence.

    Raises:
        WrongAnswer: `learn` asks for something else, or fails.
    """
    try:
        names = learns_from(agent)
    except ValueError as error:
        raise WrongAnswer(str(error)) from None
    told = {name: f"{step[name]:g}" if isinstance(step[name], float) else step[name] for name in names}
    call = "learn(" + ", ".join(f"{name}={value}" for name, value in told.items()) + ")"
    with student_code(call):
        agent.learn(**{name: step[name] for name in names})
    return call


def table_of(agent: Any, name: str, shape: tuple[int, ...] | None, kind: str = "f") -> Any:
    """Return a table of a student's agent.

    Args:
        agent: the agent.
        name: the field.
        shape: the shape that it should have; None is any.
        kind: "f" for real numbers, "i" for whole ones, which may also be stored as real ones.

    Raises:
        WrongAnswer: it is missing, or is no such array.
    """
    table = getattr(agent, name, None)
    if table is None:
        raise WrongAnswer(f"the agent should have a table `{name}`, but {type(agent).__name__} has none")
    if not isinstance(table, np.ndarray):
        raise WrongAnswer(f"the table `{name}` should be a NumPy array, but is a {type(table).__name__}")
    if shape is not None and table.shape != shape:
        raise WrongAnswer(f"the table `{name}` should have the shape {shape}, but has {table.shape}")
    if table.dtype.kind != "f" and kind == "f":
        raise WrongAnswer(
            f"the table `{name}` holds {table.dtype} numbers, so every update loses what is behind the decimal point:"
            " make it with np.zeros(shape) or np.full(shape, 1.0)"
        )
    return table
