"""The contract tests cover the whole registry, and what the table of parameters says is refused is refused."""

import inspect

import numpy as np
import pytest

from edugym.adapters.registration import Entry, make_mdp
from edugym.checks.parameters import in_short
from tests.contract.described import refused
from tests.contract.parameters import PARAMETERS, Keywords
from tests.contract.play import every_corner, every_environment


def parameters_of(entry: Entry) -> set[str]:
    """The names of an environment's own parameters."""
    return set(inspect.signature(entry.load()).parameters) - {"render_mode"}


@every_environment
def test_table_describes_every_parameter(entry: Entry) -> None:
    """Every parameter of a constructor has an extreme value and a bad one in the table, and there are no others."""
    table = PARAMETERS[entry.name]
    assert {name for corner in table.corners for name in corner} == parameters_of(entry)
    assert {bad.name for bad in table.bad} == parameters_of(entry)


@every_corner
def test_numpy_parameters(entry: Entry, keywords: Keywords) -> None:
    """Whole numbers of the smallest type of NumPy's that holds them make the same task as Python's."""
    defaults = {name: part.default for name, part in inspect.signature(entry.load()).parameters.items()}
    given = {**defaults, **keywords}
    small = {name: np.min_scalar_type(value).type(value) for name, value in given.items() if type(value) is int}
    env, same = entry.load()(**keywords), entry.load()(**{**keywords, **small})
    assert repr(env.mdp) == repr(same.mdp)
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
