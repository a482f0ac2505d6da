"""Observations written into an array, whatever form the task gives them."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym import make_mdp
from edugym.envs.catch import CatchGrid
from edugym.mdp.in_place import SeveralNumbers, WholeArray, blank, in_place
from edugym.mdp.protocol import writes_in_place
from tests.mdp.watch import Shows
from tests.training.slips import named

TASKS: list[tuple[Any, Any]] = [
    (make_mdp("Boulder"), np.int64),
    (make_mdp("Golf"), np.int64),
    (make_mdp("Trashbot"), np.float64),
    (make_mdp("Catch"), np.float64),
    (make_mdp("Catch", observation_type="rgb"), np.int64),
]


@pytest.mark.parametrize(("mdp", "kind"), TASKS, ids=lambda part: getattr(part, "__name__", type(part).__name__))
def test_what_is_written_is_what_is_observed(mdp: Any, kind: Any) -> None:
    """In the right shape and kind of numbers, over what was there before; a task that writes is left as it is."""
    task, rng = in_place(mdp), np.random.default_rng(0)
    assert (task is mdp) == hasattr(mdp, "observe_into")
    out = blank(task)
    assert out.dtype == kind
    state = mdp.initial(rng)
    for _ in range(3):
        out[...] = 77
        task.observe_into(state, rng, out)
        assert np.array_equal(np.ravel(out), np.ravel(mdp.observation(state, rng)))
        state = mdp.transition(state, mdp.action_space.sample(), rng)


@pytest.mark.parametrize("seen", [-0.75, (-0.75,), np.array([-0.75]), (0.25, -0.5), np.array([[0.25], [-0.5]])])
def test_real_numbers_stay_what_they_are(seen: Any) -> None:
    """One alone, several, or an array."""
    task = in_place(Shows(spaces.Box(-1.0, 1.0, np.shape(seen) or (1,), np.float64), seen))
    out = blank(task)
    task.observe_into(0, None, out)
    assert out.dtype == np.float64
    assert np.array_equal(out, np.reshape(seen, out.shape))
    if np.ndim(seen):  # machine code copies an array at once, and a tuple number by number
        assert type(task) is (WholeArray if isinstance(seen, np.ndarray) else SeveralNumbers)


@pytest.mark.parametrize(("seen", "shape"), [((0.25, -0.5), (1,)), (0.25, (2,)), (np.zeros((1, 2)), (2,))])
def test_what_is_not_as_the_space_says(seen: Any, shape: tuple[int, ...]) -> None:
    """One number where several are said, or the other way round."""
    space = spaces.Box(-1.0, 1.0, shape, np.float64)
    named(f"mdp {seen!r} {space}", lambda: in_place(Shows(space, seen)))


def test_a_tuple_space_is_one_row() -> None:
    """As in `Tabular`."""
    task = in_place(Shows(spaces.Tuple((spaces.Discrete(3, start=1), spaces.Discrete(2))), (2, 0)))
    out = blank(task)
    task.observe_into(0, None, out)
    assert out.tolist() == [2]


class Darker(CatchGrid):
    """Overrides `observation` alone, so the inherited `observe_into` would show something else."""

    __slots__ = ()

    def observation(self, state: Any, rng: Any) -> Any:
        """Half as bright."""
        return super().observation(state, rng) / 2


def test_a_subclass_that_overrides_observation_alone() -> None:
    """What it observes is written, not what its parent does."""
    darker: Any = Darker(4, 3)
    assert writes_in_place(CatchGrid(4, 3))
    assert not writes_in_place(darker)
    task, out = in_place(darker), np.zeros((4, 3))
    task.observe_into(darker.initial(np.random.default_rng(0)), None, out)
    assert out.max() == 0.5
