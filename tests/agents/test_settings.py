"""Settings: how they are looked up, the range of each, and what `create` refuses."""

import importlib
import math
import pkgutil
import re
from collections.abc import Iterator
from typing import Annotated, Any, NamedTuple, get_type_hints

import numpy as np
import pytest

import edugym as eg
from edugym import agents
from edugym.agents.settings import Range, check, new, settings_of
from edugym.envs.boulder import Boulder
from tests.agents.cases import AGENTS


class Limited(NamedTuple):
    """A value with one setting."""

    rate: Annotated[float, Range(0, 1)] = 0.5


def test_a_changed_annotation_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Values are checked against what is written in the class now, and not against what was."""
    check(Limited(0.5))
    with monkeypatch.context() as patch:
        patch.setitem(Limited.__annotations__, "rate", Annotated[float, Range(0, 10)])
        check(Limited(5.0))
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
    makers: tuple[Any, ...] = (eg.QLearning.create, eg.NStepSARSA.create, eg.PrioritisedSweeping.create, eg.UCB.create)
    for make in makers:
        with pytest.raises(ValueError, match=message):
            make(environment)


def test_an_unknown_setting_is_answered_with_all_that_there_are() -> None:
    """Those that `create` itself takes are among them."""
    known = "planning_steps, planning_seconds, model, memory, learning_rate"
    with pytest.raises(ValueError, match=f"PrioritisedSweeping has no setting 'planing_steps'; it has {known}"):
        eg.PrioritisedSweeping.create((2, 2), planing_steps=3)


class Half(NamedTuple):
    """A strategy that holds another one, and a class."""

    inner: eg.UCB
    kind: Any = eg.UCB

    def choose(self, Q: Any, state: int, rng: Any) -> int:
        """Do as the other one does."""
        return self.inner.choose(Q, state, rng)


def test_tables_of_a_strategy_within_a_strategy() -> None:
    """They must be those of the agent's environment too; its shape may come from spaces, whose `n` is NumPy's."""
    shape = np.int64(3), np.int64(2)
    assert eg.QLearning.create(shape, exploration=Half(eg.UCB.create((3, 2)))).Q.shape == (3, 2)
    with pytest.raises(ValueError, match="UCB was made for 4 states, but the agent has 3: give each environment its"):
        eg.QLearning.create((3, 2), exploration=Half(eg.UCB.create((4, 2))))


RANGES = {
    "(0, 1]": ("learning_rate", "value_learning_rate", "rate"),
    "[0, 1]": ("REINFORCE.value_learning_rate", "discount", "trace_decay", "epsilon", "start", "end"),
    "(0, inf]": ("error_clip", "temperature"),
    "(0, inf)": ("spread", "clip"),
    "[0, inf)": ("bonus", "exploration_bonus", "threshold", "c", "constant", "entropy_bonus"),
    "[1, inf]": ("NStepSARSA.n",),
    "[1, inf)": (
        "TreeBackup.n", "learn_every", "learn_from", "copy_every", "known_after", "explore_steps", "steps",
        "num_envs", "length", "epochs", "minibatches", "hidden",
    ),
    "[-1e+300, 1e+300]": ("risk", "highest_return", "lowest_return"),
}  # fmt: skip
"""By their ends: the settings of these names, or of one class."""
EXPECTED = {name: ends for ends, names in RANGES.items() for name in names}


def ranges() -> Iterator[tuple[type, str, Range]]:
    """Every range in the annotations of agents and strategies, with the class and the field."""
    modules = [module.name for module in pkgutil.iter_modules(agents.__path__, "edugym.agents.")]
    for module in (*modules, "edugym.deep.ppo"):
        if module == "edugym.deep.ppo":
            pytest.importorskip("torch")
        for thing in vars(importlib.import_module(module)).values():
            if isinstance(thing, type) and hasattr(thing, "_fields") and thing.__module__ == module:
                for field, hint in get_type_hints(thing, include_extras=True).items():
                    marks: tuple[Any, ...] = getattr(hint, "__metadata__", ())
                    yield from ((thing, field, mark) for mark in marks if isinstance(mark, Range))


def allows(mark: Range, value: float) -> bool:
    """Whether a value is in a range."""
    try:
        mark.check("x", value)
    except ValueError:
        return False
    return True


def test_the_ends_of_every_range() -> None:
    """A rate of 0 learns nothing, a clip of 0 has no gradient, and a discount of 0 is legitimate."""
    wrong, found = [], set()
    for kind, field, mark in ranges():
        name = f"{kind.__name__}.{field}" if f"{kind.__name__}.{field}" in EXPECTED else field
        if name not in EXPECTED:
            continue  # of a new agent, whose own test says what it allows
        ends = EXPECTED[name]
        low, high = map(float, ends[1:-1].split(","))
        found.add(name)
        inside = {low: ends[0] == "[", high: ends[-1] == "]", np.nextafter(low, -math.inf): False, math.nan: False}
        inside |= {np.nextafter(low, math.inf): True, min(high, 1e300): ends[-1] == "]" or high == math.inf}
        inside |= {} if high == math.inf else {np.nextafter(high, math.inf): False}
        wrong += [f"{name}: {value}" for value, allowed in inside.items() if allows(mark, value) != allowed]
    assert wrong == []
    assert found == set(EXPECTED)


@pytest.mark.parametrize("kind", sorted({case.kind for case in AGENTS.values()}, key=str))
def test_settings_out_of_range_are_refused(kind: Any) -> None:
    """Every field with a range; the message names it and its value."""
    for _, field, _ in (found for found in ranges() if found[0] is kind):
        for value in (-math.inf, math.nan, "0.1", None, True):
            with pytest.raises(ValueError, match=rf"{field} must be .*, but is {re.escape(repr(value))}"):
                kind.create((4, 2), **{field: value})


OWN: list[tuple[Any, dict[str, tuple[Any, ...]]]] = [
    (eg.DQN, {"hidden": (0, 2.5, "8"), "memory_size": (0, 2.5), "batch_size": (0, 2.5)}),
    (eg.DynaQ, {"planning_steps": (math.inf, -1, 2.5), "planning_seconds": (0,)}),
    (eg.DynaQ, {"memory": (0,), "expected_updates": (1,)}),
    (eg.GoExplore, {"longest": (0,)}),
    (eg.NStepSARSA, {"n": (0, 2.5, "inf"), "longest": (0,)}),
    (eg.PrioritisedSweeping, {"planning_steps": (-1, 2.5, 2**70), "planning_seconds": (-1.0,)}),
    (eg.PrioritisedSweeping, {"expected_updates": ("yes",)}),
    (eg.QLambda, {"traces": (eg.Dutch,)}),
    (eg.QLearning, {"initial_value": ("1", None, math.nan, math.inf, True)}),
    (eg.REINFORCE, {"longest": (0,)}),
    (eg.RMax, {"planning_seconds": (0,), "lowest_return": (101.0,)}),
    (eg.SARSALambda, {"traces": ("replacing",)}),
    (eg.TreeBackup, {"n": (1.5, math.inf)}),
]
"""What `create` itself looks at."""


@pytest.mark.parametrize(("kind", "settings"), OWN, ids=lambda part: getattr(part, "__name__", None))
def test_other_settings_are_refused(kind: Any, settings: dict[str, tuple[Any, ...]]) -> None:
    """Likewise by name and value."""
    for name, values in settings.items():
        for value in values:
            with pytest.raises(ValueError, match=rf"{name} must be .*but is {re.escape(repr(value))}"):
                kind.create((4, 2), **{name: value})


@pytest.mark.parametrize(("policy", "given"), [(eg.UCB.create((4, 2)), "UCB"), (eg.Greedy, "the class Greedy")])
def test_a_target_policy_has_probabilities(policy: Any, given: str) -> None:
    """UCB has none, and a class is none."""
    with pytest.raises(ValueError, match=f"target_policy must be a strategy that knows .*but is {given}$"):
        eg.TreeBackup.create((4, 2), target_policy=policy)
