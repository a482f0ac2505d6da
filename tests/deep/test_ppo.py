"""PPO: its estimates and objective by hand, how a run is put together, every kind of space, and what it learns."""

from typing import Any

import numpy as np
import pytest
import torch
from gymnasium import spaces
from torch import Tensor
from torch.distributions import Categorical, Normal
from torch.nn import functional

from edugym import MDPEnv, QLearning, profile
from edugym.deep import PPO
from edugym.deep.actor_critic import ActorCritic, Gaussian, Softmax
from edugym.deep.curves import Curve, copies
from edugym.deep.ppo import Adam, advantages_of, normalised
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.own_training import trains_itself
from tests.adapters.playing.tasks import Walk
from tests.deep.test_curves import measured
from tests.messages import named

SMALL: dict[str, Any] = {"num_envs": 2, "length": 5, "hidden": 4}
TWO = spaces.Discrete(2)
UNEVEN = spaces.Box(np.array([-1, 0, 0], np.float32), np.array([1, 5, 1], np.float32))


def test_advantages_by_hand() -> None:
    """Two copies, γ = λ = 1/2; δ = (1, 0, 2), and (1, -2, 2) in the second copy, whose episode ends with step 2."""
    V = torch.tensor([[1.0, 1], [2, 2], [4, 4], [8, 8]])
    rewards = torch.tensor([[1.0, 1], [0, 0], [2, 2]])
    going_on = torch.tensor([[1.0, 1], [1, 0], [1, 1]])
    assert advantages_of(rewards, going_on, V, 0.5, 0.5).T.tolist() == [[1.125, 0.5, 2.0], [0.5, -2.0, 2.0]]


def test_defaults() -> None:
    """γ is that of all agents; λ and ε are those of the paper's table 3."""
    defaults = PPO._field_defaults
    assert [defaults[name] for name in ("discount", "trace_decay", "clip")] == [0.99, 0.95, 0.2]


def test_weights_begin_orthogonal() -> None:
    """W Wᵀ = 2 I in hidden layers; the last one is small in the actor, and of norm 1 in the critic; σ is e^-0.5."""
    net = ActorCritic(spaces.Discrete(7), spaces.Box(-1.0, 1.0, (2,)), 6)
    for (W, b, _, _, last_W, last_b), norm in ((net.actor.weights, 1e-4), (net.critic.weights, 1.0)):
        torch.testing.assert_close(W @ W.T, 2 * torch.eye(6))
        torch.testing.assert_close(last_W @ last_W.T, norm * torch.eye(len(last_W)))
        assert not b.any()
        assert not last_b.any()
    assert net.log_std.tolist() == [-0.5, -0.5]
    assert [len(layer) for layer in net.actor.weights[::2]] == [6, 6, 2]


def test_draws() -> None:
    """A softmax with p = (1/4, 3/4), and a Gaussian with μ = 1 and σ = 2."""
    torch.manual_seed(0)
    chosen = Softmax([torch.tensor([[0.25, 0.75]]).log().expand(10_000, 2)]).sample()
    assert chosen.shape == (10_000, 1)
    assert float(chosen.double().mean()) == pytest.approx(0.75, abs=0.02)
    drawn = Gaussian(torch.ones(10_000, 1), torch.tensor([2.0]).log()).sample()
    assert [float(drawn.mean()), float(drawn.std())] == pytest.approx([1.0, 2.0], abs=0.1)


