"""The slips that students make are answered with one sentence, and a traceback that is theirs, wherever they are."""

import warnings
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import MDPEnv, MDPVectorEnv, QLearning, repeat, train, wrapper
from edugym.training import trainers
from tests.compiled.cells import LEARNER, SLIPPERY, WALK, cell
from tests.training.slips import (
    ACT,
    ENVIRONMENT,
    FIRST,
    IN_AGENT,
    IN_ENVIRONMENT,
    IN_MDP,
    IN_PLACE,
    MOVE,
    ON_POLICY,
    PAY,
    ROOMS,
    SEE,
    WAYS,
    Slip,
    answered,
    changed,
    learner,
    task,
)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", IN_MDP)
def test_slips_in_an_mdp(name: str, way: str) -> None:
    """With an agent of the package."""
    slip = IN_MDP[name]
    mdp = task(changed(WALK, slip))
    answered(slip, lambda: WAYS[way](mdp, QLearning.create((6, 2))))


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("source", [LEARNER, ON_POLICY], ids=["off-policy", "on-policy"])
@pytest.mark.parametrize("name", IN_AGENT)
def test_slips_in_an_agent(name: str, source: str, way: str) -> None:
    """In a task of the student's that is right."""
    slip = IN_AGENT[name]
    agent = learner(changed(source, slip))
    answered(slip, lambda: WAYS[way](task(), agent))


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", IN_PLACE)
def test_states_that_are_changed(name: str, way: str) -> None:
    """Each method is named."""
    slip = IN_PLACE[name]
    mdp = task(changed(ROOMS, slip))
    answered(slip, lambda: WAYS[way](mdp, QLearning.create((6, 2))))


@pytest.mark.parametrize("name", IN_MDP)
def test_slips_in_an_mdp_that_is_played(name: str) -> None:
    """The environment and the vector environment give the same sentences."""
    slip = IN_MDP[name]
    mdp = task(changed(WALK, slip))

    def played() -> None:
        env = MDPEnv(mdp)
        env.reset(seed=0)
        for _ in range(5):
            env.step(0)

    def played_copies() -> None:
        envs = MDPVectorEnv(mdp, 3)
        envs.reset(seed=0)

    answered(slip, played)
    answered(slip, played_copies)


WRAPPER = """
@wrapper
class Paid(NamedTuple):
    mdp: object
    def reward(self, state, action, next_state, rng):
        return self.mdp.reward(state, action, next_state, rng) + 1.0
"""


def wrapped(mdp: Any) -> Any:
    """Something in a wrapper of a student's own."""
    return cell(WRAPPER, {"wrapper": wrapper, "NamedTuple": NamedTuple, "__name__": "__main__"})["Paid"](mdp)


WHOLE = {
    "a class for a task": (
        lambda: train(cell(WALK)["Walk"], learner(), 30),
        r"environment must be .* make one with Walk\(",
    ),
    "a class for an agent": (
        lambda: train(task(), cell(LEARNER)["Learner"], 30),
        r"the class Learner: make one with Lea",
    ),
    "a class of ours": (lambda: train(task(), QLearning, 30), r"the class QLearning: make one with QLearning.create\("),
    "a class to repeat": (lambda: repeat(task(), {"Q": QLearning}, 30), "the class QLearning: give QLearning.create$"),
    "whole numbers": (
        lambda: train(task(), learner_with(np.zeros((6, 2), int)), 30),
        r"Q of Learner must be an array of float, but its dtype is int64, which .* np.zeros\(\(6, 2\)\)",
    ),
    "copies of a task": (
        lambda: train(MDPVectorEnv(task(), 3), learner(), 30),
        "but MDPVectorEnv holds several: give one",
    ),
    "sizes for a table": (
        lambda: train(task(), QLearning(6, 2), 30),  # type: ignore[arg-type]
        r"Q of QLearning must be an array, but is 6: use QLearning.create\(environment\)$",
    ),
    "NaN": (lambda: train(task(), learner_with(np.full((6, 2), np.nan)), 30), r"Q of Learner .* but Q\[0, 0\] is nan"),
    "too many actions": (
        lambda: train(task(), learner_with(np.arange(30.0).reshape(6, 5)), 30),
        r"act of Learner .* returned 4 .* Q of Learner has the shape \(6, 5\), but .* 6 observations and 2 actions",
    ),
    "too few actions": (
        lambda: train(task(), learner_with(np.zeros((6, 1))), 30),
        r"Q of Learner has the shape \(6, 1\)",
    ),
    "no task": (lambda: train(None, learner(), 30), "environment must be an MDP"),
    "a function for an agent": (
        lambda: train(task(), QLearning.create, 30),
        "learn, but is .*: call it, and give what",
    ),
    "a wrapper of a class": (
        lambda: train(wrapped(cell(WALK)["Walk"]), learner(), 30),
        r"mdp of Paid must be a value, but is the class Walk: make one with Walk\(\.\.\.\)$",
    ),
    "a wrapper of a number": (lambda: train(wrapped(0.5), learner(), 30), "mdp of Paid must be an MDP, .* but is 0.5$"),
    "a wrapper without its decorator": (
        lambda: train(cell(WRAPPER.replace("@wrapper", ""))["Paid"](task()), learner(), 30),
        "environment must be an MDP, .*: is the decorator @edugym.wrapper missing",
    ),
    "no agent": (lambda: train(task(), None, 30), "agent must be an object with the methods act and learn, but"),
    "the wrong way round": (
        lambda: train(learner(), task(), 30),
        "environment must come first, before the agent, but is the agent Learner",
    ),
}


