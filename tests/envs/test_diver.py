"""Diver: an episode on paper, the values of the treasures, and what weights prefer."""

from math import inf, nan
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import (
    EpsilonGreedy,
    QLearning,
    finite_model,
    make_environment,
    make_mdp,
    train,
    value_iteration,
)
from edugym.envs.diver import DOWN, RIGHT, Diver
from tests.contract.described import NO_STEPS, Parameters, refused

WEIGHTS = st.tuples(st.floats(0, 10), st.floats(0.01, 10))
PARAMETERS = Parameters(
    valid=st.fixed_dictionaries(
        {"concavity": st.floats(0, 1)}, optional={"weights": WEIGHTS, "max_steps": st.integers(1, 60)}
    ),
    corners=(
        {},
        {"concavity": 0, "weights": [0, 1], "max_steps": 1},
        {"concavity": 1, "weights": [10**6, 0], "max_steps": 2**62},
    ),
    bad=(
        *refused("concavity", -0.1, 1.1, nan, "1", None, True),
        *refused("weights", 1.0, (1,), (1, 2, 3), (-1, 2), (0, 0), (nan, 1), (inf, 1), (10**6 + 1, 1), "12", None),
        *refused("max_steps", *NO_STEPS),
    ),
    finite=({}, {"concavity": 0}, {"concavity": 1, "weights": (0.5, 0.5)}),
    random=False,
    informed=lambda _, env: RIGHT if env.state % 9 < 4 else DOWN,
)


def played(mdp: Diver, actions: list[int]) -> list[int]:
    """The states of an episode."""
    rng, states = np.random.default_rng(0), [0]
    for action in actions:
        states.append(mdp.transition(states[-1], action, rng))
    return states


def test_an_episode() -> None:
    """To treasure 1, which is worth 10 + 10 + 7 (9 - 16 c) / 16."""
    env = make_environment("Diver", concavity=0.25, weights=(2, 3))
    _, info = env.reset(seed=0)
    assert (info["vector_reward"].tolist(), info["vector_return"].tolist()) == ([0, 0], [0, 0])
    for step, (action, state) in enumerate([(RIGHT, 1), (DOWN, 10)], start=1):
        seen, *rest, info = env.step(action)
        assert (seen, rest) == (state, [-3.0, False, False])
        assert (info["vector_reward"].tolist(), info["vector_return"].tolist()) == ([0, -1], [0, -step])
    value = 20 + 7 * 5 / 16
    seen, *rest, info = env.step(DOWN)
    assert (seen, rest) == (19, [2 * value - 3, True, False])
    assert (info["vector_reward"].tolist(), info["vector_return"].tolist()) == ([value, -1], [value, -3])


def test_edges() -> None:
    """The last column is the last one; there are other ways to a treasure than along the stairs."""
    mdp = Diver.create()
    assert played(mdp, [RIGHT] * 9)[-2:] == [8, 8]
    for actions, states in (
        ([RIGHT, RIGHT, DOWN, DOWN, DOWN], [0, 1, 2, 11, 20, 29]),
        ([RIGHT, DOWN, RIGHT, DOWN, DOWN], [0, 1, 10, 11, 20, 29]),
    ):
        assert played(mdp, actions) == states
        assert [mdp.terminal(state) for state in states] == [False] * 5 + [True]


@pytest.mark.parametrize(
    ("concavity", "values"),
    [
        (0, [10, 23.9375, 37.5, 50.3125, 62, 72.1875, 80.5, 86.5625, 90]),
        (0.5, [10, 20.4375, 31.5, 42.8125, 54, 64.6875, 74.5, 83.0625, 90]),
        (1, [10, 16.9375, 25.5, 35.3125, 46, 57.1875, 68.5, 79.5625, 90]),
    ],
)
def test_values(concavity: float, values: list[float]) -> None:
    """Worked out by hand."""
    assert Diver.create(concavity).treasures.tolist() == values


@given(st.floats(0, 1), st.integers(0, 100))
def test_deeper_treasures_are_worth_more(concavity: float, seed: int) -> None:
    """At every concavity, so that all are Pareto-optimal; every way to one has 2 k + 1 steps, or more to the last."""
    mdp, rng = Diver.create(concavity), np.random.default_rng(seed)
    assert (np.diff(mdp.treasures) > 3).all()
    state, steps = 0, 0
    while not mdp.terminal(state):
        state, steps = mdp.transition(state, int(rng.integers(2)), rng), steps + 1
        assert 0 <= state < 90
        assert state // 9 <= state % 9 + 1
    k = state % 9
    assert steps == 2 * k + 1 or (k == 8 and steps > 17)


def test_a_discount_moves_the_optimum() -> None:
    """To treasure 6, as the docstring says."""
    mdp = make_mdp("Diver")
    model = finite_model(mdp)
    for discount, best in ((1.0, 7), (0.99, 6)):
        policy = value_iteration(model, discount).Q.argmax(axis=1)
        state = 0
        while not mdp.terminal(state):
            state = mdp.transition(state, int(policy[model.row(state)]), np.random.default_rng(0))
        assert state % 9 == best


@pytest.mark.parametrize("seed", range(20))
def test_a_learner_finds_the_best_treasure(seed: int) -> None:
    """As the docstring says: exploration is no second challenge."""
    mdp = make_mdp("Diver")
    agent = QLearning.create(mdp, discount=1.0, exploration=EpsilonGreedy(0.5))
    assert train(mdp, agent, 100_000, seed=seed).returns[-1] == mdp.reward_threshold == 23.0625


@pytest.mark.parametrize("concavity", [0.0, 0.3, 0.5, 1.0])
@pytest.mark.parametrize("weights", [(1, 4), (1, 0), (0, 1), (1, 5.5), (3, 1), (1, 7)])
def test_the_threshold_is_the_exact_optimum(concavity: float, weights: Any) -> None:
    """Of the exact model of 54 cells, and with a step limit that of the treasures within it."""
    mdp = make_mdp("Diver", concavity=concavity, weights=weights)
    model = finite_model(mdp)
    assert (len(model.states), int(model.terminal.sum())) == (54, 9)
    assert value_iteration(model, 1.0).start == pytest.approx(mdp.reward_threshold)
    near = make_mdp("Diver", concavity=concavity, weights=weights, max_steps=4)
    assert near.reward_threshold == max(weights[0] * near.treasures[k] - weights[1] * (2 * k + 1) for k in (0, 1))
