"""Signals to processes that work, most at random moments: none is lost, and each is soon answered."""

import os
import re
import signal
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

START = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
print("begun", flush=True)
"""
WORK = {
    "train": """
from edugym import QLearning, make_mdp, train
while True:
    mdp = make_mdp("Boulder")
    train(mdp, QLearning.create(mdp), 3_000_000)
""",
    "interpreted": """
import gymnasium
from edugym import QLearning, train
while True:
    env = gymnasium.make("CliffWalking-v1")
    train(env, QLearning.create(env), 20_000, max_steps=100)
""",
    "repeat": """
from edugym import CountBased, QLearning, repeat
for i in range(1_000):
    agents = {"Q": QLearning.create, "novelty": CountBased.create}
    repeat("Boulder", agents, 100_000, repetitions=4, jobs=2, save_to=f"{sys.argv[1]}/{i}.csv")
""",
    "processes": """
import joblib
from edugym import QLearning, repeat
if __name__ == "__main__":
    with joblib.parallel_config(backend="loky", n_jobs=2):
        for _ in range(1_000):
            repeat("CliffWalking-v1", {"Q": QLearning.create}, 3_000, repetitions=4, max_steps=100, jobs=None)
""",
    "reproduce": """
from edugym_course.cli import main
sys.argv = ["edugym", "reproduce", "exploration", "--repetitions", "9", "--output", sys.argv[1]]
main()
""",
}


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("kind", WORK)
def test_ctrl_c_ends_the_work(kind: str, seed: int, tmp_path: Path) -> None:
    """Whether it imports, compiles, trains or saves, the process ends and does not crash; some have a cold cache."""
    moment = np.random.default_rng([seed, list(WORK).index(kind)]).uniform(0, 3)
    environment = os.environ | ({"EDUGYM_CACHE_DIR": str(tmp_path / "cache")} if seed == 0 else {})
    command, pipe = [sys.executable, "-c", START + WORK[kind], str(tmp_path)], subprocess.PIPE
    with subprocess.Popen(command, env=environment, stdout=pipe, stderr=pipe, text=True) as child:
        try:
            assert child.stdout is not None
            assert child.stdout.readline() == "begun\n"
            threading.Event().wait(moment)
            child.send_signal(signal.SIGINT)
            _, said = child.communicate(timeout=60)
        finally:
            child.kill()
    assert child.returncode in (1, 130, -signal.SIGINT), said
    last = said.splitlines()[-1]
    assert last.startswith(("KeyboardInterrupt", "edugym.system.interrupts.Interrupted: ", "edugym: interrupted")), said


SCRIPT = """
import os, signal, sys, threading
import gymnasium
from edugym import QLearning, train
from edugym.system.interrupts import Interrupted
from edugym.training import trainers

class Timeout(Exception):
    pass

def expire(number, frame):
    raise Timeout

how, env_id = sys.argv[1:]
signal.signal(signal.SIGINT, signal.default_int_handler)
environment = gymnasium.make(env_id)
agent = QLearning.create(environment, initial_value=1.0)
if how == "interpreted":
    trainers.executable = lambda loop, *arguments, **options: loop
train(environment, agent, 200_000 if how in ("compiled", "alarm") else 100)  # what has to be compiled is compiled
number = signal.SIGINT
if how == "alarm":
    number = signal.SIGALRM
    signal.signal(number, expire)
threading.Timer(0.5, lambda: os.kill(os.getpid(), number)).start()
try:
    train(environment, agent, 10**13, evaluate_every=20_000, stop=threading.Event())
except Interrupted as interrupted:
    run = interrupted.partial
    print(interrupted)
    print(run.complete, len(run.steps) == len(run.returns) == len(run.episodes), run.steps[0], run.agent.Q is agent.Q)
except Timeout:
    print("timeout")
print((agent.Q != 1.0).any())
"""


@pytest.mark.parametrize(
    ("how", "env_id"),
    [
        ("compiled", "edugym/Golf-v0"),
        ("gymnasium", "FrozenLake-v1"),
        pytest.param("compiled", "edugym/MemoryCorridor-v0", marks=pytest.mark.slow),
        pytest.param("alarm", "edugym/Golf-v0", marks=pytest.mark.slow),
        pytest.param("interpreted", "edugym/Boulder-v0", marks=pytest.mark.slow),
    ],
)
def test_a_signal_ends_a_run(how: str, env_id: str) -> None:
    """What is done is kept, and the interpreter goes on; a handler of another signal raises its own error."""
    command = [sys.executable, "-c", SCRIPT, how, env_id]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert done.stderr == ""
    *said, learned = done.stdout.splitlines()
    if how == "alarm":
        assert said == ["timeout"]
    else:
        assert re.fullmatch(r"after \d+ of 10000000000000 steps; the agent keeps what it has learned", said[0])
        assert said[1] == "False True 0 True"
    assert learned == "True"
