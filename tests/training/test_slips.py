"""The slips that students make are answered with one sentence that names them, and a traceback that is theirs."""

import threading
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import FrameStack, MDPEnv, MDPVectorEnv, QLearning, check_mdp, make_mdp, repeat, train, wrapper
from edugym.checks.agents import CheckedAgent
from tests.compiled.cells import LEARNER, WALK, cell
from tests.training.slips import (
    ACTS,
    END,
    ENVIRONMENT,
    LIMIT,
    MOVE,
    PAY,
    SEE,
    STEP,
    TRANSITION,
    VALUE,
    Slip,
    answered,
    changed,
    learner,
    looker,
    named,
    walk,
)  # fmt: skip

ON_POLICY = LEARNER.replace("next_state, terminated)", "next_state, next_action, terminated)")
ACT = "return best"
UPDATE = "self.Q[state, action] +="
PROPERTY = "    @property\n    def "
IN_MDP = {
    "transition without return": Slip(MOVE, MOVE[7:], "transition Walk None"),
    "reward without return": Slip(PAY, "pass", "reward Walk None missing"),
    "a text for a reward": Slip(PAY, "return 'much'", "reward Walk 'much'"),
    "NaN for a reward": Slip(PAY, "return float('nan')", "reward Walk nan"),
    "terminal without return": Slip(END, "pass", "terminal Walk None"),
    "a number for an end": Slip(END, "return 0.5", "terminal Walk True False 0.5"),
    "observation without return": Slip(SEE, "pass\n", "observation Walk Discrete(6) None"),
    "a float to see": Slip(SEE, "return float(state)\n", "observation Walk 0.0"),
    "beyond the space": Slip(SEE, "return state + 6\n", "observation Walk 6"),
    "a flag to see": Slip(SEE, "return state > 9\n", "observation Walk Discrete(6) False"),
    "initial without return": Slip("return 0\n", "0\n", "initial Walk first None"),
    "over at the start": Slip("return 0\n", "return self.size\n", "initial Walk not terminal 5"),
    "rng forgotten": Slip(TRANSITION, TRANSITION.replace(", rng", ""), "transition Walk (self, state, action)"),
    "self forgotten": Slip(TRANSITION, TRANSITION.replace("self, ", ""), "transition (state, action, rng)"),
    "another order": Slip(TRANSITION, "def transition(self, action, state, rng):", "transition (self, action, state,"),
    "misspelt": Slip(TRANSITION, TRANSITION.replace("trans", "tans"), "transition(self, 'tansition'"),
    "another name": Slip("def terminal", "def done", "Walk terminal(self, 'done'"),
    "no action space": Slip("def action_space", "def actions", "Walk action_space"),
    "no property": Slip(f"{PROPERTY}action_space", "    def action_space", "action_space Walk @property"),
    "actions from 1": Slip("Discrete(2)", "Discrete(2, start=1)", "action_space Walk from 0 start=1"),
    "a number for a space": Slip("return spaces.Discrete(2)", "return 2", "action_space Walk 2"),
    "a typo in max_steps": Slip(
        LIMIT, f"{PROPERTY}max_steps(self): return self.sise\n\n{LIMIT}", "sise", "self.sise", AttributeError
    ),
    "what a space needs": Slip("Discrete(2)", "Discrete(self.n)", "'n'", "Discrete(self.n)", AttributeError),
    "a typo": Slip(PAY, "return self.sise", "sise", "self.sise", AttributeError),
    "a typo at the start": Slip("return 0\n", "return self.sise\n", "sise", "self.sise", AttributeError),
    "a typo at the end": Slip(END, "return self.sise", "sise", "self.sise", AttributeError),
    "a typo to see": Slip(SEE, "return self.sise\n", "sise", "self.sise", AttributeError),
    "an unknown name": Slip(MOVE, "return stat", "stat", "return stat", NameError),
    "a new attribute": Slip(MOVE, "self.n = 1; return 0", "transition Walk self.n", "self.n = 1", AttributeError),
    "numpy's randomness": Slip(MOVE, "return int(np.random.random() * 2)", "transition Walk np.random rng"),
    "python's randomness": Slip(PAY, "import random; return random.random()", "reward Walk random rng"),
    "no probabilities": Slip(MOVE, "return rng.choice(2, p=[0.5, 0.4])", "sum 1", "rng.choice"),
    "an error of one's own": Slip(PAY, "raise KeyError('x')", "x", "raise KeyError", KeyError),
    "division by zero": Slip(PAY, "return 1 / state", "zero", "1 / state", ZeroDivisionError),
}
ROOMS = (
    WALK.replace("return 0\n", "return np.zeros(1)\n")
    .replace(SEE, "return int(state[0])\n")
    .replace(MOVE, "return np.maximum(0, state + 2 * action - 1)")
    .replace(" == self.size", "[0] == self.size")
)
"""The walk with a state that is an array."""
IN_PLACE = {
    "transition": Slip("return np.max", "state[0] += 1; return np.max", "transition Walk change state"),
    "reward": Slip("return 1.0 if", "state[0] = 2; return 1.0 if", "reward Walk change state"),
    "reward of the next": Slip("return 1.0 if", "next_state[0] = 2; return 1.0 if", "reward Walk change state"),
    "terminal": Slip("return state[0] ==", "state[0] += 1; return state[0] ==", "terminal Walk change state"),
    "observation": Slip("return int(", "state += 1; return int(", "observation Walk change state copy"),
}
IN_AGENT = {
    "act without return": Slip(ACT, "best", "act Learner None missing"),
    "a negative action": Slip(ACT, "return -1", "act Learner -1"),
    "a large action": Slip(ACT, "return 5", "act Learner 0 1 5"),
    "act misspelt": Slip(ACTS, "def akt(self, state, rng):", "Learner act(self, 'akt'"),
    "act by another name": Slip(ACTS, "def choose_action(self, state, rng):", "Learner act(self, 'choose_action'"),
    "act without rng": Slip(ACTS, "def act(self, state):", "act Learner (self, state, rng) (self, state)"),
    "act without self": Slip(ACTS, "def act(state, rng):", "act Learner (state, rng)"),
    "act the wrong way round": Slip(ACTS, "def act(self, rng, state):", "act Learner (self, rng, state)"),
    "act with more": Slip(ACTS, "def act(self, state, epsilon, rng):", "act Learner epsilon"),
    "learn misspelt": Slip("def learn", "def lern", "Learner learn(self, 'lern'"),
    "learn by another name": Slip("def learn", "def update", "Learner learn(self, 'update'"),
    "learn with done": Slip("terminated):", "terminated, done):", "learn Learner 'done' 'terminated'"),
    "learn with rng": Slip("terminated):", "terminated, rng):", "learn Learner 'rng' act"),
    "learn misnames": Slip("reward, next", "rewrad, next", "learn Learner 'rewrad' 'reward'"),
    "learn with the rest": Slip("terminated):", "terminated, *rest):", "learn Learner 'rest' among truncated"),
    "learn with a reward of several": Slip("reward, next", "*reward, next", "learn Learner 'reward' among"),
    "learn no method": Slip("    def learn", "    learn = 3\n    def old", "learn Learner 3"),
    "learn without self": Slip("def learn(self, ", "def learn(", "learn Learner self"),
    "everything": Slip("learn(self,", "learn(self, **k): k['state']\n    def old(self,", "learn Learner **k", "k["),
    "another key": Slip(VALUE, f"{{}}['reward']; {VALUE}", "'reward'", "{}['reward']", KeyError),
    "a key of everything": Slip("terminated):", "terminated, **k):\n        k['x']", "'x'", "k['x']", KeyError),
    "greedy misspelt": Slip(ACTS, f"def gredy(self, state, rng): return 0\n    {ACTS}", "Learner greedy 'gredy'"),
    "greedy without rng": Slip(ACTS, f"def greedy(self, state): return 0\n    {ACTS}", "greedy Learner (self, state)"),
    "greedy without return": Slip(ACTS, f"def greedy(self, state, rng): pass\n    {ACTS}", "greedy Learner None"),
    "greedy no method": Slip(ACTS, f"greedy = 1\n    {ACTS}", "greedy Learner 1"),
    "a generator": Slip("rate: float = 0.5", "rate: object = (0.5 for _ in range(9))", "Learner generator copied"),
    "a new agent": Slip(VALUE, f"return self._replace(rate=0.1)\n        {VALUE}", "learn Learner new"),
    "an unset variable": Slip("value = 0.0 if", "valeu = 0.0 if", "value", UPDATE, NameError),
    "NaN": Slip(VALUE, f"reward = np.nan; {VALUE}", "learn Learner Q[0, nan"),
    "numpy's randomness": Slip("rng.random() < 0.1", "np.random.rand() < 0.1", "act Learner np.random rng"),
    "a call of nothing": Slip(VALUE, f"self.decay(); {VALUE}", "decay", "self.decay()", AttributeError),
    "another index": Slip(UPDATE, "self.Q[state, action, 0] +=", "indices", "action, 0] +=", IndexError),
}


