"""The settings of a class are looked up once, and again when its annotations have changed."""

from typing import Annotated, Any, NamedTuple

import pytest

from edugym.agents.settings import Range, check, new, settings_of


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
    """An annotation that is a text is read with the names that are there now."""
    names: dict[str, Any] = {"NamedTuple": NamedTuple, "__name__": __name__}
    exec("class Late(NamedTuple):\n    rate: 'Rate' = 0.5", names)
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
