"""Other processes, which find the modules that this one finds."""

import os
import subprocess
import sys


def started(program: str, *options: str, path: str = "", **variables: str) -> "subprocess.Popen[str]":
    """A process that runs a program."""
    folders = os.pathsep.join(filter(None, [path, *sys.path]))
    environment = os.environ | {"PYTHONPATH": folders, "PYTHONDONTWRITEBYTECODE": "1"} | variables
    command = [sys.executable, "-c", program, *options]
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def printed(program: str, *options: str, path: str = "", **variables: str) -> str:
    """What a program prints, which ends well."""
    process = started(program, *options, path=path, **variables)
    out, err = process.communicate(timeout=300)
    assert process.returncode == 0, (options, variables, err)
    return out