def learner_with(table: Any) -> Any:
    """An agent with a table of one's own."""
    return cell(LEARNER)["Learner"](table)


@pytest.mark.parametrize("name", WHOLE)
def test_what_is_given_is_wrong_as_a_whole(name: str) -> None:
    """Classes, tables, and what is neither a task nor an agent."""
    call, says = WHOLE[name]
    answered(Slip("", "", says), call)


def test_a_table_that_is_too_short() -> None:
    """The index that Python names is explained."""
    agent = cell(LEARNER)["Learner"](np.zeros((1, 2)))
    answered(
        Slip("", "", r"index 1 is out of .*: Q of Learner has the shape \(1, 2\)", "Q[", IndexError),
        lambda: train(task(), agent, 99),
    )


def test_a_table_the_wrong_way_round() -> None:
    """It is explained as well where the index comes late, in an evaluation episode without an end."""
    agent = cell(LEARNER.replace("self.Q.shape[1]", "2"))["Learner"](np.zeros((2, 6)))
    slow = task(WALK.replace(MOVE, "return state + (rng.random() < 0.002)"))
    answered(
        Slip("", "", r"index 2 is out of .*: Q of Learner has the shape \(2, 6\), but .* 6 obs", "Q[", IndexError),
        lambda: train(slow, agent, 30),
    )


LOOKING = """
class Looker(NamedTuple):
    tabular = False
    def act(self, state, rng):
        return 1
    def learn(self, state, action, reward, next_state, terminated):
        pass
"""
VIEW = WALK.replace(SEE, "return np.array([state, 1.0])\n").replace(
    "spaces.Discrete(self.size + 1)", "spaces.Box(0, 9, (2,))"
)


@pytest.mark.parametrize(("old", "new"), [("return 1", "state[0] = 7; return 1"), ("pass", "next_state += 1")])
def test_an_agent_that_changes_what_it_sees(old: str, new: str) -> None:
    """`act` and `learn` are named."""
    method = "act" if old == "return 1" else "learn"
    agent = cell(changed(LOOKING, Slip(old, new, "")))["Looker"]()
    answered(Slip("", "", f"{method} of Looker must not change the state"), lambda: train(task(VIEW), agent, 30))


@pytest.mark.parametrize("way", WAYS)
def test_an_agent_that_learns_from_everything(way: str) -> None:
    """It is told nothing, and the sentence says how it is."""
    slip = Slip(
        "state, action, reward, next_state, terminated):",
        "**step):\n        state = step['state']",
        r"learn of Learner is told only what its parameters name, and \*\*step gets nothing: write learn\(self, ",
        "state = step['state']",
    )
    answered(slip, lambda: WAYS[way](task(), learner(changed(LEARNER, slip))))


def test_a_strategy_of_ones_own() -> None:
    """The class in the package's agent is named as well."""
    strategy = cell("class Mine(NamedTuple):\n    def choose(self, Q, state, rng):\n        int(rng.random() * 2)\n")[
        "Mine"
    ]()
    agent = QLearning(np.zeros((6, 2)), exploration=strategy)
    answered(Slip("", "", "act of QLearning, with Mine must return an action"), lambda: train(task(), agent, 30))


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", IN_ENVIRONMENT)
def test_slips_in_a_gymnasium_environment(name: str, way: str) -> None:
    """One that no `gymnasium.make` has looked at."""
    slip = IN_ENVIRONMENT[name]
    env = cell(changed(ENVIRONMENT, slip))["Line"]()
    answered(slip, lambda: WAYS[way](env, QLearning.create((6, 2))))


