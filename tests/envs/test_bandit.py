"""Bandit: pulls on paper, the best return, and arms that drift."""

import re
from math import nan

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym import finite_model, make_environment, make_mdp, policy_evaluation, value_iteration
from edugym.envs.bandit import Bandit
from tests.contract.described import LAYOUT_SEEDS, NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused

PARAMETERS = Parameters(
    valid=st.fixed_dictionaries(
        {"n_arms": st.integers(2, 12), "gap": st.floats(0, 1)},
        optional={"drift": st.floats(0, 1), "max_steps": st.integers(1, 60), "layout_seed": LAYOUT_SEEDS},
    ),
    corners=(
        {},
        {"n_arms": 2, "gap": 0, "drift": 1, "max_steps": 1, "layout_seed": 10**9},
        {"n_arms": 1000, "gap": 1, "drift": 0, "max_steps": 2**62},
    ),
    bad=(
        *refused("n_arms", 1, 1001, *NO_WHOLE_NUMBER),
        *refused("gap", -0.1, 1.1, nan, "1", None, True),
        *refused("drift", -0.1, 1.1, nan, "1", None, True),
        *refused("max_steps", *NO_STEPS),
        *refused("layout_seed", -1, *NO_WHOLE_NUMBER),
    ),
    finite=({}, {"n_arms": 2, "gap": 1.0}, {"n_arms": 4, "gap": 0.5, "drift": 0.3}, {"n_arms": 3, "drift": 1.0}),
    layout={"n_arms": 30},
    endless=True,
)


def test_sure_arms() -> None:
    """With a gap of 1 every reward is known: the best arm always pays, and nothing ever ends but by the step limit."""
    env = make_environment("Bandit", n_arms=3, gap=1, max_steps=4, layout_seed=1)
    _, info = env.reset(seed=0)
    best = info["best_arm"]
    assert info["regret"] == 0.0
    pulls = [best, (best + 1) % 3, (best + 2) % 3, best]
    for step, arm in enumerate(pulls, start=1):
        seen, reward, terminated, truncated, info = env.step(arm)
        assert (seen, reward, terminated, truncated) == (0, float(arm == best), False, step == 4)
        assert info == {"best_arm": best, "regret": float(arm != best)}


@pytest.mark.parametrize(("gap", "best", "other"), [(0.2, 0.6, 0.4), (0.0, 0.5, 0.5), (1.0, 1.0, 0.0)])
def test_the_model(gap: float, best: float, other: float) -> None:
    """One state, which leads to itself; the mean rewards are (1 + gap)/2 and (1 - gap)/2."""
    mdp = make_mdp("Bandit", n_arms=4, gap=gap, layout_seed=3)
    model = finite_model(mdp)
    assert model.states == (mdp.first_best,)
    assert model.p.tolist() == [[[1.0]] * 4]
    expected = [best if arm == mdp.first_best else other for arm in range(4)]
    assert model.r[0] == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize("seed", [0, 7])
def test_how_often_arms_pay(seed: int) -> None:
    """A thousand pulls of each arm, within four standard errors."""
    mdp, rng = make_mdp("Bandit", n_arms=3, gap=0.5), np.random.default_rng(seed)
    for arm in range(3):
        paid = np.mean([mdp.reward(mdp.first_best, arm, mdp.first_best, rng) for _ in range(1000)])
        assert abs(paid - (0.75 if arm == mdp.first_best else 0.25)) < 4 * np.sqrt(0.1875 / 1000)


def test_returns_of_the_docstring() -> None:
    """600 for the best arm in 1000 pulls, 420 for arms at random: a mean reward of 0.6 and of 0.42."""
    mdp = make_mdp("Bandit")
    model = finite_model(mdp)
    assert mdp.reward_threshold == pytest.approx(600)
    assert value_iteration(model, 0.5).start * 0.5 == pytest.approx(0.6)
    assert policy_evaluation(model, np.full((1, 10), 0.1), 0.5).start * 0.5 == pytest.approx(0.42)


def test_drift() -> None:
    """With probability `drift` the best arm moves to any other alike, whatever was pulled; the reward is by the old."""
    mdp = Bandit.create(n_arms=3, gap=0.4, drift=0.25, layout_seed=5)
    model = finite_model(mdp)
    assert model.states == (0, 1, 2)
    assert model.initial.tolist() == [float(state == mdp.first_best) for state in range(3)]
    for action in range(3):
        assert model.p[:, action] == pytest.approx(np.full((3, 3), 0.125) + 0.625 * np.eye(3))
    assert model.r == pytest.approx(np.full((3, 3), 0.3) + 0.4 * np.eye(3))
    assert model.observations().tolist() == [0, 0, 0]
    assert mdp.reward_threshold is None


def test_the_layout_is_drawn_as_the_docstring_says() -> None:
    """Whoever reads it knows the best arm."""
    (drawn,) = re.findall(r"^ *`(numpy.*)`\.$", Bandit.__doc__ or "", re.MULTILINE)
    for layout_seed, n_arms in ((0, 10), (7, 4), (10**9, 1000)):
        best = eval(drawn, {"numpy": np, "layout_seed": layout_seed, "n_arms": n_arms})
        assert Bandit.create(n_arms, layout_seed=layout_seed).first_best == best


def test_layouts_differ() -> None:
    """Every arm is the best one in some layout, about equally often."""
    found = np.bincount([Bandit.create(n_arms=4, layout_seed=seed).first_best for seed in range(400)], minlength=4)
    assert (found > 65).all()
