"""What the contract tests need to know of an agent: its test file may describe it in `CASES`."""

from collections.abc import Callable
from typing import Any, NamedTuple


class Case(NamedTuple):
    """An agent to test.

    Attributes:
        kind: its class.
        create: makes a new one for an environment (or the shape of its table).
        estimates_return: whether its Q(s, a) estimates the discounted return at learning rate and discount 0.5, for
            which there are closed forms.
    """

    kind: type
    create: Callable[[Any], Any]
    estimates_return: bool = False
