"""DQN: deep Q-learning. The table becomes a neural network, of which every line is here."""

import math
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.settings import Counter, Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target
from edugym.agents.vectors import input_scale, vector_bounds, vector_size
from edugym.checks.parameters import MOST_ENTRIES, whole_number
from edugym.mdp.protocol import Integers, Random, Reals


class Layers(NamedTuple):
    """A number for every weight of the network: the weights themselves, their gradient, or Adam's averages.

    Attributes:
        first: shape (n_inputs + 1, n_hidden): from the inputs (a row each) to the hidden units; the last row is biases.
        second: shape (n_hidden + 1, n_actions): from the hidden units to the action values, likewise.
    """

    first: Annotated[Reals, Table(("inputs + 1", "hidden"))]
    second: Annotated[Reals, Table(("hidden + 1", "actions"))]


class ReplayMemory(NamedTuple):
    """The latest transitions, a row each; a new one takes the place of the oldest.

    Attributes:
        states: shape (n, n_inputs).
        actions: shape (n,).
        rewards: shape (n,).
        next_states: shape (n, n_inputs).
        terminated: shape (n,): 1 where the task ended, else 0.
    """

    states: Annotated[Reals, Table(("memory", "inputs"))]
    actions: Annotated[Integers, Table(("memory",))]
    rewards: Annotated[Reals, Table(("memory",))]
    next_states: Annotated[Reals, Table(("memory", "inputs"))]
    terminated: Annotated[Integers, Table(("memory",))]


