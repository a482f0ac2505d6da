"""Looking things up in a model: outcomes, samples, toy_text's `P`, and what the agent observes."""

import math
from typing import Any

import numpy as np
import pytest

from edugym import finite_model, make_mdp
from tests.compiled.cells import SLIPPERY, WALK, cell
from tests.exact.tasks import Hidden, Walk, random_model


def test_P_is_that_of_toy_text() -> None:
    """A dictionary of dictionaries of lists of tuples of plain numbers, as FrozenLake has it."""
    P = finite_model(cell(SLIPPERY)["SlipperyWalk"](2, 0.25)).P
    assert {s: {a: sorted(ways) for a, ways in by_action.items()} for s, by_action in P.items()} == {
        0: {
            0: [(0.25, 1, -0.25, False), (0.75, 0, -0.25, False)],
            1: [(0.25, 0, -0.25, False), (0.75, 1, -0.25, False)],
        },
        1: {0: [(0.25, 2, 1.0, True), (0.75, 0, -0.25, False)], 1: [(0.25, 0, -0.25, False), (0.75, 2, 1.0, True)]},
        2: {0: [(1.0, 2, 0.0, True)], 1: [(1.0, 2, 0.0, True)]},
    }
    for by_action in P.values():
        for ways in by_action.values():
            assert [tuple(map(type, way)) for way in ways] == [(float, int, float, bool)] * len(ways)


def test_samples_come_as_often_as_the_model_says() -> None:
    """Within six standard deviations; unused places of the tables are never drawn."""
    model = finite_model(cell(SLIPPERY)["SlipperyWalk"](4, 0.25))
    rng = np.random.default_rng(0)
    drawn = [model.sample(2, 1, rng) for _ in range(4000)]
    assert {(3, -0.25, False), (1, -0.25, False)} == set(drawn)
    share = np.mean([sample.next_state == 1 for sample in drawn])
    assert abs(share - 0.25) < 6 * math.sqrt(0.25 * 0.75 / 4000)
    assert {model.sample(4, 0, rng) for _ in range(50)} == {(4, 0.0, True)}
    assert {model.sample(3, 1, rng) for _ in range(100)} == {(4, 1.0, True), (2, -0.25, False)}


@pytest.mark.parametrize(("number", "next_state"), [(0.0, 1), (0.24, 1), (0.25, 3), (0.999, 3)])
def test_a_sample_divides_the_unit_interval(number: float, next_state: int) -> None:
    """The first outcome takes the numbers below its probability."""

    class Fixed:
        def random(self) -> float:
            return number

    rng: Any = Fixed()
    model = finite_model(cell(SLIPPERY)["SlipperyWalk"](4, 0.25))
    assert [outcome[:2] for outcome in model.outcomes(2, 1)] == [(0.25, 1), (0.75, 3)]
    assert model.sample(2, 1, rng).next_state == next_state


def test_states_and_actions_that_are_not_there() -> None:
    """The message says what is allowed; -1 does not count from the end."""
    model = finite_model(cell(WALK)["Walk"](4))
    rng = np.random.default_rng(0)
    wrong: list[Any] = [-1, 2, 0.5, None, "1", True]
    for action in wrong:
        with pytest.raises(ValueError, match=r"action must be .*from 0 to 1, but is"):
            model.outcomes(0, action)
        with pytest.raises(ValueError, match=r"action must be .*from 0 to 1, but is"):
            model.sample(0, action, rng)
    with pytest.raises(ValueError, match="state must be one of the 5 that can be reached"):
        model.sample(9, 0, rng)
    right: Any = np.int64(1)
    assert model.outcomes(0, right) == [(1.0, 1, -0.25, False)]
    assert str(model.outcomes(0, right)) == "[Outcome(probability=1.0, next_state=1, reward=-0.25, terminated=False)]"
    assert str(model.sample(0, right, rng)) == "Sample(next_state=1, reward=-0.25, terminated=False)"


def test_observations_are_not_rows() -> None:
    """In Supermarket walls leave gaps between the observations; in Catch three numbers are one."""
    shop = finite_model(make_mdp("Supermarket"))
    assert shop.observations().tolist() == list(shop.states)
    assert shop.observations()[8] != 8
    catch = finite_model(make_mdp("Catch", rows=4, columns=3, observation_type="vectorised"))
    assert catch.observations().tolist() == [x * 12 + y * 3 + paddle for x, y, paddle in catch.states]


def test_observations_that_do_not_belong_to_a_state() -> None:
    """Random ones, pixels, and models made by hand."""
    with pytest.raises(ValueError, match="the observation must follow from the state, but in 3 it is random"):
        finite_model(Hidden()).observations()
    with pytest.raises(ValueError, match="a table needs observations that are whole numbers"):
        finite_model(make_mdp("Catch", observation_type="rgb")).observations()
    with pytest.raises(ValueError, match="the model must know its task"):
        random_model(0).observations()


def test_a_model_is_printed_in_one_line() -> None:
    """Not as thousands of numbers."""
    assert repr(finite_model(Walk())) == "<model of Walk: 7 states, 1 actions, at most 2 outcome(s) of each>"
    assert repr(random_model(0)).startswith("<model of a task: 4 states")
