"""Fingerprints: what is easily overlooked in values and in code."""

import copy
import sys
from typing import Any

import numpy as np
import pytest

from edugym.experiments import fingerprints
from edugym.experiments.fingerprints import fingerprint

FIRST, SECOND = [1], [1]


def held(value: Any) -> Any:
    """A row of a table whose column holds any object."""
    return np.array([(value,)], [("column", object)])[0]


def defined(code: str, name: str) -> Any:
    """A function of a notebook."""
    names: dict[str, Any] = {"__name__": "__main__", "sys": sys}
    exec(code, names)
    return names[name]


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (np.float64(1), np.float64(2)),
        (np.int64(1), np.int32(1)),
        (held([1]), held([2])),
        ({1, 2}, {1, 3}),
        ([FIRST, SECOND, FIRST], [FIRST, SECOND, SECOND]),
        (type("One", (), {}), type("Two", (), {})),
        (type("Slots", (), {"__slots__": ("a",)}), type("Slots", (), {"__slots__": ("b",)})),
        (defined("def one(): pass", "one"), defined("def two(): pass", "two")),
    ],
)
def test_what_differs_has_another_one(one: Any, other: Any) -> None:
    """Numbers of NumPy, sets, names, and which of two equal lists it is."""
    assert fingerprint(one) == fingerprint(copy.deepcopy(one))
    assert fingerprint(one) != fingerprint(other)


def test_a_number_has_no_place_of_its_own() -> None:
    """The same number twice is no other value than two equal ones."""
    number = np.float64(0.5)
    assert fingerprint([number, number]) == fingerprint([number, np.float64(0.5)])
    assert fingerprint(held([1])) == fingerprint(held([1]))


def test_the_name_fits_in_the_name_of_a_file() -> None:
    """It is short, whatever is hashed."""
    assert len(fingerprint(1)) == len(fingerprint(range(1000))) == 32


@pytest.mark.parametrize(
    "code", ["def use():\n    def inner(): return rate\n    return inner()", "def use(): return [rate for _ in '12']"]
)
def test_what_an_inner_function_reaches_counts(code: str) -> None:
    """A global of a function inside a function, or of a list."""
    one, other = (defined(f"rate = {rate}\n{code}", "use") for rate in (1, 2))
    assert fingerprint(one) != fingerprint(other)


def test_what_a_function_takes_from_a_library_is_not_taken_apart() -> None:
    """There is no fingerprint of the standard output, and it needs none."""
    use = defined("def use(): sys.stdout.flush()", "use")
    assert fingerprint(use) == fingerprint(use)


def test_a_relative_import_in_a_notebook_is_an_error_of_the_call_only() -> None:
    """A notebook belongs to no package."""
    assert fingerprint(defined("def use(): from . import part", "use"))


def test_a_library_that_a_function_imports_counts_by_its_version(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where the import is inside the function."""
    use = defined("def use(): import pandas", "use")
    before, version = fingerprint(use), fingerprints._version
    monkeypatch.setattr(fingerprints, "_version", lambda package: "99" if package == "pandas" else version(package))
    assert fingerprint(use) != before
