"""Agents of Stable-Baselines3 in the form in which `edugym.profile` takes them."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from edugym.agents.vectors import vector_size
from edugym.checks.parameters import one_of
from edugym.deep.baselines import ALGORITHMS, class_of, stable_baselines3_run
from edugym.training.run import Run


class LibraryAgent(NamedTuple):
    """An agent of Stable-Baselines3 or sb3-contrib, as `PPO("MlpPolicy", env)` makes it: one copy, its own settings.

        from functools import partial
        import edugym
        from edugym.deep.library import LibraryAgent

        edugym.profile({"PPO": partial(LibraryAgent.create, algorithm="PPO")})

    Attributes:
        environment: an `MDPEnv` or an MDP.
        algorithm: "DQN", "PPO", "A2C", "QRDQN" or "RecurrentPPO".
        settings: those that are not at their defaults.
    """

    environment: Any
    algorithm: str
    settings: Mapping[str, Any]

    def train(
        self, n_steps: int, *, evaluate_every: int | None = None, evaluation_episodes: int = 100, seed: int = 0
    ) -> Run:
        """Train it for `n_steps` steps and no more: from a round that does not fit into them, it learns nothing.

        Arguments, what it returns and what it raises are those of `stable_baselines3_run`.
        """
        return stable_baselines3_run(
            self.environment,
            self.algorithm,
            n_steps,
            num_envs=1,
            evaluate_every=evaluate_every,
            evaluation_episodes=evaluation_episodes,
            seed=seed,
            complete_rounds=False,
            **self.settings,
        )

    @classmethod
    def create(cls, environment: Any, algorithm: str, **settings: Any) -> "LibraryAgent":
        """An agent for an environment; settings are those of the algorithm.

        Raises:
            ValueError: there is no such algorithm, or it does not fit the environment.
            gymnasium.error.DependencyNotInstalled: sb3-contrib is missing.
        """
        one_of("algorithm", algorithm, ALGORITHMS)
        if algorithm in ("DQN", "QRDQN"):
            vector_size(environment)
        class_of(algorithm)
        return cls(environment, algorithm, settings)
