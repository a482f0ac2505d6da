# This runs before each answer, after the imports of the lesson.
import numpy as np

from edugym import finite_model, value_iteration
