"""The networks of PPO: a policy and a value function, with the derivatives that learning needs."""

import math
from typing import Any, NamedTuple

import numpy as np
import torch
from gymnasium import spaces
from torch import Tensor, nn
from torch.nn import functional

from edugym.agents.vectors import input_scale
from edugym.mdp.tabular import table_lows, table_sizes
from edugym.mdp.task import vector_length


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
