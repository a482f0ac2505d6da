"""Players who learn: their updates against other implementations, the loop, and what comes of it."""

import math
import threading
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given
from hypothesis import strategies as st

import edugym
from edugym import games
from edugym.agents.strategies import EpsilonGreedy
from edugym.compiled import execution
from edugym.experiments.results.statistics import mean_interval
from edugym.mdp.protocol import Random

PENNIES, SOCCER = games.MatchingPennies.create(), games.Soccer.create()


class Rooms(NamedTuple):
    """Three rooms in which each player sees where they are; the second wants what the first does not."""

    broken: str = ""
    after: int = 10**9
    max_steps: int = 7

    def initial(self, rng: Random) -> tuple[int, int]:
        """A room, drawn."""
        over = self.broken == "initial" and rng.random() * self.after < 1.0
        return 3 if over else int(rng.integers(3)), 0

    def transition(self, state: tuple[int, int], actions: tuple[int, int], rng: Random) -> tuple[int, int]:
        """Both move; the time goes on."""
        return (state[0] + actions[0] + 2 * actions[1]) % 4, state[1] + 1

    def rewards(self, state: Any, actions: tuple[int, int], next_state: Any, rng: Random) -> tuple[float, float]:
        """The first wants to do the same as the other."""
        reward = 1.0 * state[0] * (1 - 2 * abs(actions[0] - actions[1])) + rng.random()
        if self.broken == "rewards" and rng.random() * self.after < 1.0:
            return math.nan, 0.0
        return reward, -reward

    def terminal(self, state: tuple[int, int]) -> bool:
        """In the last room."""
        return state[0] == 3

    def observation(self, state: tuple[int, int], player: int, rng: Random) -> int:
        """The room."""
        return 7 if self.broken == "observation" and rng.random() * self.after < 1.0 else state[0]

    def observation_space(self, player: int) -> spaces.Discrete:
        """Four rooms."""
        return spaces.Discrete(4)

    def action_space(self, player: int) -> spaces.Discrete:
        """Two ways."""
        return spaces.Discrete(2)


def q_learning(game: Any, player: int, **settings: Any) -> Any:
    """A Q-learner."""
    return edugym.QLearning.create(games.table_shape(game, player), **settings)


def two(create: Callable[..., Any], game: Any, **settings: Any) -> tuple[Any, Any]:
    """Both players."""
    return create(game, 0, **settings), create(game, 1, **settings)


def minimax(table: Any) -> float:
    """The value of a game of two rows and two columns, by its formula."""
    (a, b), (c, d) = table
    low, high = max(min(a, b), min(c, d)), min(max(a, c), max(b, d))
    return float(low if low == high else (a * d - b * c) / (a + d - b - c))


told = st.tuples(
    st.integers(0, 2), st.integers(0, 1), st.integers(0, 1), st.integers(-9, 9), st.integers(0, 2), st.booleans()
)


LARGE = 9 / (1 - 0.8)
"""The largest value that there can be: with rewards up to 9 and a discount of 0.8."""


@given(st.lists(told, max_size=30), st.integers(0, 1))
def test_minimax_q_by_the_formula(steps: list[Any], player: int) -> None:
    """Q and V are those of the formula for two actions each, and the policy guarantees V."""
    agent = games.MinimaxQ.create(Rooms(), player, learning_rate=0.5, decay=0.9, discount=0.8, initial_value=1)
    Q, V, learning_rate = np.ones((4, 2, 2)), np.ones(4), 0.5
    for s, a, o, reward, next_s, terminated in steps:
        agent.learn(state=s, action=a, other_action=o, reward=float(reward), next_state=next_s, terminated=terminated)
        Q[s, a, o] = (1 - learning_rate) * Q[s, a, o] + learning_rate * (reward + 0.8 * V[next_s] * (not terminated))
        V[s], learning_rate = minimax(Q[s]), learning_rate * 0.9
        assert np.min(agent.policy[s] @ Q[s]) == pytest.approx(V[s], abs=1e-12 * LARGE)
    assert np.allclose(agent.Q, Q, rtol=0, atol=1e-12 * LARGE)
    assert np.allclose(agent.V, V, rtol=0, atol=1e-12 * LARGE)


