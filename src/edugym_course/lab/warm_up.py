"""Compile what the lessons need, in a process of its own: `python -m edugym_course.lab.warm_up exploration ...`.

The process has the lowest priority, and ends when its standard input is closed: with the process that started it,
whatever ends that one.
"""

import contextlib
import importlib
import os
import subprocess
import sys
import threading
import warnings
from collections.abc import Iterator, Sequence


@contextlib.contextmanager
def warming_up(lessons: Sequence[str]) -> Iterator["subprocess.Popen[bytes]"]:
    """Warm up lessons in a process in the background while the block runs; see `main`."""
    command = [sys.executable, "-P", "-m", "edugym_course.lab.warm_up", *lessons]  # -P: no module of the present folder
    with subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,  # Ctrl-C in the terminal is not for this process
        creationflags=getattr(subprocess, "IDLE_PRIORITY_CLASS", 0),  # on Windows, in place of `os.nice`
    ) as process:
        try:
            yield process
        finally:
            process.kill()


def main(lessons: Sequence[str]) -> None:
    """Call what compiles the code of each lesson.

    It is the function `warm_up()` of the lesson's experiments; without one, all of them run with two repetitions.
    A lesson that fails here says so when the student runs it.
    """
    if hasattr(os, "setpriority"):
        os.setpriority(os.PRIO_PROCESS, 0, 19)  # whatever the priority of the process that started this one
    threading.Thread(target=_end_with_standard_input, daemon=True).start()
    warnings.simplefilter("ignore")
    for lesson in lessons:
        with contextlib.suppress(Exception):
            experiments = importlib.import_module(f"edugym_course.lessons.{lesson}.experiments")
            if hasattr(experiments, "warm_up"):
                experiments.warm_up()
            else:
                experiments.report(repetitions=2, jobs=1)


def _end_with_standard_input() -> None:
    sys.stdin.read()
    os._exit(0)


if __name__ == "__main__":
    main(sys.argv[1:])
