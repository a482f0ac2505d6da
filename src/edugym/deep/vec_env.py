"""A vector environment as Stable-Baselines3 wants it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.vector import AutoresetMode
from stable_baselines3.common.vec_env.base_vec_env import VecEnv, VecEnvIndices

from edugym.adapters.vector_env import MDPVectorEnv


class MDPVecEnv(VecEnv):
    """The copies of a vector environment as a `VecEnv`: like `DummyVecEnv`, but stepped in one call of machine code.

    All copies draw from one random stream, so of the seeds that Stable-Baselines3 hands out only the first counts. A
    single copy does exactly what a `DummyVecEnv` of one environment does. `infos` say what Stable-Baselines3 asks for,
    `"TimeLimit.truncated"` and `"terminal_observation"`, and nothing else.

    Args:
        vector: copies that are reset in the same step.

    Attributes:
        vector: the same.

    Raises:
        ValueError: the copies are reset in another way.
    """

    def __init__(self, vector: MDPVectorEnv[Any]) -> None:
        """See the class."""
        if vector.autoreset_mode is not AutoresetMode.SAME_STEP:
            raise ValueError(
                f"autoreset_mode must be {AutoresetMode.SAME_STEP.value!r}, but is {vector.autoreset_mode.value!r}"
            )
        self.vector = vector
        self._actions: Any = None
        super().__init__(vector.num_envs, vector.single_observation_space, vector.single_action_space)
        self.metadata = vector.metadata

    def reset(self) -> Any:
        """Start an episode in every copy, and return their observations, shape (n, ...)."""
        observations, _ = self.vector.reset(seed=self._seeds[0])
        self._reset_seeds()
        self._reset_options()
        return observations

    def step_async(self, actions: Any) -> None:
        """Store the actions, shape (n, ...)."""
        self._actions = actions

    def step_wait(self) -> tuple[Any, Any, Any, list[dict[str, Any]]]:
        """Take one step in every copy with the stored actions.

        Returns:
            Observations of shape (n, ...), which are those of the next episode where one has ended; rewards and ends
            (terminated or truncated), of shape (n,); and an info for each copy.

        Raises:
            ResetNeeded: before the first reset.
            ValueError: an action is not in the action space.
        """
        observations, rewards, terminations, truncations, more = self.vector.step(self._actions)
        infos: list[dict[str, Any]] = [{"TimeLimit.truncated": False} for _ in range(self.num_envs)]
        over = terminations | truncations
        for i in np.flatnonzero(over).tolist():
            infos[i] = {
                "TimeLimit.truncated": bool(truncations[i]),  # never of an episode that has terminated
                "terminal_observation": more["final_obs"][i],
            }
        return observations, rewards.astype(np.float32), over, infos

    def close(self) -> None:
        """Close the window, if there is one."""
        self.vector.close()

    def render(self, mode: str | None = None) -> np.ndarray[Any, Any] | None:
        """Draw the copies, as `render_mode` says: into one array of pixels, or a window."""
        if self.render_mode == "human":
            self.vector.render()
            return None
        return super().render(mode)

    def get_images(self) -> Sequence[Any]:
        """The picture of each copy, where the environment was made with `render_mode="rgb_array"`."""
        return self.vector.render() or ()

    def get_attr(self, attr_name: str, indices: VecEnvIndices = None) -> list[Any]:
        """An attribute of each copy: its `state`, `steps`, `mdp`, `spec` and so on."""
        return [getattr(self.vector.showing(i), attr_name) for i in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: Any, indices: VecEnvIndices = None) -> None:
        """Not possible: copies are no environments of their own.

        Raises:
            NotImplementedError: always.
        """
        raise NotImplementedError(f"cannot set {attr_name!r}: all copies are one MDP; make another environment")

    def env_method(
        self, method_name: str, *method_args: Any, indices: VecEnvIndices = None, **keywords: Any
    ) -> list[Any]:
        """What a method of the environment, such as `info` or `scene`, gives for each copy.

        Raises:
            NotImplementedError: it would change a copy.
        """
        if method_name in ("reset", "step", "close"):
            raise NotImplementedError(f"cannot {method_name} single copies: they go together")
        return [
            getattr(self.vector.showing(i), method_name)(*method_args, **keywords) for i in self._get_indices(indices)
        ]

    def env_is_wrapped(self, wrapper_class: Any, indices: VecEnvIndices = None) -> list[bool]:
        """No copy has a wrapper of Gymnasium's around it."""
        return [False for _ in self._get_indices(indices)]
