"""Wrappers of MDPs: they say what they change, and pass on the rest."""

from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

import edugym as eg
from edugym import Brightness, Hashed, NoisyObservation, make_mdp, wrapper
from edugym.mdp.protocol import named_actions
from edugym.rendering.ansi import to_text
from tests.compiled.cells import cell
from tests.mdp.watch import watched
from tests.training.slips import named

WRAPPERS = """
from gymnasium import spaces

@wrapper
class Costly(NamedTuple):
    mdp: object
    cost: float
    def reward(self, state, action, next_state, rng):
        return self.mdp.reward(state, action, next_state, rng) - self.cost

class Twice(NamedTuple):
    inner: object
    steps: int

@wrapper
class Counting(NamedTuple):
    mdp: object
    def initial(self, rng): return Twice(self.mdp.initial(rng), 0)
    def transition(self, state, action, rng):
        return Twice(self.mdp.transition(state.inner, action, rng), state.steps + 1)
    def reward(self, state, action, next_state, rng):
        return self.mdp.reward(state.inner, action, next_state.inner, rng)
    def terminal(self, state): return self.mdp.terminal(state.inner)
    def inside(self, state): return state.inner
    def observation(self, state, rng): return self.mdp.observation(state.inner, rng), state.steps
    observation_space = property(lambda self: spaces.MultiDiscrete([self.mdp.observation_space.n, 101]))

@wrapper
class Boxed(NamedTuple):
    mdp: object
    def inside(self, state): return state[0]

class Own(NamedTuple):
    mdp: object
    def __getattr__(self, name):
        if name == "__wrapped__":
            raise AttributeError(name)
        return "looked up"
    def terminal(self, state): return True
"""
"""A step that costs more, a state with the number of steps, a state in a tuple, and one with a `__getattr__`."""
KINDS = SimpleNamespace(**cell(WRAPPERS, {"wrapper": wrapper, "NamedTuple": NamedTuple, "__name__": "__main__"}))
WALL = make_mdp("Boulder", height=3)


def test_what_a_wrapper_does_not_change() -> None:
    """Dynamics, spaces, limit, names, picture and info are the inner task's, through two layers as well."""
    once = KINDS.Costly(WALL, 0.5)
    twice = KINDS.Costly(once, 0.25)
    for task in (once, twice):
        assert task.transition(1, WALL.grips[1], np.random.default_rng(0)) == 2
        assert (task.observation_space, task.action_space) == (WALL.observation_space, WALL.action_space)
        assert task.max_steps == 30
        assert list(named_actions(task)) == ["grip 0", "grip 1"]
        assert task.info(1) == WALL.info(1)
        assert to_text(task.scene(1)) == to_text(WALL.scene(1))
        assert task.terminal(3)
    assert (once.reward(2, 0, 3, None), twice.reward(2, 0, 3, None)) == (0.5, 0.25)
    assert not hasattr(once, "grip")
    assert once.grips is WALL.grips
    assert eg.value_iteration(eg.finite_model(once)).start == pytest.approx(1.0 - 1.5)


def test_what_a_wrapper_does_not_pass_on() -> None:
    """What is private, and the method that would write the inner observation in place of the wrapper's."""
    wrapped = KINDS.Costly(SimpleNamespace(_private=1, public=2, observe_into=print), 0.5)
    assert wrapped.public == 2
    for name in ("_private", "observe_into"):
        named(f"Costly '{name}'", lambda: getattr(wrapped, name), AttributeError)  # noqa: B023


def test_a_wrapper_with_states_of_its_own_keeps_picture_and_info() -> None:
    """The inner task is asked for its own state, in a Gymnasium environment and in another wrapper."""
    counting = KINDS.Counting(WALL)
    tasks: list[Any] = [counting, eg.Tabular.create(counting), KINDS.Costly(counting, 1.0)]
    for task in tasks:
        env = eg.MDPEnv(task, render_mode="ansi")
        env.reset(seed=0)
        _, _, _, _, info = env.step(int(WALL.grips[0]))
        assert info == WALL.info(1)
        assert env.render() == to_text(WALL.scene(1))


def test_history_reaches_the_inner_picture() -> None:
    """Golf draws where the last hit was aimed, in a wrapper with states of its own as well."""
    golf = make_mdp("Golf")
    start, after = golf.initial(None), golf.transition(golf.initial(None), 2, np.random.default_rng(0))
    picture = KINDS.Boxed(golf).scene((after,), last_state=(start,), last_action=2)
    assert picture == golf.scene(after, last_state=start, last_action=2)
    assert to_text(picture) != to_text(golf.scene(after))


def test_what_a_wrapper_looks_up_itself_is_kept() -> None:
    """The decorator puts nothing in place of methods that the class has, not even of `__getattr__`."""
    task = wrapper(KINDS.Own)(WALL)
    assert (task.height, task.terminal(0)) == ("looked up", True)


def test_a_wrapper_needs_its_field_and_its_decorator() -> None:
    """The message says so."""
    bare: Any = cell(WRAPPERS, {"wrapper": lambda kind: kind, "NamedTuple": NamedTuple, "__name__": "__main__"})
    named("Twice mdp", lambda: wrapper(KINDS.Twice), TypeError)
    named("int mdp", lambda: wrapper(int), TypeError)
    named("Costly initial(self, @edugym.wrapper", lambda: eg.check_mdp(bare["Costly"](WALL, 0.5)))


IMAGE, CORRIDOR = make_mdp("Catch", observation_type="rgb"), make_mdp("MemoryCorridor")


def bins(capacity: int) -> Any:
    """Bins for what is seen and what is done."""
    return Hashed.create(eg.Discretised.create(eg.DiscreteActions.create(make_mdp("Trashbot"), 3), 20), capacity)


TASKS: dict[str, Any] = {
    "bins": lambda: bins(3_000),
    "noise": lambda: Hashed.create(Brightness.create(NoisyObservation.create(IMAGE, 4, 20.0), 0.5), 500, overflow=True),
    "frames": lambda: eg.Tabular.create(eg.SeparateFrames.create(CORRIDOR, 7, actions=True)),  # type: ignore[arg-type]
    "long frames": lambda: eg.FrameStack.create(CORRIDOR, 20),
}


@pytest.mark.parametrize(
    "make", [pytest.param(make, id=name, marks=[pytest.mark.slow] * (name == "bins")) for name, make in TASKS.items()]
)
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
