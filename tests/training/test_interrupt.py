"""Ctrl-C: in a process of its own, since it would otherwise interrupt the tests."""

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = """
import os, signal, sys, threading, warnings
import gymnasium
from edugym import QLearning, train
from edugym.experiments import training

how, env_id = sys.argv[1:]
environment = gymnasium.make(env_id)
agent = QLearning.create(environment, initial_value=1.0)
if how == "interpreted":
    training.executable = lambda loop, *arguments, **options: loop
train(environment, agent, 6_000)  # what has to be compiled is compiled
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    run = train(environment, agent, 10**13, evaluate_every=20_000)
print([str(warning.message) for warning in caught])
print(run.complete, len(run.steps) == len(run.returns) == len(run.episodes), run.steps[0], run.agent.Q is agent.Q)
print((agent.Q != 1.0).any())
"""


@pytest.mark.parametrize(
    ("how", "env_id"),
    [
        ("compiled", "edugym/Boulder-v0"),
        ("compiled", "edugym/Golf-v0"),
        ("compiled", "edugym/MemoryCorridor-v0"),
        ("interpreted", "edugym/Boulder-v0"),
        ("gymnasium", "FrozenLake-v1"),
    ],
)
def test_ctrl_c_returns_what_is_done(how: str, env_id: str, tmp_path: Path) -> None:
    """The run so far, marked as incomplete, with a warning that says so; the interpreter goes on.

    States that are numbers, NamedTuples, and hold arrays: the latter two crash where the signal is not waited for.
    """
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    done = subprocess.run(
        [sys.executable, script, how, env_id], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.stderr == ""
    warned, partial, learned = done.stdout.splitlines()
    assert warned.startswith("['interrupted after ")
    assert warned.endswith(" of 10000000000000 steps: this is what was done']")
    assert partial == "False True 0 True"
    assert learned == "True"
