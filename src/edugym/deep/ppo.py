"""Proximal policy optimisation, whole: for any observations that are numbers and any of Gymnasium's simple actions."""

from collections.abc import Mapping
from typing import Annotated, Any, NamedTuple

import numpy as np
import torch
from torch import Tensor
from torch.nn import functional
from torch.optim.adam import adam
from torch.random import fork_rng

from edugym.agents.settings import Discount, LearningRate, Probability, Range, new, shows_settings
from edugym.checks.parameters import a_dictionary, number_of_steps, whole_number
from edugym.deep.actor_critic import ActorCritic
from edugym.deep.curves import Curve, copies, one_thread
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

    def play(self, env: Any, net: ActorCritic, observations: Any, curve: Curve, done: int) -> Any:
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

    def learn(self, net: ActorCritic, optimizer: "Adam", learning_rate: float, data: list[Tensor]) -> None:
        """Take steps up the objective, from each action `epochs` times."""
        for _ in range(self.epochs):
            for part in torch.randperm(len(data[0])).tensor_split(self.minibatches):
                gradient = self.gradient(net, *(column.index_select(0, part) for column in data))
                gradient *= 0.5 / max(0.5, float(torch.linalg.vector_norm(gradient)))  # its norm is 0.5 at most
                optimizer.step(gradient, learning_rate)

    def gradient(
        self, net: ActorCritic, x: Tensor, action: Tensor, old_log_prob: Tensor, advantage: Tensor, target: Tensor
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
