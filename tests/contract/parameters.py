"""The parameters of every environment: `PARAMETERS` in its test file, found by its name.

An environment joins the contract tests by its file and its test file.
"""

import importlib
from pathlib import Path

from edugym.adapters.registration import ENVIRONMENTS, Entry
from tests.contract.described import Keywords, Parameters

__all__ = ["PARAMETERS", "Keywords", "Parameters"]


def _described(entry: Entry) -> Parameters:
    """What the test file of an environment says; a folder of tests has it in `test_task.py`."""
    name = entry.module.rpartition(".")[2]
    folder = Path(__file__).parents[1] / "envs" / name
    module = f"tests.envs.{name}.test_task" if folder.is_dir() else f"tests.envs.test_{name}"
    described: Parameters = importlib.import_module(module).PARAMETERS
    return described


PARAMETERS = {entry.name: _described(entry) for entry in ENVIRONMENTS}
