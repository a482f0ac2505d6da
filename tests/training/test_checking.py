"""What is checked of students' agents and tasks: which actions pass, where the checks sit, and what a class shares."""

from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.wrappers import FlattenObservation, TransformReward

from edugym import EpsilonGreedy, QLearning
from edugym.adapters.tabular_observation import TabularObservation
from edugym.checks.mdps import CheckedMDP, checked_mdp
from edugym.training.checked_env import CheckedEnv, checked_env
from edugym.training.checking import CheckedAgent, checked_agent, shared_by_class, students_parts
from edugym.training.contract import GreedyActor, learner
from edugym.training.guarded import GUARDS, ActionsOfASpace, FiniteRewards, RowsOfATable, guarded
from edugym_course.lessons.own_problem.morning import WithBonus
from tests.training.tasks import Stairs, StudentsQLearning

RNG = np.random.default_rng(0)
NAN, INF = float("nan"), float("inf")


class Acting:
    """An agent that takes one action, in a task with these actions."""

    observation_space = spaces.Discrete(2)

    def __init__(self, action: Any, action_space: spaces.Space[Any]) -> None:
        """Which one."""
        self.action, self.action_space = action, action_space

    def act(self, state: Any, rng: Any) -> Any:
        """That one."""
        return self.action

    greedy = act


ACTIONS: dict[str, tuple[spaces.Space[Any], list[Any], list[Any]]] = {
    "a whole number from 0 to 2": (
        spaces.Discrete(3),
        [0, 2, np.int8(1), np.array(2)],
        [3, -1, True, np.True_, 1.0, None, [1], np.array([1]), np.array(1.0), "1"],
    ),
    "a whole number from 5 to 6": (spaces.Discrete(2, start=5), [5, np.int64(6)], [0, 1, 4, 7, True]),
    r"an element of Box\(-1.0, 1.0, \(2,\), float32\)": (
        spaces.Box(-1.0, 1.0, (2,)),
        [(0.5, 0), [3.0, -9], np.array([1, 2])],  # an MDP may cut them off at the bounds itself
        [(NAN, 0), (INF, 0.0), (0.5,), 0.5, ("a", "b"), None, ((1, 2), (3,)), (True, False), np.zeros((2, 1))],
    ),
    r"an element of Box\(-1.0, 1.0, \(1,\), float32\)": (
        spaces.Box(-1.0, 1.0, (1,)),
        [0.5, (0.5,), np.array(1), np.array([[0.5]])],
        [(0.5, 0.5), (), NAN, "x"],
    ),
    r"an element of MultiDiscrete\(\[2 3\]\)": (spaces.MultiDiscrete([2, 3]), [(1, 2), [0, 0]], [(2, 0), (1,), 1]),
}


@pytest.mark.parametrize("method", ["act", "greedy"])
@pytest.mark.parametrize("steps", [0, 9])
@pytest.mark.parametrize("allowed", ACTIONS)
def test_which_actions_pass(allowed: str, steps: int, method: str) -> None:
    """As they are, in the first steps and later; of others it is said what they should be."""
    space, right, wrong = ACTIONS[allowed]
    for action in right:
        agent = Acting(action, space)
        assert getattr(CheckedAgent(agent, agent, steps), method)(0, RNG) is action
    for action in wrong:
        agent = Acting(action, space)
        says = f"^{method} of Acting must return an action, {allowed}, but returned .* for state 0"
        with pytest.raises(ValueError, match=says + (r" \(is a return missing\?\)$" if action is None else "$")):
            getattr(CheckedAgent(agent, agent, steps), method)(0, RNG)


def test_only_the_first_steps_are_checked_in_every_way() -> None:
    """Two of them: a state that is changed in the third is not looked at."""

    class Changing(Acting):
        def act(self, state: Any, rng: Any) -> Any:
            state[0] += self.action
            return 0

    state, agent = np.zeros(1), Changing(0, Stairs().action_space)
    checked = CheckedAgent(agent, Stairs(), 2)
    for agent.action in (0, 0, 1):
        assert checked.act(state, RNG) == 0
    assert state == 1
    with pytest.raises(ValueError, match="act of Changing must not change the state"):
        CheckedAgent(agent, Stairs(), 1).act(state, RNG)


