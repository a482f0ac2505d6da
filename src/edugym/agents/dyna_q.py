"""Dyna-Q: Q-learning that also plans with a model, learned or given."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.planning import Planning, budget
from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target, random_action
from edugym.agents.tabular_model import TabularModel, model_of
from edugym.checks.parameters import whole_number
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Random


@shows_settings
class DynaQ(NamedTuple):
    """Learning, model-learning and planning in one: the same update for real and for imagined steps.

        Q(S, A) <- Q(S, A) + α [R + γ max_a Q(S', a) - Q(S, A)]             for the step that was taken
        Model(S, A) <- R, S'
        and n times: S <- a random state in which an action was taken;  A <- a random one of these actions;
        R, S' <- Model(S, A);  the same update

    If S' is terminal, max_a Q(S', a) is 0. The model counts outcomes: it draws each next state in proportion to how
    often it followed, and remembers the mean of the rewards. With `expected_updates`, planning uses the mean over all
    outcomes instead of one sample (section 8.5). An `exploration_bonus` κ makes it Dyna-Q+ (section 8.3): an imagined R
    becomes R + κ √τ, where τ is the number of steps since the action was last taken in that state, or since the start
    of learning. Planning then also imagines actions that were never taken there: they lead back to the same state, with
    reward 0 and the bonus. The model never forgets an outcome: when the environment changes, it adapts only as fast as
    the counts shift. The model of the box keeps the latest outcome, and adapts at once.

    `act` plans first and then chooses. The box plans at the end of a step, so the order of the updates is the same;
    with a given model, the agent also plans before its first step.

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        model: what follows on each action in each state.
        planning: how much to plan at each step: n updates, or a number of seconds.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.
        exploration_bonus: κ, 0 or more.
        expected_updates: whether planning uses expected updates, from the model's probabilities, or sample updates.

    References: Sutton (1990); Sutton and Barto, 2nd edition, the box of section 8.2 and section 8.3.
    """

    Q: ActionValues
    model: TabularModel
    planning: Planning
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)
    exploration_bonus: Annotated[float, Range(0)] = 0.0
    expected_updates: bool = False

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Q-learning from the step that was taken. The model counts the step, unless it was given."""
        target = one_step_target(reward, self.discount, best_value(self.Q, next_state), terminated)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
        self.model.observe(state, action, reward, next_state, terminated)

    def plan(self, rng: Random) -> None:
        """Q-learning from steps that the model imagines, as many as the budget allows."""
        done = 0
        began = self.planning.start()
        while self.model.n_known[0] > 0 and self.planning.lasts(done, began):
            s = self.model.random_state(rng)
            if self.exploration_bonus > 0.0:
                a = random_action(self.Q.shape[1], rng)
            else:
                a = self.model.random_tried_action(s, rng)
            self.Q[s, a] += self.learning_rate * (self.imagined_target(s, a, rng) - self.Q[s, a])
            done += 1

    def imagined_target(self, state: int, action: int, rng: Random) -> float:
        """The target R + γ max_a Q(S', a) by the model, plus the bonus."""
        if self.model.visits[state, action] == 0:
            target = self.discount * best_value(self.Q, state)
        elif self.expected_updates:
            target = self.model.expected_target(state, action, self.Q, self.discount)
        else:
            target = self.model.target_of(self.model.sample(state, action, rng), self.Q, self.discount)
        if self.exploration_bonus > 0.0:
            since = self.model.steps[0] - self.model.last_visit[state, action]
            target += self.exploration_bonus * math.sqrt(since)
        return target

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
        planning_steps: int = 10,
        planning_seconds: float | None = None,
        model: FiniteModel | None = None,
        memory: int | None = None,
        **settings: Any,
    ) -> "DynaQ":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            planning_steps: n, the number of planning updates a step, a whole number of 0 or more.
            planning_seconds: plan for so long at each step instead; the agent then runs interpreted.
            model: an exact model to plan with, instead of a learned one.
            memory: how many different transitions a learned model can hold; see `empty_model` for the default.
            **settings: the learning rate and what follows it above, and `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table or the model.
        """
        known = model_of(environment, model, memory)
        planning = budget(whole_number("planning_steps", planning_steps, 0), planning_seconds)
        return new(cls, environment, settings, {"model": known, "planning": planning})
