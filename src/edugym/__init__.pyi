"""The public names of EduGym and where each is defined: the one list, for type checkers and for `__init__.py`."""

from edugym.adapters.gymnasium_env import MDPEnv as MDPEnv
from edugym.adapters.tabular_observation import TabularObservation as TabularObservation
from edugym.adapters.vector_env import MDPVectorEnv as MDPVectorEnv
from edugym.agents.count_based import CountBased as CountBased
from edugym.agents.dyna_q import DynaQ as DynaQ
from edugym.agents.expected_sarsa import ExpectedSARSA as ExpectedSARSA
from edugym.agents.go_explore import GoExplore as GoExplore
from edugym.agents.n_step_sarsa import NStepSARSA as NStepSARSA
from edugym.agents.prioritised_sweeping import PrioritisedSweeping as PrioritisedSweeping
from edugym.agents.q_learning import QLearning as QLearning
from edugym.agents.r_max import RMax as RMax
from edugym.agents.sarsa import SARSA as SARSA
from edugym.agents.saving import load as load
from edugym.agents.saving import save as save
from edugym.agents.strategies import UCB as UCB
from edugym.agents.strategies import EpsilonGreedy as EpsilonGreedy
from edugym.agents.strategies import ExponentialDecay as ExponentialDecay
from edugym.agents.strategies import Greedy as Greedy
from edugym.agents.strategies import LinearDecay as LinearDecay
from edugym.agents.strategies import ScheduledEpsilonGreedy as ScheduledEpsilonGreedy
from edugym.agents.strategies import Softmax as Softmax
from edugym.agents.tables import table_size as table_size
from edugym.exact.model import FiniteModel as FiniteModel
from edugym.exact.model import finite_model as finite_model
from edugym.exact.value_iteration import value_iteration as value_iteration
from edugym.mdp.tabular import Tabular as Tabular
from edugym.mdp.wrapper import wrapper as wrapper
from edugym.registration import ENVIRONMENTS as ENVIRONMENTS
from edugym.registration import make_environment as make_environment
from edugym.registration import make_mdp as make_mdp
from edugym.registration import register_environments as register_environments
from edugym.results.claims import Above as Above
from edugym.results.claims import Below as Below
from edugym.results.claims import Claim as Claim
from edugym.results.claims import Within as Within
from edugym.results.statistics import Interval as Interval
from edugym.results.statistics import mean_interval as mean_interval
from edugym.results.statistics import paired_difference as paired_difference
from edugym.results.statistics import proportion_interval as proportion_interval
from edugym.results.tables import Results as Results
from edugym.training.repeat import repeat as repeat
from edugym.training.train import Run as Run
from edugym.training.train import train as train
from edugym.training.visits import record_visits as record_visits

__version__: str
