"""PPO: how a run is put together, step by step."""

from typing import Any

import numpy as np
import pytest
import torch
from gymnasium import spaces
from torch import Tensor

from edugym import MDPEnv
from edugym.deep import PPO
from edugym.deep.curves import Curve, copies
from edugym.deep.ppo import ActorCritic, Adam
from tests.adapters.playing.tasks import Walk

SMALL: dict[str, Any] = {"num_envs": 2, "length": 5, "hidden": 4}


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
    assert run.seed == 8


@pytest.mark.parametrize(("norm", "stepped"), [(0.25, 0.25), (0.5, 0.5), (4.0, 0.5)])
def test_each_step_is_learned_from_so_many_times(norm: float, stepped: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """In another order each time, with gradients as they are, or cut to a norm of 1/2."""
    seen: list[list[float]] = []
    steps: list[tuple[float, float]] = []
    monkeypatch.setattr(
        Adam, "step", lambda self, gradient, rate: steps.append((float(torch.linalg.vector_norm(gradient)), rate))
    )

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

    def evaluated(with_seed: int) -> list[float]:
        curve = Curve("Catch", {}, lambda: run.agent.greedy, 10, 40, with_seed)
        curve.measure(0)
        curve.measure(10)
        returns: list[float] = curve.run(run.agent, 10, with_seed).returns.tolist()
        return returns

    assert run.returns.tolist() == evaluated(seed) != evaluated(0)
    starts = [copies("Catch", 2, {}).reset(seed=number)[0].tolist() for number in (seed, 0)]
    assert first == [starts[0]] != [starts[1]]


def always_right(discount: float, max_steps: int) -> tuple[ActorCritic, list[Tensor], Any]:
    """What two copies that walk to the right play in four steps, where each place has another value."""
    environment = MDPEnv(Walk(max_steps=max_steps))
    ppo = PPO.create(environment, num_envs=2, length=4, discount=discount, trace_decay=0.0)
    env = copies(environment, 2, {})
    net = ActorCritic(env.single_observation_space, env.single_action_space, 3)
    net.weights.zero_()
    net.actor.weights[-1][1] = 60.0
    W1, _, W2, _, W3, b3 = net.critic.weights
    W1[0], W2[0, 0], W3[0, 0] = torch.tensor([0.1, 0.2, 0.3, 0.4, 0.5]), 1.0, 1.0
    b3.fill_(1.0)
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
    net, (x, action, log_prob, advantages, G), observations = always_right(0.5, max_steps)
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


def test_networks_begin_nearly_without_a_preference() -> None:
    """The last layer is small in the actor, and of norm 1 in the critic; σ is e^-0.5."""
    net = ActorCritic(spaces.Discrete(3), spaces.Box(-1.0, 1.0, (2,)), 6)
    actor, critic = net.actor.weights[4], net.critic.weights[4]
    torch.testing.assert_close(actor @ actor.T, 1e-4 * torch.eye(2))
    torch.testing.assert_close(critic @ critic.T, torch.ones(1, 1))
    assert net.log_std.tolist() == [-0.5, -0.5]
    assert [len(layer) for layer in net.actor.weights[::2]] == [6, 6, 2]


@pytest.mark.parametrize(
    ("actions", "outputs", "likeliest"),
    [
        (spaces.Discrete(3, start=5), [0.0, 2.0, 1.0], 6),
        (spaces.MultiDiscrete([2, 3], start=[0, 4]), [1.0, 0.0, 5.0, 6.0, 7.0], [0, 6]),
        (spaces.Box(np.array([-1, 0, 0], np.float32), np.array([1, 5, 1], np.float32)), [-3.0, 2.5, 9.0], [-1, 2.5, 1]),
    ],
)
def test_the_likeliest_action(actions: spaces.Space[Any], outputs: list[float], likeliest: Any) -> None:
    """In the numbers of the space, and within its bounds; it does not depend on chance."""
    net = ActorCritic(spaces.Discrete(2), actions, 4)
    net.weights.zero_()
    net.actor.weights[-1].copy_(torch.tensor(outputs))
    assert net.greedy(np.array([0, 1])).tolist() == [likeliest] * 2


def test_a_curve_has_eleven_points_unless_told_otherwise() -> None:
    """One at each tenth of the steps; a run that is too short for that has one after each step."""
    ppo = PPO.create("Catch", num_envs=1, length=10, hidden=2, minibatches=1, epochs=1)
    assert ppo.train(100, evaluation_episodes=1).steps.tolist() == [*range(0, 101, 10)]
    assert ppo._replace(length=2).train(2, evaluation_episodes=1).steps.tolist() == [0, 1, 2]
