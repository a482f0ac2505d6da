"""Datasets of Minari, the standard for data of reinforcement learning: written, and read."""

import re
import warnings
from functools import partial
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.agents.dataset import Dataset, require_dataset
from edugym.checks.parameters import a_text, in_short
from edugym.exact.branching import branches
from edugym.exact.policy_evaluation import as_probabilities
from edugym.exact.tables import FiniteModel
from edugym.exact.values import require_model
from edugym.system.extras import require

NAME = re.compile(r"([-_\w]+/)*[-_\w]+-v\d+")
PROBABILITY = "behaviour_probability"
"""The key of `infos` under which b(A|S) is kept; the last of an episode, after which nothing is done, is 1."""

Key = tuple[float, ...]


def write_minari(dataset: Dataset, model: FiniteModel, name: str, *, environment: Any = None, **about: Any) -> Any:
    """Write a dataset into Minari's folder, for every program that reads Minari.

    It holds the observations, not the rows of states, and the probabilities with which actions were taken, as
    `infos["behaviour_probability"]`. Minari's folder is `~/.minari/datasets`, or the one that the environment variable
    `MINARI_DATASETS_PATH` names.

    Args:
        dataset: the steps.
        model: the model by whose rows the dataset goes. It knows its task, whose observations are numbers that do not
            come by chance.
        name: such as "edugym/roadrunner/random-v0": folders, a name and a version. There must be no such dataset yet.
        environment: an environment of Gymnasium, or its id, which `recover_environment` of Minari then makes; None if
            nobody will ask.
        **about: what else Minari keeps of it, such as `author` and `description`.

    Returns:
        The dataset, as Minari has it.

    Raises:
        gymnasium.error.DependencyNotInstalled: Minari is not installed.
        ValueError: a parameter is not as above, or Minari has such a dataset.
    """
    require_dataset(dataset)
    observations = _observations(model)
    if (dataset.n_states, dataset.n_actions) != model.successors.shape[:2]:
        raise ValueError(f"model must be the one by whose rows {dataset} goes, but is {model}")
    if not NAME.fullmatch(a_text("name", name)):
        raise ValueError(f"name must be like 'edugym/roadrunner/random-v0', with a version, but is {in_short(name)}")
    if not (environment is None or isinstance(environment, str | gymnasium.Env)):
        raise ValueError(f"environment must be one of Gymnasium, or its id, but is {in_short(environment)}")
    require("data", "minari", "h5py")
    import minari
    from minari.data_collector.episode_buffer import EpisodeBuffer

    mdp: Any = model.mdp
    shown = np.array(observations, mdp.observation_space.dtype)
    buffers = []
    for number, (start, end) in enumerate(zip(dataset.starts, dataset.ends, strict=True)):
        steps = slice(start, end + 1)
        rows = np.append(dataset.states[steps], dataset.next_states[end])
        buffers.append(
            EpisodeBuffer(
                id=number,
                observations=shown[rows],
                actions=dataset.actions[steps].astype(mdp.action_space.dtype),
                rewards=dataset.rewards[steps],
                terminations=dataset.terminated[steps],
                truncations=dataset.truncated[steps],
                infos={PROBABILITY: np.append(dataset.probabilities[steps], 1.0)},
            )
        )
    sizes = {"observation_space": mdp.observation_space, "action_space": mdp.action_space}
    with warnings.catch_warnings():  # Minari recommends to name an author and more, which is up to the user
        warnings.filterwarnings("ignore", message=".* is (set to )?None", category=UserWarning)
        return minari.create_dataset_from_buffers(name, buffers, env=environment, **sizes, **about)


