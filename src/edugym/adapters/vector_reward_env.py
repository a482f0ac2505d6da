"""An MDP with several objectives as an environment whose reward is a vector, as in MO-Gymnasium."""

from typing import Any

import numpy as np
from gymnasium.envs.registration import EnvSpec

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.registration import make_mdp
from edugym.adapters.specification import filled
from edugym.mdp.multi_objective import require_objectives, vector

MO_DIVER = "edugym/MODiver-v0"
"""The id of Diver with vectors as rewards; Gymnasium knows it once `edugym.objectives` is imported."""


class VectorRewardEnv(MDPEnv[Any]):
    """A Gymnasium environment whose `step` returns a vector as the reward, one number for each objective.

        env = VectorRewardEnv(Diver.create())
        observation, info = env.reset(seed=0)
        observation, rewards, terminated, truncated, info = env.step(0)

    This is the interface of MO-Gymnasium, so that its wrappers work, and what other libraries build on it. It needs
    nothing of that library. Everything else is as in `edugym.MDPEnv`.

    Args:
        mdp: a task with several objectives (see `edugym.mdp.multi_objective`).
        render_mode: `"human"` (a window), `"rgb_array"` (pixels), `"ansi"` (characters) or None.

    Attributes:
        reward_space: the Gymnasium space of the vectors.
        reward_dim: the number of objectives.

    Raises:
        ValueError: `mdp` is no such task, or there is no such render mode.

    References: Felten et al. (2023), A toolkit for reliable benchmarking and research in multi-objective reinforcement
    learning.
    """

    def __init__(self, mdp: Any, render_mode: str | None = None) -> None:
        """See the class."""
        super().__init__(require_objectives(mdp), render_mode)
        self.reward_space = self.mdp.reward_space
        self.reward_dim = int(self.reward_space.shape[0])

    @property
    def spec(self) -> EnvSpec | None:
        """The id, the parameters and the step limit; the reward threshold of one number means nothing here."""
        return self._spec

    @spec.setter
    def spec(self, spec: EnvSpec | None) -> None:
        self._spec = filled(spec, None, self._limit)

    def step(self, action: Any) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        """Take one step, as `MDPEnv.step` does; the reward is a new array of shape (reward_dim,)."""
        observation, _, terminated, truncated, info = super().step(action)
        rewards = vector(self.mdp, self.last_state, self.last_action, self.state)
        return observation, np.array(rewards, self.reward_space.dtype), terminated, truncated, info


class MODiverEnv(VectorRewardEnv):
    """`edugym.envs.diver.Diver` with a vector as the reward: the value of the treasure, and time.

        mo_gymnasium.make("edugym.objectives:edugym/MODiver-v0", concavity=1)

    Its parameters are those of Diver but for the weights. `render_mode` is that of `edugym.MDPEnv`.
    """

    def __init__(self, concavity: float = 0.5, max_steps: int = 100, render_mode: str | None = None) -> None:
        """See the class.

        Raises:
            ValueError: a parameter is not as `Diver` says.
        """
        super().__init__(make_mdp("Diver", concavity=concavity, max_steps=max_steps), render_mode)
