"""Games: their actions, their score, their pictures and their luck."""

import io
import os
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.error import ResetNeeded

from edugym.adapters.keys import named_actions
from edugym.adapters.playing import Game, play, play_episode
from edugym.adapters.playing.game import TERMINATED, TRUNCATED, playable
from edugym_course import notebook
from tests.adapters.playing.tasks import Still, Walk
from tests.course.notebook.widgets import texts


def test_the_score_of_a_game() -> None:
    """The line says what happened in each step and how an episode ended; only episodes that did so count."""
    game = Game(Walk())
    assert game.actions == {"left": 0, "right": 1}
    assert (game.name, game.line()) == ("Walk", "start, observation 2, total 0")
    assert game.history() == "No episode finished yet."
    game.step("right")
    game.step(1)
    assert game.line() == f"step 2: right, observation 4, reward 1.5, total 1.5\n{TERMINATED}"
    assert game.over
    with pytest.raises(ResetNeeded):
        game.step("left")
    game.reset()
    game.step("left")
    game.reset()  # an episode that was given up
    for action in ("left", "right", "left", "right"):
        assert not game.over
        game.step(action)
    assert game.line() == f"step 4: right, observation 2, reward 0, total 0\n{TRUNCATED}"
    assert game.history() == "Episodes finished: 2. Totals: 1.5, 0. Mean: 0.75."
    with pytest.raises(ValueError, match=r"action .*'left', 'right'.*'up'"):
        game.step("up")
    game.returns = [0.0, 1.0, *[0.5] * 10]  # the last ten are shown, the mean is over all
    assert game.history() == f"Episodes finished: 12. Totals: ..., {', '.join(['0.5'] * 10)}. Mean: 0.5."
    del game.returns[:2]
    assert "..." not in game.history()


def test_a_game_keeps_its_last_finished_episode() -> None:
    """The replay is the episode under way until one is finished, and then that one, whatever is begun after it."""
    game = Game(Walk())
    game.step("left")
    assert [frame.line[:6] for frame in game.replay()] == ["start,", "step 1"]
    game.step("left")
    finished = game.replay()
    game.reset()
    game.step("right")
    assert game.replay() is finished
    assert len(finished) == 3


def test_environments_of_gymnasium_can_be_played() -> None:
    """They show pixels or characters as asked, their observation where they have neither, and numbers for actions."""
    pixels = Game("CliffWalking-v1")
    assert list(pixels.actions) == ["0", "1", "2", "3"]
    assert isinstance(pixels.frames[0].picture, np.ndarray)
    assert pixels.frames[0].picture.shape[2] == 3
    assert pixels._repr_svg_() is None
    text = Game("CliffWalking-v1", picture="ansi")
    assert isinstance(text.frames[0].picture, str)
    assert "C  C  C" in text.frames[0].picture
    cards = Game("Blackjack-v1", picture="ansi")
    assert cards.frames[0].picture == f"observation {cards.observation}"
    with pytest.raises(ValueError, match="picture must be a scene"):
        text.frames[0].with_caption()


