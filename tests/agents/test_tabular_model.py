"""The model of the planning agents: counts, chains, means, draws; learned and given."""

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces

from edugym import RMax, TabularObservation, finite_model, make_mdp
from edugym.agents.tabular_model import TabularModel, empty_model, given_model
from tests.agents.walk import Walk, exact_values


def chain(model: TabularModel, first: int, following: Any) -> list[tuple[Any, ...]]:
    """The outcomes of a chain: state, action, next state, whether it ends, weight, reward."""
    numbers = (model.states, model.actions, model.next_states, model.ends, model.weights, model.rewards)
    found = []
    while first >= 0:
        found.append(tuple(array[first].item() for array in numbers))
        first = following[first]
    return sorted(found)


def learned() -> TabularModel:
    """A model of six steps."""
    model = empty_model((4, 2))
    for step in ((0, 1, 1.0, 1), (0, 1, 3.0, 1), (0, 1, 5.0, 2), (2, 0, 0.0, 1), (0, 1, 2.0, 1)):
        model.observe(*step, False)
    model.observe(0, 1, 7.0, 1, True)
    return model


def test_it_counts() -> None:
    """Every outcome with how often it came and its mean reward; the same next state as an end is another outcome."""
    model = learned()
    assert chain(model, model.first[0, 1], model.following) == [
        (0, 1, 1, False, 3.0, 2.0),
        (0, 1, 1, True, 1.0, 7.0),
        (0, 1, 2, False, 1.0, 5.0),
    ]
    assert chain(model, model.first[0, 0], model.following) == []
    assert model.visits.tolist() == [[0, 5], [0, 0], [1, 0], [0, 0]]
    assert model.last_visit.tolist() == [[0, 6], [0, 0], [4, 0], [0, 0]]
    assert model.n_tried.tolist() == [1, 0, 1, 0]
    assert model.known_states[: model.n_known[0]].tolist() == [0, 2]
    into = chain(model, model.first_into[1], model.following_into)  # without ends: the value there does not count
    assert into == [(0, 1, 1, False, 3.0, 2.0), (2, 0, 1, False, 1.0, 0.0)]
    assert chain(model, model.first_into[3], model.following_into) == []
    Q = np.array([[0.0, 0.0], [8.0, 1.0], [-9.0, 4.0], [0.0, 0.0]])
    mean = (3 * (2 + 0.5 * 8) + 7 + (5 + 0.5 * 4)) / 5
    assert model.expected_target(0, 1, Q, 0.5) == pytest.approx(mean, rel=1e-15)


def test_draws_come_by_their_weights() -> None:
    """Three, one and one in five."""
    model, rng, n = learned(), np.random.default_rng(0), 5_000
    drawn = [model.sample(0, 1, rng) for _ in range(n)]
    shares = {(int(model.next_states[k]), int(model.ends[k])): drawn.count(k) / n for k in set(drawn)}
    assert shares == pytest.approx({(1, 0): 0.6, (1, 1): 0.2, (2, 0): 0.2}, abs=0.03)


def test_states_and_tried_actions_are_drawn_evenly() -> None:
    """Only those that were met."""
    model, rng = empty_model((5, 4)), np.random.default_rng(0)
    for state, action in ((2, 1), (2, 3), *[(4, 0)] * 7):
        model.observe(state, action, 0.0, 0, False)
    states = [model.random_state(rng) for _ in range(2_000)]
    actions = [model.random_tried_action(2, rng) for _ in range(2_000)]
    assert ({*states}, {*actions}) == ({2, 4}, {1, 3})
    assert [states.count(2) / 2_000, actions.count(1) / 2_000] == pytest.approx([0.5, 0.5], abs=0.05)


