"""Tables with a vector for each pair of a state and an action."""

from typing import Annotated

from edugym.agents.settings import Table
from edugym.agents.tables import tied
from edugym.mdp.protocol import Reals

VectorValues = Annotated[Reals, Table(("states", "actions", "objectives"), fill="initial_value")]
"""Q, shape (n_states, n_actions, n_objectives)."""
OfObjectives = Annotated[Reals, Table(("objectives",))]
"""A number for each objective."""
OfActions = Annotated[Reals, Table((1, "actions"))]
"""One number for each action of the state that was looked at last, as a table with one row: strategies take that."""


def vector_of_best(Q: Reals, state: int, scores: Reals, objective: int) -> float:
    """What Q(s, a) says of one objective, for the action with the highest score; the mean over equally good ones.

    Args:
        Q: shape (n_states, n_actions, n_objectives).
        state: s.
        scores: shape (1, n_actions): the number by which the actions of s are compared.
        objective: the place in the vector.
    """
    best = scores[0, 0]
    for action in range(1, scores.shape[1]):
        best = max(best, scores[0, action])
    total = 0.0
    ties = 0
    for action in range(scores.shape[1]):
        if tied(scores[0, action], best):
            total += Q[state, action, objective]
            ties += 1
    return total / ties
