"""Mistakes in a student's MDP are answered with one sentence, by the environment and by `check_mdp`."""

import traceback
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.registration import ENVIRONMENTS
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.checks.interfaces import require_mdp, step_limit
from edugym.checks.mdps import CheckedMDP, checked_mdp, refuse_nothing
from edugym.envs.catch import CatchGrid, Fall
from edugym.mdp.task import check_mdp, task_of
from edugym.system.packages import is_own
from tests.compiled.cells import WALK, cell
from tests.training.tasks import Stairs

MISTAKES = [
    ("return 1.0 if next_state == self.size else -0.25", "pass", r"reward .* a finite number, but returned None for "),
    ("return 1.0 if next_state == self.size else -0.25", "return 'a lot'", "reward .* but returned 'a lot'"),
    ("return 1.0 if next_state == self.size else -0.25", "return float('nan')", "reward .* but returned nan"),
    ("return state == self.size", "pass", r"terminal of Walk must return True or False, but returned None for state 1"),
    ("return state == self.size", "return 0.5", "terminal .* but returned 0.5"),
    (
        "return max(0, state + 2 * action - 1)",
        "max(0, state + 2 * action - 1)",
        r"transition .* the next state, but returned None for state 0, action 1 \(is a return missing\?\)",
    ),
    ("return state\n", "return None\n", "observation .* an element of Discrete.*, but returned None"),
    ("return state\n", "return state + 0.5\n", r"observation .* but returned 0.5 for state 0"),
    ("return state\n", "return state - 1\n", r"observation .* but returned -1 for state 0"),
    ("return state\n", "return [state]\n", r"observation .* but returned \[0\] for state 0"),
]


def walk(old: str, new: str, size: int = 5) -> Any:
    """The walk with a mistake."""
    assert WALK.count(old) == 1
    return cell(WALK.replace(old, new))["Walk"](size)


@pytest.mark.parametrize(("old", "new", "says"), MISTAKES)
def test_what_methods_return(old: str, new: str, says: str) -> None:
    """The sentence names the method, what it returned, the state, and what it should return."""
    task = walk(old, new)
    with pytest.raises(ValueError, match=says):
        check_mdp(task)
    env = MDPEnv(task)
    with pytest.raises(ValueError, match=says):
        episode(env)


def episode(env: MDPEnv[Any]) -> None:
    """Some first steps."""
    env.reset(seed=0)
    env.step(1)


STRUCTURE = [
    (
        "def initial(self, rng)",
        "def inital(self, rng)",
        r"must have a method initial\(self, rng\); is 'inital' misspelt\?",
    ),
    (
        "def transition(self, state, action, rng)",
        "def transition(self, state, action)",
        r"transition of Walk must take \(self, state, action, rng\), but takes \(self, state, action\)",
    ),
    ("def terminal(self, state)", "def ends(self, state)", r"Walk must have a method terminal\(self, state\)"),
    ("def action_space(self)", "def actions(self)", r"Walk must have a property action_space, a Gymnasium space"),
    ("return spaces.Discrete(2)", "return 2", r"action_space of Walk must be a Gymnasium space, .* but is 2$"),
    (
        "    @property\n    def action_space",
        "    def action_space",
        r"action_space .* but is <.*>: put @property above it$",
    ),
    ("return spaces.Discrete(2)", "return spaces.Discrete(2, start=1)", "action_space .* from 0"),
]


@pytest.mark.parametrize(("old", "new", "says"), STRUCTURE)
def test_what_is_missing(old: str, new: str, says: str) -> None:
    """It is found when the environment is made."""
    for made in (MDPEnv, check_mdp):
        with pytest.raises(ValueError, match=says):
            made(walk(old, new))


@pytest.mark.parametrize("names", ["('down',)", "['down', 'up', 'on']"])
def test_every_action_has_a_name(names: str) -> None:
    """One too few or too many is found; a dictionary may name only some."""
    with pytest.raises(ValueError, match=r"action_names of Walk must have a name for each action, 2, but has [13]"):
        check_mdp(walk("    def initial", f"    action_names = {names}\n\n    def initial"))
    check_mdp(walk("    def initial", "    action_names = {'up': 1}\n\n    def initial"))
    named = WALK.replace("    def initial", "    action_names = ('down',)\n\n    def initial")
    several = named.replace("spaces.Discrete(2)", "spaces.MultiDiscrete([2, 3])").replace("* action", "* action[0]")
    check_mdp(cell(several)["Walk"](5))  # which have no number


