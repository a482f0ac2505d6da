"""Networks of Stable-Baselines3 and of this package on the grid and on the image of Catch."""

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.experiments.results.claims import Above, Claim
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.training.run import Run
from edugym_course.lessons.dimensionality.tasks import catch, darkened
from edugym_course.stored import Stored

N_STEPS, EVERY = 25_000, 2_000
OUR_PPO = "our PPO, grid"
DQN_GRID, PPO_GRID, DQN_IMAGE, PPO_IMAGE = "DQN, grid", "PPO, grid", "DQN with a CNN, image", "PPO with a CNN, image"
PPO_DARK = "PPO with a CNN, darkened image"
METHODS = (DQN_GRID, PPO_GRID, OUR_PPO, DQN_IMAGE, PPO_IMAGE, PPO_DARK)

DQN_SETTINGS: Mapping[str, Any] = MappingProxyType(
    {
        "num_envs": 8,
        "learning_rate": 1e-3,
        "batch_size": 64,
        "gradient_steps": 2,
        "learning_starts": 1_000,
        "target_update_interval": 500,
        "buffer_size": 20_000,
        "exploration_fraction": 0.5,
        "exploration_final_eps": 0.05,
    }
)
PPO_SETTINGS: Mapping[str, Any] = MappingProxyType(
    {"num_envs": 64, "n_steps": 32, "batch_size": 512, "learning_rate": 2e-3}
)
CNN_SETTINGS: Mapping[str, Any] = MappingProxyType(
    {"num_envs": 64, "n_steps": 16, "batch_size": 256, "learning_rate": 1e-3, "n_epochs": 6}
)
"""The settings of Stable-Baselines3; what is not here is as it comes."""


def with_cnn(cnn: Any) -> dict[str, Any]:
    """Return the settings for a policy that sees images through a network of layers."""
    return {"policy": "CnnPolicy", "policy_kwargs": {"features_extractor_class": cnn, "net_arch": []}}


def train_network(label: str, n_steps: int, *, evaluate_every: int = EVERY, seed: int = 0) -> Run:
    """Train one of `METHODS` with balls from all columns."""
    from edugym.deep.baselines import stable_baselines3_run
    from edugym.deep.ppo import PPO
    from edugym_course.lessons.dimensionality.layers import SmallCNN

    how: dict[str, Any] = {"evaluate_every": evaluate_every, "seed": seed}
    grid = MDPEnv(catch("grid"))
    if label == OUR_PPO:
        return PPO.create(grid).train(n_steps, **how)
    if label == DQN_GRID:
        return stable_baselines3_run(grid, "DQN", n_steps, **DQN_SETTINGS, **how)
    if label == PPO_GRID:
        return stable_baselines3_run(grid, "PPO", n_steps, **PPO_SETTINGS, **how)
    image = MDPEnv(darkened("rgb") if label == PPO_DARK else catch("rgb"))
    if label == DQN_IMAGE:
        return stable_baselines3_run(image, "DQN", n_steps, **DQN_SETTINGS, **with_cnn(SmallCNN), **how)
    return stable_baselines3_run(image, "PPO", n_steps, **CNN_SETTINGS, **with_cnn(SmallCNN), **how)


def learn_with_networks(**how: Any) -> Results:
    """Train all networks, which takes some seconds a run.

    Args:
        **how: arguments of `edugym.deep.repeated.repeat_deep`, such as `repetitions`, `seed` and `jobs`.
    """
    from edugym.deep.repeated import repeat_deep

    return repeat_deep({label: partial(train_network, label) for label in METHODS}, N_STEPS, **{"jobs": 1, **how})


STORED = Stored(
    "dimensionality.networks",
    learn_with_networks,
    (
        "edugym.envs.catch",
        "edugym.deep.baselines",
        "edugym.deep.ppo",
        "edugym.deep.actor_critic",
        "edugym_course.lessons.dimensionality.boards",
        "edugym_course.lessons.dimensionality.tasks",
        "edugym_course.lessons.dimensionality.layers",
    ),
)


def network_claims(networks: Results) -> list[Claim]:
    """Return the claims on the stored networks."""
    return [
        Claim(
            f"A network learns where a dense table has no room: {label}",
            "greedy return at the end",
            mean_interval(networks.final(label)),
            Above(0.9),
            remark="results of ten seeds, stored with the package",
        )
        for label in METHODS
    ]
