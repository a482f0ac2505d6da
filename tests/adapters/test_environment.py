"""One environment: its window, picture, history, keys, model and specification, and what students' tasks get of it."""

from collections import Counter
from types import SimpleNamespace
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env

from edugym import MDPEnv, MDPVectorEnv, make_mdp
from edugym.rendering import window
from edugym.rendering.scene import Scene, Text
from tests.adapters.tasks import TRAIL
from tests.compiled.cells import SLIPPERY, WALK, cell
from tests.messages import named

DIGITS_AND_LETTERS = "0123456789abcdefghijklmnopstuvwxyz"


def walk(source: str = WALK, size: int = 5) -> Any:
    """A student's corridor."""
    return cell(source)["Walk"](size)


@pytest.fixture
def screens(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The windows that are opened, each of which notes what it is told."""
    made: list[Any] = []

    def noting(title: str) -> Any:
        screen: Any = SimpleNamespace(title=title, shown=[], closed=0)
        screen.show = lambda scene, fps: screen.shown.append((scene, fps))
        screen.close = lambda: setattr(screen, "closed", screen.closed + 1)
        made.append(screen)
        return screen

    monkeypatch.setattr(window, "Window", noting)
    return made


@pytest.mark.parametrize("registered", [True, False])
def test_what_the_window_shows(screens: list[Any], registered: bool) -> None:
    """Every state, four a second, under the environment's id or the name of its class; it is closed once."""
    env: Any = gymnasium.make("edugym/Boulder-v0", render_mode="human").unwrapped
    env = env if registered else MDPEnv(env.mdp, render_mode="human")
    env.reset(seed=0)
    scenes = [env.scene()]
    for action in (0, 1):
        env.step(action)
        scenes.append(env.scene())
    (screen,) = screens
    assert screen.title == ("edugym/Boulder-v0" if registered else "Boulder")
    assert screen.shown == [(scene, 4) for scene in scenes]
    for _ in range(2):
        env.close()
    assert screen.closed == 1
    env.render()
    assert len(screens) == 2


def test_the_window_of_several_copies(screens: list[Any]) -> None:
    """They share one, which is closed with them."""
    vector = MDPVectorEnv(MDPEnv(make_mdp("Boulder"), render_mode="human"), 2)
    vector.reset(seed=0)
    vector.render()
    (screen,) = screens
    assert [scene for scene, _ in screen.shown] == [vector.showing(i).scene() for i in range(2)]
    assert screen.closed == 0
    vector.close()
    assert screen.closed == 1


def test_a_picture_for_a_task_that_has_none() -> None:
    """The state as text, in the middle of the picture; before the first reset an initial one."""
    env = MDPEnv(walk())
    assert env.scene() == Scene(12.0, 2.0, (Text(6.0, 1.2, "state 0", 0.6),))
    env.reset(seed=0)
    env.step(1)
    assert env.scene() == Scene(12.0, 2.0, (Text(6.0, 1.2, "state 1", 0.6),))
    with pytest.warns(UserWarning, match="without a render_mode"):
        assert env.render() is None
    with pytest.raises(ValueError, match=named("render_mode", None, "'human'", "'svg'")):
        MDPEnv(env.mdp, render_mode="svg")
    wrong = MDPEnv(walk(f"{WALK}\n    def scene(self, state): return None\n"), render_mode="ansi")
    wrong.reset(seed=0)
    with pytest.raises(ValueError, match="scene of Walk must return a Scene, but returned "):
        wrong.render()


def test_the_history_of_an_episode() -> None:
    """The last state and action, and all actions, from the start of this episode; the random stream goes on."""
    env = MDPEnv(walk())
    assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (None, None, None, [], 0)
    for _ in range(2):
        env.reset()
        assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (0, None, None, [], 0)
        env.step(1)
        env.step(np.int64(0))
        assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (0, 1, 0, [1, 0], 2)


@pytest.mark.parametrize(
    ("names", "keys"),
    [
        ([], "01"),  # the actions by their numbers
        (["left", "right"], "01"),
        (["a", "b"], "ab"),
        (["1", "0"], "10"),
        (["a", "up"], "01"),
        (["x", "q"], "01"),  # which ends the game
        (["x", "r"], "01"),  # which starts it again
        ([f"action {k}" for k in range(34)], DIGITS_AND_LETTERS),
    ],
)
def test_keys(names: list[str], keys: str) -> None:
    """The names themselves if all are keys; else digits, then letters, but for those of the game."""
    source = WALK.replace("spaces.Discrete(2)", f"spaces.Discrete({len(keys)})")
    env = MDPEnv(walk(f"{source}\n    action_names = {names}\n"))
    assert env.get_keys_to_action() == {key: action for action, key in enumerate(keys)}
    many = MDPEnv(walk(WALK.replace("spaces.Discrete(2)", "spaces.Discrete(35)")))
    with pytest.raises(ValueError, match=r"actions must be at most 34 .* but are 35"):
        many.get_keys_to_action()


def test_outcomes_that_are_drawn() -> None:
    """As often as they are likely; a seed repeats them."""
    env = MDPEnv(cell(SLIPPERY)["SlipperyWalk"](5, 0.25))
    assert {one.next_state: one.probability for one in env.descriptive_model(2, 1)} == {3: 0.75, 1: 0.25}
    drawn = [env.generative_model(2, 1) for _ in range(2_000)]
    assert {outcome.probability for outcome in drawn} == {1.0}
    assert Counter(outcome.next_state for outcome in drawn)[3] == pytest.approx(1_500, abs=80)
    env.reset(seed=3)
    seeded: list[Any] = [env.model(2, 1, "generative") for _ in range(30)]
    assert [i for i, outcome in enumerate(seeded) if outcome.next_state == 1] == [14, 19, 24, 28]


def test_specifications() -> None:
    """None where nobody has registered the task; a limit or threshold that somebody has registered is kept."""
    env = MDPEnv(make_mdp("Boulder"))
    assert env.spec is None
    for given in ({}, {"max_episode_steps": 7}, {"reward_threshold": 0.0}):
        env.spec = EnvSpec("mine/Wall-v0", **given)
        assert env.spec is not None
        own: dict[str, Any] = {"max_episode_steps": 100, "reward_threshold": 1.0, **given}
        assert {name: getattr(env.spec, name) for name in own} == own
        written = EnvSpec.from_json(env.spec.to_json())  # without the task's own limit, which would become a wrapper
        assert written.max_episode_steps == given.get("max_episode_steps")
        assert written.reward_threshold == own["reward_threshold"]
    env.spec = None
    assert env.spec is None


@pytest.mark.parametrize(
    "task",
    [walk(), cell(SLIPPERY)["SlipperyWalk"](5, 0.25), cell(TRAIL)["Trails"](9)],
    ids=lambda task: type(task).__name__,
)
def test_a_students_task_is_an_environment(task: Any) -> None:
    """Without fault, and with a picture in every mode."""
    env = MDPEnv(task)
    check_env(env, skip_render_check=True)
    for mode in ("ansi", "rgb_array"):
        drawn = MDPEnv(task, render_mode=mode)
        drawn.reset(seed=0)
        frame = drawn.render()
        assert f"state {drawn.state!r}"[:8] in frame if isinstance(frame, str) else frame.ndim == 3


def test_observations_are_arrays_of_their_own() -> None:
    """An array that an MDP gives as observation is copied, so that nobody can write into the task."""
    array = np.zeros(2, np.float32)
    source = WALK.replace("return state\n", "return ARRAY\n", 1).replace(
        "spaces.Discrete(self.size + 1)", "spaces.Box(0, 100, (2,), np.float32)"
    )
    env = MDPEnv(cell(source, {**cell(""), "ARRAY": array})["Walk"](5))
    observation, _ = env.reset(seed=0)
    assert isinstance(env.observation_space, spaces.Box)
    observation[:] = 7
    assert array.tolist() == [0, 0]
