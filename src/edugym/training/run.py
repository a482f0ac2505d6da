"""What one training run produces."""

from dataclasses import dataclass
from typing import Any

from edugym.mdp.protocol import Integers, Reals


@dataclass(frozen=True)
class Run:
    """What one training run produced.

    Attributes:
        steps: shape (n_points,): the number of training steps from the start of the run to each point of the curve. The
            first point, if there is one, is at 0.
        returns: shape (n_points,): the mean undiscounted return of the evaluation episodes, played with `greedy` if the
            agent has this method, else with `act`.
        training_returns: shape (n_points,): the mean undiscounted return of the training episodes that ended since the
            previous point; NaN where none ended. In these episodes the agent explores.
        episodes: shape (n_points,): the number of training episodes that ended since the previous point.
        agent: the trained agent. It shares its tables with the agent that you passed in, so training changes your agent
            too.
        seed: the seed from which every random stream of this run comes.
        seconds: the time it took, with compiling and evaluating.
        complete: False if it was stopped before its last point.
    """

    steps: Integers
    returns: Reals
    training_returns: Reals
    episodes: Integers
    agent: Any
    seed: int
    seconds: float
    complete: bool
