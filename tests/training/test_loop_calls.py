"""What the loops call, in which order and with what, written out for a task of a few steps."""

from typing import Any, cast

import numpy as np
import pytest
from gymnasium import spaces

from edugym.training import gymnasium_loops, loops
from edugym.training.trainers import new_log

ENV, AGENT = cast(Any, "env"), cast(Any, "agent")
"""Names in place of the two random streams."""


class Watched:
    """A task of some steps and an agent whose actions are 7, 8, 9, ..., which note every call."""

    def __init__(self, end: int) -> None:
        """The task ends in the state `end`."""
        self.end, self.calls, self.chosen = end, list[str](), 6

    def initial(self, rng: str) -> int:
        """State 0."""
        self.calls.append(f"initial {rng}")
        return 0

    def transition(self, state: int, action: int, rng: str) -> int:
        """The next one."""
        self.calls.append(f"transition {state} {action} {rng}")
        return state + 1

    def reward(self, state: int, action: int, next_state: int, rng: str) -> float:
        """A number that has all three as digits."""
        self.calls.append(f"reward {state} {action} {next_state} {rng}")
        return float(100 * state + 10 * action + next_state)

    def terminal(self, state: int) -> bool:
        """Only the last."""
        self.calls.append(f"terminal {state}")
        return state == self.end

    def observation(self, state: int, rng: str) -> str:
        """Its name."""
        self.calls.append(f"observation {state} {rng}")
        return f"o{state}"

    def act(self, observation: str, rng: str) -> int:
        """Another one each time."""
        self.calls.append(f"act {observation} {rng}")
        self.chosen += 1
        return self.chosen

    def learn(self, *told: Any) -> None:
        """All that is told."""
        self.calls.append(" ".join(["learn", *map(str, told)]))


def step(state: int, action: int, *see: str) -> list[str]:
    """What every step asks the task."""
    after = state + 1
    return [
        f"transition {state} {action} env", f"reward {state} {action} {after} env", f"terminal {after}",
        *(f"observation {after} env" for _ in see),
    ]  # fmt: skip


BEGIN = ["initial env", "observation 0 env"]


@pytest.mark.parametrize(
    ("end", "limit", "second"),
    [(2, 9, "True False"), (2, 2, "True False"), (3, 2, "False True")],
    ids=["an end", "an end at the limit", "the limit"],
)
def test_off_policy(end: int, limit: int, second: str) -> None:
    """An episode of two steps, and the first of another: act, move, learn."""
    watched, log = Watched(end), new_log()
    mdp: Any = watched
    start = loops.start_off_policy(mdp, ENV)
    assert start == (0, "o0", 0, 0.0)
    moment = loops.off_policy(3, mdp, watched, limit, ENV, AGENT, log, start)
    assert watched.calls == [
        *BEGIN,
        "act o0 agent", *step(0, 7, "see"), "learn o0 7 71.0 o1 False False",
        "act o1 agent", *step(1, 8, "see"), f"learn o1 8 182.0 o2 {second}", *BEGIN,
        "act o0 agent", *step(0, 9, "see"), "learn o0 9 91.0 o1 False False",
    ]  # fmt: skip
    assert (log.returns.tolist(), log.episodes.tolist()) == ([71.0 + 182.0], [1])
    assert moment == (1, "o1", 1, 91.0)


@pytest.mark.parametrize(
    ("end", "limit", "second", "choice", "third"),
    [
        (2, 9, "8 True False", [], 9),  # there is no next action: the last one stands in its place
        (2, 2, "8 True False", [], 9),
        (3, 2, "9 False True", ["act o2 agent"], 10),  # one is chosen to learn from, and never taken
    ],
    ids=["an end", "an end at the limit", "the limit"],
)
def test_on_policy(end: int, limit: int, second: str, choice: list[str], third: int) -> None:
    """The same two steps and one more: move, choose the next action, learn."""
    watched, log = Watched(end), new_log()
    mdp: Any = watched
    start = loops.start_on_policy(mdp, mdp, ENV, AGENT)
    assert start == (0, "o0", 7, 0, 0.0)
    moment = loops.on_policy(3, mdp, watched, limit, ENV, AGENT, log, start)
    assert watched.calls == [
        *BEGIN, "act o0 agent",
        *step(0, 7, "see"), "act o1 agent", "learn o0 7 71.0 o1 8 False False",
        *step(1, 8, "see"), *choice, f"learn o1 8 182.0 o2 {second}", *BEGIN, "act o0 agent",
        *step(0, third, "see"), "act o1 agent", f"learn o0 {third} {10.0 * third + 1} o1 {third + 1} False False",
    ]  # fmt: skip
    assert (log.returns.tolist(), log.episodes.tolist()) == ([71.0 + 182.0], [1])
    assert moment == (1, "o1", third + 1, 1, 10.0 * third + 1)


