"""A game as a parallel environment of PettingZoo, so that its tools and other libraries can play it."""

from functools import cache
from typing import TYPE_CHECKING, Any

import gymnasium
from gymnasium import spaces
from gymnasium.error import ResetNeeded
from gymnasium.utils import seeding

from edugym.adapters.actions import checked_action
from edugym.checks.games import CheckedGame
from edugym.checks.mdps import CHECKED_STEPS, refuse_start
from edugym.checks.parameters import in_short, one_of
from edugym.checks.tracebacks import end_at_students_line
from edugym.checks.values import ANSWERS
from edugym.mdp.markov_game import require_game, scene_of
from edugym.system.extras import require
from edugym.system.packages import is_own

if TYPE_CHECKING:
    from edugym.rendering.scene import Scene

PLAYERS = ("player_0", "player_1")
"""The names of the players, which PettingZoo calls agents."""


class GameEnv:
    """A game of two players behind PettingZoo's interface; `parallel_env` makes one.

    Both players act at every step, and an episode ends for both at once. In the first steps of a student's game it
    checks what the methods return.

    Attributes:
        game: the game.
        game_state: the full state of the game, also what players do not see; None before the first `reset`.
        steps: how many steps this episode has taken.
        possible_agents: the names of the players, "player_0" and "player_1".
        agents: the names of those who play: both in an episode, else nobody.
        render_mode: `"rgb_array"` (pixels), `"ansi"` (characters) or None.
    """

    def __init__(self, game: Any, render_mode: str | None = None) -> None:
        """See `parallel_env`."""
        self.game, self.render_mode = game, render_mode
        self.metadata = {"render_modes": ["rgb_array", "ansi"], "render_fps": 4, "name": type(game).__name__}
        self.possible_agents = [*PLAYERS]
        self.agents: list[str] = []
        self.observation_spaces: dict[str, spaces.Space[Any]] = {
            name: game.observation_space(player) for player, name in enumerate(PLAYERS)
        }
        self.action_spaces: dict[str, spaces.Space[Any]] = {
            name: game.action_space(player) for player, name in enumerate(PLAYERS)
        }
        self.game_state: Any = None
        self.steps = 0
        self._limit: int | None = getattr(game, "max_steps", None)
        self._rng, _ = seeding.np_random()
        self._steps_to_check = 0 if is_own(game) else CHECKED_STEPS

    def observation_space(self, agent: str) -> spaces.Space[Any]:
        """What a player may see."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> spaces.Space[Any]:
        """What a player may do."""
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
        """Start an episode.

        Args:
            seed: with a seed, everything after it can be repeated; without one the random stream goes on.
            options: not used.

        Returns:
            What each player sees, and an empty dictionary for each.
        """
        if seed is not None:
            self._rng, _ = seeding.np_random(seed)
        game = CheckedGame(self.game) if self._steps_to_check else self.game
        try:
            self.game_state = game.initial(self._rng)
            seen = self._seen(game)
            if game.terminal(self.game_state):
                refuse_start(game, self.game_state)
        except Exception as error:
            end_at_students_line(error)
            raise
        self.steps, self.agents = 0, [*PLAYERS]
        return seen, {name: {} for name in PLAYERS}

    def step(
        self, actions: dict[str, Any]
    ) -> tuple[dict[str, Any], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """Let both players act at the same moment.

        Args:
            actions: the action of each player, by name.

        Returns:
            By player: the observations, the rewards, whether the game is over (`terminated`), whether the step limit
            has cut the episode off (`truncated`; never both), and empty dictionaries.

        Raises:
            ResetNeeded: there is no episode under way.
            ValueError: `actions` is no dictionary of one action for each player, or one is not in the action space.
        """
        if not self.agents:
            why = "before the first reset" if self.game_state is None else "of a finished episode"
            raise ResetNeeded(f"step {why}: call reset() to start an episode")
        pair = self._checked(actions)
        game = CheckedGame(self.game) if self._steps_to_check else self.game
        self._steps_to_check = max(0, self._steps_to_check - 1)
        try:
            next_state = game.transition(self.game_state, pair, self._rng)
            rewards = game.rewards(self.game_state, pair, next_state, self._rng)
            over = game.terminal(next_state)
            terminated = bool(over if isinstance(over, ANSWERS) else CheckedGame(self.game).terminal(next_state))
            self.game_state = next_state
            seen = self._seen(game)
        except Exception as error:
            end_at_students_line(error)
            raise
        self.steps += 1
        truncated = self.steps == self._limit and not terminated
        if terminated or truncated:
            self.agents = []
        paid = {name: float(reward) for name, reward in zip(PLAYERS, rewards, strict=True)}
        infos: dict[str, dict[str, Any]] = {name: {} for name in PLAYERS}
        return seen, paid, dict.fromkeys(PLAYERS, terminated), dict.fromkeys(PLAYERS, truncated), infos

    def _seen(self, game: Any) -> dict[str, Any]:
        """What each player sees."""
        return {name: game.observation(self.game_state, player, self._rng) for player, name in enumerate(PLAYERS)}

    def _checked(self, actions: Any) -> tuple[int, int]:
        """The actions of players 0 and 1."""
        if not isinstance(actions, dict) or set(actions) != set(PLAYERS):
            raise ValueError(
                f"actions must be a dictionary with one action for each of {', '.join(PLAYERS)}, but is"
                f" {in_short(actions)}"
            )
        first, second = (checked_action(self.action_spaces[name], actions[name], f" of {name},") for name in PLAYERS)
        return first, second

    def scene(self) -> "Scene":
        """The picture of the present state; a game without one is shown as text.

        Raises:
            ResetNeeded: there is no state to draw yet.
        """
        if self.game_state is None:
            raise ResetNeeded("render before the first reset: call reset() to start an episode")
        return scene_of(self.game, self.game_state)

    def render(self) -> Any:
        """Draw the present state as `render_mode` says: an array of pixels (height, width, 3), or a string.

        Raises:
            ResetNeeded: there is no state to draw yet.
        """
        scene = self.scene()
        if self.render_mode == "rgb_array":
            from edugym.rendering.pixels import to_pixels

            return to_pixels(scene)
        if self.render_mode == "ansi":
            from edugym.rendering.ansi import to_text

            return to_text(scene)
        gymnasium.logger.warn("render() without a render_mode shows nothing: parallel_env(game, 'rgb_array')")
        return None

    def __reduce__(self) -> Any:
        """Its class is made when PettingZoo is there, so pickle must be told how."""
        return _restored, (vars(self),)


def parallel_env(game: Any, render_mode: str | None = None) -> Any:
    """Make a game a parallel environment of PettingZoo (the extra `games`).

        env = parallel_env(Soccer.create())
        observations, infos = env.reset(seed=0)
        while env.agents:
            actions = {name: env.action_space(name).sample() for name in env.agents}
            observations, rewards, terminations, truncations, infos = env.step(actions)

    Args:
        game: the game.
        render_mode: `"rgb_array"` (pixels), `"ansi"` (characters) or None.

    Returns:
        A `pettingzoo.ParallelEnv`, which is a `GameEnv`: see there.

    Raises:
        ValueError: `game` is no game, or there is no such render mode.
        gymnasium.error.DependencyNotInstalled: PettingZoo is missing.

    References: Terry et al. (2021), PettingZoo: Gym for multi-agent reinforcement learning.
    """
    require("games", "pettingzoo")
    require_game(game)
    one_of("render_mode", render_mode, [None, "rgb_array", "ansi"])
    return _class()(game, render_mode)


@cache
def _class() -> Any:
    """The class of what `parallel_env` makes."""
    from pettingzoo import ParallelEnv

    return type("GameEnv", (GameEnv, ParallelEnv), {"__module__": __name__, "__doc__": GameEnv.__doc__})


def _restored(attributes: dict[str, Any]) -> Any:
    """An environment that was pickled or copied."""
    env = object.__new__(_class())
    vars(env).update(attributes)
    return env
