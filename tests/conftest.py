"""What all tests share: one folder of machine code for a session, and random examples that come again in every run."""

import gc
import math
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator

import pytest
from hypothesis import settings
from pytest_timeout import Settings

os.environ["SDL_VIDEODRIVER"] = "dummy"  # windows open on a pretended screen
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # begun in the background of a shell; tests press Ctrl-C
    signal.signal(signal.SIGINT, signal.default_int_handler)
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # hundreds of processes would each compile the package again
os.environ.setdefault("OMP_NUM_THREADS", "1")  # one torch thread a process: more would wait for each other's cores

settings.register_profile("repeatable", derandomize=True, deadline=None, database=None)
settings.register_profile("search", deadline=None)  # new examples each time: pytest --hypothesis-profile=search
settings.load_profile("repeatable")

_folders: list[str] = []


def pytest_addoption(parser: pytest.Parser) -> None:
    """For machines whose time is limited, where a run that is ended from outside would say nothing."""
    parser.addoption(
        "--begin-until",
        type=float,
        default=math.inf,
        help="tests that have not begun by then, in seconds since 1970, are skipped, and the summary counts them",
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Where time is limited, take the files in another order each time, so that it is not always the same that wait."""
    until = config.getoption("--begin-until")
    if until < math.inf:
        files = sorted({item.path for item in items})
        random.Random(until).shuffle(files)  # the processes of pytest-xdist know the same time, and so the same order
        items.sort(key=lambda item: files.index(item.path))


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip what has not begun in time, and set the alarm once more where a test runs again: it rings once a test."""
    if time.time() > item.config.getoption("--begin-until"):
        pytest.skip("the time for tests was over (--begin-until)")
    if getattr(item, "execution_count", 1) > 1:
        seconds = float(item.config.getini("timeout"))
        limit = Settings(seconds, "signal", func_only=False, disable_debugger_detection=False)
        item.ihook.pytest_timeout_set_timer(item=item, settings=limit)


def pytest_configure(config: pytest.Config) -> None:
    """Compile once a session: the processes of pytest-xdist inherit the folder from the one that starts them.

    A developer who sets EDUGYM_CACHE_DIR keeps the machine code from one session to the next.
    """
    if not os.environ.get("EDUGYM_CACHE_DIR"):
        _folders.append(tempfile.mkdtemp(prefix="edugym-tests-"))
        os.environ["EDUGYM_CACHE_DIR"] = _folders[0]


def pytest_collection_finish(session: pytest.Session) -> None:
    """Look for garbage less often, and not among imports: while Numba compiles, a tenth of the time went into it."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(10_000, 10, 10)


def pytest_unconfigure(config: pytest.Config) -> None:
    """Leave nothing behind."""
    for folder in _folders:
        shutil.rmtree(folder, ignore_errors=True)


@pytest.fixture(autouse=True, scope="session")
def builds_may_take_long() -> None:
    """A busy machine needs 20 s of processor time for what takes 10 s elsewhere."""
    from edugym.compiled import compiler

    compiler.MOST_SECONDS = 120.0


@pytest.fixture
def compiled_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Compile students' code though the interpreter would finish the run sooner."""
    from edugym.compiled import execution

    monkeypatch.setattr(execution, "seconds_to_build", lambda: 0.0)


@pytest.fixture(autouse=True)
def builds_are_over() -> Iterator[None]:
    """Wait for a build that a stopped run has left to its thread: at its end it would restore that run's warnings."""
    yield
    for thread in threading.enumerate():
        if thread.name == "edugym-_build_once":
            thread.join(60)


@pytest.fixture(autouse=True)
def figures_are_closed() -> Iterator[None]:
    """Close the figures that a test left open, so that the next one begins without any."""
    yield
    if pyplot := sys.modules.get("matplotlib.pyplot"):
        pyplot.close("all")


@pytest.fixture(scope="session")
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The accessibility checker of Deque, from npm."""
    folder = tmp_path_factory.mktemp("axe")
    try:
        fetched = subprocess.run(
            ["npm", "pack", "--silent", "axe-core@4"], cwd=folder, capture_output=True, text=True, timeout=120
        )
    except (FileNotFoundError, subprocess.TimeoutExpired):
        pytest.skip("npm is not there")
    if fetched.returncode != 0:
        pytest.skip("axe-core cannot be reached")
    shutil.unpack_archive(folder / fetched.stdout.strip(), folder, "gztar")
    return (folder / "package" / "axe.min.js").read_text(encoding="utf-8")
