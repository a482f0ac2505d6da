"""Copies of a student's task do what the single environment does, whatever becomes of its states and its code."""

import copy
import pickle
import traceback
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym.adapters import runner
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.registration import make_mdp
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.compiled.execution import executable
from tests.compiled.cells import WALK, cell
from tests.contract.play import every_environment, plain

TASK = """
class Task(NamedTuple):
    size: int
    def initial(self, rng): return {initial}
    def transition(self, state, action, rng):
        {transition}
    def reward(self, state, action, next_state, rng): return {reward}
    def terminal(self, state): return False
    def observation(self, state, rng): return 0
    observation_space = property(lambda self: spaces.Discrete(1))
    action_space = property(lambda self: spaces.Discrete(2))
"""


def task(initial: str, transition: str, reward: str) -> Any:
    """A student's task from a cell."""
    return cell(TASK.format(initial=initial, transition=transition, reward=reward))["Task"](1)


CHANGING = {
    "fractions": ("0", "return state + 1 if state < 150 else state + 0.25", "float(state)", True),
    "fractions in a tuple": (
        "(0, 0)",
        "return (state[0] + 0.25 if state[1] > 150 else state[0], state[1] + 1)",
        "float(state[0])",
        True,
    ),
    "beside an array": (
        "(np.zeros(2), 0)",
        "return (state[0] + 1.0, state[1] + 1.5 if state[1] > 150 else state[1] + 1)",
        "float(state[1])",
        True,
    ),
    "small numbers": ("np.int8(0)", "return np.int8(state + 1) if state < 100 else np.int64(state + 1)", "0.0", False),
    "a tuple that grows": (
        "(0,)",
        "return (state[0] + 1, 7) if len(state) > 1 or state[0] > 150 else (state[0] + 1,)",
        "float(len(state))",
        False,
    ),
    "huge numbers with the action": ("1", "return state * 2 + action if state < 2**70 else 1", "float(state)", False),
    "huge numbers": ("1", "return state * 2 if state < 2**70 else 1", "float(state)", False),
}


@pytest.mark.filterwarnings("ignore:.* runs interpreted", "ignore:overflow")
@pytest.mark.parametrize(("initial", "transition", "reward", "compiles"), CHANGING.values(), ids=CHANGING)
def test_states_that_change_late(initial: str, transition: str, reward: str, compiles: bool) -> None:
    """No digit is lost, also if the change comes after the steps that were tried."""
    changing = task(initial, transition, reward)
    env, vector = MDPEnv(changing), MDPVectorEnv(MDPEnv(changing), 2)
    env.reset(seed=0)
    vector.reset(seed=0)
    for step in range(200):
        _, expected, *_ = env.step(1)
        _, rewards, *_ = vector.step([1, 1])
        assert rewards.tolist() == [expected, expected]
        assert plain([vector.state(0), vector.state(1)]) == plain([env.state, env.state])
        if not 149 <= step <= 151:
            assert vector.is_compiled == (compiles and step < 150)


@pytest.mark.filterwarnings("ignore:.* runs interpreted")
def test_an_end_beside_a_change() -> None:
    """A step that is done again begins where it began: who has ended in the first try is not reset by the second."""
    source = TASK.format(initial="0", transition="return state + (0.25 if action and state > 150 else 1)", reward="1.0")
    ending = cell(source.replace("return False", "return state == 160"))["Task"](1)
    vector = MDPVectorEnv(MDPEnv(ending), 3)
    vector.reset(seed=0)
    for _ in range(159):
        vector.step([0, 0, 0])
    assert vector.is_compiled
    assert [part.tolist() for part in vector.step([0, 0, 1])[1:3]] == [[1.0] * 3, [True, True, False]]
    assert not vector.is_compiled
    assert [vector.state(i) for i in range(3)] == [160, 160, 159.25]


