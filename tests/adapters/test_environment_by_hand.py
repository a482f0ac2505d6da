"""The window, the picture and the model of an environment, asked for one by one."""

import inspect
import traceback
from collections import Counter
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec

from edugym import make_mdp
from edugym.adapters.gymnasium_env import MDPEnv, as_element_of, environment_of, gymnasium_class
from edugym.adapters.registration import ENVIRONMENTS
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.rendering import window
from edugym.rendering.scene import Scene, Text
from tests.compiled.cells import SLIPPERY, WALK, cell


class Screen:
    """A window that notes what it is told."""

    made: list["Screen"]

    def __init__(self, title: str) -> None:
        """Note it."""
        self.title, self.shown, self.closed = title, list[Any](), 0
        self.made.append(self)

    def show(self, scene: Any, fps: float) -> None:
        """Note it."""
        self.shown.append((scene, fps))

    def close(self) -> None:
        """Note it."""
        self.closed += 1


@pytest.mark.parametrize("registered", [True, False])
def test_what_the_window_shows(monkeypatch: pytest.MonkeyPatch, registered: bool) -> None:
    """Every state, four a second, under the environment's id or the name of its class; it is closed once."""
    monkeypatch.setattr(window, "Window", Screen)
    monkeypatch.setattr(Screen, "made", [], raising=False)
    env: Any = gymnasium.make("edugym/Boulder-v0", render_mode="human").unwrapped
    env = env if registered else MDPEnv(env.mdp, render_mode="human")
    env.reset(seed=0)
    scenes = [env.scene()]
    for action in (0, 1):
        env.step(action)
        scenes.append(env.scene())
    (screen,) = Screen.made
    assert screen.title == ("edugym/Boulder-v0" if registered else "Boulder")
    assert screen.shown == [(scene, 4) for scene in scenes]
    for _ in range(2):
        env.close()
    assert screen.closed == 1
    env.render()
    assert len(Screen.made) == 2


def test_a_picture_for_a_task_that_has_none() -> None:
    """The state as text, in the middle of the picture; before the first reset an initial one."""
    env = MDPEnv(cell(WALK)["Walk"](5))
    assert env.scene() == Scene(12.0, 2.0, (Text(6.0, 1.2, "state 0", 0.6),))
    env.reset(seed=0)
    env.step(1)
    assert env.scene() == Scene(12.0, 2.0, (Text(6.0, 1.2, "state 1", 0.6),))


def test_outcomes_that_are_drawn() -> None:
    """As often as they are likely; a seed repeats them, and they shift nothing in the environment."""
    env, other = (MDPEnv(cell(SLIPPERY)["SlipperyWalk"](5, 0.25)) for _ in range(2))
    likely = {outcome.next_state: outcome.probability for outcome in env.descriptive_model(2, 1)}
    assert likely == {3: 0.75, 1: 0.25}
    drawn = [env.generative_model(2, 1) for _ in range(2_000)]
    assert {outcome.probability for outcome in drawn} == {1.0}
    assert Counter(outcome.next_state for outcome in drawn)[3] == pytest.approx(1_500, abs=80)
    runs: list[Any] = []
    for seed in (3, 4, 3):
        env.reset(seed=seed)
        runs.append([env.model(2, 1, "generative") for _ in range(30)])
    assert runs[0] == runs[2] != runs[1]
    assert [i for i, outcome in enumerate(runs[0]) if outcome.next_state == 1] == [14, 19, 24, 28]
    assert env.model(2, 1) == env.descriptive_model(2, 1)
    other.reset(seed=3)
    assert [env.step(1) for _ in range(3)] == [other.step(1) for _ in range(3)]
    with pytest.raises(ValueError, match="kind must be one of 'descriptive', 'generative', but is 'both'"):
        env.model(2, 1, "both")
    with pytest.raises(ValueError, match="action 2 is not in the action space"):
        env.model(2, 2)


@pytest.mark.parametrize("entry", ENVIRONMENTS, ids=lambda entry: entry.name)
def test_the_class_of_an_environment(entry: Any) -> None:
    """It is called after the task, has its docstring, and can be made in a render mode."""
    task = entry.load_mdp()
    kind = gymnasium_class(task, "somewhere")
    assert (kind.__name__, kind.__doc__, kind.__module__) == (f"{task.__name__}Env", task.__doc__, "somewhere")
    parameters = inspect.signature(kind).parameters
    assert list(parameters) == [*inspect.signature(task.create).parameters, "render_mode"]
    assert parameters["render_mode"].default is None
    env = kind(render_mode="ansi")
    assert env.render_mode == "ansi"
    assert repr(env.mdp) == repr(task.create())


