"""The contract tests cover the whole registry, and what the table of parameters says is refused is refused."""

from typing import Any

import numpy as np
import pytest

from edugym.adapters.registration import Entry, make_mdp, parameters_of
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


def test_numpy_parameters_do_not_overflow() -> None:
    """The largest of a type has no one more."""
    assert make_mdp("Boulder", height=np.uint8(255)).max_steps == 2550
    assert make_mdp("Roadrunner", size=np.int8(127)).max_steps == 635
    assert make_mdp("Catch", rows=np.int8(127), columns=np.int8(127)).columns == 127
    days = make_mdp("Study", total_days=np.int8(127)).observation_space
    doors = make_mdp("MemoryCorridor", num_doors=np.uint8(255)).observation_space
    hits = make_mdp("Golf", max_hits=np.uint8(255), observe_hits=True).observation_space
    assert (days.nvec[2], doors.n, hits.nvec[2]) == (128, 256, 256)


@every_environment
def test_bad_parameters(entry: Entry) -> None:
    """A wrong parameter raises a ValueError that names the parameter and its value."""
    for bad in (*PARAMETERS[entry.name].bad, *refused("render_mode", "svg", "", 1)):
        with pytest.raises(ValueError, match=bad.name) as caught:
            pytest.fail(f"{entry.name} takes {bad}: {entry.load()(**bad.given, **{bad.name: bad.value})}")
        assert in_short(bad.value) in str(caught.value), bad


@every_environment
def test_huge_numbers(entry: Entry) -> None:
    """A number of 5 000 digits is refused with a sentence that names the parameter; only seeds may be so large."""
    for name in parameters_of(entry.load()):
        if name != "layout_seed":
            for huge in (10**5000, -(10**5000)):
                with pytest.raises(ValueError, match=f"^{name} must be .*, but is (a whole number of .* digits|-?inf)"):
                    entry.load()(**{name: huge})
    if "layout_seed" in parameters_of(entry.load()):
        assert entry.load()(layout_seed=10**5000)