def test_no_lesson_is_lost_when_the_checks_end() -> None:
    """The agent learns from every step, from then on without a detour."""

    class Counting(Acting):
        n_learned = 0

        def learn(self, reward: float) -> None:
            self.n_learned += 1

    agent = Counting(0, Stairs().action_space)
    checked = CheckedAgent(agent, Stairs(), 1)
    for n_learned in (1, 2, 3):
        checked.act(0, RNG)
        checked.learn(reward=1.0)
        assert agent.n_learned == n_learned
    assert checked.learn == agent.learn


@pytest.mark.parametrize("n_rows", [5_000, 5_001])
def test_only_a_small_table_is_searched_for_nan(n_rows: int) -> None:
    """After each of the first steps: up to 10 000 numbers."""

    class Spoiling(Acting):
        Q = np.zeros((2, 2))

        def learn(self, reward: float) -> None:
            self.Q[0, 1] = reward

    agent = Spoiling(0, Stairs().action_space)
    agent.Q = np.zeros((n_rows, 2))
    checked = CheckedAgent(agent, Stairs(), 1)
    if n_rows > 5_000:
        checked.learn(reward=NAN)
        return
    with pytest.raises(ValueError, match=r"learn of Spoiling must leave numbers in Q, but Q\[0, 1\] is nan"):
        checked.learn(reward=NAN)


def test_a_key_of_a_dictionary_of_ones_own_is_only_missing_there() -> None:
    """It is not what `learn` is told, though it has the same name."""

    class Looking(Acting):
        def learn(self, state: int) -> None:
            notes: dict[str, float] = {}
            notes["reward"] += 1

    class LookingForMore(Acting):
        def learn(self, **told: Any) -> None:
            told["bonus"] += 1

    space = Stairs().action_space
    with pytest.raises(KeyError, match=r"^'reward'$"):
        CheckedAgent(Looking(0, space), Stairs(), 1).learn(state=0)
    with pytest.raises(KeyError, match=r"^'bonus'$"):
        CheckedAgent(LookingForMore(0, space), Stairs(), 1).learn(state=0)


@pytest.mark.parametrize(
    ("action", "of_a_row"), [(2, True), (np.int64(2), True), (True, False), (None, False), (0.5, False)]
)
def test_the_size_of_a_table_explains_a_number_only(action: Any, of_a_row: bool) -> None:
    """An action that is no whole number has not come from a table that is too wide."""
    agent: Any = Acting(action, Stairs().action_space)
    agent.Q = np.zeros((4, 3))
    with pytest.raises(ValueError, match="act of Acting must return an action") as caught:
        CheckedAgent(agent, Stairs(), 1).act(0, RNG)
    assert ("Q of Acting has the shape (4, 3)" in str(caught.value)) == of_a_row


def test_checks_are_next_to_the_students_task() -> None:
    """Inside the package's wrappers, whose classes no message should blame; guards, which say less, are left out."""
    student = Stairs()
    own, mine = QLearning.create(Stairs()), StudentsQLearning(np.zeros((4, 2)))
    inner = guarded(student, own)
    assert [type(part) for part in (inner, inner.mdp)] == [FiniteRewards, RowsOfATable]
    assert type(guarded(student, mine)) is ActionsOfASpace
    for outside in (student, inner, guarded(student, mine)):
        checked = checked_mdp(outside, instead_of=GUARDS)
        assert type(checked) is CheckedMDP
        assert checked._mdp is student
    wrapped = checked_mdp(guarded(WithBonus(student, 3.0), mine), instead_of=GUARDS)
    assert type(wrapped) is WithBonus
    assert type(wrapped.mdp) is CheckedMDP


