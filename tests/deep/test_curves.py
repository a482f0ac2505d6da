"""Learning curves of deep agents: how long an evaluation episode may take."""

from typing import Any

import numpy as np
import pytest

pytest.importorskip("torch")

import torch
from gymnasium.vector import AutoresetMode

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.deep.curves import Curve, Policy, copies, one_thread
from tests.adapters.playing.tasks import Walk
from tests.training.tasks import Ring, Stairs


def measured(environment: Any, made: Any, episodes: int, points: Any = (0,), seed: int = 0, **parameters: Any) -> Any:
    """The evaluation returns of a curve at some points; `made` makes a policy."""
    curve = Curve(environment, parameters, made, 10, episodes, seed)
    for steps in points:
        curve.measure(steps)
    return curve.run(None, points[-1], 0).returns.tolist()


def always(action: int, n: int) -> Any:
    """Makes a policy that takes one action in each of `n` copies."""
    return lambda: lambda observations, first: np.full(n, action)


@pytest.mark.parametrize(
    ("environment", "parameters", "returned"),
    [
        (MDPEnv(Ring(1_200)), {}, 1_200),
        (MDPEnv(Ring(7)), {}, 7),
        (MDPEnv(Ring(None)), {}, 1_000),  # where it has no limit, as in `edugym.train`
        ("Acrobot-v1", {}, -500),  # whose reward is -1 at every step
        ("Acrobot-v1", {"max_episode_steps": 1_100}, -1_100),
    ],
)
def test_an_episode_lasts_as_long_as_the_task(environment: Any, parameters: Any, returned: int) -> None:
    """By its own limit, that of a Gymnasium id, or what that is made to be."""
    action = 1 if isinstance(environment, str) else 0
    assert measured(environment, always(action, 2), 2, **parameters) == [returned]


def test_the_curve_by_hand() -> None:
    """Two copies: points where they are due, with the episodes that ended since the one before."""
    curve = Curve(MDPEnv(Stairs()), {}, always(0, 2), 4, 2, 0)
    curve.measure(0)
    for steps, rewards, over in (
        (2, [1, 10], [False, False]),
        (4, [2, 20], [True, False]),  # 1 + 2
        (6, [5, 30], [False, True]),  # 10 + 20 + 30
        (9, [5, 5], [True, False]),  # 5 + 5
        (12, [1, 1], [False, False]),
        (13, [1, 1], [False, False]),
        (14, [9, 1], [True, False]),  # 1 + 1 + 9
    ):
        curve.add(steps, np.array(rewards, float), np.array(over))
    run = curve.run("the agent", 14, 7)
    assert run.steps.tolist() == [0, 4, 9, 13, 14]
    assert run.episodes.tolist() == [0, 1, 2, 0, 1]
    np.testing.assert_array_equal(run.training_returns, [np.nan, 3.0, 35.0, np.nan, 11.0])
    assert run.returns.tolist() == [6.0] * 5
    assert (run.agent, run.seed, run.complete) == ("the agent", 7, True)
    assert curve.run(None, 14, 7).steps.tolist() == run.steps.tolist()  # there is a point at 14 already


def test_one_episode_in_each_copy() -> None:
    """One ends after two steps, and what it gets after that does not count; the policy hears where episodes begin."""
    policies, begun = 0, list[list[bool]]()

    def made() -> Policy:
        nonlocal policies
        policies += 1
        begun.clear()

        def policy(observations: Any, first: Any) -> Any:
            begun.append(first.tolist())
            return np.array([1, len(begun) % 2])  # to the right, which ends with 1.5; to and fro, without an end

        return policy

    assert measured(MDPEnv(Walk(max_steps=7)), made, 2, (0, 10)) == [0.75, 0.75]
    assert policies == 2
    assert begun == [[True, True], *[[False, False], [True, False]] * 3]


def test_the_seed_of_a_curve() -> None:
    """It decides on the evaluation episodes, which are others at each point."""
    one, again, two = (measured("Catch", always(1, 40), 40, (0, 10, 20), seed) for seed in (1, 1, 2))
    assert one == again
    assert len({*one, *two}) > 3


def test_torch_has_the_threads_that_it_had() -> None:
    """One meanwhile; also after an error."""

    @one_thread()
    def fails() -> None:
        raise KeyError(torch.get_num_threads())

    before = torch.get_num_threads()
    try:
        torch.set_num_threads(2)
        with pytest.raises(KeyError, match=r"^1$"):
            fails()
        assert torch.get_num_threads() == 2
    finally:
        torch.set_num_threads(before)


def test_copies_begin_again_in_the_step_in_which_an_episode_ends() -> None:
    """Those of this package and of Gymnasium: no step that is learned from leads from one episode to the next."""
    for name, parameters in (("Boulder", {"max_steps": 3}), ("CartPole-v1", {"max_episode_steps": 3})):
        made = copies(name, 2, parameters)
        assert made.num_envs == 2
        assert made.metadata["autoreset_mode"] == AutoresetMode.SAME_STEP
        made.reset(seed=0)
        for _ in range(3):
            *_, truncated, info = made.step(np.array([0, 1]))
        assert truncated.tolist() == [True, True]
        assert "final_obs" in info
