"""What is said of two frequent mistakes, and that nothing is said of errors that only look like them."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym.checks.tracebacks import end_at_students_line


class Agent(NamedTuple):
    """A student's agent."""

    rate: float = 0.5
    Q: Any = np.zeros(2)
    count: Any = np.array(0)

    def assign(self, name: str) -> None:
        """Forget that fields never change."""
        agent: Any = self
        match name:
            case "rate":
                agent.rate = 0.25
            case "Q":
                agent.Q = np.ones(2)
            case "count":
                agent.count = 1

    def read(self) -> Any:
        """Use a field that there is not."""
        agent: Any = self
        return agent.missing


class Plain:
    """A class whose methods have no self, and a property that cannot be set."""

    def late(step) -> None:
        """No self."""

    @property
    def early() -> None:  # type: ignore[misc]
        """No self either."""

    @property
    def fixed(self) -> int:
        """A number."""
        return 1

    def call(self, *arguments: int) -> None:
        """Call what has no self."""
        plain: Any = self
        plain.late(*arguments)

    def look(self) -> Any:
        """Look at what has no self."""
        plain: Any = self
        return plain.early

    def assign(self) -> None:
        """Set what cannot be set."""
        plain: Any = self
        plain.fixed = 2


def said(call: Callable[[], Any]) -> str:
    """What the error of a call says in the end."""
    with pytest.raises((AttributeError, TypeError)) as caught:
        call()
    end_at_students_line(caught.value)
    return str(caught.value)


NEVER = "assign of Agent assigns self.{0}, but the fields of a NamedTuple never change: {1}"


@pytest.mark.parametrize(
    ("name", "remedy"),
    [
        ("rate", "keep what changes in a field that is an array, rate = np.array([...]), and assign self.rate[0]"),
        ("Q", "change the numbers in the array, as in self.Q[:] += 1"),
        ("count", "change the numbers in the array, as in self.count[...] += 1"),
    ],
)
def test_a_field_that_is_assigned(name: str, remedy: str) -> None:
    """The remedy is that for its value."""
    assert said(lambda: Agent().assign(name)) == NEVER.format(name, remedy)


def test_a_method_without_self() -> None:
    """It is shown as it should be written, also where it is a property."""
    with_self = ": the first parameter of a method is self: def late(self, step)"
    assert said(lambda: Plain().call(1)).endswith(f"takes 1 positional argument but 2 were given{with_self}")
    assert said(lambda: Plain().look()).endswith("the first parameter of a method is self: def early(self)")


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (Agent().read, "has no attribute 'missing'"),
        (Plain().assign, "has no setter"),
        (lambda: Plain().call(1, 2), "but 3 were given"),
        (lambda: len(3), "has no len()"),  # type: ignore[arg-type]
    ],
    ids=["a field that is missing", "a property", "two arguments too many", "another mistake"],
)
def test_other_errors_say_what_they_say(call: Callable[[], Any], says: str) -> None:
    """Nothing is added."""
    text = said(call)
    assert says in text
    assert "NamedTuple never" not in text
    assert "is self" not in text
