"""The contract tests cover the whole registry, and what the table of parameters says is refused is refused."""

from typing import Any

import numpy as np
import pytest

from edugym.adapters.registration import Entry, parameters_of
from edugym.checks.parameters import in_short
from tests.contract.described import refused
from tests.contract.parameters import PARAMETERS, Keywords
from tests.contract.play import every_corner, every_environment


@every_environment
def test_table_describes_every_parameter(entry: Entry) -> None:
    """Every parameter of a constructor has an extreme value and a bad one in the table, and there are no others."""
    table, names = PARAMETERS[entry.name], set(parameters_of(entry.load()))
    assert {name for corner in table.corners for name in corner} == {bad.name for bad in table.bad} == names


@every_corner
def test_numpy_parameters(entry: Entry, keywords: Keywords) -> None:
    """NumPy's numbers, whole ones of the smallest type, make the same task as Python's, of Python's numbers."""
    given = {**parameters_of(entry.load()), **keywords}
    kinds: dict[Any, Any] = {int: lambda value: np.min_scalar_type(value).type(value), float: np.float64}
    of_numpy = {name: kinds[type(value)](value) for name, value in given.items() if type(value) in kinds}
    env, same = entry.load()(**keywords), entry.load()(**{**keywords, **of_numpy})
    assert repr(env.mdp) == repr(same.mdp)
    assert [type(part) for part in env.mdp] == [type(part) for part in same.mdp]
    assert (env.observation_space, env.action_space) == (same.observation_space, same.action_space)


@every_environment
def test_bad_parameters(entry: Entry) -> None:
    """A wrong parameter raises a ValueError that names the parameter and its value."""
    for bad in (*PARAMETERS[entry.name].bad, *refused("render_mode", "svg", "", 1)):
        with pytest.raises(ValueError, match=bad.name) as caught:
            pytest.fail(f"{entry.name} takes {bad}: {entry.load()(**bad.given, **{bad.name: bad.value})}")
        assert in_short(bad.value) in str(caught.value), bad