@pytest.mark.filterwarnings("ignore:.* runs interpreted")
def test_a_step_that_is_done_again_counts_once() -> None:
    """It draws the same random numbers, and the step limit is where it was."""
    changing = "return state + (0.25 if action and state > 150 else 1)"
    source = TASK.format(initial="0", transition=changing, reward="rng.random()")
    drawing = cell(f"{source}    max_steps = property(lambda self: 170)")["Task"](1)
    env, vector = MDPEnv(drawing), MDPVectorEnv(MDPEnv(drawing), 1)
    env.reset(seed=0)
    vector.reset(seed=0)
    for step in range(170):
        _, reward, _, truncated, _ = env.step(int(step == 160))
        _, rewards, _, truncations, _ = vector.step([int(step == 160)])
        assert (rewards.tolist(), truncations.tolist()) == ([reward], [truncated])
    assert truncated
    assert not vector.is_compiled


def test_the_change_is_announced() -> None:
    """Once, with the name of the class."""
    vector = MDPVectorEnv(MDPEnv(task("0", "return state + 1 if state < 120 else state + 0.25", "0.0")), 2)
    vector.reset(seed=0)
    with pytest.warns(UserWarning, match="Task runs interpreted from here on, some hundred times slower") as caught:
        several_steps(vector, 130)
    assert len(caught) == 1
    assert caught[0].filename == __file__


def several_steps(vector: Any, n: int) -> None:
    """Take them."""
    for _ in range(n):
        vector.step([0, 0])


def test_late_error() -> None:
    """An error after many steps ends at the student's line, as in the single environment."""
    late = task("0", "return state + 1", "float(np.zeros(150)[state])")
    vector = MDPVectorEnv(MDPEnv(late), 2)
    vector.reset(seed=0)
    several_steps(vector, 150)
    with pytest.raises(IndexError, match="index 150 is out of bounds for axis 0 with size 150") as caught:
        vector.step([0, 0])
    here, students = traceback.extract_tb(caught.value.__traceback__)
    assert here.filename == __file__
    assert "np.zeros(150)[state]" in str(students.line)


def one_by_one(env: MDPEnv[Any], n: int) -> None:
    """Take some steps."""
    for _ in range(n):
        env.step(0)


NOTHING = {
    "transition": (
        ("return None if state == 150 else state + 1", "float(state)"),
        "the next state, .* None for state .*150",
    ),
    "reward": (
        ("return state + 1", "None if state == 150 else 1.0"),
        "a finite number, but returned None for state .*150",
    ),
    "nan": (
        ("return state + 1", "math.nan if state == 150 else 1.0"),
        "a finite number, but returned nan for state .*150",
    ),
}


@pytest.mark.parametrize(("methods", "says"), NOTHING.values(), ids=NOTHING)
@pytest.mark.parametrize("initial", ["0", "np.int16(0)"], ids=["compiled", "interpreted"])
@pytest.mark.filterwarnings("ignore:.* interpreted")
def test_what_is_none_late(methods: tuple[str, str], says: str, initial: str) -> None:
    """One sentence says what is missing, as in the single environment, and no copy goes on with NaN."""
    late = task(
        initial,
        methods[0].replace("state + 1", "type(state)(state + 1)" if "16" in initial else "state + 1"),
        methods[1],
    )
    vector = MDPVectorEnv(MDPEnv(late), 2)
    vector.reset(seed=0)
    several_steps(vector, 150)
    with pytest.raises(ValueError, match=f" of Task must return {says}") as caught:
        vector.step([0, 0])
    assert len(traceback.extract_tb(caught.value.__traceback__)) == 1
    assert caught.value.__context__ is None
    vector.reset(seed=0)
    several_steps(vector, 3)
    if "nan" not in methods[1]:
        for episodes_before in (0, 2):  # among the first 200 steps, which are checked more closely, or after them
            single = MDPEnv(late)
            for _ in range(episodes_before):
                single.reset(seed=0)
                one_by_one(single, 120)
            single.reset(seed=0)
            with pytest.raises(ValueError, match=f" of Task must return {says}"):
                one_by_one(single, 300)


