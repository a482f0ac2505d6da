"""Whose code is whose: this package's, an installed one's, or a user's."""

import os
import site
from pathlib import Path

import numpy as np
import pytest

import edugym
import edugym_course
from edugym import QLearning
from edugym.system.packages import is_installed, is_ours, own_folders, package_of


@pytest.mark.parametrize(
    ("place", "installed"),
    [
        (np.__file__, True),
        (os.__file__, True),
        (f"{site.getusersitepackages()}/mine/code.py", True),  # where `pip install --user` puts packages
        ("/usr/lib/python3/dist-packages/mine.py", True),
        (__file__, False),
        ("/home/me/lessons/mine.py", False),
        (Path.cwd(), False),
    ],
)
def test_what_is_installed(place: str | Path, installed: bool) -> None:
    """Whatever is in the folders of Python and its packages: a virtual environment's, a user's or the system's."""
    assert is_installed(place) is installed


def test_what_is_ours() -> None:
    """Both packages of the distribution, and nothing else."""
    assert own_folders() == [Path(package.__path__[0]) for package in (edugym, edugym_course)]
    assert [is_ours(thing) for thing in (edugym, QLearning, edugym_course, np, Path, 3)] == [True] * 3 + [False] * 3
    assert [package_of(thing) for thing in (QLearning, np.linalg, 3)] == ["edugym", "numpy", ""]
