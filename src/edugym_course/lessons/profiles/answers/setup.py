import numpy as np

from edugym import SARSA, make_mdp
