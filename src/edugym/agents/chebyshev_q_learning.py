"""Q-learning with the Chebyshev distance to a utopian point."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Counter, Discount, LearningRate, Part, Range, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action, one_step_target
from edugym.agents.vector_tables import OfActions, OfObjectives, VectorValues, vector_of_best
from edugym.mdp.multi_objective import table_shape
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.weighted import weights_for


@shows_settings
class ChebyshevQLearning(NamedTuple):
    """Q-learning of vectors; the best action is the one closest to a point that is best in all objectives.

        d(s, a) = max_i w_i |z_i + τ - Q(s, a)_i|
        Q(S, A) <- Q(S, A) + α [R + γ Q(S', A*) - Q(S, A)]     where A* = argmin_a d(S', a), and R and Q are vectors

    The utopian point z has in each objective the best return of an episode so far. There need be no policy that comes
    to it. d is the largest of the weighted distances, so points can be closest that no weighted sum prefers: those in a
    dent of the Pareto front.

    In the middle of an episode Q(s, a) are the returns *from there on*, but z is what whole episodes brought. What was
    paid up to there is forgotten, and the agent may go on where its own weights would rather have stopped before. With
    `whole_returns` it compares whole returns: it adds to Q(s, a) the return with which s was last reached. That is
    right where this return follows from the state, as in `Diver`; elsewhere put it into the state.

    Attributes:
        Q: shape (n_states, n_actions, n_objectives): the vectors of action values.
        weights: shape (n_objectives,): w, of 0 or more.
        best_returns: shape (n_objectives,): z, the best undiscounted return so far in each objective.
        total: shape (n_objectives,): the return of this episode so far.
        so_far: shape (n_states, n_objectives): the return with which each state was last reached.
        episodes: shape (1,): how many episodes have ended.
        closeness: shape (1, n_actions): -d in the state that was looked at last.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1; with `whole_returns` only 1.
        exploration: how actions are chosen; it takes -d as the values.
        margin: τ, 0 or more: how far the utopian point lies beyond z.
        whole_returns: whether whole returns are compared.

    Choices: Van Moffaert et al. do not say of what z is the best value; here it is the return of an episode, and 0
    until the first has ended. `whole_returns` is not theirs; Hayes et al. say why returns no longer add up if they are
    not weighted by a sum. Where several actions are closest, the target has the mean of their vectors.

    References: Van Moffaert, Drugan and Nowé (2013), Scalarized multi-objective reinforcement learning: novel design
    techniques; Hayes et al. (2022), A practical guide to multi-objective reinforcement learning and planning.
    """

    Q: VectorValues
    weights: Annotated[Reals, Part()]
    best_returns: OfObjectives
    total: OfObjectives
    so_far: Annotated[Reals, Table(("states", "objectives"))]
    episodes: Counter
    closeness: OfActions
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)
    margin: Annotated[float, Range(0)] = 0.0
    whole_returns: bool = False

    def learn(
        self, state: int, action: int, rewards: Reals, next_state: int, terminated: bool, truncated: bool
    ) -> None:
        """Move the vector Q(S, A) towards R plus γ times that of the closest action in S'."""
        for i in range(len(self.total)):
            self.total[i] += rewards[i]
            self.so_far[next_state, i] = self.total[i]
        self.look_at(next_state)
        for i in range(len(self.total)):
            next_value = vector_of_best(self.Q, next_state, self.closeness, i)
            target = one_step_target(rewards[i], self.discount, next_value, terminated)
            self.Q[state, action, i] += self.learning_rate * (target - self.Q[state, action, i])
        if terminated or truncated:
            self.end_episode()

    def end_episode(self) -> None:
        """Note in which objectives this episode was the best so far."""
        for i in range(len(self.total)):
            if self.episodes[0] == 0 or self.total[i] > self.best_returns[i]:
                self.best_returns[i] = self.total[i]
            self.total[i] = 0.0
        self.episodes[0] += 1

    def look_at(self, state: int) -> None:
        """Write -d(s, a) of every action into `closeness`."""
        for action in range(self.Q.shape[1]):
            farthest = 0.0
            for i in range(self.Q.shape[2]):
                value = self.Q[state, action, i]
                if self.whole_returns:
                    value += self.so_far[state, i]
                farthest = max(farthest, self.weights[i] * abs(self.best_returns[i] + self.margin - value))
            self.closeness[0, action] = -farthest

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        self.look_at(state)
        return self.exploration.choose(self.closeness, 0, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action that is closest to the utopian point."""
        self.look_at(state)
        return greedy_action(self.closeness, 0, rng)

    def forget_episode(self) -> None:
        """Forget the return of an episode that was not played to its end."""
        for i in range(len(self.total)):
            self.total[i] = 0.0

    @classmethod
    def create(cls, environment: Any, weights: Any = None, **settings: Any) -> "ChebyshevQLearning":
        """A new agent for a task.

        Args:
            environment: a task with several objectives (see `edugym.mdp.multi_objective`), or the shape (n_states,
                n_actions, n_objectives).
            weights: a number of 0 or more for each objective, not all 0; by default 1 for each.
            **settings: the fields of the class that have a default, and `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        states, actions, objectives = table_shape(environment)
        parts = {"weights": weights_for((1.0,) * objectives if weights is None else weights, objectives)}
        agent = new(cls, None, settings, parts, states=states, actions=actions, objectives=objectives)
        if agent.whole_returns and agent.discount != 1:
            raise ValueError(f"discount must be 1 with whole_returns, but is {agent.discount}")
        return agent