@shows_settings
class DQN(NamedTuple):
    """Q-learning with a neural network, from a memory of transitions, towards a target that is held still.

        Q(s, ·; θ) = W₂ max(0, W₁ s + b₁) + b₂
        y = R + γ max_a Q(S', a; θ⁻)                         (R alone if S' is terminal)
        θ <- θ - a step of Adam down the gradient of the mean of L(Q(S, A; θ) - y) over a batch from memory

    and now and then θ⁻ <- θ. The loss L(δ) is δ²/2 up to |δ| = c, and c (|δ| - c/2) beyond.

    The weights are drawn when the agent acts for the first time, from its random stream: so every seed has its own.
    Before that they are 0, unless you have put others in, and all actions are worth the same: the first point of a
    learning curve is random play. In a loop of your own, call `act` before each `learn`: it also draws the batch.

    A state is a flat vector. `train` flattens boards and images, and encodes whole numbers one-hot; in a loop of your
    own, Gymnasium's `FlattenObservation` does both.

    Attributes:
        weights: θ.
        target: θ⁻, the weights that the targets are computed with.
        gradient: of the mean loss over a batch, by θ.
        mean: Adam's m, the moving average of the gradient.
        square: Adam's v, that of its square.
        memory: the latest transitions.
        scale: shape (n_inputs,): what inputs are multiplied by: 1 over the largest value that the observation space
            allows, 1 where it has no bounds, or bounds of a billion or more.
        x: shape (n_inputs,): the inputs of the network.
        h: shape (n_hidden,): its hidden units.
        Q: shape (1, n_actions): its action values.
        dQ: shape (n_actions,): the derivatives of the loss by the action values.
        dh: shape (n_hidden,): the derivatives of the loss by the hidden units.
        batch: shape (batch_size,): the rows of the memory from which to learn next.
        steps: shape (1,): how many transitions there have been.
        updates: shape (1,): how many steps of Adam.
        learning_rate: of Adam, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.
        learn_every: steps between two updates, 1 or more.
        learn_from: the step before which nothing is learned, 1 or more.
        copy_every: updates between two copies of θ to θ⁻, 1 or more.
        error_clip: c, the largest error that counts in full, greater than 0. With `math.inf` the loss is δ²/2. Choose
            infinity if returns are much larger than 1 and depend on rare steps, as in CartPole: errors beyond c all
            weigh the same, so rare targets count too little, and the values may grow without end.

    Deviations from Mnih et al.: one fully connected hidden layer on the whole observation instead of convolutions on
    four frames; inputs are scaled by their bounds; first weights as He et al. draw them for such a layer; Adam instead
    of RMSProp; rewards are not clipped; ε is constant by default (for theirs, see
    `ScheduledEpsilonGreedy` with `LinearDecay`), also before step `learn_from`, where theirs act uniformly at random;
    the memory is a hundredth of theirs, `learn_from` a fiftieth and `copy_every` a fortieth, and the learning rate four
    times theirs; actions are not repeated, and episodes do not start with idle steps; evaluation is greedy, theirs has
    ε = 0.05; at a truncation the agent bootstraps; and a batch is drawn before the step after which it is learned from,
    so that the newest transition is in it only if it took the place of one that was drawn.

    References: Mnih et al. (2015), Human-level control through deep reinforcement learning, algorithm 1 and extended
    data table 1; Kingma and Ba (2015), Adam, algorithm 1; He et al. (2015) for the first weights; Sutton and Barto,
    2nd edition, sections 9.7 and 16.5.
    """

    weights: Layers
    target: Layers
    gradient: Layers
    mean: Layers
    square: Layers
    memory: ReplayMemory
    scale: Annotated[Reals, Table(("inputs",), fill=1.0)]
    x: Annotated[Reals, Table(("inputs",))]
    h: Annotated[Reals, Table(("hidden",))]
    Q: Annotated[Reals, Table((1, "actions"))]
    dQ: Annotated[Reals, Table(("actions",))]
    dh: Annotated[Reals, Table(("hidden",))]
    batch: Annotated[Integers, Table(("batch",))]
    steps: Counter
    updates: Counter
    learning_rate: LearningRate = 1e-3
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)
    learn_every: Annotated[int, Range(1)] = 4
    learn_from: Annotated[int, Range(1)] = 1_000
    copy_every: Annotated[int, Range(1)] = 250
    error_clip: Annotated[float, Range(0, math.inf, open=True)] = 1.0

    def learn(self, state: Any, action: int, reward: float, next_state: Any, terminated: bool) -> None:
        """Remember the transition; every few steps, take one step of gradient descent on a batch from memory."""
        self.remember(state, action, reward, next_state, terminated)
        if self.is_due(self.steps[0]):
            for k in range(len(self.batch)):
                self.add_gradient(self.batch[k])
            self.updates[0] += 1
            adam(self.weights.first, self.gradient.first, self.mean.first, self.square.first, self.adam_rate)
            adam(self.weights.second, self.gradient.second, self.mean.second, self.square.second, self.adam_rate)
            if self.updates[0] % self.copy_every == 0:
                copy(self.weights, self.target)

    def add_gradient(self, row: int) -> None:
        """Add the gradient of the mean loss that is due to one transition of the batch."""
        memory = self.memory
        forward(self.target, memory.next_states[row], self.h, self.Q)
        target = one_step_target(memory.rewards[row], self.discount, best_value(self.Q, 0), memory.terminated[row] == 1)
        forward(self.weights, memory.states[row], self.h, self.Q)
        action = memory.actions[row]
        for a in range(len(self.dQ)):
            self.dQ[a] = 0.0
        self.dQ[action] = slope_of_loss(self.Q[0, action] - target, self.error_clip) / len(self.batch)
        backward(self.weights, self.gradient, memory.states[row], self.h, self.dQ, self.dh)

    def act(self, state: Any, rng: Random) -> int:
        """Choose an action by the exploration strategy, and draw from which transitions to learn after it."""
        if self.steps[0] == 0:
            self.draw_weights(rng)
        if self.is_due(self.steps[0] + 1):
            n = min(self.steps[0], len(self.memory.actions))
            for k in range(len(self.batch)):
                self.batch[k] = int(rng.random() * n)
        self.write_values(state)
        return self.exploration.choose(self.Q, 0, rng)

    def greedy(self, state: Any, rng: Random) -> int:
        """The action with the highest value."""
        self.write_values(state)
        return greedy_action(self.Q, 0, rng)

    def write_values(self, state: Any) -> None:
        """Compute Q(s, ·; θ).

        Raises:
            ValueError: the state is no vector with a number for each input.
        """
        if len(state) != len(self.x):
            raise ValueError(
                "state must be a flat vector with a number for each input of DQN: flatten boards and images"
            )
        for i in range(len(self.x)):
            self.x[i] = float(state[i]) * self.scale[i]
        forward(self.weights, self.x, self.h, self.Q)

    def remember(self, state: Any, action: int, reward: float, next_state: Any, terminated: bool) -> None:
        """Write a transition into the memory."""
        memory, row = self.memory, self.steps[0] % len(self.memory.actions)
        for i in range(len(self.x)):
            memory.states[row, i] = float(state[i]) * self.scale[i]
            memory.next_states[row, i] = float(next_state[i]) * self.scale[i]
        memory.actions[row] = action
        memory.rewards[row] = reward
        memory.terminated[row] = 1 if terminated else 0
        self.steps[0] += 1

    def is_due(self, step: int) -> bool:
        """Whether there is an update after so many steps."""
        return step >= self.learn_from and step % self.learn_every == 0

    @property
    def adam_rate(self) -> float:
        """Adam's step size α √(1 - β₂ᵗ) / (1 - β₁ᵗ), which makes up for averages that started from 0."""
        t = float(self.updates[0])
        return self.learning_rate * math.sqrt(1.0 - math.pow(0.999, t)) / (1.0 - math.pow(0.9, t))

    def draw_weights(self, rng: Random) -> None:
        """Draw the weights evenly from ±√(6/n) for n inputs of a unit; biases stay 0. The target network is a copy.

        Where there are weights, they stay.
        """
        if not self.weights.first.any() and not self.weights.second.any():
            for layer in (self.weights.first, self.weights.second):
                n_inputs = layer.shape[0] - 1
                bound = math.sqrt(6.0 / n_inputs)
                for i in range(n_inputs):
                    for j in range(layer.shape[1]):
                        layer[i, j] = bound * (2.0 * rng.random() - 1.0)
        copy(self.weights, self.target)

    @property
    def tabular(self) -> bool:
        """False: its states are vectors of numbers, not rows of a table."""
        return False

    @property
    def n_inputs(self) -> int:
        """How many numbers a state has."""
        return len(self.x)

    @property
    def n_actions(self) -> int:
        """How many actions it chooses from."""
        return len(self.dQ)

    @classmethod
    def create(
        cls, environment: Any, hidden: int = 64, memory_size: int = 10_000, batch_size: int = 32, **settings: Any
    ) -> "DQN":
        """A new agent for an environment (or the shape (n_inputs, n_actions)).

        Args:
            environment: an MDP or Gymnasium environment with actions 0, 1, ...
            hidden: how many hidden units the network has, from 1 to 2^28.
            memory_size: how many transitions are remembered, likewise.
            batch_size: from how many of them each update learns, likewise.
            **settings: see the class.

        Raises:
            ValueError: a setting is not as above or as the class says, or the environment does not fit.
        """
        n_inputs, n_actions = vector_size(environment)
        for name, size in (("hidden", hidden), ("memory_size", memory_size), ("batch_size", batch_size)):
            whole_number(name, size, 1, MOST_ENTRIES)
        sizes = {"inputs": n_inputs, "hidden": hidden, "actions": n_actions, "memory": memory_size, "batch": batch_size}
        sizes |= {"inputs + 1": n_inputs + 1, "hidden + 1": hidden + 1}
        agent = new(cls, None, settings, **sizes)
        agent.scale[:] = input_scale(*vector_bounds(environment))
        return agent


