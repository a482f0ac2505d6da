"""A challenge for a class: the best profile with one table, and nothing tuned.

`edugym profile my_agent.py:MyAgent --one-table` checks the rules and ranks the agent among those of the package.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
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
from edugym.training.train import train
from edugym_course import agent_profiles
from edugym_course.grading.challenge import Sizes
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.student_code import student_code

ROOM = 50
"""So many numbers an agent may keep beside its table: its settings, and a window of the last few steps."""
TRIED = 1_000
"""The training steps in each challenge after which what an agent keeps is counted."""


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


def check_rules(agents: Mapping[str, Any], ladders: Sequence[Ladder]) -> None:
    """Refuse an agent that breaks a rule.

    Args:
        agents: as `by_the_rules` gives them.
        ladders: those that it will climb.

    Raises:
        ValueError: it names the rule, and what breaks it; or the agent's code raises an error, or does not end.
    """
    try:
        _check_rules(agents, ladders)
    except WrongAnswer as error:
        raise ValueError(str(error)) from error


def _check_rules(agents: Mapping[str, Any], ladders: Sequence[Ladder]) -> None:
    for label, make in agents.items():
        _check_settings(label, make, ladders)
        for ladder in ladders:
            task = ladder.make(ladder.strengths[0], layout_seed=0)
            with student_code(f"training {label} in {ladder.name}"):
                agent = make(task)
                takes_rows = contract_of(agent).tabular
                trained = train(task, agent, TRIED, evaluate_every=TRIED).agent if takes_rows else agent
            if not takes_rows:
                raise ValueError(f"rule 1, one table: {label} must take observations as rows, but `tabular` is False")
            _check_one_table(label, trained, table_size(task), ladder.name)


def _check_one_table(label: str, agent: Any, shape: tuple[int, int], where: str) -> None:
    """Refuse an agent that keeps more numbers than one table has."""
    entries = math.prod(shape)
    kept = {name: numbers_in(part) for name, part in parts_of(agent)}
    if sum(kept.values()) > entries + ROOM:
        largest = sorted(kept, key=lambda name: -kept[name])[:3]
        listed = ", ".join(f"{name} {kept[name]:,}" for name in largest)
        raise ValueError(
            f"rule 1, one table: {label} may keep {entries:,} numbers in {where}, one for each state and action, and"
            f" {ROOM} beside them, but after {TRIED:,} steps it keeps {sum(kept.values()):,} ({listed})"
        )


def _check_settings(label: str, make: Any, ladders: Sequence[Ladder]) -> None:
    """Refuse an agent whose settings depend on the task."""
    first: dict[str, tuple[Any, str]] = {}
    for ladder in ladders:
        for strength in ladder.strengths:
            task = ladder.make(strength, layout_seed=0)
            sizes = table_size(task)
            with student_code(f"making {label} for {ladder.name}"):
                agent = make(task)
            for name, value in settings_in(agent):
                if any(value == size for size in (*sizes, math.prod(sizes))):
                    continue
                before, where = first.setdefault(name, (value, ladder.name))
                if value != before:
                    raise ValueError(
                        f"rule 2, nothing tuned: the settings of {label} must be the same in every task, but {name} is"
                        f" {before!r} in {where} and {value!r} in {ladder.name}"
                    )


def parts_of(value: Any) -> Iterator[tuple[str, Any]]:
    """The parts of something that an agent keeps, with their names; none of a number, an array or a function."""
    if isinstance(value, Mapping):
        yield from ((str(key), part) for key, part in value.items())
    elif hasattr(value, "_asdict"):
        yield from value._asdict().items()
    elif not isinstance(value, str | bytes | np.ndarray) and isinstance(value, Sequence | set | frozenset):
        yield from ((str(place), part) for place, part in enumerate(value))
    elif not isinstance(value, type) and not callable(value):
        slots = [name for kind in type(value).__mro__ for name in getattr(kind, "__slots__", ())]
        yield from getattr(value, "__dict__", {}).items()
        kept = [name for name in slots if not name.startswith("__") and hasattr(value, name)]
        yield from ((name, getattr(value, name)) for name in kept)


def numbers_in(value: Any) -> int:
    """How many numbers and texts are kept in something; the keys of a dictionary do not count."""
    if isinstance(value, np.ndarray):
        return int(value.size)
    if value is None or isinstance(value, bool | int | float | complex | str | bytes | np.generic):
        return 1
    return sum(numbers_in(part) for _, part in parts_of(value))


def settings_in(value: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    """The numbers and texts in a new agent, with the way to each; of an array, the value with which it is filled."""
    if isinstance(value, np.ndarray):
        if value.size and (value == value.flat[0]).all():
            yield f"the first value of {name}", value.flat[0].item()
    elif isinstance(value, bool | int | float | str | np.generic):
        yield name, value
    else:
        for part, inside in parts_of(value):
            yield from settings_in(inside, f"{name}.{part}" if name else part)


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
