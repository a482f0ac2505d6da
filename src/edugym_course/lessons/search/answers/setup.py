from math import inf, log, sqrt

import numpy as np
