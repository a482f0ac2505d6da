import itertools
import math