START = "return self.place, {}"
SPACE = "self.observation_space ="
RESET = "reset(self, *, seed=None, options=None):\n        super().reset(seed=seed)"
IN_ENVIRONMENT = {
    "four values": Slip(STEP, "return self.place, -1.0, False, {}", "step Line (observation, reward, terminated,"),
    "no return": Slip(STEP, "pass", "step Line None"),
    "no reward": Slip(STEP, "return self.place, None, False, False, {}", "step Line reward None"),
    "no end": Slip(STEP, "return self.place, -1.0, None, False, {}", "step Line terminated None"),
    "no limit": Slip(STEP, "return self.place, -1.0, False, 'no', {}", "step Line truncated 'no'"),
    "outside": Slip(STEP, "return -1, -1.0, False, False, {}", "step Line Discrete(6) -1"),
    "a flag to see": Slip(STEP, "return False, -1.0, False, False, {}", "step Line Discrete(6) False"),
    "reset without info": Slip(START, "return self.place", "reset Line (observation, info) 0"),
    "reset with more": Slip(START, "return self.place, {}, 0", "reset Line (observation, info) (0, {}, 0)"),
    "reset with a list": Slip(START, "return [self.place, {}]", "reset Line (observation, info) [0, {}]"),
    "reset outside": Slip(START, "return 6, {}", "reset Line Discrete(6) 6"),
    "a generator": Slip(SPACE, f"self.rows = (k for k in range(6)); {SPACE}", "Line generator copied"),
    "reset of the old kind": Slip(RESET, "reset(self):", "reset Line (self, *, seed=None, options=None) (self)"),
    "step without action": Slip("def step(self, action)", "def step(self)", "step Line (self, action) (self)"),
    "step misspelt": Slip("def step", "def stpe", "Line step(self, action)"),
    "no space": Slip("self.action_space =", "self.actions =", "Line action_space"),
    "a typo": Slip("+ 2 * action", "+ 2 * acton", "acton", "acton", NameError),
}
GYM_WRAPPER = """
import gymnasium
class Paid(gymnasium.RewardWrapper):
    def __init__(self, env):
        super().__init__(env)
    def reward(self, reward):
        return reward + 1.0
"""
IN_GYM_WRAPPER = {
    "no super": Slip("super().__init__(env)", "self.env = env", "__init__ Paid super().__init__(env)"),
    "misspelt": Slip("def reward(", "def rewards(", "Paid reward(self, reward)"),
    "nothing paid": Slip("return ", "", "step Paid reward None"),
    "no number": Slip("reward + 1.0", "float('nan')", "step Paid reward nan"),
    "no action": Slip("gymnasium.RewardWrapper", "gymnasium.ActionWrapper", "Paid action(self, action)"),
    "nothing seen": Slip("gymnasium.RewardWrapper", "gymnasium.ObservationWrapper", "Paid observation(self,"),
}
WAYS: tuple[Callable[[Any, Any], Any], ...] = (
    lambda task, agent: train(task, agent, 6_000, evaluate_every=3_000),
    lambda task, agent: repeat(task, {"mine": agent}, 30, repetitions=2, jobs=1),
    lambda task, agent: repeat(task, {"mine": agent}, 30, repetitions=2, jobs=2),
)
"""Other ways to the same slip than a short run: a long one, a run of several, and one in a thread."""