def test_fictitious_play_is_browns() -> None:
    """With payoffs that it knows, its play is the best answer to the other's average, move by move."""
    payoffs = np.random.default_rng(0).normal(size=(2, 3))  # without ties
    game = games.matrix_game(payoffs)
    first, second = two(games.FictitiousPlay.create, game, epsilon=0.0, learning_rate=1.0, discount=0.0)
    first.Q[0], second.Q[0] = payoffs, -payoffs.T
    of_first, of_second = np.ones(2), np.ones(3)
    games.train_players(game, (first, second), 200)
    rng = np.random.default_rng(0)
    for _ in range(200):
        a, b = int(np.argmax(payoffs @ of_second)), int(np.argmin(of_first @ payoffs))
        of_first[a] += 1
        of_second[b] += 1
    assert np.array_equal(first.others[0], of_second)
    assert np.array_equal(second.others[0], of_first)
    assert np.allclose(first.policy[0], (of_first - 1) / 200)
    assert first.greedy(0, rng) == np.argmax(payoffs @ of_second)


def test_average_play_of_every_state() -> None:
    """Each row by its own count, and uniform where nothing has been played."""
    player = games.FictitiousPlay.create(SOCCER, 0)
    player.played[3] = [1, 0, 3, 0, 4]
    assert player.policy[3].tolist() == [0.125, 0.0, 0.375, 0.0, 0.5]
    assert np.allclose(np.delete(player.policy, 3, axis=0), 0.2)


class Tuple(NamedTuple):
    """A student's player, who also learns from the other's action."""

    Q: Any

    def act(self, state: int, rng: Random) -> int:
        """An action."""
        return 0 if rng.random() < 0.5 + 0.1 * self.Q[state, 0] else 1

    def learn(self, state: int, action: int, other_action: int, reward: float, truncated: bool) -> None:
        """Learn."""
        self.Q[state, action] += 0.1 * (reward + other_action + (1.0 if truncated else 0.0) - self.Q[state, action])


class Plain:
    """The same as an ordinary class, which is not compiled."""

    def __init__(self, Q: Any) -> None:
        """With a table."""
        self.Q = Q

    def act(self, state: int, rng: Random) -> int:
        """An action."""
        return 0 if rng.random() < 0.5 + 0.1 * self.Q[state, 0] else 1

    def learn(self, state: int, action: int, other_action: int, reward: float, truncated: bool) -> None:
        """Learn."""
        self.Q[state, action] += 0.1 * (reward + other_action + (1.0 if truncated else 0.0) - self.Q[state, action])


PLAYERS: dict[str, Callable[..., Any]] = {
    "MinimaxQ": games.MinimaxQ.create,
    "FictitiousPlay": games.FictitiousPlay.create,
    "QLearning": q_learning,
    "ActorCritic": lambda game, player: edugym.ActorCritic.create(games.table_shape(game, player)),
    "REINFORCE": lambda game, player: edugym.REINFORCE.create(games.table_shape(game, player), longest=7),
    "FixedPlayer": lambda game, player: games.FixedPlayer.create(game, player, games.uniform_policy(game, player)),
    "a student's": lambda game, player: Tuple(np.zeros(games.table_shape(game, player))),
}


