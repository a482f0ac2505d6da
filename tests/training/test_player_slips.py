"""Slips in programs of players: each is answered in one sentence."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple, cast

import numpy as np
import pytest

import edugym
from edugym import games
from edugym.mdp.protocol import Random
from tests.messages import named
from tests.training.test_players import PENNIES, SOCCER, Plain, Rooms, q_learning, two


class NoReturn(Plain):
    """Forgets to return."""

    def act(self, state: int, rng: Random) -> int:  # type: ignore[return]
        """An action."""
        rng.random()


class Late(NamedTuple):
    """Does something else once in a thousand steps."""

    what: Any

    def act(self, state: int, rng: Random) -> Any:
        """An action."""
        return self.what if rng.random() < 1e-3 else 0

    def learn(self, reward: float) -> None:
        """Learn."""


class Misspelt(Plain):
    """Misspells a parameter."""

    def learn(self, state: int, other_actoin: int, reward: float) -> None:  # type: ignore[override]
        """Learn."""


class Forgets(Plain):
    """Writes what is no number."""

    def learn(self, state: int, action: int, reward: float) -> None:  # type: ignore[override]
        """Learn."""
        self.Q[state, action] = math.nan


class Shrinks:
    """Takes a smaller table in the middle of a run."""

    def __init__(self) -> None:
        """With one that fits."""
        self.Q = np.zeros((4, 2))

    def act(self, state: int, rng: Random) -> int:
        """An action."""
        return 0

    def learn(self, reward: float) -> None:
        """Learn."""
        self.Q = np.zeros((4, 1))


class Paid(Rooms):
    """It has one reward for both."""

    def rewards(self, state: Any, actions: tuple[int, int], next_state: Any, rng: Random) -> Any:
        """A number."""
        return 1.0

    def transition(self, state: tuple[int, int], actions: tuple[int, int], rng: Random) -> tuple[int, int]:
        """Always to the end."""
        return 3, 0


def met() -> Any:
    """A run of ten steps."""
    return games.train_players(PENNIES, two(q_learning, PENNIES), 10)


def meet(first: Any, game: Any = None, n_steps: int = 20_000) -> Any:
    """Train somebody against a Q-learner."""
    game = Rooms() if game is None else game
    return games.train_players(game, (first, q_learning(game, 1)), n_steps)


@pytest.mark.filterwarnings("ignore:.* cannot be compiled")
@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: games.train_players(Rooms(), q_learning(Rooms(), 0), 9), ("agents", "pair", "QLearning")),
        (lambda: games.train_players(Rooms(), [q_learning(Rooms(), 0)], 9), ("agents", "pair", "QLearning")),
        (lambda: games.train_players("Boulder", two(q_learning, Rooms()), 9), ("game", "rewards", "'Boulder'")),
        (lambda: meet(edugym.QLearning), ("agent", "QLearning", "create")),
        (lambda: meet(edugym.SARSA.create((4, 2))), ("learn", "SARSA", "'next_action'", "other_action")),
        (lambda: meet(edugym.QLearning.create((9, 2))), ("Q", "player 0", (4, 2), (9, 2))),
        (lambda: meet(games.MinimaxQ.create(SOCCER, 0)), ("Q", "player 0", (4, 2, 2), (801, 5, 5))),
        (
            lambda: meet(edugym.LinearQLearning.create(edugym.make_mdp("Golf"))),
            ("player 0", "tables", "LinearQLearning"),
        ),
        (lambda: meet(NoReturn(np.zeros((4, 2)))), ("act", "NoReturn", "0 to 1", None, "return")),
        (lambda: meet(Late(2)), ("act", "Late", "0 to 1", 2)),
        (lambda: meet(Late(1.0)), ("act", "Late", "0 to 1", 1.0)),
        (lambda: meet(Late(-1)), ("act", "Late", "0 to 1", -1)),
        (lambda: meet(Misspelt(np.zeros((4, 2)))), ("learn", "Misspelt", "'other_actoin'", "'other_action'")),
        (lambda: meet(Shrinks(), n_steps=200), ("Q", "player 0", (4, 2), (4, 1))),
        (lambda: meet(Forgets(np.zeros((4, 2)))), ("learn", "Forgets", "Q", "nan")),
        (lambda: meet(q_learning(Rooms(), 0), Rooms("rewards", 5_000), 100_000), ("rewards", "Rooms", "finite", "nan")),
        (
            lambda: meet(q_learning(Rooms(), 0), Rooms("initial", 5_000), 100_000),
            ("initial", "Rooms", "not terminal", (3, 0)),
        ),
        (lambda: meet(q_learning(Rooms(), 0), Rooms("observation", 5_000)), ("observation", "Rooms", "Discrete(4)", 7)),
        (
            lambda: edugym.train("Boulder", games.MinimaxQ.create(SOCCER, 0), 9),
            ("MinimaxQ", "edugym.games.train_players"),
        ),
        (lambda: games.learned_policy(PENNIES, 0, q_learning(SOCCER, 0)), ("Q", "player 0", (1, 2), (801, 5))),
        (
            lambda: edugym.train(SOCCER, q_learning(SOCCER, 0), 9),
            ("environment", "Soccer", "two players", "edugym.games.train_players", "edugym.games.against"),
        ),
        (lambda: edugym.finite_model(cast(Any, Rooms())), ("Rooms", "two players", "edugym.games.against")),
        (lambda: games.against(PENNIES, 0, q_learning(PENNIES, 1)), ("policy", "player 1", "learned_policy")),
        (lambda: games.FixedPlayer.create(PENNIES, 0, [0.5, 0.5]), ("policy", "player 0", (1, 2), "[[0.5, 0.5]]")),
        (lambda: games.exploitability(games.game_model(PENNIES), met()), ("policies", "pair", "run.policies[-1]")),
        (
            lambda: games.exploitability(games.game_model(PENNIES), met().policies),
            ("policies", "pair", "run.policies[-1]"),
        ),
        (lambda: games.game_model(Paid()), ("rewards", "Paid", "pair", 1.0)),
    ],
)
def test_slips(call: Callable[[], Any], says: tuple[Any, ...]) -> None:
    """Each mistake is one sentence, also where it comes late, in machine code."""
    with pytest.raises(ValueError, match=named(*says)):
        call()
