"""Matrix games, the MDP against a fixed player, and exploitability: against payoffs and worked out by hand."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given
from hypothesis import strategies as st

import edugym
from edugym import games
from edugym.compiled import execution
from edugym.envs.games.matrix_games import MatrixGame
from edugym.mdp.against import Met
from edugym.mdp.protocol import Random
from edugym.rendering.ansi import to_text
from tests.messages import named


def policy(*probabilities: float) -> Any:
    """The policy of a player who sees nothing."""
    return np.array([probabilities])


FIRST, SECOND = policy(1.0, 0.0), policy(0.0, 1.0)


@pytest.mark.parametrize(
    ("game", "policies", "returns", "gain"),
    [
        (games.RockPaperScissors.create(), (policy(1 / 3, 1 / 3, 1 / 3),) * 2, (0, 0), 0),
        (games.RockPaperScissors.create(), (policy(1, 0, 0), policy(1 / 3, 1 / 3, 1 / 3)), (0, 0), 1 / 2),
        (games.MatchingPennies.create(), (policy(0.7, 0.3), policy(0.4, 0.6)), (-0.08, 0.08), (0.2 + 0.4) / 2),
        (games.PrisonersDilemma.create(5), (FIRST, FIRST), (3, 3), 5 - 3),
        (games.PrisonersDilemma.create(5), (SECOND, SECOND), (1, 1), 0),
        (games.PrisonersDilemma.create(5), (FIRST, SECOND), (0, 5), 1 / 2),
        (games.PrisonersDilemma.create(3), (FIRST, FIRST), (3, 3), 0),
        (games.StagHunt.create(3), (FIRST, FIRST), (4, 4), 0),
        (games.StagHunt.create(3), (SECOND, SECOND), (3, 3), 0),
        (games.StagHunt.create(5), (FIRST, FIRST), (4, 4), 5 - 4),
        (games.Chicken.create(10), (FIRST, SECOND), (-1, 1), 0),
        (games.Chicken.create(10), (policy(0.9, 0.1),) * 2, (-0.1, -0.1), 0),
        (games.Chicken.create(10), (SECOND, SECOND), (-10, -10), 10 - 1),
        (games.Chicken.create(0.5), (SECOND, SECOND), (-0.5, -0.5), 0),
    ],
)
def test_exploitability_by_hand(game: Any, policies: Any, returns: tuple[float, float], gain: float) -> None:
    """Equilibria are not exploitable, and the other policies by as much as their docstrings say."""
    model = games.game_model(game)
    assert games.expected_returns(model, policies) == pytest.approx(returns)
    assert games.exploitability(model, policies) == pytest.approx(gain, abs=1e-12)


@pytest.mark.parametrize("kind", MatrixGame.__subclasses__())
def test_a_docstring_numbers_the_actions(kind: Any) -> None:
    """As they are numbered in the game."""
    names = kind.create().action_names
    assert f"Actions: {', '.join(f'{number} {name}' for number, name in enumerate(names))}." in (kind.__doc__ or "")


def weights(n: int) -> st.SearchStrategy[Any]:
    """Policies of so many actions."""
    return st.lists(st.integers(0, 5), min_size=n, max_size=n).filter(any).map(lambda w: policy(*np.divide(w, sum(w))))


@given(st.data())
def test_any_table_of_payoffs(data: Any) -> None:
    """Values and gains are those of the tables, and so is each state of the MDP against a fixed player."""
    n, m = data.draw(st.integers(1, 3)), data.draw(st.integers(1, 3))
    payoff = st.lists(st.integers(-3, 3), min_size=m, max_size=m)
    first, second = (np.array(data.draw(st.lists(payoff, min_size=n, max_size=n)), float) for _ in range(2))
    p, q = data.draw(weights(n)), data.draw(weights(m))
    game = games.matrix_game(first, second)
    model = games.game_model(game)
    alone = [(first @ q[0], p[0]), (p[0] @ second, q[0])]  # what each action is worth, and how likely it is
    returns = [values @ own for values, own in alone]
    assert games.expected_returns(model, (p, q)) == pytest.approx(returns)
    gain = sum(max(values) - values @ own for values, own in alone) / 2
    assert games.exploitability(model, (p, q)) == pytest.approx(gain, abs=1e-12)
    for player, (values, _) in enumerate(alone):
        other = (q, p)[player]
        found = edugym.value_iteration(edugym.finite_model(games.against(game, player, other)))
        assert found.start == pytest.approx(max(values))
        assert found.Q[found.model.initial > 0] == pytest.approx(values[np.newaxis])


class Tag(NamedTuple):
    """Two on a ring of n squares; each stays or steps on. Player 0 gets 1 for every step apart, player 1 the opposite.

    It ends when they meet, and a step onto the same square slips back with the probability 1/4. Player 0 sees only how
    far it is ahead; player 1 sees both squares.
    """

    n: int = 3
    max_steps: int = 20

    def initial(self, rng: Random) -> tuple[int, int]:
        """Not on one square."""
        return 0, 1 + int(rng.integers(0, self.n - 1))

    def transition(self, state: tuple[int, int], actions: tuple[int, int], rng: Random) -> tuple[int, int]:
        """Each moves."""
        first, second = (state[0] + actions[0]) % self.n, (state[1] + actions[1]) % self.n
        if first == second and rng.random() < 0.25:
            return state
        return first, second

    def rewards(self, state: Any, actions: Any, next_state: tuple[int, int], rng: Random) -> tuple[float, float]:
        """For being apart, and a little for staying."""
        gain = (0.0 if next_state[0] == next_state[1] else 1.0) + 0.125 * (actions[1] - actions[0])
        return gain, -gain

    def terminal(self, state: tuple[int, int]) -> bool:
        """On one square."""
        return state[0] == state[1]

    def observation(self, state: tuple[int, int], player: int, rng: Random) -> int:
        """How far player 0 is ahead, or both squares."""
        return (state[0] - state[1]) % self.n if player == 0 else state[0] * self.n + state[1]

    def observation_space(self, player: int) -> spaces.Discrete:
        """As above."""
        return spaces.Discrete(self.n if player == 0 else self.n * self.n)

    def action_space(self, player: int) -> spaces.Discrete:
        """Stay or step on."""
        return spaces.Discrete(2)


@pytest.mark.parametrize("player", [0, 1])
def test_the_model_against_a_player_is_that_of_the_mdp(player: int) -> None:
    """The averaged tables, and the MDP that remembers the other's action, have the same values in every state."""
    game, discount = Tag(4), 0.9
    model = games.game_model(game)
    other = np.random.default_rng(player).dirichlet(np.ones(2), games.table_shape(game, 1 - player)[0])
    averaged = edugym.value_iteration(model.against(player, other), discount)
    mdp = games.against(game, player, other)
    remembered = edugym.value_iteration(edugym.finite_model(mdp), discount)
    assert remembered.start == pytest.approx(averaged.start, abs=1e-9)
    for state, value in zip(remembered.model.states, remembered.V, strict=True):
        assert value == pytest.approx(averaged.value(state.state), abs=1e-9)
    assert mdp.max_steps == 20
    assert edugym.table_size(mdp) == ((4, 2), (16, 2))[player]


