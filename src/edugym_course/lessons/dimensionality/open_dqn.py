"""DQN in which two parts are methods of their own, so that a class can replace them."""

from typing import Any

from edugym.agents.dqn import DQN, backward, forward, slope_of_loss
from edugym.agents.tables import best_value, one_step_target
from edugym.mdp.protocol import Random


class OpenDQN(DQN):
    """DQN; a class of one's own may replace `target_of` and `row_for`."""

    __slots__ = ()

    def target_of(self, row: int) -> float:
        """Return the target for a transition of the memory."""
        memory = self.memory
        forward(self.target, memory.next_states[row], self.h, self.Q)
        return one_step_target(memory.rewards[row], self.discount, best_value(self.Q, 0), memory.terminated[row] == 1)

    def row_for(self, u: float) -> int:
        """Return the row of the memory that a random number from 0 to 1 stands for."""
        return int(u * min(self.steps[0], len(self.memory.actions)))

    def add_gradient(self, row: int) -> None:
        """Add the gradient of the mean loss that is due to one transition of the batch, as DQN does."""
        memory = self.memory
        target = self.target_of(row)
        forward(self.weights, memory.states[row], self.h, self.Q)
        action = memory.actions[row]
        for a in range(len(self.dQ)):
            self.dQ[a] = 0.0
        self.dQ[action] = slope_of_loss(self.Q[0, action] - target, self.error_clip) / len(self.batch)
        backward(self.weights, self.gradient, memory.states[row], self.h, self.dQ, self.dh)

    def act(self, state: Any, rng: Random) -> int:
        """Choose an action, and draw from which transitions to learn after it, as DQN does."""
        if self.steps[0] == 0:
            self.draw_weights(rng)
        if self.is_due(self.steps[0] + 1):
            for k in range(len(self.batch)):
                self.batch[k] = self.row_for(rng.random())
        self.write_values(state)
        return self.exploration.choose(self.Q, 0, rng)
