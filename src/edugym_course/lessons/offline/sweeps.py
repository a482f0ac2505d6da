"""One sweep of pessimistic fitted Q, the mistakes that are made in it, and steps that tell them apart."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.cases import FAR_BELOW, from_a_start, starts
from edugym_course.grading.mistakes import UNUSUAL
from edugym_course.grading.values import same

N_STATES, N_ACTIONS = 3, 2
Step = tuple[int, int, float, int, bool]
"""State, action, reward, next state, and whether the task ended."""
Sweep = tuple[list[Step], Reals, float, float]
"""Steps, the values before, the penalty, and the lowest value."""


def swept(
    case: Sweep,
    *,
    sign: float = 1.0,
    over: str = "root",
    fit: str = "mean",
    unseen: str = "lowest",
    floor: str = "max",
    end: str = "right",
    future: str = "largest",
    start: int = 0,
    per: str = "pair",
    order: str = "at once",
    discount: float = 1.0,
) -> Reals:
    """Return the values after one sweep; other arguments than the defaults are mistakes."""
    steps, before, penalty, lowest = case
    if order == "in turn":
        table = before.copy()
        for pair in np.ndindex(table.shape):
            table[pair] = swept((steps, table, penalty, lowest), discount=discount)[pair]
        return table
    targets: dict[tuple[int, int], list[float]] = {}
    for s, a, r, after, terminated in steps:
        if terminated and end == "skipped":
            continue
        V = {
            "start": from_a_start(before[after], start),
            "smallest": before[after].min(),
            "own": before[s].max(),
            "largest": before[after].max(),
            "mean": before[after].mean(),
            "same action": before[after, a],
        }[future]
        going_on = {"always": True, "never": False}.get(end, not terminated)
        earned = 0.0 if terminated and end == "worth 0" else r
        targets.setdefault((s, a), []).append(earned + (discount * float(V) if going_on else 0.0))
    Q = {
        "lowest": np.full_like(before, lowest),
        "zero": np.zeros_like(before),
        "before": before.copy(),
        "penalty": np.full_like(before, -penalty),
    }[unseen]
    for (s, a), seen in targets.items():
        n = len(seen)
        taken = {"pair": n, "state": sum(1 for one in steps if one[0] == s), "all": len(steps)}[per]
        if floor == "targets":
            seen = [max(lowest, target) for target in seen]
        fitted = {
            "mean": float(np.mean(seen)),
            "worst": min(seen),
            "median": float(np.median(seen)),
            "sum": sum(seen),
            "last": seen[-1],
            "best": max(seen),
        }[fit]
        size = {
            "root of both": np.sqrt(penalty / n),
            "root": penalty / np.sqrt(taken),
            "n": penalty / taken,
            "one": penalty,
            "times": penalty * np.sqrt(n),
        }
        less = sign * {**size, "none": 0.0}[over]
        Q[s, a] = fitted - less
        if floor == "each":
            Q[s, a] = np.mean([max(lowest, target - less) for target in seen])
        elif floor != "none":
            Q[s, a] = {"min": min}.get(floor, max)(lowest, Q[s, a])
    return Q


SWEPT_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the penalty is added; that is a bonus, which draws to what is known badly, as when exploring": {"sign": -1.0},
    "the penalty is divided by n; the error of a mean goes down with √n": {"over": "n"},
    "the penalty does not get smaller with n": {"over": "one"},
    "the penalty is multiplied by √n; what is known well should cost less": {"over": "times"},
    "the penalty is under the root, too; only n is": {"over": "root of both"},
    "the penalty is left out: that is fitted Q as it is, with the lowest value for what is unseen": {"over": "none"},
    "n counts all steps from the state; it counts those with this action": {"per": "state"},
    "n counts all steps that there are; it counts those of the pair": {"per": "all"},
    "the targets are added up; fit their mean": {"fit": "sum"},
    "the last target of each pair stays; fit the mean of all of them": {"fit": "last"},
    "the worst target of each pair stays; fit the mean of all of them": {"fit": "worst"},
    "the median of the targets is fitted; fit their mean": {"fit": "median"},
    "the best target of each pair stays; fit the mean of all of them": {"fit": "best"},
    "pairs without a step are 0; a pessimist gives them the lowest value": {"unseen": "zero"},
    "pairs without a step keep their value; a pessimist gives them the lowest value": {"unseen": "before"},
    "pairs without a step get the penalty as a value; a pessimist gives them the lowest value": {"unseen": "penalty"},
    "some values are below the lowest one there is": {"floor": "none"},
    "each target is held above the lowest value; only their mean, less the penalty, is": {"floor": "each"},
    "each target is held above the lowest value; only what comes of their mean is": {"floor": "targets"},
    "some targets use values that this sweep has already changed: they all need those of the table before it": {
        "order": "in turn"
    },
    "of the value and the lowest one it takes the smaller; max(...) takes the larger": {"floor": "min"},
    "what comes after the end is counted: where `terminated` is True the target is the reward alone": {"end": "always"},
    "what comes after a step is left out: where the task goes on, add the largest value of the next state": {
        "end": "never"
    },
    "the reward of the last step is lost: where `terminated` is True it is the target": {"end": "worth 0"},
    "steps that end are left out; their target is the reward alone": {"end": "skipped"},
    "that is the largest value of the state itself; take that of the *next* state": {"future": "own"},
    "the next state counts with its mean value; take the largest": {"future": "mean"},
    "the next state counts with its smallest value; take the largest": {"future": "smallest"},
    **starts(
        lambda start: f"the search for the largest value starts at {start}, and all may be lower: start at -math.inf",
        lambda start: {"future": "start", "start": start},
    ),
    "the next state counts with the value of the same action; take the largest": {"future": "same action"},
}


def made_up_sweeps(rng: np.random.Generator) -> list[Sweep]:
    """Make up steps: some pairs come several times, some never, one is below the lowest; in the fourth all are low.

    The lowest value is a whole number, as one writes it. In the last case single targets are below it.
    """
    made = list[Sweep]()
    kinds = ((2.0, 6, 0.0, -9), (3.0, 8, 0.0, -9), (12.0, 7, 0.0, -9), (2.0, 4, FAR_BELOW, -9), (1.0, 8, 0.0, -2))
    for penalty, n_steps, down, lowest in kinds:
        steps: list[Step] = [
            (
                int(rng.integers(2)),
                int(rng.integers(N_ACTIONS)),
                float(rng.integers(-3, 6)),
                int(rng.integers(N_STATES)),
                bool(rng.random() < 0.3),
            )
            for _ in range(n_steps)
        ]
        made.append(
            (steps, (rng.integers(-3, 6, (N_STATES, N_ACTIONS)) - down).astype(float), penalty, lowest - int(down))
        )
    return made


def where_wrong(cases: Sequence[Sweep], found: Sequence[Reals], rule: Callable[[Sweep], Reals]) -> str:
    """Return for which kinds of pairs a sweep is right, if it is for some."""
    right = dict.fromkeys(("no step", "one step that ends", "one step that goes on", "several steps"), True)
    for case, table in zip(cases, found, strict=True):
        for pair, expected in np.ndenumerate(rule(case)):
            ends = [terminated for s, a, *_, terminated in case[0] if (s, a) == pair]
            alone = "one step that ends" if all(ends) else "one step that goes on"
            kind = ("no step", alone)[len(ends)] if len(ends) < 2 else "several steps"
            right[kind] &= same(float(table[pair]), float(expected))
    if not any(right.values()):
        return UNUSUAL
    wrong, well = (" or with ".join(kind for kind in right if right[kind] == side) for side in (False, True))
    return f"pairs with {well} are right, so look at those with {wrong}"
