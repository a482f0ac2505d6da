"""The seed of everything that shows an episode."""

import io
from collections.abc import Callable
from typing import Any

import pytest

from edugym.adapters.playing import Game, play, play_episode
from edugym_course import notebook
from tests.course.notebook.widgets import texts


def on_the_screen(**options: Any) -> str:
    """What is written before the first key."""
    screen = io.StringIO()
    play("MemoryCorridor", keyboard=io.StringIO(), screen=screen, **options)
    return screen.getvalue()


@pytest.mark.parametrize(
    "start",
    [
        lambda **options: Game("MemoryCorridor", **options).line(),
        lambda **options: play_episode("MemoryCorridor", [], **options)[0].line,
        lambda **options: notebook.frames("MemoryCorridor", [], **options).frames[0].line,
        lambda **options: texts(notebook.play("MemoryCorridor", **options).widget)[1],
        on_the_screen,
    ],
    ids=["game", "episode", "film", "buttons", "screen"],
)
def test_a_seed_repeats_the_start(start: Callable[..., str]) -> None:
    """The same of thirty doors is right with the same seed, and another with another."""
    first, again = ([start(seed=seed, num_doors=30) for seed in range(4)] for _ in "ab")
    assert all("observation" in told for told in first)
    assert first == again
    assert len(set(first)) > 1
