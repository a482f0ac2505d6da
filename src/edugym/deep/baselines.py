"""Agents of Stable-Baselines3 on our vector environments, with the learning curve that `edugym.train` gives."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import stable_baselines3
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.on_policy_algorithm import OnPolicyAlgorithm
from stable_baselines3.common.policies import BasePolicy
from stable_baselines3.common.torch_layers import FlattenExtractor

from edugym.checks.parameters import a_dictionary, in_short, number_of_steps, one_of, true_or_false, whole_number
from edugym.deep import stable_baselines3_env
from edugym.deep.curves import Curve, Policy, one_thread
from edugym.training.run import Run

ALGORITHMS = ("DQN", "PPO", "A2C", "QRDQN", "RecurrentPPO")
CONTRIBUTED = ("QRDQN", "RecurrentPPO")
"""Those of sb3-contrib."""


def stable_baselines3_run(
    environment: Any,
    algorithm: str,
    n_steps: int,
    /,
    *,
    num_envs: int = 8,
    policy: str | None = None,
    parameters: Mapping[str, Any] | None = None,
    evaluate_every: int | None = None,
    evaluation_episodes: int = 100,
    seed: int = 0,
    complete_rounds: bool = True,
    **settings: Any,
) -> Run:
    """Train an agent of Stable-Baselines3 (or sb3-contrib), in one thread of torch.

        from edugym.deep import stable_baselines3_run

        stable_baselines3_run("Catch", "PPO", 20_000, num_envs=64, n_steps=32, batch_size=512, learning_rate=2e-3)

    Args:
        environment: the name or id of one of our environments, an `MDPEnv`, or an MDP.
        algorithm: "DQN", "PPO", "A2C", "QRDQN", or "RecurrentPPO", which remembers what it has seen.
        n_steps: how many steps to take in all copies together. (A setting `n_steps` of the algorithm, the length of its
            rounds, can be given by its name.)
        num_envs: how many copies play, 1 or more.
        policy: the name or the class of a policy; by default "MlpPolicy", or "MlpLstmPolicy" for "RecurrentPPO".
        parameters: those of an environment that is given by name.
        evaluate_every: steps between two points of the curve, 1 or more; by default a tenth of `n_steps`.
        evaluation_episodes: how many episodes each point averages, played by the likeliest actions.
        seed: from 0 to 2³² - 1; the same seed gives the same run. Stable-Baselines3 seeds the global random streams of
            Python, NumPy and torch with it.
        complete_rounds: whether algorithms that play whole rounds complete the last one, beyond `n_steps`. If not, they
            learn nothing from a round that does not fit.
        **settings: those of the algorithm.

    Returns:
        As `edugym.train`; its `agent` is the one of Stable-Baselines3.

    Raises:
        ValueError: a parameter is not as above.
        gymnasium.error.DependencyNotInstalled: sb3-contrib is missing.
    """
    one_of("algorithm", algorithm, ALGORITHMS)
    number_of_steps("n_steps", n_steps)
    whole_number("seed", seed, 0, 2**32 - 1)
    parameters = a_dictionary("parameters", parameters)
    true_or_false("complete_rounds", complete_rounds)
    recurrent = algorithm == "RecurrentPPO"
    if policy is None:
        policy = "MlpLstmPolicy" if recurrent else "MlpPolicy"
    known = sorted(class_of(algorithm).policy_aliases)
    if not (isinstance(policy, str) and policy in known) and not (
        isinstance(policy, type) and issubclass(policy, BasePolicy)
    ):
        raise ValueError(
            f"policy must be one of {', '.join(known)}, or a class of Stable-Baselines3's policies, but is"
            f" {in_short(policy)}"
        )
    with one_thread():
        envs = stable_baselines3_env(environment, num_envs, **parameters)
        if recurrent:
            settings["policy_kwargs"] = {"features_extractor_class": AsVector} | settings.get("policy_kwargs", {})
        model = class_of(algorithm)(policy, envs, seed=seed, device="cpu", **settings)
        every = max(1, n_steps // 10) if evaluate_every is None else evaluate_every
        curve = Curve(environment, parameters, lambda: _policy(model, recurrent), every, evaluation_episodes, seed)
        curve.measure(0)
        model.learn(n_steps, callback=_Watch(curve, None if complete_rounds else n_steps))
        return curve.run(model, model.num_timesteps, seed)


def class_of(algorithm: str) -> Any:
    """The class of an algorithm.

    Raises:
        gymnasium.error.DependencyNotInstalled: sb3-contrib is missing.
    """
    if algorithm not in CONTRIBUTED:
        return getattr(stable_baselines3, algorithm)
    from edugym.system.extras import require

    require("deep", "sb3_contrib")
    import sb3_contrib

    return getattr(sb3_contrib, algorithm)


class AsVector(FlattenExtractor):
    """Stable-Baselines3's own, with a length that torch's LSTM takes: for a `MultiDiscrete`, theirs is no `int`."""

    def __init__(self, observation_space: Any) -> None:
        """See the class."""
        super().__init__(observation_space)
        self._features_dim = int(self._features_dim)


def _policy(model: Any, recurrent: bool) -> Policy:
    """What the model does, with a memory that starts empty."""
    memory = None

    def policy(observations: Any, first: Any) -> Any:
        nonlocal memory
        if not recurrent:
            return model.predict(observations, deterministic=True)[0]
        actions, memory = model.predict(observations, state=memory, episode_start=first, deterministic=True)
        return actions

    return policy


class _Watch(BaseCallback):
    """Takes note of every step for the curve, and ends the run after `last` steps, if that is given."""

    def __init__(self, curve: Curve, last: int | None) -> None:
        super().__init__()
        self._curve, self._last = curve, last

    def _on_step(self) -> bool:
        self._curve.add(self.num_timesteps, np.asarray(self.locals["rewards"], float), np.asarray(self.locals["dones"]))
        if self._last is None or self.num_timesteps < self._last:
            return True
        if not isinstance(self.model, OnPolicyAlgorithm):
            return False
        length = self.model.n_steps * self.training_env.num_envs
        return self.num_timesteps % length == 0  # a round that is complete is learned from, and is then the last
