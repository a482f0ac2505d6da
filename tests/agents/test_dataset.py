"""Datasets: what they hold, how they are collected from a model, and what is refused."""

from typing import Any

import numpy as np
import pytest

from edugym import Dataset, collect, finite_model, make_mdp, policy_evaluation
from edugym.agents import dataset
from tests.agents.offline import by_hand, going_on, random_data
from tests.exact.tasks import LOOP, random_model
from tests.messages import named


def test_by_hand() -> None:
    """Episodes, visits and returns of four steps."""
    data = by_hand()
    assert data.n_episodes == 3
    assert data.starts.tolist() == [0, 2, 3]
    assert data.ends.tolist() == [1, 2, 3]
    assert data.visits.tolist() == [[1, 2], [1, 0], [0, 0]]
    assert data.returns(0.5).tolist() == [4.0, 0.0, 8.0]
    assert data.returns().tolist() == [6.0, 0.0, 8.0]
    assert repr(data) == "<dataset: 4 steps in 3 episodes; 3 states, 2 actions>"


@pytest.mark.parametrize("seed", [0, 7])
def test_what_is_collected_could_have_been_made_by_hand(seed: int) -> None:
    """It passes the checks; no episode is longer than the limit; `terminated` and `truncated` never blur."""
    model, _, behaviour, data = random_data(seed, n_episodes=300)
    assert [*map(str, Dataset.create(*data))] == [*map(str, data)]
    lengths = data.ends - data.starts + 1
    assert lengths.max() == 6
    assert (lengths[data.truncated[data.ends]] == 6).all()
    assert (model.terminal[data.next_states] == data.terminated).all()
    assert data.terminated[data.ends[lengths == 6]].any()  # an end at the limit is an end
    assert data.n_episodes == 300
    assert (data.probabilities == behaviour[data.states, data.actions]).all()


@pytest.mark.parametrize("seed", [0, 7])
def test_frequencies_are_those_of_model_and_policy(seed: int) -> None:
    """First states, actions, next states, and the mean return, each within four standard errors."""
    model, _, behaviour, data = random_data(seed, n_episodes=20_000)

    def close(found: Any, expected: Any, times: Any) -> None:
        assert (np.abs(found - expected) <= 4.5 * np.sqrt(expected * (1 - expected) / times) + 1e-12).all()

    first = np.bincount(data.states[data.starts], minlength=4) / 20_000
    close(first, model.initial, 20_000)
    visits = data.visits[:3]
    close(visits / visits.sum(axis=1, keepdims=True), behaviour[:3], visits.sum(axis=1, keepdims=True))
    ways = np.zeros((4, 3, 4))
    np.add.at(ways, (data.states, data.actions, data.next_states), 1)
    close(ways[:3] / visits[:, :, None], model.p[:3], visits[:, :, None])
    returns = data.returns(0.9)
    exact = policy_evaluation(model, behaviour, 0.9, horizon=6).start
    assert abs(returns.mean() - exact) < 4 * returns.std() / np.sqrt(len(returns))


def test_seeds_and_limits() -> None:
    """The same seed gives the same data; the limit is that of the task, or the one that is given."""
    model = finite_model(make_mdp("Boulder", height=3, max_steps=20))
    policy = np.full(model.successors.shape[:2], 0.5)
    one, same, other = (collect(model, policy, 50, seed=seed) for seed in (1, 1, 2))
    assert np.array_equal(one.actions, same.actions)
    assert not np.array_equal(one.actions[:50], other.actions[:50])
    assert (one.ends - one.starts + 1).max() == 20
    short = collect(model, policy, 50, max_steps=4, seed=1)
    assert (short.ends - short.starts + 1).max() == 4
    assert not np.array_equal(collect(model, policy, 50).actions[:50], collect(model, policy, 50).actions[:50])


def test_episodes_that_never_end_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """Staying pays for ever."""
    model = finite_model(LOOP)
    with pytest.raises(ValueError, match=named("max_steps", 10_000_000, 20_000, "2 of 2")):
        collect(model, np.ones(len(model.states), int), 2)
    monkeypatch.setattr(dataset, "MOST_STEPS", 100)
    with pytest.raises(ValueError, match=named("max_steps", 100, "after 2 steps", "50 of 50")):
        collect(model, np.ones(len(model.states), int), 50, max_steps=3)


@pytest.mark.parametrize(
    ("change", "names"),
    [
        ({"states": [], "actions": []}, ("states", "[]")),
        ({"states": [0, 1, 0, 3]}, ("states", 0, 2, 3)),
        ({"next_states": [0.5, 2, 2, 1]}, ("next_states", 0, 2, 0.5)),
        ({"next_states": [2, 2, 2, 1]}, ("next_states", "step 0", 2, 1)),
        ({"actions": [1, 0, 2, 0]}, ("actions", 0, 1, 2)),
        ({"rewards": [1, 2, np.nan, 0]}, ("rewards", "finite", "nan")),
        ({"rewards": [1, 2]}, ("rewards", "(4,)")),
        ({"probabilities": [0.5, 0.0, 1, 1]}, ("probabilities", 0, 1, 0.0)),
        ({"probabilities": [0.5, 1.5, 1, 1]}, ("probabilities", 0, 1, 1.5)),
        ({"terminated": [0, 1, 1, 2]}, ("terminated", 4)),
        ({"truncated": [False, True, False, True]}, ("truncated", "terminated")),
        ({"truncated": [False] * 4}, ("terminated", "truncated", "last")),
        ({"n_states": 0}, ("n_states", 1, 0)),
        ({"n_actions": 1}, ("actions", 0, 0, 1)),
    ],
)
def test_bad_steps_are_named(change: dict[str, Any], names: tuple[Any, ...]) -> None:
    """The message names the parameter, what is allowed and what was given."""
    with pytest.raises(ValueError, match=named(*names)):
        by_hand(**change)


@pytest.mark.parametrize(
    ("given", "names"),
    [
        ({"policy": [0, 1]}, ("policy", "(4, 2)")),
        ({"n_episodes": 0}, ("n_episodes", 1, 0)),
        ({"max_steps": 0}, ("max_steps", 1, 0)),
        ({"seed": -1}, ("seed", 0, -1)),
        ({"model": None}, ("model", "FiniteModel")),
        ({"model": random_model(0)}, ("model", "terminal")),
    ],
)
def test_bad_calls_are_named(given: dict[str, Any], names: tuple[Any, ...]) -> None:
    """Of `collect`."""
    usual: dict[str, Any] = {"model": going_on(random_model(0)), "policy": [0, 0, 0, 0], "n_episodes": 3}
    with pytest.raises(ValueError, match=named(*names)):
        collect(**(usual | given))