def in_turn(rows: dict[str, Slip]) -> pytest.MarkDecorator:
    """Each slip with one of the other ways."""
    return pytest.mark.parametrize(("name", "way"), [(name, WAYS[k % 3]) for k, name in enumerate(rows)])


def played(env: Any) -> None:
    """Five steps."""
    env.reset(seed=0)
    for _ in range(5):
        env.step(0)


@in_turn(IN_MDP | {f"{name} in place": slip for name, slip in IN_PLACE.items()})
def test_slips_in_an_mdp(name: str, way: Any) -> None:
    """In a run of an agent of the package, in the environments that play it, and where it is only checked."""
    slip = IN_MDP.get(name) or IN_PLACE[name.removesuffix(" in place")]
    task = walk(changed(WALK if name in IN_MDP else ROOMS, slip.old, slip.new))
    for call in (
        lambda: train(task, QLearning.create((6, 2)), 30),
        lambda: way(task, QLearning.create((6, 2))),
        lambda: played(MDPEnv(task)),
        lambda: MDPVectorEnv(task, 3).reset(seed=0) if name in IN_MDP else played(MDPEnv(task)),
    ):
        answered(slip.names, call, slip.line, slip.error)
    named("" if slip.line else slip.names, lambda: check_mdp(task), slip.error)


