"""Copies of a task do what the single environment does, whatever becomes of a student's states, code and mistakes."""

import copy
import pickle
import re
import traceback
import warnings
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.vector import AutoresetMode

from edugym import MDPEnv, MDPVectorEnv, make_mdp
from edugym.adapters.registration import ENVIRONMENTS
from tests.adapters.tasks import TRAIL
from tests.compiled.cells import cell
from tests.contract.play import Copies, plain
from tests.messages import named


def alike(task: Any, mode: AutoresetMode, n_steps: int, action: Any = None) -> list[bool]:
    """Compare three copies with single environments that draw from one stream; tell at each step if they compile."""
    alone, vector = Copies([MDPEnv(task) for _ in range(3)], mode, seed=5), MDPVectorEnv(task, 3, mode)
    space, compiled = vector.single_observation_space, []
    vector.action_space.seed(0)
    observations, _ = vector.reset(seed=5)
    for _ in range(n_steps):
        assert plain(observations) == plain(np.array(alone.observations, space.dtype).reshape(3, *(space.shape or ())))
        actions = vector.action_space.sample() if action is None else np.full(3, action)
        rewards, terminations, truncations, last = alone.step(list(actions))
        observations, *seen, infos = vector.step(actions.astype(np.uint16) if actions.dtype.kind == "i" else actions)
        assert [part.tolist() for part in seen] == [rewards, terminations, truncations]
        assert plain([vector.state(i) for i in range(3)]) == plain([env.state for env in alone.envs])
        assert plain(list(infos.get("final_obs", last))) == plain(
            [one if one is None else np.array(one, space.dtype) if space.shape else one for one in last]
        )
        actions[:] = 1 - actions  # whoever gave them may use the array again
        for i, env in enumerate(alone.envs):
            assert plain(vector.showing(i).info()) == plain(env.info())
            assert vector.showing(i).steps == env.steps
            assert vector.showing(i).scene() == env.scene()
        compiled.append(vector.is_compiled)
    return compiled


REMEMBERING = """
from edugym.rendering.scene import Scene

class Remembered(NamedTuple):
    action_space: object
    max_steps: int = 5
    end: int = 16  # the last state that is not terminal
    observation_space = property(lambda self: spaces.Discrete(100))
    def initial(self, rng): return int(rng.random() * 10)
    def transition(self, state, action, rng): return state + 1 + int(rng.random() * 3)
    def reward(self, state, action, next_state, rng): return float(np.ravel(action)[0] - 2)  # unsigned would overflow
    def terminal(self, state): return state > self.end
    def observation(self, state, rng): return state
    def info(self, state, last_state, last_action, actions, steps):
        return {"all": (state, last_state, last_action, list(actions), steps)}

class Latest(Remembered):
    def info(self, state, last_action): return {"last": last_action}

class Drawn(Remembered):
    def info(self, state): return {}
    def scene(self, state, last_state, actions):
        return Scene(1.0 + state + 100 * (last_state or 0), 1.0 + sum(map(float, np.ravel(actions))), ())
"""
"""Tasks whose info asks for everything, or for the last action only; or whose picture asks, and the info does not."""
FEW = ["Boulder", "Study", "Catch", "MemoryCorridor"]
"""The environments of the quick tests; the picture of Study asks for all actions."""
NOTEBOOK = cell(REMEMBERING)
Remembered, Latest, Drawn = (NOTEBOOK[name] for name in ("Remembered", "Latest", "Drawn"))


@pytest.mark.filterwarnings("ignore:.* interpreted")
@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP])
@pytest.mark.parametrize(
    "task",
    [
        Remembered(spaces.Discrete(1000)),
        Remembered(spaces.Box(0, 1, (2,), np.float32)),
        Remembered(spaces.MultiDiscrete([3, 200])),
        Latest(spaces.Discrete(128)),
        Drawn(spaces.Discrete(3)),
    ],
    ids=lambda task: f"{type(task).__name__}, {task.action_space}",
)
def test_what_each_of_several_copies_knows(task: Any, mode: AutoresetMode) -> None:
    """Its own steps, last state and actions, as far as its info and its picture ask for them."""
    alike(task, mode, 60)


