"""Zero-sum games: each policy that is found guarantees the value, which proves that both are right."""

from functools import cache
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import games
from edugym.envs.games.soccer import EAST, GOAL, NORTH, SOUTH, STAND, WEST, Field
from edugym.rendering.ansi import to_text
from tests.exact.test_games import Tag
from tests.messages import named

STEPS = {NORTH: (-1, 0), SOUTH: (1, 0), EAST: (0, 1), WEST: (0, -1), STAND: (0, 0)}
DISCOUNT = 0.9


@given(st.data())
def test_both_policies_guarantee_the_value(data: Any) -> None:
    """Whatever the other does; ties, equal rows and tables of one column included."""
    n, m = data.draw(st.integers(1, 6)), data.draw(st.integers(1, 6))
    numbers = st.one_of(st.integers(-2, 2), st.floats(-1e6, 1e6))
    row = st.lists(numbers, min_size=m, max_size=m)
    payoffs = np.array(data.draw(st.lists(row, min_size=n, max_size=n)), float)
    value, first, second = games.solve_zero_sum(payoffs)
    size = np.abs(payoffs).max() + 1e-300
    for policy in (first, second):
        assert (policy >= 0).all()
        assert policy.sum() == pytest.approx(1)
    assert (first @ payoffs).min() == pytest.approx(value, abs=1e-9 * size)
    assert (payoffs @ second).max() == pytest.approx(value, abs=1e-9 * size)


def test_where_nothing_matters() -> None:
    """Of all policies, which are equally good there, the uniform ones are found."""
    value, first, second = games.solve_zero_sum([[7, 7, 7], [7, 7, 7]])
    assert (value, first.tolist(), second.tolist()) == (7, pytest.approx([1 / 2] * 2), pytest.approx([1 / 3] * 3))


def test_payoffs_that_are_almost_equal() -> None:
    """Rounding costs digits there, in few games many."""
    rng, gaps = np.random.default_rng(0), []
    for _ in range(1_000):
        shape = tuple(rng.integers(3, 8, 2))
        payoffs = rng.integers(-2, 3, shape) + 10.0 ** rng.uniform(-17, -7, shape) * rng.normal(size=shape)
        _, first, second = games.solve_zero_sum(payoffs)
        assert abs(first.sum() - 1) < 1e-8
        assert abs(second.sum() - 1) < 1e-8
        gaps.append((payoffs @ second).max() - (first @ payoffs).min())
    assert np.mean(np.array(gaps) < 1e-9) > 0.95
    assert np.mean(np.array(gaps) < 1e-7) > 0.99


def test_a_tiny_pivot_leaves_probabilities() -> None:
    """Minimax Q-learning with a learning rate of 1 came to this table in soccer, and its policy summed to 0.75."""
    payoffs = [
        [0.7290000000000002, 1.7303204405944018e-05, 1.0520803551700154e-05],
        [0.729, 1.747762239329709e-05, 1.0525035741748567e-05],
        [0.7290000000000001, 4.587282546215099e-05, 1.0525035741748567e-05],
    ]
    value, first, second = games.solve_zero_sum(payoffs)
    assert (first.sum(), second.sum()) == (pytest.approx(1, abs=1e-9), pytest.approx(1, abs=1e-9))
    assert (first @ payoffs).min() == pytest.approx(value, abs=1e-8)
    assert (payoffs @ second).max() == pytest.approx(value, abs=1e-8)


class Ball(NamedTuple):
    """Soccer in the test's own words: places are (row, column), a goal is None."""

    places: tuple[Any, Any]
    owner: int


def moved(ball: Ball, player: int, action: int, contact: float) -> list[tuple[float, Ball]]:
    """What one move can come to, with its probabilities."""
    row, column = ball.places[player]
    row, column = row + STEPS[action][0], column + STEPS[action][1]
    has_ball, other = ball.owner == player, ball.places[1 - player]
    both = {player: (row, column), 1 - player: other}
    if has_ball and row in (1, 2) and column == (5 if player == 0 else -1):
        both[player] = None
    elif not (0 <= row < 4 and 0 <= column < 5):
        return [(1.0, ball)]
    elif both[player] == other:
        if not has_ball:
            return [(1.0, ball)]
        swapped = Ball((ball.places[1], ball.places[0]), ball.owner)
        return [(contact, Ball(ball.places, 1 - player)), (1.0 - contact, swapped)]
    return [(1.0, Ball((both[0], both[1]), ball.owner))]


def in_own_words(state: Field) -> Ball:
    """A state of the game."""
    first, second = (None if place == GOAL else divmod(place, 5) for place in (state.first, state.second))
    return Ball((first, second), state.ball)


