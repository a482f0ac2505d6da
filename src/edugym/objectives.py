"""Several objectives: vectors of rewards, Pareto fronts, agents that learn them, and what weighted sums cannot find."""

import gymnasium

from edugym.adapters.vector_reward_env import MO_DIVER, MODiverEnv, VectorRewardEnv
from edugym.agents.chebyshev_q_learning import ChebyshevQLearning
from edugym.agents.lagrangian_q_learning import LagrangianQLearning
from edugym.agents.pareto_q_learning import ParetoQLearning
from edugym.exact.constrained import ConstrainedOptimum, constrained_optimum
from edugym.exact.front import Front, exact_front
from edugym.exact.points import pareto_front, supported
from edugym.mdp.multi_objective import table_shape
from edugym.mdp.weighted import Weighted
from edugym.training.train_vectors import VectorRun, train_vectors

__all__ = [
    "ChebyshevQLearning",
    "ConstrainedOptimum",
    "Front",
    "LagrangianQLearning",
    "ParetoQLearning",
    "VectorRewardEnv",
    "VectorRun",
    "Weighted",
    "constrained_optimum",
    "exact_front",
    "pareto_front",
    "supported",
    "table_shape",
    "train_vectors",
]

if MO_DIVER not in gymnasium.registry:  # without Gymnasium's checker, which wants one number as the reward
    gymnasium.register(MO_DIVER, entry_point=f"{MODiverEnv.__module__}:MODiverEnv", disable_env_checker=True)
