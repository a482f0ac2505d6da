"""Deep reinforcement learning: a PPO of our own, and environments and learning curves for Stable-Baselines3.

It needs the extra `deep`. Nothing else in EduGym loads torch.
"""

import importlib
from typing import TYPE_CHECKING, Any

from gymnasium.error import DependencyNotInstalled

from edugym.adapters.gymnasium_env import MDPEnv, environment_of
from edugym.adapters.registration import make_environment
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.checks.parameters import in_short
from edugym.system.extras import install

__all__ = ["PPO", "stable_baselines3_env", "stable_baselines3_run"]

if TYPE_CHECKING:
    from edugym.deep.baselines import stable_baselines3_run as stable_baselines3_run
    from edugym.deep.ppo import PPO as PPO
    from edugym.deep.vec_env import MDPVecEnv


def stable_baselines3_env(
    environment: "str | MDPEnv[Any] | MDPVectorEnv[Any]", num_envs: int | None = None, **parameters: Any
) -> "MDPVecEnv":
    """Copies of an environment for an agent of Stable-Baselines3.

        from stable_baselines3 import PPO
        from edugym.deep import stable_baselines3_env

        copies = stable_baselines3_env("Catch", 64, rows=5)
        PPO("MlpPolicy", copies, n_steps=32, batch_size=512, learning_rate=2e-3).learn(10_000)

    PPO learns after each round of `n_steps` steps in every copy: with 64 copies and its default of 2048 that is only
    after 131 072 steps.

    RecurrentPPO of sb3-contrib refuses every `MultiDiscrete` observation, such as that of Golf: "input_size should be
    of type int". It takes one as a vector, from Stable-Baselines3's own copies:
    `make_vec_env("edugym/Golf-v0", wrapper_class=gymnasium.wrappers.FlattenObservation)`.

    Args:
        environment: the name or id of an environment; an environment of one's own, such as `MDPEnv(Walk(7))`, or its
            MDP; or a vector environment that resets its copies in the same step (`autoreset_mode="SameStep"`).
        num_envs: how many copies, 1 or more; by default one, or as many as the vector environment has.
        **parameters: what the environment is made with, where it is given by its name.

    Returns:
        A `VecEnv`. It gives what Stable-Baselines3's own `DummyVecEnv` does, many times faster. `VecMonitor` around it
        adds the statistics of episodes.

    Raises:
        DependencyNotInstalled: Stable-Baselines3 is not there.
        ValueError: there is no such environment, it has no such parameter, one is not as its class says, its steps do
            more than its MDP (Supermarket with a `step_timeout` waits), or the vector environment has another number of
            copies or resets them in another way.
    """
    try:
        from edugym.deep.vec_env import MDPVecEnv
    except ImportError as error:
        raise DependencyNotInstalled(f"Stable-Baselines3 is missing, run {install('deep')}") from error
    if isinstance(environment, str):
        environment = make_environment(environment, **parameters)
    elif parameters:
        raise ValueError(f"parameters are for an environment given by its name, but are {in_short(parameters)}")
    if not isinstance(environment, MDPVectorEnv):
        environment = environment_of(environment)
        if not environment.only_plays_its_mdp:
            raise ValueError(
                f"environment must do in a step what its MDP does and no more, such as waiting, but {environment!r}"
                " does more: use Stable-Baselines3's own DummyVecEnv"
            )
        environment = MDPVectorEnv(environment, 1 if num_envs is None else num_envs, "SameStep")
    if num_envs not in (None, environment.num_envs):
        raise ValueError(
            f"num_envs must be {environment.num_envs}, as the vector environment has, but is {in_short(num_envs)}"
        )
    return MDPVecEnv(environment)


def __getattr__(name: str) -> Any:
    """Load what needs torch when it is first used."""
    homes = {"PPO": "edugym.deep.ppo", "stable_baselines3_run": "edugym.deep.baselines"}
    if name not in homes:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        return getattr(importlib.import_module(homes[name]), name)
    except ImportError as error:
        raise DependencyNotInstalled(f"Stable-Baselines3 or torch is missing, run {install('deep')}") from error