@pytest.mark.parametrize(("end", "limit"), [(2, 9), (2, 2), (3, 2)])
def test_playing(end: int, limit: int) -> None:
    """Two episodes of two steps, without learning."""
    watched, returns = Watched(end), np.zeros(2)
    mdp: Any = watched
    loops.play_episodes(2, mdp, mdp, limit, ENV, AGENT, returns)
    assert watched.calls == [
        call
        for first in (7, 9)
        for call in (
            *BEGIN, "act o0 agent", *step(0, first),
            "observation 1 env", "act o1 agent", *step(1, first + 1),
        )
    ]  # fmt: skip
    assert returns.tolist() == [71.0 + 182.0, 91.0 + 202.0]


class WatchedEnvironment(Watched):
    """The same task as an environment, which may also truncate by itself."""

    action_space = spaces.Discrete(99)
    state = 0

    def __init__(self, end: int, cut: int) -> None:
        """It truncates in the state `cut`."""
        super().__init__(end)
        self.cut = cut

    def reset(self, seed: int | None = None) -> Any:
        """State 0."""
        self.calls.append(f"reset {seed}")
        self.state = 0
        return "o0", {}

    def step(self, action: int) -> Any:
        """The next one; the reward is that of the task."""
        self.calls.append(f"step {action}")
        self.state += 1
        reward = np.float32(100 * (self.state - 1) + 10 * action + self.state)
        return f"o{self.state}", reward, self.state == self.end, self.state == self.cut, {}


ENDS = pytest.mark.parametrize(
    ("end", "cut", "limit", "terminated"),
    [(2, 9, 9, True), (2, 9, 2, True), (2, 2, 9, True), (9, 2, 9, False), (9, 9, 2, False)],
    ids=["an end", "an end at the limit", "an end that is cut off", "cut off", "the limit"],
)


@ENDS
def test_off_policy_in_an_environment(end: int, cut: int, limit: int, terminated: bool) -> None:
    """The same steps."""
    env, log = WatchedEnvironment(end, cut), new_log()
    env_of_any_kind: Any = env
    moment = gymnasium_loops.off_policy(3, env_of_any_kind, env, limit, AGENT, log, (None, "o0", 0, 0.0))
    assert env.calls == [
        "act o0 agent", "step 7", "learn o0 7 71.0 o1 False False",
        "act o1 agent", "step 8", f"learn o1 8 182.0 o2 {terminated} {not terminated}", "reset None",
        "act o0 agent", "step 9", "learn o0 9 91.0 o1 False False",
    ]  # fmt: skip
    assert (log.returns.tolist(), log.episodes.tolist()) == ([71.0 + 182.0], [1])
    assert moment == (None, "o1", 1, 91.0)


@ENDS
def test_on_policy_in_an_environment(end: int, cut: int, limit: int, terminated: bool) -> None:
    """The same steps."""
    env, log = WatchedEnvironment(end, cut), new_log()
    env_of_any_kind: Any = env
    moment = gymnasium_loops.on_policy(3, env_of_any_kind, env, limit, AGENT, log, (None, "o0", 6, 0, 0.0))
    choice, third = ([], 8) if terminated else (["act o2 agent"], 9)
    assert env.calls == [
        "step 6", "act o1 agent", "learn o0 6 61.0 o1 7 False False",
        "step 7", *choice, f"learn o1 7 172.0 o2 {third - 1} {terminated} {not terminated}", "reset None",
        "act o0 agent", f"step {third}", "act o1 agent",
        f"learn o0 {third} {10.0 * third + 1} o1 {third + 1} False False",
    ]  # fmt: skip
    assert (log.returns.tolist(), log.episodes.tolist()) == ([61.0 + 172.0], [1])
    assert moment == (None, "o1", third + 1, 1, 10.0 * third + 1)


@ENDS
def test_playing_in_an_environment(end: int, cut: int, limit: int, terminated: bool) -> None:
    """An episode from a seed of the environment's stream."""
    env = WatchedEnvironment(end, cut)
    env_of_any_kind: Any = env
    total = gymnasium_loops.play_episode(env_of_any_kind, env_of_any_kind, limit, np.random.default_rng(3), AGENT)
    seed = int(np.random.default_rng(3).integers(2**31))
    assert env.calls == [f"reset {seed}", "act o0 agent", "step 7", "act o1 agent", "step 8"]
    assert total == 71.0 + 182.0