def objective(ppo: PPO, net: ActorCritic, data: list[Tensor]) -> Tensor:
    """The objective as the class says it, by torch's own distributions; torch can take its derivatives."""
    x, action, old_log_prob, advantage, G = data

    def run(weights: list[Tensor]) -> Tensor:
        W1, b1, W2, b2, W3, b3 = weights
        y: Tensor = functional.linear(functional.linear(functional.linear(x, W1, b1).tanh(), W2, b2).tanh(), W3, b3)
        return y

    y, V = run(net.actor.weights), run(net.critic.weights)[:, 0]
    if isinstance(net.actions, spaces.Box):
        normal: Any = Normal(y, net.log_std.exp())
        log_prob, entropy = normal.log_prob(action).sum(-1), normal.entropy().sum(-1)
    else:
        parts: list[Any] = [Categorical(logits=part) for part in y.split_with_sizes(net.sizes, -1)]
        log_prob = torch.stack([part.log_prob(action[:, k]) for k, part in enumerate(parts)]).sum(0)
        entropy = torch.stack([part.entropy() for part in parts]).sum(0)
    ratio = (log_prob - old_log_prob).exp()
    gain = torch.min(ratio * advantage, ratio.clamp(1 - ppo.clip, 1 + ppo.clip) * advantage)
    total: Tensor = (gain - (V - G) ** 2 / 2 + ppo.entropy_bonus * entropy).mean()
    return total


@pytest.mark.parametrize("bonus", [0.0, 0.3])
@pytest.mark.parametrize(
    "actions", [spaces.Discrete(3), spaces.MultiDiscrete([2, 4]), spaces.Box(-1.0, 1.0, (2,), np.float64)]
)
def test_the_gradient_is_that_of_the_objective(actions: spaces.Space[Any], bonus: float) -> None:
    """What is written out equals what torch finds, in double precision, with ratios on both sides of the bounds."""
    torch.manual_seed(1)
    ppo = PPO.create("Catch", entropy_bonus=bonus)
    net = ActorCritic(spaces.Box(-1.0, 1.0, (5,), np.float64), actions, 7)
    net.set_weights(torch.randn(len(net.weights), dtype=torch.float64))
    x = torch.randn(200, 5, dtype=torch.float64)
    policy = net.policy(net.actor(x))
    action = policy.sample()
    old = policy.log_prob(action) + 0.3 * torch.randn(200, dtype=torch.float64)
    data = [x, action, old, normalised(torch.randn(200, dtype=torch.float64)), torch.randn(200, dtype=torch.float64)]
    ratio = (policy.log_prob(action) - old).exp()
    assert (ratio > 1 + ppo.clip).any()
    assert (ratio < 1 - ppo.clip).any()
    found = ppo.gradient(net, *data)
    learned = [*net.actor.weights, *net.critic.weights, net.log_std]
    for part in learned:
        part.requires_grad_()
    wanted = torch.autograd.grad(objective(ppo, net, data), learned, allow_unused=True)
    by_torch = [torch.zeros_like(part) if of is None else of for part, of in zip(learned, wanted, strict=True)]
    torch.testing.assert_close(found, torch.cat([part.ravel() for part in by_torch]))


def test_adam_is_that_of_torch() -> None:
    """Steps uphill at a falling rate, to the same bits."""
    torch.manual_seed(0)
    weights = torch.randn(100)
    ours, theirs = Adam.create(weights.clone()), torch.optim.Adam([weights], eps=1e-5, fused=True, maximize=True)
    for t in range(20):
        rate, weights.grad = 0.1 / (t + 1), torch.randn(100)
        ours.step(weights.grad, rate)
        theirs.param_groups[0]["lr"] = rate
        theirs.step()
    assert torch.equal(ours.weights, weights)