class Rewarding(gymnasium.Env[int, int]):
    """An environment with a method that MDPs have, too."""

    def reward(self) -> float:
        """Whatever it pays."""
        return 1.0


def test_what_is_no_mdp() -> None:
    """The answer says what to pass instead."""
    Walk = cell(WALK)["Walk"]
    wrongs: list[tuple[Any, str]] = [
        (None, "mdp must be an MDP, .* but is None"),
        (3, "mdp must be an MDP, .* but is 3"),
        (Walk, r"mdp must be a value, but is the class Walk: make one with Walk\(\.\.\.\)"),
        ("Boulder", r"edugym.make_mdp\('Boulder'\)"),
        (MDPEnv(Walk(3)), "mdp must be an MDP"),
        (Rewarding(), "mdp must be an MDP, .* but is <.*Rewarding object at "),
    ]
    for wrong, says in wrongs:
        with pytest.raises(ValueError, match=says):
            MDPEnv(wrong)
    with pytest.raises(ValueError, match=r"Boulder\.create\(\.\.\.\)"):
        require_mdp(ENVIRONMENTS[0].load_mdp())


CHANGES = """
class Board(NamedTuple):
    size: int
    def initial(self, rng): return np.zeros(self.size)
    def transition(self, state, action, rng):
        {transition}
    def reward(self, state, action, next_state, rng):
        {reward}
        return 0.0
    def terminal(self, state): return False
    def observation(self, state, rng): return 0
    observation_space = property(lambda self: spaces.Discrete(1))
    action_space = property(lambda self: spaces.Discrete(2))
"""


def test_states_changed_in_place() -> None:
    """The method is named; a copy that is changed is fine."""
    for transition, reward, method in (
        ("state[action] += 1; return state", "pass", "transition"),
        ("return state + 1", "next_state[0] = 7", "reward"),
        ("return state + 1", "state[0] = 7", "reward"),
    ):
        task = cell(CHANGES.format(transition=transition, reward=reward))["Board"](2)
        with pytest.raises(ValueError, match=f"{method} of Board must not change the state that it is given"):
            check_mdp(task)
    fine = cell(CHANGES.format(transition="state = state.copy(); state[action] += 1; return state", reward="pass"))
    assert len(check_mdp(fine["Board"](2), 7)) == 8


class Written(CatchGrid):
    """A student's board, which is written into an array."""

    __slots__ = ()

    def observe_into(self, state: Any, rng: Any, board: Any) -> None:
        """As bright as there are rows, so that only a board of one row is in the observation space."""
        super().observe_into(state, rng, board)
        board[:] *= self.rows


def test_observations_that_are_written() -> None:
    """What is there before does not stay, and what comes is checked."""
    board = np.full((1, 3), 0.5, np.float32)
    CheckedMDP(Written(1, 3)).observe_into(Fall(0, 0, 2), np.random.default_rng(0), board)
    assert board.tolist() == [[1.0, 0.0, 1.0]]
    with pytest.raises(ValueError, match="observation of Written must return an element of Box"):
        CheckedMDP(Written(2, 3)).observe_into(Fall(0, 0, 2), np.random.default_rng(0), np.zeros((2, 3), np.float32))


def test_what_is_right_passes() -> None:
    """NumPy's numbers and types that mean the same are fine; the package's own MDPs are not checked at every step."""
    for old, new in (
        ("return state == self.size", "return np.bool_(state == self.size)"),
        ("return state\n", "return np.int8(state)\n"),
        ("return 1.0 if next_state == self.size else -0.25", "return np.float32(1)"),
        ("return 1.0 if next_state == self.size else -0.25", "return True"),
    ):
        check_mdp(walk(old, new))
    for entry in ENVIRONMENTS:
        mdp = entry.load_mdp().create()
        assert is_own(mdp)
        assert check_mdp(mdp, 20)
    assert not is_own(cell(WALK)["Walk"](3))


