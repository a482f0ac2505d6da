"""Mistakes that come after the first steps get the same sentence in machine code and in the interpreter."""

import warnings
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from gymnasium import spaces

from edugym import QLearning, train
from tests.compiled.cells import LEARNER, WALK, cell
from tests.training.slips import ACTS, END, MOVE, PAY, SEE
from tests.training.test_slips import LOOKING, VIEW

pytestmark = pytest.mark.usefixtures("compiled_at_once")

N_STEPS = 60_000
RARE = "rng.random() < 0.0002"
OUTSIDE = {"machine code": "", "interpreted": "notes = {}\n        "}
"""What to write before a line: a dict is outside what can be compiled."""

LATE = {
    "NaN for a reward": (PAY, f"return np.nan if {RARE} else -0.25", "reward of Walk .* returned nan for state"),
    "an infinite reward": (PAY, f"return np.inf if {RARE} else -0.25", "reward of Walk .* returned inf for state"),
    "below the space": (SEE, f"return -1 if {RARE} else state\n", "observation of Walk .* returned -1 for state"),
    "no next state": (
        MOVE,
        f"if {RARE}:\n            return None\n        {MOVE}",
        "transition of Walk must return the next state, .* None",
    ),
    "beyond the space": (SEE, f"return 6 if {RARE} else state\n", "observation of Walk .* returned 6 for state"),
}


def changed(source: str, old: str, new: str) -> str:
    """Replace a text that stands in the source once."""
    assert source.count(old) == 1
    return source.replace(old, new)


def walk(source: str = WALK) -> Any:
    """Make a walk of five steps."""
    return cell(source)["Walk"](5)


def learner(source: str = LEARNER) -> Any:
    """Make an agent for it."""
    return cell(source)["Learner"](np.zeros((6, 2)))


@pytest.mark.parametrize("way", OUTSIDE)
@pytest.mark.parametrize("name", LATE)
@pytest.mark.filterwarnings("ignore:Walk.* cannot be compiled")
def test_rare_mistakes_in_an_mdp(name: str, way: str) -> None:
    """They come after some thousands of steps that are right."""
    old, new, says = LATE[name]
    source = changed(changed(WALK, old, new), MOVE, OUTSIDE[way] + MOVE)
    with pytest.raises(ValueError, match=says):
        train(walk(source), QLearning.create((6, 2)), N_STEPS, seed=2)


@pytest.mark.parametrize(
    ("way", "action"), [("machine code", "2"), ("machine code", "-1"), ("machine code", "None"), ("interpreted", "2")]
)
@pytest.mark.filterwarnings("ignore:Walk, Learner cannot be compiled")
def test_a_rare_action(way: str, action: str) -> None:
    """An agent that returns an action that does not exist is named, with the state; -1 is not the last one."""
    wrong = f"if {RARE}:\n            return {action}\n        "
    source = changed(LEARNER, "if rng.random() < 0.1:", f"{OUTSIDE[way]}{wrong}if rng.random() < 0.1:")
    with pytest.raises(ValueError, match=r"act of Learner .* from 0 to 1, but returned " + action + r" for state \d"):
        train(walk(), learner(source), N_STEPS, seed=2)


@pytest.mark.parametrize("way", OUTSIDE)
@pytest.mark.filterwarnings("ignore:Walk, Learner cannot be compiled")
def test_a_rare_action_in_evaluation(way: str) -> None:
    """The method by which the agent is evaluated is named, too."""
    greedy = f"def greedy(self, state, rng):\n        {OUTSIDE[way]}return 2 if rng.random() < 0.001 else 1\n    {ACTS}"
    with pytest.raises(ValueError, match=r"greedy of Learner .* from 0 to 1, but returned 2 for state \d"):
        train(walk(), learner(changed(LEARNER, ACTS, greedy)), 6_000, evaluate_every=2, seed=2)


STAYER = """
class Stayer(NamedTuple):
    total: np.ndarray

    def act(self, state, rng):
        return ACT

    def greedy(self, state, rng):
        return GREEDY

    def learn(self, state, reward):
        self.total[0] += reward
"""
"""An agent without a table, for which any state will do."""


@pytest.mark.parametrize(("act", "greedy"), [("1", "2"), ("2", "1")], ids=["evaluation", "training"])
def test_a_rare_next_state(act: str, greedy: str) -> None:
    """One that is missing is named before the reward fails, also late in a call of machine code."""
    stay = "if action == 2:\n            return None if rng.random() < 0.0001 else state\n        "
    source = changed(changed(WALK, MOVE, f"{stay}{MOVE}"), "Discrete(2)", "Discrete(3)")
    source = changed(source, PAY, "return 0.5 * next_state")
    stayer = cell(STAYER.replace("ACT", act).replace("GREEDY", greedy))["Stayer"](np.zeros(1))
    with pytest.raises(ValueError, match=r"transition of Walk must return the next state, .* None"):
        train(walk(source), stayer, N_STEPS, evaluate_every=600, evaluation_episodes=20)


