"""What is an MDP and what is none, and what is looked at when one is checked (slips: tests/training/test_slips.py)."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym import ENVIRONMENTS, FrameStack, MDPEnv, QLearning, Tabular, check_mdp, finite_model, train
from edugym.envs.catch import CatchGrid
from tests.compiled.cells import WALK, cell
from tests.training.slips import END, LIMIT, MOVE, PAY, SEE, TRANSITION, changed, named, walk

Walk = cell(WALK)["Walk"]
BOULDER: Any = ENVIRONMENTS[0].load_mdp()
REWARDING = """
import gymnasium
class Rewarding(gymnasium.Env):
    def reward(self): return 1.0
"""
NO_MDPS = [
    (None, "mdp None"),
    (3, "mdp 3"),
    (Walk, "mdp Walk(...)"),
    (BOULDER, "mdp .create(...)"),
    ("Boulder", "mdp edugym.make_mdp('Boulder')"),
    (MDPEnv(Walk(3)), "mdp MDPEnv env.unwrapped.mdp"),
    (cell(REWARDING)["Rewarding"](), "mdp Rewarding"),
    (Tabular(Walk, np.array([6]), np.zeros(1, int), np.zeros(1, int)), "mdp Tabular Walk(...)"),
    (Tabular(3, np.array([6]), np.zeros(1, int), np.zeros(1, int)), "mdp Tabular 3"),
    (FrameStack(walk(WALK.replace(TRANSITION, "def transition(self, state):")), 1, 6, 1, 1), "transition Walk (self,"),
]


@pytest.mark.parametrize(("wrong", "names"), NO_MDPS, ids=[names for _, names in NO_MDPS])
def test_what_is_no_mdp(wrong: Any, names: str) -> None:
    """The answer says what to pass instead."""
    for use in (check_mdp, MDPEnv, finite_model):
        named(names, lambda: use(wrong))  # noqa: B023


def test_what_is_not_misspelt() -> None:
    """What is hidden, what is spelt otherwise, `terminal`, which is wanted itself, and a space, which is no method."""
    cases = ("initial", "_initial"), ("initial", "begin"), ("observation", "look")
    for wanted, name in cases:
        task = walk(WALK.replace(f"def {wanted}(", f"def {name}("))
        assert "?" not in str(named(f"Walk {wanted}(self,", lambda: check_mdp(task)))  # noqa: B023


@pytest.mark.parametrize("names", ["('down',)", "['down', 'up', 'on']"])
def test_every_action_has_a_name(names: str) -> None:
    """One too few or too many is found; a dictionary may name only some, and several numbers have no names."""
    source = WALK.replace(LIMIT, f"    action_names = {names}\n\n{LIMIT}")
    named(f"action_names Walk 2 {names.count(',') * 2 - 1}", lambda: check_mdp(walk(source)))
    check_mdp(walk(WALK.replace(LIMIT, f"    action_names = {{'up': 1}}\n\n{LIMIT}")))
    check_mdp(walk(source.replace("Discrete(2)", "MultiDiscrete([2, 3])").replace("* action", "* action[0]")))


def test_step_limits() -> None:
    """A limit is a whole number of 1 or more, or None; a mistake inside the property is no "no limit"."""

    def limited(limit: str) -> Any:
        source = changed(changed(WALK, END, "return False"), MOVE, "return 0")
        return walk(changed(source, LIMIT, f"    max_steps = property(lambda self: {limit})\n\n{LIMIT}"))

    for wrong in ("-3", "2.5", "2**63", "0", "'ten'", "True"):
        named("max_steps", lambda: check_mdp(limited(wrong)))  # noqa: B023
    for right, episodes in (("None", 0), ("7", 10), ("np.int32(7)", 10)):
        task = limited(right)
        assert train(task, QLearning.create(task), 70).episodes.sum() == episodes
    for task in (limited("self.sise"), FrameStack(limited("self.sise"), 1, 6, 1, 1)):
        named("sise", lambda: check_mdp(task), AttributeError)  # noqa: B023


@pytest.mark.parametrize(
    ("space", "wrong"),
    [
        (spaces.Discrete(3, start=1), 0), (spaces.Discrete(3, start=1), 4), (spaces.Discrete(3), 3),
        (spaces.Box(0, 9, (2,)), 0), (spaces.MultiBinary(1), 0),
    ],
)  # fmt: skip
def test_whole_numbers_that_are_not_in_the_space(space: Any, wrong: int) -> None:
    """Whatever the space is, and wherever it starts."""
    mdp = cell(changed(WALK, SEE, f"return {wrong}\n"))["Walk"]
    task = type("Walk", (mdp,), {"__slots__": (), "observation_space": space})(5)
    named(f"observation Walk {space} {wrong}", lambda: check_mdp(task))


def test_the_answer_names_states_and_action() -> None:
    """What was given, in this order, and what came."""
    task = walk(WALK.replace("return 0\n", "return 3\n").replace(MOVE, "return 4").replace(PAY, "pass"))
    with pytest.raises(ValueError, match=r"reward of Walk .*None.* state 3, action [01], next state 4"):
        check_mdp(task)


@pytest.mark.parametrize("end", [1, 3])
def test_the_states_that_are_met(end: int) -> None:
    """Each step gives one, and after the end comes an initial one; it plays 200 steps where no number is given."""
    source = WALK.replace(MOVE, "return state + 1").replace("return 0\n", "return -1\n").replace(SEE, "return 0\n")
    mdp = cell(source)["Walk"]
    assert check_mdp(mdp(end), 7)[: end + 4] == [*range(-1, end + 1), -1, 0][: end + 4]
    assert len(check_mdp(mdp(10**6))) == 201


def test_what_is_right_passes() -> None:
    """NumPy's numbers and types that mean the same, and states that are copied and changed."""
    ordinary = "class Walk:\n    mdp = print\n    def __init__(self, n): self.size = n"
    for old, new in (
        (END, f"return np.bool_({END[7:]})"), (SEE, "return np.int8(state)\n"), (PAY, "return np.float32(1)"),
        (PAY, "return True"), ("class Walk(NamedTuple):\n    size: int", ordinary),
    ):  # fmt: skip
        check_mdp(walk(changed(WALK, old, new)), 20)
    board = WALK.replace("return 0\n", "return [0]\n").replace(SEE, "return 0\n")
    check_mdp(walk(changed(board, MOVE, "state = list(state); state[0] += action; return state")))
    for entry in ENVIRONMENTS:
        assert check_mdp(entry.load_mdp().create(), 20)
    counting = WALK.replace("size: int", "size: int\n    seen: np.ndarray").replace(MOVE, f"self.seen[0] += 1; {MOVE}")
    task = cell(counting)["Walk"](5, np.zeros(1))
    check_mdp(task)
    assert not task.seen.any()  # it has played a copy


def test_observations_that_are_written() -> None:
    """They are checked."""
    too_bright = {"__slots__": (), "observe_into": lambda self, state, rng, board: board.fill(9.0)}
    written: Any = type("Written", (CatchGrid,), too_bright)
    named("observation Written Box(", lambda: MDPEnv(written(4, 3)).reset(seed=0))


def test_spaces_of_several_parts() -> None:
    """Dictionaries and tuples are observations of a single environment."""
    space = "spaces.Dict(place=spaces.Discrete(6), picture=spaces.Box(0, 9, (2,)))"
    source = WALK.replace("spaces.Discrete(self.size + 1)", space)
    env = MDPEnv(walk(source.replace(SEE, "return {'place': state, 'picture': [state, 1]}\n")))
    assert isinstance(env.observation_space, spaces.Dict)
    assert env.observation_space.contains(env.reset(seed=0)[0])
    assert env.observation_space.contains(env.step(1)[0])
