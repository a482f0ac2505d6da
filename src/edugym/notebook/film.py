"""Look at an episode step by step."""

from collections.abc import Sequence
from itertools import accumulate
from typing import Any

import ipywidgets

from edugym.checks import above
from edugym.notebook.panel import Panel, picture_html, text_html
from edugym.playing.films import play_episode
from edugym.playing.game import Frame
from edugym.rendering.scene import Scene
from edugym.rendering.svg import to_svg

STRIP = 4
"""How many frames of an episode stand side by side where no kernel runs."""


class Film(Panel):
    """An episode with a slider to step through it and a button that plays it.

    Only the frame that is looked at is in the page, so that the notebook stays small.

    Attributes:
        frames: the episode.
        slider: which frame is shown, from 0.
        player: the button that plays it.
    """

    def __init__(self, frames: Sequence[Frame], frames_per_second: float) -> None:
        """Make the widgets."""
        self.frames = list(frames)
        last = len(self.frames) - 1
        self.slider = ipywidgets.IntSlider(description="step", min=0, max=last)
        self.player = ipywidgets.Play(min=0, max=last, interval=round(1000 / frames_per_second))
        self._link = ipywidgets.jslink((self.player, "value"), (self.slider, "value"))
        self._picture, self._line = ipywidgets.HTML(), ipywidgets.HTML()
        self.slider.observe(self.calling(self.show), "value")
        self.show()
        super().__init__(ipywidgets.HBox([self.player, self.slider]), self._picture, self._line)

    def show(self) -> None:
        """Show the frame at which the slider stands."""
        frame = self.frames[self.slider.value]
        self._picture.value = picture_html(frame.picture)
        self._line.value = text_html(frame.line)

    def still(self) -> dict[str, str]:
        """A few frames side by side, from the first to the last."""
        last = len(self.frames) - 1
        chosen = [self.frames[k] for k in sorted({round(last * k / (STRIP - 1)) for k in range(STRIP)})]
        if isinstance(chosen[0].picture, Scene):
            return {"image/svg+xml": side_by_side([frame.with_caption() for frame in chosen])}
        return {"text/html": "\n".join(picture_html(frame.picture) for frame in chosen)}


def side_by_side(scenes: Sequence[Scene]) -> str:
    """One SVG picture of several scenes, from left to right, as wide as the page allows."""
    lefts = [0, *accumulate(scene.size_in_pixels()[0] for scene in scenes)]
    height = max(scene.size_in_pixels()[1] for scene in scenes)
    pictures = [to_svg(scene).replace("<svg ", f'<svg x="{x}" ', 1) for x, scene in zip(lefts, scenes, strict=False)]
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="100%" viewBox="0 0 {lefts[-1]} {height}">'
    return "\n".join((head, *pictures, "</svg>"))


def frames(
    environment: Any,
    actor: Any,
    *,
    seed: int = 0,
    max_steps: int = 200,
    frames_per_second: float = 4.0,
    **parameters: Any,
) -> Film:
    """Let an agent play an episode, or play given actions, and look at it step by step.

    Args:
        environment: its name, the id of any Gymnasium environment, an environment, or an MDP.
        actor: an agent, which does what it believes best; a function of the observation; or a sequence of actions or of
            their names.
        seed: of the environment and of the agent.
        max_steps: after how many steps to stop at the latest.
        frames_per_second: how fast it plays.
        parameters: of the environment, where its name or id is given.

    Returns:
        The episode, which shows itself as the last value of a cell.

    Raises:
        ValueError: as `edugym.playing.play_episode`, or `frames_per_second` is not above 0.
    """
    above("frames_per_second", frames_per_second, 0)
    episode = play_episode(environment, actor, seed=seed, max_steps=max_steps, **parameters)
    return Film(episode, frames_per_second)
