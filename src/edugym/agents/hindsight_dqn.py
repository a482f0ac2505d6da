"""DQN with hindsight: its memory also holds what the episodes were worth for goals that they achieved."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.dqn import DQN
from edugym.agents.hindsight import FutureGoals, Hindsight, check_hindsight, size_of_goal
from edugym.agents.settings import Counter, Range, Table, new, shows_settings
from edugym.agents.vectors import vector_size
from edugym.mdp.protocol import Random, Reals


@shows_settings
class HindsightDQN(NamedTuple):
    """DQN for many goals: Q(s‖g, a; θ) of one network for all of them.

    While it acts it is `DQN`. An episode that misses its goal has reached others. So when it is over, each of its
    transitions goes into the memory again, for some goals G' that the episode has achieved after it (see `hindsight`):

        R' = `reward_at_goal` if S' achieves G', else `reward_elsewhere`
        (S‖G, A, R, S'‖G)  becomes  (S‖G', A, R', S'‖G')

    where it counts as terminated if S' achieves G'. An environment has goals if its MDP has a `goal_space`: the second
    half of a state is then the goal, and the first half what has been achieved. In one without, nothing is added, and
    the agent is DQN.

    Attributes:
        dqn: the network and its memory, in which the steps of the episode under way are the last.
        length: shape (1,): how many steps of the episode under way are in it.
        draws: shape (longest, goals): random numbers, by which goals are chosen when the episode is over.
        goal_size: how many numbers a goal has; 0 in an environment without goals.
        hindsight: which goals are learned in hindsight: `FutureGoals(k)`, `FinalGoal()` or `NoHindsight()`.
        reward_at_goal: what the environment pays for a step that achieves its goal.
        reward_elsewhere: what it pays for any other step.

    Choices: some transitions are added twice, so that their number is a multiple of `learn_every`: DQN counts what is
    in its memory, and so it still learns every `learn_every` steps of the environment. An episode of which the memory
    would not hold all (`longest`) counts as several.

    References: Andrychowicz et al. (2017), Hindsight experience replay, algorithm 1 and section 4.5; Schaul et al.
    (2015), Universal value function approximators.
    """

    dqn: DQN
    length: Counter
    draws: Annotated[Reals, Table(("longest", "goals"))]
    goal_size: Annotated[int, Range(0)] = 0
    hindsight: Hindsight = FutureGoals(4)
    reward_at_goal: Annotated[float, Range(-1e300, 1e300)] = 0.0
    reward_elsewhere: Annotated[float, Range(-1e300, 1e300)] = -1.0

    def learn(self, state: Any, action: int, reward: float, next_state: Any, terminated: bool, truncated: bool) -> None:
        """Learn as DQN does; when the episode is over, remember its steps for other goals too."""
        self.dqn.learn(state, action, reward, next_state, terminated)
        self.length[0] += 1
        if terminated or truncated or self.length[0] == len(self.draws):
            if self.goal_size > 0 and self.hindsight.goals > 0:
                self.remember_in_hindsight()
            self.length[0] = 0

    def remember_in_hindsight(self) -> None:
        """Remember the steps of the episode for goals that it achieved."""
        length, k, every = int(self.length[0]), self.hindsight.goals, self.dqn.learn_every
        first, size = int(self.dqn.steps[0]) - length, len(self.dqn.memory.actions)
        wanted = length * k
        for copy in range(wanted + (every - wanted % every) % every):
            t, i = copy % length, copy // length % k
            goal_step = self.hindsight.achieved_after(t, length, self.draws[t, i])
            self.remember_for((first + t) % size, (first + goal_step) % size)

    def remember_for(self, row: int, goal_row: int) -> None:
        """Copy a transition in the memory, with what another one achieved as the goal."""
        memory, size, new_row = self.dqn.memory, self.goal_size, self.dqn.steps[0] % len(self.dqn.memory.actions)
        reached = True
        for x in range(size):
            goal = memory.next_states[goal_row, x]
            if memory.next_states[row, x] != goal:
                reached = False
            memory.states[new_row, x] = memory.states[row, x]
            memory.next_states[new_row, x] = memory.next_states[row, x]
            memory.states[new_row, size + x] = goal
            memory.next_states[new_row, size + x] = goal
        memory.actions[new_row] = memory.actions[row]
        memory.rewards[new_row] = self.reward_at_goal if reached else self.reward_elsewhere
        memory.terminated[new_row] = 1 if reached else 0
        self.dqn.steps[0] += 1

    def forget_episode(self) -> None:
        """Forget that the last steps in the memory are of an episode under way."""
        self.length[0] = 0

    def act(self, state: Any, rng: Random) -> int:
        """Choose an action as DQN does, and draw by what goals its step will be learned again."""
        for i in range(self.hindsight.goals):
            self.draws[self.length[0], i] = rng.random()
        return self.dqn.act(state, rng)

    def greedy(self, state: Any, rng: Random) -> int:
        """The action with the highest value."""
        return self.dqn.greedy(state, rng)

    @property
    def Q(self) -> Reals:
        """The action values of the state seen last, shape (1, n_actions)."""
        return self.dqn.Q

    @property
    def tabular(self) -> bool:
        """False: its states are vectors of numbers, not rows of a table."""
        return False

    @property
    def n_inputs(self) -> int:
        """How many numbers a state has, those of the goal included."""
        return self.dqn.n_inputs

    @property
    def n_actions(self) -> int:
        """How many actions it chooses from."""
        return self.dqn.n_actions

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "HindsightDQN":
        """A new agent for an environment (or the shape (n_inputs, n_actions)).

        Args:
            environment: an MDP or Gymnasium environment with actions 0, 1, ...
            **settings: the fields of the class that have a default, and all that `DQN.create` takes. `goal_size` is
                known where an environment is given.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit.
        """
        n_inputs, _ = vector_size(environment)
        mine = {name: settings.pop(name) for name in cls._field_defaults.keys() & settings.keys()}
        mine = {"goal_size": size_of_goal(environment, n_inputs), "hindsight": FutureGoals(), **mine}
        hindsight, dqn = mine["hindsight"], DQN.create(environment, **settings)
        check_hindsight(hindsight)
        longest = (len(dqn.memory.actions) - dqn.learn_every) // (hindsight.goals + 1)
        if longest < 1:
            raise ValueError(
                f"memory_size must be {hindsight.goals + 1 + dqn.learn_every} or more, for hindsight {hindsight} and"
                f" learn_every {dqn.learn_every}, but is {len(dqn.memory.actions)}"
            )
        agent = new(cls, None, mine, {"dqn": dqn}, longest=longest, goals=hindsight.goals)
        if agent.goal_size not in (0, n_inputs / 2):
            raise ValueError(
                f"goal_size must be 0, or half of the {n_inputs} numbers of a state, but is {agent.goal_size!r}"
            )
        return agent
