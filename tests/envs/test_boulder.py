"""Boulder: an episode on paper, and the number of steps that a random climber needs."""

from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym.adapters.registration import make_mdp
from edugym.envs.boulder import Boulder
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.contract.described import LAYOUT_SEEDS, NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused
from tests.envs.classes import BoulderEnv

PARAMETERS = Parameters(
    valid=st.fixed_dictionaries(
        {"height": st.integers(1, 15), "n_grips": st.integers(2, 5)},
        optional={"max_steps": st.integers(1, 60), "layout_seed": LAYOUT_SEEDS},
    ),
    corners=(
        {},
        {"height": 1, "max_steps": 1},
        {"height": 100, "max_steps": 120},
        {"height": 3, "n_grips": 50, "layout_seed": 2**63},
    ),
    bad=(
        *refused("height", 0, -1, 10**6 + 1, 10**400, *NO_WHOLE_NUMBER),
        *refused("n_grips", 1, -2, 1001, 10**9, *NO_WHOLE_NUMBER),
        *refused("max_steps", *NO_STEPS),
        *refused("layout_seed", -1, *NO_WHOLE_NUMBER),
    ),
    finite=({}, {"height": 1}, {"height": 4, "n_grips": 7, "layout_seed": 3}),
    random=False,
    informed=lambda info, _: max(info["right_grip"], 0),
)


def test_an_episode() -> None:
    """Three right grips lead to the top; a wrong one on the way to the ground, which is no end."""
    env = BoulderEnv(height=3)
    assert env.mdp.grips.tolist() == [1, 1, 1]
    assert env.reset(seed=0) == (0, {"right_grip": 1})
    for action, seen in (
        (1, (1, 0.0, False, False, {"right_grip": 1})),
        (0, (0, 0.0, False, False, {"right_grip": 1})),
        (0, (0, 0.0, False, False, {"right_grip": 1})),
        (1, (1, 0.0, False, False, {"right_grip": 1})),
        (1, (2, 0.0, False, False, {"right_grip": 1})),
        (1, (3, 1.0, True, False, {"right_grip": -1})),
    ):
        assert env.step(action) == seen


@pytest.mark.parametrize(
    ("parameters", "grips"),
    [
        ({}, [1, 1, 1, 0, 0, 0, 0, 0, 0, 1]),
        ({"n_grips": 5, "layout_seed": 7}, [4, 3, 3, 4, 2, 3, 4, 1, 0, 1]),
        ({"height": 4}, [1, 1, 1, 0]),
    ],
)
def test_layouts(parameters: dict[str, Any], grips: list[int]) -> None:
    """The walls that these parameters name are the same on every machine and in every version."""
    assert make_mdp("Boulder", **parameters).grips.tolist() == grips


def test_grips_are_uniform() -> None:
    """At every height each grip holds equally often, over layouts."""
    layouts = np.array([make_mdp("Boulder", height=6, n_grips=3, layout_seed=seed).grips for seed in range(900)])
    counts = np.array([(layouts == grip).sum(axis=0) for grip in range(3)])
    assert np.abs(counts - 300).max() < 5 * np.sqrt(900 * (1 / 3) * (2 / 3))


@pytest.mark.parametrize("n_grips", [2, 7])
@pytest.mark.parametrize("height", [1, 5, 10])
def test_random_climber(height: int, n_grips: int) -> None:
    """A random climber needs (N^(H+1) - N)/(N - 1) steps: the linear equations of the exact model agree."""
    model = finite_model(make_mdp("Boulder", height=height, n_grips=n_grips, layout_seed=5))
    p = model.p.mean(axis=1)[: height + 1, : height + 1]
    climbing = ~model.terminal
    steps = np.linalg.solve(np.eye(height) - p[np.ix_(climbing, climbing)], np.ones(height))
    expected = (n_grips ** (height + 1) - n_grips) / (n_grips - 1)
    assert steps[0] == pytest.approx(expected, rel=1e-6)
    assert (height, n_grips) != (10, 2) or str(round(expected)) in (Boulder.__doc__ or "")


def test_best_return() -> None:
    """The best return is 1, in as many steps as the wall is high; with a step less it is 0."""
    for height in (1, 10, 30):
        model = finite_model(make_mdp("Boulder", height=height))
        assert len(model.states) == height + 1
        assert value_iteration(model).start == 1.0
        assert value_iteration(model, horizon=height).start == 1.0
        assert value_iteration(model, discount=0.5).start == pytest.approx(0.5 ** (height - 1))
    assert value_iteration(finite_model(make_mdp("Boulder")), horizon=9).start == 0.0


@pytest.mark.parametrize(("parameters", "limit"), [({}, 100), ({"height": 3}, 30), ({"height": 5, "max_steps": 7}, 7)])
def test_step_limit(parameters: dict[str, Any], limit: int) -> None:
    """A climber who never gets up is stopped after 10 steps for each height, unless told otherwise."""
    env = BoulderEnv(**parameters)
    env.reset(seed=0)
    wrong = 1 - int(env.mdp.grips[0])
    seen = [env.step(wrong) for _ in range(limit)]
    assert all(step == (0, 0.0, False, False, {"right_grip": 1 - wrong}) for step in seen[:-1])
    assert seen[-1] == (0, 0.0, False, True, {"right_grip": 1 - wrong})


def test_the_top_at_the_last_moment() -> None:
    """Who reaches the top in the last step has reached it: terminated, not truncated."""
    env = BoulderEnv(height=4, max_steps=4)
    env.reset(seed=0)
    assert [env.step(int(grip))[1:4] for grip in env.mdp.grips] == [(0.0, False, False)] * 3 + [(1.0, True, False)]
