"""What the command `edugym` can do."""

import importlib
import os
import shutil
import sys
from pathlib import Path
from typing import Annotated, Any, Literal

from gymnasium.error import DependencyNotInstalled

from edugym.adapters.registration import in_course_order, parameters_of
from edugym.experiments.checkpoints import CHECKPOINTS
from edugym.experiments.repeat import MOST_JOBS
from edugym.system.extras import require
from edugym.system.files import check_writable, write_whole
from edugym.system.interrupts import INTERRUPTED, SignalGuard
from edugym.system.other_threads import call_interruptibly
from edugym_course import arguments
from edugym_course.arguments import path_of
from edugym_course.lessons import lesson_names, load_experiments
from edugym_course.report import Report, Section, explanation, markdown, rows_of
from edugym_course.warned import warnings_said_at_once

try:
    require("experiments", "typer")
except DependencyNotInstalled as missing:
    raise SystemExit(f"edugym: {missing}") from None

import typer
from rich import box
from rich.console import Console
from rich.table import Column, Table

from edugym_course.teaching.commands import assign, grade, handout

CLAIMS = "claims.csv"
"""The file with the claims of a lesson."""

REPORT = "report.md"
"""The report on all lessons."""

app = typer.Typer(no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False)


@app.callback()
def edugym() -> None:
    """EduGym: a reinforcement-learning course you can run."""


@app.command("list")
def list_environments() -> None:
    """List the environments, with their challenges and parameters."""
    table = Table("id", "challenge", "parameters (default)", box=None, pad_edge=False)
    for entry in in_course_order():
        parameters = (f"{name} ({_short(default)})" for name, default in parameters_of(entry.load()).items())
        table.add_row(entry.id, entry.challenge, ", ".join(parameters))
    Console().print(table)


