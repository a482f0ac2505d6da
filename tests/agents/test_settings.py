"""The settings of a class are looked up once, and again when its annotations have changed."""

from typing import Annotated, Any, NamedTuple

import numpy as np
import pytest

from edugym import UCB, NStepSARSA, PrioritisedSweeping, QLearning
from edugym.agents.settings import Range, check, new, settings_of
from edugym.envs.boulder import Boulder


class Limited(NamedTuple):
    """A value with one setting."""

    rate: Annotated[float, Range(0, 1)] = 0.5


def test_a_changed_annotation_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Values are checked against what is written in the class now, and not against what was."""
    check(Limited(0.5))
    with pytest.raises(ValueError, match="rate"):
        check(Limited(5.0))
    monkeypatch.setitem(Limited.__annotations__, "rate", Annotated[float, Range(0, 10)])
    check(Limited(5.0))
    monkeypatch.undo()
    with pytest.raises(ValueError, match="rate"):
        check(Limited(5.0))


def test_a_name_that_comes_to_mean_something_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """An annotation that is a text is read with the names that are there now, also beside one that is no text."""
    names: dict[str, Any] = {"NamedTuple": NamedTuple, "__name__": __name__}
    exec("class Late(NamedTuple):\n    rate: 'Rate' = 0.5\n    bonus: float = 0.0", names)
    late = names["Late"]
    check(late(5.0))
    monkeypatch.setitem(globals(), "Rate", Annotated[float, Range(0, 1)])
    with pytest.raises(ValueError, match="rate"):
        check(late(5.0))
    monkeypatch.setitem(globals(), "Rate", Annotated[float, Range(0, 10)])
    check(late(5.0))


def test_what_is_given_out_may_be_changed() -> None:
    """A caller who changes what it got changes nothing for the next one."""
    settings_of(Limited).clear()
    assert settings_of(Limited) == {"rate": 0.5}
    assert new(Limited, None, {"rate": 1}) == Limited(1.0)


@pytest.mark.parametrize(
    ("environment", "message"),
    [
        (None, "environment must be an MDP, a Gymnasium environment or a shape, but is None"),
        (Boulder, r"environment must be a value, but is the class Boulder: make one with Boulder.create\(...\)"),
        ((4, 0), r"two whole numbers of 1 or more, but is \(4, 0\)"),
        ((4, 2, 3), r"two whole numbers of 1 or more, but is \(4, 2, 3\)"),
    ],
)
def test_what_is_no_environment_is_refused(environment: Any, message: str) -> None:
    """Whatever agent is made for it, and the strategy too."""
    makers: tuple[Any, ...] = (QLearning.create, NStepSARSA.create, PrioritisedSweeping.create, UCB.create)
    for make in makers:
        with pytest.raises(ValueError, match=message):
            make(environment)


def test_a_shape_may_come_from_spaces() -> None:
    """`space.n` is a whole number of NumPy's."""
    assert QLearning.create((np.int64(3), np.int64(2))).Q.shape == (3, 2)


def test_an_unknown_setting_is_answered_with_all_that_there_are() -> None:
    """Those that `create` itself takes are among them."""
    known = "planning_steps, planning_seconds, model, memory, learning_rate"
    with pytest.raises(ValueError, match=f"PrioritisedSweeping has no setting 'planing_steps'; it has {known}"):
        PrioritisedSweeping.create((2, 2), planing_steps=3)


class Half(NamedTuple):
    """A strategy that holds another one."""

    inner: UCB

    def choose(self, Q: Any, state: int, rng: Any) -> int:
        """Do as the other one does."""
        return self.inner.choose(Q, state, rng)


def test_tables_of_a_strategy_within_a_strategy() -> None:
    """They must be those of the agent's environment too."""
    assert QLearning.create((3, 2), exploration=Half(UCB.create((3, 2)))).Q.shape == (3, 2)
    with pytest.raises(ValueError, match="UCB was made for 4 states, but the agent has 3: give each environment its"):
        QLearning.create((3, 2), exploration=Half(UCB.create((4, 2))))


class OfAKind(NamedTuple):
    """Holds a class."""

    kind: Any = UCB


def test_a_class_in_a_field_has_no_tables() -> None:
    """It is no strategy that was made for an environment."""
    assert new(OfAKind, (3, 2), {}) == OfAKind(UCB)
