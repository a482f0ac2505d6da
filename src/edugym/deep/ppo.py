"""Proximal policy optimisation, whole: for any observations that are numbers and any of Gymnasium's simple actions."""

from collections.abc import Mapping
from typing import Annotated, Any, NamedTuple

import numpy as np
import torch
from gymnasium import spaces
from torch import Tensor, nn
from torch.distributions import Categorical, Independent, Normal

from edugym.agents.settings import Discount, LearningRate, Probability, Range, new, shows_settings
from edugym.agents.vectors import vector_length
from edugym.checks import whole_number
from edugym.deep.curves import Curve, copies, one_thread
from edugym.mdp.tabular import table_lows, table_sizes
from edugym.training.train import Run

Whole = Annotated[int, Range(1)]


@shows_settings
class PPO(NamedTuple):
    """Policy gradients in small steps: many copies play, and the policy may not move far from the one that played.

        ratio = π(A|S) / π_old(A|S)
        maximise the mean of min(ratio Â, clip(ratio, 1 - ε, 1 + ε) Â) - (V(S) - G)²/2 + c · entropy of π(·|S)
        Â_t = δ_t + γλ Â_t+1,  δ_t = R_t+1 + γ V(S_t+1) - V(S_t),  G_t = Â_t + V(S_t)

    Attributes:
        environment: the name of an environment of this package, an id that Gymnasium knows, or an `MDPEnv`.
        parameters: those of an environment that is given by name.
        num_envs: how many copies play, 1 or more.
        length: steps that each copy plays between two updates, 1 or more.
        epochs: how many times each step is learned from, 1 or more.
        minibatches: into how many parts the steps are divided for learning, 1 or more.
        hidden: units in each of the two hidden layers of each network, 1 or more.
        learning_rate: of Adam, greater than 0 and up to 1; it falls evenly to 0.
        discount: γ, from 0 to 1.
        trace_decay: λ, from 0 to 1.
        clip: ε, greater than 0.
        entropy_bonus: c, 0 or more.

    Choices where Schulman et al. (2017) leave them open, or deviations: policy and value function are two networks, and
    the coefficient of the value loss is 1; advantages are normalised in each minibatch, and values are not clipped; the
    gradient of both networks together is clipped to a norm of 0.5; ε of Adam is 1e-5; weights are orthogonal, and small
    in the last layer of the policy; inputs are divided by their bounds, and rewards are not scaled; σ of real actions
    starts at e^-0.5 and does not depend on the state, and actions are cut off at the bounds of the space; a terminal
    state is worth 0, and a truncated episode V of its last state.

    References: Schulman et al. (2017), Proximal policy optimization algorithms, equations 7, 9, 11 and 12 and algorithm
    1; Schulman et al. (2016) for Â; Huang et al. (2022), The 37 implementation details of proximal policy
    optimization.
    """

    environment: Any
    parameters: Any
    num_envs: Whole = 64
    length: Whole = 32
    epochs: Whole = 10
    minibatches: Whole = 4
    hidden: Whole = 64
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
            evaluate_every: steps between two points of the curve; by default a tenth of `n_steps`.
            evaluation_episodes: how many episodes each point averages, played by the likeliest actions.
            seed: the same seed gives the same run.

        Returns:
            As `edugym.train`; its `agent` is the `ActorCritic`.

        Raises:
            ValueError: a parameter is not as above.
        """
        updates = whole_number("n_steps", n_steps, self.num_envs * self.length) // (self.num_envs * self.length)
        with one_thread():
            torch.manual_seed(whole_number("seed", seed, 0))
            env = copies(self.environment, self.num_envs, self.parameters)
            net = ActorCritic(env.single_observation_space, env.single_action_space, self.hidden)
            optimizer = torch.optim.Adam(net.parameters(), self.learning_rate, eps=1e-5, fused=True)
            every = evaluate_every or max(1, n_steps // 10)
            curve = Curve(self.environment, self.parameters, lambda: net.greedy, every, evaluation_episodes, seed)
            curve.measure(0)
            observations, _ = env.reset(seed=seed)
            for update in range(updates):
                optimizer.param_groups[0]["lr"] = self.learning_rate * (1 - update / updates)
                done = update * self.num_envs * self.length
                data, observations = self.play(env, net, observations, curve, done)
                self.learn(net, optimizer, data)
            return curve.run(net, updates * self.num_envs * self.length, seed)

    def play(self, env: Any, net: "ActorCritic", observations: Any, curve: Curve, done: int) -> Any:
        """Play `length` steps in every copy, and judge every action; shapes (length · n, ...)."""
        n, T = self.num_envs, self.length
        X, A, log_probs = [], [], []
        rewards, going_on = torch.zeros(T, n), torch.zeros(T, n)
        with torch.no_grad():
            for t in range(T):
                x = net.numbers(observations)
                policy = net.policy(x)
                action = policy.sample()
                X.append(x)
                A.append(action)
                log_probs.append(policy.log_prob(action))
                observations, reward, terminated, truncated, infos = env.step(net.given(action))
                over = terminated | truncated
                rewards[t], going_on[t] = torch.as_tensor(reward), torch.as_tensor(~over)
                for i in np.flatnonzero(truncated & ~terminated):  # what would have come is worth V
                    last = net.numbers(np.asarray(infos["final_obs"][i])[None])
                    rewards[t, i] += self.discount * net.value(last)[0]
                curve.add(done + (t + 1) * n, reward, over)
            V = net.value(torch.stack([*X, net.numbers(observations)]))  # (T + 1, n)
            advantages = advantages_of(rewards, going_on, V, self.discount, self.trace_decay)
            parts = (torch.stack(X), torch.stack(A), torch.stack(log_probs), advantages, advantages + V[:-1])
        return [part.flatten(0, 1) for part in parts], observations

    def learn(self, net: "ActorCritic", optimizer: Any, data: list[Tensor]) -> None:
        """Take steps up the objective, from each action `epochs` times."""
        for _ in range(self.epochs):
            for rows in torch.randperm(len(data[0])).chunk(self.minibatches):
                x, action, old_log_prob, advantage, G = (part[rows] for part in data)
                policy = net.policy(x)
                ratio = (policy.log_prob(action) - old_log_prob).exp()
                gain = clipped_gain(ratio, normalised(advantage), self.clip).mean()
                value_loss = 0.5 * (net.value(x) - G).pow(2).mean()
                loss = -gain + value_loss - self.entropy_bonus * policy.entropy().mean()
                optimizer.zero_grad()
                loss.backward()
                nn.utils.clip_grad_norm_(net.parameters(), 0.5)
                optimizer.step()

    @classmethod
    def create(cls, environment: Any, parameters: Mapping[str, Any] | None = None, **settings: Any) -> "PPO":
        """The algorithm for an environment; settings: see the class.

        Raises:
            ValueError: a setting is not as the class says, or there is no such environment.
        """
        copies(environment, 1, parameters or {})
        return new(cls, None, {"environment": environment, "parameters": dict(parameters or {}), **settings})


def advantages_of(rewards: Tensor, going_on: Tensor, V: Tensor, discount: float, trace_decay: float) -> Tensor:
    """Generalised advantage estimates Â, shape (T, n).

    Args:
        rewards: shape (T, n).
        going_on: shape (T, n): 0 where the step ended an episode, else 1.
        V: shape (T + 1, n): the value of the state before each step, and of the last.
        discount: γ.
        trace_decay: λ.
    """
    advantages, after = torch.zeros_like(rewards), torch.zeros_like(rewards[0])
    for t in reversed(range(len(rewards))):
        delta = rewards[t] + discount * going_on[t] * V[t + 1] - V[t]
        advantages[t] = after = delta + discount * trace_decay * going_on[t] * after
    return advantages


def clipped_gain(ratio: Tensor, advantage: Tensor, clip: float) -> Tensor:
    """The objective of each step: it gains nothing from a ratio beyond 1 ± ε (equation 7)."""
    return torch.min(ratio * advantage, ratio.clamp(1 - clip, 1 + clip) * advantage)


def normalised(x: Tensor) -> Tensor:
    """With a mean of 0 and a standard deviation of 1."""
    return (x - x.mean()) / (x.std(correction=0) + 1e-8)


class ActorCritic(nn.Module):
    """A policy and a value function: two networks with two hidden layers each."""

    def __init__(self, observations: spaces.Space[Any], actions: spaces.Space[Any], hidden: int) -> None:
        """See the class.

        Raises:
            ValueError: observations are not numbers, or actions not `Discrete`, `MultiDiscrete` or vectors of reals.
        """
        super().__init__()
        self.observations, self.actions = observations, actions
        if isinstance(actions, spaces.Box) and len(actions.shape) == 1:
            self.sizes = [actions.shape[0]]
        elif isinstance(actions, spaces.Discrete | spaces.MultiDiscrete):
            self.sizes = list(table_sizes(actions))
        else:
            raise ValueError(f"PPO needs actions that are whole numbers or vectors, but the action space is {actions}")
        n_inputs = vector_length(observations)
        self.actor = layers(n_inputs, hidden, hidden, sum(self.sizes), last=0.01)
        self.critic = layers(n_inputs, hidden, hidden, 1, last=1.0)
        self.log_std = nn.Parameter(torch.full((self.sizes[0],), -0.5))
        if isinstance(observations, spaces.Box):
            largest = np.maximum(*np.abs((observations.low.ravel(), observations.high.ravel()))).astype(float)
            self.scale = torch.as_tensor(np.where((largest > 0) & (largest < 1e9), 1 / np.maximum(largest, 1e-9), 1))

    def numbers(self, observations: Any) -> Tensor:
        """Observations as vectors, shape (n, n_inputs): numbers over the largest allowed, or ones and zeros."""
        seen = np.asarray(observations).reshape(len(observations), -1)
        if isinstance(self.observations, spaces.Box):
            return (torch.as_tensor(seen) * self.scale).float()
        sizes, x = table_sizes(self.observations), torch.zeros(len(seen), vector_length(self.observations))
        first = np.cumsum([0, *sizes[:-1]]) - np.array(table_lows(self.observations))
        return x.scatter_(1, torch.as_tensor(seen + first), 1.0)

    def policy(self, x: Tensor) -> Any:
        """The distribution π(·|s)."""
        y = self.actor(x)
        if isinstance(self.actions, spaces.Box):
            return Independent(Normal(y, self.log_std.exp(), validate_args=False), 1)
        return Several([Categorical(logits=part, validate_args=False) for part in y.split(self.sizes, -1)])

    def value(self, x: Tensor) -> Tensor:
        """V(s), shape (n,)."""
        value: Tensor = self.critic(x).squeeze(-1)
        return value

    def given(self, actions: Tensor) -> Any:
        """Actions as the environment takes them."""
        if isinstance(self.actions, spaces.Box):
            return np.clip(actions.numpy(), self.actions.low, self.actions.high)
        whole = actions.numpy() + np.array(table_lows(self.actions))
        return whole[:, 0] if isinstance(self.actions, spaces.Discrete) else whole

    def greedy(self, observations: Any, first: Any = None) -> Any:
        """The likeliest actions for observations of shape (n, ...)."""
        with torch.no_grad():
            return self.given(self.policy(self.numbers(observations)).mode)


class Several(NamedTuple):
    """The distribution of one or several whole numbers, each with probabilities of its own."""

    parts: list[Any]  # of Categorical, whose methods have no types

    def sample(self) -> Tensor:
        """Shape (n, n_numbers)."""
        return torch.stack([part.sample() for part in self.parts], -1)

    def log_prob(self, actions: Tensor) -> Tensor:
        """Of all numbers together, shape (n,)."""
        logs = [part.log_prob(actions[..., k]) for k, part in enumerate(self.parts)]
        return torch.stack(logs).sum(0)

    def entropy(self) -> Tensor:
        """Likewise."""
        return torch.stack([part.entropy() for part in self.parts]).sum(0)

    @property
    def mode(self) -> Tensor:
        """The likeliest numbers, shape (n, n_numbers)."""
        return torch.stack([part.mode for part in self.parts], -1)


def layers(*sizes: int, last: float) -> nn.Sequential:
    """Fully connected layers with tanh between them, orthogonal weights, those of the last layer scaled by `last`."""
    parts: list[nn.Module] = []
    for k in range(len(sizes) - 1):
        layer = nn.Linear(sizes[k], sizes[k + 1])
        nn.init.orthogonal_(layer.weight, last if k == len(sizes) - 2 else 2**0.5)
        nn.init.zeros_(layer.bias)
        parts += [layer, nn.Tanh()]
    return nn.Sequential(*parts[:-1])
