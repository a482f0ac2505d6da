from functools import partial
from edugym import Greedy, SARSA, Softmax
