"""What all tabular agents ask of their parameters."""

from typing import Any

from edugym.checks import above, between


def check_learning(learning_rate: float, discount: float) -> None:
    """Refuse a learning rate that is not above 0 and up to 1, and a discount that is not from 0 to 1.

    Raises:
        ValueError: one of them is not.
    """
    above("learning_rate", learning_rate, 0, 1)
    between("discount", discount, 0, 1)


def check_exploration(exploration: Any) -> None:
    """Refuse what is no exploration strategy, and one whose settings are not as its class says (its method `check`).

    Raises:
        ValueError: it is so.
    """
    if not hasattr(exploration, "choose"):
        raise ValueError(f"exploration must be a strategy with a method choose, but is {exploration!r}")
    if hasattr(exploration, "check"):
        exploration.check()
