"""Prioritised sweeping: planning backwards from where values change."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.heap import Heap
from edugym.agents.planning import Planning, budget
from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action
from edugym.agents.tabular_model import TabularModel, model_of
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Random
from edugym.mdp.task import table_size


@shows_settings
class PrioritisedSweeping(NamedTuple):
    """Update the pair with the largest error first; then check the pairs that lead to its state.

        Model(S, A) <- R, S'
        P = |R + γ max_a Q(S', a) - Q(S, A)|;  if P > θ, put (S, A) into the queue with priority P
        and n times, while the queue is not empty:
            S, A <- the first of the queue;  R, S' <- Model(S, A)
            Q(S, A) <- Q(S, A) + α [R + γ max_a Q(S', a) - Q(S, A)]
            for all pairs that the model says lead to S: compute their P, and queue them if P > θ

    All learning is by planning: `learn` changes the model and the queue, and Q changes at the next `act`, which plans
    first and then chooses. The box plans at the end of a step, so the order of the updates is the same. With a given
    model, `create` computes P for all pairs and fills the queue.

    If an action has had several outcomes, P and the update use the expected target. (The box assumes a deterministic
    environment; the text of section 8.4 has expected updates otherwise.) With `expected_updates` off, an update samples
    one outcome, and P uses the single outcome that was observed, or that leads to S. A pair that was updated with α < 1
    returns to the queue only when it, or its next state, is visited or changes again: in a deterministic environment
    use `learning_rate=1`.

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        model: what follows on each action in each state.
        queue: the pairs to update, each as the number s * n_actions + a.
        planning: how much to plan at each step: n updates, or a number of seconds.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.
        threshold: θ, 0 or more.
        expected_updates: whether planning uses expected updates, from the model's probabilities, or sample updates.
            `DynaQ` samples by default, like its box; where chance matters, compare the two with the same setting.

    References: Moore and Atkeson (1993); Peng and Williams (1993); Sutton and Barto, 2nd edition, the box of section
    8.4.
    """

    Q: ActionValues
    model: TabularModel
    queue: Heap
    planning: Planning
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)
    threshold: Annotated[float, Range(0)] = 1e-3
    expected_updates: bool = True

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Let the model learn, and put the pair into the queue if it is surprising."""
        outcome = self.model.observe(state, action, reward, next_state, terminated)
        if outcome >= 0:
            self.consider(outcome)

    def consider(self, outcome: int) -> None:
        """Put the pair of an outcome into the queue if its update would be large enough."""
        s, a = self.model.states[outcome], self.model.actions[outcome]
        if self.expected_updates:
            target = self.model.expected_target(s, a, self.Q, self.discount)
        else:
            target = self.model.target_of(outcome, self.Q, self.discount)
        P = abs(target - self.Q[s, a])
        if self.threshold < P:
            self.queue.push(s * self.Q.shape[1] + a, P)

    def plan(self, rng: Random) -> None:
        """Update the first pairs of the queue, and consider what leads to them."""
        done = 0
        began = self.planning.start()
        while self.queue.size[0] > 0 and self.planning.lasts(done, began):
            pair = self.queue.pop()
            s, a = pair // self.Q.shape[1], pair % self.Q.shape[1]
            if self.expected_updates:
                target = self.model.expected_target(s, a, self.Q, self.discount)
            else:
                target = self.model.target_of(self.model.sample(s, a, rng), self.Q, self.discount)
            self.Q[s, a] += self.learning_rate * (target - self.Q[s, a])
            outcome = self.model.first_into[s]
            while outcome >= 0:
                self.consider(outcome)
                outcome = self.model.following_into[outcome]
            done += 1

    def act(self, state: int, rng: Random) -> int:
        """Plan, then choose an action by the exploration strategy."""
        self.plan(rng)
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(
        cls,
        environment: Any,
        *,
        planning_steps: float = 10,
        planning_seconds: float | None = None,
        model: FiniteModel | None = None,
        memory: int | None = None,
        **settings: Any,
    ) -> "PrioritisedSweeping":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            planning_steps: n, the number of planning updates a step, 0 or more; `math.inf` to plan until the queue is
                empty. (With discount 1 this may never happen; where it surely does not, infinity is refused.)
            planning_seconds: plan for so long at each step instead; the agent then runs interpreted.
            model: an exact model to plan with, instead of a learned one.
            memory: how many different transitions a learned model can hold; see `empty_model` for the default.
            **settings: the learning rate and what follows it above, and `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table or the model.
        """
        known = model_of(environment, model, memory)
        n_states, n_actions = table_size(environment)
        pairs = n_states * n_actions
        parts = {"model": known, "planning": budget(planning_steps, planning_seconds)}
        agent = new(cls, environment, settings, parts, **{"items": pairs, "items + 1": pairs + 1})
        endless = not agent.expected_updates or (agent.threshold == 0 and agent.learning_rate < 1)
        if endless and planning_seconds is None and planning_steps == math.inf:
            raise ValueError(
                "planning_steps must be finite if updates are sampled, or if threshold is 0 and learning_rate below 1,"
                " since the queue may then never be empty, but is inf"
            )
        if model is not None:
            for outcome in range(int(known.n_outcomes[0])):
                agent.consider(outcome)
        return agent