@pytest.mark.parametrize(
    ("game", "discount"), [(Tag(3), 0.5), pytest.param(games.Soccer.create(0.3), 0.9, marks=pytest.mark.slow)]
)
def test_returns_are_those_of_play(game: Any, discount: float) -> None:
    """Many episodes of two random players come to what the model expects, within 5 standard errors.

    Player 1 takes the first action or the last, so that its chances are not those of player 0.
    """
    rng, last = np.random.default_rng(0), game.action_space(1).n - 1
    policies = games.uniform_policy(game, 0), np.zeros_like(games.uniform_policy(game, 1))
    policies[1][:, [0, last]] = 0.5
    expected = games.expected_returns(games.game_model(game), policies, discount)
    returns = []
    for _ in range(2_000):
        state, total, weight = game.initial(rng), np.zeros(2), 1.0
        while not game.terminal(state) and weight > 1e-6:
            actions = int(rng.integers(game.action_space(0).n)), last * int(rng.integers(2))
            next_state = game.transition(state, actions, rng)
            total += weight * np.array(game.rewards(state, actions, next_state, rng))
            state, weight = next_state, weight * discount
        returns.append(total)
    error = np.std(returns, axis=0) / np.sqrt(len(returns))
    assert np.all(np.abs(np.mean(returns, axis=0) - expected) < 5 * error)
    assert expected[0] == pytest.approx(-expected[1])
    assert abs(expected[0]) > 8 * error[0]


