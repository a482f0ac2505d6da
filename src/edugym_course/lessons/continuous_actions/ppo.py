"""Bins and continuous actions with the same algorithm: PPO on Trashbot, where only the action space differs."""

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from edugym.experiments.results.tables import Results
from edugym_course.stored import Stored

N_STEPS = 393_216
"""The training steps of a stored run: 48 rounds in which 128 copies play 64 steps each."""
ACTIONS: Mapping[str, int | None] = MappingProxyType({"3 bins": 3, "5 bins": 5, "9 bins": 9, "continuous": None})
"""By label, the number of bins for each joint; None for real numbers."""
CONTINUOUS = "continuous"


def trainer(label: str, n_steps: int = N_STEPS) -> Any:
    """Return the function that trains PPO with the actions of a label.

    128 copies, 64 steps a round, 6 epochs of 8 minibatches, learning rate 0.001 (falls to 0), discount 0.999, λ 0.95,
    clipped at 0.2; two networks with two layers of 64 units.

    Args:
        label: one of `ACTIONS`.
        n_steps: the training steps, for the points of the curve.
    """
    from edugym.deep.ppo import PPO

    bins = ACTIONS[label]
    parameters = {} if bins is None else {"n_bins": bins}
    rounds: dict[str, Any] = {"num_envs": 128, "length": 64, "epochs": 6, "minibatches": 8}
    algorithm = PPO.create("Trashbot", parameters, learning_rate=1e-3, discount=0.999, **rounds)
    return partial(algorithm.train, evaluate_every=n_steps // 24, evaluation_episodes=1)


def learn_with_ppo(labels: tuple[str, ...] = tuple(ACTIONS), n_steps: int = N_STEPS, **how: Any) -> Results:
    """Train PPO, which takes about ten seconds a run.

    Args:
        labels: some of `ACTIONS`.
        n_steps: the training steps of each run.
        **how: arguments of `edugym.deep.repeated.repeat_deep`, such as `repetitions`, `seed` and `jobs`.
    """
    from edugym.deep.repeated import repeat_deep

    return repeat_deep({label: trainer(label, n_steps) for label in labels}, n_steps, **{"jobs": 1, **how})


STORED = Stored(
    "continuous_actions.ppo",
    learn_with_ppo,
    ("edugym.envs.trashbot.task", "edugym.envs.trashbot.geometry", "edugym.deep.ppo", "edugym.deep.actor_critic"),
)
