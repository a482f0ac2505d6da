"""Settings: how they are looked up, the range of each, and what `create` refuses."""

import importlib
import math
import pkgutil
from collections.abc import Iterator
from contextlib import nullcontext
from typing import Annotated, Any, NamedTuple, get_type_hints

import numpy as np
import pytest

import edugym as eg
from edugym import agents
from edugym.agents.settings import Range, check, settings_of
from tests.agents.cases import AGENTS
from tests.messages import named


class Limited(NamedTuple):
    """A value with one setting."""

    rate: Annotated[float, Range(0, 1)] = 0.5


def test_an_annotation_counts_as_it_is_now(monkeypatch: pytest.MonkeyPatch) -> None:
    """After it was changed, and, written as a text, when its name comes to mean something."""
    names: dict[str, Any] = {"NamedTuple": NamedTuple, "__name__": __name__}
    exec("class Late(NamedTuple):\n    rate: 'Rate' = 0.5\n    bonus: float = 0.0", names)
    check(Limited(0.5))
    check(names["Late"](5.0))
    with monkeypatch.context() as patch:
        patch.setitem(Limited.__annotations__, "rate", Annotated[float, Range(0, 10)])
        check(Limited(5.0))
    monkeypatch.setitem(globals(), "Rate", Annotated[float, Range(0, 1)])
    settings_of(Limited).clear()  # a caller who changes what it got changes nothing
    for kind in (Limited, names["Late"]):
        with pytest.raises(ValueError, match="rate"):
            check(kind(5.0))


def test_an_unknown_setting_is_answered_with_all_that_there_are() -> None:
    """Those that `create` itself takes are among them."""
    known = "planning_steps, planning_seconds, model, memory, learning_rate"
    with pytest.raises(ValueError, match=named("PrioritisedSweeping", "planing_steps", known)):
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
    Range(0, 1, open=True): ("learning_rate", "value_learning_rate", "rate"),
    Range(0, 1): ("REINFORCE.value_learning_rate", "discount", "trace_decay", "epsilon", "start", "end"),
    Range(0, math.inf, open=True): ("error_clip", "temperature"),
    Range(0, open=True): ("spread", "clip"),
    Range(0): ("ThompsonSampling.spread", "bonus", "exploration_bonus", "threshold", "c", "constant", "entropy_bonus"),
    Range(1, math.inf): ("NStepSARSA.n",),
    Range(1): (
        "TreeBackup.n", "learn_every", "learn_from", "copy_every", "known_after", "explore_steps", "steps",
        "num_envs", "length", "epochs", "minibatches", "hidden",
    ),
    Range(-1e300, 1e300): ("risk", "highest_return", "lowest_return", "reward_at_goal", "reward_elsewhere"),
}  # fmt: skip
"""The settings of these names, or of one class."""


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


def test_every_range() -> None:
    """A rate of 0 learns nothing, a clip of 0 has no gradient, and a discount of 0 is legitimate."""
    expected, wrong, found = {name: mark for mark, names in RANGES.items() for name in names}, [], set()
    for kind, field, mark in ranges():
        name = f"{kind.__name__}.{field}"
        name = name if name in expected else field
        found.add(name)
        if expected.get(name, mark) != mark:  # what is not in the table is of a new agent, with a test of its own
            wrong.append(f"{kind.__name__}.{field}: {mark}")
    assert wrong == []
    assert found >= expected.keys()


@pytest.mark.parametrize("mark", RANGES, ids=str)
def test_the_ends_of_a_range(mark: Range) -> None:
    """The next numbers to both sides, and what is no number."""
    high = mark.high or math.inf
    inside = {mark.low: not mark.open, math.nextafter(mark.low, -math.inf): False, math.nan: False}
    inside |= {math.nextafter(mark.low, math.inf): True, min(high, 1e300): True, math.inf: mark.high == math.inf}
    inside |= {} if high == math.inf else {math.nextafter(high, math.inf): False}
    for value, allowed in inside.items():
        with nullcontext() if allowed else pytest.raises(ValueError, match=named("x")):
            mark.check("x", value)


@pytest.mark.parametrize("kind", sorted({case.kind for case in AGENTS.values()}, key=str))
def test_settings_out_of_range_are_refused(kind: Any) -> None:
    """Every field with a range; the message names it and its value."""
    for _, field, _ in (found for found in ranges() if found[0] is kind):
        for value in (-math.inf, math.nan, "0.1", None, True):
            with pytest.raises(ValueError, match=named(field, repr(value))):
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
    (eg.UCT, {"simulations": (0, 1, 2.5, math.inf), "depth": (0, 2.5), "nodes": (0, 2.5), "memory": (0,)}),
]
"""What `create` itself looks at."""


@pytest.mark.parametrize(("kind", "settings"), OWN, ids=lambda part: getattr(part, "__name__", None))
def test_other_settings_are_refused(kind: Any, settings: dict[str, tuple[Any, ...]]) -> None:
    """Likewise by name and value."""
    for name, values in settings.items():
        for value in values:
            with pytest.raises(ValueError, match=named(name, repr(value))):
                kind.create((4, 2), **{name: value})


@pytest.mark.parametrize(("policy", "given"), [(eg.UCB.create((4, 2)), "UCB"), (eg.Greedy, "the class Greedy")])
def test_a_target_policy_has_probabilities(policy: Any, given: str) -> None:
    """UCB has none, and a class is none."""
    with pytest.raises(ValueError, match=f"target_policy must be a strategy that knows .*but is {given}$"):
        eg.TreeBackup.create((4, 2), target_policy=policy)
