"""What `edugym profile` does: profile agents, write the report, and say the result in the terminal."""

import shutil
import sys
import warnings
from pathlib import Path
from typing import Any

from rich import box
from rich.console import Console
from rich.table import Table

from edugym import Profile
from edugym.experiments.profiles import report
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.tuning import tuned_profile, with_untuned
from edugym.system.files import check_writable
from edugym.system.interrupts import SignalGuard, call_interruptibly
from edugym_course import agent_profiles, arguments

UNFINISHED = "unfinished"
"""The folder, in that of the report, for what is done before everything is."""


def profile_and_report(agents: list[str], tuned: list[str], output: Path, how: dict[str, Any]) -> list[str]:
    """Profile agents, write the report, and return what to say.

    Args:
        agents: as they are written on the command line; none makes the stored profiles again whose code has changed.
        tuned: settings among which the agents choose in a second profile, as they are written on the command line.
        output: the folder for the report.
        how: more arguments of `edugym.profile`.

    Raises:
        ValueError: an agent, or an argument, is not as it must be.
        OSError: a file cannot be read or written.
        KeyboardInterrupt: Ctrl-C was pressed.
    """
    check_writable(output / report.NAME)
    how = {**how, "progress": sys.stderr.isatty(), "checkpoints": output / UNFINISHED}
    stale = agent_profiles.stale()
    with SignalGuard(), warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        if agents:
            found, beside = _profiles(arguments.agents(agents), tuned, how), agent_profiles.load()
        else:
            found, beside = agent_profiles.make_again(stale, **how), None
        path = call_interruptibly(report.write, found, output, beside)
    shutil.rmtree(output / UNFINISHED, ignore_errors=True)
    _print_scores(found, beside)
    said = [f"{name}. {report.said(found, name).sentence}" for name in found.challenges]
    if not agents:
        said.append(f"Made again: {', '.join(stale) or 'none'}.")
    elif beside and stale:
        said.append(f"No stored profile was made from the present code of {', '.join(stale)}: edugym profile --all.")
    return [*(f"edugym: {text}" for text in {str(one.message) for one in warned}), *said, f"The report is {path}."]


def _profiles(agents: dict[str, Any], tuned: list[str], how: dict[str, Any]) -> Profile:
    """The profile of agents as they are given and, beside it, that with settings of their choice."""
    grids = arguments.grids(agents, tuned) if tuned else {}  # first: what is misspelt is said at once
    found = profile(agents, **how)
    return with_untuned(found, tuned_profile(grids, **how)) if grids else found


def _print_scores(found: Profile, beside: Profile | None) -> None:
    heading, rows = report.score_table(found, beside)
    table = Table(*heading, box=box.SIMPLE_HEAD, pad_edge=False)
    for row in rows:
        table.add_row(*row)
    Console().print(table)
