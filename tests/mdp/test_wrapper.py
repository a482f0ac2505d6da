"""Wrappers of MDPs: they say what they change, and pass on the rest."""

from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym import (
    Brightness,
    DiscreteActions,
    Discretised,
    FrameStack,
    Hashed,
    MDPEnv,
    MDPVectorEnv,
    NoisyObservation,
    QLearning,
    finite_model,
    make_mdp,
    train,
    value_iteration,
    wrapper,
)
from edugym.adapters.fitting import tabular
from edugym.checks.interfaces import require_mdp, step_limit
from edugym.mdp.protocol import named_actions
from edugym.rendering.ansi import to_text


@wrapper
class Costly(NamedTuple):
    """Every step costs something."""

    mdp: Any
    cost: float

    def reward(self, state: Any, action: int, next_state: Any, rng: Any) -> float:
        """Less than before."""
        reward: float = self.mdp.reward(state, action, next_state, rng)
        return reward - self.cost


class Twice(NamedTuple):
    """A state with the number of steps."""

    inner: Any
    steps: int


@wrapper
class Counting(NamedTuple):
    """Shows the number of steps as well: a wrapper with states of its own."""

    mdp: Any

    def initial(self, rng: Any) -> Twice:
        """No step."""
        return Twice(self.mdp.initial(rng), 0)

    def transition(self, state: Twice, action: int, rng: Any) -> Twice:
        """One more."""
        return Twice(self.mdp.transition(state.inner, action, rng), state.steps + 1)

    def reward(self, state: Twice, action: int, next_state: Twice, rng: Any) -> float:
        """As before."""
        reward: float = self.mdp.reward(state.inner, action, next_state.inner, rng)
        return reward

    def terminal(self, state: Twice) -> bool:
        """As before."""
        terminal: bool = self.mdp.terminal(state.inner)
        return terminal

    def inside(self, state: Twice) -> Any:
        """The state of the inner MDP."""
        return state.inner

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """A position, and steps up to a hundred."""
        return spaces.MultiDiscrete([self.mdp.observation_space.n, 101])

    def observation(self, state: Twice, rng: Any) -> Any:
        """Both."""
        return self.mdp.observation(state.inner, rng), state.steps


WALL = make_mdp("Boulder", height=3)


def test_what_a_wrapper_does_not_change() -> None:
    """Dynamics, spaces, limit, names, picture and info are the inner task's, through two layers as well."""
    once: Any = Costly(WALL, 0.5)
    twice: Any = Costly(once, 0.25)
    for task, state in ((once, 1), (twice, 1)):
        assert task.transition(state, WALL.grips[1], np.random.default_rng(0)) == 2
        assert (task.observation_space, task.action_space) == (WALL.observation_space, WALL.action_space)
        assert step_limit(task) == 30
        assert list(named_actions(task)) == ["grip 0", "grip 1"]
        assert task.info(state) == WALL.info(state)
        assert to_text(task.scene(state)) == to_text(WALL.scene(state))
        assert task.terminal(3)
    assert Costly(WALL, 0.5).reward(2, 0, 3, None) == 0.5
    assert twice.reward(2, 0, 3, None) == 0.25
    assert not hasattr(once, "observe_into")
    assert not hasattr(once, "grip")
    assert once.grips is WALL.grips


def test_what_a_wrapper_does_not_pass_on() -> None:
    """What is private, and the method that would write the inner observation in place of the wrapper's."""
    inner = SimpleNamespace(_private=1, public=2, observe_into=print)
    wrapped: Any = Costly(inner, 0.5)
    assert wrapped.public == 2
    for name in ("_private", "observe_into"):
        with pytest.raises(AttributeError, match=f"^Costly has no attribute '{name}'$"):
            getattr(wrapped, name)