@pytest.mark.parametrize(
    ("space", "observations", "inputs"),
    [
        (spaces.MultiDiscrete([2, 3]), [[0, 2], [1, 0]], [[1, 0, 0, 0, 1], [0, 1, 1, 0, 0]]),  # ones and zeros
        (spaces.Discrete(3, start=5), [6], [[0, 1, 0]]),
        (spaces.Box(0, 255, (1, 2), np.uint8), [[[255, 51]]], [[1.0, 0.2]]),  # colours as shares of 255
        (spaces.Box(-128, 127, (1,), np.int8), [[-64]], [[-0.5]]),
        (spaces.Box(-np.inf, np.inf, (1,), np.float32), [[3.0]], [[3.0]]),  # unbounded numbers as they are
        (spaces.Box(-np.finfo(np.float32).max, np.finfo(np.float32).max, (1,), np.float32), [[3.0]], [[3.0]]),
    ],
)
def test_what_it_sees(space: spaces.Space[Any], observations: Any, inputs: list[list[float]]) -> None:
    """Whole numbers as ones and zeros, one after the other; others as shares of their bounds."""
    seen = ActorCritic(space, TWO, 4).inputs_of(np.array(observations, space.dtype))
    assert seen.numpy() == pytest.approx(np.array(inputs))


@pytest.mark.parametrize(
    ("actions", "outputs", "likeliest", "n"),
    [
        (spaces.Discrete(3, start=5), [0.0, 2.0, 1.0], 6, 3),
        (spaces.MultiDiscrete([2, 3], start=[0, 4]), [0.2, 0.0, 0.0, 0.3, 0.6], [0, 6], 6),
        (UNEVEN, [-3.0, 2.5, 9.0], [-1, 2.5, 1], 40),
    ],
)
def test_every_kind_of_action(actions: spaces.Space[Any], outputs: list[float], likeliest: Any, n: int) -> None:
    """In the numbers of the space, and within its bounds; samples are different, and the likeliest one is not."""
    torch.manual_seed(0)
    net = ActorCritic(TWO, actions, 4)
    net.weights.zero_()
    net.actor.weights[-1].copy_(torch.tensor(outputs))
    assert net.greedy(np.array([0, 1])).tolist() == [likeliest] * 2
    policy = net.policy(net.actor(net.inputs_of(np.zeros(50, np.int64))))
    drawn = policy.sample()
    assert policy.log_prob(drawn).shape == (50,)
    given = net.for_environment(drawn)
    assert all(actions.contains(action) for action in given)
    assert len({str(action) for action in given}) >= n


@pytest.mark.parametrize("actions", [spaces.MultiBinary(3), spaces.Box(-1, 1, (2, 2)), spaces.Box(-1, 1, ())])
def test_actions_of_another_kind_are_refused(actions: spaces.Space[Any]) -> None:
    """The message names the space."""
    with pytest.raises(ValueError, match=r"PPO needs actions that .* vectors, but the action space is"):
        ActorCritic(TWO, actions, 4)


def test_the_learning_rate_falls_evenly(monkeypatch: pytest.MonkeyPatch) -> None:
    """In three updates of 10 steps; 9 more are no whole update. The optimizer is the same one all the time."""
    rates, optimizers = [], []

    def learn(self: PPO, net: ActorCritic, optimizer: Adam, learning_rate: float, data: list[Tensor]) -> None:
        rates.append(learning_rate)
        optimizers.append(optimizer)
        assert optimizer.weights is net.weights
        assert [len(column) for column in data] == [10] * 5

    monkeypatch.setattr(PPO, "learn", learn)
    run = PPO.create("Catch", learning_rate=0.3, **SMALL).train(39, evaluate_every=7, evaluation_episodes=1, seed=8)
    assert rates == pytest.approx([0.3, 0.2, 0.1])
    assert len({id(optimizer) for optimizer in optimizers}) == 1
    assert run.steps.tolist() == [0, 8, 16, 24, 30]  # where both copies have taken as many steps
    assert PPO.create("Catch", **SMALL).train(100, evaluation_episodes=1).steps.tolist() == [*range(0, 101, 10)]
    assert run.seed == 8


