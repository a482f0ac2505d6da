"""What `edugym lab` compiles in the background: it disturbs nobody, and nothing stays behind."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from edugym_course.lab.warm_up import warming_up
from tests.course.lab.browser import PATIENCE, running_lab, until

pytestmark = pytest.mark.skipif(not Path("/proc").is_dir(), reason="processes are looked for in /proc")


def is_running(process: int) -> bool:
    """Whether a process runs; one that has ended and was not waited for does not."""
    status = Path(f"/proc/{process}/stat")
    return status.exists() and status.read_text().rpartition(")")[2].split()[0] != "Z"


def test_warming_up_disturbs_nobody() -> None:
    """It writes nothing into the terminal, Ctrl-C there is not for it, and it has the lowest priority."""
    with warming_up(["exploration"]) as process:
        written = [os.readlink(f"/proc/{process.pid}/fd/{number}") for number in (1, 2)]
        assert written == [os.devnull] * 2
        assert os.getsid(process.pid) != os.getsid(0)
        until(lambda: os.getpriority(os.PRIO_PROCESS, process.pid) == 19, "the lowest priority")
        assert process.poll() is None
    assert process.poll() is not None  # it ends with the block


@pytest.mark.slow
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
    until(lambda: not is_running(process), "the end of warming up")


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_one_signal_ends_everything(number: signal.Signals, tmp_path: Path) -> None:
    """JupyterLab needs no second word, and warming up ends as well."""
    with running_lab(tmp_path) as lab:
        listed = Path(f"/proc/{lab.process.pid}/task/{lab.process.pid}/children")
        children = until(lambda: listed.read_text().split(), "warming up")
        lab.process.send_signal(number)
        assert lab.process.wait(PATIENCE) == 0
        until(lambda: not any(map(is_running, map(int, children))), "the end of its children")
    assert "Traceback" not in (tmp_path / "log.txt").read_text()