def test_the_picture_against_a_fixed_player() -> None:
    """That of the game, so that one can play against the policy; without one the state in words, as in PettingZoo."""
    soccer, pennies = games.Soccer.create(), games.MatchingPennies.create()
    state = soccer.initial(np.random.default_rng(0))
    mdp = games.against(soccer, 0, games.uniform_policy(soccer, 1))
    assert mdp.scene(Met(state, 3)) == soccer.scene(state)
    assert "state 1" in to_text(games.against(pennies, 1, FIRST).scene(Met(1, 0)))


def test_a_picture_that_is_none() -> None:
    """It is refused with the name of the game."""

    class Blank(MatrixGame):
        def scene(self, state: int) -> Any:
            return "a picture"

    mdp = games.against(Blank(games.MatchingPennies.create().payoffs), 0, FIRST)
    with pytest.raises(ValueError, match=named("scene", "Blank", "Scene", "'a picture'")):
        mdp.scene(Met(0, 0))


@pytest.mark.parametrize(("temptation", "talks"), [(5.0, True), (1.0, False)])
def test_learning_against_a_fixed_player(temptation: float, talks: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Q-learning finds the best answer to one who is silent; machine code does what the interpreter does."""
    mdp = games.against(games.PrisonersDilemma.create(temptation), 1, FIRST)
    runs = []
    for compile_from in (0, 10**9):
        monkeypatch.setattr(execution, "COMPILE_FROM", compile_from)
        runs.append(edugym.train(mdp, edugym.QLearning.create(mdp), 500, seed=0).agent.Q)
    assert np.array_equal(*runs)
    assert (runs[0][0, 1] > runs[0][0, 0]) == talks


class NoGame(NamedTuple):
    """A game whose player 1 acts on a continuum."""

    game: Any

    def __getattr__(self, name: str) -> Any:
        """As the game."""
        return getattr(self.game, name)

    def action_space(self, player: int) -> Any:
        """No numbers for player 1."""
        return self.game.action_space(0) if player == 0 else spaces.Box(0, 1)


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: games.game_model(Tag), ("game", "Tag", "Tag(...)")),
        (lambda: games.game_model(edugym.make_mdp("Boulder")), ("game", "rewards", "Boulder", "rewards")),
        (lambda: games.table_shape(NoGame(Tag()), 0), ("action_space(1)", "NoGame", "spaces.Discrete", "Box")),
        (lambda: games.game_model(Tag(), 3), ("3", "states", "max_states")),
        (lambda: games.against(Tag(), 2, FIRST), ("player", 0, 1, 2)),
        (lambda: games.against(Tag(), 0, FIRST), ("policy", "player 1", (9, 2))),
        (lambda: games.against(Tag(2), 1, [[1, 0], [0.7, 0.7]]), ("policy", "player 0", "1", "row 1", "0.7 0.7")),
        (lambda: games.matrix_game([[0, np.inf]]), ("first", "finite", "inf")),
        (lambda: games.matrix_game([[0, 1]], [[0]]), ("second", (1, 2))),
        (lambda: games.matrix_game(np.zeros((0, 2))), ("first", 1, 1000, (0, 2))),
    ],
)  # fmt: skip
def test_messages(call: Any, says: tuple[Any, ...]) -> None:
    """Each mistake is answered with one sentence."""
    with pytest.raises(ValueError, match=named(*says)) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_the_other_payoffs_are_the_opposite() -> None:
    """One table makes a zero-sum game."""
    game = games.matrix_game([[1, 0, -2]])
    assert isinstance(game, MatrixGame)
    assert game.payoffs[..., 1].tolist() == [[-1, 0, 2]]
    assert (games.table_shape(game, 0), games.table_shape(game, 1)) == ((1, 1), (1, 3))