class Pictures(Stairs):
    """A task that shows pictures."""

    __slots__ = ()

    @property
    def observation_space(self) -> Any:
        """Four pixels."""
        return spaces.Box(0.0, 1.0, (2, 2))


class PicturesInPlace(Pictures):
    """It writes them into an array."""

    __slots__ = ()

    def observe_into(self, state: int, rng: Any, out: Any) -> None:
        """Write them."""
        out[:] = 0.0


def test_pictures_have_no_guard_and_those_in_place_stay_so() -> None:
    """Machine code would look at each pixel."""
    mine = StudentsQLearning(np.zeros((4, 2)))
    assert type(guarded(Pictures(), QLearning.create(Stairs())).mdp) is Pictures
    assert hasattr(guarded(PicturesInPlace(), mine), "observe_into")


class Both(NamedTuple):
    """A student's agent in another one."""

    inner: Any


def test_checks_are_next_to_the_students_agent() -> None:
    """Inside what the loops make of it; the package's own agents have none."""
    own: QLearning = QLearning.create(Stairs())
    mine: Any = StudentsQLearning(np.zeros((4, 2)))
    for made in (learner, GreedyActor):
        assert type(checked_agent(made(mine), Stairs()).agent) is CheckedAgent
        assert type(checked_agent(made(own), Stairs()).agent) is QLearning
    with_strategy = own._replace(exploration=mine)
    assert type(checked_agent(with_strategy, Stairs())) is CheckedAgent
    assert students_parts(with_strategy) == ["StudentsQLearning"]
    assert students_parts(Both(mine)) == []
    assert students_parts(own._replace(exploration=EpsilonGreedy(0.2))) == students_parts(mine) == []


def test_what_a_class_shares() -> None:
    """Lists, dictionaries, sets and arrays of the class or those above it, unless the agent has one of its own."""
    above = type("Above", (), {"seen": {1}, "old": [1]})
    of_class = {"old": [2], "table": np.zeros(2), "names": {"a": 1}, "own": [], "rate": 0.5, "_hidden": []}
    agent: Any = type("Agent", (above,), of_class)()
    agent.own = []
    shared = shared_by_class(agent)
    agent.table[0] = agent.names["b"] = 1
    assert sorted(shared) == ["names", "old", "seen", "table"]
    assert (shared["seen"], shared["old"], shared["names"]) == ({1}, [2], {"a": 1})
    assert not shared["table"].any()
    assert shared_by_class(QLearning.create((2, 2))) == {}


class Lost(gymnasium.Env[Any, Any]):
    """An environment that shows what is not in its space, from the first step on."""

    observation_space, action_space = spaces.Discrete(2), spaces.Discrete(2)

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Somewhere else."""
        return 7, 0.0, False, False, {}


def test_the_last_of_the_first_steps_of_an_environment_is_checked() -> None:
    """The one after it is not."""
    with pytest.raises(ValueError, match=r"step of Lost must return an observation in Discrete\(2\), but returned 7"):
        CheckedEnv(Lost(), 1).step(0)
    assert CheckedEnv(Lost(), 0).step(0)[0] == 7


def test_a_wrapper_of_gymnasium_is_named_where_nothing_is_the_students() -> None:
    """Around a task of the package, which is not to blame."""
    env = TransformReward(gymnasium.make("edugym/Golf-v0"), lambda reward: 2 * float(reward))
    assert CheckedEnv(env)._of == "TransformReward"


def test_checks_are_taken_away() -> None:
    """From around a Gymnasium environment, also from inside the package's wrappers, after an error, too."""
    inner = gymnasium.make("FrozenLake-v1")
    for env in (TabularObservation(inner), FlattenObservation(inner)):
        around = checked_env(env)
        assert around.__enter__() is env
        assert type(env.env) is CheckedEnv
        assert not around.__exit__(KeyError, KeyError(), None)
        assert env.env is inner
    with checked_env(inner) as checked:
        assert type(checked) is CheckedEnv