def read_minari(dataset: Any, model: FiniteModel, behaviour: Any = None) -> Dataset:
    """Read a dataset of Minari that was made in the task of a model, whoever made it.

    Args:
        dataset: what `minari.load_dataset(name)` gives.
        model: the exact model of the task. It knows its task, whose observations are numbers that do not come by
            chance; no two states in which something can be done look alike.
        behaviour: b, the policy that acted, by the rows of the model: shape (S, A), or shape (S,). None for the
            probabilities that `write_minari` kept; where there are none, b(a|s) is estimated: the share of the actions
            in s that were a.

    Raises:
        gymnasium.error.DependencyNotInstalled: Minari is not installed.
        ValueError: a parameter is not as above; the dataset holds a step that the task cannot take, or an action that
            the policy never takes.
    """
    observations = _observations(model)
    taken = None if behaviour is None else as_probabilities(behaviour, model, "behaviour")
    require("data", "minari", "h5py")
    from minari import MinariDataset

    if not isinstance(dataset, MinariDataset):
        raise ValueError(f"dataset must be what minari.load_dataset(name) gives, but is {in_short(dataset)}")
    ends = {seen: s for s, seen in enumerate(observations) if model.terminal[s]}
    inside = {seen: s for s, seen in enumerate(observations) if not model.terminal[s]}
    if len(inside) < (~model.terminal).sum():
        raise ValueError("model must have observations that tell the state, but in its task two states look alike")
    parts: list[tuple[Any, ...]] = []
    for episode in dataset.iterate_episodes():
        over = bool(episode.terminations[-1])
        keys = [_key(seen) for seen in np.asarray(episode.observations)]
        rows = [_row(seen, inside) for seen in keys[:-1]] + [_row(keys[-1], ends if over else inside)]
        actions = np.asarray(episode.actions, np.int64)
        kept = np.asarray((episode.infos or {}).get(PROBABILITY, np.zeros(len(rows))))[:-1]
        cut = np.asarray(episode.truncations) & ~np.asarray(episode.terminations)
        cut[-1] = not over  # an episode that was broken off when the collecting ended was cut off, too
        parts.append((rows[:-1], actions, episode.rewards, rows[1:], episode.terminations, cut, kept))
    if not parts:
        raise ValueError("dataset must hold an episode, but is empty")
    columns = (np.concatenate(one) for one in zip(*parts, strict=True))
    states, actions, rewards, next_states, terminated, truncated, probabilities = columns
    n_states, n_actions = model.successors.shape[:2]
    if taken is not None:
        probabilities = taken[states, actions]
    elif not probabilities.all():
        visits = np.zeros((n_states, n_actions))
        np.add.at(visits, (states, actions), 1.0)
        probabilities = visits[states, actions] / visits.sum(axis=1)[states]
    if not probabilities.all():
        k = int((probabilities == 0).argmax())
        where = f"{actions[k]} in {model.states[states[k]]}"
        raise ValueError(f"behaviour must take every action of the dataset, but never takes {where}")
    read = Dataset.create(
        states, actions, rewards, next_states, terminated, truncated, probabilities, n_states, n_actions
    )
    _require_possible(read, model)
    return read


def _require_possible(dataset: Dataset, model: FiniteModel) -> None:
    """Check that the task takes such steps.

    Raises:
        ValueError: it does not.
    """
    ways = model.successors[dataset.states, dataset.actions] == dataset.next_states[:, np.newaxis]
    possible = (ways & (model.probabilities[dataset.states, dataset.actions] > 0)).any(axis=1)
    if not possible.all():
        k = int((~possible).argmax())
        before, after = (model.states[rows[k]] for rows in (dataset.states, dataset.next_states))
        raise ValueError(
            f"dataset must be of the task of the model, but holds a step from {before} to {after} after action"
            f" {dataset.actions[k]}, which is not possible there"
        )


def _observations(model: FiniteModel) -> list[Key]:
    """What is observed in each state, as numbers.

    Raises:
        ValueError: the model does not know its task, or that shows something else.
    """
    require_model(model)
    mdp: Any = model.mdp
    if mdp is None:
        raise ValueError("model must know its task, but was made without `mdp`")
    space = mdp.observation_space
    if not isinstance(space, spaces.Discrete | spaces.MultiDiscrete | spaces.MultiBinary | spaces.Box):
        raise ValueError(f"model must be of a task whose observations are numbers, but they are {space}")
    seen = list[Key]()
    for state in model.states:
        ways = list(branches(partial(mdp.observation, state)))
        if len(ways) > 1:
            raise ValueError(f"model must be of a task that shows its states, but in {state!r} chance decides")
        seen.append(_key(ways[0][1]))
    return seen


def _key(observation: Any) -> Key:
    return tuple(np.ravel(np.asarray(observation)).tolist())


def _row(seen: Key, rows: dict[Key, int]) -> int:
    """The row of an observation.

    Raises:
        ValueError: the task never shows it at this place.
    """
    if seen not in rows:
        raise ValueError(f"dataset must be of the task of the model, which never shows {seen} there")
    return rows[seen]
