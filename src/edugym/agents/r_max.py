"""R-max: optimistic planning that explores."""

from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.planning import Planning, budget
from edugym.agents.settings import Counter, Discount, Range, Table, new, shows_settings
from edugym.agents.tables import greedy_action
from edugym.agents.tabular_model import TabularModel, model_of
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.task import table_size

MOST = 1e300


class Sweep(NamedTuple):
    """The pairs that are known, and how far the sweep over them has come.

    Attributes:
        pairs: shape (n_states * n_actions,): the known pairs, each as s * n_actions + a, in the order in which they
            became known.
        n: shape (1,): how many.
        next: shape (1,): the index of the pair to update next.
        settled: shape (1,): how many updates in a row have changed no value by more than θ.
    """

    pairs: Annotated[Integers, Table(("pairs",))]
    n: Counter
    next: Counter
    settled: Counter


@shows_settings
class RMax(NamedTuple):
    """Plan with a model that gives every unknown action a very high value, so that the agent tries it.

        optimistic(s, a) = Σ_s' p(s'|s, a) [r(s, a, s') + γ max_a' optimistic(s', a')]        if (s, a) is known
        optimistic(s, a) = U                                                                  otherwise

    A pair is known after m tries; its p and r are then estimated from these m tries and no longer change. (Pairs that
    find no room in `memory` never become known, and are tried again and again.) The values are those of value
    iteration, one known pair after the other, until a whole sweep changes none by more than θ or the budget is spent;
    the sweep goes on at the next step. The agent always takes the best action by these values: it explores because it
    plans to, and needs no ε. Evaluation needs values without optimism: `Q` has the same equations with a pessimistic L
    in place of U, and `greedy` uses it.

    Attributes:
        Q: shape (n_states, n_actions): the pessimistic values, by which it is evaluated.
        optimistic: shape (n_states, n_actions): the values by which it acts.
        model: what follows on each action in each state.
        sweep: the known pairs.
        planning: how much to plan at each step: a number of updates, or of seconds.
        discount: γ, from 0 to 1.
        highest_return: U, the optimistic value of an unknown action, a finite number. It should be at least the best
            possible return from any state; otherwise some actions may never be tried. max(R_max, 0)/(1 - γ), for the
            highest reward R_max, is always enough if γ < 1; the default is that for rewards up to 1 at γ = 0.99.
        lowest_return: L, the pessimistic value of an unknown action, at most U. It should be at most the worst possible
            return.
        known_after: m, 1 or more: 1 is right where nothing is left to chance.
        threshold: θ, 0 or more. Values may err by θγ/(1 - γ), which is 0.1 by default: choose θ well below (1 - γ)
            times the smallest return that matters. With γ = 1, every step must cost something.

    References: Brafman and Tennenholtz (2002), R-max; Sutton and Barto, 2nd edition, section 4.5 (asynchronous dynamic
    programming). In the paper, unknown actions lead to a fictitious state of maximal reward; U is its value. The paper
    has one table, and maximises the average reward over a fixed number of steps. Here there are two tables, and rewards
    are discounted.
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
        """Add a pair to the sweep."""
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
            planning_steps: the number of planning updates a step, 0 or more; `math.inf` to plan until no value changes
                by more than θ (with discount 1 this may never happen).
            planning_seconds: plan for so long at each step instead; the agent then runs interpreted.
            model: an exact model to plan with, in which all is known.
            memory: how many different transitions a learned model can hold; see `empty_model` for the default.
            **settings: the discount and what follows it above.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table or the model.
        """
        known = model_of(environment, model, memory)
        n_states, n_actions = table_size(environment)
        parts = {"model": known, "planning": budget(planning_steps, planning_seconds)}
        agent = new(cls, environment, settings, parts, pairs=n_states * n_actions)
        if agent.lowest_return > agent.highest_return:
            raise ValueError(
                f"lowest_return must be at most {agent.highest_return!r}, the highest_return, but is"
                f" {agent.lowest_return!r}"
            )
        if model is not None:
            for s, a in np.argwhere(known.visits).tolist():
                agent.becomes_known(s, a)
        return agent
