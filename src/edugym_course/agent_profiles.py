"""The profiles of the package's agents with tables, stored with the package, so that a new agent is seen beside them.

`edugym profile --all` makes those again whose code has changed.
"""

import ast
import hashlib
import json
import os
from pathlib import Path
from typing import Any

import edugym
from edugym import Profile, profile
from edugym.adapters.registration import ENVIRONMENTS
from edugym.experiments.fingerprints import versions
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.scores import COLUMNS
from edugym.system.files import write_whole
from edugym_course.stored import source, what_determines

PATH = Path(__file__).with_suffix(".csv")
"""The scores of all runs; the JSON file beside it says from which code and with which versions they were made."""
KEPT = ("agent", "challenge", "strength", "repetition", "score", "steps_to_0.9")
DIGITS = 4
REPETITIONS = 10


def agents() -> dict[str, Any]:
    """The agents with tables, by name: functions that make one at its defaults."""
    kinds = {name: getattr(edugym, name) for name in dir(edugym) if hasattr(getattr(edugym, name), "learn")}
    return {name: kind.create for name, kind in kinds.items() if _has_table(kind)}


def _has_table(kind: Any) -> bool:
    try:
        return getattr(kind.create((2, 2)), "tabular", True) is not False
    except ValueError:
        return False


def code_of(agent: str) -> str:
    """A hash of the code that determines the profile of an agent: its own, that of the tasks, and the ladders."""
    module = getattr(edugym, agent).__module__
    tasks = [entry.module for entry in ENVIRONMENTS]
    modules = [*_with_imports(module), *tasks, "edugym.training.loops", "edugym.experiments.profiles.ladders"]
    return hashlib.sha256("\n".join(what_determines(source(name)) for name in modules).encode()).hexdigest()[:32]


def _with_imports(module: str) -> list[str]:
    """A module of an agent, and those of the room of agents that it imports, directly or not."""
    found = [module]
    for name in found:  # grows on the way
        for part in ast.walk(ast.parse(source(name).read_text(encoding="utf-8"))):
            other = part.module if isinstance(part, ast.ImportFrom) else None
            if other and other.startswith("edugym.agents.") and other not in found:
                found.append(other)
    return sorted(found)


def stale() -> list[str]:
    """The agents whose profile is missing, or was made from other code."""
    made = _about()["code"] if PATH.exists() else {}
    return [name for name in agents() if made.get(name) != code_of(name)]


def load() -> Profile | None:
    """The stored profile, without those of agents that are gone; None where none is stored.

    It has the scores, not the returns.
    """
    if not PATH.exists():
        return None
    import pandas

    runs = pandas.read_csv(PATH)
    about = _about()
    there = tuple(name for name in agents() if name in about["code"])
    runs = runs[runs["agent"].isin(there)].reindex(columns=list(COLUMNS))
    return Profile(runs, LADDERS, there, {name: about["blank"][name] for name in there})


def make_again(names: list[str], checkpoints: str | os.PathLike[str], **how: Any) -> Profile:
    """Make profiles again, and store each as soon as it is done.

    Args:
        names: of agents.
        checkpoints: the folder for what is done, if it is interrupted.
        how: more arguments of `edugym.profile`.
    """
    for name in names:
        _store(name, profile({name: agents()[name]}, repetitions=REPETITIONS, checkpoints=checkpoints, **how))
    found = load()
    assert found is not None
    return found


def _store(name: str, new: Profile) -> None:
    """Put the profile of one agent in the place of its old one."""
    import pandas

    rows = new.runs[list(KEPT)].round({"score": DIGITS})
    about: dict[str, Any] = {"versions": "", "code": {}, "blank": {}}
    if PATH.exists():
        old = pandas.read_csv(PATH)
        rows = pandas.concat([old[old["agent"] != name], rows]).sort_values("agent", kind="stable")
        about = _about()
    about["versions"] = versions()
    about["code"][name], about["blank"][name] = code_of(name), new.blank[name]
    write_whole(PATH, rows.to_csv(index=False, lineterminator="\n", float_format="%.5g").encode())
    write_whole(PATH.with_suffix(".json"), (json.dumps(about, indent=1, sort_keys=True) + "\n").encode())


def _about() -> dict[str, Any]:
    about: dict[str, Any] = json.loads(PATH.with_suffix(".json").read_text(encoding="utf-8"))
    return about
