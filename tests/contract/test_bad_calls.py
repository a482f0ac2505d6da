"""Every public function answers a bad argument with one sentence, and none hangs or asks for all the memory.

One argument of a valid call at a time is replaced by each of a fixed list of odd values. The call must return where the
table says that the parameter takes the value; else it must raise an error that names the parameter, shows the value,
and says what is allowed. A public name without a row in the tables fails too.
"""

import copy
import importlib
import inspect
import math
import re
import resource
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any, get_type_hints

import gymnasium
import pytest

import edugym
from edugym.agents.settings import Range, Table
from edugym.checks.parameters import in_short
from edugym_course.grading import WrongAnswer
from tests.contract import more_public_calls, public_calls
from tests.contract.public_calls import EVERYWHERE, NUMBER, ROOMS, Case, completed, odd_values, row

CALLED_BY_LOOPS = ("edugym.agents.", "edugym.envs.games.", "edugym.mdp.")
"""Of classes from here only `create` counts, or what is made directly: machine code calls their other methods, with
what the gates have looked at."""
MADE_BY_LIBRARY = {
    "ConstrainedOptimum",
    "Estimate",
    "FiniteModel",
    "FittedValues",
    "Front",
    "GameRun",
    "Interval",
    "Outcome",
    "Profile",
    "Results",
    "Run",
    "Sample",
    "Score",
    "Values",
    "VectorRun",
}
"""Classes of which functions return values, and nobody else makes any."""
NOT_CHECKED = {"statistics.in_short", "tables.with_types", "deep.PPO.gradient", "deep.PPO.learn", "deep.PPO.play"}
"""Functions for the package itself, and the parts of `PPO.train`."""
SECONDS, BYTES = 60, 4 * 2**30
"""What one call may take, on a loaded machine, and how much more memory than before."""

NAMES = [name for name in dir(edugym) if name not in {entry.name for entry in edugym.ENVIRONMENTS}]
"""The public names but the environments, whose settings `environments` tries together."""
OWN_DEFAULTS = {
    "discount", "epsilon", "evaluation_episodes", "expected_updates", "high", "learning_rate", "longest", "low",
    "max_steps", "n_tables", "planning_steps", "seed", "spread", "value_learning_rate", "y_label",
}  # fmt: skip
"""The parameters whose default depends on where they stand."""


def in_table(key: str) -> Case:
    """The row of a public callable, or what follows from its name and those of its parameters."""
    name, _, method = key.partition(".")
    for calls in (public_calls.CALLS, more_public_calls.CALLS):
        if key in calls:
            return completed(key, calls[key]())
    if method == "create" and name in {entry.name for entry in edugym.ENVIRONMENTS}:
        return more_public_calls.of_environment(name)
    return completed(key, row())


def declared(key: str) -> dict[str, str]:
    """Which odd values the settings of an agent take, as their declared ranges say; nothing for other callables."""
    agent, takes = getattr(edugym, key.partition(".")[0], None), {}
    hints = get_type_hints(agent, include_extras=True) if hasattr(agent, "learn") else {}
    for name, hint in hints.items():
        for mark in getattr(hint, "__metadata__", ()):
            if isinstance(mark, Range):
                odd = odd_values().items()
                takes[name] = " ".join(key for key, value in odd if in_range(value, mark, hint.__origin__))
            elif isinstance(mark, Table) and isinstance(mark.fill, str):
                takes[mark.fill] = NUMBER
    return takes


def in_range(value: Any, allowed: Range, kind: type) -> bool:
    """Whether a range has a number of this kind; a whole number has its limit, or that of a real number."""
    if type(value) not in (int, kind) or value != value or value == 10**400:
        return False
    largest = 2**62 if kind is int else math.nextafter(math.inf, 0)
    high = largest if allowed.high is None else allowed.high
    return value <= high and (value > allowed.low or (value == allowed.low and not allowed.open))


def public(name: str) -> Iterator[str]:
    """The keys of the rows that a public name, or a public module or the environments, must have."""
    if name == "environments":
        yield from (f"{entry.name}.create" for entry in edugym.ENVIRONMENTS)
    elif name in ROOMS:
        room = importlib.import_module(ROOMS[name])
        own = [part for part, value in vars(room).items() if getattr(value, "__module__", "") == room.__name__]
        shown = getattr(room, "__all__", [part for part in own if not part.startswith("_")])
        for part in shown:
            if not hasattr(edugym, part):
                yield from keys_of(f"{name}.{part}", getattr(room, part))
    else:
        yield from keys_of(name, getattr(edugym, name))


