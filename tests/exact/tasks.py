"""Small tasks with closed forms, random models, and the values of a policy by linear algebra."""

from typing import NamedTuple

import numpy as np
from gymnasium import spaces

from edugym import FiniteModel
from edugym.mdp.protocol import Random, Reals


class Walk(NamedTuple):
    """The random walk of example 6.2: from the middle of five states, left or right by chance; 1 for the right end.

    Attributes:
        n_actions: how many names there are for the only thing that can be done.
    """

    n_actions: int = 1

    def initial(self, rng: Random) -> int:
        """The middle."""
        return 3

    def transition(self, state: int, action: int, rng: Random) -> int:
        """One step to either side."""
        return state + 1 if rng.random() < 0.5 else state - 1

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """1 at the right end."""
        return 1.0 if next_state == 6 else 0.0

    def terminal(self, state: int) -> bool:
        """Either end."""
        return state in (0, 6)

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """Five states and two ends."""
        return spaces.Discrete(7)

    @property
    def action_space(self) -> spaces.Discrete:
        """All the same here."""
        return spaces.Discrete(self.n_actions)


class Gambler(Walk):
    """The gambler's problem of example 4.3: stake 1 to 50 of one's capital; heads with probability 0.4."""

    __slots__ = ()

    def initial(self, rng: Random) -> int:
        """Half of what is wanted."""
        return 50

    def transition(self, state: int, action: int, rng: Random) -> int:
        """The stake is won or lost; it is cut to what there is and what is needed."""
        stake = min(action + 1, state, 100 - state)
        return state + stake if rng.random() < 0.4 else state - stake

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """1 for reaching 100."""
        return 1.0 if next_state == 100 else 0.0

    def terminal(self, state: int) -> bool:
        """Ruin, or 100."""
        return state in (0, 100)


class Loop(Walk):
    """One state that pays 1 for staying (action 1) and nothing for the end (action 0)."""

    __slots__ = ()

    def transition(self, state: int, action: int, rng: Random) -> int:
        """Stay in 3, or go to the end."""
        return 3 if action == 1 else 6

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """1 for staying."""
        return float(action)


class Hidden(Walk):
    """The random walk seen through fog: the agent observes only in which half it is, at the middle by chance."""

    __slots__ = ()

    def observation(self, state: int, rng: Random) -> int:
        """0 on the left, 1 on the right; the middle looks like the left three times of four."""
        if state == 3:
            return 0 if rng.random() < 0.75 else 1
        return int(state > 3)

    @property
    def observation_space(self) -> spaces.Discrete:
        """Left or right."""
        return spaces.Discrete(2)


LOOP, GAMBLER = Loop(2), Gambler(50)


def random_model(seed: int, n_states: int = 4, n_actions: int = 2) -> FiniteModel:
    """A model with random numbers, in which every state leads to every state, but the last, which is the end."""
    rng = np.random.default_rng(seed)
    p = rng.dirichlet(np.ones(n_states), (n_states, n_actions))
    rewards = rng.normal(size=p.shape)
    initial, terminal = rng.dirichlet(np.ones(n_states)), np.arange(n_states) == n_states - 1
    p[-1], rewards[-1] = terminal, 0.0
    successors = np.broadcast_to(np.arange(n_states), p.shape).copy()
    states = tuple(range(n_states))
    return FiniteModel(states, dict(enumerate(states)), initial, terminal, successors, p, rewards)


def value_of(model: FiniteModel, policy: Reals, discount: float) -> Reals:
    """The values of a policy, shape (S, A), by solving its linear equations: V = r + γ P V."""
    P = np.einsum("sa,san->sn", policy, model.p)
    r = np.einsum("sa,sa->s", policy, model.r)
    going_on = ~model.terminal
    V = np.zeros(len(r))
    inside = np.eye(going_on.sum()) - discount * P[np.ix_(going_on, going_on)]
    V[going_on] = np.linalg.solve(inside, r[going_on])
    return V
