"""The policy that an agent follows, as an array that can be evaluated."""

import copy
import pickle
from functools import partial
from typing import Any

import numpy as np

from edugym.checks.contract import tables_of
from edugym.checks.parameters import in_short, true_or_false
from edugym.exact.branching import branches
from edugym.exact.tables import FiniteModel
from edugym.exact.values import require_model
from edugym.mdp.protocol import Reals
from edugym.system.packages import is_own

MAX_WAYS = 10_000
"""How many ways the choice of one action may go."""


def policy_of(agent: Any, model: FiniteModel, *, greedy: bool = False) -> Reals:
    """The policy that an agent follows now: shape (S, A), π(a|s) for every row of the model.

    The probabilities are exact: `agent.act` is followed along every way that its random numbers can go, ε-greedy steps
    and ties included. Where the observation is random, or does not tell the state, the agent acts by what it sees.

        values = policy_evaluation(model, policy_of(agent, model))

    Args:
        agent: an agent with whole numbers for observations. It is not changed, also where acting changes it (as counts
            do): the policy is that of its next action in each state.
        model: the model of its task.
        greedy: whether to follow `agent.greedy`, where it has that, instead of `act`.

    Returns:
        The probabilities; in terminal states, where nothing is chosen, those of random actions.

    Raises:
        ValueError: `agent` cannot act, was made for another task, chooses an action that is not there, or draws what
            cannot be followed; or the observations are not whole numbers.
    """
    true_or_false("greedy", greedy)
    choose_name = "greedy" if greedy and hasattr(agent, "greedy") else "act"
    if isinstance(agent, type) or not hasattr(agent, choose_name):
        raise ValueError(f"agent must be an agent, with a method act(state, rng), but is {in_short(agent)}")
    require_model(model)
    task = model.table_task()
    n_states, n_actions, _ = model.successors.shape
    _require_tables(agent, (int(task.observation_space.n), n_actions))
    acting = copy.deepcopy(agent)
    changes = False

    def choose(observation: int, rng: Any) -> Any:
        actor = copy.deepcopy(agent) if changes else acting
        try:
            return getattr(actor, choose_name)(observation, rng)
        except IndexError as error:
            shape = f"{task.observation_space.n} observations and {n_actions} actions"
            raise ValueError(f"agent must be one for {shape}, as the model has: for {observation}, {error}") from error

    def chosen(observation: int) -> Reals:
        """Shape (A,): the probability of every action, given what is observed."""
        probabilities = np.zeros(n_actions)
        for way, (p, action) in enumerate(branches(lambda rng: choose(observation, rng))):
            if way == MAX_WAYS:
                raise ValueError(f"the agent's choice can go more than {MAX_WAYS} ways: are many actions equally good?")
            if isinstance(action, bool) or not isinstance(action, int | np.integer) or not 0 <= action < n_actions:
                raise ValueError(
                    f"{choose_name} must return an action from 0 to {n_actions - 1}, but returns {action!r}"
                )
            probabilities[action] += p
        return probabilities

    def followed() -> Reals:
        known: dict[int, Reals] = {}
        policy = np.full((n_states, n_actions), 1 / n_actions)
        for s in np.flatnonzero(~model.terminal).tolist():
            policy[s] = 0.0
            for p, observation in branches(partial(task.observation, model.states[s])):
                if observation not in known:
                    known[observation] = chosen(observation)
                policy[s] += p * known[observation]
        return policy

    before = _contents(acting)
    policy = followed()
    changes = before is None or _contents(acting) != before
    return followed() if changes else policy


def _require_tables(agent: Any, shape: tuple[int, int]) -> None:
    """Refuse an agent of the package that was made for another task."""
    own = is_own(agent) and getattr(agent, "tabular", True)
    for name, table in tables_of(agent).items() if own else ():
        if name in ("Q", "preferences") and table.shape[-2:] != shape:
            raise ValueError(
                f"agent must have a table {name} of shape {shape}, as the model has, but its is {table.shape}"
            )


def soft(policy: Reals, epsilon: float) -> Reals:
    """The policy that takes a random action with probability ε, and else follows another one; both of shape (S, A)."""
    mixed: Reals = (1 - epsilon) * policy + epsilon / policy.shape[1]
    return mixed


def _contents(agent: Any) -> bytes | None:
    """What an agent holds, to see whether acting changes it; None where that cannot be told."""
    try:
        return pickle.dumps(agent)
    except (pickle.PicklingError, TypeError, AttributeError):
        return None
