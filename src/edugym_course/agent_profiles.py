"""The profiles of the package's agents and of libraries', stored with the package: a new agent is seen beside them.

`edugym profile --all` makes what is missing of the package's, and those parts again whose code has changed; `edugym
profile --libraries` does the same for the agents of Stable-Baselines3, which takes hours.
"""

import ast
import hashlib
import inspect
import json
import os
from collections.abc import Iterable, Mapping
from functools import lru_cache, partial
from pathlib import Path
from types import MappingProxyType
from typing import Any

import edugym
from edugym import GaussianActorCritic, Profile, TileCoding, profile
from edugym.adapters.registration import ENVIRONMENTS
from edugym.experiments.fingerprints import DEEP, version_of, versions
from edugym.experiments.profiles.ladders import LADDERS, Ladder
from edugym.experiments.profiles.profile import why_not_entered
from edugym.experiments.profiles.scores import COLUMNS, KEPT
from edugym.system.files import write_whole
from edugym_course.stored import source, what_determines

PATH = Path(__file__).with_suffix(".csv")
"""The scores of all runs; the JSON file beside it says from which code and with which versions they were made."""
DIGITS = 4
REPETITIONS = 10
LIBRARY_REPETITIONS = 3
"""Of agents of libraries, which take hours: their intervals are wide."""
LIBRARY_AGENTS = {f"SB3 {algorithm}": algorithm for algorithm in ("DQN", "PPO", "A2C", "QRDQN", "RecurrentPPO")}
"""The agents of Stable-Baselines3 and sb3-contrib: what they are called here, and there."""
LIBRARY_CODE = ("edugym.deep.library", "edugym.deep.vec_env")
"""The modules that determine how those fare, with what they import of their room."""
WRIST = (1, 1, 9, 9, 1, 1, 2)
"""Cells over the wrist of Trashbot's arm and what it holds: its seven numbers have too many at the defaults."""
SETTINGS: dict[str, Any] = {"GaussianActorCritic": WRIST}
"""What is not at its default, by agent."""

NOTHING: Mapping[str, Any] = MappingProxyType({})

Parts = dict[str, list[Ladder]]
"""For each agent, ladders."""


def agents() -> dict[str, Any]:
    """The agents of the package, by name: functions that make one at its defaults (except `SETTINGS`)."""
    kinds = {name: getattr(edugym, name) for name in dir(edugym) if hasattr(getattr(edugym, name), "learn")}
    return {name: kind.create for name, kind in kinds.items()} | {"GaussianActorCritic": on_tiles}


def with_ladders() -> str:
    """Say how many environments have a ladder, in a sentence."""
    count = f"{len(LADDERS)} of the {len(ENVIRONMENTS)} environments"
    return f"For {count} there is a ladder of tasks, from easy to hopeless."


def on_tiles(environment: Any, **settings: Any) -> GaussianActorCritic:
    """An actor-critic with real-valued actions, on tiles over the wrist."""
    tiles = TileCoding.create(environment, tiles=list(WRIST))
    return GaussianActorCritic.create(environment, **{"features": tiles} | settings)


def kind_of(make: Any) -> Any:
    """The class of the agents that a function of `agents` makes; None for any other function."""
    return GaussianActorCritic if make is on_tiles else getattr(make, "__self__", None)


def abouts(given: Mapping[str, Any] = NOTHING) -> dict[str, str]:
    """What agents are, in a line, by name: those of the package and of libraries, and those that were given.

    Args:
        given: functions that make agents, by label; a pair of one and a wrapper counts as the agent.
    """
    found = {name: _first_line(getattr(edugym, name)) for name in agents()}
    for name in SETTINGS.keys() & found.keys():
        found[name] = f"{found[name].rstrip('.')}; here with tiles for Trashbot's arm ({', '.join(map(str, WRIST))})."
    found |= {name: f"{algorithm} of {_library_of(algorithm)}" for name, algorithm in LIBRARY_AGENTS.items()}
    makers = {label: agent[0] if type(agent) is tuple else agent for label, agent in given.items()}
    return {label: _first_line(make) or "yours" for label, make in makers.items()} | found


