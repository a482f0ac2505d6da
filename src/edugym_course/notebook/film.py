"""Look at an episode step by step."""

from collections.abc import Sequence
from itertools import accumulate
from typing import Any

import ipywidgets

from edugym.adapters.playing.films import play_episode
from edugym.adapters.playing.game import Frame
from edugym.checks.parameters import above
from edugym.rendering.scene import Scene
from edugym.rendering.svg import to_svg
from edugym_course.notebook.widget import NotebookWidget, picture_html, picture_widget, text_html

FASTEST = 1000
"""The most frames a second: a player counts milliseconds."""
STRIP = 4
"""The number of frames that stand side by side where no kernel runs."""


class Film(NotebookWidget):
    """An episode with a slider to step through it and a button that plays it.

    Only the present frame is in the page, so the notebook stays small.

    Attributes:
        frames: the episode.
        slider: chooses the frame, from 0.
        player: the button that plays the episode.
    """

    def __init__(self, frames: Sequence[Frame], frames_per_second: float) -> None:
        """Make the widgets."""
        self.frames = list(frames)
        last = len(self.frames) - 1
        self.slider = ipywidgets.IntSlider(description="step", max=last, layout=ipywidgets.Layout(max_width="100%"))
        self.player = ipywidgets.Play(max=last, interval=round(1000 / frames_per_second))
        self._link = ipywidgets.jslink((self.player, "value"), (self.slider, "value"))
        self._picture, self._line = picture_widget(), ipywidgets.HTML()
        self.slider.observe(self.calling(self.show), "value")
        self.show()
        row = ipywidgets.HBox([self.player, self.slider], layout=ipywidgets.Layout(flex_flow="row wrap"))  # for phones
        super().__init__(row, self._picture, self._line)

    def show(self) -> None:
        """Show the frame that the slider has chosen."""
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
    """Let an agent play an episode, or play given actions, and show it step by step.

    Args:
        environment: the name of an environment, the id of any in Gymnasium, an environment, or an MDP.
        actor: an agent, which plays without exploring; a function of the observation; or a sequence of actions or of
            their names.
        seed: the seed of the environment and of the agent.
        max_steps: the most steps to play.
        frames_per_second: the speed of the film, greater than 0 and at most 1000.
        parameters: the parameters of the environment, if its name or id is given.

    Returns:
        The episode. As the last value of a cell it shows itself.

    Raises:
        ValueError: as `edugym.adapters.playing.play_episode`, or `frames_per_second` is not as above.
    """
    above("frames_per_second", frames_per_second, 0, FASTEST)
    episode = play_episode(environment, actor, seed=seed, max_steps=max_steps, **parameters)
    return Film(episode, frames_per_second)
