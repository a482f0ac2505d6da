"""Policies of players as tables: the probability of every action for everything that a player may observe."""

from typing import Any

import numpy as np

from edugym.checks.parameters import in_short
from edugym.mdp.markov_game import a_player, require_game, sizes, table_shape
from edugym.mdp.protocol import Random, Reals


def uniform_policy(game: Any, player: int) -> Reals:
    """The policy of random actions: shape (n_observations, n_actions).

    Raises:
        ValueError: `game` is no game, or `player` is neither 0 nor 1.
    """
    shape = table_shape(game, player)
    return np.full(shape, 1.0 / shape[1])


def checked_policy(game: Any, player: int, policy: Any, name: str = "policy") -> Reals:
    """A player's policy, checked: shape (n_observations, n_actions), each row probabilities that sum to 1.

    Args:
        game: the game.
        player: whose policy it is.
        policy: the table.
        name: of the parameter that it was given for.

    Raises:
        ValueError: it is something else, or `game` is no game.
    """
    require_game(game)
    return fitting_policy(game, a_player(player), policy, name)


def fitting_policy(game: Any, player: int, policy: Any, name: str = "policy") -> Reals:
    """`checked_policy` for what is known to be a game.

    Raises:
        ValueError: the policy is something else.
    """
    shape = sizes(game, player)
    try:
        table = np.asarray(policy, np.float64)
    except (ValueError, TypeError, OverflowError):
        table = np.zeros(0)
    if table.shape != shape:
        agent = hasattr(policy, "act") and not isinstance(policy, type)
        hint = f": learned_policy(game, {player}, agent) is that of an agent" if agent else ""
        hint = hint or (f": put the row into a table, [{in_short(policy)}]" if table.shape == shape[1:] else "")
        raise ValueError(
            f"{name} of player {player} must be an array of shape {shape}, with a row of probabilities for each"
            f" observation, but is {in_short(policy)}{hint}"
        )
    bad = ~((table >= 0).all(axis=1) & (np.abs(table.sum(axis=1) - 1) < 1e-6))
    if bad.any():
        row = int(bad.argmax())
        raise ValueError(
            f"{name} of player {player} must hold probabilities that sum to 1 in every row, but row {row} is"
            f" {table[row]}"
        )
    return table


def checked_policies(game: Any, policies: Any) -> tuple[Reals, Reals]:
    """The policies of both players in what is known to be a game, each checked as in `checked_policy`.

    Raises:
        ValueError: they are not two, or one of them is something else.
    """
    if not isinstance(policies, tuple | list) or len(policies) != 2:
        several = isinstance(policies, list) and policies and isinstance(policies[-1], tuple)
        hint = ": those of a run are run.policies[-1]" if several or hasattr(policies, "policies") else ""
        raise ValueError(
            f"policies must be a pair of tables, one of player 0 and one of player 1, but is {in_short(policies)}{hint}"
        )
    first, second = policies
    return fitting_policy(game, 0, first, "policies"), fitting_policy(game, 1, second, "policies")


def draw_from(policy: Reals, observation: int, rng: Random) -> int:
    """An action drawn with the probabilities in one row of a policy."""
    left = rng.random()
    for action in range(policy.shape[1] - 1):
        left -= policy[observation, action]
        if left < 0.0:
            return action
    return policy.shape[1] - 1