@pytest.mark.parametrize(
    "entry",
    [pytest.param(entry, id=entry.name, marks=[pytest.mark.slow] * (entry.name not in FEW)) for entry in ENVIRONMENTS],
)
def test_what_copies_show(entry: Any) -> None:
    """The picture and the info of a copy are those of a single environment, also after copying and pickling."""
    env = entry.load()()
    vector = MDPVectorEnv(entry.load()(), 1, "SameStep")
    env.reset(seed=3)
    vector.reset(seed=3)
    vector.action_space.seed(0)
    for step in range(40):
        actions = vector.action_space.sample()
        vector.step(actions)
        if any(env.step(actions[0])[2:4]):
            env.reset()
        one = vector.showing(0)
        assert plain((one.info(), one.steps)) == plain((env.info(), env.steps))
        assert repr(one.state) == repr(env.state)
        assert one.scene() == env.scene(), step
        if step == 20:
            vector = pickle.loads(pickle.dumps(copy.deepcopy(vector)))


def test_what_is_kept_for_pictures() -> None:
    """Of a long run no more than a picture asks for, which is seen in the size of a pickled vector environment."""
    study = MDPVectorEnv(MDPEnv(make_mdp("Study", total_days=50)), 3)
    boulder = MDPVectorEnv(MDPEnv(make_mdp("Boulder")), 3)
    for vector in (study, boulder):
        vector.reset(seed=0)
        sizes = []
        for _ in range(1000):
            vector.step(np.ones(3, np.int64))
            sizes.append(len(pickle.dumps(vector)))
        assert max(sizes) <= max(sizes[: 3 * 50])
    assert len(study.showing(0).actions) == study.showing(0).steps
    assert (boulder.showing(0).actions, type(boulder.state(2))) == ([], int)
    wrong: Any
    for wrong in (-1, 3, 1.0):  # copies are numbered from 0
        for method in (boulder.state, boulder.showing):
            with pytest.raises(ValueError, match=named("i", 0, 2, repr(wrong))):
                method(wrong)


@pytest.mark.parametrize(("asked", "limit"), [(None, 5), (-1, 5), (7, 5), (5, 5), (3, 3)])
def test_the_lower_limit_counts(asked: int | None, limit: int) -> None:
    """The task's own, or what is asked for."""
    task: Any = Remembered(spaces.Discrete(1))._replace(end=40)
    vector = MDPVectorEnv(MDPEnv(task), 2, max_episode_steps=asked)
    vector.spec = gymnasium.spec("edugym/Boulder-v0")
    assert vector.spec.max_episode_steps == limit
    vector.reset(seed=0)
    truncated = [vector.step([0, 0])[3].tolist() for _ in range(limit)]
    assert truncated == [[False, False]] * (limit - 1) + [[True, True]]


TASK = """
class Place(NamedTuple):
    x: float
    laps: int

class Task(NamedTuple):
    max_steps: int = 250
    def initial(self, rng): return {initial}
    def transition(self, state, action, rng): return {transition}
    def reward(self, state, action, next_state, rng): return {reward}
    def terminal(self, state): return {terminal}
    def observation(self, state, rng): return {observation}
    observation_space = property(lambda self: {space})
    action_space = property(lambda self: spaces.Discrete(2))
{more}
"""


def task(initial: str, transition: str, reward: str = "1.0", terminal: str = "False", **seen: str) -> Any:
    """A student's task from a cell, which shows nothing but 0 where nothing else is said."""
    shown = {"observation": "0", "space": "spaces.Discrete(1)", "more": "", **seen}
    parts = {"initial": initial, "transition": transition, "reward": reward, "terminal": terminal, **shown}
    return cell(TASK.format(**parts))["Task"]()


ARRAY = """
    def seen(self, state, rng):
        seen = np.zeros(2)
        seen[0] = state
        seen[1] = rng.random()
        return seen
"""
IN_PLACE = """
    def observe_into(self, state, rng, out):
        out[0] = state
        out[1] = rng.random()
"""