def test_what_is_inside_an_environment() -> None:
    """The environment itself, or one of the task; other wrappers and what is no task are refused by name."""
    made: Any = gymnasium.make("edugym/Boulder-v0", height=3)
    assert environment_of(made) is made.unwrapped
    assert environment_of(made.unwrapped) is made.unwrapped
    mdp = make_mdp("Boulder", height=4)
    assert environment_of(mdp).mdp == mdp
    with pytest.raises(ValueError, match=r"^where must have no wrapper that changes it, but has TimeLimit: pass its"):
        environment_of(gymnasium.wrappers.TimeLimit(made, 3), "where")
    with pytest.raises(ValueError, match=r"^environment must be an MDP, .* but is 3$"):
        environment_of(3)


def test_an_observation_with_a_part_too_few() -> None:
    """It is no element of a space of two parts, and no part is left out in silence."""
    shown = as_element_of(spaces.Tuple([spaces.Discrete(3), spaces.Discrete(3)]))
    seen = shown((np.int64(1), 2))
    assert seen == (1, 2)
    assert [type(part) for part in seen] == [int, int]
    with pytest.raises(ValueError, match="zip"):
        shown((1,))


def test_the_history_of_an_episode() -> None:
    """The last state and action, and all actions, from the start of this episode; the random stream goes on."""
    env = MDPEnv(cell(WALK)["Walk"](5))
    assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (None, None, None, [], 0)
    for _ in range(2):
        env.reset()
        assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (0, None, None, [], 0)
        env.step(1)
        env.step(np.int64(0))
        assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (0, 1, 0, [1, 0], 2)


MISTAKES = {
    "made": ("    def initial", "    @property\n    def max_steps(self):\n        return self.sise\n\n    def initial"),
    "initial": ("return 0\n", "return self.sise\n"),
    "observation": ("return state\n", "return self.sise\n"),
    "step": ("return state == self.size", "return state == self.sise"),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_errors_end_at_the_students_line(name: str) -> None:
    """Whoever calls it, and whenever."""
    task = cell(WALK.replace(*MISTAKES[name]))["Walk"](5)
    for copies in (False, True):
        with pytest.raises(AttributeError, match="sise") as caught:
            played(task, copies=copies)
        frames = traceback.extract_tb(caught.value.__traceback__)
        assert str(frames[-1].line) in MISTAKES[name][1]
        assert all(frame.filename == __file__ for frame in frames[:-1])


def played(task: Any, *, copies: bool) -> None:
    """Made, reset and stepped."""
    env: Any = MDPVectorEnv(task, 2) if copies else MDPEnv(task)
    env.reset(seed=0)
    env.step([1, 1] if copies else 1)


def test_without_a_specification() -> None:
    """There is none where nobody has registered the task, and it can be taken away."""
    env = MDPEnv(make_mdp("Boulder"))
    assert env.spec is None
    env.spec = gymnasium.spec("edugym/Boulder-v0")
    assert env.spec is not None
    assert (env.spec.max_episode_steps, env.spec.reward_threshold) == (100, 1.0)
    env.spec = None
    assert env.spec is None


@pytest.mark.parametrize("given", [{}, {"max_episode_steps": 7}, {"reward_threshold": 0.0}])
def test_only_what_a_specification_lacks_is_filled_in(given: dict[str, Any]) -> None:
    """A limit or a threshold that somebody has registered is kept, also as JSON; the task's own is not written."""
    env = MDPEnv(make_mdp("Boulder"))
    env.spec = EnvSpec("mine/Wall-v0", **given)
    assert env.spec is not None
    own: dict[str, Any] = {"max_episode_steps": 100, "reward_threshold": 1.0, **given}
    assert {name: getattr(env.spec, name) for name in own} == own
    written = EnvSpec.from_json(env.spec.to_json())
    assert written.max_episode_steps == given.get("max_episode_steps")
    assert written.reward_threshold == own["reward_threshold"]


def test_the_window_of_several_copies(monkeypatch: pytest.MonkeyPatch) -> None:
    """They share one, which is closed with them."""
    monkeypatch.setattr(window, "Window", Screen)
    monkeypatch.setattr(Screen, "made", [], raising=False)
    vector = MDPVectorEnv(MDPEnv(make_mdp("Boulder"), render_mode="human"), 2)
    vector.reset(seed=0)
    vector.render()
    (screen,) = Screen.made
    assert [scene for scene, _ in screen.shown] == [vector.showing(i).scene() for i in range(2)]
    assert screen.closed == 0
    vector.close()
    assert screen.closed == 1
