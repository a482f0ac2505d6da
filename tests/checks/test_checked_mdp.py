"""For how long an MDP is checked, what is checked in wrappers, and the very words of the answers."""

import re
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym import make_mdp, train
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.interfaces import require_environment, require_mdp, require_method, step_limit
from edugym.checks.mdps import CHECKED_STEPS, CheckedMDP, checked_mdp, innermost
from edugym.mdp.tabular import Tabular
from edugym.mdp.task import check_mdp
from edugym.system.packages import is_own
from tests.compiled.cells import LEARNER, WALK, cell

BOARD = """
class Board(NamedTuple):
    log: list
    observation_space: object = spaces.Discrete(3)
    action_space: object = spaces.Discrete(4)
    def initial(self, rng): return np.zeros(2)
    def transition(self, state, action, rng):
        self.log.append(("transition", state.tolist(), action)); state[0] += 1; return state + action
    def reward(self, state, action, next_state, rng):
        self.log.append(("reward", state.tolist(), action, next_state.tolist())); state[0] += 1; return 0.5
    def terminal(self, state): state[0] += 1; return False
    def observation(self, state, rng): self.log.append(("observation", state.tolist())); state[0] += 1; return 2
    def observe_into(self, state, rng, out): state[0] += 1; out[...] = 1
"""
"""Every method changes the state that it is given, by 1."""


def board(**values: Any) -> Any:
    """A board, and what its methods were asked."""
    return cell(BOARD)["Board"]([], **values)


def test_states_may_not_change_for_as_many_steps_as_it_says() -> None:
    """After them nothing is copied, and the MDP is asked what it was asked before."""
    rng, mdp = np.random.default_rng(0), board()
    checked = CheckedMDP(mdp, 2)
    for _ in range(2):
        asks: list[Callable[[], Any]] = [
            lambda: checked.transition(np.array([5.0, 5.0]), 3, rng),
            lambda: checked.reward(np.array([5.0, 5.0]), 3, np.array([7.0, 7.0]), rng),
            lambda: checked.terminal(np.array([5.0, 5.0])),
            lambda: checked.observation(np.array([5.0, 5.0]), rng),
        ]
        for ask in asks:
            with pytest.raises(
                ValueError, match=r"turned array\(\[5., 5.\]\) into array\(\[6., 5.\]\): make a new one"
            ):
                ask()
    mdp.log.clear()
    for _ in range(2):
        assert checked.transition(np.array([5.0, 5.0]), 3, rng).tolist() == [9.0, 8.0]
        assert checked.reward(np.array([5.0, 5.0]), 3, np.array([7.0, 7.0]), rng) == 0.5
        assert checked.terminal(np.array([5.0, 5.0])) is False
        assert checked.observation(np.array([5.0, 5.0]), rng) == 2
    asked = [("transition", [5, 5], 3), ("reward", [5, 5], 3, [7, 7]), ("observation", [5, 5])]
    assert mdp.log == 2 * asked


def test_rewards_and_observations_are_checked_for_ever() -> None:
    """Also after the steps in which everything is."""
    rng, source = np.random.default_rng(0), BOARD.replace("return 0.5", "return np.nan").replace("return 2", "return 3")
    checked = CheckedMDP(cell(source)["Board"]([]), 0)
    checked.transition(np.zeros(2), 0, rng)
    with pytest.raises(ValueError, match="reward of Board must return a finite number, but returned nan"):
        checked.reward(np.zeros(2), 0, np.zeros(2), rng)
    with pytest.raises(ValueError, match="observation of Board must return an element of Discrete"):
        checked.observation(np.zeros(2), rng)


def test_observing_into_an_array_may_not_change_the_state() -> None:
    """The method is named."""
    checked = CheckedMDP(board(observation_space=spaces.Box(0, 1, (2,))))
    with pytest.raises(ValueError, match="observe_into of Board must not change the state that it is given"):
        checked.observe_into(np.zeros(2), np.random.default_rng(0), np.zeros(2, np.float32))


@pytest.mark.parametrize(
    ("space", "wrong"),
    [
        (spaces.Discrete(3, start=1), 0),
        (spaces.Discrete(3, start=1), 4),
        (spaces.Discrete(3), 3),
        (spaces.Box(0, 9, (2,)), 0),
        (spaces.MultiBinary(1), 0),
    ],
)
def test_whole_numbers_that_are_not_in_the_space(space: Any, wrong: int) -> None:
    """Whatever the space is, and wherever it starts."""
    mdp = cell(WALK.replace("return state\n", f"return {wrong}\n"))["Walk"]
    kind = type("Walk", (mdp,), {"__slots__": (), "observation_space": space})
    with pytest.raises(ValueError, match=re.escape(f"observation of Walk must return an element of {space}, but")):
        CheckedMDP(kind(5)).observation(0, np.random.default_rng(0))


