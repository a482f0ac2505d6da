"""Any observations as the rows of a table that holds only those that occur."""

from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.checks.interfaces import MDP_ONLY
from edugym.mdp.hashed_table import HashedTable
from edugym.mdp.in_place import blank, in_place
from edugym.mdp.protocol import Random
from edugym.mdp.task import task_of
from edugym.mdp.wrapper import wrapper


@wrapper
class Hashed(NamedTuple):
    """An MDP whose observations (images too) are shown as rows of a table, in order of first appearance.

    Every tabular agent works on it. A table over all images of Catch, 10 by 5 cells, would have 2^50 rows; this one has
    as many as there are different images, so an agent learns from images exactly as it does from positions. What it
    cannot do is generalise: an image that it has not seen is a new row.

        task = Hashed.create(make_mdp("Catch"), capacity=1_000)
        agent = QLearning.create(task)
        train(task, agent, 50_000)
        task.used, task.capacity                    # (250, 1000)

    The table belongs to the wrapper and is its only part that changes. An observation keeps its row for ever, so an
    evaluation, which adds rows as training does, changes no value that was learnt. The rows mean nothing without the
    wrapper: keep both, agent and wrapper, to use the agent again, and use a wrapper in one thread at a time.

    Make one with `Hashed.create(mdp, capacity)`.

    Attributes:
        mdp: the task.
        table: which observation has which row.
        key: the present observation, before it is looked up.
    """

    mdp: Any
    table: HashedTable
    key: Any

    @property
    def used(self) -> int:
        """How many different observations have occurred."""
        return self.table.used

    @property
    def capacity(self) -> int:
        """How many different observations there is room for."""
        return self.table.capacity

    @property
    def observation_space(self) -> spaces.Discrete:
        """The rows of the table, used or not."""
        return spaces.Discrete(self.table.capacity)

    def observation(self, state: Any, rng: Random) -> int:
        """The row of what the task shows."""
        self.mdp.observe_into(state, rng, self.key)
        return self.table.row(self.key)

    @classmethod
    def create(cls, mdp: Any, capacity: int = 100_000, overflow: bool = False) -> "Hashed":
        """The wrapper with an empty table, for an MDP that observes numbers.

        Args:
            mdp: the task.
            capacity: how many different observations there is room for, from 1 to 2^28.
            overflow: whether all new observations share the last row when the table is full, instead of an error.

        Raises:
            ValueError: the task does not observe numbers, or the capacity is not as said.
        """
        task_of(mdp, "mdp", MDP_ONLY)
        mdp = in_place(mdp)
        key = blank(mdp)
        return cls(mdp, HashedTable.create(key, capacity, overflow), key)
