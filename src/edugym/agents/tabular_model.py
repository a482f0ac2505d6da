"""A model of the environment in tables, learned by counting or given."""

from typing import Annotated, Any, NamedTuple

import gymnasium
import numpy as np

from edugym.agents.settings import Counter, Table, new
from edugym.agents.tables import best_value, one_step_target, random_action
from edugym.checks.parameters import MOST_ENTRIES, in_short, whole_number
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.tabular import tabular_mdp
from edugym.mdp.task import table_size


class TabularModel(NamedTuple):
    """What follows on each action in each state, and how often.

    An outcome k is one thing that was seen to happen: in `states[k]` the action `actions[k]` led to `next_states[k]`.
    The outcomes of a pair (s, a) form a chain: first[s, a], then following[first[s, a]] and so on, until -1. So do
    those that lead to a state, the predecessors: first_into[s], following_into[first_into[s]], ...

    Attributes:
        visits: shape (n_states, n_actions): N(s, a), how many steps with each action in each state it remembers.
        last_visit: shape (n_states, n_actions): at which step it was taken last; 0 for never.
        steps: shape (1,): how many steps were seen.
        known_states: shape (n_states,): the states in which an action was taken, in the order in which they were met.
        n_known: shape (1,): how many these are.
        n_tried: shape (n_states,): how many different actions were taken in each state.
        first: shape (n_states, n_actions): the first outcome of each pair, or -1.
        first_into: shape (n_states,): the first outcome that leads to each state, or -1.
        n_outcomes: shape (1,): how many outcomes there are; the arrays that follow have this shape (memory,).
        states: the state of each outcome.
        actions: its action.
        next_states: its next state.
        ends: 1 where the task ended with it, else 0.
        weights: how often it was seen, or, in a given model, its probability.
        rewards: the mean reward with it.
        following: the next outcome of the same pair, or -1.
        following_into: the next outcome that leads to the same state, or -1.
        given: whether the model was given, and does not learn.
    """

    visits: Annotated[Integers, Table(("states", "actions"))]
    last_visit: Annotated[Integers, Table(("states", "actions"))]
    steps: Counter
    known_states: Annotated[Integers, Table(("states",))]
    n_known: Counter
    n_tried: Annotated[Integers, Table(("states",))]
    first: Annotated[Integers, Table(("states", "actions"), fill=-1)]
    first_into: Annotated[Integers, Table(("states",), fill=-1)]
    n_outcomes: Counter
    states: Annotated[Integers, Table(("memory",))]
    actions: Annotated[Integers, Table(("memory",))]
    next_states: Annotated[Integers, Table(("memory",))]
    ends: Annotated[Integers, Table(("memory",))]
    weights: Annotated[Reals, Table(("memory",))]
    rewards: Annotated[Reals, Table(("memory",))]
    following: Annotated[Integers, Table(("memory",))]
    following_into: Annotated[Integers, Table(("memory",))]
    given: bool = False

    def observe(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> int:
        """Count what happened, unless the model was given.

        Returns:
            The index of the outcome; -1 if the model lacks it, because it was given or because its memory is full.
        """
        self.steps[0] += 1
        self.last_visit[state, action] = self.steps[0]
        if self.given:
            return self.find(state, action, next_state, terminated)
        return self.add(state, action, reward, next_state, terminated, 1.0)

    def find(self, state: int, action: int, next_state: int, terminated: bool) -> int:
        """The outcome that this is, or -1."""
        k = int(self.first[state, action])
        while k >= 0 and not (self.next_states[k] == next_state and (self.ends[k] == 1) == terminated):
            k = int(self.following[k])
        return k

    def add(self, state: int, action: int, reward: float, next_state: int, terminated: bool, weight: float) -> int:
        """Add to the weight of an outcome, and return its index.

        A new outcome for which there is no room changes nothing; the index is then -1.
        """
        k = self.find(state, action, next_state, terminated)
        if k < 0 and self.n_outcomes[0] == len(self.states):
            return -1
        if self.visits[state, action] == 0:
            if self.n_tried[state] == 0:
                self.known_states[self.n_known[0]] = state
                self.n_known[0] += 1
            self.n_tried[state] += 1
        self.visits[state, action] += 1
        if k < 0:
            k = int(self.n_outcomes[0])
            self.n_outcomes[0] += 1
            self.states[k] = state
            self.actions[k] = action
            self.next_states[k] = next_state
            self.ends[k] = 1 if terminated else 0
            self.following[k] = self.first[state, action]
            self.first[state, action] = k
            if not terminated:  # what leads to an end does not depend on the values there
                self.following_into[k] = self.first_into[next_state]
                self.first_into[next_state] = k
        self.weights[k] += weight
        self.rewards[k] += weight / self.weights[k] * (reward - self.rewards[k])
        return k

    def target_of(self, k: int, Q: Reals, discount: float) -> float:
        """The target of a sample update with outcome k: R + γ max_a Q(S', a)."""
        return one_step_target(self.rewards[k], discount, best_value(Q, self.next_states[k]), self.ends[k] == 1)

    def expected_target(self, state: int, action: int, Q: Reals, discount: float) -> float:
        """The target of an expected update: Σ_s' p(s'|s, a) [r(s, a, s') + γ max_a Q(s', a)]."""
        mean = 0.0
        total = 0.0
        k = int(self.first[state, action])
        while k >= 0:
            total += self.weights[k]
            mean += self.weights[k] / total * (self.target_of(k, Q, discount) - mean)
            k = int(self.following[k])
        return mean

    def sample(self, state: int, action: int, rng: Random) -> int:
        """Draw an outcome of a pair that has one, each by its weight."""
        total = 0.0
        k = int(self.first[state, action])
        while k >= 0:
            total += self.weights[k]
            k = int(self.following[k])
        left = rng.random() * total
        k = int(self.first[state, action])
        while self.following[k] >= 0:
            left -= self.weights[k]
            if left < 0.0:
                break
            k = int(self.following[k])
        return k

    def random_state(self, rng: Random) -> int:
        """A state in which an action was taken, drawn uniformly."""
        return int(self.known_states[int(rng.random() * self.n_known[0])])

    def random_tried_action(self, state: int, rng: Random) -> int:
        """An action that was taken in a state, drawn uniformly."""
        left = random_action(self.n_tried[state], rng)
        action = 0
        while self.visits[state, action] == 0 or left > 0:
            if self.visits[state, action] > 0:
                left -= 1
            action += 1
        return action


def empty_model(environment: Any, memory: int | None = None) -> TabularModel:
    """A model that has seen nothing yet, for an environment (or the shape of a table).

    Args:
        environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
        memory: how many outcomes it can hold, from 1 to 2^28; by default 8 for each pair of state and action, or
            100 000 if that is less, but never fewer than 1 000 or two for each pair. An outcome that no longer
            fits is neither remembered nor counted as a visit.

    Raises:
        ValueError: the memory is not as above, or the environment does not fit a table.
    """
    n_states, n_actions = table_size(environment)
    pairs = n_states * n_actions
    default = max(1_000, 2 * pairs, min(8 * pairs, 100_000))
    memory = default if memory is None else whole_number("memory", memory, 1, MOST_ENTRIES)
    return new(TabularModel, environment, {}, memory=memory)


def model_of(environment: Any, model: FiniteModel | None, memory: int | None) -> TabularModel:
    """The model of a new agent: the given one, or an empty one that learns.

    Args:
        environment: an MDP, an environment or a shape.
        model: the exact model to plan with, or None.
        memory: how many different transitions a learned model can hold, or None for the default of `empty_model`.

    Raises:
        ValueError: as `given_model` or `empty_model`, or there is a model and a memory.
    """
    if model is None:
        return empty_model(environment, memory)
    if memory is not None:
        raise ValueError(
            f"memory must be left out where a model is given, which does not learn, but is {in_short(memory)}"
        )
    return given_model(environment, model)


def given_model(environment: Any, model: FiniteModel) -> TabularModel:
    """An exact model (which may have noise) in the form in which agents plan.

    Args:
        environment: the MDP of the model, or an environment or shape whose observations are the states themselves.
        model: the exact model; it must tell all states apart by what the agent observes in them.

    Raises:
        ValueError: it is no model, not one of this environment, or states that differ look the same.
    """
    if not isinstance(model, FiniteModel):
        raise ValueError(f"model must be a FiniteModel, such as finite_model(mdp), but is {in_short(model)}")
    rows = [_observed(environment, state) for state in model.states]
    n_states, n_actions = table_size(environment)
    going_on = [row for row, end in zip(rows, model.terminal, strict=True) if not end]
    if len(set(going_on)) < len(going_on):
        raise ValueError("model must have states that the agent can tell apart, but some look the same to it")
    if model.successors.shape[1] != n_actions or not all(0 <= row < n_states for row in rows):
        raise ValueError(
            f"model must be one of this environment, which has {n_states} states and {n_actions} actions, but has"
            f" {len(rows)} and {model.successors.shape[1]}"
        )
    table = empty_model(environment, int(np.count_nonzero(model.probabilities)) + 1)
    for s, a, k in np.argwhere(model.probabilities > 0).tolist():
        if not model.terminal[s]:
            n = model.successors[s, a, k]
            p, reward, end = model.probabilities[s, a, k], model.rewards[s, a, k], model.terminal[n]
            table.add(rows[s], a, float(reward), rows[n], bool(end), float(p))
    return table._replace(given=True)


def _observed(environment: Any, state: Any) -> int:
    """The row of a table that stands for a state."""
    if isinstance(environment, gymnasium.Env):
        environment = getattr(environment.unwrapped, "mdp", environment)
    if hasattr(environment, "observation") and not isinstance(environment, gymnasium.Env):
        state = tabular_mdp(environment).observation(state, np.random.default_rng(0))
    if not isinstance(state, int | np.integer):
        raise ValueError(
            f"model must have states that are whole numbers, or come with its MDP, but has {in_short(state)}"
        )
    return int(state)
