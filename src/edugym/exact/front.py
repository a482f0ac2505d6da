"""The exact Pareto front of a task without chance, by dynamic programming with sets of vectors."""

from typing import Any, NamedTuple, TypeAlias

import numpy as np

from edugym.checks.parameters import between
from edugym.exact.model import finite_model
from edugym.exact.points import pareto_front
from edugym.exact.tables import FiniteModel
from edugym.mdp.multi_objective import require_objectives, vector
from edugym.mdp.protocol import Reals

DIGITS = 9
"""Returns that agree in so many digits after the point count as one: the order of a sum changes the last digits."""
MOST_SWEEPS = 10_000
Numbers: TypeAlias = tuple[float, ...]
Found: TypeAlias = dict[Numbers, tuple[Numbers, tuple[int, ...]]]
"""For each rounded return that a state can give, the return and the actions for it."""


class Front(NamedTuple):
    """A Pareto front, and how to get to each of its points.

    Attributes:
        returns: shape (n_points, n_objectives): the returns, ascending in the first objective.
        actions: the actions of an episode with each of these returns.
    """

    returns: Reals
    actions: tuple[tuple[int, ...], ...]


def exact_front(mdp: Any, discount: float = 1.0) -> Front:
    """The Pareto front of all policies that use no chance, by value iteration with a set of vectors for each state.

        V(s) <- the Pareto-optimal ones of { r(s, a, s') + γ v : v in V(s'), for each action a that leads to an s' }

    After h sweeps V(s) are the returns of h more steps, so it ends at the step limit, `max_steps`, or as soon as
    nothing changes. (A policy that tosses a coin at the start of an episode has a mean return between two points.)

    Args:
        mdp: a finite task without chance, with a method `rewards` (see `edugym.mdp.multi_objective`), such as `Diver`.
        discount: γ, from 0 to 1.

    Raises:
        ValueError: `mdp` is no such task, the discount is out of range, or the returns do not settle in 10 000 sweeps.

    References: White (1982), Multi-objective infinite-horizon discounted Markov decision processes.
    """
    mdp = require_objectives(mdp)
    gamma = between("discount", discount, 0, 1)
    model = finite_model(mdp)
    successors = _successors(model)  # shape (S, A)
    n_states, n_actions = successors.shape
    n_objectives = mdp.reward_space.shape[0]
    rewards = np.zeros((n_states, n_actions, n_objectives))
    for s in np.flatnonzero(~model.terminal):
        for a in range(n_actions):
            rewards[s, a] = vector(mdp, model.states[s], a, model.states[successors[s, a]])
    nothing = (0.0,) * n_objectives
    V: list[Found] = [{nothing: (nothing, ())} for _ in range(n_states)]
    limit = getattr(mdp, "max_steps", None) or MOST_SWEEPS + 1
    for _ in range(min(limit, MOST_SWEEPS)):
        improved = [
            V[s] if model.terminal[s] else _one_step(rewards[s], [V[n] for n in successors[s]], gamma)
            for s in range(n_states)
        ]
        if all(new.keys() == old.keys() for new, old in zip(improved, V, strict=True)):
            break
        V = improved
    else:
        if limit > MOST_SWEEPS:
            raise ValueError(
                f"mdp must be a task whose returns settle, but they still change after {MOST_SWEEPS} steps"
            )
    best = sorted(V[int(model.initial.argmax())].values())
    return Front(np.array([returns for returns, _ in best]), tuple(actions for _, actions in best))


def _one_step(rewards: Reals, later: list[Found], gamma: float) -> Found:
    """The Pareto-optimal returns of a state.

    Args:
        rewards: shape (A, n_objectives): the vector of rewards of each action.
        later: what the state after each action can give.
        gamma: the discount.
    """
    ways: Found = {}
    for action, after in enumerate(later):
        for returns, actions in after.values():
            total = tuple(float(r) + gamma * v for r, v in zip(rewards[action], returns, strict=True))
            ways.setdefault(tuple(round(one, DIGITS) for one in total), (total, (action, *actions)))
    keys = list(ways)
    optimal = pareto_front(keys)
    return {key: ways[key] for key, is_optimal in zip(keys, optimal, strict=True) if is_optimal}


def _successors(model: FiniteModel) -> Any:
    """Shape (S, A): the row of the state after each action; tasks with chance are refused."""
    by_chance = ((model.probabilities > 0).sum(axis=2) > 1).any()
    if by_chance or (model.initial > 0).sum() > 1:
        where = "transition" if by_chance else "initial"
        raise ValueError(
            f"mdp must be a task without chance, but what {where} of {type(model.mdp).__name__} does varies"
        )
    return np.take_along_axis(model.successors, model.probabilities.argmax(axis=2)[..., np.newaxis], axis=2)[..., 0]