GYM_WRAPPER = """
import gymnasium
class Paid(gymnasium.RewardWrapper):
    def __init__(self, env):
        super().__init__(env)
    def reward(self, reward):
        return reward + 1.0
"""


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("super().__init__(env)", "self.env = env", r"^__init__ of Paid must call super\(\).__init__\(env\)$"),
        ("def reward(", "def rewards(", r"^Paid must have a method reward\(self, reward\)$"),
        ("return ", "", "step of Paid must return a finite number as reward, but returned None"),
    ],
)
def test_slips_in_a_gymnasium_wrapper(old: str, new: str, says: str) -> None:
    """Around one of the package's environments."""
    slip = Slip(old, new, says)
    env = cell(changed(GYM_WRAPPER, slip))["Paid"](MDPEnv(task()))
    answered(slip, lambda: train(env, QLearning.create((6, 2)), 30))


@pytest.mark.parametrize("name", ["act without return", "a large action", "a frozen field", "learn misnames", "NaN"])
def test_an_agent_in_a_gymnasium_environment(name: str) -> None:
    """As in an MDP."""
    slip = IN_AGENT[name]
    agent = learner(changed(LEARNER, slip))
    answered(slip, lambda: train(cell(ENVIRONMENT)["Line"](), agent, 30))


def test_late_slips_in_machine_code() -> None:
    """Machine code that fails after thousands of steps is played again, checked."""
    late = WALK.replace("size: int", "size: int\n    count: np.ndarray").replace(
        MOVE, f"self.count[0] += 1\n        {MOVE}"
    )
    rare = Slip(
        PAY, f"if self.count[0] < 3_000:\n            {PAY}", "reward of Walk must return a finite number, .* None"
    )
    mdp = cell(changed(late, rare))["Walk"](5, np.zeros(1, np.int64))
    answered(rare, lambda: train(mdp, QLearning.create((6, 2)), 9_000))


LATE = LEARNER.replace("rate: float = 0.5", "rate: float = 0.5\n    count = [0]").replace(
    "        best = 0\n", "        self.count[0] += 1; late = self.count[0] > 2_000\n        best = 0\n"
)


@pytest.mark.parametrize("on_policy", [True, False])
@pytest.mark.parametrize("environment", [True, False])
@pytest.mark.parametrize(
    ("new", "says"),
    [
        ("return None if late else best", "act of Learner must return an action, .* returned None for state ."),
        ("return 'x' if late else best", "act of Learner must return an action, a whole .* returned 'x' for state ."),
        ("return 7 if late else best", "act of Learner must return an action, a whole .* returned 7 for state ."),
    ],
)
def test_late_slips_in_the_interpreter(new: str, says: str, environment: bool, on_policy: bool) -> None:
    """Where they end in an error, it is said what was wrong at that step."""
    source = LATE.replace(ACT, new)
    if on_policy:
        source = source.replace("next_state, terminated)", "next_state, next_action, terminated)")
    where = cell(ENVIRONMENT)["Line"]() if environment else task()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        answered(Slip("", "", says), lambda: train(where, learner(source), 9_000, max_steps=50))


def test_a_late_reward_that_is_missing() -> None:
    """In the interpreter."""
    source = WALK.replace("size: int", "size: int\n    count = [0]").replace(
        PAY, f"self.count[0] += 1\n        if self.count[0] < 3_000:\n            {PAY}"
    )
    mdp = task(source)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        says = "reward of Walk must return a finite number, but returned None"
        answered(Slip("", "", says), lambda: train(mdp, QLearning.create((6, 2)), 9_000))


@pytest.mark.parametrize("n_steps", [30, 300, 6_000])
def test_nothing_happens_twice(n_steps: int) -> None:
    """A task that counts its steps in a global list, and an agent that counts what it learns."""
    scope = cell(LEARNER.replace(FIRST, "learned.append(state); value = 0.0"))
    cell(WALK.replace(MOVE, f"seen.append(state); {MOVE}"), scope)
    scope["seen"], scope["learned"] = [], []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        run = train(scope["Walk"](5), scope["Learner"](np.zeros((6, 2))), n_steps, evaluate_every=n_steps, max_steps=7)
    assert len(scope["learned"]) == n_steps
    evaluation_steps = sum(7 if total <= -7 / 4 else round((1 - total) * 4) + 1 for total in run.returns)
    assert len(scope["seen"]) == n_steps + evaluation_steps


def test_the_checks_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same run without them, bit for bit."""
    runs = []
    for checked in (True, False):
        if not checked:
            monkeypatch.setattr(trainers, "checked_mdp", lambda mdp, steps, **how: mdp)
            monkeypatch.setattr(trainers, "checked_agent", lambda agent, task, steps: agent)
        agent = learner()
        run = train(
            task(SLIPPERY.replace("SlipperyWalk", "Walk").replace("slip: float", "slip: float = 0.2")), agent, 400
        )
        runs.append((agent.Q.tobytes(), run.returns.tobytes(), run.training_returns.tobytes()))
    assert runs[0] == runs[1]
