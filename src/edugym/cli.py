"""The command `edugym`: what the package does, from a terminal."""

import ast
import sys
import threading
import warnings
from pathlib import Path
from typing import Annotated, Any, Literal

from gymnasium.error import DependencyNotInstalled

from edugym.extras import require
from edugym.files import check_writable, write_whole
from edugym.lessons.report import MODULES, Report, experiment
from edugym.registration import ENVIRONMENTS, parameters_of
from edugym.results.claims import Claim

try:
    require("experiments", "typer")
except DependencyNotInstalled as missing:
    raise SystemExit(f"edugym: {missing}") from None

import typer
from rich import box
from rich.console import Console
from rich.table import Column, Table

INTERRUPTED = 130
"""The exit status of a command that Ctrl-C ended, as shells have it."""

app = typer.Typer(no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False)


@app.callback()
def edugym() -> None:
    """EduGym: a reinforcement-learning course you can run."""


@app.command("list")
def list_environments() -> None:
    """List the environments, with their challenges and parameters."""
    table = Table("id", "challenge", "parameters (default)", box=None, pad_edge=False)
    for entry in ENVIRONMENTS:
        parameters = (f"{name} ({_short(default)})" for name, default in parameters_of(entry.load()).items())
        table.add_row(entry.id, entry.challenge, ", ".join(parameters))
    Console().print(table)


@app.command()
def play(
    environment: Annotated[str, typer.Argument(help="Its name (Boulder), or the id of any Gymnasium environment.")],
    parameters: Annotated[
        list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help="A parameter, such as --set height=5.")
    ] = None,
    render: Annotated[Literal["ansi", "human"], typer.Option(help="In this terminal, or in a window.")] = "ansi",
    seed: Annotated[
        int | None, typer.Option(min=0, help="Of the first episode. By default another one each time.")
    ] = None,
    gif: Annotated[Path | None, typer.Option(help="A file for the last finished episode, as a film.")] = None,
) -> None:
    """Play an environment with keys, which are shown on the screen."""
    from edugym import playing
    from edugym.playing.game import made

    try:
        env = made(environment, "ansi", dict(map(_parameter, parameters or [])))
        game = playing.Game(env, seed=seed)
    except (TypeError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error
    try:
        playing.play(game, render=render, gif=gif)
    except BrokenPipeError:
        raise  # the reader of the output has gone, as in `| head`: Typer ends the command without a word
    except (OSError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error


def _short(default: Any) -> str:
    """A default value for the table; a number with many digits is rounded."""
    return str(float(f"{default:.4g}") if isinstance(default, float) else default)


def _parameter(text: str) -> tuple[str, Any]:
    """The name and the value in NAME=VALUE; a value that is no number (or inf), True, False or None is a text."""
    name, equals, value = text.partition("=")
    if not equals or not name.isidentifier():
        raise ValueError(f"a parameter is written name=value, but not {text!r}")
    for read in (ast.literal_eval, float):
        try:
            return name, read(value)
        except (TypeError, ValueError, SyntaxError):
            continue
    return name, value


@app.command()
def reproduce(
    lesson: Annotated[str | None, typer.Argument(help=f"One of: {', '.join(MODULES)}. By default all.")] = None,
    output: Annotated[Path, typer.Option(help="The folder to write to.")] = Path("results"),
    repetitions: Annotated[
        int | None, typer.Option(min=2, help="Runs of each method. By default as many as the lesson says.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="From which all random numbers come.")] = 0,
    jobs: Annotated[int, typer.Option(min=-1, help="Runs at a time; -1 for one a core.")] = -1,
) -> None:
    """Redo the experiments behind the paper's figures, and say which claims hold.

    Figures (PNG, SVG) and data (CSV) are written to OUTPUT/LESSON. The exit status is 0 when every claim holds, 1 when
    one does not, 2 when the command is wrong, and 130 after Ctrl-C, which writes what is done.
    """
    if lesson is not None and lesson not in MODULES:
        raise typer.BadParameter(f"{lesson!r} is none of: {', '.join(MODULES)}", param_hint="LESSON")
    if jobs == 0:
        raise typer.BadParameter("0 runs at a time do nothing: give 1 or more, or -1", param_hint="--jobs")
    chosen = [lesson] if lesson is not None else list(MODULES)
    for name in chosen:
        try:
            check_writable(output / name / "claims.csv")
        except OSError as error:
            raise typer.BadParameter(str(error), param_hint="--output") from error
    how: dict[str, Any] = {"seed": seed, "jobs": jobs, "progress": sys.stderr.isatty()}
    how |= {} if repetitions is None else {"repetitions": repetitions}
    all_hold = True
    try:
        for name in chosen:
            all_hold &= _reproduce(name, output / name, how)
    except KeyboardInterrupt:
        typer.echo(f"edugym: interrupted; what was done is in {output}", err=True)
        raise typer.Exit(INTERRUPTED) from None
    raise typer.Exit(0 if all_hold else 1)


def _reproduce(lesson: str, folder: Path, how: dict[str, Any]) -> bool:
    """Redo one lesson; whether all its claims hold.

    Raises:
        KeyboardInterrupt: Ctrl-C; what is done has been written.
    """
    from edugym.plotting import draw, save_figure

    stop = threading.Event()
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        report = experiment(lesson).report(**how, stop=stop, folder=folder)
    for warning in warned:
        typer.echo(f"edugym: {warning.message}", err=True)
    if stop.is_set():
        raise KeyboardInterrupt
    for figure in report.figures:
        save_figure(draw(figure), folder / figure.name)
    _write_claims(report, folder / "claims.csv")
    _print_claims(lesson, report.claims)
    typer.echo(f"Figures and data are in {folder}.")
    return all(claim.holds for claim in report.claims)


def _write_claims(report: Report, path: Path) -> None:
    import pandas

    rows = [
        {**claim._asdict(), **claim.measured._asdict(), "expected": str(claim.expected), "holds": claim.holds}
        for claim in report.claims
    ]
    table = pandas.DataFrame(rows).drop(columns="measured")
    write_whole(path, table.to_csv(index=False, lineterminator="\n").encode())


def _print_claims(lesson: str, claims: Any) -> None:
    columns = ("claim", "measured, with 95 % interval", Column("expected", no_wrap=True), Column("holds", no_wrap=True))
    table = Table(*columns, title=lesson, title_justify="left", box=box.SIMPLE_HEAD, leading=1, pad_edge=False)
    for claim in claims:
        table.add_row(*_row(claim))
    Console().print(table)


def _row(claim: Claim) -> tuple[str, str, str, str]:
    reason = f"\n[dim]{claim.reason}[/dim]" if claim.reason else ""
    holds = "[green]yes[/green]" if claim.holds else "[bold red]NO[/bold red]"
    return f"{claim.statement}{reason}", f"{claim.measured}\n[dim]{claim.quantity}[/dim]", str(claim.expected), holds


def main() -> None:
    """Run the command; a library that is missing is named with what to install."""
    try:
        app()
    except DependencyNotInstalled as missing:
        raise SystemExit(f"edugym: {missing}") from None
