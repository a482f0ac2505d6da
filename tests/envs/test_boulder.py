"""Boulder: an episode on paper, and the number of steps that a random climber needs."""

from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym.adapters.registration import find, make_mdp
from edugym.envs.boulder import Boulder
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.contract.described import LAYOUT_SEEDS, NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused

BoulderEnv: Any = find("Boulder").load()

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
    for action, height in ((1, 1), (0, 0), (0, 0), (1, 1), (1, 2)):
        assert env.step(action) == (height, 0.0, False, False, {"right_grip": 1})
    assert env.step(1) == (3, 1.0, True, False, {"right_grip": -1})


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