def _first_line(agent: Any) -> str:
    """The first line of the docstring of a class, or of the class whose method this is; "" where it has none."""
    kind = kind_of(agent) or agent
    text = (inspect.getdoc(kind) or "").partition("\n")[0]
    return "" if text.startswith(f"{getattr(kind, '__name__', '')}(") else text  # a NamedTuple lists its fields there


def _library_of(algorithm: str) -> str:
    return "sb3-contrib" if algorithm in ("QRDQN", "RecurrentPPO") else "Stable-Baselines3"


def library_agents() -> dict[str, Any]:
    """The agents of libraries, by name: functions that make one as its library does, with one copy of the task."""
    return {name: partial(_of_library, algorithm) for name, algorithm in LIBRARY_AGENTS.items()}


def _of_library(algorithm: str, environment: Any) -> Any:
    from edugym.deep.library import LibraryAgent

    return LibraryAgent.create(environment, algorithm)


def code_of(agent: str, ladder: Ladder) -> str:
    """A hash of what determines how an agent fares on a ladder: its code, that of the task, and the rungs."""
    tasks = [entry.module for entry in ENVIRONMENTS if entry.name == ladder.name]
    if agent in LIBRARY_AGENTS:
        modules = [*_with_imports(*LIBRARY_CODE), *tasks]
    else:
        modules = [*_with_imports(getattr(edugym, agent).__module__), *tasks, "edugym.training.loops"]
    code = [inspect.getsource(ladder.make), *(source(module).read_text(encoding="utf-8") for module in modules)]
    parts = [what_determines(part, shown=("scene", "info")) for part in code]
    bounds = ladder.bounds and [[round(bound, 6) for bound in ladder.bounds(strength)] for strength in ladder.strengths]
    rungs = (ladder.strengths, ladder.n_steps, ladder.evaluation_episodes, ladder.one_layout, bounds)
    return hashlib.sha256("\n".join([*parts, repr((rungs, SETTINGS.get(agent)))]).encode()).hexdigest()[:16]


def _with_imports(*modules: str) -> list[str]:
    """Modules of agents, and those of the rooms of agents that they import, directly or not."""
    found = [*modules]
    for name in found:  # grows on the way
        found += [other for other in _imported(source(name).read_text(encoding="utf-8")) if other not in found]
    return sorted(found)


@lru_cache(256)
def _imported(code: str) -> tuple[str, ...]:
    """The modules of the rooms of agents from which code imports."""
    modules = (part.module or "" for part in ast.walk(ast.parse(code)) if isinstance(part, ast.ImportFrom))
    return tuple(dict.fromkeys(name for name in modules if name.startswith(("edugym.agents.", "edugym.deep."))))


def library_versions() -> dict[str, str]:
    """The versions of the libraries that are installed; builds of one version count as one."""
    return {name: version.partition("+")[0] for name in DEEP if (version := version_of(name))}


def stale() -> Parts:
    """The ladders on which an agent of the package was not measured, or with other code; other agents are left out."""
    return _stale(agents())


def stale_of_libraries(installed: bool = True) -> Parts:
    """The ladders on which an agent of a library was not measured, or with other code; agents without any are left out.

    Args:
        installed: whether one that was measured with another version than that installed here counts too.
    """
    found = _stale(LIBRARY_AGENTS)
    here, made = library_versions() if installed else {}, _about().get("libraries", {}) if PATH.exists() else {}
    for name, ladders in made.items():
        other = [ladder for ladder in LADDERS if _differ(here, ladders.get(ladder.name, {}))]
        found[name] = [ladder for ladder in LADDERS if ladder in [*found.get(name, []), *other]]
    return {name: ladders for name, ladders in found.items() if ladders}


def _differ(here: dict[str, str], there: dict[str, str]) -> bool:
    return any(here[name] != there[name] for name in here.keys() & there.keys())


def _stale(names: Iterable[str]) -> Parts:
    made = _about()["code"] if PATH.exists() else {}
    found = {
        name: [ladder for ladder in LADDERS if made.get(name, {}).get(ladder.name) != code_of(name, ladder)]
        for name in names
    }
    return {name: ladders for name, ladders in found.items() if ladders}


