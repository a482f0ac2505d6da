"""What JupyterLab is started with, what is compiled meanwhile, and what a lesson says of itself."""

import base64
import importlib
import os
import re
import sys
import threading
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from traitlets.config.loader import PyFileConfigLoader

from edugym_course.lab import lessons, server, start_page, warm_up
from edugym_course.lab.lessons import Lesson, student_lessons
from edugym_course.lessons import lesson_names

OPENING = """# Doubling #2: by `x + x`
**The challenge.** One
line. **You will be able to** double. **Time.** 5 minutes. **Before you start.** Read **this**.

**Time.** Another."""
DOUBLING = Lesson(
    "01_doubling",
    "",
    [
        {"cell_type": "markdown", "source": [OPENING], "metadata": {}},
        {"cell_type": "code", "source": "1", "metadata": {"tags": ["check"]}},
        {"cell_type": "code", "source": "2", "metadata": {"tags": ["hidden"]}},
        {"cell_type": "code", "source": "3", "metadata": {"tags": ["hidden", "check"]}},
    ],
)


def test_what_a_lesson_says_of_itself() -> None:
    """In one line each; a part ends at the next label or at the end of its paragraph."""
    assert (DOUBLING.number, DOUBLING.title, DOUBLING.exercises) == ("1", "Doubling #2: by `x + x`", 2)
    labels = ("The challenge", "Time", "Before you start", "Author")
    assert [DOUBLING.part(label) for label in labels] == ["One line.", "5 minutes.", "Read **this**.", ""]
    assert DOUBLING._replace(name="12_x").number == "12"


def test_the_lessons_are_in_order(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Those of an installed package before those of a checkout; other notebooks are no lessons."""
    for folder in ("packaged", "checkout"):
        (tmp_path / folder).mkdir()
        for name in ("02_b.ipynb", "01_a.ipynb", "10_c.ipynb", "template.ipynb", "3.ipynb"):
            (tmp_path / folder / name).write_text('{"cells": []}')
    (tmp_path / "checkout" / "11_d.ipynb").write_text('{"cells": [{}]}')
    monkeypatch.setattr(lessons, "PACKAGED", tmp_path / "packaged")
    monkeypatch.setattr(lessons, "CHECKOUT", tmp_path / "checkout")
    assert student_lessons() == [Lesson(name, '{"cells": []}', []) for name in ("01_a", "02_b", "10_c")]
    monkeypatch.setattr(lessons, "PACKAGED", tmp_path / "nowhere")
    assert student_lessons()[3:] == [Lesson("11_d", '{"cells": [{}]}', [{}])]


def test_a_row_of_the_start_page(tmp_path: Path) -> None:
    """With the versions beside the student's own."""
    for name in ("", "_new_version", "_new_version_2"):
        (tmp_path / f"01_doubling{name}.ipynb").touch()
    image, _, rest = start_page.row(DOUBLING, tmp_path).removeprefix("| ").partition(" | ")
    assert rest == (
        "**1. [Doubling #2: by `x + x`](01_doubling.ipynb)** ([01_doubling_new_version](01_doubling_new_version.ipynb))"
        " ([01_doubling_new_version_2](01_doubling_new_version_2.ipynb))"
        "<br>One line.<br>**Time.** 5 minutes. **Before you start.** Read **this**."
        "<br>**Exercises.** 0 of 2 solved |\n"
    )
    found = re.fullmatch(r"!\[Boulder\]\(data:image/svg\+xml;base64,(.*)\)", image)
    assert found
    size = re.search(r'width="(\d+)" height="(\d+)"', base64.b64decode(found[1]).decode())
    assert size
    assert 114 <= max(map(int, size.groups())) <= 126  # its unit is a whole number of pixels
    assert start_page.row(DOUBLING._replace(name="99_later"), tmp_path).startswith("|  | **99. [")


@pytest.mark.parametrize(("user", "set_before"), [(0, "mine"), (1000, "")])
def test_how_jupyterlab_is_started(user: int, set_before: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """At the start page of the student's folder; the student's own options come last, so that they win."""
    started: list[Any] = []

    @contextmanager
    def warming_up(names: Sequence[str]) -> Iterator[None]:
        started.append(names)
        yield
        started.append("ended")

    labapp = SimpleNamespace(LabApp=SimpleNamespace(launch_instance=started.append))
    monkeypatch.setitem(sys.modules, "jupyterlab.labapp", labapp)
    monkeypatch.setattr(server, "warming_up", warming_up)
    monkeypatch.setattr(os, "geteuid", lambda: user)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("JUPYTER_CONFIG_PATH", set_before)
    server.serve(Path("mine"), ["--port=1"])
    names, arguments, end = started
    assert (names, end) == (lesson_names(), "ended")
    assert arguments == [
        f"--ServerApp.root_dir={tmp_path}/mine",
        "--LabApp.default_url=/lab/tree/start.md",
        f"--LabApp.workspaces_dir={tmp_path}/mine/.edugym/workspaces",
        "--ServerApp.answer_yes=True",
        "--log-level=WARN",
        "--port=1",
        *["--allow-root"] * (user == 0),
    ]
    paths = os.environ["JUPYTER_CONFIG_PATH"].split(os.pathsep)
    assert paths == [str(server.SETTINGS), *filter(None, [set_before])]
    assert (tmp_path / "mine" / "start.md").exists()
    settings = (server.SETTINGS / "labconfig" / "default_setting_overrides.json").read_text()
    assert '"markdown": "Markdown Preview"' in settings
    assert '"fetchNews": "false"' in settings


def test_the_style_sheet_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """That of the user comes first."""
    monkeypatch.setenv("JUPYTER_CONFIG_DIR", str(tmp_path))
    settings = PyFileConfigLoader("jupyter_server_config.py", str(server.SETTINGS)).load_config()
    assert settings.LabApp.custom_css
    first, last = settings.ServerApp.tornado_settings["static_custom_path"]
    assert first == str(tmp_path / "custom")
    assert Path(last, "custom.css").exists()


def test_what_is_compiled_in_the_background(monkeypatch: pytest.MonkeyPatch) -> None:
    """With the lowest priority; a lesson that fails does not stop those after it."""
    done: list[Any] = []

    def fails() -> None:
        raise RuntimeError

    kinds: list[Any] = [{"warm_up": fails}, {"warm_up": lambda: done.append("b"), "report": fails}]
    kinds += [{"report": lambda **how: done.append(how)}]
    names = [f"edugym_course.lessons.{name}.experiments" for name in "abc"]
    modules = {name: SimpleNamespace(**kind) for name, kind in zip(names, kinds, strict=True)}
    monkeypatch.setattr(warnings, "simplefilter", done.append)
    monkeypatch.setattr(importlib, "import_module", modules.__getitem__)
    monkeypatch.setattr(os, "setpriority", lambda kind, process, priority: done.append(priority))
    monkeypatch.setattr(threading.Thread, "start", lambda self: done.append((self.daemon, self._target)))
    warm_up.main("abxc")
    assert done == [19, (True, warm_up._end_with_standard_input), "ignore", "b", {"repetitions": 2, "jobs": 1}]
