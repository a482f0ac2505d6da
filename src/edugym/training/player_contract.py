"""The gate for what users give as a player of a game."""

from typing import Any

from edugym.checks.contract import IN_GAMES, Contract, contract_of, tables_of
from edugym.checks.interfaces import class_name
from edugym.mdp.markov_game import sizes


def player_contract(game: Any, player: int, agent: Any) -> Contract:
    """The contract of an agent that is a player of what is known to be a game.

    Raises:
        ValueError: it is no agent, it learns from its next action, or its tables do not fit the game.
    """
    own, contract = sizes(game, player), contract_of(agent, IN_GAMES)
    joint = *own, sizes(game, 1 - player)[1]
    if not contract.tabular:
        raise ValueError(f"player {player} must be an agent with tables, but is a {class_name(contract.agent)}")
    for name, table in tables_of(contract.agent).items():
        fitting = joint if table.ndim == 3 else own
        if name in ("Q", "preferences") and table.shape != fitting:
            raise ValueError(
                f"{name} of player {player} must have the shape {fitting} in this game, but its shape is {table.shape}"
            )
    return contract
