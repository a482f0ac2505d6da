"""Looking ahead exactly, in the right model and in wrong ones, and what that is worth in the task itself."""

from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.uct import UCT
from edugym.envs.games.soccer import WEST, Soccer
from edugym.envs.supermarket import Supermarket
from edugym.exact.finite_horizon import finite_horizon
from edugym.exact.game_model import game_model
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.values import greedy_actions
from edugym.mdp.against import against
from edugym.mdp.player_policies import uniform_policy
from edugym.mdp.protocol import Reals
from edugym_course.lessons.search.methods import DEPTH, DISCOUNT, DOOR, MAX_STEPS, OPTIMUM, model_of_map, returns

DEPTHS = (1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 30)
SOCCER_DEPTHS = (1, 2, 3, 4, 5, 6, 8, 10, 20)
SOCCER_C = 1.0
"""c in soccer, where a game brings -1, 0 or 1."""


def looking_ahead(
    planned: FiniteModel, truth: FiniteModel, depths: Sequence[int] = DEPTHS, discount: float = DISCOUNT
) -> Reals:
    """Return what it is worth to look so many steps ahead before each step, exactly.

    Args:
        planned: the model in which is looked ahead. It has the states of the truth, and perhaps more.
        truth: the model of the task that is played, for at most 100 steps.
        depths: the numbers of steps.
        discount: γ of the look-ahead; what counts in the task is the return without a discount.

    Returns:
        Shape (n_depths,): the expected returns. Of equally good actions one is drawn.
    """
    values = finite_horizon(planned, max(depths), discount)
    rows = [planned.row(state) for state in truth.states]
    policies = (greedy_actions(values[depth].Q[rows]) for depth in depths)
    return np.array([policy_evaluation(truth, policy, horizon=MAX_STEPS).start for policy in policies])


def in_the_shop(
    door: tuple[int, int] | None = None, depths: Sequence[int] = DEPTHS, discount: float = DISCOUNT
) -> Reals:
    """Return what looking ahead is worth in the supermarket; with a door, on an old map."""
    return looking_ahead(model_of_map(door), model_of_map(), depths, discount)


def with_errors(layout_seed: int, depths: Sequence[int], noise: float = 1.0, *, steps_pay: bool = True) -> Reals:
    """Return what looking ahead is worth in a model whose rewards have errors, drawn by a seed.

    Args:
        layout_seed: draws the errors.
        depths: the numbers of steps.
        noise: their standard deviation.
        steps_pay: whether a step may seem to pay; if not, what costs in truth costs 0.01 or more in the model, too.
    """
    truth = model_of_map()
    planned = Supermarket.create(noise, layout_seed=layout_seed).distorted(truth)
    if not steps_pay:
        capped = np.where(truth.rewards < 0, np.minimum(planned.rewards, -0.01), planned.rewards)
        planned = planned._replace(rewards=capped)
    return looking_ahead(planned, truth, depths)


def random_play(depth: int = DEPTH, discount: float = DISCOUNT) -> float:
    """Return what plain roll-outs come to with more and more simulations, exactly.

    Their values are then those of random play for so many steps, and the best action by these is taken.
    """
    model = model_of_map()
    uniform = np.full(model.successors.shape[:2], 1 / model.successors.shape[1])
    best = policy_evaluation(model, uniform, discount, horizon=depth).greedy_policy()
    return policy_evaluation(model, best, horizon=MAX_STEPS).start


class Sweeps(NamedTuple):
    """Numbers of sweeps of value iteration over the shop.

    Attributes:
        from_entrance: after so many, whoever follows the values from the entrance on gets the best return.
        everywhere: after so many, the best actions by the values are the best ones in every state.
        pairs: the pairs of a state and an action that a sweep asks the model about.
    """

    from_entrance: int
    everywhere: int
    pairs: int


def sweeps_needed(discount: float = DISCOUNT) -> Sweeps:
    """Return how many sweeps of value iteration the shop needs."""
    model, numbers = model_of_map(), range(1, MAX_STEPS + 1)
    Q = [values.Q for values in finite_horizon(model, MAX_STEPS, discount)]
    is_best = Q[-1] >= Q[-1].max(axis=1, keepdims=True) - 1e-9
    worth = in_the_shop(None, numbers, discount)
    return Sweeps(
        from_entrance=next(d for d in numbers if worth[d - 1] > OPTIMUM - 1e-9),
        everywhere=next(
            d for d in numbers if is_best[(greedy_actions(Q[d]) > 0) & ~model.terminal[:, np.newaxis]].all()
        ),
        pairs=int((~model.terminal).sum()) * is_best.shape[1],
    )


def mending(depth: int, door: tuple[int, int] = DOOR, discount: float = DISCOUNT) -> float:
    """Return what one gets who looks ahead on an old map, and writes into it what the own steps show."""
    planned, truth = model_of_map(door), model_of_map()
    planned = planned._replace(successors=planned.successors.copy(), rewards=planned.rewards.copy())
    Q = finite_horizon(planned, depth, discount)[depth].Q
    s, total = int(truth.initial.argmax()), 0.0
    for _ in range(MAX_STEPS):
        row = planned.row(truth.states[s])
        action = int(Q[row].argmax())
        after, reward = truth.successors[s, action, 0], float(truth.rewards[s, action, 0])
        if planned.states[planned.successors[row, action, 0]] != truth.states[after]:
            planned.successors[row, action, 0] = planned.row(truth.states[after])
            planned.rewards[row, action, 0] = reward
            Q = finite_horizon(planned, depth, discount)[depth].Q
        total += reward
        s = int(after)
        if truth.terminal[s]:
            break
    return total


class Opponents(NamedTuple):
    """Soccer for player 0, as it is thought to be and as it is.

    Attributes:
        thought: the model with an opponent who moves at random.
        real: the model with one who always runs towards the goal in which it scores.
    """

    thought: FiniteModel
    real: FiniteModel


@cache
def opponents(contact: float = 1.0) -> Opponents:
    """Return soccer against the opponent that one thinks to have, and against the real one."""
    game = Soccer.create(contact)
    model = game_model(game)
    return Opponents(model.against(0, uniform_policy(game, 1)), model.against(0, runner(game)))


def runner(game: Soccer) -> Reals:
    """Return the policy of player 1 who always runs towards the goal in which it scores."""
    policy = np.zeros_like(uniform_policy(game, 1))
    policy[:, WEST] = 1.0
    return policy


def in_soccer(knows: bool, contact: float = 1.0, depths: Sequence[int] = SOCCER_DEPTHS) -> Reals:
    """Return what looking ahead is worth against the runner, for one who knows it and for one who does not."""
    thought, real = opponents(contact)
    return looking_ahead(real if knows else thought, real, depths)


def simulated_in_soccer(simulations: int, contact: float = 1.0, **how: Any) -> Reals:
    """Return what UCT gets in games against the runner, whom it knows; other arguments as in `returns`."""
    game = Soccer.create(contact)
    mdp = against(game, 0, runner(game))
    settings: dict[str, Any] = {"simulations": simulations, "depth": DEPTH, "c": SOCCER_C, "discount": DISCOUNT}
    return returns(mdp, UCT.create(mdp, model=finite_model(mdp), **settings), **how)