@pytest.mark.parametrize(("norm", "stepped"), [(0.25, 0.25), (0.5, 0.5), (4.0, 0.5)])
def test_each_step_is_learned_from_so_many_times(norm: float, stepped: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """In another order each time, with gradients as they are, or cut to a norm of 1/2."""
    seen: list[list[float]] = []
    steps: list[tuple[float, float]] = []
    monkeypatch.setattr(Adam, "step", lambda self, found, rate: steps.append((float(found.norm()), rate)))

    def gradient(self: PPO, net: ActorCritic, x: Tensor, *data: Tensor) -> Tensor:
        assert all(torch.equal(column, x) for column in data)
        seen.append(x.tolist())
        return torch.full((4,), norm / 2)

    monkeypatch.setattr(PPO, "gradient", gradient)
    ppo = PPO.create("Catch", epochs=3, minibatches=2, **SMALL)
    net = ActorCritic(spaces.Discrete(2), spaces.Discrete(2), 2)
    torch.manual_seed(0)
    ppo.learn(net, Adam.create(net.weights), 0.125, [torch.arange(10.0)] * 5)
    epochs = [seen[k] + seen[k + 1] for k in (0, 2, 4)]
    assert [sorted(epoch) for epoch in epochs] == [[*range(10)]] * 3
    assert len({tuple(epoch) for epoch in epochs}) == 3
    assert [norm for norm, _ in steps] == pytest.approx([stepped] * 6)
    assert [rate for _, rate in steps] == [0.125] * 6


@pytest.mark.parametrize("seed", [3, 4])
def test_the_seed_decides_which_episodes_are_played(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """In training, and in evaluation: a network that learns nothing plays those of a curve with this seed."""
    first, play = [], PPO.play

    def watched(self: PPO, env: Any, net: ActorCritic, observations: Any, *rest: Any) -> Any:
        first.append(observations.tolist())
        return play(self, env, net, observations, *rest)

    monkeypatch.setattr(PPO, "learn", lambda *given: None)
    monkeypatch.setattr(PPO, "play", watched)
    run = PPO.create("Catch", **SMALL).train(10, evaluate_every=10, evaluation_episodes=40, seed=seed)
    evaluated = [measured("Catch", lambda: run.agent.greedy, 40, (0, 10), with_seed) for with_seed in (seed, 0)]
    assert run.returns.tolist() == evaluated[0] != evaluated[1]
    starts = [copies("Catch", 2, {}).reset(seed=number)[0].tolist() for number in (seed, 0)]
    assert first == [starts[0]] != [starts[1]]


def always_right(max_steps: int) -> tuple[ActorCritic, list[Tensor], Any]:
    """What two copies that walk to the right play in four steps, where each place has another value."""
    environment = MDPEnv(Walk(max_steps=max_steps))
    ppo = PPO.create(environment, num_envs=2, length=4, discount=0.5, trace_decay=0.0)
    env = copies(environment, 2, {})
    net = ActorCritic(env.single_observation_space, env.single_action_space, 3)
    net.weights.zero_()
    net.actor.weights[-1][1] = 60.0
    W1, _, W2, _, W3, b3 = net.critic.weights
    W1[0], W2[0, 0], W3[0, 0], b3[0] = torch.tensor([0.1, 0.2, 0.3, 0.4, 0.5]), 1.0, 1.0, 1.0
    curve = Curve(environment, {}, lambda: net.greedy, 1_000, 1, 0)
    curve.measure(0)
    data, observations = ppo.play(env, net, env.reset(seed=0)[0], curve, 0)
    return net, data, observations


@pytest.mark.parametrize(
    ("max_steps", "places"),
    [
        (4, [2, 3, 2, 3]),  # the right end is reached in two steps, and pays 1.5: nothing comes after it
        (1, [2, 2, 2, 2]),  # cut off at place 3, whose value counts, and not that of the place of the next episode
    ],
)
def test_what_each_step_is_worth(max_steps: int, places: list[int]) -> None:
    """By the definition with λ = 0: R + γ V(S') - V(S); and G is R + γ V(S')."""
    net, (x, action, log_prob, advantages, G), observations = always_right(max_steps)
    V = {place: float(net.critic(net.inputs_of(np.array([place])))) for place in range(5)}
    assert len({*V.values()}) == 5
    targets = [1.5 if place == 3 else 0.5 * V[3] for place in places]
    assert G.reshape(4, 2).T.tolist() == [pytest.approx(targets)] * 2
    by_hand = [target - V[place] for target, place in zip(targets, places, strict=True)]
    assert advantages.reshape(4, 2).T.tolist() == [pytest.approx(by_hand, abs=1e-6)] * 2
    assert x.argmax(1).reshape(4, 2).T.tolist() == [places] * 2
    assert action.flatten().tolist() == [1] * 8
    assert log_prob.tolist() == [0.0] * 8
    assert observations.tolist() == [2, 2]


@pytest.mark.parametrize("name", ["Catch", "Trashbot", "Boulder", "Tamagotchi", "Pendulum-v1"])
def test_it_runs_everywhere_and_repeats(name: str) -> None:
    """Every kind of observation and action: the same seed gives the same run, another one another."""
    ppo = PPO.create(name, num_envs=4, length=8, hidden=8, epochs=2)
    stream = torch.random.get_rng_state()
    runs = [ppo.train(96, seed=seed, evaluate_every=32, evaluation_episodes=2) for seed in (1, 1, 2)]
    assert torch.equal(torch.random.get_rng_state(), stream)
    assert runs[0].steps.tolist() == [0, 32, 64, 96]
    weights = [run.agent.weights for run in runs]
    assert torch.equal(weights[0], weights[1])
    assert not torch.equal(weights[0], weights[2])
    assert np.array_equal(runs[0].returns, runs[1].returns)


@pytest.mark.parametrize(
    ("created", "trained", "message"),
    [
        ({}, {"n_steps": 100}, named("n_steps", 2048, 100)),
        ({}, {"n_steps": 2_048, "evaluate_every": 0}, named("evaluate_every", 1, 0)),
        ({"num_envs": 2, "length": 3}, {}, named("minibatches", 1, 3, 4)),
        ({"environment": None}, {}, "environment must be"),
        ({"parameters": {"colour": "red"}}, {}, "has no parameter 'colour'"),
    ],
)
def test_wrong_arguments_are_refused(created: Any, trained: Any, message: str) -> None:
    """Too few steps for an update, no environment; `test_settings` looks at the ranges."""
    with pytest.raises(ValueError, match=message):
        PPO.create(**{"environment": "Catch", **created}).train(**trained)


def test_it_learns_catch() -> None:
    """Nearly every ball, from the grid, in 30 000 steps; with hardly any learning, few."""
    assert PPO.create("Catch").train(30_000).returns[-1] > 0.95
    assert PPO.create("Catch", learning_rate=1e-12).train(10_000).returns[-1] < 0.5


@pytest.mark.slow
def test_it_learns_cart_pole() -> None:
    """Above 475 of 500, where Gymnasium counts it as solved (over 21 seeds at least 496); not before learning."""
    settings: dict[str, Any] = {"num_envs": 32, "length": 64, "epochs": 6, "learning_rate": 3e-3, "clip": 0.1}
    ppo = PPO.create("CartPole-v1", discount=0.995, trace_decay=0.98, **settings)
    how = {"evaluate_every": 120_000, "evaluation_episodes": 10}
    before, after = np.transpose([ppo.train(120_000, seed=seed, **how).returns for seed in range(2)])
    assert before.max() < 100
    assert after.min() > 475


def test_it_can_be_profiled() -> None:
    """It trains itself, though it has a method `learn`; a table does not."""
    short = next(ladder for ladder in LADDERS if ladder.name == "Catch")._replace(strengths=(4,), n_steps=4_096)
    found = profile({"PPO": PPO.create}, challenges=[short], repetitions=2, jobs=1)
    assert found.score("PPO", "Catch").n == 2
    assert not trains_itself(QLearning.create((3, 2)))
