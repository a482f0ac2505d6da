"""The tree of a search at decision time, in arrays."""

from typing import Annotated, NamedTuple

from edugym.agents.settings import Counter, Table
from edugym.mdp.protocol import Integers, Reals

ROOT = 0
OUTSIDE = -1


class Tree(NamedTuple):
    """What the simulations of one search have met: a node is a state and the way to it, and node 0 is the root.

    After an action every outcome has a node of its own. Those of one node and action form a chain: first[node,
    action], then following[first[node, action]] and so on, until -1.

    Attributes:
        n: shape (1,): how many nodes there are.
        states: shape (nodes,): the state of each node.
        outcomes: shape (nodes,): the outcome of the model that leads to each node.
        counts: shape (nodes, n_actions): N(node, a), how many simulations took each action in each node.
        values: shape (nodes, n_actions): Q(node, a), the mean of their returns from there on.
        first: shape (nodes, n_actions): the first node after each action, or -1.
        following: shape (nodes,): the next node after the same action, or -1.
        bounds: shape (1, n_actions): the upper bounds in the present node.
        path_nodes: shape (depth,): the nodes of the present simulation.
        path_actions: shape (depth,): the action in each of them.
        path_rewards: shape (depth,): the reward after each action.
    """

    n: Counter
    states: Annotated[Integers, Table(("nodes",))]
    outcomes: Annotated[Integers, Table(("nodes",))]
    counts: Annotated[Integers, Table(("nodes", "actions"))]
    values: Annotated[Reals, Table(("nodes", "actions"))]
    first: Annotated[Integers, Table(("nodes", "actions"), fill=OUTSIDE)]
    following: Annotated[Integers, Table(("nodes",))]
    bounds: Annotated[Reals, Table((1, "actions"))]
    path_nodes: Annotated[Integers, Table(("depth",))]
    path_actions: Annotated[Integers, Table(("depth",))]
    path_rewards: Annotated[Reals, Table(("depth",))]

    def plant(self, state: int) -> None:
        """Begin a new tree, which has nothing but its root."""
        self.n[0] = 0
        self.add_node(state, OUTSIDE)

    def add_node(self, state: int, outcome: int) -> int:
        """A new node, in which nothing was tried yet."""
        node = int(self.n[0])
        self.n[0] = node + 1
        self.states[node] = state
        self.outcomes[node] = outcome
        self.counts[node, :] = 0
        self.values[node, :] = 0.0
        self.first[node, :] = OUTSIDE
        return node

    def child(self, node: int, action: int, outcome: int) -> int:
        """The node that an outcome leads to, or -1."""
        child = int(self.first[node, action])
        while child != OUTSIDE and self.outcomes[child] != outcome:
            child = int(self.following[child])
        return child

    def expand(self, node: int, action: int, outcome: int, state: int) -> None:
        """Add the node that an outcome leads to; where there is no more room, nothing happens."""
        if self.n[0] < len(self.states):
            child = self.add_node(state, outcome)
            self.following[child] = self.first[node, action]
            self.first[node, action] = child
