"""The interface of Markov games, and the gate for what users give as one.

A Markov game is an MDP in which two players act at the same moment. As with an MDP, you do not inherit from the
protocol: every NamedTuple with the right methods is a game.
"""

from typing import Any, Protocol

from gymnasium import Space, spaces

from edugym.checks.interfaces import a_class, class_name, require_method, step_limit
from edugym.checks.parameters import in_short, one_of
from edugym.mdp.protocol import Observation_co, Random, State
from edugym.rendering.scene import Scene, in_words

METHODS = {
    "initial": ("rng",),
    "transition": ("state", "actions", "rng"),
    "rewards": ("state", "actions", "next_state", "rng"),
    "terminal": ("state",),
    "observation": ("state", "player", "rng"),
    "observation_space": ("player",),
    "action_space": ("player",),
}
"""What every game has, and what each method takes."""


class MarkovGame(Protocol[State, Observation_co]):
    """A Markov game of two players, 0 and 1, and what each observes in each state.

    Both choose an action at the same moment, and neither sees what the other chooses. `actions` is the pair of both,
    and `rewards` gives a pair. Methods draw every random number from `rng`, and must not change `state`. The discount
    belongs to the players. The game is zero-sum if the two rewards always add up to 0.

    A game may also have

    * `max_steps`: the number of steps after which an episode is truncated;
    * `action_names`: the names of the actions 0, 1, ..., of both players;
    * `scene(state)`: its picture (see `edugym.rendering`);
    * `create(**parameters)`, a class method: check the parameters and return the game.

    References: Shapley (1953), Stochastic games; Littman (1994), Markov games as a framework for multi-agent
    reinforcement learning.
    """

    def observation_space(self, player: int) -> Space[Any]:
        """The Gymnasium space of what a player sees: `Discrete(n)`, for players with tables."""

    def action_space(self, player: int) -> Space[Any]:
        """The Gymnasium space of a player's actions: `Discrete(n)`, the numbers 0, 1, ..., n - 1."""

    def initial(self, rng: Random) -> State:
        """Draw the state in which an episode starts."""

    def transition(self, state: State, actions: tuple[int, int], rng: Random) -> State:
        """Draw the next state from the dynamics p(s'|s, a₀, a₁)."""

    def rewards(self, state: State, actions: tuple[int, int], next_state: State, rng: Random) -> tuple[float, float]:
        """Draw the rewards of a transition, one for each player."""

    def terminal(self, state: State) -> bool:
        """Whether `state` is terminal."""

    def observation(self, state: State, player: int, rng: Random) -> Observation_co:
        """Draw what a player sees in this state."""


def require_game(game: Any) -> None:
    """Refuse what is no game of two players whose observations and actions are numbered from 0.

    Raises:
        ValueError: a method is missing or takes something else, or a space is not `Discrete(n)`.
    """
    if isinstance(game, type):
        raise ValueError(f"game must be a value, but is {a_class(game)}")
    if not hasattr(game, "rewards"):
        hint = ": rewards gives one to each player, reward of an MDP only one" if hasattr(game, "transition") else ""
        raise ValueError(
            f"game must be a Markov game, a value with the methods {', '.join(METHODS)}, but is {in_short(game)}{hint}"
        )
    for method, parameters in METHODS.items():
        require_method(game, method, parameters, METHODS)
    for name in ("observation_space", "action_space"):
        for player in (0, 1):
            space = getattr(game, name)(player)
            if not isinstance(space, spaces.Discrete) or space.start != 0:
                raise ValueError(
                    f"{name}({player}) of {class_name(game)} must be spaces.Discrete(n), since players have tables,"
                    f" but is {in_short(space)}"
                )
    step_limit(game)


def scene_of(game: Any, state: Any) -> Scene:
    """The picture of a state; of a game without pictures, the state in words.

    Raises:
        ValueError: the game's own picture is no `Scene`.
    """
    draw = getattr(game, "scene", None)
    scene = in_words(state) if draw is None else draw(state)
    if not isinstance(scene, Scene):
        raise ValueError(f"scene of {class_name(game)} must return a Scene, but returned {in_short(scene)}")
    return scene


def a_player(player: Any) -> int:
    """Refuse what is neither player 0 nor player 1.

    Raises:
        ValueError: it is something else.
    """
    return int(one_of("player", player, (0, 1)))


def n_actions(game: Any, player: int) -> int:
    """The number of a player's actions."""
    return int(game.action_space(player).n)


def table_shape(game: Any, player: int) -> tuple[int, int]:
    """The shape (n_observations, n_actions) of a player's tables.

        QLearning.create(table_shape(game, 0))

    Raises:
        ValueError: `game` is no game, or `player` is neither 0 nor 1.
    """
    require_game(game)
    return sizes(game, a_player(player))


def sizes(game: Any, player: int) -> tuple[int, int]:
    """`table_shape` of what is known to be a game: its methods are not looked at again."""
    return int(game.observation_space(player).n), n_actions(game, player)
