"""Play an environment with buttons."""

from functools import partial
from typing import Any

import ipywidgets

from edugym.adapters.playing.game import Game
from edugym.checks.parameters import true_or_false
from edugym.rendering.scene import Scene
from edugym_course.notebook.widget import NotebookWidget, picture_html, picture_widget, text_html

HIDDEN = (
    '<div style="max-width: 240px; padding: 60px 20px; border: 1px solid; text-align: center">'
    "The picture is hidden until the episode is over: an agent sees only the observation.</div>"
)


class Buttons(NotebookWidget):
    """A game with a button for each action.

    Attributes:
        game: the game, which can also be played by code: `game.step("putt")`, then `show()`.
        actions: the button of each action, by its name.
        new_episode: the button that starts an episode.
        blind: whether the picture is hidden until the episode is over, so that you see only what an agent sees.
    """

    def __init__(self, game: Game, blind: bool = False) -> None:
        """Make the widgets."""
        self.game = game
        self.blind = blind
        as_wide_as_its_text = ipywidgets.Layout(width="auto", min_width="148px")
        self.actions = {
            name: ipywidgets.Button(description=name, tooltip=name, layout=as_wide_as_its_text) for name in game.actions
        }
        self.new_episode = ipywidgets.Button(description="New episode")
        for name, button in self.actions.items():
            button.on_click(self.calling(partial(self.step, name)))
        self.new_episode.on_click(self.calling(self.reset))
        self._picture, self._line, self._history = picture_widget(), ipywidgets.HTML(), ipywidgets.HTML()
        in_rows = ipywidgets.Layout(flex_flow="row wrap", width="auto")
        controls = ipywidgets.VBox(
            [
                ipywidgets.HBox([*self.actions.values()], layout=in_rows),
                self.new_episode,
                self._line,
                self._history,
            ],
            layout=ipywidgets.Layout(width="360px", max_width="100%"),
        )
        self.show()
        super().__init__(ipywidgets.HBox([self._picture, controls], layout=in_rows))

    def step(self, action: Any) -> None:
        """Take a step, given the action or its name, and show the result."""
        self.game.step(action)
        self.show()

    def reset(self) -> None:
        """Start an episode and show it."""
        self.game.reset()
        self.show()

    def show(self) -> None:
        """Show the present state of the game."""
        self._picture.value = HIDDEN if self.is_hidden else picture_html(self.game.picture())
        self._line.value = text_html(self.game.line())
        self._history.value = text_html(self.game.history())
        for button in self.actions.values():
            button.disabled = self.game.over
        self.new_episode.button_style = "primary" if self.game.over else ""

    @property
    def is_hidden(self) -> bool:
        """Whether the picture is hidden now."""
        return self.blind and not self.game.over

    def still(self) -> dict[str, str]:
        """The present picture and score."""
        if self.is_hidden:
            return {"text/html": f"{HIDDEN}<br>{text_html(self.game.line())}"}
        frame = self.game.frame()
        if isinstance(frame.picture, Scene):
            return {"image/svg+xml": frame.with_caption()._repr_svg_()}
        return {"text/html": f"{picture_html(frame.picture)}<br>{text_html(frame.line)}"}


def play(environment: Any, *, blind: bool = False, seed: int | None = 0, **parameters: Any) -> Buttons:
    """Play an environment with buttons: `play("Boulder", height=5)`.

    Args:
        environment: the name of an environment, the id of any in Gymnasium, an environment, an MDP, or a `Game`.
        blind: whether to hide the picture until the episode is over. You then see what an agent sees: the observation,
            the reward and the end.
        seed: the seed of the first episode, from which later ones continue; None gives other games each time.
        parameters: the parameters of the environment, if its name or id is given.

    Returns:
        The game with its buttons. As the last value of a cell it shows itself.

    Raises:
        ValueError: `blind` is not True or False; and as `edugym.adapters.playing.Game`.
    """
    true_or_false("blind", blind)
    game = environment if isinstance(environment, Game) else Game(environment, seed=seed, **parameters)
    return Buttons(game, blind)
