"""Go-Explore: first return, then explore."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Counter, Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.tables import best_value, greedy_action, one_step_target, random_action, replaces
from edugym.checks import whole_number
from edugym.mdp.protocol import Integers, Random, Reals


class Try(NamedTuple):
    """The try under way: the way to a goal and a little beyond.

    Attributes:
        goal: shape (1,): the state to return to.
        explored: shape (1,): how many random steps this try has made since it reached its goal.
        length: shape (1,): how many steps this try has taken.
        states: shape (longest,): the state before each step of this try.
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
    2. Return to it, greedily by Q(goal, ·, ·), without exploring.
    3. From there take `explore_steps` random actions.
    4. Learn backwards over the try, with every state that it met as a goal (hindsight). The reward is 1 at the goal g,
       where the goal-conditioned task ends:

           Q(g, S, A) <- Q(g, S, A) + α [1 - Q(g, S, A)]                             if S' = g
           Q(g, S, A) <- Q(g, S, A) + α [γ max_a Q(g, S', a) - Q(g, S, A)]           otherwise

    Rewards do not guide the exploration. The agent remembers where the best reward was; to exploit (`greedy`), it goes
    there.

    Attributes:
        Q: shape (n_states, n_states, n_actions): the value of an action in a state for reaching a goal, by goal first.
        visits: shape (n_states,): how often each state was visited or chosen; the archive is where this is not 0.
        now: the try under way.
        best_reward: shape (1,): the highest reward so far.
        best_state: shape (1,): the state where it was received.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1: below 1, the nearer way is the better.
        explore_steps: how many random steps a try makes at its goal, 1 or more.

    Choices: Ecoffet et al. restore the simulator or train a goal-conditioned network; here a table learns to return.
    Their archive holds cells with scores by several counts; here a cell is a state, and the least visited is chosen.
    A try ends with its exploration, with the episode, or when it has become as long as its memory.

    References: Ecoffet et al. (2021), First return, then explore, Nature 590; Kaelbling (1993), Learning to achieve
    goals; Andrychowicz et al. (2017), Hindsight experience replay.
    """

    Q: Annotated[Reals, Table(("states", "states", "actions"))]
    visits: Annotated[Integers, Table(("states",))]
    now: Try
    best_reward: Annotated[Reals, Table((1,), fill=-math.inf)]
    best_state: Counter
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    explore_steps: Annotated[int, Range(1)] = 20

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Remember the step; at the end of the try, learn to reach every state that it met."""
        step = self.now.length[0]
        self.now.states[step] = state
        self.now.actions[step] = action
        self.now.next_states[step] = next_state
        self.now.length[0] = step + 1
        self.visits[next_state] += 1
        if reward > self.best_reward[0]:
            self.best_reward[0] = reward
            self.best_state[0] = next_state
        explored = self.now.explored[0] == self.explore_steps
        if terminated or truncated or explored or step + 1 == len(self.now.states):
            for last in range(step + 1):
                self.learn_to_reach(self.now.next_states[last], last)
            self.now.length[0] = 0

    def learn_to_reach(self, goal: int, last: int) -> None:
        """Q-learning for one goal over the try up to the step that reached it, the last step first."""
        for step in range(last, -1, -1):
            s, a, next_s = self.now.states[step], self.now.actions[step], self.now.next_states[step]
            reached = next_s == goal
            target = one_step_target(1.0 if reached else 0.0, self.discount, best_value(self.Q[goal], next_s), reached)
            self.Q[goal, s, a] += self.learning_rate * (target - self.Q[goal, s, a])

    def act(self, state: int, rng: Random) -> int:
        """Return to the goal, or explore when there."""
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
        """The state of the archive with the fewest visits; among equals, one at random."""
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
        """Go where the best reward was."""
        return greedy_action(self.Q[self.best_state[0]], state, rng)

    @classmethod
    def create(cls, environment: Any, *, longest: int = 1_000, **settings: Any) -> "GoExplore":
        """A new agent for an environment (or the shape of a table), which has been nowhere yet.

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            longest: how many steps of a try are remembered, 1 or more.
            **settings: see the class.

        Raises:
            ValueError: a setting is not as the class says, or the environment does not fit a table.
        """
        return new(cls, environment, settings, longest=whole_number("longest", longest, 1))