@pytest.mark.parametrize("name", [name for name in PLAYERS if name != "a student's"])
def test_a_new_player_draws_one_of_the_best(name: str) -> None:
    """Each action of a new table is as likely: its share of the draws is within 4 standard errors."""
    player, rng, n = PLAYERS[name](SOCCER, 0), np.random.default_rng(0), 800
    n_actions = games.table_shape(SOCCER, 0)[1]
    counts = np.bincount([player.greedy(3, rng) for _ in range(n)], minlength=n_actions)
    assert counts == pytest.approx(n / n_actions, abs=4 * (n * (n_actions - 1)) ** 0.5 / n_actions)


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] * (name in ("REINFORCE", "ActorCritic"))) for name in PLAYERS]
)
def test_machine_code_does_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tables, policies and returns are those of the interpreter, bit for bit."""
    runs = []
    for compile_from in (0, 10**9):
        monkeypatch.setattr(execution, "COMPILE_FROM", compile_from)
        run = games.train_players(Rooms(), (PLAYERS[name](Rooms(), 0), q_learning(Rooms(), 1)), 12_000, seed=3)
        assert run.complete
        assert run.steps.tolist() == list(range(0, 12_001, 1_200))
        runs.append(run)
    first, second = runs
    assert np.array_equal(first.policies, second.policies)
    assert np.array_equal(first.training_returns, second.training_returns, equal_nan=True)
    for one, other in zip(first.agents, second.agents, strict=True):
        for field in one._fields:
            if isinstance(getattr(one, field), np.ndarray):
                assert np.array_equal(getattr(one, field), getattr(other, field))


@pytest.mark.filterwarnings("ignore:Plain cannot be compiled")
def test_any_class_can_play() -> None:
    """A student's ordinary class learns what the NamedTuple learns, also as player 1."""
    tables = []
    for kind in (Tuple, Plain):
        agents = kind(np.zeros((4, 2))), kind(np.zeros((4, 2)))
        games.train_players(Rooms(), agents, 6_000, seed=1)
        tables.append([agent.Q for agent in agents])
    assert np.array_equal(tables[0], tables[1])


def test_one_agent_on_both_sides() -> None:
    """The same agent may be both players: it learns twice a step."""
    agent = games.FictitiousPlay.create(PENNIES, 0)
    run = games.train_players(PENNIES, (agent, agent), 100)
    assert agent.played.sum() == 200
    assert run.agents[0].Q is run.agents[1].Q


class Ends(NamedTuple):
    """Notes how its steps ended."""

    seen: Any

    def act(self, state: int, rng: Random) -> int:
        """An action."""
        return 0

    def learn(self, terminated: bool, truncated: bool) -> None:
        """Learn."""
        self.seen[0] += terminated and not truncated
        self.seen[1] += truncated and not terminated
        self.seen[2] += terminated and truncated


@pytest.mark.parametrize(("max_steps", "seen"), [(None, [10, 0, 0]), (1, [10, 0, 0])])
def test_terminated_is_not_truncated(max_steps: int | None, seen: list[int]) -> None:
    """A matrix game terminates after its one step, also at the step limit."""
    agents = Ends(np.zeros(3)), Ends(np.zeros(3))
    run = games.train_players(PENNIES, agents, 10, max_steps=max_steps)
    assert [agent.seen.tolist() for agent in agents] == [seen, seen]
    assert run.episodes.sum() == 10


def test_truncated_at_the_limit() -> None:
    """In soccer two players who only go north never score: every episode is truncated at its limit."""
    agents = Ends(np.zeros(3)), Ends(np.zeros(3))
    run = games.train_players(SOCCER, agents, 40, max_steps=8)
    assert agents[0].seen.tolist() == [0, 5, 0]
    assert run.episodes.sum() == 5


def test_returns_of_fixed_players() -> None:
    """The mean returns of players who do not learn are those of the exact model, within 5 standard errors."""
    policies = games.uniform_policy(SOCCER, 0), np.array(games.uniform_policy(SOCCER, 1))
    policies[1][:] = [0, 0, 0, 1, 0]  # always west, where its goal is
    agents = [games.FixedPlayer.create(SOCCER, player, policies[player]) for player in (0, 1)]
    run = games.train_players(SOCCER, agents, 200_000, max_steps=10_000)
    expected = games.expected_returns(games.game_model(SOCCER), policies)
    n_episodes = run.episodes.sum()
    mean = np.nansum(run.training_returns * run.episodes[:, np.newaxis], axis=0) / n_episodes
    assert abs(expected[0]) > 0.1
    assert np.all(np.abs(mean - expected) < 5 / np.sqrt(n_episodes))
    assert np.array_equal(run.policies[-1], policies)