def forward(weights: Layers, x: Reals, h: Reals, Q: Reals) -> None:
    """Compute the hidden units, h = max(0, W₁ x + b₁), and the action values, Q = W₂ h + b₂, of shape (1, n_actions).

    An input that is 0 adds nothing, and so costs nothing.
    """
    first, second = weights.first, weights.second
    for j in range(len(h)):
        h[j] = first[len(x), j]
    for i in range(len(x)):
        if x[i] != 0.0:
            for j in range(len(h)):
                h[j] += x[i] * first[i, j]
    for j in range(len(h)):
        h[j] = max(0.0, h[j])
    for a in range(Q.shape[1]):
        total = second[len(h), a]
        for j in range(len(h)):
            total += h[j] * second[j, a]
        Q[0, a] = total


def slope_of_loss(error: float, error_clip: float) -> float:
    """The derivative of the loss by the error δ: δ itself, from -c to c (Huber's loss)."""
    return min(max(error, -error_clip), error_clip)


def backward(weights: Layers, gradient: Layers, x: Reals, h: Reals, dQ: Reals, dh: Reals) -> None:
    """Add to the gradient what the chain rule gives, from the action values back to the first weights.

    Args:
        weights: those of `forward`.
        gradient: what to add to.
        x: the inputs, shape (n_inputs,).
        h: the hidden units as `forward` left them, shape (n_hidden,).
        dQ: the derivatives of the loss by the action values, shape (n_actions,).
        dh: room for those by the hidden units, shape (n_hidden,).
    """
    for j in range(len(h)):
        dh[j] = 0.0
    for a in range(len(dQ)):
        if dQ[a] != 0.0:
            gradient.second[len(h), a] += dQ[a]
            for j in range(len(h)):
                gradient.second[j, a] += h[j] * dQ[a]
                slope = weights.second[j, a] * dQ[a]
                dh[j] += slope if h[j] > 0.0 else 0.0  # max(0, ·) is flat where it gives 0
    for j in range(len(h)):
        gradient.first[len(x), j] += dh[j]
    for i in range(len(x)):
        if x[i] != 0.0:
            for j in range(len(h)):
                gradient.first[i, j] += x[i] * dh[j]


def adam(weights: Reals, gradient: Reals, mean: Reals, square: Reals, rate: float) -> None:
    """Take one step of Adam down the gradient, then set the gradient to 0; all arrays have the same shape.

    (In the form of section 2 of the paper, whose ε is not corrected for the start. The divisor is never 0: `np.divide`
    does not test for that, so machine code is faster.)
    """
    for i in range(weights.shape[0]):
        for j in range(weights.shape[1]):
            mean[i, j] += 0.1 * (gradient[i, j] - mean[i, j])  # m <- 0.9 m + 0.1 g
            square[i, j] += 0.001 * (gradient[i, j] * gradient[i, j] - square[i, j])  # v <- 0.999 v + 0.001 g²
            weights[i, j] -= np.divide(rate * mean[i, j], math.sqrt(square[i, j]) + 1e-8)
            gradient[i, j] = 0.0


def copy(source: Layers, target: Layers) -> None:
    """Make the target's weights equal to the source's."""
    for one, other in ((source.first, target.first), (source.second, target.second)):
        for i in range(one.shape[0]):
            for j in range(one.shape[1]):
                other[i, j] = one[i, j]