def test_an_index_of_something_else() -> None:
    """Only the index of an array is explained by the size of a table, and only where it may be that of the table."""
    for wrong, says in (
        ("[0, 1][2]", "list index out of range"),
        ("'ab'[2]", "string index out of range"),
        ("np.zeros(4)[4]", "index 4 is out of bounds for axis 0 with size 4"),
        ("self.Q[0, state + 3]", r"index \d is out of .* size 3: Q of Learner has the shape \(7, 3\), but this"),
        ("self.Q[state + 7, 0]", r"index \d is out of .* size 7: Q of Learner has the shape \(7, 3\), but this"),
    ):
        source = changed(LEARNER, "value = 0.0", f"{wrong}; value = 0.0")
        with pytest.raises(IndexError, match=f"^{says}") as caught:
            train(
                walk(),
                cell(changed(source, "rng.random() * self.Q.shape[1]", "rng.random() * 2"))["Learner"](
                    np.zeros((7, 3))
                ),
                300,
            )
        assert ("shape" in says) == ("shape" in str(caught.value))


def test_what_is_right_is_left_alone() -> None:
    """The control: without a mistake there is not a word."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert train(walk(), learner(), N_STEPS, seed=2).complete


class Rooms(gym.Env[Any, Any]):
    """A Gymnasium environment of a student's that never ends, with one wrong reward.

    Args:
        wrong_at: the step with the reward NaN; 0 for none.
    """

    observation_space = spaces.Discrete(3)
    action_space = spaces.Discrete(2)

    def __init__(self, wrong_at: int) -> None:
        """See the class."""
        self.steps, self.wrong_at = 0, wrong_at

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Start an episode."""
        super().reset(seed=seed, options=options)
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Take a step."""
        self.steps += 1
        return self.steps % 3, np.nan if self.steps == self.wrong_at else 0.0, False, False, {}


def test_a_rare_reward_of_a_gymnasium_environment() -> None:
    """It is checked at every step."""
    with pytest.raises(ValueError, match="step of Rooms must return a finite number as reward, but returned nan"):
        train(Rooms(3_000), QLearning.create((3, 2)), 4_000)


def test_episodes_that_never_end() -> None:
    """A warning says so after training, unless there is a step limit or there were only few steps."""
    endless = walk(changed(changed(WALK, END, "return False"), MOVE, "return min(5, max(0, state + 2 * action - 1))"))
    with pytest.warns(UserWarning, match=r"no episode of Walk has ended in 2000 steps: terminal never returned True"):
        train(endless, QLearning.create((6, 2)), 2_000)
    with pytest.warns(UserWarning, match=r"no episode of Rooms has ended .* step never returned terminated True"):
        train(Rooms(0), QLearning.create((3, 2)), 2_000)
    with pytest.warns(UserWarning, match="has ended in 1000 steps"):
        train(endless, QLearning.create((6, 2)), 1_000)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        train(endless, QLearning.create((6, 2)), 2_000, max_steps=100)
        train(endless, QLearning.create((6, 2)), 999)


def test_a_table_of_the_class() -> None:
    """It is shared by all agents: a warning says so after training. What does not change may be shared."""
    source = changed(LEARNER, "    rate: float = 0.5\n", "    rate: float = 0.5\n    seen = {}\n    moves = [0, 1]\n")
    agent = learner(changed(source, "value = 0.0", "self.seen[state] = len(self.moves); value = 0.0"))
    with pytest.warns(UserWarning, match="seen of Learner has changed, which is not the agent's own") as caught:
        train(walk(), agent, 300)
    assert len(caught) == 1


def test_a_table_that_is_a_default() -> None:
    """The next agent would begin with it: a warning says so after training, and none where the agent has its own."""
    kind = cell(changed(LEARNER, "Q: np.ndarray", "Q: np.ndarray = np.zeros((6, 2))"))["Learner"]
    with pytest.warns(UserWarning, match=r"Q of Learner has changed, .* own: pass it, Learner\(...\), without a def"):
        train(walk(), kind(), 300)
    plain = cell(PLAIN)["Plain"]
    with pytest.warns(UserWarning, match="Q of Plain has changed, which is not the agent's own"):
        train(walk(), plain(), 300)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        train(walk(), kind(np.zeros((6, 2))), 300)
        train(walk(), plain(np.zeros((6, 2))), 300)


PLAIN = """
class Plain:
    def __init__(self, Q=np.zeros((6, 2))):
        self.Q = Q
    def act(self, state, rng):
        return 1
    def learn(self, state, action):
        self.Q[state, action] += 1