def test_a_wrapper_with_states_of_its_own_keeps_picture_and_info() -> None:
    """The inner task is asked for its own state, in a Gymnasium environment, a vector copy and in another wrapper."""
    counting: Any = Counting(WALL)
    tasks: tuple[Any, ...] = (counting, tabular(counting), Costly(counting, 1.0))
    for task in tasks:
        env = MDPEnv(task, render_mode="ansi")
        env.reset(seed=0)
        _, _, _, _, info = env.step(int(WALL.grips[0]))
        assert info == WALL.info(1)
        assert env.render() == to_text(WALL.scene(1))
        vector = MDPVectorEnv(env, 2)
        vector.reset(seed=0)
        vector.step(np.array([WALL.grips[0], 1 - WALL.grips[0]]))
        assert to_text(vector.showing(0).scene()) == to_text(WALL.scene(1))
        assert to_text(vector.showing(1).scene()) == to_text(WALL.scene(0))


def test_history_reaches_the_inner_picture() -> None:
    """Golf draws where the last hit was aimed, in a wrapper with states of its own as well."""
    golf = make_mdp("Golf")

    @wrapper
    class Boxed(NamedTuple):
        mdp: Any

        def inside(self, state: Any) -> Any:
            return state[0]

    start, after = golf.initial(None), golf.transition(golf.initial(None), 2, np.random.default_rng(0))
    boxed: Any = Boxed(golf)
    picture = boxed.scene((after,), last_state=(start,), last_action=2)
    assert picture == golf.scene(after, last_state=start, last_action=2)
    assert to_text(picture) != to_text(golf.scene(after))


def test_exact_model_and_training() -> None:
    """A wrapped task has its exact model, and runs compiled as it does interpreted."""
    task: Any = Costly(WALL, 0.5)
    assert value_iteration(finite_model(task)).start == pytest.approx(1.0 - 1.5)
    tables = []
    for steps in ((6_000,), (1_500,) * 4):
        agent = QLearning.create(task, learning_rate=0.5)
        for n_steps in steps:
            run = train(task, agent, n_steps, seed=2, evaluate_every=n_steps)
        tables.append(agent.Q)
        assert run.agent.Q.min() < -0.5
    assert all(table.any() for table in tables)


def test_a_wrapper_without_the_decorator() -> None:
    """What it does not define is missing, and the decorator would add it."""

    class Bare(NamedTuple):
        mdp: Any

        def reward(self, state: Any, action: Any, next_state: Any, rng: Any) -> float:
            return 1.0

    with pytest.raises(ValueError, match=r"Bare must have a method initial\(self, rng\), or the decorator @edugym.wr"):
        require_mdp(Bare(make_mdp("Boulder")))


def test_what_a_wrapper_looks_up_itself_is_kept() -> None:
    """The decorator puts nothing in place of methods that the class has, not even of `__getattr__`."""

    class Own(NamedTuple):
        mdp: Any

        def __getattr__(self, name: str) -> Any:
            if name == "__wrapped__":
                raise AttributeError(name)
            return "looked up"

        def terminal(self, state: Any) -> bool:
            return True

    task: Any = wrapper(Own)(make_mdp("Boulder"))
    assert (task.height, task.terminal(0)) == ("looked up", True)


def test_a_wrapper_needs_a_field_mdp() -> None:
    """The message says so."""

    class Wrong(NamedTuple):
        task: Any

    with pytest.raises(TypeError, match="Wrong must be a NamedTuple with a field mdp, the MDP that it wraps"):
        wrapper(Wrong)
    with pytest.raises(TypeError, match="must be a NamedTuple with a field mdp"):
        wrapper(int)


@pytest.mark.parametrize("kind", [FrameStack, Hashed, Discretised, DiscreteActions, NoisyObservation, Brightness])
def test_wrappers_ask_for_an_mdp(kind: Any) -> None:
    """A name, a class or a Gymnasium environment in its place is answered with one sentence."""
    for wrong in ("Catch", type(WALL), MDPEnv(WALL)):
        with pytest.raises(ValueError, match="mdp must be"):
            kind.create(wrong, 3)
