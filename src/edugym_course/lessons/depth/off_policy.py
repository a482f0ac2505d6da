"""n-step Q-learning learns from its own exploration: how wrong its target is, and two ways to mend it, exactly."""

import math

import numpy as np

from edugym.envs.study import Study
from edugym.exact.model import finite_model
from edugym.exact.policies import soft
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures.sheet import Sheet
from edugym.mdp.protocol import Reals
from edugym_course.lessons.depth.panels import Series
from edugym_course.lessons.depth.targets import DAYS, EPSILON, target

UNCORRECTED, WEIGHTED, CUT = "uncorrected", "importance sampling", "cut at exploring actions"


def uncorrected(model: FiniteModel, epsilon: float = EPSILON) -> tuple[Reals, Reals]:
    """Return bias and standard deviation of R_1 + ... + R_n + max_a q*(S_n, a), for n = 1, 2, ..., H.

    The first action is the best one, and all later ones are ε-greedy for the true optimal values. Rewards have no noise
    here, so the target of a learner that leaves its exploration out would be v*(S_0), always.

    Args:
        model: the exact model of the task.
        epsilon: ε.
    """
    best = value_iteration(model)
    greedy = np.eye(best.Q.shape[1])[best.Q.argmax(axis=1)]
    start = int(model.initial.argmax())
    action = int(greedy[start].argmax())
    after, reward = model.successors[start, action, 0], float(model.rewards[start, action, 0])
    from_there = model._replace(initial=np.eye(len(model.states))[after])
    targets = [target(from_there, soft(greedy, epsilon), best.V, n - 1, 0.0) for n in range(1, DAYS + 1)]
    bias: Reals = np.array([reward + one.mean for one in targets]) - best.start
    return bias, np.sqrt([max(one.exploration, 0.0) for one in targets])


def weighted_deviation(value: float, n: int, epsilon: float = EPSILON, n_actions: int = 5) -> float:
    """Return the standard deviation of the target weighted by the importance-sampling ratio.

    All n - 1 later actions are greedy with probability g^(n - 1), g = 1 - ε + ε/N. Then the ratio is 1/g^(n - 1) and
    the return is `value`; otherwise the ratio is 0. So the mean is `value`, and the variance (1/g^(n - 1) - 1) value².
    """
    g = 1 - epsilon + epsilon / n_actions
    return abs(value) * math.sqrt(1 / g ** (n - 1) - 1)


def off_policy_sheet(epsilon: float = EPSILON, layout_seed: int = 0) -> Sheet:
    """Return bias and standard deviation of three off-policy targets of the first day against n."""
    model = finite_model(Study.create(layout_seed=layout_seed))
    bias, deviation = uncorrected(model, epsilon)
    value, n_actions = value_iteration(model).start, model.successors.shape[1]
    depths = np.arange(1.0, DAYS + 1)
    weighted = np.array([weighted_deviation(value, n, epsilon, n_actions) for n in range(1, DAYS + 1)])
    none = np.zeros(DAYS)
    lines = ({CUT: none, UNCORRECTED: bias, WEIGHTED: none}, {CUT: none, UNCORRECTED: deviation, WEIGHTED: weighted})
    return Sheet(
        "off_policy",
        [
            [
                Series(depths, lines[0], "mean of the target less the optimum", "n", "bias", first=4),
                Series(depths, lines[1], "its standard deviation", "n", "standard deviation", first=4),
            ]
        ],
    )
