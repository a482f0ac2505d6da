"""Games behind PettingZoo's interface: its own tests, the same episodes as the game's methods, and students' slips."""

import copy
import pickle
import warnings
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.error import ResetNeeded

from edugym import games
from edugym.adapters.parallel_env import PLAYERS
from edugym.mdp.protocol import Random
from tests.messages import named

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    pytest.importorskip("pettingzoo")
    from pettingzoo import ParallelEnv
    from pettingzoo.test import parallel_api_test, parallel_seed_test
    from pettingzoo.utils import parallel_to_aec


class Meeting(NamedTuple):
    """Two players on a ring of five squares get 1 when they meet; `slip` makes one mistake of students."""

    slip: str = ""
    max_steps: int = 20

    def initial(self, rng: Random) -> Any:
        """Apart from each other."""
        over = self.slip == "over" and rng.random() < 0.01
        return None if self.slip == "initial" else np.array([0, 0 if over else 1 + rng.integers(4)])

    def transition(self, state: Any, actions: tuple[int, int], rng: Random) -> Any:
        """To the left, stay, or to the right."""
        if self.slip == "changed":
            state += 1
        return None if self.slip == "transition" else (state + actions - 1) % 5

    def rewards(self, state: Any, actions: tuple[int, int], next_state: Any, rng: Random) -> Any:
        """1 for both when they meet."""
        met = 1.0 if self.terminal(next_state) else 0.0
        return {"one reward": met, "nothing": None, "text": ("1", met), "nan": (np.nan, met)}.get(
            self.slip, (met, -met)
        )

    def terminal(self, state: Any) -> Any:
        """Whether they have met."""
        return None if self.slip == "terminal" else state[0] == state[1]

    def observation(self, state: Any, player: int, rng: Random) -> int:
        """How far away the other is."""
        return int(state[1 - player] - state[player]) % 5 + (9 if self.slip == "observation" else 0)

    def observation_space(self, player: int) -> spaces.Discrete:
        """Squares to the other."""
        return spaces.Discrete(5)

    def action_space(self, player: int) -> spaces.Discrete:
        """Three moves."""
        return spaces.Discrete(3)


GAMES = [games.Soccer.create(max_steps=30), games.MatchingPennies.create(), games.matrix_game([[1, 2, 3]]), Meeting()]


def names(game: Any) -> str:
    """The name of a case."""
    return type(game).__name__


@pytest.mark.parametrize("game", GAMES, ids=names)
def test_pettingzoos_own_tests(game: Any) -> None:
    """Of the parallel interface and of seeds; its other interface, where one acts after the other, takes it too."""
    env = games.parallel_env(game)
    assert isinstance(env, ParallelEnv)
    parallel_api_test(env, num_cycles=100)
    parallel_seed_test(lambda: games.parallel_env(game), num_cycles=100)
    in_turn = parallel_to_aec(games.parallel_env(game))
    in_turn.reset(seed=0)
    for name in in_turn.agent_iter(20):
        *_, terminated, truncated, _ = in_turn.last()
        in_turn.step(None if terminated or truncated else in_turn.action_space(name).sample())


@pytest.mark.parametrize("game", GAMES, ids=names)
def test_episodes_are_those_of_the_game(game: Any) -> None:
    """With the same random stream; terminated and truncated are never both, and nobody plays after the end."""
    env, rng, actions = games.parallel_env(game), np.random.default_rng(5), np.random.default_rng(6)
    ends = set()
    for episode in range(30):
        seen, _ = env.reset(seed=5 if episode == 0 else None)
        state, steps = game.initial(rng), 0
        assert seen == {name: game.observation(state, player, rng) for player, name in enumerate(PLAYERS)}
        while env.agents:
            pair = tuple(int(actions.integers(game.action_space(player).n)) for player in (0, 1))
            seen, rewards, terminated, truncated, _ = env.step(dict(zip(PLAYERS, pair, strict=True)))
            next_state = game.transition(state, pair, rng)
            assert tuple(rewards.values()) == game.rewards(state, pair, next_state, rng)
            state, steps = next_state, steps + 1
            assert seen == {name: game.observation(state, player, rng) for player, name in enumerate(PLAYERS)}
            over = bool(game.terminal(state))
            cut = not over and steps == getattr(game, "max_steps", None)
            assert (terminated, truncated) == (dict.fromkeys(PLAYERS, over), dict.fromkeys(PLAYERS, cut))
            assert env.agents == ([] if over or cut else [*PLAYERS])
            ends |= {over, cut} if not env.agents else set()
    assert True in ends
    with pytest.raises(ResetNeeded, match="finished episode"):
        env.step(dict.fromkeys(PLAYERS, 0))