@in_turn(IN_AGENT)
def test_slips_in_an_agent(name: str, way: Any) -> None:
    """Off-policy and on-policy, in an MDP and in an environment of the student's that are right."""
    slip = IN_AGENT[name]
    for source in (changed(LEARNER, slip.old, slip.new), changed(ON_POLICY, slip.old, slip.new)):
        for call in (
            lambda: train(walk(), learner(source), 30),  # noqa: B023
            lambda: way(walk(), learner(source)),  # noqa: B023
            lambda: train(cell(ENVIRONMENT)["Line"](), learner(source), 30),  # noqa: B023
        ):
            answered(slip.names, call, slip.line, slip.error)


@in_turn(IN_ENVIRONMENT | IN_GYM_WRAPPER)
def test_slips_in_a_gymnasium_environment(name: str, way: Any) -> None:
    """One that no `gymnasium.make` has looked at, and a wrapper around one of the package's environments."""
    slip = (IN_ENVIRONMENT | IN_GYM_WRAPPER)[name]
    if name in IN_ENVIRONMENT:
        env = cell(changed(ENVIRONMENT, slip.old, slip.new))["Line"]()
    else:
        env = cell(changed(GYM_WRAPPER, slip.old, slip.new))["Paid"](MDPEnv(walk()))
    answered(slip.names, lambda: train(env, QLearning.create((6, 2)), 30), slip.line, slip.error)
    answered(slip.names, lambda: way(env, QLearning.create((6, 2))), slip.line, slip.error)


OTHER_NAMES = {
    "initial": "reset start initial_state",
    "transition": "step next_state dynamics",
    "terminal": "is_terminal done terminated is_done",
    "observation": "observe obs",
    "act": "choose choose_action select_action get_action policy",
    "learn": "update train fit",
}
"""What books and other libraries call the methods."""