@cache
def soccer(contact: float) -> tuple[Any, Any]:
    """Its model and its solution: each takes a second."""
    model = games.game_model(games.Soccer.create(contact))
    return model, games.minimax_value_iteration(model, DISCOUNT)


@pytest.mark.parametrize("contact", [0.0, 0.3, 1.0])
def test_soccer_is_what_its_page_says(contact: float) -> None:
    """Every transition of the model, against an implementation of its own; and the values solve Shapley's equation."""
    model, solved = soccer(contact)
    states = model.joint[0].states
    values = dict(zip(map(in_own_words, states), solved.V.tolist(), strict=True))
    assert len(states) == 800
    for s, state in enumerate(states):
        if model.joint[0].terminal[s]:
            assert GOAL in state[:2]
            continue
        Q = np.zeros((5, 5))
        for a, b in np.ndindex(5, 5):
            reached: dict[Ball, float] = {}
            for order in ((0, 1), (1, 0)):
                ways = [(0.5, in_own_words(state))]
                for player in order:
                    ways = [
                        (p * q, after)
                        for p, before in ways
                        for q, after in ([(1.0, before)] if None in before.places
                                         else moved(before, player, (a, b)[player], contact))
                    ]  # fmt: skip
                for p, after in ways:
                    reached[after] = reached.get(after, 0.0) + p
            known = model.joint[0].outcomes(state, a + 5 * b)
            found: dict[Ball, float] = {in_own_words(way.next_state): way.probability for way in known}
            assert found == pytest.approx({after: p for after, p in reached.items() if p > 0})
            for after, p in reached.items():
                reward = 1.0 if after.places[0] is None else -1.0 if after.places[1] is None else 0.0
                Q[a, b] += p * (reward + DISCOUNT * values[after] * (reward == 0))
        first, second = (policy[2 * (20 * state.first + state.second) + state.ball] for policy in solved.policies)
        assert (first @ Q).min() == pytest.approx(solved.V[s], abs=1e-8)
        assert (Q @ second).max() == pytest.approx(solved.V[s], abs=1e-8)


@pytest.mark.parametrize(("contact", "random_states"), [(0.0, 0), (1.0, 56)])
def test_the_value_of_soccer(contact: float, random_states: int) -> None:
    """Nobody can exploit the solution; it is random where the other player matters; half a turn exchanges the players.

    Without contact the value is a count of steps: γ^(steps - 1) to who has the ball.
    """
    model, solved = soccer(contact)
    assert solved.start == pytest.approx(0, abs=1e-9)
    assert games.exploitability(model, solved.policies, DISCOUNT) == pytest.approx(0, abs=1e-8)
    pure = solved.Q.min(axis=2).max(axis=1)  # what a policy without chance guarantees
    assert (solved.V - pure > 1e-8).sum() == random_states
    for state in model.joint[0].states:
        first, second, ball = state
        if GOAL in (first, second):
            continue
        value = solved.value(state)
        assert value == pytest.approx(-solved.value(Field(19 - second, 19 - first, 1 - ball)), abs=1e-8)
        if contact == 0:
            row, column = divmod(first if ball == 0 else second, 5)
            steps = (5 - column if ball == 0 else column + 1) + (row in (0, 3))
            assert value == pytest.approx((1 if ball == 0 else -1) * DISCOUNT ** (steps - 1))


def test_not_every_game_has_such_a_solution() -> None:
    """Rewards must be opposite, and players must see what their policies depend on."""
    dilemma = games.game_model(games.PrisonersDilemma.create())
    with pytest.raises(ValueError, match=named("model", "zero-sum", (0, 0), 0, (3.0, 3.0))):
        games.minimax_value_iteration(dilemma)
    blind = games.game_model(Blind())
    with pytest.raises(ValueError, match=named("player 0", "see", "state")):
        games.minimax_value_iteration(blind, DISCOUNT)


class Blind(Tag):
    """Player 0 gets the opposite where player 1 is ahead, and does not see it."""

    def rewards(self, state: Any, actions: Any, next_state: Any, rng: Any) -> tuple[float, float]:
        """Staying is good in one state, and bad in the other."""
        gain = (1.0 if (state[1] - state[0]) % 3 == 1 else -1.0) * actions[0]
        return gain, -gain

    def observation(self, state: Any, player: int, rng: Any) -> int:
        """Nothing for player 0."""
        return 0 if player == 0 else state[0] * self.n + state[1]


def test_scene() -> None:
    """Both players, the ball and who has scored are in the picture."""
    game = games.Soccer.create()
    playing, over = (to_text(game.scene(state)) for state in (Field(6, 13, 0), Field(7, GOAL, 1)))
    assert "A ●" in playing
    assert "player 0 has the ball" in playing
    assert "B●" in over
    assert "player 1 has scored" in over