def test_the_words_of_an_answer() -> None:
    """State, action and next state are in it, in this order, and what has been forgotten."""
    rng = np.random.default_rng(0)
    mdp = cell(WALK.replace("return 1.0 if next_state == self.size else -0.25", "pass"))["Walk"](5)
    with pytest.raises(ValueError, match="reward") as caught:
        CheckedMDP(mdp).reward(3, 1, 4, rng)
    assert str(caught.value) == (
        "reward of Walk must return a finite number, but returned None for state 3, action 1, next state 4 (is a return"
        " missing?)"
    )


@pytest.mark.parametrize("end", [1, 3])
def test_the_states_that_are_met(end: int) -> None:
    """Each step gives one, and after the end comes an initial one; it plays 200 steps where no number is given."""
    mdp = cell(
        WALK.replace("return max(0, state + 2 * action - 1)", "return state + 1")
        .replace("return 0\n", "return -1\n")
        .replace("return state\n", "return 0\n")
    )["Walk"]
    assert check_mdp(mdp(end), 7)[: end + 4] == [*range(-1, end + 1), -1, 0][: end + 4]
    assert len(check_mdp(mdp(10**6))) == 201
    assert CHECKED_STEPS == 200


class Around(NamedTuple):
    """A student's wrapper."""

    mdp: Any


def test_what_is_inside_wrappers() -> None:
    """Those of the package are looked through, and a student's is not."""
    walk, ours = cell(WALK)["Walk"](5), make_mdp("Boulder")
    for mdp in (walk, ours, Around(walk), Around(ours)):
        assert innermost(mdp) is mdp
        assert innermost(around(around(mdp))) is mdp
    assert is_own(around(ours))
    assert is_own((ours, 1, "a", np.zeros(2)))
    for value in (Around(ours), around(walk), (ours, walk), (walk, ours)):
        assert not is_own(value)


def around(mdp: Any) -> Tabular:
    """A wrapper of the package."""
    return Tabular(mdp, np.array([6]), np.zeros(1, np.int64), np.zeros(1, np.int64))


def test_a_mistake_in_a_step_limit_inside_a_wrapper() -> None:
    """It shows, and does not mean that there is none."""
    limit = "    @property\n    def max_steps(self):\n        return self.sise\n\n    def initial"
    mistaken: Any = around(cell(WALK.replace("    def initial", limit))["Walk"](5))
    endless: Any = around(cell(WALK)["Walk"](5))
    with pytest.raises(AttributeError, match="sise"):
        step_limit(mistaken)
    assert step_limit(endless) is None


class Size(int):
    """A number of a student's own class."""


def test_where_the_checks_stand() -> None:
    """Around what a student has made, inside the package's wrappers, and in place of a wrapper that checks less."""
    walk = cell(WALK)["Walk"](5)
    outer = checked_mdp(around(around(walk)), 7)
    assert type(outer) is type(outer.mdp) is Tabular
    assert isinstance(outer.mdp.mdp, CheckedMDP)
    assert (outer.mdp.mdp._mdp, outer.mdp.mdp._left) == (walk, 7)
    instead = checked_mdp(around(around(walk)), instead_of=(Tabular,))
    assert isinstance(instead, CheckedMDP)
    assert instead._mdp is walk
    mixed = make_mdp("Boulder")._replace(height=Size(4))
    assert isinstance(checked_mdp(mixed), CheckedMDP)


@pytest.mark.parametrize(
    ("inside", "says"),
    [
        (cell(WALK)["Walk"], r"mdp of Tabular must be a value, but is the class Walk: make one with Walk\(\.\.\.\)"),
        (3, "mdp of Tabular must be an MDP, .* but is 3"),
    ],
    ids=["a class", "a number"],
)
def test_what_is_no_mdp_in_a_wrapper(inside: Any, says: str) -> None:
    """It is said where it stands."""
    with pytest.raises(ValueError, match=says):
        require_mdp(around(inside))


@pytest.mark.parametrize(
    ("forgetful", "says"),
    [
        ("initial", "initial of Walk must return the first state, but returned None (is a return missing?)"),
        ("transition", "transition of Walk must return the next state, but returned None (is a return missing?)"),
    ],
)
def test_a_state_that_is_none(forgetful: str, says: str) -> None:
    """Where it shows only in what is seen, the method that has forgotten it is named."""
    line = {"initial": "return 0\n", "transition": "return max(0, state + 2 * action - 1)\n"}[forgetful]
    mdp, rng = cell(WALK.replace(line, "pass\n"))["Walk"](5), np.random.default_rng(0)
    checked = CheckedMDP(mdp, 0)
    state = checked.initial(rng)
    if forgetful == "transition":
        state = checked.transition(state, 1, rng)
    with pytest.raises(ValueError, match="must return") as caught:
        checked.observation(state, rng)
    assert str(caught.value) == says


