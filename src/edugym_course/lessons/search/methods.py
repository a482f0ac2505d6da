"""What lesson 18 does: agents that search in a model of the supermarket before each step."""

import threading
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.agents.q_learning import QLearning
from edugym.agents.tables import random_action
from edugym.agents.uct import UCT
from edugym.compiled.execution import executable
from edugym.envs.supermarket import FLOOR, Supermarket
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Random, Reals
from edugym.training.loops import play_episodes
from edugym.training.train import train
from edugym_course.lessons.maximisation_bias.methods import seeds

SIMULATIONS, DEPTH, C, DISCOUNT = 1_000, 20, 10.0, 0.95
NUMBERS = (30, 100, 300, 1_000, 3_000)
"""Numbers of simulations in the figure."""
MAX_STEPS, REPETITIONS = 100, 100
OPTIMUM = 95.0
BRANCHES = (4, 8, 16)
"""Numbers of actions. Four of them are the directions."""
DOOR = (7, 3)
"""The cell of the wall (row, column) in which the old map shows a door."""
LEARNING_STEPS = SIMULATIONS * DEPTH
"""The steps of Q-learning: the most that UCT simulates before one step of its own."""


class Crowd(NamedTuple):
    """The supermarket with more actions, which bring nothing new.

    Attributes:
        shop: the supermarket.
        n_actions: how many there are, 4 or more; the first four are those of the supermarket.
        copies: whether action a does the same as a mod 4; else every further action stands still, for -1.
        max_steps: the number of steps after which an episode is cut off.
    """

    shop: Supermarket
    n_actions: int
    copies: bool = False
    max_steps: int = MAX_STEPS

    def initial(self, rng: Random) -> int:
        """As in the supermarket."""
        return self.shop.initial(rng)

    def transition(self, state: int, action: int, rng: Random) -> int:
        """As in the supermarket; further actions repeat it, or stand still."""
        if action < 4 or self.copies:
            return self.shop.transition(state, action % 4, rng)
        return state

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """As in the supermarket."""
        return self.shop.reward(state, action, next_state, rng)

    def terminal(self, state: int) -> bool:
        """As in the supermarket."""
        return self.shop.terminal(state)

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """As in the supermarket."""
        return self.shop.observation_space

    @property
    def action_space(self) -> spaces.Discrete:
        """So many actions."""
        return spaces.Discrete(self.n_actions)


class Searching(NamedTuple):
    """A player that takes the best action by its agent's search.

    Attributes:
        agent: searches in its own model, whatever it plays in.
    """

    agent: UCT

    def act(self, state: int, rng: Random) -> int:
        """Search, and take the action with the highest value."""
        return self.agent.greedy(state, rng)


class KnownLeaves(UCT):
    """UCT that is told what a new node is worth, in place of a roll-out: its Q holds this for each state."""

    def roll_out(self, state: int, steps: int, rng: Random) -> float:
        """The value that it was told."""
        return float(self.Q[state, 0])


class HighestReturns(KnownLeaves):
    """The same, and the value of an action is the highest of the returns that followed it, not their mean."""

    def back_up(self, steps: int, G: float) -> None:
        """Keep the highest return of each action on the path."""
        for step in range(steps - 1, -1, -1):
            node, action = self.tree.path_nodes[step], self.tree.path_actions[step]
            G = self.tree.path_rewards[step] + self.discount * G
            known = self.tree.values[node, action] if self.tree.counts[node, action] > 1 else G
            self.tree.values[node, action] = max(known, G)


class FourInRollOuts(UCT):
    """UCT whose roll-outs draw from the four directions only, whatever other actions there are."""

    def roll_out(self, state: int, steps: int, rng: Random) -> float:
        """The return of random directions."""
        return rolled_out(self, 4, state, steps, rng)


class SixteenInRollOuts(UCT):
    """UCT that has four actions, and whose roll-outs draw from sixteen, of which twelve stand still."""

    def roll_out(self, state: int, steps: int, rng: Random) -> float:
        """The return of random directions, and of standing still in three of four steps."""
        return rolled_out(self, 16, state, steps, rng)


def rolled_out(search: UCT, n_actions: int, state: int, steps: int, rng: Random) -> float:
    """Return what random actions get, out of so many; those that the search does not have stand still, for -1."""
    model, G, weight = search.model, 0.0, 1.0
    for _ in range(steps, search.depth):
        action = random_action(n_actions, rng)
        if action >= search.Q.shape[1]:
            G -= weight
        else:
            outcome = model.sample(state, action, rng)
            G += weight * float(model.rewards[outcome])
            if model.ends[outcome] == 1:
                return G
            state = int(model.next_states[outcome])
        weight *= search.discount
    return G


def shop() -> Supermarket:
    """Return the supermarket, with episodes of at most 100 steps."""
    return Supermarket.create(max_steps=MAX_STEPS)