@pytest.mark.parametrize("name", OTHER_NAMES)
def test_the_names_of_others_are_known(name: str) -> None:
    """However unlike the wanted name they are."""
    for other in OTHER_NAMES[name].split():
        of_agent, renamed = name in ("act", "learn"), (f"def {name}(", f"def {other}(")
        task = walk(WALK if of_agent else changed(WALK, *renamed))
        agent = learner(changed(LEARNER, *renamed) if of_agent else LEARNER)
        named(f"{name}(self, '{other}'", lambda: train(task, agent, 9))  # noqa: B023


WRAPPER = """
@wrapper
class Paid(NamedTuple):
    mdp: object
    def reward(self, state, action, next_state, rng):
        return self.mdp.reward(state, action, next_state, rng) + 1.0
"""


def wrapped(mdp: Any, source: str = WRAPPER) -> Any:
    """Something in a wrapper of a student's own."""
    return cell(source, {"wrapper": wrapper, "NamedTuple": NamedTuple, "__name__": "__main__"})["Paid"](mdp)


Walk, Learner = cell(WALK)["Walk"], cell(LEARNER)["Learner"]
Mine = cell("class Mine(NamedTuple):\n    def choose(self, Q, state, rng): pass")["Mine"]
TEXT = changed(WALK, PAY, "return 'x'")
GIVEN: dict[str, tuple[str, Callable[[], Any], Callable[[], Any]]] = {
    "a class for a task": ("environment Walk(", lambda: Walk, learner),
    "a class for an agent": ("agent Learner(", walk, lambda: Learner),
    "a class of ours": ("agent QLearning.create(", walk, lambda: QLearning),
    "whole numbers": ("Q Learner float int64 np.zeros((6, 2))", walk, lambda: learner(table=np.zeros((6, 2), int))),
    "flags": ("Q Learner float bool", walk, lambda: learner(table=np.zeros((6, 2), bool))),
    "copies of a task": ("environment MDPVectorEnv", lambda: MDPVectorEnv(walk(), 3), learner),
    "sizes for a table": ("Q QLearning 6 QLearning.create(", walk, lambda: QLearning(6, 2)),  # type: ignore[arg-type]
    "NaN": ("Q Learner Q[0, 0] nan", walk, lambda: learner(table=np.full((6, 2), np.nan))),
    "whole numbers in ours": ("Q QLearning float int64", walk, lambda: QLearning(np.zeros((6, 2), int))),
    "NaN in ours": ("Q QLearning Q[0, 0] nan", walk, lambda: QLearning(np.full((6, 2), np.nan))),
    "a table that does not fit": ("agent Q (6, 2)", walk, lambda: QLearning.create((3, 2))),
    "too many actions": ("act Learner 4 Q (6, 5)", walk, lambda: learner(table=np.arange(30.0).reshape(6, 5))),
    "too few actions": ("Q Learner (6, 1) 6 2", walk, lambda: learner(table=np.zeros((6, 1)))),
    "no task": ("environment None", lambda: None, learner),
    "a number for a task": ("environment 3", lambda: 3, learner),
    "a function for an agent": ("agent create call", walk, lambda: QLearning.create),
    "a wrapper of a class": ("mdp Paid Walk(...)", lambda: wrapped(Walk), learner),
    "a wrapper of a number": ("mdp Paid 0.5", lambda: wrapped(0.5), learner),
    "no decorator": ("environment @edugym.wrapper", lambda: wrapped(walk(), WRAPPER.replace("@wrapper", "")), learner),
    "ours around it": ("reward Walk 'x'", lambda: FrameStack.create(walk(TEXT), 2), lambda: QLearning.create((36, 2))),
    "no agent": ("agent act learn None", walk, lambda: None),
    "a number for an agent": ("agent act learn 0.5", walk, lambda: 0.5),
    "the wrong way round": ("environment agent Learner", learner, walk),
    "a strategy": ("act QLearning, Mine None", walk, lambda: QLearning(np.zeros((6, 2)), exploration=Mine())),
    "no numbers to see": ("table whole numbers Box", lambda: "CartPole-v1", lambda: QLearning.create((2, 2))),
    "no tabular": ("Box tabular False Looker", lambda: "CartPole-v1", lambda: looker("True")),
}


