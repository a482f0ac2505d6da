"""The command `edugym lab`: slips, options, and that nothing stays behind."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from edugym_course.commands import app
from edugym_course.lab import server
from edugym_course.lab.warm_up import warming_up
from tests.course.lab.browser import running_lab, until


def run(*arguments: str) -> Result:
    """The command in this process, on a wide terminal."""
    return CliRunner(env={"COLUMNS": "200"}).invoke(app, ["lab", *arguments])


@pytest.fixture
def served(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What JupyterLab is started with, in place of starting it."""
    calls: list[Any] = []
    monkeypatch.setattr(server, "serve", lambda folder, options: calls.append((folder, options)))
    return calls


def test_lessons_come_into_a_folder(served: list[Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By default of this name; options of JupyterLab go to JupyterLab."""
    monkeypatch.chdir(tmp_path)
    assert run("--no-browser", "--port", "8899", "--ServerApp.ip=0.0.0.0").exit_code == 0
    assert served == [(Path("edugym-lessons"), ["--ServerApp.ip=0.0.0.0", "--no-browser", "--port=8899"])]
    assert (tmp_path / "edugym-lessons" / "01_exploration.ipynb").exists()
    assert run("--ServerApp.ip=0.0.0.0", "elsewhere").exit_code == 0
    assert run("--port", "0", "elsewhere").exit_code == 0
    assert served[1:] == [(Path("elsewhere"), ["--ServerApp.ip=0.0.0.0"]), (Path("elsewhere"), ["--port=0"])]


def test_solutions_are_out_of_sight(served: list[Any], tmp_path: Path) -> None:
    """No file in the folder has them."""
    run(str(tmp_path))
    files = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert len(files) >= 3
    for path in files:
        assert "BEGIN SOLUTION" not in path.read_text()
        assert "1 - 0.5 ** (1 / 100)" not in path.read_text()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [(["file"], "is not a folder"), (["file/in/it"], "is not a folder"), (["a", "b"], "one folder is enough")],
)
def test_slips_are_answered_in_one_sentence(
    arguments: list[str], said: str, served: list[Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Before anything is started."""
    monkeypatch.chdir(tmp_path)
    Path("file").touch()
    result = run(*arguments)
    assert result.exit_code == 2
    assert said in result.output
    assert served == []


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_cannot_be_written_to(served: list[Any], tmp_path: Path) -> None:
    """Says so."""
    tmp_path.chmod(0o500)
    assert "ermission denied" in run(str(tmp_path / "lessons")).output
    assert served == []


def test_without_jupyterlab(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """One sentence says how to get it, and nothing is written."""
    code = "import sys; sys.modules['jupyterlab'] = None; from edugym_course.cli import main; main()"
    made = subprocess.run([sys.executable, "-c", code, "lab"], capture_output=True, text=True, cwd=tmp_path)
    assert made.returncode == 1
    assert made.stderr == 'edugym: jupyterlab is not installed, run `pip install "edugym[lab]"`\n'
    assert list(tmp_path.iterdir()) == []


def is_running(process: int) -> bool:
    """Whether a process runs; one that has ended and was not waited for does not."""
    status = Path(f"/proc/{process}/stat")
    return status.exists() and status.read_text().rpartition(")")[2].split()[0] != "Z"


@pytest.mark.slow
def test_warming_up_ends_with_the_block(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It runs in the background meanwhile."""
    with warming_up(["exploration"]) as process:
        assert process.poll() is None
    assert process.poll() is not None


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="processes are looked for in /proc")
def test_warming_up_disturbs_nobody() -> None:
    """It writes nothing into the terminal, Ctrl-C there is not for it, and it has the lowest priority."""
    with warming_up(["exploration"]) as process:
        written = [os.readlink(f"/proc/{process.pid}/fd/{number}") for number in (1, 2)]
        assert written == [os.devnull] * 2
        assert os.getsid(process.pid) != os.getsid(0)
        until(lambda: os.getpriority(os.PRIO_PROCESS, process.pid) == 19, "the lowest priority", 20)


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc").is_dir(), reason="processes are looked for in /proc")
def test_warming_up_ends_with_a_process_that_was_killed() -> None:
    """Nobody tells it then."""
    code = (
        "import time; from edugym_course.lab.warm_up import warming_up\n"
        "with warming_up(['exploration']) as process: print(process.pid, flush=True); time.sleep(60)"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as parent:
        assert parent.stdout is not None
        process = int(parent.stdout.readline())
        assert is_running(process)
        parent.kill()
    until(lambda: not is_running(process), "the end of warming up", 20)


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc").is_dir(), reason="processes are looked for in /proc")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_one_signal_ends_everything(number: signal.Signals, tmp_path: Path) -> None:
    """JupyterLab needs no second word, and warming up ends as well."""
    with running_lab(tmp_path) as lab:
        children = Path(f"/proc/{lab.process.pid}/task/{lab.process.pid}/children").read_text().split()
        assert children
        lab.process.send_signal(number)
        assert lab.process.wait(30) == 0
        assert not any(map(is_running, map(int, children)))
    assert "Traceback" not in (tmp_path / "log.txt").read_text()
