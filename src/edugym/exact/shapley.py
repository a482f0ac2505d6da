"""Shapley's value iteration: the value of a zero-sum Markov game, and policies that guarantee it."""

from typing import Any, NamedTuple

import numpy as np

from edugym.compiled.execution import executable
from edugym.exact.game_model import GameModel, require_game_model
from edugym.exact.values import sweep_until_settled
from edugym.exact.zero_sum import solve_states, workspace
from edugym.mdp.markov_game import n_actions
from edugym.mdp.protocol import Reals

USUAL_SWEEPS = 200
"""About so many sweeps are needed at discount 0.9: from this follows whether machine code pays."""


class GameValues(NamedTuple):
    """The solution of a zero-sum Markov game.

    Attributes:
        V: shape (S,): the value of each state to player 0, by the rows of the model; to player 1 its opposite.
        Q: shape (S, A_0, A_1): the value to player 0 of each pair of actions.
        start: what player 0 expects from the start of an episode.
        policies: of players 0 and 1, by their observations: shapes (n_observations, n_actions). Each guarantees its
            player the value, whatever the other does.
        model: the model that it was found with.
    """

    V: Reals
    Q: Reals
    start: float
    policies: tuple[Reals, Reals]
    model: GameModel

    def value(self, state: Any) -> float:
        """V(s) of a state.

        Raises:
            ValueError: the game has no such state.
        """
        return float(self.V[self.model.joint[0].row(state)])


def minimax_value_iteration(
    model: GameModel, discount: float = 1.0, *, tolerance: float = 1e-10, max_sweeps: int = 100_000
) -> GameValues:
    """Solve a zero-sum Markov game: value iteration, in which each state is a matrix game.

        Q(s, a, b) <- Σ_s' p(s'|s, a, b) [r(s, a, b, s') + γ V(s')]
        V(s)       <- max_π min_b Σ_a π(a) Q(s, a, b)

    Both players must see the state, or as much of it as their policies depend on.

    Args:
        model: the model of the game.
        discount: γ, from 0 to 1.
        tolerance: stop when every change is smaller; a finite number greater than 0.
        max_sweeps: give up after so many sweeps, from 1 to 10 million.

    Raises:
        ValueError: a parameter is not as above, the game is not zero-sum, the values do not settle, or two states in
            which a player must act differently look the same to it.

    References: Shapley (1953), Stochastic games.
    """
    require_game_model(model)
    first, second = model.joint
    n_states, n_first, n_second = len(first.states), n_actions(model.game, 0), n_actions(model.game, 1)

    def by_pair(Q: Reals) -> Reals:
        """From (states, pairs) to (states, actions of player 0, actions of player 1)."""
        return np.ascontiguousarray(Q.reshape(n_states, n_second, n_first).swapaxes(1, 2))

    rewards, others = by_pair(first.r), second.r.reshape(n_states, n_first, n_second)
    if not np.allclose(rewards, -others, rtol=0, atol=1e-12):
        s, a, b = np.unravel_index(np.abs(rewards + others).argmax(), rewards.shape)
        pair = float(rewards[s, a, b]), float(others[s, a, b])
        raise ValueError(
            f"model must be of a zero-sum game, in which the rewards add up to 0, but after the actions"
            f" {(int(a), int(b))} in state {first.states[s]!r} they are {pair}"
        )
    policies = np.zeros((n_states, n_first)), np.zeros((n_states, n_second))
    space = workspace(n_first, n_second)

    def minimax(Q: Reals) -> Reals:
        V = np.zeros(n_states)
        solve(n_states, by_pair(Q), V, *policies, *space)
        return V

    blank = by_pair(np.zeros((n_states, n_first * n_second))), np.zeros(n_states), *policies, *space
    solve = executable(solve_states, blank, expected=USUAL_SWEEPS * n_states)
    V, Q, start, _ = sweep_until_settled(first, minimax, discount, None, tolerance, max_sweeps)
    by_observation = model.by_observation(0, policies[0]), model.by_observation(1, policies[1])
    return GameValues(V, by_pair(Q), start, by_observation, model)
