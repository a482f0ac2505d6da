"""The problem with which the cell of exercise 4 begins, and whether another one is the same under another name."""

import dis
from typing import Any

from edugym.mdp.protocol import Random


class Bicycle:
    """What happens in the problem with which the cell of exercise 4 begins, and what it pays."""

    def transition(self, state: Any, action: int, rng: Random) -> Any:
        """Sold, which is an offer of 0; or a day later with a new offer."""
        day, _ = state
        return (day, 0) if action == 1 else (day + 1, 1 + int(rng.random() * 3))

    def reward(self, state: Any, action: int, next_state: Any, rng: Random) -> float:
        """The offer that was taken."""
        return float(state[1]) if action == 1 else 0.0


def is_like(kind: type, known: type) -> bool:
    """Whether a class has the dynamics and the reward of a known one, but for names and numbers."""
    return all(_steps_of(kind, name) == _steps_of(known, name) for name in ("transition", "reward"))


def _steps_of(kind: type, name: str) -> list[str]:
    """Return what the code of a method does, step by step, without the names of its variables and its numbers."""
    code = getattr(getattr(kind, name, None), "__code__", None)
    return [] if code is None else [step.opname for step in dis.get_instructions(code)]
