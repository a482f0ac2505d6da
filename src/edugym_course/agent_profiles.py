"""The profiles of the package's agents, stored with the package, so that a new agent is seen beside them.

`edugym profile --all` makes what is missing, and those parts again whose code has changed.
"""

import ast
import hashlib
import inspect
import json
import os
from pathlib import Path
from typing import Any

import edugym
from edugym import GaussianActorCritic, Profile, TileCoding, profile
from edugym.adapters.registration import ENVIRONMENTS
from edugym.experiments.fingerprints import versions
from edugym.experiments.profiles.ladders import LADDERS, Ladder
from edugym.experiments.profiles.profile import why_not_entered
from edugym.experiments.profiles.scores import COLUMNS
from edugym.system.files import write_whole
from edugym_course.stored import source, what_determines

PATH = Path(__file__).with_suffix(".csv")
"""The scores of all runs; the JSON file beside it says from which code and with which versions they were made."""
KEPT = ("agent", "challenge", "strength", "repetition", "score", "steps_to_0.9")
DIGITS = 4
REPETITIONS = 10
WRIST = (1, 1, 9, 9, 1, 1, 2)
"""Cells over the wrist of Trashbot's arm and what it holds: its seven numbers have too many at the defaults."""
SETTINGS: dict[str, Any] = {"GaussianActorCritic": WRIST}
"""What is not at its default, by agent."""

TOO_SLOW = {"RMax": ["Switches"]}
"""Ladders that are not measured, by agent: hours of planning, over every pair of a state and a goal."""


def agents() -> dict[str, Any]:
    """The agents of the package, by name: functions that make one at its defaults (except `SETTINGS`)."""
    kinds = {name: getattr(edugym, name) for name in dir(edugym) if hasattr(getattr(edugym, name), "learn")}
    return {name: kind.create for name, kind in kinds.items()} | {"GaussianActorCritic": on_tiles}


def on_tiles(environment: Any) -> GaussianActorCritic:
    """An actor-critic with real-valued actions, on tiles over the wrist."""
    return GaussianActorCritic.create(environment, features=TileCoding.create(environment, tiles=list(WRIST)))


def code_of(agent: str, ladder: Ladder) -> str:
    """A hash of what determines how an agent fares on a ladder: its code, that of the task, and the rungs."""
    tasks = [entry.module for entry in ENVIRONMENTS if entry.name == ladder.name]
    modules = [*_with_imports(getattr(edugym, agent).__module__), *tasks, "edugym.training.loops"]
    code = [inspect.getsource(ladder.make), *(source(module).read_text(encoding="utf-8") for module in modules)]
    parts = [what_determines(part, shown=("scene", "info")) for part in code]
    bounds = ladder.bounds and [[round(bound, 6) for bound in ladder.bounds(strength)] for strength in ladder.strengths]
    rungs = (ladder.strengths, ladder.n_steps, ladder.evaluation_episodes, ladder.one_layout, bounds)
    return hashlib.sha256("\n".join([*parts, repr((rungs, SETTINGS.get(agent)))]).encode()).hexdigest()[:16]


def _with_imports(module: str) -> list[str]:
    """A module of an agent, and those of the room of agents that it imports, directly or not."""
    found = [module]
    for name in found:  # grows on the way
        for part in ast.walk(ast.parse(source(name).read_text(encoding="utf-8"))):
            other = part.module if isinstance(part, ast.ImportFrom) else None
            if other and other.startswith("edugym.agents.") and other not in found:
                found.append(other)
    return sorted(found)


def stale() -> dict[str, list[Ladder]]:
    """The ladders on which an agent was not measured, or with other code; agents without any are left out.

    Those that are `TOO_SLOW` do not count.
    """
    made = _about()["code"] if PATH.exists() else {}
    found = {
        name: [
            ladder
            for ladder in LADDERS
            if ladder.name not in TOO_SLOW.get(name, [])
            and made.get(name, {}).get(ladder.name) != code_of(name, ladder)
        ]
        for name in agents()
    }
    return {name: ladders for name, ladders in found.items() if ladders}


def load() -> Profile | None:
    """The stored profile of all agents of the package; None where nothing is stored.

    It has the scores, not the returns.
    """
    if not PATH.exists():
        return None
    import pandas

    runs = pandas.read_csv(PATH)
    names, blank = tuple(agents()), _about()["blank"]
    runs = runs[runs["agent"].isin(names)].reindex(columns=list(COLUMNS))
    return Profile(runs, LADDERS, names, {name: blank.get(name, {}) for name in names})


def made_with() -> str:
    """The versions with which the stored profile was made."""
    return str(_about()["versions"])


def make_again(parts: dict[str, list[Ladder]], checkpoints: str | os.PathLike[str], **how: Any) -> Profile:
    """Make parts of profiles again, and store those of an agent as soon as they are done.

    Args:
        parts: for each agent, ladders.
        checkpoints: the folder for what is done, if it is interrupted.
        how: more arguments of `edugym.profile`.
    """
    for name, ladders in parts.items():
        agent = {name: agents()[name]}
        blank = why_not_entered(agent, ladders)[name]
        entered = [ladder for ladder in ladders if ladder.name not in blank]
        runs: list[Any] = []
        if entered:
            found = profile(agent, challenges=entered, repetitions=REPETITIONS, checkpoints=checkpoints, **how)
            runs = found.runs[list(KEPT)].round({"score": DIGITS}).to_dict("records")
        _store(name, runs, {ladder.name: code_of(name, ladder) for ladder in ladders}, blank)
    stored = load()
    assert stored is not None
    return stored


def _store(name: str, runs: list[Any], code: dict[str, str], blank: dict[str, str]) -> None:
    """Put what is new of an agent in the place of the old."""
    import pandas

    rows = pandas.DataFrame(runs, columns=list(KEPT))
    about: dict[str, Any] = {"versions": "", "code": {}, "blank": {}}
    if PATH.exists():
        old = pandas.read_csv(PATH)
        old = old[(old["agent"] != name) | ~old["challenge"].isin([*code])]
        rows = pandas.concat([part for part in (old, rows) if len(part)]).sort_values("agent", kind="stable")
        about = _about()
    about["versions"] = versions()
    about["code"][name] = about["code"].get(name, {}) | code
    before = about["blank"].get(name, {})
    about["blank"][name] = {challenge: why for challenge, why in before.items() if challenge not in code} | blank
    write_whole(PATH, rows.to_csv(index=False, lineterminator="\n", float_format="%.5g").encode())
    write_whole(PATH.with_suffix(".json"), (json.dumps(about, indent=1, sort_keys=True) + "\n").encode())


def _about() -> dict[str, Any]:
    about: dict[str, Any] = json.loads(PATH.with_suffix(".json").read_text(encoding="utf-8"))
    return about
