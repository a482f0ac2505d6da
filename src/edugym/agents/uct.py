"""UCT: Monte Carlo tree search that selects by upper confidence bounds."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.search_tree import OUTSIDE, ROOT, Tree
from edugym.agents.settings import ActionValues, Discount, Range, new, shows_settings
from edugym.agents.strategies import UCB, EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action, random_action
from edugym.agents.tabular_model import TabularModel, model_of
from edugym.checks.parameters import MOST_ENTRIES, whole_number
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Random
from edugym.mdp.task import table_size


@shows_settings
class UCT(NamedTuple):
    """Search at decision time: before each action, simulate what may follow, and look closer where it seems good.

    Each search begins a new tree, whose root is the present state, and simulates n times:

        select     from the root on, in each node the action with the highest Q(node, a) + c √(ln N(node) / N(node, a));
                   one that was never tried comes first;  R, S' <- Model(S, A)
        expand     the first S' that is not in the tree becomes a node
        roll out   from there on, random actions until the end, or until d steps after the root
        back up    from the last node to the root: G <- R + γ G;  N(node, A) <- N(node, A) + 1;
                   Q(node, A) <- Q(node, A) + [G - Q(node, A)] / N(node, A)

    Then the best action is the one with the highest Q in the root. Nothing else is kept of a tree.

    Attributes:
        Q: shape (n_states, n_actions): what the latest search from each state said of its actions.
        model: what follows on each action in each state.
        tree: the latest search.
        simulations: n, 1 or more, and at least the number of actions.
        depth: d, 1 or more: how many steps each simulation looks ahead.
        c: how much uncertainty is worth, a finite number of 0 or more. It is in the unit of the returns: c = √2 suits
            returns from 0 to 1 (UCB1), and returns that differ by up to 100 need one that is 100 times as large.
        discount: γ, from 0 to 1.
        exploration: how `act` chooses by the values of the root.

    Choices: every outcome of an action has a node of its own (closed loop), so that the plan can answer what happens;
    an open loop has one node for each action. A state that is reached in two ways has two nodes. N(node) counts the
    present choice, as in `UCB`. After d steps nothing more counts. An action that a learned model has never seen ends
    the simulation; it is worth its `initial_value`, so a high one makes the agent try it. Where the model knows nothing
    at all, `act` chooses by the initial values. With `nodes=1` no node is added to the root, and what is left is a
    rollout algorithm (section 8.10): it simulates good actions more often, and follows each by random ones.

    References: Kocsis and Szepesvári (2006), Bandit based Monte-Carlo planning; Browne et al. (2012), A survey of Monte
    Carlo tree search methods, algorithm 2; Sutton and Barto, 2nd edition, section 8.11.
    """

    Q: ActionValues
    model: TabularModel
    tree: Tree
    simulations: Annotated[int, Range(1)] = 100
    depth: Annotated[int, Range(1)] = 20
    c: Annotated[float, Range(0)] = 1.0
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """The model counts the step, unless it was given."""
        self.model.observe(state, action, reward, next_state, terminated)

    def search(self, state: int, rng: Random) -> None:
        """Grow a new tree from this state: its root then has a value for each action."""
        self.tree.plant(state)
        if self.model.n_tried[state] == 0:
            for action in range(self.Q.shape[1]):  # a slice that is copied would make machine code much slower
                self.tree.values[ROOT, action] = self.Q[state, action]
        else:
            for _ in range(self.simulations):
                self.simulate(rng)

    def simulate(self, rng: Random) -> None:
        """Select, expand, roll out, back up."""
        node, state, steps, ended = ROOT, int(self.tree.states[ROOT]), 0, False
        while node != OUTSIDE and steps < self.depth and not ended:
            action = self.select(node, rng)
            self.tree.path_nodes[steps] = node
            self.tree.path_actions[steps] = action
            if self.model.visits[state, action] == 0:
                self.tree.path_rewards[steps] = self.Q[state, action]
                ended = True
            else:
                outcome = self.model.sample(state, action, rng)
                self.tree.path_rewards[steps] = self.model.rewards[outcome]
                ended = self.model.ends[outcome] == 1
                state = int(self.model.next_states[outcome])
                child = self.tree.child(node, action, outcome)
                if child == OUTSIDE and not ended:
                    self.tree.expand(node, action, outcome, state)
                node = child
            steps += 1
        self.back_up(steps, 0.0 if ended else self.roll_out(state, steps, rng))

    def select(self, node: int, rng: Random) -> int:
        """The action with the highest upper bound in a node, which then counts as taken."""
        return UCB(self.tree.counts, self.tree.bounds, self.c).choose(self.tree.values, node, rng)

    def roll_out(self, state: int, steps: int, rng: Random) -> float:
        """The return of random actions from a state on, `steps` after the root."""
        model = self.model
        G = 0.0
        weight = 1.0
        for _ in range(steps, self.depth):
            action = random_action(self.Q.shape[1], rng)
            if model.visits[state, action] == 0:
                return G + weight * float(self.Q[state, action])
            outcome = model.sample(state, action, rng)
            G += weight * float(model.rewards[outcome])
            if model.ends[outcome] == 1:
                return G
            weight *= self.discount
            state = int(model.next_states[outcome])
        return G

    def back_up(self, steps: int, G: float) -> None:
        """Move the value of each action on the path towards the return that followed it, the last one first."""
        for step in range(steps - 1, -1, -1):
            node, action = self.tree.path_nodes[step], self.tree.path_actions[step]
            G = self.tree.path_rewards[step] + self.discount * G
            self.tree.values[node, action] += (G - self.tree.values[node, action]) / self.tree.counts[node, action]

    def act(self, state: int, rng: Random) -> int:
        """Search, then choose an action by the exploration strategy."""
        self.search(state, rng)
        for action in range(self.Q.shape[1]):
            self.Q[state, action] = self.tree.values[ROOT, action]
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """Search, then take the action with the highest value."""
        self.search(state, rng)
        return greedy_action(self.tree.values, ROOT, rng)

    @classmethod
    def create(
        cls,
        environment: Any,
        *,
        simulations: int = 100,
        depth: int = 20,
        nodes: int | None = None,
        model: FiniteModel | None = None,
        memory: int | None = None,
        **settings: Any,
    ) -> "UCT":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            simulations: n, from the number of actions, so that each is tried, to 2^28.
            depth: d, the number of steps that each simulation looks ahead, from 1 to 2^28.
            nodes: how many nodes the tree may have, from 1 to 2^28; by default one for each simulation and the root.
            model: an exact model to search in, instead of a learned one.
            memory: how many different transitions a learned model can hold; see `empty_model` for the default.
            **settings: c and what follows it above, and `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table or the model.
        """
        known = model_of(environment, model, memory)
        n_actions = table_size(environment)[1]
        simulations = whole_number("simulations", simulations, 1, MOST_ENTRIES)
        if simulations < n_actions:
            raise ValueError(
                f"simulations must be at least {n_actions}, the number of actions, so that each is tried, but is"
                f" {simulations}"
            )
        depth = whole_number("depth", depth, 1, MOST_ENTRIES)
        nodes = simulations + 1 if nodes is None else whole_number("nodes", nodes, 1, MOST_ENTRIES)
        settings = {**settings, "simulations": simulations, "depth": depth}
        return new(cls, environment, settings, {"model": known}, nodes=nodes, depth=depth)