def keys_of(key: str, value: Any) -> Iterator[str]:
    """The same for one value: itself, or what makes one of a class, and the methods."""
    if not isinstance(value, type):
        if callable(value) and inspect.signature(value).parameters and key not in NOT_CHECKED:
            yield key
        return
    if issubclass(value, BaseException):
        return
    if hasattr(value, "create"):
        yield f"{key}.create"
    elif key.split(".")[-1] not in MADE_BY_LIBRARY and inspect.signature(value).parameters:
        yield key
    for name in dir(value):
        method = getattr(value, name, None)
        ours = callable(method) and (getattr(method, "__module__", None) or "").startswith("edugym")
        own = name[0] != "_" and name != "create" and f"{key}.{name}" not in NOT_CHECKED
        if ours and own and not value.__module__.startswith(CALLED_BY_LOOPS):
            taken = inspect.signature(getattr(value, name)).parameters.values()
            if any(one.name not in ("self", "place") and one.kind is not one.VAR_KEYWORD for one in taken):
                yield f"{key}.{name}"


@contextmanager
def limited() -> Iterator[None]:
    """End a block that takes too long or too much memory."""

    def late(*_: Any) -> None:
        raise TimeoutError(f"it takes more than {SECONDS} s")

    old, (soft, hard) = signal.signal(signal.SIGALRM, late), resource.getrlimit(resource.RLIMIT_AS)
    now = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + BYTES, hard))
    signal.alarm(SECONDS)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, old)
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def fault(call: Callable[[], object], names: tuple[str, ...], value: Any, takes: bool) -> str | None:
    """What is wrong with how a call answers a value of a parameter of one of these names; None if nothing is."""
    try:
        with limited():
            call()
    except (ValueError, TypeError, gymnasium.error.Error, WrongAnswer) as error:
        says = str(error)
        shown = {in_short(value)[:30], type(value).__name__, getattr(value, "__name__", in_short(value))}
        shown |= {value if isinstance(value, str) else in_short(value), "1e+30"}  # as a float
        allowed = re.search(r"must|should|not in the (action|observation) space|doesn't exist|is None|missing", says)
        own, *others = (re.search(rf"\b{name}\b", says, re.IGNORECASE) for name in names)
        named = any(others) or (own and any(text in says for text in shown))
        good = named and allowed and "\n" not in says and len(says) < 600
        return None if good and not takes else f"{type(error).__name__}: {says}"
    except FileNotFoundError as error:
        return None if str(value) in str(error) else repr(error)
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt):
            raise
        return repr(error)
    return None if takes else "it returns"


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(
    "name",
    [
        *NAMES,
        *(pytest.param(room, marks=[pytest.mark.slow] * (room == "deep")) for room in ROOMS),  # it trains networks
        "environments",
    ],
)
def test_bad_calls(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each odd value in the place of each argument."""
    faults, calls = [], 0
    for key in public(name):
        case = in_table(key)
        with limited():
            case.function(**copy.deepcopy(case.valid))
        usually = EVERYWHERE | declared(key)
        for parameter, usual in case.valid.items():
            folder = tmp_path / f"{key}.{parameter}"
            folder.mkdir()
            monkeypatch.chdir(folder)  # some functions take any text as a path
            takes = (case.takes.get(parameter) or usually.get(parameter, "")).split()
            names = (parameter, *case.named.get(parameter, "").split())
            for odd, value in odd_values().items():
                if value is None and usual is None:
                    continue
                others = copy.deepcopy({other: one for other, one in case.valid.items() if other != parameter})
                found = fault(partial(case.function, **others, **{parameter: value}), names, value, odd in takes)
                calls += 1
                if found is not None:
                    faults.append(f"{key}({parameter}={odd}): {found}")
    assert not faults, f"{len(faults)} of {calls} calls:\n" + "\n".join(faults)


def test_a_parameter_has_the_same_default_wherever_it_stands() -> None:
    """Who knows `progress` or `tolerance` from one function knows them from all."""
    defaults = dict[str, list[Any]]()
    for key in (key for name in (*NAMES, *ROOMS) if name != "deep" for key in public(name)):
        for one in inspect.signature(public_calls.found(key)).parameters.values():
            if one.default is not one.empty:
                defaults.setdefault(one.name, []).append(one.default)
    assert {name for name, values in defaults.items() if any(value != values[0] for value in values)} == OWN_DEFAULTS