def test_what_no_longer_fits_is_not_remembered() -> None:
    """Known outcomes go on counting. Nobody plans with a pair that does not fit: it would have another's outcome."""
    model, rng = empty_model((4, 2), memory=1), np.random.default_rng(0)
    assert [model.observe(0, 0, 1.0, n, False) for n in (1, 2, 1)] == [0, -1, 0]
    assert chain(model, model.first[0, 0], model.following) == [(0, 0, 1, False, 2.0, 1.0)]
    assert model.observe(1, 1, -7.0, 2, False) == -1
    assert np.argwhere(model.visits).tolist() == [[0, 0]]
    for _ in range(20):
        state = model.random_state(rng)
        assert (state, model.random_tried_action(state, rng)) == (0, 0)
    agent = RMax.create((4, 2), memory=1)
    agent.learn(0, 0, 5.0, 3, True)
    agent.learn(1, 1, -7.0, 2, False)
    agent.plan()
    assert (agent.optimistic[1, 1], agent.Q[1, 1]) == (100.0, -100.0)


def test_a_given_model_has_the_exact_backups() -> None:
    """At the optimal values the expected target of every pair is its value, and nothing changes the model."""
    exact, Q = finite_model(Walk()), exact_values(Walk(), 0.9)
    model = given_model(Walk(), exact)
    assert model.n_outcomes[0] == np.count_nonzero(exact.probabilities[~exact.terminal])
    assert model.n_known[0] == np.count_nonzero(~exact.terminal)
    k = model.observe(1, 0, 123.0, 0, True)  # which of its outcomes a step is, if it has it
    assert (model.states[k], model.actions[k], model.next_states[k]) == (1, 0, 0)
    assert model.observe(1, 0, 0.0, 3, False) == -1
    for s in (1, 2, 3):
        assert [model.expected_target(s, a, Q, 0.9) for a in (0, 1)] == pytest.approx(Q[s].tolist(), abs=1e-8)


def walk_seen(place: Callable[[int], int]) -> Any:
    """The walk, of which the agent sees something else than the state."""
    return type("Seen", (Walk,), {"__slots__": (), "observation": lambda self, state, rng: place(state)})()


class Five(gymnasium.Env[Any, Any]):
    """An environment that somebody else has made, with as many observations and actions as the walk."""

    observation_space: Any = spaces.Discrete(5)
    action_space: Any = spaces.Discrete(2)


def test_a_model_of_states_that_are_no_numbers() -> None:
    """It comes with its MDP, or with an environment of it; states that are numbers need neither."""
    model = finite_model(make_mdp("Roadrunner"))
    for environment in (make_mdp("Roadrunner"), gymnasium.make("edugym/Roadrunner-v0")):
        assert given_model(environment, model).n_known[0] == np.count_nonzero(~model.terminal)
    walk = finite_model(Walk())
    ends_alike = given_model(walk_seen(lambda s: s % 4), walk)  # nothing is chosen there
    assert np.array_equal(ends_alike.rewards, given_model((5, 2), walk).rewards)
    for other in (Five(), TabularObservation(Five()), Walk()):  # also where a wrapper has a method `observation`
        assert np.array_equal(given_model(other, walk).rewards, given_model((5, 2), walk).rewards)


@pytest.mark.parametrize(("n_states", "memory"), [(4, 1_000), (63, 1_008), (7_000, 100_000), (30_000, 120_000)])
def test_how_much_fits_by_default(n_states: int, memory: int) -> None:
    """Eight outcomes of each pair, or fewer where that is much; but never fewer than two."""
    assert len(empty_model((n_states, 2)).states) == memory


@pytest.mark.parametrize(
    ("environment", "model", "message"),
    [
        ((5, 2), "exact", r"model must be a FiniteModel, .* but is 'exact'"),
        (walk_seen(lambda s: min(s, 2)), finite_model(Walk()), r"model must have states that the agent can tell apart"),
        ((4, 2), finite_model(Walk()), r"model must be one of this environment, which has 4 states and 2 actions"),
        ((5, 3), finite_model(Walk()), r"model must be one of this environment, .*, but has 5 and 2"),
        ((5, 2), finite_model(make_mdp("Roadrunner")), r"model must have states that are whole numbers"),
    ],
)
def test_what_does_not_fit_is_refused(environment: Any, model: Any, message: str) -> None:
    """The message says what is wrong with it."""
    with pytest.raises(ValueError, match=message):
        given_model(environment, model)
