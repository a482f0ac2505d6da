"""Go-Explore: first return, then explore."""

from typing import Any, NamedTuple

import numpy as np

from edugym.agents.settings import check_learning
from edugym.agents.strategies import best_value, greedy_action
from edugym.checks import whole_number
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.tabular import table_size


class Try(NamedTuple):
    """What the agent is doing now: one try after another, each to a goal and a little beyond.

    Attributes:
        goal: shape (1,): the state to return to.
        explored: shape (1,): how many random steps this try has made since it got there.
        length: shape (1,): how many steps this try has taken.
        states: shape (longest,): the state before each step of this try.
        actions: shape (longest,): the action of each step.
        next_states: shape (longest,): the state after each step.
        best: shape (2,): the reward of the most rewarding transition so far, and the state it led to.
    """

    goal: Integers
    explored: Integers
    length: Integers
    states: Integers
    actions: Integers
    next_states: Integers
    best: Reals


class GoExplore(NamedTuple):
    """First return, then explore, on goal-conditioned Q-learning.

    1. Choose the state of the archive (all that were ever visited) that was visited least as the goal; choosing it
       counts as a visit.
    2. Return to it, greedily by Q(goal, ·, ·), without exploring.
    3. From there take `explore_steps` random actions.
    4. Learn backwards over the try, with every state that it met as a goal (hindsight), with reward 1 at the goal,
       where the goal-conditioned task ends:

           Q(g, S, A) <- Q(g, S, A) + α [1{S' = g} + γ 1{S' ≠ g} max_a Q(g, S', a) - Q(g, S, A)]

    Rewards do not guide the exploration. The agent remembers where the best one was, and to exploit (`greedy`) it
    goes there.

    Attributes:
        Q: shape (n_states, n_states, n_actions): the value of an action in a state for reaching a goal, by goal first.
        visits: shape (n_states,): how often each state was visited or chosen; the archive is where this is not 0.
        now: what the agent is doing.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1: below 1, the nearer way is the better.
        explore_steps: how many random steps a try makes at its goal, 1 or more.

    Choices: Ecoffet et al. restore the simulator or train a goal-conditioned network; here a table learns to return.
    Their archive holds cells with scores by several counts; here a cell is a state, and the least visited is chosen.
    A try ends with its exploration, with the episode, or when it has become as long as its memory.

    References: Ecoffet et al. (2021), First return, then explore, Nature 590; Kaelbling (1993), Learning to achieve
    goals; Andrychowicz et al. (2017), Hindsight experience replay.
    """

    Q: Reals
    visits: Integers
    now: Try
    learning_rate: float = 0.5
    discount: float = 0.9
    explore_steps: int = 20

    @classmethod
    def create(
        cls,
        environment: Any,
        *,
        learning_rate: float = 0.5,
        discount: float = 0.9,
        explore_steps: int = 20,
        longest: int = 1_000,
    ) -> "GoExplore":
        """A new agent that has been nowhere.

        Args:
            environment: an MDP or Gymnasium environment with whole numbers for observations and actions, or the numbers
                (n_states, n_actions) of both.
            learning_rate: see the class, as the others.
            discount: see the class.
            explore_steps: see the class.
            longest: how many steps of a try are remembered, 1 or more.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        check_learning(learning_rate, discount)
        whole_number("explore_steps", explore_steps, 1)
        whole_number("longest", longest, 1)
        n_states, n_actions = table_size(environment)
        goal, explored, length = (np.zeros(1, np.int64) for _ in range(3))
        states, actions, next_states = (np.zeros(longest, np.int64) for _ in range(3))
        now = Try(goal, explored, length, states, actions, next_states, np.array([-np.inf, 0.0]))
        Q, visits = np.zeros((n_states, n_states, n_actions)), np.zeros(n_states, np.int64)
        return cls(Q, visits, now, learning_rate, discount, explore_steps)

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
            return int(rng.random() * self.Q.shape[2])
        return greedy_action(self.Q[self.now.goal[0]], state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """Go where the best reward was."""
        return greedy_action(self.Q[int(self.now.best[1])], state, rng)

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
                    if rng.random() * ties < 1.0:
                        least = state
        return least

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Remember the step; at the end of the try, learn to reach every state that it met."""
        step = self.now.length[0]
        self.now.states[step] = state
        self.now.actions[step] = action
        self.now.next_states[step] = next_state
        self.now.length[0] = step + 1
        self.visits[next_state] += 1
        if reward > self.now.best[0]:
            self.now.best[0] = reward
            self.now.best[1] = next_state
        explored = self.now.explored[0] == self.explore_steps
        if terminated or truncated or explored or step + 1 == len(self.now.states):
            for last in range(step + 1):
                self.learn_to_reach(self.now.next_states[last], last)
            self.now.length[0] = 0

    def learn_to_reach(self, goal: int, last: int) -> None:
        """Q-learning for one goal over the try up to the step that reached it, the last step first."""
        for step in range(last, -1, -1):
            s, a, next_s = self.now.states[step], self.now.actions[step], self.now.next_states[step]
            target = 1.0 if next_s == goal else self.discount * best_value(self.Q[goal], next_s)
            self.Q[goal, s, a] += self.learning_rate * (target - self.Q[goal, s, a])
