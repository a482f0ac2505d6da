"""Ctrl-C at random moments of every kind of work: none is lost, and each is soon answered."""

import os
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
    "many updates a step": """
from typing import NamedTuple
import numpy as np
from edugym import make_mdp, train
class Sweeping(NamedTuple):
    Q: np.ndarray
    def act(self, state, rng):
        return int(rng.random() * 2)
    def learn(self, state, action, reward):
        for k in range(1100):
            self.Q[state, action] += 0.001 * (reward - self.Q[state, action])
while True:
    train(make_mdp("Boulder"), Sweeping(np.zeros((11, 2))), 30_000)
""",
    "repeat": """
from edugym import CountBased, QLearning, repeat
for i in range(1_000):
    agents = {"Q": QLearning.create, "novelty": CountBased.create}
    repeat("Boulder", agents, 100_000, repetitions=4, jobs=2, save_to=f"{sys.argv[1]}/{i}.csv")
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
    with subprocess.Popen(
        [sys.executable, "-c", START + WORK[kind], str(tmp_path)],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as child:
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