BOX, PAIR = "spaces.Box(-1e3, 1e3, {})", "(2,), np.float64"
NESTED = "((state, 1, 2), (3, rng.random(), -state))"


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    ("observation", "space", "more"),
    [
        (NESTED, "(2, 3), np.float32", ""),
        ("self.seen(state, rng)", PAIR, ARRAY),
        ("self.seen(state, rng)", PAIR, ARRAY + IN_PLACE),
    ],
    ids=["nested", "an array", "in place"],
)
def test_observations_of_every_kind(observation: str, space: str, more: str) -> None:
    """They are written into rows, last ones included, with the random numbers that they take, in machine code."""
    shown = {"observation": observation, "space": BOX.format(space), "more": more}
    walk = task("int(rng.random() * 2)", "state + 1 + action", "float(state)", "state >= 10", **shown)
    assert all(alike(walk, AutoresetMode.SAME_STEP, 30))


def test_states_with_arrays() -> None:
    """Which grow, beside a number, in machine code."""
    assert all(alike(cell(TRAIL)["Trails"](9), AutoresetMode.SAME_STEP, 60))


STATES = {
    "fractions in a tuple": ("(0, 0)", "(state[0] + 0.25 if state[1] > 150 else state[0], state[1] + 1)", 0),
    "chance": ("int(rng.random() * 10)", "state + (int(rng.random() * 3) if state < 150 else rng.random())", 100),
    "a tuple that grows": ("(0,)", "(state[0] + 1, 7) if len(state) > 1 or state[0] > 150 else (state[0] + 1,)", 0),
    "small numbers": ("np.int8(0)", "np.int8(state + 1) if state < 100 else np.int64(state + 1)", 0),
    "huge numbers": ("1", "state * 2 + action if state < 2**70 else 1", 0),
    "texts": ("'start'", "state + '>'", 0),
    "none": ("None", "1 if state is None else state + 1", 0),
    "tuples of any length": ("()", "(*state, action)", 0),
    "array": ("(np.zeros(2), 0)", "(state[0] + 1.0, state[1] + 1.5 if state[1] > 150 else state[1] + 1)", 0),
}


@pytest.mark.filterwarnings("ignore:.* cannot be compiled", "ignore:overflow", "ignore:.* number of .* digits")
@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] * (name == "array")) for name in STATES])
def test_states_of_any_kind(name: str) -> None:
    """No digit is lost if the type changes after the steps that were tried: all go on interpreted, with one warning."""
    initial, transition, compiled = STATES[name]
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        runs = alike(task(initial, transition, "rng.random()"), AutoresetMode.NEXT_STEP, 170, action=1)
    assert all(runs[:compiled])
    assert not any(runs[160:])
    said = [str(one.message) for one in told if "from here on" in str(one.message)]
    assert len(said) == bool(compiled)
    assert all(one.startswith("Task runs interpreted from here on, some hundred times slower") for one in said)
    assert {one.filename for one in told if "runs interpreted" in str(one.message)} <= {__file__}
    assert name != "texts" or re.match("Task cannot be compiled and runs .* tuples of num", str(told[0].message))


@pytest.mark.filterwarnings("ignore:.* interpreted")
@pytest.mark.parametrize(
    ("first", "change", "size"),
    [
        (0, "self.n[0] += 1", 1),
        (149, "self.n[0] += 1", 200_000),
        pytest.param(149, "n = self.n[:1]\n        n += 1", 200_000, marks=pytest.mark.slow),
        (149, "np.add(self.n, 1, self.n)", 200_000),
        pytest.param(149, "self.n.fill(self.n[0] + 1)", 200_000, marks=pytest.mark.slow),
    ],
)
def test_what_an_mdp_counts(first: int, change: str, size: int) -> None:
    """In an array of its own, a large one too: the call at which machine code gives up is repeated, and counts once."""
    count = (
        f"    def counted(self, state):\n        if state < {first}: return 0\n        {change}\n        return 0\n"
        f"    n: np.ndarray = np.zeros({size}, np.int64)"
    )
    walk = task("0", "self.counted(state) + (state + 1 if state < 150 else state + 0.5)", more=count)
    vector = MDPVectorEnv(walk, 2)
    vector.reset(seed=0)
    for _ in range(160):
        vector.step([0, 0])
    assert walk.n[0] == 2 * (160 - first)


