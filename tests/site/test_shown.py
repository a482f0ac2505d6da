"""`make site` ends by showing the website on this machine."""

import os
import re
import signal
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest

from tests.messages import named

pytestmark = pytest.mark.slow
SITE = Path(__file__).parents[2] / "site"
BUILT_ALREADY = """
import sys
from pathlib import Path
sys.path.insert(0, sys.argv.pop(1))
import website
website.BUILT = Path(sys.argv.pop(1))
website.build = lambda *_: 0
sys.exit(website.main())
"""


@pytest.fixture
def command(tmp_path: Path) -> list[str]:
    """The command that builds the website, with one that is built."""
    (tmp_path / "html").mkdir()
    (tmp_path / "html" / "index.html").write_text("all of it", encoding="utf-8")
    return [sys.executable, "-c", BUILT_ALREADY, str(SITE), str(tmp_path), "--port", "0"]


def test_it_is_shown_in_a_terminal_until_ctrl_c(command: list[str]) -> None:
    """At the address that stands there. Ctrl-C is no error, and leaves no traceback."""
    mine, terminal = os.openpty()
    with subprocess.Popen(command, stdout=terminal, stderr=subprocess.PIPE, text=True) as shown:
        os.close(terminal)
        said = os.read(mine, 4096).decode()
        address = next(word for word in said.split() if word.startswith("http"))
        with urllib.request.urlopen(address) as page:
            assert page.read() == b"all of it"
        shown.send_signal(signal.SIGINT)
        _, complaint = shown.communicate(timeout=30)
    os.close(mine)
    assert shown.returncode == 0
    assert "Traceback" not in complaint


@pytest.mark.parametrize(
    ("options", "status", "names"),
    [
        ([], 0, ["make site ARGS=--serve"]),
        (["--serve", "--port", "99999"], 2, ["--port 99999", "0"]),
    ],
)
def test_it_ends_where_nobody_looks_or_the_port_is_none(
    command: list[str], options: list[str], status: int, names: list[str]
) -> None:
    """Without a terminal it says where the website is, and how to see it."""
    done = subprocess.run([*command, *options], capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == status
    assert re.search(named(*names), done.stdout + done.stderr, re.DOTALL)
