"""Profiles of agents that choose their settings, on other seeds and layouts than those that are scored."""

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.parameters import a_path, in_short, whole_number
from edugym.experiments.profiles.ladders import Ladder, steps_of
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.scores import Profile
from edugym.experiments.repeat import MOST_REPETITIONS
from edugym.system.memory import in_digits


class Tuned(NamedTuple):
    """A profile of agents with settings of their own choice.

    Attributes:
        profile: the scores with the chosen settings.
        chosen: for each agent and each challenge that it can enter, the setting that it chose.
        tuning: the profile by which it chose; its agents are called "label: setting".
    """

    profile: Profile
    chosen: dict[str, dict[str, str]]
    tuning: Profile


def tuned_profile(
    grids: Mapping[str, Mapping[str, Any]],
    *,
    tuning_repetitions: int = 3,
    challenges: Sequence[str | Ladder] | None = None,
    repetitions: int = 10,
    seed: int = 0,
    jobs: int | None = -1,
    progress: bool = False,
    checkpoints: str | os.PathLike[str] | None = None,
) -> Tuned:
    """Profile agents each of which chooses, for every challenge, the best of its settings.

        grid = {f"α = {rate}": partial(QLearning.create, learning_rate=rate) for rate in (0.1, 0.5)}
        edugym.tuned_profile({"Q-learning": grid}).profile

    It chooses by the mean score over the ladder, measured on other seeds and layouts than those that are scored then.
    (What is tuned on the runs that are scored looks better than it is.)

    Args:
        grids: a dictionary from labels to the settings of an agent: a dictionary from their names to agents, as
            `edugym.profile` takes them.
        tuning_repetitions: the number of runs of each setting on each rung, by which it chooses; 1 to 1 000 000.
        challenges: this and the others are as in `edugym.profile`.
        repetitions: the number of runs that are scored on each rung.
        seed: as in `edugym.profile`.
        jobs: as in `edugym.profile`.
        progress: as in `edugym.profile`.
        checkpoints: as in `edugym.profile`.

    Raises:
        ValueError: an argument is not as above.
        OSError: a checkpoint cannot be written.
        Interrupted: Ctrl-C was pressed.
    """
    allowed = "grids must be a dictionary from labels to dictionaries of agents by their settings, but"
    if not isinstance(grids, Mapping) or not grids:
        raise ValueError(f"{allowed} is {in_short(grids)}")
    for label, grid in grids.items():
        if not isinstance(grid, Mapping) or not grid:
            raise ValueError(f"{allowed} {label!r} has {in_short(grid)}")
    tuning_repetitions = whole_number("tuning_repetitions", tuning_repetitions, 1, MOST_REPETITIONS)
    repetitions = whole_number("repetitions", repetitions, 1, MOST_REPETITIONS)
    seed = whole_number("seed", seed, 0)
    folder: Path | None = None if checkpoints is None else a_path("checkpoints", checkpoints)
    how: dict[str, Any] = {"jobs": jobs, "progress": progress, "checkpoints": folder}
    candidates = {named(label, setting): agent for label, grid in grids.items() for setting, agent in grid.items()}
    tuning = profile(candidates, challenges=challenges, repetitions=tuning_repetitions, seed=other_seed(seed), **how)
    chosen: dict[str, dict[str, str]] = {label: {} for label in grids}
    blank: dict[str, dict[str, str]] = {label: {} for label in grids}
    parts = []
    for ladder in tuning.ladders:
        for label, grid in grids.items():
            scores = {setting: tuning.score(named(label, setting), ladder.name) for setting in grid}
            entered = {setting: score.estimate for setting, score in scores.items() if score.n}
            if entered:
                chosen[label][ladder.name] = max(entered, key=lambda setting: entered[setting])
            else:
                blank[label][ladder.name] = tuning.blank[named(label, next(iter(grid)))][ladder.name]
        agents = {label: grids[label][own[ladder.name]] for label, own in chosen.items() if ladder.name in own}
        if agents:
            found = profile(agents, challenges=[ladder], repetitions=repetitions, seed=seed, **how)
            parts.append(found.runs)
            for label, failed in found.blank.items():  # while it trained with other seeds
                blank[label] |= failed
    import pandas

    runs = pandas.concat(parts, ignore_index=True)
    settings = _said(grids, tuning, tuning_repetitions, chosen)
    return Tuned(Profile(runs, tuning.ladders, tuple(grids), blank, settings), chosen, tuning)


def _said(
    grids: Mapping[str, Mapping[str, Any]], tuning: Profile, repetitions: int, chosen: dict[str, dict[str, str]]
) -> str:
    """How the agents chose, among what, what it cost, and what they took."""
    said = [
        f"An agent chose for each challenge the settings with the best mean score, by {repetitions} runs of each on"
        " every rung, with other seeds and layouts than those that are scored."
    ]
    for label, grid in grids.items():
        entered = [ladder for ladder in tuning.ladders if ladder.name in chosen[label]]
        rungs = sum(steps_of(ladder, strength) for ladder in entered for strength in ladder.strengths)
        steps = in_digits(repetitions * len(grid) * rungs)
        taken: dict[str, list[str]] = {}
        for challenge, setting in chosen[label].items():
            taken.setdefault(setting, []).append(challenge)
        fell = "; ".join(f"{setting} ({', '.join(challenges)})" for setting, challenges in taken.items())
        said.append(f"{label} had the choice of: {'; '.join(grid)}. It tried them for {steps} steps, and took: {fell}.")
    return " ".join(said)


def with_untuned(untuned: Profile, tuned: Tuned) -> Profile:
    """Both profiles in one, to be seen beside each other; the agents that chose have another label."""
    import pandas

    labels = {agent: f"tuned {agent}" for agent in tuned.profile.agents}
    runs = tuned.profile.runs.replace({"agent": labels})
    blank = {labels[agent]: reasons for agent, reasons in tuned.profile.blank.items()}
    return Profile(
        pandas.concat([untuned.runs, runs], ignore_index=True),
        untuned.ladders,
        (*untuned.agents, *labels.values()),
        untuned.blank | blank,
        f"Agents that are not called tuned have their settings as given; the others chose. {tuned.profile.settings}",
    )


def named(label: str, setting: str) -> str:
    """What an agent with a setting is called while it is tuned."""
    return f"{label}: {setting}"


def other_seed(seed: int) -> int:
    """A seed whose repetitions have other seeds and layouts than those of `seed`."""
    return int(np.random.SeedSequence([seed, 1]).generate_state(1)[0])