def old_map(door: tuple[int, int] = DOOR) -> Supermarket:
    """Return the supermarket as it is on an old map, which shows a door where there is a wall."""
    cells = shop().cells.copy()
    cells[door] = FLOOR
    return shop()._replace(cells=cells)


@cache
def crowd(n_actions: int, copies: bool = False) -> Crowd:
    """Return the supermarket with so many actions, the same object each time."""
    return Crowd(shop(), n_actions, copies)


@cache
def model_of_crowd(n_actions: int, copies: bool = False) -> FiniteModel:
    """Return its exact model."""
    return finite_model(crowd(n_actions, copies))


@cache
def model_of_map(door: tuple[int, int] | None = None) -> FiniteModel:
    """Return the exact model of the supermarket, or of the one on an old map."""
    return finite_model(shop() if door is None else old_map(door))


def searcher(model: FiniteModel, **settings: Any) -> UCT:
    """Return an agent that searches in a model, with the settings of the lesson unless others are given.

    With `nodes=1` it has no tree: plain roll-outs.
    """
    how: dict[str, Any] = {"simulations": SIMULATIONS, "depth": DEPTH, "c": C, "discount": DISCOUNT}
    return UCT.create(model.mdp, model=model, **{**how, **settings})


def returns(
    mdp: Any,
    agent: UCT,
    *,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
) -> Reals:
    """Let an agent play single episodes, and return what it gets in each.

    Args:
        mdp: what it plays in.
        agent: searches before each step.
        repetitions: how many episodes, each with random numbers of its own.
        seed: of the repetitions.
        stop: set by whoever wants no more.
    """
    found = []
    for number in seeds(seed, repetitions, stop):
        of_mdp, of_agent = (np.random.default_rng([number, part]) for part in range(2))
        total = np.zeros(1)
        how = mdp, Searching(agent), mdp.max_steps, of_mdp, of_agent, total
        executable(play_episodes, how, rehearsed=1)(1, *how)
        found.append(total[0])
    return np.array(found)


def searched(*, door: tuple[int, int] | None = None, **settings: Any) -> Reals:
    """Return what a search gets in the supermarket; with a door, it searches in an old map.

    Args:
        door: the cell of the door.
        **settings: those of `returns` and of `searcher`.
    """
    how = {name: settings.pop(name) for name in ("repetitions", "seed", "stop") if name in settings}
    return returns(shop(), searcher(model_of_map(door), **settings), **how)


@cache
def worth(play: str, door: tuple[int, int] | None = None) -> Reals:
    """Return what each state of the supermarket is worth, exactly, if from there on one plays "at random" or "well".

    With a door, it is what the old map says.
    """
    model = model_of_map(door)
    if play == "well":
        values = value_iteration(model, DISCOUNT).V
    else:
        values = policy_evaluation(
            model, np.full(model.successors.shape[:2], 1 / model.successors.shape[1]), DISCOUNT
        ).V
    table = np.zeros(int(shop().observation_space.n))
    table[[int(state) for state in model.states]] = values
    return table


def told(play: str, *, door: tuple[int, int] | None = None, highest: bool = False, **settings: Any) -> Reals:
    """Return what UCT gets that is told what new nodes are worth if one plays so.

    Args:
        play: "well", or "at random".
        door: where the map shows a door that is bricked up, if anywhere.
        highest: whether the value of an action is the highest of its returns, not their mean.
        **settings: other arguments as in `searched`.
    """
    how = {name: settings.pop(name) for name in ("repetitions", "seed", "stop") if name in settings}
    agent = (HighestReturns if highest else KnownLeaves)(*searcher(model_of_map(door), **settings))
    agent.Q[:] = worth(play, door)[:, np.newaxis]
    return returns(shop(), agent, **how)


def in_crowd(n_actions: int, *, copies: bool = False, **settings: Any) -> Reals:
    """Return what a search gets where there are so many actions; arguments as in `searched`."""
    how = {name: settings.pop(name) for name in ("repetitions", "seed", "stop") if name in settings}
    return returns(crowd(n_actions, copies), searcher(model_of_crowd(n_actions, copies), **settings), **how)


def idle_only_in(where: str, **settings: Any) -> Reals:
    """Return what UCT gets if twelve actions that stand still are only in its "tree", or only in its "roll-outs"."""
    how = {name: settings.pop(name) for name in ("repetitions", "seed", "stop") if name in settings}
    if where == "tree":
        return returns(crowd(16), FourInRollOuts(*searcher(model_of_crowd(16), **settings)), **how)
    return returns(shop(), SixteenInRollOuts(*searcher(model_of_map(), **settings)), **how)


def learned(
    n_steps: int = LEARNING_STEPS,
    *,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
) -> Reals:
    """Return what Q-learners get after so many steps, which they may as well take in the model; one episode each."""
    found = []
    for number in seeds(seed, repetitions, stop):
        agent = QLearning.create(shop(), learning_rate=1.0, discount=DISCOUNT)
        run = train(shop(), agent, n_steps, evaluate_every=n_steps, seed=number)
        found.append(float(run.returns[-1]))
    return np.array(found)
