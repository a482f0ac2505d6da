"""Go-Explore: first return, then explore."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Counter, Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.tables import best_value, greedy_action, one_step_target, random_action, replaces
from edugym.checks.parameters import MOST_ENTRIES, whole_number
from edugym.mdp.protocol import Integers, Random, Reals


class Attempt(NamedTuple):
    """The current attempt: the steps to a goal and the random steps after it.

    Attributes:
        goal: shape (1,): the state to return to.
        explored: shape (1,): the number of random steps since the goal was reached.
        length: shape (1,): the number of steps so far.
        states: shape (longest,): the state before each step.
        actions: shape (longest,): the action of each step.
        next_states: shape (longest,): the state after each step.
    """

    goal: Counter
    explored: Counter
    length: Counter
    states: Annotated[Integers, Table(("longest",))]
    actions: Annotated[Integers, Table(("longest",))]
    next_states: Annotated[Integers, Table(("longest",))]


@shows_settings
class GoExplore(NamedTuple):
    """First return, then explore, on goal-conditioned Q-learning.

    1. Choose as the goal the state of the archive (all states ever visited) with the fewest visits. Choosing it counts
       as a visit.
    2. Act greedily by Q(goal, ·, ·) until the goal is reached.
    3. From there take `explore_steps` random actions.
    4. For every state that the attempt entered, treat it as the goal and update the steps that led to it, the last step
       first (hindsight). Reaching the goal g gives reward 1 and ends the goal-conditioned task:

           Q(g, S, A) <- Q(g, S, A) + α [1 - Q(g, S, A)]                             if S' = g
           Q(g, S, A) <- Q(g, S, A) + α [γ max_a Q(g, S', a) - Q(g, S, A)]           otherwise

    Rewards do not guide the exploration. The agent stores the first state in which it received its highest reward;
    `greedy` moves to that state.

    Attributes:
        Q: shape (n_states, n_states, n_actions): Q[goal, state, action], the value of the
            action in the state when the task is to reach the goal.
        visits: shape (n_states,): how often a step entered each state or the state was chosen as a goal; the state
            in which an attempt starts counts as 1 if it was 0. The archive is the states with a count above 0.
        now: the current attempt.
        best_reward: shape (1,): the highest reward so far.
        best_state: shape (1,): the state where it was received.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1: below 1, shorter paths have higher values.
        explore_steps: the number of random steps after the goal was reached, 1 or more.

    Choices: Ecoffet et al. restore the simulator or train a goal-conditioned network; here a table of goal-conditioned
    values is learned. Their archive stores cells and draws one at random, with weight 1/√(visits + 1); here each state
    is a cell, and the least visited one is chosen. An attempt ends after its random steps, at the end of the episode,
    or after `longest` steps; the next one starts from the state reached, not from a reset. A state that was entered
    several times in an attempt is learned as a goal several times.

    References: Ecoffet et al. (2021), First return, then explore, Nature 590; Kaelbling (1993), Learning to achieve
    goals; Andrychowicz et al. (2017), Hindsight experience replay.
    """

    Q: Annotated[Reals, Table(("states", "states", "actions"))]
    visits: Annotated[Integers, Table(("states",))]
    now: Attempt
    best_reward: Annotated[Reals, Table((1,), fill=-math.inf)]
    best_state: Counter
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    explore_steps: Annotated[int, Range(1)] = 20

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Store the step; at the end of the attempt, learn to reach every state that it entered."""
        step = self.now.length[0]
        self.now.states[step] = state
        self.now.actions[step] = action
        self.now.next_states[step] = next_state
        self.now.length[0] = step + 1
        self.visits[next_state] += 1
        if reward > self.best_reward[0]:
            self.best_reward[0] = reward
            self.best_state[0] = next_state
        finished = self.now.explored[0] == self.explore_steps
        if terminated or truncated or finished or step + 1 == len(self.now.states):
            for last in range(step + 1):
                self.learn_to_reach(self.now.next_states[last], last)
            self.now.length[0] = 0

    def forget_episode(self) -> None:
        """Forget the attempt in an episode that was not played to its end."""
        self.now.length[0] = 0

    def learn_to_reach(self, goal: int, last: int) -> None:
        """Apply the Q-learning update for one goal to the steps `last`, `last - 1`, ..., 0."""
        for step in range(last, -1, -1):
            s, a, next_s = self.now.states[step], self.now.actions[step], self.now.next_states[step]
            reached = next_s == goal
            target = one_step_target(1.0 if reached else 0.0, self.discount, best_value(self.Q[goal], next_s), reached)
            self.Q[goal, s, a] += self.learning_rate * (target - self.Q[goal, s, a])

    def act(self, state: int, rng: Random) -> int:
        """Act greedily towards the goal until it is reached, then at random.

        The first call of an attempt chooses the goal.
        """
        if self.now.length[0] == 0:
            if self.visits[state] == 0:
                self.visits[state] = 1
            self.now.goal[0] = self.least_visited(rng)
            self.visits[self.now.goal[0]] += 1
            self.now.explored[0] = 0
        if state == self.now.goal[0] or self.now.explored[0] > 0:
            self.now.explored[0] += 1
            return random_action(self.Q.shape[2], rng)
        return greedy_action(self.Q[self.now.goal[0]], state, rng)

    def least_visited(self, rng: Random) -> int:
        """The state of the archive with the fewest visits; ties are broken at random."""
        least = 0
        ties = 0
        for state in range(len(self.visits)):
            if self.visits[state] > 0:
                if ties == 0 or self.visits[state] < self.visits[least]:
                    least = state
                    ties = 1
                elif self.visits[state] == self.visits[least]:
                    ties += 1
                    if replaces(ties, rng):
                        least = state
        return least

    def greedy(self, state: int, rng: Random) -> int:
        """The greedy action towards the state with the best reward."""
        return greedy_action(self.Q[self.best_state[0]], state, rng)

    @classmethod
    def create(cls, environment: Any, *, longest: int = 1_000, **settings: Any) -> "GoExplore":
        """Create an agent with new tables for an environment, or for the shape (n_states, n_actions) of a table.

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            longest: the maximum number of steps in one attempt, from 1 to 2^28.
            **settings: the fields of the class that have a default.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment is not tabular.
        """
        return new(cls, environment, settings, longest=whole_number("longest", longest, 1, MOST_ENTRIES))
