"""Programs that never end by themselves: `python -m tests.compiled.unending HOW` says how one of them was stopped."""

import functools
import os
import re
import signal
import sys
import threading
import time
import warnings
from typing import Any

import numpy as np

import edugym
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.compiled import execution
from edugym.system.interrupts import Interrupted
from tests.compiled.cells import cell

PATIENT = 20_000  # steps before the first that does not end
SOME_SECONDS = 3.0  # of processor time: compiling takes one or two
BOULDER = "edugym/Boulder-v0"


NOTEBOOK = cell(f"""
class Waiting(NamedTuple):
    count: np.ndarray  # the actions, and whether it waits
    def act(self, state, rng):
        self.count[0] += 1
        while self.count[0] > {PATIENT}:
            self.count[1] = 1
        return int(rng.integers(2))
    def learn(self, state, action, reward, next_state): pass

class Interpreted:
    def __init__(self): self.count = np.zeros(2)
    act, learn = Waiting.act, Waiting.learn

class Circle(NamedTuple):
    last: int  # the state from which a step does not end
    rich: int  # the state from which every step has a reward
    observation_space = property(lambda self: spaces.Discrete(2))
    action_space = property(lambda self: spaces.Discrete(2))
    def initial(self, rng): return 0
    def transition(self, state, action, rng):
        while state >= self.last:
            action = 1 - action
        return state + 1
    def reward(self, state, action, next_state, rng): return 1.0 if state >= self.rich else 0.0
    def terminal(self, state): return False
    def observation(self, state, rng): return state % 2
""")
Waiting, Interpreted, Circle = (NOTEBOOK[name] for name in ("Waiting", "Interpreted", "Circle"))


class Timeout(Exception):
    """What the handler of another signal raises."""


def stopped_by(error: type[BaseException], work: Any, press: Any, waits: Any = None) -> Any:
    """Let it work, press when it waits (or after some seconds), and return the error that ends it."""

    def when_it_waits() -> None:
        began = time.process_time()
        while not waits() if waits else time.process_time() - began < SOME_SECONDS:
            time.sleep(0.05)
        press()

    threading.Thread(target=when_it_waits).start()
    try:
        return work()
    except error as raised:
        return raised


def ctrl_c() -> None:
    """Press Ctrl-C."""
    os.kill(os.getpid(), signal.SIGINT)


def train(agent: Any, task: Any = BOULDER, max_steps: int = 100, stop: Any = None) -> Any:
    """Train it for ever, without evaluating it on the way."""
    return edugym.train(task, agent, 10**9, evaluate_every=10**9, max_steps=max_steps, stop=stop)


def training() -> None:
    """Ctrl-C, another signal whose handler raises its own error, and the order to stop reach machine code.

    The tables are then those of the last whole chunk of steps.
    """

    def expire(number: int, frame: Any) -> None:
        raise Timeout

    signal.signal(signal.SIGALRM, expire)
    agent, stop = Waiting(np.zeros(2)), threading.Event()
    alarm = functools.partial(os.kill, os.getpid(), signal.SIGALRM)
    stopped = stopped_by(Interrupted, lambda: train(agent), ctrl_c, lambda: agent.count[1])
    print(*re.findall(r"in the loop at line \d+ of your code", str(stopped)))
    print(stopped.partial.complete, 0 < agent.count[0] <= PATIENT, agent.count[1])
    print(type(stopped_by(Timeout, lambda: train(agent), alarm, lambda: agent.count[1])).__name__)
    agent.count[0] = 0  # else the rehearsal may come to the loop without end, where no `stop` reaches plain Python
    print(stopped_by(Interrupted, lambda: train(agent, stop=stop), stop.set, lambda: agent.count[1]).complete)


def in_threads() -> None:
    """After Ctrl-C no thread goes on. A compilation would, to its end: so a shorter run comes first."""
    edugym.repeat(BOULDER, {"waiting": Waiting(np.zeros(2))}, n_steps=PATIENT // 2, repetitions=2, jobs=2)
    for agent in (Waiting(np.zeros(2)), Interpreted()):
        repeat = functools.partial(edugym.repeat, BOULDER, {"waiting": agent}, n_steps=10**9, repetitions=2, jobs=2)
        stopped = stopped_by(Interrupted, functools.partial(repeat, evaluate_every=10**9), ctrl_c)
        time.sleep(1.0)
        began = time.process_time()
        time.sleep(0.5)
        print(type(stopped).__name__, time.process_time() - began < 0.25)


def vector() -> None:
    """The copies are where they were before the step that does not end."""
    copies = MDPVectorEnv(Circle(last=300, rich=0), 100)
    copies.reset(seed=0)
    for _ in range(300):
        copies.step(np.zeros(100, np.int64))
    stopped = stopped_by(KeyboardInterrupt, lambda: copies.step(np.zeros(100, np.int64)), ctrl_c)
    print(isinstance(stopped, KeyboardInterrupt), copies.state(0), copies.state(99))


def planning() -> None:
    """An agent of the package plans for ever where values grow without end."""
    endless = edugym.PrioritisedSweeping.create((2, 2), discount=1.0, planning_steps=float("inf"))
    stopped = stopped_by(Interrupted, lambda: train(endless, Circle(last=10**12, rich=1000), PATIENT), ctrl_c)
    print(type(stopped).__name__)


def evaluation() -> None:
    """An evaluation episode of a task without end is one call of machine code."""
    agent = edugym.QLearning.create((2, 2))
    stopped = stopped_by(Interrupted, lambda: train(agent, Circle(last=10**12, rich=0), 10**12), ctrl_c)
    print(type(stopped).__name__, stopped.partial.steps.size)


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)
    warnings.simplefilter("ignore")
    vars(execution)["seconds_to_build"] = lambda: 0.0
    globals()[sys.argv[1]]()
