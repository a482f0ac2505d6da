import math
from edugym.agents.tables import one_step_target
