"""Values by state, by observation, and the policy that follows from them."""

import numpy as np
import pytest

from edugym import QLearning, finite_model, make_mdp, value_iteration
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.values import Values
from tests.exact.tasks import Hidden, Walk, random_model


def test_the_value_of_a_state_is_not_that_of_its_row() -> None:
    """In Supermarket `V[8]` belongs to another state than 8."""
    model = finite_model(make_mdp("Supermarket"))
    found = value_iteration(model)
    assert found.value(8) == found.V[model.row(8)]
    assert model.row(8) != 8
    for s, state in enumerate(model.states):
        assert found.value(state) == found.V[s]
    with pytest.raises(ValueError, match="state must be one of the 428 that can be reached"):
        found.value(799)


def test_a_table_is_indexed_like_that_of_an_agent() -> None:
    """What is never observed has no value."""
    for name, parameters in (("Supermarket", {}), ("Catch", {"observation_type": "vectorised"}), ("Boulder", {})):
        mdp = make_mdp(name, **parameters)
        model = finite_model(mdp)
        found = value_iteration(model)
        table = found.table()
        assert table.shape == QLearning.create(mdp).Q.shape
        for s, observation in enumerate(model.observations()):
            assert np.array_equal(table[observation], found.Q[s])
        assert np.isnan(table).all(axis=1).sum() == len(table) - len(model.states)
    task = finite_model(make_mdp("Supermarket"))
    assert value_iteration(task).table()[8].max() == value_iteration(task).value(8)


def test_no_table_where_the_observation_does_not_tell_the_state() -> None:
    """Two states of different values that look alike have no common entry."""

    class Blind(Walk):
        __slots__ = ()

        def observation(self, state: int, rng: object) -> int:
            return 0

    model = finite_model(Blind())
    with pytest.raises(ValueError, match=r"there is no table by observation: \d looks like a state of other values"):
        value_iteration(model).table()
    assert policy_evaluation(model, np.zeros(7, int), 0.0).value(1) == 0.0
    with pytest.raises(ValueError, match="in 3 it is random"):
        value_iteration(finite_model(Hidden())).table()


def test_the_greedy_policy_shares_ties() -> None:
    """Equal but for rounding, which is coarser far from 0 on either side, is equal; the shares sum to 1."""
    values_and_shares = [
        ([1.0, 1.0 - 1e-12, 0.0], [0.5, 0.5, 0.0]),
        ([2.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
        ([-5.0, -5.0, -5.0], [1 / 3, 1 / 3, 1 / 3]),
        ([1e12, 1e12 - 1.0, 0.0], [0.5, 0.5, 0.0]),
        ([-1e12, -2e12, -1e12 - 1.0], [0.5, 0.0, 0.5]),
        ([-1e-8, 1e-3, 1e-3 - 1e-8], [0.0, 1.0, 0.0]),
    ]
    Q = np.array([values for values, _ in values_and_shares])
    policy = Values(Q.max(axis=1), Q, 0.0, random_model(0, n_actions=3)).greedy_policy()
    assert policy.tolist() == [shares for _, shares in values_and_shares]
