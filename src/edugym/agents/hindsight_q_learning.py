"""Q-learning with hindsight: values for every goal, learned from what was achieved."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.hindsight import FutureGoals, Hindsight, check_hindsight, number_of_goals
from edugym.agents.settings import ActionValues, Counter, Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target
from edugym.checks.parameters import MOST_ENTRIES, whole_number
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.task import table_size


class EpisodeSteps(NamedTuple):
    """The steps of the episode under way.

    Attributes:
        length: shape (1,): how many there are.
        states: shape (longest,): the row (state, goal) before each.
        actions: shape (longest,): its action.
        next_states: shape (longest,): the row after it.
        draws: shape (longest, goals): random numbers, by which goals are chosen when the episode is over.
    """

    length: Counter
    states: Annotated[Integers, Table(("longest",))]
    actions: Annotated[Integers, Table(("longest",))]
    next_states: Annotated[Integers, Table(("longest",))]
    draws: Annotated[Reals, Table(("longest", "goals"))]


@shows_settings
class HindsightQLearning(NamedTuple):
    """Q-learning of universal values Q(s‖g, a): of an action in a state s, when g is the goal.

        Q(S‖G, A) <- Q(S‖G, A) + α [R + γ max_a Q(S'‖G, a) - Q(S‖G, A)]

    An episode that misses its goal has reached others. So when it is over, its steps are learned again, the last one
    first, each for some goals G' that the episode has achieved after it (see `hindsight`):

        R' = `reward_at_goal` if S' achieves G', else `reward_elsewhere`
        Q(S‖G', A) <- Q(S‖G', A) + α [R' + γ max_a Q(S'‖G', a) - Q(S‖G', A)]

    where S' has the value 0 if it achieves G'. An environment has goals if its MDP has a `goal_space`. In one without,
    nothing is learned in hindsight, and the agent is Q-learning.

    Attributes:
        Q: shape (n_states, n_actions): the universal values; row n_goals s + g is for the state s and the goal g.
        episode: the steps of the episode under way.
        n_goals: how many goals there are. They are the states: the goal g is achieved in the state g. 1 is for an
            environment without goals.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.
        hindsight: which goals are learned in hindsight: `FutureGoals(k)`, `FinalGoal()` or `NoHindsight()`.
        reward_at_goal: what the environment pays for a step that achieves its goal.
        reward_elsewhere: what it pays for any other step.

    Choices: Andrychowicz et al. store the steps in a memory, and learn from batches of them; here each is learned once,
    for its own goal as soon as it is taken. An episode of more than `longest` steps counts as several.

    References: Andrychowicz et al. (2017), Hindsight experience replay, algorithm 1 and section 4.5; Schaul et al.
    (2015), Universal value function approximators; Kaelbling (1993), Learning to achieve goals.
    """

    Q: ActionValues
    episode: EpisodeSteps
    n_goals: Annotated[int, Range(1)] = 1
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)
    hindsight: Hindsight = FutureGoals(4)
    reward_at_goal: Annotated[float, Range(-1e300, 1e300)] = 0.0
    reward_elsewhere: Annotated[float, Range(-1e300, 1e300)] = -1.0

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Learn the step for its own goal; when the episode is over, learn all its steps for other goals."""
        self.update(state, action, reward, next_state, terminated)
        episode, t = self.episode, self.episode.length[0]
        episode.states[t] = state
        episode.actions[t] = action
        episode.next_states[t] = next_state
        episode.length[0] = t + 1
        if terminated or truncated or t + 1 == len(episode.states):
            if self.n_goals > 1:
                self.learn_in_hindsight()
            episode.length[0] = 0

    def learn_in_hindsight(self) -> None:
        """Learn the steps of the episode for goals that it achieved, the last step first."""
        episode, length = self.episode, int(self.episode.length[0])
        for t in range(length - 1, -1, -1):
            for i in range(self.hindsight.goals):
                goal_step = self.hindsight.achieved_after(t, length, episode.draws[t, i])
                goal = self.achieved(episode.next_states[goal_step])
                reached = self.achieved(episode.next_states[t]) == goal
                reward = self.reward_at_goal if reached else self.reward_elsewhere
                state = self.with_goal(episode.states[t], goal)
                next_state = self.with_goal(episode.next_states[t], goal)
                self.update(state, episode.actions[t], reward, next_state, reached)

    def update(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Move Q(S‖G, A) towards the reward plus γ times the highest value in S'‖G."""
        target = one_step_target(reward, self.discount, best_value(self.Q, next_state), terminated)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])

    def achieved(self, row: int) -> int:
        """The goal that is achieved in the state of a row: s in s‖g."""
        return row // self.n_goals

    def with_goal(self, row: int, goal: int) -> int:
        """The row of the same state with another goal: s‖g' for s‖g."""
        return row // self.n_goals * self.n_goals + goal

    def forget_episode(self) -> None:
        """Forget the steps of an episode that was not played to its end."""
        self.episode.length[0] = 0

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy, and draw by what goals its step will be learned again."""
        for i in range(self.hindsight.goals):
            self.episode.draws[self.episode.length[0], i] = rng.random()
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, *, longest: int = 1_000, **settings: Any) -> "HindsightQLearning":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            longest: how many steps of an episode are remembered, from 1 to 2^28.
            **settings: the fields of the class that have a default, and `initial_value`, by default 0. `n_goals` is
                known where an environment is given.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table of states and
                goals.
        """
        n_states, _ = table_size(environment)
        settings = {"n_goals": number_of_goals(environment, n_states), "hindsight": FutureGoals(), **settings}
        check_hindsight(settings["hindsight"])
        longest = whole_number("longest", longest, 1, MOST_ENTRIES)
        agent = new(cls, environment, settings, longest=longest, goals=settings["hindsight"].goals)
        if agent.n_goals not in (1, math.sqrt(n_states)):
            raise ValueError(
                f"n_goals must be 1, or the root of {n_states} rows (state, goal), but is {agent.n_goals!r}"
            )
        return agent