def test_checking_leaves_the_task_alone() -> None:
    """It plays a copy: what a student counts in a table is not counted."""
    task = cell(CHANGES.format(transition="self.size[1] += 1; return state + 1", reward="pass"))["Board"](
        np.array([2, 0])
    )
    check_mdp(task)
    assert task.size.tolist() == [2, 0]


def test_where_an_error_is_shown() -> None:
    """A mistake that Python finds ends at the student's line, which comes right after the call of ours."""
    task = walk("return state == self.size", "return state == self.sise")
    env, vector = MDPEnv(task), MDPVectorEnv(MDPEnv(task), 2)
    env.reset(seed=0)
    for call in (lambda: env.step(1), lambda: vector.reset(seed=0)):
        with pytest.raises(AttributeError, match="sise") as caught:
            call()
        *_, call_of_ours, students = traceback.extract_tb(caught.value.__traceback__)
        assert students.line == "return state == self.sise"
        assert call_of_ours.filename == __file__


def test_step_limits() -> None:
    """A limit is a whole number of 1 or more, or None; a mistake inside the property is no "no limit"."""
    for wrong in ("-3", "2.5", "2**63", "0", "'ten'", "True"):
        task = walk(
            "    def initial", f"    @property\n    def max_steps(self):\n        return {wrong}\n\n    def initial"
        )
        for use in (MDPEnv, task_of):
            with pytest.raises(ValueError, match="max_steps must be"):
                use(task)
    for right, limit in (("None", None), ("7", 7), ("np.int32(7)", 7)):
        task = walk(
            "    def initial", f"    @property\n    def max_steps(self):\n        return {right}\n\n    def initial"
        )
        assert step_limit(task) == limit
    typo = walk(
        "    def initial", "    @property\n    def max_steps(self):\n        return self.sise\n\n    def initial"
    )
    with pytest.raises(AttributeError, match="sise"):
        MDPEnv(typo)
    assert step_limit(cell(WALK)["Walk"](3)) is None


def test_spaces_of_several_parts() -> None:
    """Dictionaries and tuples are observations of a single environment."""
    space = "spaces.Dict(place=spaces.Discrete(6), picture=spaces.Box(0, 9, (2,)))"
    task = cell(
        WALK.replace("spaces.Discrete(self.size + 1)", space).replace(
            "return state\n", "return {'place': state, 'picture': [state, 1]}\n", 1
        )
    )["Walk"](5)
    env = MDPEnv(task)
    observation, _ = env.reset(seed=0)
    assert isinstance(env.observation_space, spaces.Dict)
    assert env.observation_space.contains(observation)
    assert env.observation_space.contains(env.step(1)[0])


@pytest.mark.parametrize(
    ("next_state", "says"),
    [
        (None, "transition of Stairs must return the next state, but returned None for state 2, action 1 "),
        (3, "reward of Stairs must return a finite number, but returned None for state 2, action 1, next state 3 "),
    ],
)
def test_which_method_has_no_return(next_state: Any, says: str) -> None:
    """The reward is None because it has no `return`, or because there is no next state."""
    with pytest.raises(ValueError, match=says):
        refuse_nothing(Stairs(), 2, 1, next_state)


def test_something_else_that_is_called_mdp() -> None:
    """Only the package's wrappers have another task there; a student's class may have anything."""
    source = WALK.replace(
        "class Walk(NamedTuple):\n    size: int", "class Note:\n    pass\nclass Walk:\n    size, mdp = 3, Note()"
    )
    task = cell(source)["Walk"]()
    assert check_mdp(task, 1) == [0, check_mdp(task, 1)[1]]
    assert isinstance(checked_mdp(task), CheckedMDP)
    assert checked_mdp(task).observation(3, np.random.default_rng(0)) == 3


def test_what_the_package_has_itself_is_played_as_it_is() -> None:
    """Nothing around it takes time."""
    task = ENVIRONMENTS[0].load_mdp().create()
    assert checked_mdp(task) is task
