"""What training asks the task and the agent, in which order and with which random stream: every call, written out."""

from types import SimpleNamespace
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces

from edugym import train
from edugym.checks.mdps import CHECKED_STEPS
from tests.compiled.cells import cell


def streams() -> dict[str, np.random.Generator]:
    """The streams of a run with seed 0, by their names."""
    names = ("env", "agent", "play", "actor")
    children = np.random.SeedSequence(0).spawn(4)
    return {name: np.random.default_rng(child) for name, child in zip(names, children, strict=True)}


def place(rng: Any) -> Any:
    """Where a stream is."""
    return rng.bit_generator.state["state"]["state"]


NAMES = {place(rng): name for name, rng in streams().items()}


CLASSES = """
class Stairs:
    observation_space, action_space = spaces.Discrete(20), spaces.Discrete(999)
    def __init__(self, end): self.end = end
    def initial(self, rng): note("initial", rng); return 0
    def transition(self, state, action, rng): note("transition", state, action, rng); return state + 1
    def reward(self, state, action, after, rng): note("reward", state, action, after, rng); return paid(state, action)
    def terminal(self, state): note("terminal", state); return state == self.end
    def observation(self, state, rng): note("observation", state, rng); return state + 10

class Environment(gymnasium.Env):
    observation_space, action_space = spaces.Discrete(20), spaces.Discrete(999)
    def __init__(self, end, cut): self.end, self.cut = end, cut
    def reset(self, *, seed=None, options=None):
        note("reset", seed)
        self.state = 0
        return 10, {}
    def step(self, action):
        note("step", action)
        self.state += 1
        ends = self.state == self.end, self.state == self.cut
        return self.state + 10, np.float32(paid(self.state - 1, action)), *ends, {}

class OffPolicy:
    chosen = 6
    def act(self, state, rng):
        note("act", state, rng)
        self.chosen += 1
        return self.chosen
    def greedy(self, state, rng): note("greedy", state, rng); return 3
    def learn(self, state, action, reward, next_state, terminated, truncated):
        note("learn", state, action, reward, next_state, terminated, truncated)

class OnPolicy(OffPolicy):
    def learn(self, state, action, reward, next_state, next_action, terminated, truncated):
        note("learn", state, action, reward, next_state, next_action, terminated, truncated)
"""
"""A task of some steps, in which the agent sees ten more than the state; and agents whose actions are 7, 8, 9, ..."""


def noting(calls: list[str]) -> SimpleNamespace:
    """These classes, which note every call."""

    def note(*what: Any) -> None:
        calls.append(" ".join(NAMES[place(one)] if hasattr(one, "random") else str(one) for one in what))

    def paid(state: int, action: int) -> float:
        return float(100 * state + 10 * action + state + 1)

    known = {"note": note, "paid": paid, "np": np, "spaces": spaces, "gymnasium": gymnasium, "__name__": "__main__"}
    return SimpleNamespace(**cell(CLASSES, known))


def step(state: int, action: int, rng: str, *see: str) -> list[str]:
    """What every step asks the task."""
    after = state + 1
    asked = [f"transition {state} {action} {rng}", f"reward {state} {action} {after} {rng}", f"terminal {after}"]
    return asked + [f"observation {after} {rng}" for _ in see]


BEGIN = ["initial env", "terminal 0", "observation 0 env"]
PLAYED = [
    "initial play", "terminal 0", "observation 0 play", "greedy 10 actor", *step(0, 3, "play"),
    "observation 1 play", "greedy 11 actor", *step(1, 3, "play"),
]  # fmt: skip
"""An evaluation episode of two steps."""
TASKS = {
    "an end": ("Stairs", (2,), 9, True),
    "an end at the limit": ("Stairs", (2,), 2, True),
    "the limit": ("Stairs", (3,), 2, False),
    "an environment's end": ("Environment", (2, 9), 9, True),
    "an environment's end at the limit": ("Environment", (2, 9), 2, True),
    "an environment's end that is cut off": ("Environment", (2, 2), 9, True),
    "an environment that cuts off": ("Environment", (9, 2), 9, False),
    "an environment with a limit": ("Environment", (9, 9), 2, False),
}


@pytest.mark.parametrize("name", TASKS)
@pytest.mark.parametrize("kind", ["OffPolicy", "OnPolicy"])
def test_every_call(kind: str, name: str) -> None:
    """Of two steps, and the first of another episode; after the limit SARSA chooses an action that is never taken."""
    task, ends, limit, terminated = TASKS[name]
    calls: list[str] = []
    classes, rngs = noting(calls), streams()
    run = train(getattr(classes, task)(*ends), getattr(classes, kind)(), 3, max_steps=limit, evaluate_every=3)
    if task == "Stairs":
        begin, again, played = BEGIN, BEGIN, [PLAYED, PLAYED]
    else:
        begin, again = [f"reset {rngs['env'].integers(2**31)}"], ["reset None"]
        steps = ["greedy 10 actor", "step 3", "greedy 11 actor", "step 3"]
        played = [[f"reset {rngs['play'].integers(2**31)}", *steps] for _ in range(2)]

    def took(state: int, action: int) -> list[str]:
        return step(state, action, "env", "see") if task == "Stairs" else [f"step {action}"]

    end = f"{terminated} {not terminated}"
    if kind == "OffPolicy":
        learned = [
            "act 10 agent", *took(0, 7), "learn 10 7 71.0 11 False False",
            "act 11 agent", *took(1, 8), f"learn 11 8 182.0 12 {end}", *again,
            "act 10 agent", *took(0, 9), "learn 10 9 91.0 11 False False",
        ]  # fmt: skip
        expected = [*begin, *played[0], *learned, *played[1]]
    else:
        choice, action = ([], 9) if terminated else (["act 12 agent"], 10)
        learned = [
            *took(0, 7), "act 11 agent", "learn 10 7 71.0 11 8 False False",
            *took(1, 8), *choice, f"learn 11 8 182.0 12 {action - 1} {end}", *again, "act 10 agent",
            *took(0, action), "act 11 agent", f"learn 10 {action} {10.0 * action + 1} 11 {action + 1} False False",
        ]  # fmt: skip
        expected = [*begin, "act 10 agent", *played[0], *learned, *played[1]]
    assert calls == expected
    assert run.returns.tolist() == [31.0 + 132.0] * 2
    assert (run.training_returns[1], run.episodes.tolist()) == (71.0 + 182.0, [0, 1])


@pytest.mark.parametrize("kind", ["OffPolicy", "OnPolicy"])
def test_no_step_counts_twice_when_checks_end(kind: str) -> None:
    """After some steps an agent is asked without a detour."""
    calls: list[str] = []
    classes, n_steps = noting(calls), CHECKED_STEPS + 9
    train(classes.Stairs(2), getattr(classes, kind)(), n_steps, evaluate_every=n_steps)
    assert sum(call.startswith("learn ") for call in calls) == n_steps
