"""Open JupyterLab on a student's folder."""

import os
from collections.abc import Sequence
from pathlib import Path
from urllib.parse import quote

from edugym.system.extras import require
from edugym.system.files import check_writable
from edugym_course.lab.delivery import deliver
from edugym_course.lab.lessons import student_lessons
from edugym_course.lab.records import DELIVERED, HIDDEN, without_number
from edugym_course.lab.start_page import write_start_page
from edugym_course.lab.warm_up import warming_up

SETTINGS = Path(__file__).parent / "jupyter"
"""Settings of JupyterLab, and a style sheet for phones: Markdown is shown as a page, and no news are fetched.

Those of the user come first.
"""


def require_jupyterlab() -> None:
    """Refuse to go on without JupyterLab and what the lessons need.

    Raises:
        gymnasium.error.DependencyNotInstalled: a library is missing.
    """
    require("lab", "jupyterlab", "ipywidgets", "matplotlib")


def prepare(folder: Path) -> list[str]:
    """Put fresh lessons and the start page into a student's folder.

    Returns:
        For each lesson that the student has changed, and of which there is a newer version: one sentence.

    Raises:
        OSError: nothing can be written there.
    """
    check_writable(folder / DELIVERED)
    messages = []
    for lesson in student_lessons():
        path = folder / f"{lesson.name}.ipynb"
        place = deliver(lesson.text, path)
        if place != path:
            messages.append(f"{path.name} has your changes and stays as it is; the new version is in {place.name}")
    write_start_page(folder)
    return messages


def serve(folder: Path, options: Sequence[str]) -> None:
    """Run JupyterLab at the start page until Ctrl-C or a signal ends it, and warm up the lessons meanwhile.

    Args:
        folder: the student's folder, as `prepare` has left it.
        options: options of JupyterLab; they overrule those that are set here.

    """
    from jupyterlab.labapp import LabApp

    folder = folder.resolve()
    start_page = write_start_page(folder)
    paths = [str(SETTINGS), *filter(None, [os.environ.get("JUPYTER_CONFIG_PATH")])]
    os.environ["JUPYTER_CONFIG_PATH"] = os.pathsep.join(paths)
    arguments = [
        f"--ServerApp.root_dir={folder}",
        f"--LabApp.default_url=/lab/tree/{quote(start_page.name)}",
        f"--LabApp.workspaces_dir={folder / HIDDEN / 'workspaces'}",  # with the tabs that are open in this folder
        "--ServerApp.answer_yes=True",  # Ctrl-C needs no second word
        "--log-level=WARN",
        *options,
    ]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        arguments.append("--allow-root")  # JupyterLab refuses to run as root, as in a container, unless told so
    with warming_up([without_number(lesson.name) for lesson in student_lessons()]):
        LabApp.launch_instance(arguments)
