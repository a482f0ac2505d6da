"""Proximal policy optimisation, whole: for any observations that are numbers and any of Gymnasium's simple actions."""

import math
from collections.abc import Mapping
from typing import Annotated, Any, NamedTuple

import numpy as np
import torch
from gymnasium import spaces
from torch import Tensor, nn
from torch.nn import functional
from torch.optim.adam import adam
from torch.random import fork_rng

from edugym.agents.settings import Discount, LearningRate, Probability, Range, new, shows_settings
from edugym.agents.vectors import input_scale
from edugym.checks.parameters import a_dictionary, number_of_steps, whole_number
from edugym.deep.curves import Curve, copies, one_thread
from edugym.mdp.tabular import table_lows, table_sizes
from edugym.mdp.task import vector_length
from edugym.training.run import Run

AtLeastOne = Annotated[int, Range(1)]


@shows_settings
class PPO(NamedTuple):
    """Policy gradients in small steps: many copies play, and the policy may not move far from the one that played.

        ratio = π(A|S) / π_old(A|S)
        maximise the mean of min(ratio Â, clip(ratio, 1 - ε, 1 + ε) Â) - (V(S) - G)²/2 + c · entropy of π(·|S)
        Â_t = δ_t + γλ Â_t+1,  δ_t = R_t+1 + γ V(S_t+1) - V(S_t),  G_t = Â_t + V(S_t)

    Attributes:
        environment: the name of an environment of this package, an id that Gymnasium knows, an `MDPEnv` or an MDP.
        parameters: those of an environment that is given by name.
        num_envs: how many copies play, 1 or more.
        length: steps that each copy plays between two updates, 1 or more.
        epochs: how many times each step is learned from, 1 or more.
        minibatches: into how many parts the steps are divided for learning, 1 or more; each has two steps or more.
        hidden: units in each of the two hidden layers of each network, 1 or more.
        learning_rate: of Adam, greater than 0 and up to 1; it falls evenly to 0.
        discount: γ, from 0 to 1.
        trace_decay: λ, from 0 to 1.
        clip: ε, greater than 0.
        entropy_bonus: c, 0 or more.

    Choices where Schulman et al. (2017) leave them open, or deviations: policy and value function are two networks; the
    value loss has a factor 1/2, which is c₁ = 1/2 in their equation 9; advantages are normalised in each minibatch, and
    values are not clipped; the gradient of both networks together is clipped to a norm of 0.5; ε of Adam is 1e-5;
    weights are orthogonal, and small in the last layer of the policy; inputs are divided by their bounds, and rewards
    are not scaled; σ of real actions starts at e^-0.5 and does not depend on the state; the environment gets actions
    cut off at the bounds of the space, and the policy learns from those that were drawn; a terminal state is worth 0,
    and a truncated episode V of its last state.

    References: Schulman et al. (2017), Proximal policy optimization algorithms, equations 7, 9, 11 and 12 and algorithm
    1; Schulman et al. (2016) for Â; Huang et al. (2022), The 37 implementation details of proximal policy
    optimization.
    """

    environment: Any
    parameters: Any
    num_envs: AtLeastOne = 64
    length: AtLeastOne = 32
    epochs: AtLeastOne = 10
    minibatches: AtLeastOne = 4
    hidden: AtLeastOne = 64
    learning_rate: LearningRate = 2e-3
    discount: Discount = 0.99
    trace_decay: Probability = 0.95
    clip: Annotated[float, Range(0, open=True)] = 0.2
    entropy_bonus: Annotated[float, Range(0)] = 0.0

    def train(
        self, n_steps: int, *, evaluate_every: int | None = None, evaluation_episodes: int = 100, seed: int = 0
    ) -> Run:
        """Train new networks for `n_steps` steps of all copies together, rounded down to whole updates.

        Args:
            n_steps: how many steps, `num_envs` times `length` or more.
            evaluate_every: steps between two points of the curve, 1 or more; by default a tenth of `n_steps`.
            evaluation_episodes: how many episodes each point averages, played by the likeliest actions.
            seed: from 0 to 2⁶³ - 1; the same seed gives the same run. It leaves torch's own random stream as it was.

        Returns:
            As `edugym.train`; its `agent` is the `ActorCritic`.

        Raises:
            ValueError: a parameter is not as above.
        """
        number_of_steps("n_steps", n_steps)
        updates = whole_number("n_steps", n_steps, self.num_envs * self.length) // (self.num_envs * self.length)
        whole_number("seed", seed, 0, 2**63 - 1)
        with one_thread(), fork_rng(devices=[]), torch.inference_mode():  # the gradient is written out below
            torch.manual_seed(seed)
            env = copies(self.environment, self.num_envs, self.parameters)
            net = ActorCritic(env.single_observation_space, env.single_action_space, self.hidden)
            optimizer = Adam.create(net.weights)
            every = max(1, n_steps // 10) if evaluate_every is None else evaluate_every
            curve = Curve(self.environment, self.parameters, lambda: net.greedy, every, evaluation_episodes, seed)
            curve.measure(0)
            observations, _ = env.reset(seed=seed)
            for update in range(updates):
                done = update * self.num_envs * self.length
                data, observations = self.play(env, net, observations, curve, done)
                self.learn(net, optimizer, self.learning_rate * (1 - update / updates), data)
            return curve.run(net, updates * self.num_envs * self.length, seed)

    def play(self, env: Any, net: "ActorCritic", observations: Any, curve: Curve, done: int) -> Any:
        """Play `length` steps in every copy, and judge every action.

        Returns:
            What `gradient` takes, shape (length · n, ...) each: inputs, actions, their log π, advantages and targets of
            V. And the observations after the last step.
        """
        n, T = self.num_envs, self.length
        inputs, outputs, actions = [], [], []
        rewards, going_on = np.zeros((T, n), np.float32), np.zeros((T, n), np.float32)
        for t in range(T):
            inputs.append(net.inputs_of(observations))
            outputs.append(net.actor(inputs[-1]))
            actions.append(net.policy(outputs[-1]).sample())
            observations, reward, terminated, truncated, infos = env.step(net.for_environment(actions[-1]))
            over = terminated | truncated
            rewards[t], going_on[t] = reward, ~over
            for i in np.flatnonzero(truncated & ~terminated):  # what would have come is worth V
                last = net.inputs_of(np.asarray(infos["final_obs"][i])[None])
                rewards[t, i] += self.discount * float(net.critic(last))
            curve.add(done + (t + 1) * n, reward, over)
        x, action = torch.cat(inputs), torch.cat(actions)
        V = net.critic(torch.cat([x, net.inputs_of(observations)])).view(T + 1, n)
        steps = torch.as_tensor(rewards), torch.as_tensor(going_on)
        advantages = advantages_of(*steps, V, self.discount, self.trace_decay)
        log_prob = net.policy(torch.cat(outputs)).log_prob(action)
        targets = advantages + V[:-1]
        return [x, action, log_prob, advantages.ravel(), targets.ravel()], observations

    def learn(self, net: "ActorCritic", optimizer: "Adam", learning_rate: float, data: list[Tensor]) -> None:
        """Take steps up the objective, from each action `epochs` times."""
        for _ in range(self.epochs):
            for part in torch.randperm(len(data[0])).tensor_split(self.minibatches):
                gradient = self.gradient(net, *(column.index_select(0, part) for column in data))
                gradient *= 0.5 / max(0.5, float(torch.linalg.vector_norm(gradient)))  # its norm is 0.5 at most
                optimizer.step(gradient, learning_rate)

    def gradient(
        self, net: "ActorCritic", x: Tensor, action: Tensor, old_log_prob: Tensor, advantage: Tensor, target: Tensor
    ) -> Tensor:
        """The gradient of the objective by all weights: by the chain rule, from the outputs of the networks back.

        Args:
            net: the networks.
            x: their inputs, shape (n, n_inputs).
            action: what was done, shape (n, n_numbers).
            old_log_prob: log π of it when it was done, shape (n,).
            advantage: Â, shape (n,).
            target: G, which V should be, shape (n,).
        """
        *inputs, y = net.actor.outputs(x)
        policy, advantage = net.policy(y), normalised(advantage)
        ratio = (policy.log_prob(action) - old_log_prob).exp()
        gain = ratio * advantage  # its derivative by log π is the same number, ratio · Â
        slope = gain * (gain == clipped_gain(ratio, advantage, self.clip))  # but 0 where the ratio is cut off
        y_gradient, *log_std_gradients = policy.gradient(action, slope, self.entropy_bonus)
        net.actor.backward(inputs, y_gradient)
        *inputs, V = net.critic.outputs(x)
        net.critic.backward(inputs, target[:, None] - V)
        for part in log_std_gradients:  # none where actions are whole numbers
            net.log_std_gradient.copy_(part)
        return net.gradient.div_(len(x))

    @classmethod
    def create(cls, environment: Any, parameters: Mapping[str, Any] | None = None, **settings: Any) -> "PPO":
        """The algorithm for an environment; settings: see the class.

        Raises:
            ValueError: a setting is not as the class says, or there is no such environment.
        """
        parameters = a_dictionary("parameters", parameters)
        copies(environment, 1, parameters)
        made = new(cls, None, {"environment": environment, "parameters": parameters, **settings})
        whole_number("minibatches", made.minibatches, 1, made.num_envs * made.length // 2)
        return made


def advantages_of(rewards: Tensor, going_on: Tensor, V: Tensor, discount: float, trace_decay: float) -> Tensor:
    """Generalised advantage estimates Â, shape (T, n).

    Args:
        rewards: shape (T, n).
        going_on: shape (T, n): 0 where the step ended an episode, else 1.
        V: shape (T + 1, n): the value of the state before each step, and of the last.
        discount: γ.
        trace_decay: λ.
    """
    delta = rewards + discount * going_on * V[1:] - V[:-1]
    decay = discount * trace_decay * going_on
    advantages = delta.clone()
    for t in reversed(range(len(delta) - 1)):
        advantages[t] += decay[t] * advantages[t + 1]
    return advantages


def clipped_gain(ratio: Tensor, advantage: Tensor, clip: float) -> Tensor:
    """The objective of each step: it gains nothing from a ratio beyond 1 ± ε (equation 7)."""
    return torch.min(ratio * advantage, ratio.clamp(1 - clip, 1 + clip) * advantage)


def normalised(x: Tensor) -> Tensor:
    """With a mean of 0 and a standard deviation of 1."""
    return functional.layer_norm(x, x.shape, eps=1e-12)


class Adam(NamedTuple):
    """The function behind `torch.optim.Adam`, whose own bookkeeping takes longer than the step itself.

    Attributes:
        weights: shape (n,), what is learned; changed in place.
        mean: shape (n,), the average of the gradients so far.
        mean_square: shape (n,), that of their squares.
        n_steps: how many steps there were.

    References: Kingma and Ba (2015), Adam: a method for stochastic optimization, algorithm 1.
    """

    weights: Tensor
    mean: Tensor
    mean_square: Tensor
    n_steps: Tensor

    def step(self, gradient: Tensor, learning_rate: float) -> None:
        """Take a step uphill."""
        past: Any = [self.mean], [self.mean_square], [], [self.n_steps]
        plain: Any = {"weight_decay": 0.0, "amsgrad": False, "maximize": True, "fused": True}
        adam([self.weights], [gradient], *past, lr=learning_rate, beta1=0.9, beta2=0.999, eps=1e-5, **plain)

    @classmethod
    def create(cls, weights: Tensor) -> "Adam":
        """For these weights, before the first step."""
        return cls(weights, torch.zeros_like(weights), torch.zeros_like(weights), torch.tensor(0.0))


class ActorCritic:
    """A policy and a value function: two networks with two hidden layers each.

    Attributes:
        actor: its outputs make the policy: the means of real actions, or the preferences for whole numbers.
        critic: gives V.
        log_std: log σ of each real action.
        weights: all numbers that are learned, in one vector; the others are views of it.
        gradient: the derivatives of the objective by them, in the same order.
        log_std_gradient: those by `log_std`, a view of it.
    """

    def __init__(self, observations: spaces.Space[Any], actions: spaces.Space[Any], hidden: int) -> None:
        """See the class.

        Raises:
            ValueError: observations are not numbers, or actions not `Discrete`, `MultiDiscrete` or vectors of reals.
        """
        self.observations, self.actions = observations, actions
        if isinstance(actions, spaces.Box) and len(actions.shape) == 1:
            self.sizes, n_reals = [actions.shape[0]], actions.shape[0]
        elif isinstance(actions, spaces.Discrete | spaces.MultiDiscrete):
            self.sizes, n_reals = list(table_sizes(actions)), 0
            self.lows = np.array(table_lows(actions))
        else:
            raise ValueError(f"PPO needs actions that are whole numbers or vectors, but the action space is {actions}")
        n_inputs = vector_length(observations)
        actor = initial_weights(n_inputs, hidden, hidden, sum(self.sizes), last=0.01)
        critic = initial_weights(n_inputs, hidden, hidden, 1, last=1.0)
        learned = [*actor, *critic, torch.full((n_reals,), -0.5)]
        self.shapes = [part.shape for part in learned]
        self.set_weights(torch.cat([part.ravel() for part in learned]))
        if isinstance(observations, spaces.Box):
            scale = input_scale(observations.low.ravel(), observations.high.ravel())
            self.scale = torch.as_tensor(scale, dtype=torch.float32)

    def set_weights(self, vector: Tensor) -> None:
        """Make the networks of views of this vector, which is what is learned."""
        self.weights, self.gradient = vector, torch.zeros_like(vector)
        weights, gradients = views_of(self.weights, self.shapes), views_of(self.gradient, self.shapes)
        self.actor, self.critic = Network(weights[:6], gradients[:6]), Network(weights[6:12], gradients[6:12])
        self.log_std, self.log_std_gradient = weights[12], gradients[12]

    def inputs_of(self, observations: Any) -> Tensor:
        """Observations as vectors, shape (n, n_inputs): numbers over the largest allowed, or ones and zeros."""
        seen = np.asarray(observations).reshape(len(observations), -1)
        if isinstance(self.observations, spaces.Box):
            return torch.as_tensor(seen, dtype=torch.float32) * self.scale
        sizes, x = table_sizes(self.observations), torch.zeros(len(seen), vector_length(self.observations))
        first = np.cumsum([0, *sizes[:-1]]) - np.array(table_lows(self.observations))
        return x.scatter_(1, torch.as_tensor(seen + first), 1.0)

    def policy(self, y: Tensor) -> "Gaussian | Softmax":
        """The distribution π(·|s), from the outputs of the actor, shape (n, n_outputs)."""
        if isinstance(self.actions, spaces.Box):
            return Gaussian(y, self.log_std)
        return Softmax([functional.log_softmax(part.T, 0).T for part in y.split_with_sizes(self.sizes, -1)])

    def for_environment(self, actions: Tensor) -> Any:
        """Actions as the environment takes them."""
        if isinstance(self.actions, spaces.Box):
            return np.clip(actions.numpy(), self.actions.low, self.actions.high)
        whole = actions.numpy() + self.lows
        return whole[:, 0] if isinstance(self.actions, spaces.Discrete) else whole

    def greedy(self, observations: Any, first: Any = None) -> Any:
        """The likeliest actions for observations of shape (n, ...)."""
        return self.for_environment(self.policy(self.actor(self.inputs_of(observations))).mode)


class Network(NamedTuple):
    """Layers with tanh between them: y = W₃h₂ + b₃, h₂ = tanh(W₂h₁ + b₂), h₁ = tanh(W₁x + b₁)."""

    weights: list[Tensor]  # W₁, b₁, W₂, b₂, W₃, b₃
    gradients: list[Tensor]  # the derivatives of the objective by them

    def __call__(self, x: Tensor) -> Tensor:
        """y, shape (n, n_outputs), for x of shape (n, n_inputs)."""
        return self.outputs(x)[-1]

    def outputs(self, x: Tensor) -> list[Tensor]:
        """x, h₁, h₂ and y."""
        W1, b1, W2, b2, W3, b3 = self.weights
        h1 = functional.linear(x, W1, b1).tanh_()
        h2 = functional.linear(h1, W2, b2).tanh_()
        return [x, h1, h2, (W3 @ h2.T).T + b3]

    def backward(self, inputs: list[Tensor], d: Tensor) -> None:
        """Find the derivatives of any sum over states by W₁, b₁, W₂ and so on.

        Args:
            inputs: x, h₁ and h₂, the inputs of the layers.
            d: the derivatives of the sum by y, shape (n, n_outputs); on the way back, by what goes into each tanh.
        """
        for k in (2, 1, 0):
            torch.mm(d.T, inputs[k], out=self.gradients[2 * k])
            torch.sum(d, 0, out=self.gradients[2 * k + 1])
            if k > 0:
                d = torch.ops.aten.tanh_backward(d @ self.weights[2 * k], inputs[k])  # times tanh' = 1 - h²


class Gaussian(NamedTuple):
    """π of real numbers: log π = Σ (-z²/2 - log σ - log √2π), z = (a - μ)/σ; its entropy is Σ log σ and a constant."""

    mean: Tensor  # shape (n, n_numbers)
    log_std: Tensor  # shape (n_numbers,)

    def sample(self) -> Tensor:
        """Actions, shape (n, n_numbers)."""
        return self.mean + self.log_std.exp() * torch.randn_like(self.mean)

    def log_prob(self, actions: Tensor) -> Tensor:
        """The logarithm of π, of all numbers of an action together, shape (n,)."""
        z = (actions - self.mean) / self.log_std.exp()
        return -(z * z / 2 + self.log_std + math.log(2 * math.pi) / 2).sum(-1)

    def gradient(self, actions: Tensor, slope: Tensor, bonus: float) -> list[Tensor]:
        """The derivatives of the sum of slope · log π + bonus · entropy, by μ and by log σ."""
        std = self.log_std.exp()
        z = (actions - self.mean) / std
        return [slope[:, None] * z / std, slope @ (z * z - 1) + bonus * len(z)]

    @property
    def mode(self) -> Tensor:
        """The likeliest actions, shape (n, n_numbers)."""
        return self.mean


class Softmax(NamedTuple):
    """π of one or several whole numbers: each has probabilities p, the softmax of its part of y."""

    log_p: list[Tensor]  # for each of them, shape (n, n_values)

    def sample(self) -> Tensor:
        """Actions, shape (n, n_numbers).

        Of waiting times E/p, with E exponential, each is the shortest with its probability p.
        """
        draws = [log_p.exp() / torch.empty_like(log_p).exponential_() for log_p in self.log_p]
        return torch.stack([draw.argmax(-1) for draw in draws], -1)

    def log_prob(self, actions: Tensor) -> Tensor:
        """The logarithm of π, of all numbers of an action together, shape (n,)."""
        chosen = [log_p.gather(1, actions[:, k : k + 1]) for k, log_p in enumerate(self.log_p)]
        return torch.cat(chosen, -1).sum(-1)

    def gradient(self, actions: Tensor, slope: Tensor, bonus: float) -> list[Tensor]:
        """By y: of log π, 1 - p for what was chosen, else -p; of the entropy H = -Σ p log p, -p (log p + H)."""
        found = []
        for k, log_p in enumerate(self.log_p):
            p = log_p.exp()
            d = (-slope[:, None] * p).scatter_add_(1, actions[:, k : k + 1], slope[:, None])
            if bonus:
                d -= bonus * p * (log_p - (p * log_p).sum(-1, keepdim=True))
            found.append(d)
        return [torch.cat(found, -1)]

    @property
    def mode(self) -> Tensor:
        """The likeliest actions, shape (n, n_numbers)."""
        return torch.stack([log_p.argmax(-1) for log_p in self.log_p], -1)


def views_of(vector: Tensor, shapes: list[torch.Size]) -> list[Tensor]:
    """Parts of a vector, one after the other, as views in these shapes."""
    views = vector.split_with_sizes([shape.numel() for shape in shapes])
    return [view.view(shape) for view, shape in zip(views, shapes, strict=True)]


def initial_weights(*sizes: int, last: float) -> list[Tensor]:
    """W and b of each layer: W is orthogonal, times √2, that of the last layer times `last`, and b is 0."""
    found = []
    for k in range(len(sizes) - 1):
        W = torch.empty(sizes[k + 1], sizes[k])
        nn.init.orthogonal_(W, last if k == len(sizes) - 2 else 2**0.5)
        found += [W, torch.zeros(sizes[k + 1])]
    return found
