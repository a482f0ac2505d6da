"""The figures of lesson 3."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from edugym.envs.study import Study
from edugym.exact.model import finite_model
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.sheet import Sheet, in_pairs
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.depth.methods import BY_DEPTH, SHORT, Maker, best_returns, compare, label, layouts
from edugym_course.lessons.depth.panels import Parts, Series
from edugym_course.lessons.depth.targets import DAYS, EPSILON, soft_policy, target, true_values
from edugym_course.reporting import for_mdp

MANY_RATES = (0.003, 0.01, 0.03, 0.1, 0.3, 1.0)


def curves(results: Results, title: str, epsilon: float = EPSILON) -> Curves:
    """Return the learning curves of an experiment, with the optimum and the best ε-soft policy of its layouts."""
    optimum, soft = best_returns(layouts(results), 0.0, epsilon)
    return Curves(results, title, optimum=optimum, soft_optimum=soft)


def learning_curves(by_title: Mapping[str, Results]) -> Sheet:
    """Return a panel for each experiment, two in a row."""
    panels = [curves(results, title) for title, results in by_title.items()]
    return in_pairs("depth", panels)


def race(own: Mapping[str, Maker], *, repetitions: int = 50, **how: Any) -> Sheet:
    """Return the learning curves of all depths and of methods of the reader's own, with five and with ten actions.

    Args:
        own: by label, functions that make an agent for the task, which is the MDP itself.
        repetitions: the number of runs of each method, each with a layout of its own.
        **how: more arguments of `compare`.
    """
    methods = {name: for_mdp(make) for name, make in own.items()}
    return learning_curves(
        {
            f"{n_actions} actions": compare(
                depths=BY_DEPTH, n_actions=n_actions, own=methods, repetitions=repetitions, **how
            )
            for n_actions in (5, 10)
        }
    )._replace(name="race")


def through_rates(rates: Sequence[float] = MANY_RATES, *, n_steps: int = SHORT, **how: Any) -> dict[float, Results]:
    """Train every n with several learning rates; arguments as in `compare`."""
    return {rate: compare(depths=BY_DEPTH, learning_rate=rate, n_steps=n_steps, **how) for rate in rates}


def rate_series(by_rate: Mapping[float, Results], title: str = "the first 500 episodes") -> Against:
    """Return how well each depth does while it learns, against the learning rate."""
    names = next(iter(by_rate.values())).methods
    return Against(
        [*by_rate],
        {name: [results.average(name) for results in by_rate.values()] for name in names},
        title,
        "learning rate α",
        "return (greedy), mean over training",
        log=True,
    )


def best_rates(by_rate: Mapping[float, Results]) -> dict[float, float]:
    """Return for each depth the learning rate with the highest return while it learns."""
    return {n: max(by_rate, key=lambda rate: float(by_rate[rate].average(label(n)).mean())) for n in BY_DEPTH}


def split(sigma: float, layout_seed: int = 0, epsilon: float = EPSILON) -> dict[str, Reals]:
    """Return the variance of the target of the first day for n = 1, 2, ..., H, by what it comes from.

    The agent acts by the best ε-soft policy, and its values are those of this policy.
    """
    model = finite_model(Study.create(layout_seed=layout_seed))
    policy = soft_policy(model, epsilon)
    Q = true_values(model, policy)
    targets = [target(model, policy, Q, n, sigma) for n in range(1, DAYS + 1)]
    return {
        "noise of the rewards": np.array([one.noise for one in targets]),
        "the agent's own exploration": np.array([one.exploration for one in targets]),
    }


def variance_sheet(sigmas: Sequence[float] = (0.2, 1.0), layout_seed: int = 0) -> Sheet:
    """Return what the variance of the target is made of, a panel for each σ."""
    parts = {sigma: split(sigma, layout_seed) for sigma in sigmas}
    top = 1.05 * max(float(np.sum([*one.values()], axis=0).max()) for one in parts.values())
    return Sheet("variance", [[Parts(one, f"σ = {sigma:g}", top) for sigma, one in parts.items()]])


def bias_series(layout_seed: int = 0, epsilon: float = EPSILON) -> Series:
    """Return the mean of the target of the first day less its true value, early and late in training."""
    model = finite_model(Study.create(layout_seed=layout_seed))
    policy = soft_policy(model, epsilon)
    Q = true_values(model, policy)
    depths = np.arange(1.0, DAYS + 1)
    means = {
        name: np.array([target(model, policy, values, int(n), 0.0).mean for n in depths])
        for name, values in (("values still 0", np.zeros_like(Q)), ("values learned", Q))
    }
    true = means["values still 0"][-1]
    return Series(
        depths,
        {name: one - true for name, one in means.items()},
        "bias of the target of the first day",
        "n",
        "mean less true value",
        first=5,
        zero=True,
    )


def episodes_until(values: Reals, share: float = 0.5) -> float:
    """Return after how many episodes the value of the first day is at least a share of 10; infinity for never."""
    reached = np.flatnonzero(values[:, 0] >= share * 10.0)
    return float(reached[0]) if len(reached) else math.inf
