"""What models and values are asked for: outcomes, samples, `P`, observations, values by state and by observation."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym import QLearning, finite_model, make_mdp, value_iteration
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.values import Values
from tests.compiled.cells import SLIPPERY, WALK, cell
from tests.exact.tasks import Hidden, Walk, random_model
from tests.messages import named


def test_P_is_that_of_toy_text() -> None:
    """A dictionary of dictionaries of lists of tuples of plain numbers, as FrozenLake has it."""
    P = finite_model(cell(SLIPPERY)["SlipperyWalk"](2, 0.25)).P
    steps = {0: (0, 1, -0.25, False), 1: (0, 2, 1.0, True)}
    for s, (left, right, pays, ends) in steps.items():
        for a, p in ((0, 0.25), (1, 0.75)):
            assert sorted(P[s][a]) == sorted([(p, right, pays, ends), (1 - p, left, -0.25, False)])
            assert [tuple(map(type, way)) for way in P[s][a]] == [(float, int, float, bool)] * 2
    assert P[2] == {0: [(1.0, 2, 0.0, True)], 1: [(1.0, 2, 0.0, True)]}


def test_samples() -> None:
    """They come as often as the model says; unused places of the tables are never drawn."""
    model, rng = finite_model(cell(SLIPPERY)["SlipperyWalk"](4, 0.25)), np.random.default_rng(0)
    drawn = [model.sample(2, 1, rng) for _ in range(4000)]
    assert {(3, -0.25, False), (1, -0.25, False)} == set(drawn)
    share = np.mean([sample.next_state == 1 for sample in drawn])
    assert abs(share - 0.25) < 6 * math.sqrt(0.25 * 0.75 / 4000)
    assert {model.sample(4, 0, rng) for _ in range(50)} == {(4, 0.0, True)}
    assert {model.sample(3, 1, rng) for _ in range(100)} == {(4, 1.0, True), (2, -0.25, False)}
    assert [outcome[:2] for outcome in model.outcomes(2, 1)] == [(0.25, 1), (0.75, 3)]
    for number, next_state in ((0.0, 1), (0.24, 1), (0.25, 3), (0.999, 3)):
        fixed: Any = SimpleNamespace(random=lambda number=number: number)
        assert model.sample(2, 1, fixed).next_state == next_state


def test_states_and_actions_that_are_not_there() -> None:
    """The message says what is allowed; -1 does not count from the end."""
    model = finite_model(cell(WALK)["Walk"](4))
    rng = np.random.default_rng(0)
    wrong: list[Any] = [-1, 2, 0.5, None, True]
    for action in wrong:
        with pytest.raises(ValueError, match=named("action", 0, 1, action)):
            model.outcomes(0, action)
        with pytest.raises(ValueError, match=named("action", 0, 1, action)):
            model.sample(0, action, rng)
    with pytest.raises(ValueError, match=named("state", 5, 9)):
        model.sample(9, 0, rng)
    right: Any = np.int64(1)
    assert str(model.outcomes(0, right)) == "[Outcome(probability=1.0, next_state=1, reward=-0.25, terminated=False)]"
    assert str(model.sample(0, right, rng)) == "Sample(next_state=1, reward=-0.25, terminated=False)"
    assert repr(finite_model(Walk())) == "<model of Walk: 7 states, 1 actions, at most 2 outcome(s) of each>"
    assert repr(random_model(0)).startswith("<model of a task: 4 states")


def test_the_value_of_a_state_is_not_that_of_its_row() -> None:
    """In Supermarket `V[8]` belongs to another state than 8."""
    model = finite_model(make_mdp("Supermarket"))
    found = value_iteration(model)
    assert model.row(8) != 8
    assert [found.value(state) for state in model.states] == found.V.tolist()
    with pytest.raises(ValueError, match=named("state", 428, 799)):
        found.value(799)


@pytest.mark.parametrize(
    ("name", "parameters"), [("Supermarket", {}), ("Catch", {"observation_type": "vectorised"}), ("Boulder", {})]
)
def test_a_table_is_indexed_like_that_of_an_agent(name: str, parameters: dict[str, Any]) -> None:
    """By observations, which are not rows; what is never observed has no value."""
    mdp = make_mdp(name, **parameters)
    model = finite_model(mdp)
    observations = model.observations().tolist()
    by_hand = [x * 50 + y * 5 + paddle for x, y, paddle in model.states] if name == "Catch" else list(model.states)
    assert observations == by_hand
    found = value_iteration(model)
    table = found.table()
    assert table.shape == QLearning.create(mdp).Q.shape
    assert np.array_equal(table[observations], found.Q)
    assert np.isnan(table).all(axis=1).sum() == len(table) - len(model.states)


def test_no_table_where_the_observation_does_not_tell_the_state() -> None:
    """Random observations, pixels, models made by hand, and two states of different values that look alike."""
    for model, reason in (
        (finite_model(Hidden()), "the observation must follow from the state, but in 3 it is random"),
        (finite_model(make_mdp("Catch", observation_type="rgb")), "needs observations that are whole numbers"),
        (random_model(0), "the model must know its task"),
    ):
        with pytest.raises(ValueError, match=reason):
            model.observations()
    model = finite_model(type("Blind", (Walk,), {"observation": lambda *_: 0})())
    with pytest.raises(ValueError, match=r"there is no table by observation: \d looks like a state of other values"):
        value_iteration(model).table()
    assert policy_evaluation(model, np.zeros(7, int), 0.0).value(1) == 0.0


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
