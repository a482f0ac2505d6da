"""Keys for the actions of an environment, and what it shows without a picture of its own."""

import numpy as np
import pytest

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.keys import keys_of
from edugym.rendering.scene import Text
from tests.adapters.playing.tasks import Walk
from tests.training.tasks import Stairs


@pytest.mark.parametrize(
    ("names", "keys"),
    [
        (["left", "right"], "01"),
        (["a", "b"], "ab"),
        (["1", "0"], "10"),
        (["a", "up"], "01"),
        (["x", "q"], "01"),  # which ends the game
        (["x", "r"], "01"),  # which starts it again
        ([f"action {k}" for k in range(34)], "0123456789abcdefghijklmnopstuvwxyz"),
        ([], ""),
    ],
)
def test_keys(names: list[str], keys: str) -> None:
    """The names themselves if all are keys; else digits, then letters, but for those of the game."""
    assert keys_of(names) == dict(zip(keys, names, strict=True))


def test_more_actions_than_keys() -> None:
    """There are ten digits and 24 letters."""
    with pytest.raises(ValueError, match="actions must be at most 34 to be played by keys, but are 35"):
        keys_of([f"action {k}" for k in range(35)])


def test_gymnasiums_keys() -> None:
    """Each with the action that has its name."""
    assert MDPEnv(Walk()).get_keys_to_action() == {"0": 0, "1": 1}


def test_a_task_without_a_picture_is_shown_as_text() -> None:
    """The state, or the one in which an episode begins."""
    env = MDPEnv(Stairs())
    scene = env.scene()
    assert (scene.width, scene.height) == (12.0, 2.0)
    assert [*scene.shapes] == [Text(6.0, 1.2, "state 0", 0.6)]
    env.reset(seed=0)
    env.step(1)
    assert [*env.scene().shapes] == [Text(6.0, 1.2, "state 1", 0.6)]


def test_drawing_nothing() -> None:
    """Who forgets the mode is told."""
    env = MDPEnv(Walk())
    env.reset(seed=0)
    with pytest.warns(UserWarning, match=r"render\(\) without a render_mode shows nothing: pass render_mode when you"):
        assert env.render() is None


def test_what_led_to_a_state() -> None:
    """The last state and action, all actions and their number; nothing at the start of an episode."""
    env = MDPEnv(Walk())
    env.reset(seed=0)
    for _ in range(2):
        assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (2, None, None, [], 0)
        env.step(np.int64(0))
        assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (1, 2, 0, [0], 1)
        env.step(1)
        assert (env.state, env.last_state, env.last_action, env.actions, env.steps) == (2, 1, 1, [0, 1], 2)
        env.reset()