@pytest.mark.parametrize(
    ("system", "screen", "driver"),
    [("linux", None, "dummy"), ("linux", "DISPLAY", None), ("linux", "WAYLAND_DISPLAY", None), ("darwin", None, None)],
)
def test_pixels_without_a_screen(
    system: str, screen: str | None, driver: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where Linux has none, pygame is told to do without, and only there."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.setenv(name, "")  # so that it is put back after the test
        monkeypatch.delenv(name)
    if screen:
        monkeypatch.setenv(screen, ":0")
    monkeypatch.setattr("edugym.adapters.playing.game.sys", SimpleNamespace(platform=system))
    playable("CliffWalking-v1", "ansi", {})
    assert os.environ.get("SDL_VIDEODRIVER") == driver


@pytest.mark.parametrize(
    ("environment", "parameters", "names"),
    [
        ("Bolder", {}, "environment .*Boulder, .*Bolder"),
        ("Boulder", {"heigth": 3}, "Boulder .*'heigth'; it has height, n_grips, "),
        ("Boulder", {"height": 0}, "height .* 0$"),
        (Walk(), {"n_grips": 2, "height": 3}, r"environment.*\['height', 'n_grips'\]"),
        ("Boulder", {"picture": "human"}, "picture .*'human'"),
        (Still(spaces.Box(-np.inf, 1, (2,))), {}, "named_actions"),
        (Still(spaces.MultiDiscrete(np.array([[2, 3]]))), {}, "named_actions"),
        (Still(spaces.Text(3)), {}, "named_actions"),
    ],
)
def test_what_cannot_be_played_is_named(environment: Any, parameters: dict[str, Any], names: str) -> None:
    """An environment that does not exist, parameters that it does not have, and actions that nobody can name."""
    with pytest.raises(ValueError, match=names):
        Game(environment, **parameters)


PUSHED = {"middle": [1, 2], "0 low": [0, 2], "0 high": [2, 2], "1 low": [1, 0], "1 high": [1, 4]}


@pytest.mark.parametrize(
    ("space", "actions"),
    [
        (spaces.Discrete(2, start=5), {"5": [5], "6": [6]}),
        (spaces.MultiDiscrete([3, 5]), PUSHED),
        (spaces.Box(-1, 3, (1,)), {"middle": [1], "0 low": [-1], "0 high": [3]}),
    ],
)
def test_actions_without_names(space: spaces.Space[Any], actions: dict[str, Any]) -> None:
    """Whole numbers are their own names; of several numbers, each can be pushed to its ends."""
    named = named_actions(Still(space))
    assert {name: np.ravel(action).tolist() for name, action in named.items()} == actions
    assert all(space.contains(action) for action in named.values())


@pytest.mark.parametrize(
    ("observation", "line"),
    [
        (True, "start, observation 1, total 0"), (np.float32(0.25), "start, observation 0.25, total 0"),
        (np.arange(4), "start, observation 0 1 2 3, total 0"),
        (np.arange(8), "start, total 0\nobservation 0 1 2 3 4 5 6 7"), (np.arange(9), "start, total 0"),
        ((3, np.array([1.5, 2.0])), "start, observation 3 1.5 2, total 0"),
        (np.arange(5), "start, total 0\nobservation 0 1 2 3 4"),
        (np.array([-1 / 300, 12345, np.inf, np.nan]), "start, observation -0.00333 12345 inf nan, total 0"),
        ({"a": 1}, "start, total 0"), ("hello", "start, total 0"),
    ],
)  # fmt: skip
def test_only_short_observations_are_written_out(observation: Any, line: str) -> None:
    """Up to eight numbers, from spaces of several kinds; of those with many digits, three."""
    assert Game(Still(spaces.Discrete(2), observation)).line() == line


def test_actions_without_a_name() -> None:
    """Are written out as the observations are; very many have none."""
    game = Game("Trashbot")
    game.step(np.array([-1, 1 / 3], np.float32))
    score, observation = game.line().splitlines()
    assert score == "step 1: action -1 0.333, reward 0, total 0"
    assert observation.startswith("observation -0.28")
    assert [len(Game(Still(spaces.Discrete(n))).actions) for n in (10_000, 10_001, 10**9)] == [10_000, 0, 0]


STARTS: dict[str, Callable[..., str]] = {
    "game": lambda **options: Game("MemoryCorridor", **options).line(),
    "episode": lambda **options: play_episode("MemoryCorridor", [], **options)[0].line,
    "film": lambda **options: notebook.frames("MemoryCorridor", [], **options).frames[0].line,
    "buttons": lambda **options: texts(notebook.play("MemoryCorridor", **options).widget)[1],
    "screen": lambda **o: play("MemoryCorridor", keyboard=io.StringIO(), screen=io.StringIO(), **o).line(),
}


@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS)
def test_a_seed_repeats_the_start(start: Callable[..., str]) -> None:
    """The same of thirty doors is right with the same seed, and another with another."""
    first, again = ([start(seed=seed, num_doors=30) for seed in range(4)] for _ in "ab")
    assert all("observation" in told for told in first)
    assert len({Game("MemoryCorridor", seed=None, num_doors=30).line() for _ in range(9)}) > 1
    assert first == again
    assert len(set(first)) > 1
