"""A toy with moods: what it needs cannot be remembered, since it also depends on chance."""

from typing import Any, NamedTuple

import numpy as np

from edugym.envs.tamagotchi import Tamagotchi, Toy, happiness
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.wrapper import wrapper


@wrapper
class Moody(NamedTuple):
    """A toy that now and then needs something all of a sudden."""

    mdp: Any  # the toy
    moods: float  # the probability of a mood in a step
    drop: int  # by how much one of the four variables falls then

    def transition(self, state: Toy, action: int, rng: Random) -> Any:
        """After the step, a variable that is drawn at random falls; then the toy says anew what it wants."""
        toy = self.mdp.transition(state, action, rng)
        if rng.random() < self.moods:
            need = int(rng.random() * 4)
            variables = (
                max(toy.variables[0] - self.drop * (need == 0), 0),
                max(toy.variables[1] - self.drop * (need == 1), 0),
                max(toy.variables[2] - self.drop * (need == 2), 0),
                max(toy.variables[3] - self.drop * (need == 3), 0),
            )
            toy = self.mdp.settled(variables, toy.hp, rng)
        return toy


def best_return(moods: float, drop: int, steps: int = 100) -> float:
    """Return the best expected return of a player who knows the variables and the need, by planning backwards.

    The variables are multiples of 5. The end at 0 hit points is left out, which no good player reaches.

    Args:
        moods: the probability of a mood.
        drop: by how much a variable falls; a multiple of 5.
        steps: the length of an episode.
    """
    grid = np.arange(21)
    places = np.indices((21,) * 4)
    one = np.array([happiness((5 * int(k), 50, 50, 50)) for k in grid])
    rewards = sum(one[places[need]] for need in range(4))
    urgent = places == places.min(axis=0)
    values: Reals = np.zeros((21,) * 4)
    for _ in range(steps):
        after = rewards + values
        expected = (1.0 - moods) * after
        for need in range(4):
            expected = expected + moods / 4 * np.take(after, np.maximum(grid - drop // 5, 0), axis=need)
        values = sum(
            urgent[wanted] * np.max([_moved(expected, wanted, action) for action in range(4)], axis=0)
            for wanted in range(4)
        ) / urgent.sum(axis=0)
    return float(values[-1, -1, -1, -1])


def _moved(values: Reals, wanted: int, action: int) -> Reals:
    """Return the value of what an action makes of every state."""
    grid = np.arange(21)
    for need in range(4):
        change = (6 if need == action else -1) - (2 if action != wanted else 0)
        values = np.take(values, np.clip(grid + change, 0, 20), axis=need)
    return values


def moody_toy(moods: float = 0.1, drop: int = 20, **parameters: Any) -> Moody:
    """Return a toy with moods; other parameters are those of Tamagotchi."""
    return Moody(Tamagotchi.create(**parameters), moods, drop)
