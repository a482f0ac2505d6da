"""Small tasks with closed forms, random models, and the values of a policy by linear algebra."""

import numpy as np

from edugym import FiniteModel
from edugym.mdp.protocol import Reals
from tests.compiled.cells import cell

TASKS = """
class Walk(NamedTuple):
    n_actions: int = 1  # how many names there are for the only thing that can be done
    observation_space = property(lambda self: spaces.Discrete(7))
    action_space = property(lambda self: spaces.Discrete(self.n_actions))
    def initial(self, rng): return 3
    def transition(self, state, action, rng): return state + 1 if rng.random() < 0.5 else state - 1
    def reward(self, state, action, next_state, rng): return 1.0 if next_state == 6 else 0.0
    def terminal(self, state): return state in (0, 6)
    def observation(self, state, rng): return state

class Gambler(Walk):
    def initial(self, rng): return 50
    def transition(self, state, action, rng):
        stake = min(action + 1, state, 100 - state)  # cut to what there is and what is needed
        return state + stake if rng.random() < 0.4 else state - stake
    def reward(self, state, action, next_state, rng): return 1.0 if next_state == 100 else 0.0
    def terminal(self, state): return state in (0, 100)

class Loop(Walk):
    def transition(self, state, action, rng): return 3 if action == 1 else 6
    def reward(self, state, action, next_state, rng): return float(action)

class Hidden(Walk):
    observation_space = property(lambda self: spaces.Discrete(2))
    def observation(self, state, rng):
        if state == 3:
            return 0 if rng.random() < 0.75 else 1
        return int(state > 3)
"""
Walk, Gambler, Loop, Hidden = (cell(TASKS)[name] for name in ("Walk", "Gambler", "Loop", "Hidden"))
"""The random walk of example 6.2: from the middle of five states, left or right by chance; 1 for the right end.

The gambler's problem of example 4.3: stake 1 to 50 of one's capital; heads with probability 0.4; 100 pays 1.
One state that pays 1 for staying (action 1) and nothing for the end (action 0).
The random walk seen through fog: the agent observes only in which half it is, at the middle by chance.
"""
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