def load() -> Profile | None:
    """The stored profile of all agents of the package, and of those of libraries that were measured on some ladder.

    It has the scores, not the returns. It is None where nothing is stored.
    """
    if not PATH.exists():
        return None
    import pandas

    runs, blank = pandas.read_csv(PATH), _about()["blank"]
    measured = {*runs["agent"]}
    names = (*agents(), *(name for name in LIBRARY_AGENTS if name in measured))
    runs = runs[runs["agent"].isin(names)].reindex(columns=list(COLUMNS))
    return Profile(runs, LADDERS, names, {name: blank.get(name, {}) for name in names})


def made_with() -> str:
    """The versions with which the agents of the package were measured; where they differ, with the agents."""
    agents_with: dict[str, list[str]] = {}
    for name, used in sorted(_about()["versions"].items()):
        agents_with.setdefault(used, []).append(name)
    if len(agents_with) == 1:
        return next(iter(agents_with))
    return "; ".join(f"{used} ({', '.join(names)})" for used, names in agents_with.items())


def libraries_with() -> str:
    """The versions of libraries with which their agents were measured; "" where none was."""
    made = _about().get("libraries", {})
    found = {
        f"{name} {version}"
        for ladders in made.values()
        for about in ladders.values()
        for name, version in about.items()
    }
    return ", ".join(sorted(found))


def make_again(parts: Parts, checkpoints: str | os.PathLike[str], **how: Any) -> Profile:
    """Make parts of profiles again, and store those of an agent (of a library: each ladder) as soon as they are done.

    Args:
        parts: for each agent, ladders.
        checkpoints: the folder for what is done, if it is interrupted.
        how: more arguments of `edugym.profile`.
    """
    for name, ladders in parts.items():
        if name in LIBRARY_AGENTS:
            for ladder in ladders:
                _make(name, library_agents()[name], [ladder], LIBRARY_REPETITIONS, checkpoints, how)
        else:
            _make(name, agents()[name], ladders, REPETITIONS, checkpoints, how)
    stored = load()
    assert stored is not None
    return stored


def _make(
    name: str,
    make: Any,
    ladders: list[Ladder],
    repetitions: int,
    checkpoints: str | os.PathLike[str],
    how: dict[str, Any],
) -> None:
    """Measure an agent on ladders, and store the result."""
    agent = {name: make}
    blank = why_not_entered(agent, ladders)[name]
    entered = [ladder for ladder in ladders if ladder.name not in blank]
    runs: list[Any] = []
    if entered:
        found = profile(agent, challenges=entered, repetitions=repetitions, checkpoints=checkpoints, **how)
        runs = found.runs[list(KEPT)].round({"score": DIGITS}).to_dict("records")
    store(name, runs, {ladder.name: code_of(name, ladder) for ladder in ladders}, blank)


def store(name: str, runs: list[Any], code: dict[str, str], blank: dict[str, str]) -> None:
    """Put what is new of an agent in the place of the old.

    Args:
        name: the agent.
        runs: its rows, as `KEPT` says.
        code: for each ladder that was tried, `code_of` it.
        blank: the ladders that it cannot enter, with the reason.
    """
    import pandas

    rows = pandas.DataFrame(runs, columns=list(KEPT))
    about: dict[str, Any] = {"versions": {}, "code": {}, "blank": {}, "libraries": {}}
    if PATH.exists():
        old = pandas.read_csv(PATH)
        old = old[(old["agent"] != name) | ~old["challenge"].isin([*code])]
        rows = pandas.concat([part for part in (old, rows) if len(part)]).sort_values("agent", kind="stable")
        about |= _about()
    if name in LIBRARY_AGENTS:
        about["libraries"].setdefault(name, {}).update(dict.fromkeys(code, library_versions()))
    else:
        about["versions"][name] = versions()
    about["code"][name] = about["code"].get(name, {}) | code
    before = about["blank"].get(name, {})
    about["blank"][name] = {challenge: why for challenge, why in before.items() if challenge not in code} | blank
    write_whole(PATH, rows.to_csv(index=False, lineterminator="\n", float_format="%.5g").encode())
    write_whole(PATH.with_suffix(".json"), (json.dumps(about, indent=1, sort_keys=True) + "\n").encode())


def _about() -> dict[str, Any]:
    about: dict[str, Any] = json.loads(PATH.with_suffix(".json").read_text(encoding="utf-8"))
    return about
