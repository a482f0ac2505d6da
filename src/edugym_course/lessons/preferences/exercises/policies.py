"""Exercise 3 of lesson 14: the policy with a penalty, the usual mistakes in it, and the cases that tell them."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.mdp.protocol import Reals

Choice = tuple[Reals, Reals, float]
"""Values, the reference policy, and the penalty."""


def weighed(
    choice: Choice,
    *,
    reference: str = "right",
    penalty: str = "right",
    sign: float = 1.0,
    kind: str = "soft",
    times: float = 1.0,
) -> Reals:
    """Return the policy with a penalty, which counts so many times; other arguments than the defaults are mistakes."""
    values, given_reference, beta = choice[0], choice[1], times * choice[2]
    base = {
        "right": given_reference,
        "left out": np.ones_like(values) / len(values),
        "squared": given_reference**2,
        "support": (given_reference > 0) / (given_reference > 0).sum(),
    }[reference]
    scale = {"right": beta, "multiplied": 1 / beta, "left out": 1.0}[penalty]
    if kind == "greedy":
        return np.asarray(np.eye(len(values))[int(np.argmax(np.where(base > 0, values, -np.inf)))])
    if kind == "reference":
        return np.asarray(base)
    exponents = sign * values / scale
    weights = base * np.exp(np.where(base > 0, exponents - exponents[base > 0].max(), -np.inf))
    if kind == "inside":
        weights = np.exp(exponents + base - (exponents + base).max())
    if kind == "share":
        weights = np.exp(exponents * base - (exponents * base).max())
    if kind == "added":
        weights = base + np.exp(exponents - exponents.max())
    policy: Reals = weights / (1.0 if kind == "not normalised" else weights.sum())
    return policy


POLICY_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the reference is left out: that is a softmax of the values alone": {"reference": "left out"},
    "the values are multiplied by the penalty; a large penalty keeps to the reference, so divide": {
        "penalty": "multiplied"
    },
    "the penalty is left out: divide the values by it": {"penalty": "left out"},
    "the sign is wrong: an action with a higher value becomes more likely": {"sign": -1.0},
    "they do not sum to 1: divide by their sum": {"kind": "not normalised"},
    "that is the greedy policy, which is what a penalty of 0 would give": {"kind": "greedy"},
    "that is the reference: the values play no part": {"kind": "reference"},
    "the reference is added to the exponentials; multiply by it": {"kind": "added"},
    "the reference is added inside the exponential; it is multiplied by the exponential": {"kind": "inside"},
    "the reference is multiplied by the values; it is multiplied by the exponential": {"kind": "share"},
    "the reference is multiplied in twice": {"reference": "squared"},
    "it matters only whether the reference takes an action, and it should matter how often": {"reference": "support"},
}


def choices(rng: np.random.Generator) -> list[Choice]:
    """Make up states: one has an action that the reference never takes, one far values, one a small penalty."""
    made = list[Choice]()
    for penalty, size, never in ((0.5, 3, False), (2.0, 4, False), (4.0, 3, True), (0.25, 3, False)):
        reference = rng.dirichlet(np.ones(size))
        if never:
            reference[0] = 0.0
            reference /= reference.sum()
        made.append(
            (np.round(rng.normal(size=size), 2) - 1.0, np.round(reference, 3) / np.round(reference, 3).sum(), penalty)
        )
    return made


EXTREMES: tuple[Choice, ...] = (
    (np.array([3_000.0, 2_999.0, -5_000.0]), np.array([0.25, 0.5, 0.25]), 0.01),
    (np.array([3_000.0, 1.0, 0.0]), np.array([0.0, 0.5, 0.5]), 0.01),  # the best action is never taken
    (np.array([1.0, -3_000.0, -3_001.0]), np.array([0.0, 0.5, 0.5]), 0.01),  # and those that are taken are below 0
    (np.array([1.0, 0.9999, 0.0]), np.array([0.25, 0.5, 0.25]), 0.0001),  # so small a penalty tells them apart
    (np.array([3_000.0, 1.0, 1.0]), np.array([0.0, 0.25, 0.75]), 0.0001),  # the two best that are taken are equal
)