"""


def test_a_table_that_comes_to_hold_nan() -> None:
    """A warning says so after training, and the run is kept."""
    wrong = (
        "self.Q[5, 0] += 1.0\n        if self.Q[5, 0] > 30_000:\n            self.Q[5, 1] = np.nan\n        value = 0.0"
    )
    with pytest.warns(UserWarning, match="Q of Learner holds nan after training"):
        run = train(walk(), learner(changed(LEARNER, "value = 0.0", wrong)), N_STEPS)
    assert run.complete


def test_a_table_of_objects_is_not_looked_at() -> None:
    """Python's own numbers, say, or fractions; NumPy cannot say whether they are NaN."""
    run = train(walk(), cell(PLAIN)["Plain"](np.zeros((6, 2), object)), 1000)
    assert run.complete
    assert run.agent.Q.sum() == 1000


VALUE = "value = 0.0 if terminated else max(self.Q[next_state, 0], self.Q[next_state, 1])\n"
UPDATE = "self.Q[state, action] += self.rate * (reward + value - self.Q[state, action])"
STORED_NOWHERE = {
    "returned": "return self.Q[state, action] + self.rate * (reward + value - self.Q[state, action])",
    "a number of its own": "q = self.Q[state, action]\n        q += self.rate * (reward + value - q)",
}
ONLY_THOUGHT = {
    "the update": UPDATE,
    "nothing to do": f"if state < 0:\n            {UPDATE}",
    "no thought": "pass",
    "no reward comes": STORED_NOWHERE["returned"],
}


@pytest.mark.parametrize("name", STORED_NOWHERE)
def test_an_agent_that_stores_nothing(name: str) -> None:
    """What `learn` returns is ignored: a warning says so if rewards came and the table is as blank as before."""
    agent = learner(changed(LEARNER, UPDATE, STORED_NOWHERE[name]))
    says = (
        r"^learn of Learner has changed nothing in Q in 1000 steps, although rewards came: assign .*self.Q\[...\] \+="
    )
    with pytest.warns(UserWarning, match=says):
        train(walk(), agent, 1_000, max_steps=9)


@pytest.mark.parametrize("name", ONLY_THOUGHT)
def test_an_agent_that_need_not_store(name: str) -> None:
    """No warning: it learns, it has no reason to, it does not try, or no reward has come; nor after few steps."""
    source = changed(LEARNER, UPDATE, ONLY_THOUGHT[name])
    task = walk(changed(changed(WALK, "1.0 if", "0.0 if"), "-0.25", "0.0") if name == "no reward comes" else WALK)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        train(
            task,
            learner(changed(source, VALUE, "value = 0.0\n") if name == "no thought" else source),
            1_000,
            max_steps=9,
        )
        train(walk(), learner(changed(LEARNER, UPDATE, STORED_NOWHERE["returned"])), 999, max_steps=9)
        tables = learner(changed(LEARNER, UPDATE, STORED_NOWHERE["returned"]))
        tables.Q[0, 1] = 1.0  # what a planner has found, say
        train(walk(), tables, 1_000, max_steps=9)


@pytest.mark.parametrize("way", OUTSIDE)
@pytest.mark.parametrize("seen", ["9.1", "-0.1", "np.nan"])
@pytest.mark.filterwarnings("ignore:Walk, Looker cannot be compiled")
def test_a_rare_vector_outside_the_box(seen: str, way: str) -> None:
    """As where observations are whole numbers."""
    source = changed(changed(VIEW, "[state, 1.0]", f"[state, {seen} if {RARE} else 1.0]"), MOVE, OUTSIDE[way] + MOVE)
    with pytest.raises(ValueError, match=r"observation of Walk must return an element of Box\(.*returned array"):
        train(walk(source), cell(LOOKING)["Looker"](), N_STEPS, seed=2)


@pytest.mark.parametrize(("seen", "n"), [("(state, {})", 2), ("np.full(40, {})", 40)])
def test_other_vectors_outside_the_box(seen: str, n: int) -> None:
    """A tuple of a whole number and a real one, and many numbers: they compile, and are guarded."""
    source = VIEW.replace("np.array([state, 1.0])", seen.format("1.0")).replace("(2,)", f"({n},)")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        train(walk(source), cell(LOOKING)["Looker"](), 6_000, max_steps=9)
        rare = changed(source, seen.format("1.0"), seen.format(f"9.5 if {RARE} else 1.0"))
        with pytest.raises(ValueError, match=r"observation of Walk must return an element of Box\("):
            train(walk(rare), cell(LOOKING)["Looker"](), N_STEPS, seed=2)


@pytest.mark.parametrize("bounds", ["0.1, 0.1", "-np.inf, np.inf", "0, np.inf", "0, np.finfo(np.float32).max"])
def test_bounds_are_those_of_the_type_of_the_space(bounds: str) -> None:
    """0.1 is less than 0.1 in a space of float32, and is no mistake; without bounds there is nothing to say either."""
    source = VIEW.replace("[state, 1.0]", "[0.1, 0.1]").replace("(0, 9,", f"({bounds},")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        train(walk(source), cell(LOOKING)["Looker"](), 6_000, max_steps=9)