@app.command()
def play(
    environment: Annotated[
        str,
        typer.Argument(
            help="Its name (Boulder), the id of any Gymnasium environment, or a file that edugym.share wrote"
            " (kiosk.py; it is run, so open only files of people whom you trust)."
        ),
    ],
    parameters: Annotated[
        list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help="A parameter, such as --set height=5.")
    ] = None,
    render: Annotated[Literal["ansi", "human"], typer.Option(help="In this terminal, or in a window.")] = "ansi",
    seed: Annotated[
        int | None, typer.Option(min=0, help="The seed of the first episode; by default a new one each time.")
    ] = None,
    gif: Annotated[
        Path | None,
        typer.Option(parser=path_of, metavar="PATH", help="Save the last whole episode as a film."),
    ] = None,
) -> None:
    """Play an environment with the keyboard; the keys are shown on the screen."""
    from edugym.adapters import playing
    from edugym.adapters.playing.game import playable

    try:
        env = playable(environment, "ansi", arguments.parameters(parameters or []))
        game = playing.Game(env, seed=seed)
    except (OSError, TypeError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error
    try:
        playing.play(game, render=render, gif=gif)
    except BrokenPipeError:
        raise  # the reader of the output has gone, as in `| head`: Typer ends the command without a word
    except (OSError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error


def _short(default: Any) -> str:
    """Format a default value for the table; a number with many digits is rounded."""
    return str(float(f"{default:.4g}") if isinstance(default, float) else default)


@app.command()
def profile(
    agents: Annotated[list[str] | None, typer.Argument(metavar="[AGENT...]", help=arguments.HELP)] = None,
    output: Annotated[
        Path, typer.Option(parser=path_of, metavar="FOLDER", help="The folder for the report and its data.")
    ] = Path("profile"),
    challenge: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="An environment; can be repeated. By default all.")
    ] = None,
    tuned: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUES",
            help="Show each agent also with settings that it chooses itself, such as --tuned learning_rate=0.05,0.5;"
            " can be repeated, for all combinations.",
        ),
    ] = None,
    repetitions: Annotated[int, typer.Option(min=2, help="Runs on each rung of a ladder.")] = 10,
    seed: Annotated[int, typer.Option(min=0, help="The seed of all random numbers.")] = 0,
    jobs: Annotated[int, typer.Option(min=-1, max=MOST_JOBS, help="Runs at a time; -1 means one for each core.")] = -1,
    one_table: Annotated[
        bool,
        typer.Option(
            "--one-table",
            help="Enter the challenge for a class: one table, nothing tuned. The rules are checked, and the agent is"
            " ranked among those of the package.",
        ),
    ] = False,
    everyone: Annotated[
        bool, typer.Option("--all", help="For developers: make the stored profiles again whose code has changed.")
    ] = False,
    libraries: Annotated[
        bool, typer.Option("--libraries", help="For developers: as --all, of agents of Stable-Baselines3; takes hours.")
    ] = False,
) -> None:
    """Say which challenges an agent masters, and how strong each may become.

    It climbs a ladder of tasks for every environment, from easy to hopeless, and scores every rung from 0 (random play)
    to 1 (the best play). OUTPUT/report.html is the report; report.md, runs.csv and the pictures lie beside it. What is
    done is kept in OUTPUT/unfinished: after Ctrl-C the same command goes on from there. The agents of the package have
    profiles that are stored with it; the report shows their scores in grey. With --tuned, each agent also chooses, for
    every challenge, among its settings as given and those listed, by runs with other seeds and layouts than those that
    are scored; that takes 3 more runs of each setting on each rung.
    """
    from edugym_course import profiling

    if bool(agents) + everyone + libraries != 1:
        raise typer.BadParameter("give agents, or --all, or --libraries", param_hint="AGENT")
    everyone = everyone or libraries
    if everyone and (tuned or one_table):
        wrong = "--tuned" if tuned else "--one-table"
        raise typer.BadParameter("stored profiles are not tuned, and enter no challenge: give agents", param_hint=wrong)
    if one_table and (tuned or challenge):
        wrong = "--tuned" if tuned else "--challenge"
        raise typer.BadParameter("by the rules nothing is tuned, and all challenges count", param_hint=wrong)
    chosen = {} if everyone else {"challenges": challenge, "repetitions": repetitions, "seed": seed}
    try:
        said = profiling.profile_and_report(
            agents or [], tuned or [], output, {"jobs": jobs, **chosen}, one_table=one_table, libraries=libraries
        )
    except KeyboardInterrupt:
        typer.echo(f"edugym: interrupted; what is done is kept in {output}, and the same command goes on", err=True)
        raise typer.Exit(INTERRUPTED) from None
    except (OSError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error
    typer.echo("\n".join(said))


@app.command()
def reproduce(
    lesson: Annotated[str | None, typer.Argument(help=f"One of: {', '.join(lesson_names())}. By default all.")] = None,
    output: Annotated[
        Path, typer.Option(parser=path_of, metavar="FOLDER", help="The folder for figures and data.")
    ] = Path("results"),
    repetitions: Annotated[
        int | None, typer.Option(min=2, help="Runs of each method; by default the number of the lesson.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="The seed of all random numbers.")] = 0,
    jobs: Annotated[int, typer.Option(min=-1, max=MOST_JOBS, help="Runs at a time; -1 means one for each core.")] = -1,
) -> None:
    """Run the experiments behind the paper's figures again, and report which claims hold.

    Figures (PNG, SVG) and data (CSV) are written to OUTPUT/LESSON when everything is complete, and OUTPUT/report.md
    shows the claims and figures of all lessons that have been reproduced there. Until then all that is
    done is kept in OUTPUT/LESSON.unfinished: whatever ends the command, the same command goes on from there. The exit
    status is 0 when every claim holds, 1 when a claim does not hold, 2 when the command is wrong, and 130 after Ctrl-C.
    """
    names = lesson_names()
    if lesson is not None and lesson not in names:
        raise typer.BadParameter(f"{lesson!r} is none of: {', '.join(names)}", param_hint="LESSON")
    if jobs == 0:
        raise typer.BadParameter("0 runs at a time do nothing: give 1 or more, or -1", param_hint="--jobs")
    chosen = names if lesson is None else [lesson]
    for name in chosen:
        try:
            check_writable(output / name / CLAIMS)
        except OSError as error:
            raise typer.BadParameter(str(error), param_hint="--output") from error
    how: dict[str, Any] = {"seed": seed, "jobs": jobs, "progress": sys.stderr.isatty()}
    how |= {} if repetitions is None else {"repetitions": repetitions}
    try:
        with SignalGuard() as guard:
            hold = [_reproduce(name, output / name, how, guard) for name in chosen]
    except KeyboardInterrupt:
        typer.echo(f"edugym: interrupted; what is done is kept in {output}, and the same command goes on", err=True)
        raise typer.Exit(INTERRUPTED) from None
    raise typer.Exit(0 if all(hold) else 1)


def _reproduce(lesson: str, folder: Path, how: dict[str, Any], guard: SignalGuard) -> bool:
    """Run the experiments of one lesson, and return whether all claims hold.

    Everything is written into a folder beside `folder`, and moved there when it is complete: an unfinished rerun leaves
    complete results as they are. The claims come last: where they are, everything else is.

    Raises:
        KeyboardInterrupt: Ctrl-C was pressed.
    """
    unfinished = folder.with_name(f"{folder.name}.unfinished")
    unfinished.mkdir(exist_ok=True)
    _clear(unfinished, keep=CHECKPOINTS)
    experiments = call_interruptibly(load_experiments, lesson)
    with warnings_said_at_once():
        report = experiments.report(**how, folder=unfinished)
    plotting = call_interruptibly(importlib.import_module, "edugym.experiments.figures")
    for figure in report.figures:
        guard.should_stop()
        plotting.save_figure(figure.draw(), unfinished / figure.name)
    _write_claims(report, unfinished / CLAIMS)
    guard.should_stop()
    (folder / CLAIMS).unlink(missing_ok=True)
    for path in sorted(unfinished.iterdir(), key=lambda path: (path.name == CLAIMS, path.name)):
        if path.name != CHECKPOINTS:
            write_whole(folder / path.name, path.read_bytes())
    shutil.rmtree(unfinished)
    _write_report(folder.parent)
    _print_claims(lesson, report.claims)
    typer.echo(f"Figures and data are in {folder}, and a report in {folder.parent / REPORT}.")
    return all(claim.holds for claim in report.claims)


def _clear(folder: Path, keep: str) -> None:
    """Remove what an unfinished command has left, except one folder."""
    for path in folder.iterdir():
        if path.name == keep:
            continue
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
            path.unlink()


def _write_claims(report: Report, path: Path) -> None:
    import pandas

    table = pandas.DataFrame(rows_of(report.claims))
    write_whole(path, table.to_csv(index=False, lineterminator="\n").encode())


def _write_report(output: Path) -> None:
    """Write the report on all lessons with results in the folder, in this run of the command or earlier."""
    import pandas

    sections = []
    for name in lesson_names():
        folder = output / name
        if (folder / CLAIMS).exists():
            table = pandas.read_csv(folder / CLAIMS)
            claims = [dict(zip(table.columns, row, strict=True)) for row in table.itertuples(index=False)]
            about = call_interruptibly(load_experiments, name).__doc__ or name
            sections.append(Section(name, about, claims, sorted(folder.glob("*.svg"))))
    write_whole(output / REPORT, markdown(sections, output).encode())


def _print_claims(lesson: str, claims: Any) -> None:
    columns = (
        "",
        "claim",
        "measured, with 95 % interval",
        Column("expected", no_wrap=True),
        Column("holds", no_wrap=True),
    )
    table = Table(*columns, title=lesson, title_justify="left", box=box.SIMPLE_HEAD, leading=1, pad_edge=False)
    for number, (row, claim) in enumerate(zip(rows_of(claims), claims, strict=True), start=1):
        lines = [claim.statement, *(f"[dim]{line}[/dim]" for line in explanation(row))]
        measured = f"{claim.measured}\n[dim]{claim.quantity}[/dim]"
        holds = "[green]yes[/green]" if claim.holds else "[bold red]NO[/bold red]"
        table.add_row(str(number), "\n".join(lines), measured, str(claim.expected), holds)
    Console().print(table)


@app.command(context_settings={"ignore_unknown_options": True})
def lab(
    arguments: Annotated[
        list[str] | None,
        typer.Argument(metavar="[DIRECTORY] [OPTIONS OF JUPYTERLAB]", help="The folder for the lessons."),
    ] = None,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open it in the browser.")] = True,
    port: Annotated[int | None, typer.Option(min=0, max=65535, help="The port; by default the first free one.")] = None,
) -> None:
    """Put the lessons into a folder, by default ./edugym-lessons, and open them in JupyterLab.

    A lesson that you have changed stays as it is; a newer version is put beside it. Options of JupyterLab are written
    with a sign of equality, such as --ServerApp.ip=0.0.0.0. Ctrl-C ends it.
    """
    from edugym_course.lab import server

    options = [argument for argument in arguments or [] if argument.startswith("-")]
    folders = [argument for argument in arguments or [] if not argument.startswith("-")] or ["edugym-lessons"]
    if len(folders) > 1:
        raise typer.BadParameter(f"one folder is enough, but there are {', '.join(folders)}", param_hint="DIRECTORY")
    folder = path_of(folders[0])
    server.require_jupyterlab()
    try:
        messages = server.prepare(folder)
    except OSError as error:
        raise typer.BadParameter(str(error), param_hint="DIRECTORY") from error
    for message in messages:
        typer.echo(f"edugym: {message}")
    typer.echo(f"The lessons are in {folder.resolve()}. Ctrl-C here ends JupyterLab.")
    options += [] if browser else ["--no-browser"]
    options += [] if port is None else [f"--port={port}"]
    server.serve(folder, options)


for _command in (assign, handout, grade):
    app.command()(_command)


def run() -> None:
    """Do what the command line says. A missing library, or output that cannot be written, ends it with one line."""
    try:
        try:
            app()
        finally:
            if sys.stdout is not None:
                sys.stdout.flush()  # here, where an error can still be reported
    except SystemExit as end:
        if end.code == INTERRUPTED:
            if isinstance(getattr(end.__context__, "__cause__", None), KeyboardInterrupt):  # Typer makes no word of it
                print("edugym: interrupted", file=sys.stderr, flush=True)
            os._exit(INTERRUPTED)  # at once: the compiler may still be busy in a thread, which Python would wait for
        raise
    except DependencyNotInstalled as missing:
        raise SystemExit(f"edugym: {missing}") from None
    except OSError as error:
        # Python flushes once more at its end, which would fail again, with a traceback.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):  # as in `edugym list | head`: nobody reads on
            raise SystemExit(1) from None
        if isinstance(error.__context__, SystemExit) and error.__context__.code:  # it has failed already, and said why
            raise SystemExit(error.__context__.code) from None
        about_a_file = error.filename is not None or error.strerror is None
        raise SystemExit(f"edugym: {error if about_a_file else f'cannot write the output: {error.strerror}'}") from None
