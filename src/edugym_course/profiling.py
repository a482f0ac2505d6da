"""What `edugym profile` does: profile agents, write the report, and say the result in the terminal."""

import shutil
import sys
from pathlib import Path
from typing import Any

from rich import box
from rich.console import Console
from rich.table import Table

from edugym import Profile
from edugym.experiments.profiles import report, tables, verdicts
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.scores import pooled
from edugym.experiments.profiles.tuning import tuned_profile, with_untuned
from edugym.system.files import check_writable
from edugym.system.interrupts import SignalGuard
from edugym.system.other_threads import call_interruptibly
from edugym_course import agent_profiles, arguments, one_table_rules
from edugym_course import one_table as class_challenge
from edugym_course.warned import warnings_said_at_once

UNFINISHED = "unfinished"
"""The folder, in that of the report, for what is done before everything is."""


def profile_and_report(
    agents: list[str],
    tuned: list[str],
    output: Path,
    how: dict[str, Any],
    *,
    one_table: bool = False,
    libraries: bool = False,
) -> list[str]:
    """Profile agents, write the report, and return what to say.

    Args:
        agents: as they are written on the command line; none makes the stored profiles again whose code has changed.
        tuned: settings among which the agents choose in a second profile, as they are written on the command line.
        output: the folder for the report.
        how: more arguments of `edugym.profile`.
        libraries: whether those made again are the profiles of agents of libraries, not those of the package's.
        one_table: whether the agents enter the challenge for a class, by its rules.

    Raises:
        ValueError: an agent, or an argument, is not as it must be, or an agent breaks a rule.
        OSError: a file cannot be read or written.
        KeyboardInterrupt: Ctrl-C was pressed.
    """
    check_writable(output / report.NAME)
    how = {**how, "progress": sys.stderr.isatty(), "checkpoints": output / UNFINISHED}
    stale: dict[str, Any] = {}
    given: dict[str, Any] = {}
    grids: dict[str, Any] = {}
    with SignalGuard(), warnings_said_at_once():
        if agents:
            given, beside = arguments.agents(agents), agent_profiles.load()
            grids = arguments.grids(given, tuned) if tuned else {}  # first: what is misspelt is said at once
            found = _by_the_rules(given, how) if one_table else _profiles(given, grids, how)
        else:
            stale = agent_profiles.stale_of_libraries() if libraries else agent_profiles.stale()
            found, beside = agent_profiles.make_again(stale, **how), None
        everybody = pooled(found, beside) if beside else None
        path = call_interruptibly(report.write, found, output, everybody, agent_profiles.abouts(given))
    shutil.rmtree(output / UNFINISHED, ignore_errors=True)
    _print_table(*tables.score_table(found, everybody))
    said = [f"{name}. {verdicts.said(found, name, everybody).sentence}" for name in found.challenges]
    if tuned and (untuned := [label for label in given if label not in grids]):
        said.append(f"Not tuned, since it has none of these settings: {', '.join(untuned)}.")
    if not agents:
        said.append(f"Made again: {', '.join(stale) or 'none'}.")
        if old := {} if libraries else agent_profiles.stale_of_libraries():
            parts = [f"{name} ({', '.join(ladder.name for ladder in ladders)})" for name, ladders in old.items()]
            said.append(f"Not made again: {', '.join(parts)}: edugym profile --libraries, which takes hours.")
    elif beside and (stale := agent_profiles.stale()):
        said.append(f"No stored profile was made from the present code of {', '.join(stale)}: edugym profile --all.")
    if one_table and beside:
        places = class_challenge.ranking(found, beside, found.challenges)
        _print_table(*class_challenge.ranking_table(places))
        said += class_challenge.sentences(places)
    return [*said, f"The report is {path}."]


def _profiles(agents: dict[str, Any], grids: dict[str, Any], how: dict[str, Any]) -> Profile:
    """The profile of agents as they are given and, beside it, that with settings of their choice."""
    found = profile(agents, **how)
    return with_untuned(found, tuned_profile(grids, **how)) if grids else found


def _by_the_rules(agents: dict[str, Any], how: dict[str, Any]) -> Profile:
    """The profile of agents that keep to the rules of the challenge for a class."""
    ladders, entering = class_challenge.ladders(), class_challenge.by_the_rules(agents)
    one_table_rules.check_rules(entering, ladders)
    return profile(entering, **how | {"challenges": ladders})


def _print_table(heading: list[str], rows: list[list[str]]) -> None:
    table = Table(*heading, box=box.SIMPLE_HEAD, pad_edge=False)
    for row in rows:
        table.add_row(*row)
    Console().print(table)
