"""A challenge for a class: the best profile with one table, and nothing tuned.

`edugym profile my_agent.py:MyAgent --one-table` checks the rules and ranks the agent among those of the package.
"""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym import Profile
from edugym.checks.contract import contract_of
from edugym.experiments.profiles.ladders import LADDERS, Ladder
from edugym.experiments.repeat import makers_of
from edugym.experiments.results.statistics import Interval, mean_interval
from edugym.mdp.task import table_size
from edugym_course import agent_profiles
from edugym_course.grading.challenge import Sizes
from edugym_course.one_table_rules import ROOM, numbers_in


class Place(NamedTuple):
    """An agent in the ranking.

    Attributes:
        label: what it is called.
        points: 100 times its mean score over the challenges, with a 95 % interval over the repetitions.
        enters: whether it keeps to the rules; others stand in the ranking without a place.
        submitted: whether it is one that was given, not one of the package.
    """

    label: str
    points: Interval
    enters: bool
    submitted: bool


def ladders() -> tuple[Ladder, ...]:
    """The challenges that a table can enter: those whose observations and actions are whole numbers."""
    fitting = []
    for ladder in LADDERS:
        try:
            table_size(ladder.make(ladder.strengths[0], layout_seed=0))
        except ValueError:
            continue
        fitting.append(ladder)
    return tuple(fitting)


def by_the_rules(agents: Mapping[str, Any]) -> dict[str, Any]:
    """Agents that are told nothing but the sizes of their table; arguments as in `edugym.profile`.

    Raises:
        ValueError: one is given with a wrapper, or not as in `edugym.profile`.
    """
    for label, agent in agents.items():
        if type(agent) is tuple:  # an agent may be a NamedTuple
            raise ValueError(f"an agent with one table sees each task as it is, but {label} has a wrapper")
    return {label: partial(_told_sizes, make) for label, make in makers_of(agents).items()}


def _told_sizes(make: Any, environment: Any) -> Any:
    """An agent that cannot look at the task, plan with it, or take steps of its own."""
    n_states, n_actions = table_size(environment)
    return make(Sizes(spaces.Discrete(n_states), spaces.Discrete(n_actions)))


def ranking(found: Profile, stored: Profile, challenges: Sequence[str]) -> list[Place]:
    """The agents that were given and those of the package, best first.

    Agents of the package that were not measured in every challenge are left out.
    """
    given = [Place(label, points(found, label, challenges), True, True) for label in found.agents]
    return best_first([*given, *of_package(stored, challenges)])


def of_package(stored: Profile, challenges: Sequence[str]) -> list[Place]:
    """The agents of the package, by their stored profiles, best first; those not measured everywhere are left out."""
    own = [label for label in stored.agents if label in agent_profiles.agents()]
    places = [Place(label, points(stored, label, challenges), has_one_table(label), False) for label in own]
    return best_first([place for place in places if place.points.n])


def best_first(places: Sequence[Place]) -> list[Place]:
    """Agents in the order of their points."""
    return sorted(places, key=lambda place: -place.points.estimate)


def points(profile: Profile, agent: str, challenges: Sequence[str]) -> Interval:
    """100 times the mean score of an agent over the challenges; not measured (n = 0) where one is missing."""
    scores = [profile.scores(agent, challenge).mean(axis=0) for challenge in challenges]
    fewest = min(map(len, scores))
    return mean_interval(100 * np.mean([score[:fewest] for score in scores], axis=0))


def has_one_table(name: str) -> bool:
    """Whether an agent of the package keeps to the first rule at its defaults."""
    shape = 1_000, 10  # large enough for any second table to be seen
    try:
        agent = agent_profiles.agents()[name](Sizes(spaces.Discrete(shape[0]), spaces.Discrete(shape[1])))
    except (AttributeError, ValueError):  # it needs to know more than the sizes of a table
        return False
    return contract_of(agent).tabular and numbers_in(agent) <= math.prod(shape) + ROOM


def ranking_table(places: Sequence[Place]) -> tuple[list[str], list[list[str]]]:
    """The heading and the rows of the ranking; only those that keep to the rules have a place."""
    rows, place = [], 0
    for agent in places:
        place += agent.enters
        shown = f"{agent.points.estimate:.1f} [{agent.points.low:.1f}, {agent.points.high:.1f}]"
        name = f"{agent.label} (submitted)" if agent.submitted else agent.label
        rows.append([str(place) if agent.enters else "–", name, shown])
    return ["place", "agent", "points"], rows


def sentences(places: Sequence[Place]) -> list[str]:
    """What to say of each agent that was submitted."""
    entered = [place for place in places if place.enters]
    best = max((one for one in entered if not one.submitted), key=lambda one: one.points.estimate, default=None)
    said = []
    for one in entered:
        if not one.submitted:
            continue
        text = f"{one.label} has {one.points.estimate:.1f} points, place {entered.index(one) + 1} of {len(entered)}"
        if best is not None:
            text += f"; to beat: {best.label} of the package, {best.points.estimate:.1f}"
        said.append(f"{text}.")
    return said
