"""Several objectives: vectors of rewards, Pareto fronts, and what weighted sums cannot find."""

import gymnasium

from edugym.objectives.exact_front import Front, exact_front
from edugym.objectives.points import pareto_front, supported
from edugym.objectives.vector_reward_env import MO_DIVER, MODiverEnv, VectorRewardEnv

__all__ = ["Front", "VectorRewardEnv", "exact_front", "pareto_front", "supported"]

if MO_DIVER not in gymnasium.registry:  # without Gymnasium's checker, which wants one number as the reward
    gymnasium.register(MO_DIVER, entry_point=f"{MODiverEnv.__module__}:MODiverEnv", disable_env_checker=True)
