"""The interaction loop of two players and a game. It is plain Python and can be compiled, as in `training.loops`.

Game and players have random streams of their own, so the random numbers of one never depend on how many another has
drawn.
"""

from typing import Any, NamedTuple, TypeAlias

from edugym.mdp.protocol import Actor, Integers, Random, Reals

Carry: TypeAlias = tuple[Any, Any, Any, int, float, float]
"""What the loop carries from step to step: the state, what each player sees, and this episode's steps and returns."""


class GameLog(NamedTuple):
    """Sums over the training episodes that ended since the sums were last set to zero.

    Attributes:
        returns: shape (2,): the sum of the undiscounted returns of each player.
        episodes: shape (1,): how many ended.
    """

    returns: Reals
    episodes: Integers


def start(game: Any, game_rng: Random) -> Carry:
    """The carry before the first step."""
    state = game.initial(game_rng)
    return state, game.observation(state, 0, game_rng), game.observation(state, 1, game_rng), 0, 0.0, 0.0


def play(
    n_steps: int,
    game: Any,
    first: Any,
    second: Any,
    max_steps: int,
    game_rng: Random,
    first_rng: Random,
    second_rng: Random,
    log: GameLog,
    carry: Carry,
) -> Carry:
    """Take `n_steps` steps, after each of which both players learn.

    Args:
        n_steps: how many steps to take; episodes follow each other.
        game: the game.
        first: player 0, wrapped by `edugym.checks.contract.learner`.
        second: player 1, wrapped too.
        max_steps: after how many steps an episode is truncated.
        game_rng: what the game draws from.
        first_rng: what player 0 draws from.
        second_rng: what player 1 draws from.
        log: where the returns of the episodes that end are added up.
        carry: where to start: what `start` or the previous call returned.

    Returns:
        The carry after the last step.
    """
    state, seen, other_seen, steps, total, other_total = carry
    for _ in range(n_steps):
        action = first.act(seen, first_rng)
        other_action = second.act(other_seen, second_rng)
        next_state = game.transition(state, (action, other_action), game_rng)
        reward, other_reward = game.rewards(state, (action, other_action), next_state, game_rng)
        terminated = game.terminal(next_state)
        next_seen = game.observation(next_state, 0, game_rng)
        other_next_seen = game.observation(next_state, 1, game_rng)
        steps += 1
        total += reward
        other_total += other_reward
        truncated = steps == max_steps and not terminated
        first.learn(seen, action, reward, next_seen, terminated, truncated, other_action)
        second.learn(other_seen, other_action, other_reward, other_next_seen, terminated, truncated, action)
        state, seen, other_seen = next_state, next_seen, other_next_seen
        if terminated or truncated:
            log.returns[0] += total
            log.returns[1] += other_total
            log.episodes[0] += 1
            state = game.initial(game_rng)
            seen, other_seen = game.observation(state, 0, game_rng), game.observation(state, 1, game_rng)
            steps, total, other_total = 0, 0.0, 0.0
    return state, seen, other_seen, steps, total, other_total


def count_actions(n_observations: int, actor: Actor[Any], draws: int, rng: Random, counts: Reals) -> None:
    """Ask a policy `draws` times for its action at each observation, and count them.

    The shape of `counts` is (n_observations, n_actions).
    """
    for seen in range(n_observations):
        for _ in range(draws):
            counts[seen, actor.act(seen, rng)] += 1.0
