"""The exact model of a Markov game: against a fixed policy the game is an MDP, which planning solves."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.games import CheckedGame
from edugym.checks.parameters import in_short
from edugym.exact.model import MAX_STATES, finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.markov_game import a_player, n_actions, require_game
from edugym.mdp.player_policies import checked_policies, fitting_policy, uniform_policy
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.system.packages import is_own


class JointGame(NamedTuple):
    """The game as an MDP in which one mind moves both players, and is rewarded as one of them.

    Its action is n b + a for the action a of this player, the action b of the other and this player's n actions.

    Attributes:
        game: the game.
        player: whose rewards count, and whose observations are seen.
        n: how many actions this player has.
    """

    game: Any
    player: int
    n: int

    def initial(self, rng: Random) -> Any:
        """As in the game."""
        return self.game.initial(rng)

    def transition(self, state: Any, action: int, rng: Random) -> Any:
        """As in the game."""
        return self.game.transition(state, self.actions(action), rng)

    def reward(self, state: Any, action: int, next_state: Any, rng: Random) -> Any:
        """That of the player."""
        return self.game.rewards(state, self.actions(action), next_state, rng)[self.player]

    def terminal(self, state: Any) -> Any:
        """As in the game."""
        return self.game.terminal(state)

    def observation(self, state: Any, rng: Random) -> Any:
        """What the player sees."""
        return self.game.observation(state, self.player, rng)

    @property
    def observation_space(self) -> Any:
        """That of the player."""
        return self.game.observation_space(self.player)

    @property
    def action_space(self) -> spaces.Discrete:
        """Every pair of actions."""
        return spaces.Discrete(n_actions(self.game, 0) * n_actions(self.game, 1))

    def actions(self, action: int) -> tuple[int, int]:
        """The actions of players 0 and 1."""
        other, own = divmod(action, self.n)
        return (own, other) if self.player == 0 else (other, own)


@dataclass(frozen=True, eq=False, repr=False)
class GameModel:
    """The tables of a finite Markov game, as `game_model` makes them.

    Attributes:
        game: the game.
        joint: for each player the model of its `JointGame`. Both have the same states.
    """

    game: Any
    joint: tuple[FiniteModel, FiniteModel]
    _seen: dict[int, Integers] = field(default_factory=dict)

    def __repr__(self) -> str:
        """What it is a model of, and its sizes."""
        n_states, n_pairs, _ = self.joint[0].successors.shape
        return f"<model of the game {type(self.game).__name__}: {n_states} states, {n_pairs} pairs of actions>"

    def by_state(self, player: int, policy: Any) -> Reals:
        """The policy of a player by the rows of the model, shape (S, A), from one by its observations.

        Raises:
            ValueError: a parameter is not as it must be, or what the player observes is random.
        """
        table: Reals = fitting_policy(self.game, a_player(player), policy)[self._observations(player)]
        return table

    def by_observation(self, player: int, policy: Reals) -> Reals:
        """The policy of a player by its observations from one by the rows of the model; else random actions.

        Raises:
            ValueError: two states look the same to the player, and the policy is another one there.
        """
        rows = np.flatnonzero(~self.joint[player].terminal)
        table, seen = uniform_policy(self.game, player), self._observations(player)[rows]
        table[seen] = policy[rows]
        for s, other in zip(rows.tolist(), table[seen], strict=True):
            if not np.array_equal(other, policy[s]):
                state = self.joint[player].states[s]
                raise ValueError(
                    f"player {player} must see the state, but to it {state!r} looks like a state of another policy"
                )
        return table

    def against(self, player: int, policy: Any) -> FiniteModel:
        """The model of the MDP that a player is in while the other follows a fixed policy, for planning.

            p(s'|s, a) = Σ_b ρ(b|s) p(s'|s, a, b)

        It gives the values of `edugym.games.against` in fewer states: here a state need not say what the other player
        did last.

        Args:
            player: who acts: 0 or 1.
            policy: ρ of the other player, by its observations: shape (n_observations, n_actions).

        Raises:
            ValueError: a parameter is not as above, or what the other player observes is random.
        """
        joint, ρ = self.joint[a_player(player)], self.by_state(1 - player, policy)
        n_states, _, width = joint.successors.shape
        own, other = n_actions(self.game, player), n_actions(self.game, 1 - player)

        def by_own_action(table: Any) -> Any:
            """From (states, pairs, ways) to (states, own actions, actions of the other, ways)."""
            return table.reshape(n_states, other, own, width).swapaxes(1, 2)

        successors, rewards = by_own_action(joint.successors), by_own_action(joint.rewards)
        probabilities = by_own_action(joint.probabilities) * ρ[:, np.newaxis, :, np.newaxis]
        shape = n_states, own, other * width
        return joint._replace(
            successors=successors.reshape(shape),
            probabilities=probabilities.reshape(shape),
            rewards=rewards.reshape(shape),
            mdp=None,
        )

    def _observations(self, player: int) -> Integers:
        """Shape (S,): what a player sees in each state. Every policy asks for it, so it is worked out once."""
        if player not in self._seen:
            self._seen[player] = self.joint[player].observations()
        return self._seen[player]


def require_game_model(model: Any) -> None:
    """Refuse what is no model of a game.

    Raises:
        ValueError: it is something else.
    """
    if not isinstance(model, GameModel):
        raise ValueError(f"model must be the model of a game, as game_model(game) makes it, but is {in_short(model)}")


def game_model(game: Any, max_states: int = MAX_STATES) -> GameModel:
    """The exact model of a Markov game, worked out from its own methods as `edugym.finite_model` does it for an MDP.

    Args:
        game: the game. Its states are numbers, or (nested) tuples of numbers.
        max_states: how many states to look at before giving up, from 1 to 100 million.

    Raises:
        ValueError: `game` is no game, or it is not finite (see `edugym.finite_model`).
    """
    require_game(game)
    checked = game if is_own(game) else CheckedGame(game)
    joint = (JointGame(checked, player, n_actions(game, player)) for player in (0, 1))
    first, second = (finite_model(one, max_states) for one in joint)
    return GameModel(game, (first, second))


def expected_returns(model: GameModel, policies: Any, discount: float = 1.0) -> tuple[float, float]:
    """What each player expects from the start of an episode if both follow these policies.

    Args:
        model: the model of the game.
        policies: of players 0 and 1, by their observations: each of shape (n_observations, n_actions).
        discount: γ, from 0 to 1.

    Raises:
        ValueError: a parameter is not as above, or at discount 1 the values do not settle.
    """
    π, ρ = _checked(model, policies)
    return _expected(model, (model.against(0, ρ), model.against(1, π)), (π, ρ), discount)


def exploitability(model: GameModel, policies: Any, discount: float = 1.0) -> float:
    """What a player gains, in the mean over both, by answering the other's policy as well as possible.

        (max_π' v_0(π', ρ) - v_0(π, ρ) + max_ρ' v_1(π, ρ') - v_1(π, ρ)) / 2

    It is 0 if and only if the policies are a Nash equilibrium: nobody gains by playing something else. Against a fixed
    policy the game is an MDP (`model.against`), so value iteration finds each maximum exactly.

    Args:
        model: the model of the game.
        policies: π of player 0 and ρ of player 1, by their observations: each of shape (n_observations, n_actions).
        discount: γ, from 0 to 1.

    Raises:
        ValueError: a parameter is not as above, or at discount 1 the values do not settle.

    References: Lanctot et al. (2017), A unified game-theoretic approach to multiagent reinforcement learning, call the
    sum of both NashConv; half of it is what OpenSpiel calls exploitability.
    """
    π, ρ = _checked(model, policies)
    tasks = model.against(0, ρ), model.against(1, π)
    best = value_iteration(tasks[0], discount).start, value_iteration(tasks[1], discount).start
    gain = sum(best) - sum(_expected(model, tasks, (π, ρ), discount))
    return max(0.0, gain / 2)  # rounding can make a 0 negative


def _expected(
    model: GameModel, tasks: tuple[FiniteModel, FiniteModel], policies: tuple[Reals, Reals], discount: float
) -> tuple[float, float]:
    """What each player expects in its task, which holds the other's policy."""
    first, second = (
        policy_evaluation(task, model.by_state(player, policy), discount).start
        for player, (task, policy) in enumerate(zip(tasks, policies, strict=True))
    )
    return first, second


def _checked(model: Any, policies: Any) -> tuple[Reals, Reals]:
    """The policies, if model and policies are as they must be."""
    require_game_model(model)
    return checked_policies(model.game, policies)
