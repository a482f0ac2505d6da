"""Trashbot: what which actions can reach, at best, by a script, by chance and by learning."""

import itertools
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from edugym.adapters.registration import find
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.envs.trashbot.geometry import SHOULDER_Y, Robot, arm
from edugym.envs.trashbot.planning import ScriptedController, best_plan, joint_angles
from edugym.envs.trashbot.task import DELIVERED, MOVING, START
from tests.envs.trashbot.moves import DEFAULT, RNG, SCALE

TrashbotEnv: Any = find("Trashbot").load()


@pytest.mark.parametrize(
    ("n_bins", "centring", "n_steps"),
    [
        (2, 0.85, 11),
        (3, 1.31, 10),
        (5, 1.89, 11),
        *(pytest.param(*more, marks=pytest.mark.slow) for more in ((4, 1.91, 10), (6, 1.96, 12), (7, 1.94, 11))),
        *(pytest.param(*more, marks=pytest.mark.slow) for more in ((9, 1.97, 10), (11, 1.99, 13))),
    ],
)
def test_more_bins_centre_better(n_bins: int, centring: float, n_steps: int) -> None:
    """The exact search finds what the docstring says, and to play its plan returns that, plus 3."""
    env = TrashbotEnv(n_bins)
    plan = best_plan(env.mdp)
    assert (round(plan.centring, 2), len(plan.actions)) == (centring, n_steps)
    assert plan.fewest_steps == 10
    env.reset()
    steps = [env.step(action) for action in plan.actions]
    assert sum(float(reward) for _, reward, *_ in steps) == pytest.approx(3 + plan.centring)
    assert [terminated for _, _, terminated, *_ in steps] == [False] * (n_steps - 1) + [True]


def test_narrower_containers_ask_for_more_bins() -> None:
    """With 3 bins the box gets into the container less and less centred, and in the end not at all."""
    for width, centring in ((0.4, 1.08), (0.35, 0.62)):
        assert round(best_plan(TrashbotEnv(3, container_width=width).mdp).centring, 2) == centring
    with pytest.raises(ValueError, match="n_bins must be higher: with 3 "):
        best_plan(TrashbotEnv(3, container_width=0.3).mdp)
    assert best_plan(TrashbotEnv(5, container_width=0.3).mdp).centring >= 1.57


def test_what_cannot_be_searched() -> None:
    """Continuous actions, a lattice that is not finite or is too large, and an environment in place of its MDP."""
    env: Any = TrashbotEnv(3)
    with pytest.raises(TypeError, match=r"mdp must be that of Trashbot \(`env.unwrapped.mdp`\), but is .*TrashbotEnv"):
        best_plan(env)
    with pytest.raises(ValueError, match="n_bins must leave at most 500000000 moves to try, but 24 make 548467200"):
        best_plan(TrashbotEnv(24).mdp)
    with pytest.raises(ValueError, match="n_bins must be given"):
        best_plan(DEFAULT)
    with pytest.raises(ValueError, match=r"action_scale must divide a full turn .* is 0\.2$"):
        best_plan(TrashbotEnv(3, action_scale=0.2).mdp)


def test_search_interpreted() -> None:
    """On a lattice of few states the search does the same without a compiler, and breadth first means shortest."""
    task = TrashbotEnv(2, container_width=1.0, action_scale=math.tau / 24).mdp
    plan = best_plan(task)
    reached = {(START, False)}
    for n_steps in range(1, plan.fewest_steps + 1):
        found = set()
        for ((shoulder, elbow), holding), action in itertools.product(reached, itertools.product((0, 1), repeat=2)):
            after = task.transition(Robot(shoulder, elbow, holding, 0, MOVING), action, RNG)
            if after.outcome == DELIVERED:
                assert n_steps == plan.fewest_steps
                return
            if after.outcome == MOVING:
                found.add(((round(after.shoulder, 9), round(after.elbow, 9)), after.holding))
        reached = found
    pytest.fail(f"the box cannot be delivered in {plan.fewest_steps} steps")


@given(st.just(SCALE) | st.floats(0.01, 0.3), st.floats(0.2501, 1.0))
def test_scripted_controller(action_scale: float, width: float) -> None:
    """In every task that the constructor accepts there is time to deliver the box, also into a tight container."""
    max_steps = math.ceil(2.5 / action_scale)
    env = TrashbotEnv(container_width=width, action_scale=action_scale, max_steps=max_steps)
    controller, total = ScriptedController(action_scale), 0.0
    observation, _ = env.reset()
    while env.state.outcome == MOVING:
        observation, reward, *_, info = env.step(controller.act(observation, RNG))
        total += float(reward)
    assert total == pytest.approx(5, abs=0.01)
    assert action_scale != SCALE or info["steps"] == 11  # as the docstring says


@pytest.mark.parametrize(
    ("n_bins", "picked_up", "delivered"), [(None, 0.700, 0.011), (3, 0.776, 0.020), (5, 0.720, 0.015)]
)
def test_random_play(n_bins: int | None, picked_up: float, delivered: float) -> None:
    """In how many episodes random actions pick up and deliver the box; it is never centred better than the plan."""
    n = 4_000
    env = MDPVectorEnv(TrashbotEnv(n_bins), n, "SameStep")
    env.reset(seed=0)
    env.action_space.seed(0)
    first, returns, best = np.full(n, True), np.zeros((150, n)), 0.0
    for t in range(150):
        _, rewards, terminated, truncated, _ = env.step(env.action_space.sample())
        assert not truncated.any()
        best = max(best, rewards.max() - 2)
        returns[t] = rewards * first
        first &= ~terminated
    assert not first.any()
    for share, reward in ((picked_up, 1), (delivered, 2)):
        times = (returns >= reward).any(axis=0).sum()
        assert abs(times / n - share) < 5 * math.sqrt(share * (1 - share) / n)
    if n_bins:
        assert best <= best_plan(TrashbotEnv(n_bins).mdp).centring + 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("n_bins", [5, None])
def test_our_ppo_learns(n_bins: int | None) -> None:
    """With the same settings it gets close to the best return, 4.9 or 5, in half of the docstring's steps."""
    pytest.importorskip("torch").set_num_threads(1)
    from edugym.deep import PPO

    settings = {"num_envs": 64, "length": 256, "minibatches": 16, "learning_rate": 1e-3, "discount": 0.999}
    ppo = PPO.create("Trashbot", {"n_bins": n_bins}, **settings)
    curves = [ppo.train(500_000, evaluate_every=50_000, evaluation_episodes=1, seed=seed).returns for seed in range(2)]
    assert all(curve[0] <= 1 for curve in curves)
    assert min(curve[-3:].mean() for curve in curves) > 4


@given(st.floats(-1.4, 1.4), st.floats(-1.0, 1.5), st.sampled_from([-1.0, 1.0]))
def test_inverse_kinematics(x: float, y: float, bend: float) -> None:
    """The angles for a place lead there; one that is out of reach is named."""
    assume(0.25 < math.hypot(x, y - SHOULDER_Y) < 1.79)
    shoulder, elbow = joint_angles(x, y, bend)
    assert arm(shoulder, elbow)[2:] == pytest.approx((x, y))
    assert math.copysign(1, elbow) == bend
    with pytest.raises(ValueError, match=r"in reach of the wrist, but are .*, 2\.5"):
        joint_angles(x, 2.5, bend)
