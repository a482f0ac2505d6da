"""The policy that a player has learned, as a table that `exploitability` takes."""

from typing import Any

import numpy as np

from edugym.checks.agents import checked_agent
from edugym.checks.contract import Contract
from edugym.checks.parameters import whole_number
from edugym.compiled.execution import executable
from edugym.mdp.against import against
from edugym.mdp.markov_game import a_player, require_game, sizes
from edugym.mdp.player_policies import fitting_policy, uniform_policy
from edugym.mdp.protocol import Reals
from edugym.system.interrupts import deferring_signals
from edugym.training.evaluated import actor
from edugym.training.game_loops import count_actions
from edugym.training.player_contract import player_contract

DRAWS, MOST_DRAWS = 100, 1_000_000


def learned_policy(game: Any, player: int, agent: Any, *, draws: int = DRAWS, seed: int = 0) -> Reals:
    """The policy of an agent as a player of a game: shape (n_observations, n_actions).

    If the agent has a `policy` (an array of that shape, such as that of `MinimaxQ`), it is this. Otherwise the agent is
    asked `draws` times for its action at each observation, with `greedy` if it has it, else `act` of a copy, and the
    shares are returned. They are exact for a deterministic policy; a random one is off by about 0.5 / sqrt(draws).

    Args:
        game: the game.
        player: which player the agent is, 0 or 1.
        agent: the agent.
        draws: how often to ask, from 1 to 1 000 000.
        seed: of the random stream for it.

    Raises:
        ValueError: a parameter is not as above, or the agent's policy does not fit the game.
    """
    require_game(game)
    draws, seed = whole_number("draws", draws, 1, MOST_DRAWS), whole_number("seed", seed, 0)
    return policy_of(game, a_player(player), agent, draws, seed)


def policy_of(game: Any, player: int, agent: Any, draws: int = DRAWS, seed: int = 0) -> Reals:
    """`learned_policy` in what is known to be a game.

    Raises:
        ValueError: the agent, or the policy that it has, does not fit.
    """
    contract = player_contract(game, player, agent)
    if has_policy(contract):
        return np.array(fitting_policy(game, player, contract.agent.policy))
    shape, rng = sizes(game, player), np.random.default_rng(seed)
    asked, counts = actor(contract), np.zeros(shape)
    if not contract.is_own:
        asked = checked_agent(asked, against(game, player, uniform_policy(game, 1 - player)), steps=0)
    count = count_actions
    if contract.is_own:
        count = executable(count_actions, (asked, draws, rng, counts), expected=shape[0] * draws)
    with deferring_signals(machine_code=count is not count_actions):
        count(shape[0], asked, draws, rng, counts)
    return counts / draws


def has_policy(contract: Contract) -> bool:
    """Whether an agent says itself what its policy is."""
    return isinstance(getattr(contract.agent, "policy", None), np.ndarray | list)
