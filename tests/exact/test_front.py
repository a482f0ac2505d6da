"""The exact front, against every sequence of actions, and against the shortest way to each treasure."""

from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from edugym import finite_model, make_mdp, value_iteration
from edugym.envs.diver import Diver
from edugym.objectives import exact_front, pareto_front, supported
from tests.exact.graphs import Graph, loop


@st.composite
def graphs(draw: st.DrawFn) -> Graph:
    """Up to four nodes, two actions, two or three objectives, and a limit of at most five steps."""
    n_states, n_objectives = draw(st.integers(2, 4)), draw(st.integers(2, 3))
    successors = draw(arrays.arrays(np.int64, (n_states, 2), elements=st.integers(0, n_states - 1)))
    numbers = st.integers(-3, 3).map(float)
    vectors = draw(arrays.arrays(np.float64, (n_states, 2, n_objectives), elements=numbers))
    return Graph(successors, vectors, draw(st.integers(1, 5)))


def returns_of(mdp: Any, actions: Any, discount: float) -> tuple[float, ...]:
    """The sum of the vectors of rewards of an episode, which may end before the actions do."""
    rng = np.random.default_rng(0)
    state, total, factor = mdp.initial(rng), np.zeros(mdp.reward_space.shape), 1.0
    for action in actions:
        if mdp.terminal(state):
            break
        next_state = mdp.transition(state, action, rng)
        total = total + factor * np.array(mdp.rewards(state, action, next_state))
        factor, state = factor * discount, next_state
    return tuple(total.tolist())


@settings(deadline=None, max_examples=60)
@given(graphs(), st.sampled_from([1.0, 0.5, 0.0]))
def test_every_sequence_of_actions(mdp: Graph, discount: float) -> None:
    """The best of all returns are the front, and its actions give them."""
    assert mdp.max_steps is not None
    every = sorted({returns_of(mdp, actions, discount) for actions in product((0, 1), repeat=mdp.max_steps)})
    best = [point for point, optimal in zip(every, pareto_front(every), strict=True) if optimal]
    front = exact_front(mdp, discount)
    assert front.returns.tolist() == [list(point) for point in best]
    for point, actions in zip(front.returns, front.actions, strict=True):
        assert len(actions) <= mdp.max_steps
        assert returns_of(mdp, actions, discount) == tuple(point)


def shortest_ways(mdp: Diver) -> dict[int, int]:
    """The fewest steps to each treasure, by its state: breadth first."""
    rng, reached, border, steps = np.random.default_rng(0), {0: 0}, {0}, 0
    while border:
        steps += 1
        border = {mdp.transition(s, a, rng) for s in border if not mdp.terminal(s) for a in range(2)} - reached.keys()
        reached |= dict.fromkeys(border, steps)
    return {state: n for state, n in reached.items() if mdp.terminal(state)}


@settings(deadline=None, max_examples=20)
@given(st.floats(0, 1), st.integers(1, 20))
def test_diver(concavity: float, max_steps: int) -> None:
    """Each treasure within the limit, by its shortest way, is a point of the front."""
    mdp = Diver.create(concavity, max_steps=max_steps)
    ways = shortest_ways(mdp)
    assert len(ways) == 9
    expected = sorted((mdp.treasures[s % 9], -float(steps)) for s, steps in ways.items() if steps <= max_steps)
    front = exact_front(mdp)
    assert front.returns == pytest.approx(np.array(expected), abs=1e-12)
    for point, actions in zip(front.returns, front.actions, strict=True):
        assert returns_of(mdp, actions, 1.0) == pytest.approx(tuple(point), abs=1e-12)


@pytest.mark.parametrize("concavity", [0.0, 0.4, 1.0])
def test_weighted_sums_find_what_is_supported_and_nothing_else(concavity: float) -> None:
    """Value iteration on the weighted reward, for weights between those at which two treasures tie."""
    front = exact_front(Diver.create(concavity)).returns
    found = set()
    for share in np.linspace(0.001, 0.999, 200):
        mdp = make_mdp("Diver", concavity=concavity, weights=(share, 10 * (1 - share)))
        start = value_iteration(finite_model(mdp)).start
        found |= set(np.flatnonzero(np.isclose(front @ np.array(mdp.weights), start, rtol=0, atol=1e-9)).tolist())
    assert sorted(found) == np.flatnonzero(supported(front)).tolist()


def test_a_task_that_never_settles() -> None:
    """Who waits gets more and more, unless there is a limit or a discount."""
    assert exact_front(loop()).returns.tolist() == [[0, 5], [1, 4], [2, 3]]
    assert exact_front(loop(max_steps=None), 0.5).returns[0].tolist() == pytest.approx([0, 2])
    with pytest.raises(ValueError, match="mdp must be a task whose returns settle"):
        exact_front(loop(max_steps=None))


@pytest.mark.parametrize(
    ("slip", "says"),
    [
        ("random start", "mdp must be a task without chance, but what initial of Graph does varies"),
        ("random walk", "mdp must be a task without chance, but what transition of Graph does varies"),
        ("space", r"reward_space of Graph must be a Box of shape \(n_objectives,\), but is Discrete"),
        ("one number", r"what rewards of Graph returns must be an array of numbers of shape \(2,\), but is 1.0"),
        ("nothing", r"what rewards of Graph returns must be an array of numbers of shape \(2,\), but is None"),
        ("too many", r"what rewards of Graph returns must be an array of numbers of shape \(2,\), but is \(1.0"),
    ],
)
def test_slips(slip: str, says: str) -> None:
    """One sentence each."""
    with pytest.raises(ValueError, match=says):
        exact_front(loop(slip))


def test_an_mdp_with_one_reward() -> None:
    """It has no vectors."""
    with pytest.raises(
        ValueError, match=r"mdp must have several objectives, with a method rewards\(.*, but is Boulder"
    ):
        exact_front(make_mdp("Boulder"))
