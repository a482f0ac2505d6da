"""Wrappers show the same, interpreted and as machine code."""

from typing import Any

import numpy as np
import pytest

from edugym import (
    Brightness,
    DiscreteActions,
    Discretised,
    FrameStack,
    Hashed,
    NoisyObservation,
    SeparateFrames,
    Tabular,
    make_mdp,
)
from tests.mdp.watch import watched

IMAGE, CORRIDOR = make_mdp("Catch", observation_type="rgb"), make_mdp("MemoryCorridor")


def bins(capacity: int) -> Any:
    """Bins for what is seen and what is done."""
    return Hashed.create(Discretised.create(DiscreteActions.create(make_mdp("Trashbot"), 3), 20), capacity)


def frames() -> Any:
    """Separate numbers, which a table puts together again."""
    separate: Any = SeparateFrames.create(CORRIDOR, 7, actions=True)
    return Tabular.create(separate)


TASKS: dict[str, Any] = {
    "bins": lambda: bins(3_000),
    "noise": lambda: Hashed.create(Brightness.create(NoisyObservation.create(IMAGE, 4, 20.0), 0.5), 500, overflow=True),
    "frames": frames,
    "long frames": lambda: FrameStack.create(CORRIDOR, 20),
}


@pytest.mark.parametrize("make", TASKS.values(), ids=TASKS)
def test_machine_code_does_the_same(make: Any) -> None:
    """On random walks: rows, rewards, and the table of a hashed task."""
    one, other = make(), make()
    shown = watched(one)
    assert np.array_equal(watched(other, machine_code=True), shown)
    assert len(np.unique(shown[:, 0])) > 20
    if isinstance(one, Hashed):
        assert all(map(np.array_equal, one.table, other.table))


def test_a_full_table_stops_machine_code() -> None:
    """With the same sentence."""
    with pytest.raises(ValueError, match=r"full.* capacity"):
        watched(bins(3), machine_code=True)