@pytest.mark.parametrize("player", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_the_best_answer_to_a_fixed_player(player: int) -> None:
    """Against one who shows heads too often, Q-learning finds the best answer, which is known exactly."""
    often_heads = games.FixedPlayer.create(PENNIES, 1 - player, [[0.8, 0.2]])
    learns = q_learning(PENNIES, player, learning_rate=0.01)
    games.train_players(PENNIES, (learns, often_heads) if player == 0 else (often_heads, learns), 20_000)
    assert int(games.learned_policy(PENNIES, player, learns)[0].argmax()) == player


def test_learned_policy() -> None:
    """It is the agent's own table if it has one, else the shares of its actions: ties are drawn."""
    ties = games.learned_policy(PENNIES, 0, q_learning(PENNIES, 0), draws=10_000)
    assert abs(ties[0, 0] - 0.5) < 0.03
    agent = q_learning(PENNIES, 0)
    agent.Q[0] = [0, 1]
    assert np.array_equal(games.learned_policy(PENNIES, 0, agent), [[0, 1]])
    policy = [[0.25, 0.75]]
    assert np.array_equal(games.learned_policy(PENNIES, 1, games.FixedPlayer.create(PENNIES, 1, policy)), policy)


def test_stop_and_interrupt() -> None:
    """A set event and Ctrl-C end the run; what was learned is kept."""
    stop = threading.Event()
    stop.set()
    run = games.train_players(PENNIES, two(q_learning, PENNIES), 100, stop=stop)
    assert not run.complete
    assert run.steps.tolist() == [0]

    class Interrupts(Plain):
        """Somebody presses Ctrl-C in step 11."""

        steps = 0

        def learn(self, reward: float) -> None:  # type: ignore[override]
            """Count, and interrupt."""
            self.steps += 1
            if self.steps == 11:
                raise KeyboardInterrupt

    with pytest.raises(edugym.Interrupted) as caught:
        games.train_players(PENNIES, (Interrupts(np.zeros((1, 2))), q_learning(PENNIES, 1)), 100, evaluate_every=5)
    assert caught.value.partial.steps.tolist()[0] == 0
    assert not caught.value.partial.complete


def exploitable(create: Callable[..., Any], contact: float, **settings: Any) -> Any:
    """How exploitable both are after a million steps of soccer: the interval of the mean over five seeds."""
    game = games.Soccer.create(contact=contact)
    model = games.game_model(game)
    runs = [games.train_players(game, two(create, game, **settings), 1_000_000, seed=seed) for seed in range(5)]
    return mean_interval([games.exploitability(model, run.policies[-1], 0.9) for run in runs])


@pytest.mark.slow
def test_who_is_exploited() -> None:
    """Minimax Q-learning is hardly exploitable where policies must be random; Q-learning is."""
    minimax_q = exploitable(games.MinimaxQ.create, 1.0)
    learner = exploitable(q_learning, 1.0, discount=0.9, initial_value=1, exploration=EpsilonGreedy(0.2))
    assert minimax_q.high < 0.1
    assert learner.low > 0.15


@pytest.mark.slow
@pytest.mark.parametrize(
    ("create", "settings"),
    [
        (games.MinimaxQ.create, {}),
        (q_learning, {"discount": 0.9, "initial_value": 1, "exploration": EpsilonGreedy(0.2)}),
    ],
)
def test_who_is_not(create: Callable[..., Any], settings: dict[str, Any]) -> None:
    """The control: without contact no policy needs to be random, and neither is exploitable."""
    assert exploitable(create, 0.0, **settings).high < 0.01