NONE, NAN = "None if state == 150 else 1.0", "math.nan if state == 150 else 1.0"
LATE = {
    "an error": ({"reward": "float(np.zeros(150)[state])"}, IndexError, "index 150 is out of bounds"),
    "no next state": (
        {"transition": "None if state == 150 else state + 1"}, ValueError, "next state, .* None for state .*150"),
    "no reward": ({"reward": NONE}, ValueError, "a finite number, .* None for state .*150"),
    "nan": ({"reward": NAN}, ValueError, "a finite number, .* nan for state .*150"),
    "no end": ({"terminal": "None if state == 151 else False"}, ValueError, "True or False, .* None for state .*151"),
    "half an end": ({"terminal": "0.5 if state == 151 else False"}, ValueError, "True or False, .* 0.5 for state"),
}  # fmt: skip
"""Parts of a task that go wrong at the 151st step, and what is raised."""


def late(name: str, number: str = "") -> Any:
    """The task of a row of `LATE`, whose states may be numbers of NumPy's."""
    parts = {"transition": "state + 1", **LATE[name][0]}
    parts["transition"] = parts["transition"].replace("state + 1", f"{number}(state + 1)")
    return task(f"{number}(0)", **parts)


@pytest.mark.filterwarnings("ignore:.* interpreted")
@pytest.mark.parametrize("name", LATE)
def test_late_mistakes(name: str) -> None:
    """One sentence at the student's line says what is wrong, compiled or not, and no copy goes on with NaN."""
    parts, kind, says = LATE[name]
    for number in ("", "np.int16"):
        vector = MDPVectorEnv(late(name, number), 2)
        vector.reset(seed=0)
        for _ in range(150):
            vector.step([0, 0])
        with pytest.raises(kind, match=says) as caught:
            vector.step([0, 0])
        here, *students = traceback.extract_tb(caught.value.__traceback__)
        assert here.filename == __file__
        assert [str(frame.line) for frame in students] == [
            f"def reward(self, state, action, next_state, rng): return {parts.get('reward')}"
        ] * (kind is IndexError)
        assert caught.value.__context__ is None
        vector.reset(seed=0)
        vector.step([0, 0])


@pytest.mark.parametrize("name", ["no next state", "no reward", "no end", "half an end"])
def test_late_mistakes_in_one_environment(name: str) -> None:
    """The same sentence, among the first steps, which are checked more closely, and after them."""
    _, kind, says = LATE[name]
    for episodes_before in (0, 2):
        env = MDPEnv(late(name))
        for _ in range(episodes_before):
            env.reset(seed=0)
            for _ in range(120):
                env.step(0)
        env.reset(seed=0)
        with pytest.raises(kind, match=says):
            [env.step(0) for _ in range(200)]


@pytest.mark.filterwarnings("ignore:.* interpreted")
@pytest.mark.parametrize("mode", [None, *AutoresetMode], ids=str)
def test_a_late_episode_that_starts_at_its_end(mode: AutoresetMode | None) -> None:
    """The same sentence in one environment (None) and in copies, however these begin again."""
    walk = task("3 if rng.random() < 0.002 else 0", "state + 1", terminal="state == 3")
    env: Any = MDPEnv(walk) if mode is None else MDPVectorEnv(walk, 2, mode)
    env.reset(seed=1)
    steps: list[int] = []

    def play() -> None:
        while len(steps) < 9_000:
            steps.append(1)
            _, _, over, _, _ = env.step(0 if mode is None else [0, 0])
            if mode is None and over:
                env.reset()
            if mode is AutoresetMode.DISABLED and over.any():
                env.reset(options={"reset_mask": over})

    with pytest.raises(ValueError, match=r"initial of Task .*not terminal, .* 3"):
        play()
    assert len(steps) > 200  # the first are checked in every way
