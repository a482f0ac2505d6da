"""Episodes of agents, films and captions."""

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.playing import Frame, play_episode, record
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.rendering.captions import captioned
from edugym.rendering.gif import to_gif
from edugym.rendering.palette import BLUE, GREEN, INK, PAPER, RED, YELLOW, rgb
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Circle, Line, Polygon, Scene, Shape
from tests.adapters.playing.tasks import Walk
from tests.messages import named


def test_gifs_of_pictures(tmp_path: Path) -> None:
    """One frame for each picture that differs, as fast as asked, in its colours, at the size of the largest."""
    path = tmp_path / "colours.gif"
    black = np.zeros((20, 500, 3), np.uint8)
    pictures: list[Scene | NDArray[np.uint8]]
    pictures = [Scene(10, 10, (), background=RED), Scene(10, 10, (), background=BLUE), black, black]
    to_gif(pictures, path, frames_per_second=10)
    with Image.open(path) as image:
        assert (getattr(image, "n_frames", 1), image.size) == (3, (500, 480))
        assert image.info["loop"] == 0  # without end
        seen, durations = [], []
        for k in range(3):
            image.seek(k)
            seen.append(image.convert("RGB").getpixel((5, 5)))
            durations.append(image.info["duration"])
    assert seen == [rgb(RED), rgb(BLUE), (0, 0, 0)]
    assert durations == [100, 100, 2100]  # the same picture twice is shown for longer, as is the last
    record(play_episode("CliffWalking-v1", [0, 1]), path)  # Gymnasium's own pixels become frames
    with Image.open(path) as image:
        assert getattr(image, "n_frames", 1) == 3
    with pytest.raises(ValueError, match="picture must be a scene"):
        record([Frame("characters", "start")], path)
    with pytest.raises(ValueError, match="pictures must be one or more"):
        to_gif([], path)
    with pytest.raises(ValueError, match="frames_per_second must be above 0 and at most 50, got 51"):
        to_gif(pictures, path, 51)


def test_actions_make_an_episode() -> None:
    """By name or number, until they or the episode end; or a function of the observation, at most so many steps."""

    def steps(actor: Any, **options: Any) -> int:
        return len(play_episode(Walk(max_steps=9), actor, **options)) - 1

    assert steps(["left"]) == 1
    assert steps([0, "left", 1, 1]) == 2
    assert steps(lambda observation: int(observation < 3)) == 9
    assert steps(lambda observation: int(observation < 3), max_steps=5) == 5
    with pytest.raises(ValueError, match=named("max_steps", 1, 100_000, 0)):
        steps([0], max_steps=0)


def test_agents_make_an_episode() -> None:
    """An agent does what it believes best, on the rows of its table, repeatably; without `greedy` it acts."""
    agent = QLearning.create(MDPEnv(Walk()), exploration=EpsilonGreedy(1.0))
    agent.Q[:, 1] = 1.0
    for seed in range(5):
        lines = [frame.line.split(",")[0] for frame in play_episode(Walk(), agent, seed=seed)]
        assert lines == ["start", "step 1: right", "step 2: right"]
    acting = SimpleNamespace(act=lambda state, rng: divmod(state, 1)[1] + 1)
    assert play_episode("Golf", acting)[1].line.startswith("step 1: chip")
    agent.Q[:] = 0.0  # it is undecided
    one, other = ([[frame.line for frame in play_episode(Walk(), agent, seed=k)] for k in range(8)] for _ in "ab")
    assert one == other
    assert len(set(map(tuple, one))) > 1


def test_captions_stand_below_the_picture() -> None:
    """The picture is in the middle of paper, what its edge cut off stays hidden, and long lines fit."""
    shapes: list[Shape] = [
        Circle(0, 5, 2, fill=BLUE, outline=None),
        Polygon(((3, 1), (5, 1), (5, 3)), fill=GREEN, outline=None),
        Line(((0, 9), (5, 9)), colour=YELLOW, line_width=0.5),
    ]
    scene = Scene(5, 10, shapes, background=RED, title="before", columns=7)
    below = captioned(scene, ["short", "", "a very long line " * 6])
    assert (below.title, below.columns) == ("before", 7)
    assert captioned(scene, ["", "", "x"]).size_in_pixels() == below.size_in_pixels()

    pixels = to_pixels(below)
    unit, margin = pixels.shape[1] / below.width, (below.width - scene.width) / 2

    def colour(x: float, y: float) -> tuple[int, ...]:
        return tuple(map(int, pixels[int(y * unit), int((margin + x) * unit)]))

    inside = [colour(1, 5), colour(4.8, 1.5), colour(2, 9), colour(2.5, 0.5)]
    assert inside == [rgb(BLUE), rgb(GREEN), rgb(YELLOW), rgb(RED)]
    assert [colour(-1, 5), colour(5.5, 5), colour(0.1, 10.1)] == [rgb(PAPER)] * 3
    ink = (pixels == rgb(INK)).all(axis=2)
    assert ink[int(10 * unit) :].any()
    assert not ink[:, [0, 1, -2, -1]].any()
    assert not ink[: int(10 * unit)].any()