def test_code_that_changes() -> None:
    """A method or a global name that is given another value counts from the next step on."""
    notebook = cell("PAY = 2.0\n" + WALK.replace("else -0.25", "else PAY"))
    Walk = notebook["Walk"]
    vector = MDPVectorEnv(MDPEnv(Walk(50)), 2)
    vector.reset(seed=0)
    assert vector.step([1, 1])[1].tolist() == [2.0, 2.0]
    notebook["PAY"] = 3.0
    assert vector.step([1, 1])[1].tolist() == [3.0, 3.0]
    Walk.reward = lambda self, state, action, next_state, rng: 42.0
    assert vector.step([1, 1])[1].tolist() == [42.0, 42.0]
    assert vector.is_compiled


def test_many_copies_start_quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many there are, only some are rehearsed by the interpreter."""
    rehearsed = []

    def recording(loop: Any, arguments: Any, **options: Any) -> Any:
        rehearsed.append(options["rehearsed"])
        assert all(len(part) <= 100 for part in arguments if isinstance(part, np.ndarray))
        return executable(loop, arguments, **options)

    monkeypatch.setattr(runner, "executable", recording)
    vector = MDPVectorEnv(MDPEnv(cell(WALK)["Walk"](3)), 300_000)
    vector.reset(seed=0)
    vector.step(np.ones(300_000, np.int64))
    assert vector.is_compiled
    assert rehearsed == [100, 100]


def test_which_copy() -> None:
    """Copies are numbered from 0; others are refused."""
    vector = gymnasium.make_vec("edugym/Boulder-v0", 3).unwrapped
    assert isinstance(vector, MDPVectorEnv)
    vector.reset(seed=0)
    wrongs: list[Any] = [-1, 3, 1.0, None]
    for wrong in wrongs:
        for method in (vector.state, vector.showing):
            with pytest.raises(ValueError, match="i must be "):
                method(wrong)
    assert type(vector.state(2)) is int


@every_environment
def test_what_copies_show(entry: Any) -> None:
    """The picture and the info of a copy are those of a single environment in the same episode, in every mode."""
    for mode in ("NextStep", "SameStep"):
        env = entry.load()()
        vector = MDPVectorEnv(entry.load()(), 1, mode)
        env.reset(seed=3)
        vector.reset(seed=3)
        vector.action_space.seed(0)
        over = False
        for step in range(40):
            actions = vector.action_space.sample()
            vector.step(actions)
            if over and mode == "NextStep":
                env.reset()
                over = False
            else:
                _, _, terminated, truncated, _ = env.step(actions[0])
                over = terminated or truncated
                if over and mode == "SameStep":
                    env.reset()
            one = vector.showing(0)
            assert plain(one.info()) == plain(env.info())
            assert repr(one.state) == repr(env.state)
            assert one.steps == env.steps
            assert one.scene() == env.scene(), (step, mode)
            if step == 20:
                vector = copy.deepcopy(vector)
            if step == 30:
                vector = pickle.loads(pickle.dumps(vector))


def test_each_copy_shows_its_own_steps() -> None:
    """Copies reach the top at different times, and count from 0 again."""
    vector = MDPVectorEnv(MDPEnv(make_mdp("Boulder", height=3)), 4, "SameStep")
    vector.reset(seed=0)
    steps = [0] * 4
    rng = np.random.default_rng(0)
    for _ in range(50):
        _, _, terminated, truncated, _ = vector.step(rng.integers(2, size=4))
        steps = [0 if over else n + 1 for n, over in zip(steps, terminated | truncated, strict=True)]
        assert [vector.showing(i).steps for i in range(4)] == steps
    assert len(set(steps)) > 1


def test_what_is_kept_for_pictures() -> None:
    """Of a long episode no more actions are kept than the episode has, and none where nothing asks for them."""
    study = MDPVectorEnv(MDPEnv(make_mdp("Study", total_days=50)), 3)
    boulder = MDPVectorEnv(MDPEnv(make_mdp("Boulder")), 3)
    for vector in (study, boulder):
        vector.reset(seed=0)
        for _ in range(1000):
            vector.step(np.ones(3, np.int64))
    assert 0 < len(study._actions) <= 2 * 50 + 16
    assert len(study.showing(0).actions) == study.showing(0).steps
    assert boulder._actions == []
