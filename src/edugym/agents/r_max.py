"""R-max: planning that wants to know."""

from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.planning import Planning, budget
from edugym.agents.settings import Counter, Discount, Range, Table, new, shows_settings
from edugym.agents.tables import greedy_action, table_size
from edugym.agents.tabular_model import TabularModel, empty_model, given_model
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Integers, Random, Reals

MOST = 1e300


class Sweep(NamedTuple):
    """The pairs that are known, and how far the sweep over them has come.

    Attributes:
        pairs: shape (n_states * n_actions,): the known pairs, (s, a) as s n_actions + a, in the order of their becoming
            known.
        n: shape (1,): how many.
        next: shape (1,): the index of the pair to update next.
        settled: shape (1,): how many updates in a row have changed next to nothing.
    """

    pairs: Annotated[Integers, Table(("pairs",))]
    n: Counter
    next: Counter
    settled: Counter


@shows_settings
class RMax(NamedTuple):
    """Plan with a model in which all that is unknown is wonderful: the agent goes and sees.

        Q(s, a) = Σ_s' p(s'|s, a) [r(s, a, s') + γ max_a' Q(s', a')]        if (s, a) is known
        Q(s, a) = U                                                         otherwise

    A pair is known when it has been tried m times; its p and r are the shares and means of these, and stay so. The
    values are those of value iteration, one known pair after the other, until a whole sweep changes none by more than
    θ or the budget is spent; the sweep goes on at the next step. The agent always takes the best action by these
    values: it explores because it plans to. They say nothing of how to use what is known, so it keeps a second table,
    with a pessimistic L in the place of U, by which it is evaluated (`greedy`).

    Attributes:
        Q: shape (n_states, n_actions): the values of what is known, pessimistic elsewhere.
        optimistic: shape (n_states, n_actions): the values by which it acts.
        model: what follows on each action in each state.
        sweep: the known pairs.
        planning: how many updates a step, or how much time.
        discount: γ, from 0 to 1.
        highest_return: U, what an unknown action is hoped to be worth: no less than the best return from any state, or
            it may never be tried. max(R_max, 0)/(1 - γ), for the highest reward R_max, is always enough.
        lowest_return: L, what it is feared to be worth: no more than the worst return.
        known_after: m, 1 or more: 1 is right where nothing is left to chance.
        threshold: θ, 0 or more.

    References: Brafman and Tennenholtz (2002), R-max; Sutton and Barto, 2nd edition, section 4.5 (asynchronous dynamic
    programming). The paper adds a state in which all is wonderful, to which unknown actions lead; U is its value. It
    has one table only, which is enough once all that matters is known, and maximises the average reward over a given
    number of steps; here future rewards are discounted.
    """

    Q: Annotated[Reals, Table(("states", "actions"), fill="lowest_return")]
    optimistic: Annotated[Reals, Table(("states", "actions"), fill="highest_return")]
    model: TabularModel
    sweep: Sweep
    planning: Planning
    discount: Discount = 0.99
    highest_return: Annotated[float, Range(-MOST, MOST)] = 100.0
    lowest_return: Annotated[float, Range(-MOST, MOST)] = -100.0
    known_after: Annotated[int, Range(1)] = 1
    threshold: Annotated[float, Range(0)] = 1e-3

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Let the model learn, until the pair is known."""
        if not self.model.given and self.model.visits[state, action] < self.known_after:
            self.model.observe(state, action, reward, next_state, terminated)
            if self.model.visits[state, action] == self.known_after:
                self.becomes_known(state, action)

    def becomes_known(self, state: int, action: int) -> None:
        """Plan with this pair from now on."""
        self.sweep.pairs[self.sweep.n[0]] = state * self.Q.shape[1] + action
        self.sweep.n[0] += 1
        self.sweep.settled[0] = 0

    def plan(self) -> None:
        """Value iteration over the known pairs, as far as the budget allows."""
        done = 0
        began = self.planning.start()
        while self.sweep.settled[0] < self.sweep.n[0] and self.planning.lasts(done, began):
            pair = self.sweep.pairs[self.sweep.next[0]]
            s, a = pair // self.Q.shape[1], pair % self.Q.shape[1]
            hoped = self.model.expected_target(s, a, self.optimistic, self.discount)
            feared = self.model.expected_target(s, a, self.Q, self.discount)
            change = max(abs(hoped - self.optimistic[s, a]), abs(feared - self.Q[s, a]))
            self.sweep.settled[0] = self.sweep.settled[0] + 1 if change <= self.threshold else 0
            self.optimistic[s, a] = hoped
            self.Q[s, a] = feared
            self.sweep.next[0] = (self.sweep.next[0] + 1) % self.sweep.n[0]
            done += 1

    def act(self, state: int, rng: Random) -> int:
        """Plan, then take the best action, known or not."""
        self.plan()
        return greedy_action(self.optimistic, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The best action as far as is known."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(
        cls,
        environment: Any,
        *,
        planning_steps: float = 1_000,
        planning_seconds: float | None = None,
        model: FiniteModel | None = None,
        memory: int | None = None,
        **settings: Any,
    ) -> "RMax":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            planning_steps: the number of planning updates a step, 0 or more; `math.inf` to plan until all is settled.
            planning_seconds: plan for so long at each step instead; the agent then runs interpreted.
            model: an exact model to plan with, in which all is known.
            memory: how many different transitions a learned model can hold; see `empty_model` for the default.
            **settings: see the class.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        known = empty_model(environment, memory) if model is None else given_model(environment, model)
        n_states, n_actions = table_size(environment)
        parts = {"model": known, "planning": budget(planning_steps, planning_seconds)}
        agent = new(cls, environment, settings, parts, pairs=n_states * n_actions)
        if model is not None:
            for s, a in np.argwhere(known.visits).tolist():
                agent.becomes_known(s, a)
        return agent