@pytest.mark.parametrize("name", GIVEN)
def test_what_is_given_is_wrong_as_a_whole(name: str) -> None:
    """Classes, tables, and what is neither a task nor an agent."""
    names, task, agent = GIVEN[name]
    answered(names, lambda: train(task(), agent(), 30))


def test_whose_name_an_agent_has() -> None:
    """Ours has that of a student's part too; one of the student's own has its name alone."""
    own = cell("class Own(NamedTuple):\n    part: object\n    def act(self, state, rng): pass")["Own"]
    for agent, name in (
        (QLearning(np.zeros((6, 2)), exploration=Mine()), "QLearning, with Mine"),
        (own(Mine()), "Own"),
    ):
        with pytest.raises(ValueError, match=rf"^act of {name} \w"):
            CheckedAgent(agent, walk()).act(0, np.random.default_rng(0))


@pytest.mark.parametrize(
    ("parameter", "value", "allowed"),
    [
        ("n_steps", 0, "1 or more"), ("n_steps", 1e5, "whole"), ("n_steps", "10", "whole"),
        ("max_steps", 0, "1 or more"), ("max_steps", True, "whole"), ("max_steps", 2**62 + 1, str(2**62)),
        ("evaluate_every", 0, "1 or more"), ("evaluation_episodes", 0, "from 1 to 1000000"),
        ("seed", -1, "0 or more"), ("seed", None, "whole"), ("stop", 3, "threading.Event None"),
    ],
)  # fmt: skip
def test_bad_parameters_are_refused(parameter: str, value: Any, allowed: str) -> None:
    """The message names the parameter, its value and what is allowed; nothing has been trained."""
    agent: Any = QLearning.create((6, 2))
    named(f"{parameter} {allowed} {value!r}", lambda: train(walk(), agent, **{"n_steps": 10, parameter: value}))
    named("stop threading.Event Event ()", lambda: train(walk(), agent, 9, stop=threading.Event))
    assert not agent.Q.any()


def test_what_is_given_to_repeat() -> None:
    """Agents have labels, and are made by what is given."""
    wrong: Any = QLearning.create
    named("agents dictionary", lambda: repeat("Boulder", wrong, 10))
    answered("QLearning QLearning.create", lambda: repeat(walk(), {"Q": QLearning}, 30))
    for name in ("Boulder", "edugym/Boulder-v0", "edugym:edugym/Boulder-v0"):
        assert repeat(name, {"Q": QLearning.create(make_mdp("Boulder"))}, 10, repetitions=1).complete


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ("self.Q[0, state + 3]", "size 3: Q of Learner has the shape (7, 3)"),
        ("self.Q[state + 7, 0]", "size 7: Q of Learner has the shape (7, 3)"), ("np.zeros(4)[4]", "size 4"),
        ("[0, 1][2]", "list index out of range"), ("'ab'[2]", "string index out of range"),
    ],
)  # fmt: skip
def test_an_index_that_is_too_large(wrong: str, says: str) -> None:
    """It is explained by the shape of the table, where it may be an index of that."""
    source = LEARNER.replace("range(self.Q.shape[1])", "range(2)").replace("* self.Q.shape[1]", "* 2")
    agent = learner(changed(source, VALUE, f"{wrong}; {VALUE}"), np.zeros((7, 3)))
    error = answered("index", lambda: train(walk(), agent, 99), "[", IndexError)
    assert says in str(error)
    assert ("shape" in str(error)) == ("shape" in says)
    fits = learner(changed(source, VALUE, f"self.Q[state + 6, 0]; {VALUE}"))
    answered("states 0 to 5 actions 0 to 1", lambda: train(walk(), fits, 99), "[", IndexError)
    answered("index 1 Learner (1, 2) 6 2", lambda: train(walk(), learner(table=np.zeros((1, 2))), 99), "", IndexError)
