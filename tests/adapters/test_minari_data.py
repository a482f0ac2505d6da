"""Minari: what is written is read again to the bit, by Minari itself too, and what others wrote is read."""

from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import (
    FiniteModel,
    collect,
    finite_model,
    importance_sampling,
    make_mdp,
    policy_evaluation,
    read_minari,
    write_minari,
)
from edugym.agents.dataset import Dataset
from tests.exact.tasks import random_model
from tests.messages import named

minari = pytest.importorskip("minari")
pytest.importorskip("h5py")

TASKS: dict[str, dict[str, Any]] = {
    "Roadrunner": {"size": 6},
    "Boulder": {"height": 4, "max_steps": 9},
    "Diver": {},
    "Supermarket": {"max_steps": 30},
}


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is written into the folder of whoever runs the tests."""
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(tmp_path))


def at_random(name: str, n_episodes: int = 20, seed: int = 1) -> tuple[FiniteModel, Any, Dataset]:
    """A model, the random policy, and its data."""
    model = finite_model(make_mdp(name, **TASKS[name]))
    policy = np.full(model.successors.shape[:2], 1 / model.successors.shape[1])
    return model, policy, collect(model, policy, n_episodes, seed=seed)


@pytest.mark.parametrize("name", TASKS)
def test_what_is_written_is_read_again(name: str) -> None:
    """To the bit, in each column, by the name that Minari has for it."""
    model, _, dataset = at_random(name)
    write_minari(dataset, model, "edugym/test-v0", description="random")
    loaded = minari.load_dataset("edugym/test-v0")
    assert loaded.total_episodes == 20
    assert loaded.total_steps == len(dataset.states)
    again = read_minari(loaded, model)
    for field in Dataset._fields:
        one, other = (np.asarray(getattr(data, field)) for data in (dataset, again))
        # Terminal states that look alike are one: nothing is ever done there.
        if field == "next_states":
            one, other = (np.where(dataset.terminated, -1, rows) for rows in (one, other))
        assert np.array_equal(one, other), field


def test_minari_recovers_the_environment() -> None:
    """With the parameters of the task; its own spaces hold what was written."""
    model, _, dataset = at_random("Roadrunner")
    environment = gymnasium.make("edugym/Roadrunner-v0", size=6)
    write_minari(dataset, model, "roadrunner/random-v1", environment=environment)
    loaded = minari.load_dataset("roadrunner/random-v1")
    recovered: Any = loaded.recover_environment()
    assert recovered.unwrapped.mdp == model.mdp
    for episode in loaded.iterate_episodes():
        assert all(recovered.observation_space.contains(seen) for seen in episode.observations)
        assert len(episode.observations) == len(episode.actions) + 1


def written_by_another(behaviour: Any, n_episodes: int) -> tuple[FiniteModel, Any]:
    """Steps of the environment itself, kept by Minari's own functions alone."""
    from minari.data_collector.episode_buffer import EpisodeBuffer

    environment: Any = gymnasium.make("edugym/Roadrunner-v0", size=6)
    model, rng = finite_model(environment.unwrapped.mdp), np.random.default_rng(3)
    buffers = []
    for number in range(n_episodes):
        seen, _ = environment.reset(seed=number)
        observations = [seen]
        steps = list[tuple[Any, ...]]()
        while not steps or not any(steps[-1][2:]):
            row = model.row(environment.unwrapped.state)
            action = int(rng.choice(3, p=behaviour[row]))
            seen, reward, terminated, truncated, _ = environment.step(action)
            observations.append(seen)
            steps.append((action, reward, terminated, truncated))
        actions, rewards, ends, cuts = (np.array(column) for column in zip(*steps, strict=True))
        buffers.append(
            EpisodeBuffer(
                id=number,
                observations=np.array(observations),
                actions=actions,
                rewards=rewards,
                terminations=ends,
                truncations=cuts,
            )
        )
    return model, minari.create_dataset_from_buffers("another/data-v0", buffers, env=environment)


@pytest.mark.filterwarnings("ignore:.*None")
def test_what_another_program_wrote_is_read() -> None:
    """With the policy that acted, and with an estimate of it; importance sampling then finds the exact value."""
    model = finite_model(make_mdp("Roadrunner", size=6))
    behaviour = np.random.default_rng(1).dirichlet(np.full(3, 3.0), len(model.states))
    target = 0.5 * behaviour + 0.5 / 3
    _, loaded = written_by_another(behaviour, 400)
    known, estimated = read_minari(loaded, model, behaviour), read_minari(loaded, model)
    assert np.array_equal(known.probabilities, behaviour[known.states, known.actions])
    shares = known.visits / np.maximum(known.visits.sum(axis=1, keepdims=True), 1)
    assert np.array_equal(estimated.probabilities, shares[known.states, known.actions])
    exact = policy_evaluation(model, target, 0.9, horizon=30).start
    found = importance_sampling(known, target, 0.9, method="per decision")
    assert abs(found.value - exact) < 4 * found.standard_error


def test_data_of_another_task_are_refused() -> None:
    """Of a longer road, and of a task whose steps differ."""
    model, policy, dataset = at_random("Roadrunner", 50)
    loaded = write_minari(dataset, model, "edugym/test-v0")
    shorter = finite_model(make_mdp("Roadrunner", size=4))
    with pytest.raises(ValueError, match=named("dataset", "model")):
        read_minari(loaded, shorter)
    backwards = model._replace(successors=model.successors[:, ::-1])
    with pytest.raises(ValueError, match=named("dataset", "model", "action")):
        read_minari(loaded, backwards)
    never = np.where(np.arange(3) == 1, 1.0, 0.0) * np.ones_like(policy)
    with pytest.raises(ValueError, match=named("behaviour", "never takes")):
        read_minari(loaded, model, never)


@pytest.mark.parametrize(
    ("change", "names"),
    [
        ({"name": "random"}, ("name", "random")),
        ({"name": 3}, ("name", 3)),
        ({"model": random_model(0)}, ("model", "mdp")),
        ({"model": None}, ("model", "FiniteModel")),
        ({"dataset": None}, ("dataset", "Dataset")),
        ({"environment": 3}, ("environment", 3)),
    ],
)
def test_bad_arguments_are_named(change: dict[str, Any], names: tuple[Any, ...]) -> None:
    """Nothing is written then."""
    model, _, dataset = at_random("Boulder", 2)
    usual: dict[str, Any] = {"dataset": dataset, "model": model, "name": "edugym/test-v0"}
    with pytest.raises(ValueError, match=named(*names)):
        write_minari(**(usual | change))
    assert not [*minari.list_local_datasets()]


def test_nothing_is_written_over() -> None:
    """A second dataset of the same name is refused, and the first one stays."""
    model, _, dataset = at_random("Boulder", 2)
    write_minari(dataset, model, "edugym/test-v0")
    with pytest.raises(ValueError, match="edugym/test-v0"):
        write_minari(at_random("Boulder", 3)[2], model, "edugym/test-v0")
    assert minari.load_dataset("edugym/test-v0").total_episodes == 2
