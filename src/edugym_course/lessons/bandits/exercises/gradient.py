"""Exercise 3 of lesson 0b: the update of the gradient bandit, the usual mistakes, and pulls to learn from."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.cases import LEARNING_RATES


class Paid(NamedTuple):
    """A pull for exercise 3, and the preferences before it."""

    H: Reals
    arm: int
    reward: float
    mean: float
    learning_rate: float


def preferred(
    case: Paid,
    *,
    pi: str = "softmax",
    baseline: str = "mean",
    sign: float = 1.0,
    moved: str = "all",
    rate: str = "right",
    kept: float = 1.0,
    cost: float = 0.0,
) -> Reals:
    """Return the preferences after the update; other arguments than the defaults are mistakes."""
    H, arm, reward, mean, learning_rate = case
    if pi == "moving":
        after = H.copy()
        for one in range(len(H)):
            alone = case._replace(H=after)
            after[one] = preferred(alone, cost=cost)[one]
        return after
    if pi == "moved":
        chosen_first = preferred(case, moved="chosen", cost=cost)
        after = preferred(case._replace(H=chosen_first), cost=cost)
        after[arm] = chosen_first[arm]
        return after
    moved_first = preferred(case, moved="only indicator", cost=cost) if pi == "late" else H
    shares = {
        "softmax": np.exp(H) / np.exp(H).sum(),
        "late": np.exp(moved_first) / np.exp(moved_first).sum(),
        "values": H / H.sum() if H.sum() else H,
        "unscaled": np.exp(H),
        "minus": np.exp(-H) / np.exp(-H).sum(),
        "uniform": np.full(len(H), 1 / len(H)),
    }[pi]
    step = {"right": learning_rate, "none": 1.0}[rate] * {
        "mean": reward - cost - mean,
        "none": reward - cost,
        "added": reward - cost + mean,
        "greedy": reward - cost - float(H[arm]),
        "only above": max(reward - cost - mean, 0.0),
        "late": reward - cost - mean / learning_rate,
        "size": abs(reward - cost - mean),
    }[baseline]
    chosen = np.eye(len(H))[arm]
    direction = {
        "all": chosen - shares,
        "highest": np.eye(len(H))[np.argmax(H)] - shares,
        "chosen": chosen * (1 - shares),
        "others": (chosen - 1) * shares,
        "only indicator": chosen,
        "minus everywhere": chosen * shares * -1 - (1 - chosen) * shares,
        "plus everywhere": chosen * (1 - shares) + (1 - chosen) * shares,
        "own share": chosen * (1 - shares) - (1 - chosen) * shares[arm],
        "whole": chosen - (1 - chosen) * shares,
        "twice": chosen * (1 - shares) - shares,
        "all as chosen": 1 - shares,
        "by its share": (2 * chosen - 1) * shares,
    }[moved]
    moved_to: Reals = kept * H + sign * step * direction
    return moved_to


GRADIENT_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "only the arm that was pulled moves; all others move the other way": {"moved": "chosen"},
    "the arm that was pulled does not move": {"moved": "others"},
    "π is left out: only the arm that was pulled moves, by a whole step": {"moved": "only indicator"},
    "1{a = A} is left out, which is 1 for the arm that was pulled": {"moved": "minus everywhere"},
    "each arm moves by 1 − π(a), as if it had been pulled; for the others 1{a = A} is 0": {"moved": "all as chosen"},
    "the arm that was pulled moves by π(A); it moves by 1 − π(A)": {"moved": "by its share"},
    "the other arms move in the direction of the one that was pulled": {"moved": "plus everywhere"},
    "the arm that was pulled moves back again by π(A): its change is 1 − π(A) in all": {"moved": "twice"},
    "π is worked out again after each change; all changes follow from the preferences before": {"pi": "moving"},
    "π is worked out again after the first change; all changes follow from the preferences before": {"pi": "moved"},
    "H(A) changes before π is worked out; all changes follow from the preferences before": {"pi": "late"},
    "all others move by the probability of the arm that was pulled; each moves by its own": {"moved": "own share"},
    "the arm that was pulled moves by a whole step; it moves by 1 − π(A)": {"moved": "whole"},
    "π is H divided by its sum; it is e to the power of H, divided by the sum of that": {"pi": "values"},
    "e to the power of H is not divided by its sum": {"pi": "unscaled"},
    "e has the power of −H; it is that of H": {"pi": "minus"},
    "all arms count as equally probable; π follows from H": {"pi": "uniform"},
    "the mean reward is left out": {"baseline": "none"},
    "the mean is subtracted after R is multiplied by α: put parentheses around R − m": {"baseline": "late"},
    "the arm with the highest preference moves up; it is the one that was pulled": {"moved": "highest"},
    "the mean reward is added; subtract it": {"baseline": "added"},
    "a reward below the mean changes nothing; it makes the arm rarer": {"baseline": "only above"},
    "a reward below the mean makes the arm likelier; keep the sign of R − m": {"baseline": "size"},
    "the preference of the arm stands in place of the mean reward": {"baseline": "greedy"},
    "H(A) moves towards the reward, as a mean does; a preference is no mean": {
        "baseline": "greedy",
        "moved": "only indicator",
    },
    "the change takes the place of the old preferences; add it to them": {"kept": 0.0},
    "the sign is wrong: after a good reward the arm gets rarer": {"sign": -1.0},
    "the learning rate is left out": {"rate": "none"},
}


def made_up_pulls(rng: np.random.Generator) -> list[Paid]:
    """Make up pulls: of rewards above the mean and below it."""
    made = []
    for n_arms in (2, 3, 4, 3):
        H = rng.choice(np.arange(-4, 5) / 2, n_arms, replace=False)
        H += 0.5 * (H.sum() == 0)  # H is divided by its sum in one mistake
        reward, mean = rng.choice(np.arange(1.0, 8.0), 2, replace=False)
        made.append(
            Paid(H, int(rng.integers(n_arms)), float(reward), float(mean) + 0.5, float(rng.choice(LEARNING_RATES)))
        )
    return made