@pytest.mark.parametrize("again", [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))])
def test_copies_go_on_alone(again: Any) -> None:
    """From the same state, with the same random stream."""
    env = games.parallel_env(games.Soccer.create())
    env.reset(seed=1)
    other = again(env)
    steps = [[one.step(dict.fromkeys(PLAYERS, 2)) for _ in range(2)] for one in (env, other)]
    assert steps[0] == steps[1]
    assert other.game_state == env.game_state


@pytest.mark.parametrize(
    ("slip", "says"),
    [
        ("initial", r"initial of Meeting .*None \(is a return missing\?\)"),
        ("transition", r"transition of Meeting .*None for state .*, actions \(1, 1\) \(is a return missing\?\)"),
        ("changed", "transition of Meeting .*change the state"),
        ("one reward", "rewards of Meeting .*pair.*0.0"),
        ("nothing", r"rewards of Meeting .*pair.*None .*\(is a return missing\?\)"),
        ("text", "rewards of Meeting .*pair.*'1'"),
        ("nan", "rewards of Meeting .*pair.*nan"),
        ("terminal", "terminal of Meeting .*True or False.*None"),
        ("observation", r"observation of Meeting .*Discrete\(5\) to player 0"),
    ],
)
def test_slips_in_a_game(slip: str, says: str) -> None:
    """One sentence names the method and what it returned."""
    env = games.parallel_env(Meeting(slip))

    def play() -> None:
        env.reset(seed=0)
        env.step(dict.fromkeys(PLAYERS, 1))

    with pytest.raises(ValueError, match=says):
        play()


@pytest.mark.parametrize(("seed", "is_late"), [(7, False), (1, True)])
def test_a_game_that_is_over_at_the_start(seed: int, is_late: bool) -> None:
    """The same sentence, whether it comes in the first steps or after them."""
    env = games.parallel_env(Meeting("over"))
    steps: list[int] = []

    def play() -> None:
        env.reset(seed=seed)
        while len(steps) < 9_000:
            steps.append(1)
            env.step(dict.fromkeys(PLAYERS, 1))
            if not env.agents:
                env.reset()

    with pytest.raises(ValueError, match=r"initial of Meeting .*not terminal, .*0, 0"):
        play()
    assert (len(steps) > 200) == is_late  # the first are checked in every way


def test_slips_of_players() -> None:
    """Actions that are none, and steps outside an episode."""
    env = games.parallel_env(Meeting())
    with pytest.raises(ResetNeeded, match="before the first reset"):
        env.step({})
    with pytest.raises(ResetNeeded, match="before the first reset"):
        env.render()
    env.reset(seed=0)
    wrong: Any
    for wrong in ([1, 1], None, {"player_0": 1}, {0: 1, 1: 1}):
        with pytest.raises(ValueError, match=r"actions .*player_0, player_1"):
            env.step(wrong)
    with pytest.raises(ValueError, match="action 3 is not in the action space of player_"):
        env.step({"player_0": 0, "player_1": 3})
    assert env.steps == 0
    with pytest.raises(ValueError, match=named("render_mode", None, "rgb_array", "ansi", "human")):
        games.parallel_env(Meeting(), "human")
    with pytest.raises(ValueError, match="game must be a Markov game"):
        games.parallel_env(gymnasium.make("CartPole-v1"))


def test_pictures() -> None:
    """The game's own picture, or its state as text."""
    pixels = games.parallel_env(games.Soccer.create(), "rgb_array")
    pixels.reset(seed=0)
    picture = pixels.render()
    assert picture.ndim == 3
    assert len(np.unique(picture)) > 2
    for game, says in ((games.Soccer.create(), "has the ball"), (Meeting(), "state")):
        text = games.parallel_env(game, "ansi")
        text.reset(seed=0)
        assert says in text.render()
    silent = games.parallel_env(Meeting())
    silent.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode"):
        assert silent.render() is None