def test_the_mdp_in_a_wrapper_is_looked_at() -> None:
    """The mistake is named with the class that has it."""
    walk = cell(WALK.replace("def transition(self, state, action, rng)", "def transition(self, state, action)"))["Walk"]
    with pytest.raises(ValueError, match=r"^transition of Walk must take"):
        check_mdp(around(walk(5)))


NEAR = {
    "start": "; is 'start' misspelt?",
    "initial_state": "; is 'initial_state' misspelt?",
    "inital": "; is 'inital' misspelt?",
    "_initial": "",
    "terminal": "",
    "begin": "",
}


@pytest.mark.parametrize("has", NEAR)
def test_which_name_may_be_misspelt(has: str) -> None:
    """One that others use, or one that is spelt much the same; not a hidden one or one that is wanted itself."""
    owner = type("Task", (), {has: lambda self, rng: 0})()
    with pytest.raises(ValueError, match="initial") as caught:
        require_method(owner, "initial", ("rng",), ("initial", "terminal", "inial"))
    assert str(caught.value) == f"Task must have a method initial(self, rng){NEAR[has]}"
    require_method(type("Task", (), {"initial": lambda self, stream: 0})(), "initial", ("rng",))
    wrapper = type("Task", (), {has: lambda self, rng: 0, "_fields": ("mdp",)})()
    decorator = ", or the decorator @edugym.wrapper, which takes it from the MDP inside"
    with pytest.raises(ValueError, match="initial") as caught:
        require_method(wrapper, "initial", ("rng",), ("initial", "terminal", "inial"))
    assert str(caught.value) == f"Task must have a method initial(self, rng){NEAR[has] or decorator}"


OTHERS = {
    "initial": "reset start initial_state",
    "transition": "step next_state dynamics",
    "terminal": "is_terminal done terminated is_done",
    "observation": "observe obs",
    "act": "choose choose_action select_action get_action policy",
    "learn": "update train fit",
    "greedy": "greedy_act act_greedy",
}
"""What books and other libraries call the methods."""


@pytest.mark.parametrize(("name", "other"), [(name, other) for name in OTHERS for other in OTHERS[name].split()])
def test_the_names_of_others_are_known(name: str, other: str) -> None:
    """However unlike the wanted name they are; one that is like it too comes second."""
    owner = type("Task", (), {other: 0, f"{name}_": 0})()
    with pytest.raises(ValueError, match=rf"must have a method {name}\(self, state\); is '{other}' misspelt\?"):
        require_method(owner, name, ("state",))


def test_another_wanted_method_is_not_misspelt() -> None:
    """Even where it is spelt much the same."""
    owner = type("Task", (), {"rewards": lambda self: 0})()
    with pytest.raises(ValueError, match=r"must have a method reward\(self, rng\)$"):
        require_method(owner, "reward", ("rng",), ("rewards",))


def test_a_method_that_is_none() -> None:
    """It is shown."""
    owner = type("Task", (), {"initial": 3})()
    with pytest.raises(ValueError, match=r"^initial of Task must be a method, but is 3$"):
        require_method(owner, "initial", ("rng",))


@pytest.mark.parametrize("part", ["observation_space", "transition", "step"])
def test_what_an_environment_has(part: str) -> None:
    """One of three is enough to look closer."""
    require_environment("environment", type("Task", (), {part: 0})())
    for wrong, says in (
        (3, "is 3"),
        ((3, 4), "is (3, 4)"),
        (Around(3), "is Around(mdp=3): is the decorator @edugym.wrapper missing?"),
        (type("Tasks", (), {part: 0, "num_envs": 2})(), "Tasks holds several: give one of them"),
    ):
        with pytest.raises(ValueError, match=f"^where must be a task, but {re.escape(says)}$"):
            require_environment("where", wrong, "a task")


@pytest.mark.parametrize(
    "way", [check_mdp, MDPEnv, lambda mdp: train(mdp, cell(LEARNER)["Learner"](np.zeros((6, 2))), 9)]
)
@pytest.mark.parametrize("space", ["observation_space", "action_space"])
def test_a_mistake_inside_a_space(space: str, way: Any) -> None:
    """It shows as Python shows it, and not as a space that is missing."""
    mdp = cell(WALK.replace(f"def {space}(self):\n        return", f"def {space}(self):\n        return self.sise,"))
    with pytest.raises(AttributeError, match="sise"):
        way(mdp["Walk"](5))
