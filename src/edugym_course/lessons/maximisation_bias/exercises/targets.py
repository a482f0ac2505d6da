"""Exercises 2 and 3 of lesson 17: an update of double Q-learning, a maxmin target, and the usual mistakes in both."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES
from edugym_course.grading.values import in_brackets

N_STATES, N_ACTIONS = 3, 3
VALUES = (-5.0, -4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0)
"""The values in a table; none is 0, which would look as if nothing followed."""
ENDS = (
    *((True, False), (False, False), (True, True), (False, False), (True, False), (False, True), (True, True)),
    *((False, False), (True, False), (True, False), (False, False)),
)
"""For each case of exercises 2 and 3, whether Q1 learns, and whether the step ends an episode."""


def _target(case: Any, cost: float, following: float, end: str, gamma: str) -> float:
    """Return the target of an update, for a value of what follows; other arguments than "right" are mistakes."""
    reward = float(case.reward) - cost
    going_on = {"always": True, "never": False, "inverted": case.terminated}.get(end, not case.terminated)
    if end == "lost" and case.terminated:
        return 0.0
    rate = {"one": 1.0, "learning rate": getattr(case, "learning_rate", 1.0)}.get(gamma, case.discount)
    told: float = {
        "all": rate * (reward + following),
        "twice": rate * (reward + rate * following),
        "no reward": rate * following,
        "minus": reward - rate * following,
    }.get(gamma, reward + rate * following)
    return told if going_on else reward


END_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "what comes after the end is counted: where `terminated` is True the target is the reward alone": {"end": "always"},
    "what comes after a step is left out": {"end": "never"},
    "`terminated` is taken the wrong way round: what follows counts where it is *False*": {"end": "inverted"},
    "the reward of the step that ends an episode is lost: where `terminated` is True the target is the reward": {
        "end": "lost"
    },
    "the discount is left out": {"gamma": "one"},
    "the reward is discounted, too; only what follows is": {"gamma": "all"},
    "the target is discounted once more; only what follows is discounted, and once": {"gamma": "twice"},
    "the reward is left out where something follows": {"gamma": "no reward"},
    "what follows is subtracted; it is added to the reward": {"gamma": "minus"},
}
"""What goes wrong in a target, whatever the value of what follows."""


def _reward(rng: np.random.Generator) -> float:
    """Draw a reward that is not 0, so that it shows whether it counts."""
    return float(rng.choice((-3, -2, -1, 1, 2, 3, 4, 5)))


class Learning(NamedTuple):
    """A step for exercise 2, and the tables before it."""

    Q1: Reals
    Q2: Reals
    first: bool
    state: int
    action: int
    reward: float
    next_state: int
    terminated: bool
    learning_rate: float
    discount: float


def doubled(
    case: Learning,
    *,
    value: str = "the other",
    changed: str = "right",
    end: str = "right",
    gamma: str = "right",
    less: str = "own",
    step: str = "right",
    place: str = "right",
    cost: float = 0.0,
) -> Reals:
    """Return both tables after the update, shape (2, S, A); other arguments than the defaults are mistakes."""
    tables = np.stack([case.Q1, case.Q2])
    chosen = {"right": not case.first, "first": False, "second": True, "other": case.first, "both": not case.first}
    entry: Any = {
        "right": (case.state, case.action),
        "next": (case.next_state, case.action),
        "row": (case.state, slice(None)),
        "turned": (case.action, case.state),
    }[place]
    for i in (0, 1) if changed == "both" else (int(chosen[changed]),):
        own, other = np.stack([case.Q1, case.Q2])[[i, 1 - i]]
        here, there = own[case.next_state], other[case.next_state]
        following = {
            "the other": there[here.argmax()],
            "own": here.max(),
            "the other's maximum": there.max(),
            "swapped": here[there.argmax()],
            "mean": (here + there).max() / 2,
            "smaller": np.minimum(here, there).max(),
            "more cautious": min(here.max(), there[here.argmax()]),
            "sum chooses": there[(here + there).argmax()],
            "old state chooses": there[own[case.state].argmax()],
            "old state": other[case.state, here.argmax()],
            "taken": there[case.action],
            "index": here.argmax(),
            "worst": there[here.argmin()],
            "average": there.mean(),
        }[value]
        target = _target(case, cost, float(following), end, gamma)
        if end == "no step" and case.terminated:
            continue
        old = (own if less == "own" else other)[entry]
        tables[(i, *entry)] += {
            "right": case.learning_rate * (target - old),
            "whole": target - old,
            "only": case.learning_rate * target,
            "away": -case.learning_rate * (target - old),
            "swapped": case.discount * (target - old),
            "mostly": (1 - case.learning_rate) * (target - old),
        }[step]
    return tables


DOUBLE_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    **END_MISTAKES,
    "the step that ends an episode changes nothing; it has a target, too: the reward alone": {"end": "no step"},
    "the table that chooses the action also says what it is worth: that is Q-learning with two tables": {
        "value": "own"
    },
    "that is the largest value of the other table; the action is the best one of the table that learns": {
        "value": "the other's maximum"
    },
    "the roles are swapped: the table that learns chooses the action, and the other says what it is worth": {
        "value": "swapped"
    },
    "the tables are averaged before the maximum; one chooses, and the other says what that is worth": {"value": "mean"},
    "the smaller value of both counts: that is maxmin Q-learning": {"value": "smaller"},
    "of the two values of the chosen action the smaller one counts; the other table says alone what it is worth": {
        "value": "more cautious"
    },
    "both tables are changed; `first` says which one learns": {"changed": "both"},
    "Q1 is changed, whatever `first` says": {"changed": "first"},
    "Q2 is changed, whatever `first` says": {"changed": "second"},
    "the other table is changed: Q1 learns if `first` is True": {"changed": "other"},
    "the action is the best one by both tables together; the table that learns chooses it alone": {
        "value": "sum chooses"
    },
    "the action is the best one of `state`; it is chosen in `next_state`": {"value": "old state chooses"},
    "the other table is asked about `state`; what counts is the value in `next_state`": {"value": "old state"},
    "the other table is asked about the action that was taken; it is asked about the best one in `next_state`": {
        "value": "taken"
    },
    "argmax is the *number* of the best action; the other table says what it is worth": {"value": "index"},
    "the action with the *smallest* value is chosen": {"value": "worst"},
    "that is the mean of the other table's values; it is asked about one action only": {"value": "average"},
    "the value of `next_state` is changed; what is learned is the value of `state`": {"place": "next"},
    "the values of *all* actions of `state` are changed; learn about the action that was taken": {"place": "row"},
    "the old value is taken from the other table": {"less": "other"},
    "the learning rate is left out": {"step": "whole"},
    "− Q(S, A) is left out: the target takes the place of the error": {"step": "only"},
    "the value moves *away* from the target: the error is the target less the old value": {"step": "away"},
    "α and 1 − α are swapped: the old value counts 1 − α": {"step": "mostly"},
    "state and action are swapped: Q1[state, action]": {"place": "turned"},
    "the learning rate and the discount are swapped": {"step": "swapped", "gamma": "learning rate"},
}


def learnings(rng: np.random.Generator) -> list[Learning]:
    """Make up steps: for both tables, and one that ends."""
    made = []
    for first, terminated in ENDS:
        Q1, Q2 = (rng.permuted(VALUES).reshape(N_STATES, N_ACTIONS) for _ in range(2))
        state, next_state = rng.choice(N_STATES, 2, replace=False).tolist()
        action, reward = int(rng.integers(N_ACTIONS)), _reward(rng)
        rates = float(rng.choice(LEARNING_RATES)), float(rng.choice(DISCOUNTS))
        made.append(Learning(Q1, Q2, first, state, action, reward, next_state, terminated, *rates))
    return made


def update_by_hand(case: Learning, cost: float) -> str:
    """Return what the update of a case is made of, for the sentence."""
    own, other = (case.Q1, case.Q2) if case.first else (case.Q2, case.Q1)
    best, reward = int(own[case.next_state].argmax()), case.reward - cost
    what, target = "the step ends its episode", reward
    if not case.terminated:
        worth = other[case.next_state, best]
        what, target = (
            f"action {best} looks best in state {case.next_state} to it, and the other says {worth:g}",
            reward,
        )
        target += case.discount * worth
    return (
        f"Q{1 if case.first else 2} learns here, {what}, so the target is {target:.4g}, and the old value"
        f" {own[case.state, case.action]:g}: compare these with yours"
    )


class Aim(NamedTuple):
    """The tables and the outcome of a step, for exercise 3."""

    tables: Reals
    reward: float
    next_state: int
    terminated: bool
    discount: float


def aimed(
    case: Aim,
    *,
    rule: str = "maxmin",
    end: str = "right",
    gamma: str = "right",
    cost: float = 0.0,
) -> float:
    """Return the target of maxmin Q-learning; other arguments than the defaults are mistakes."""
    row = case.tables[:, case.next_state]
    value = {
        "maxmin": row.min(axis=0).max(),
        "minmax": row.max(axis=1).min(),
        "mean": row.mean(axis=0).max(),
        "largest": row.max(),
        "smallest": row.min(),
        "maxmax": row.max(axis=0).min(),
        "other axis": row.min(axis=1).max(),
        "first": row[0].max(),
        "two": row[:2].min(axis=0).max(),
        "all": case.tables.min(axis=0).max(),
        "last": row[-1].max(),
        "first state": case.tables[:, 0].min(axis=0).max(),
        "mean of all": row.mean(),
        "last axis": case.tables[:, :, case.next_state].min(axis=0).max(),
        "index": row.min(axis=0).argmax(),
        "indices": row.argmin(axis=0).max(),
        "sum": row.min(axis=0).sum(),
        "average": row.min(axis=0).mean(),
        "first action": row[:, 0].min(),
        "from 0": max(0.0, row.min(axis=0).max()),
        "least from 0": np.minimum(0.0, row.min(axis=0)).max(),
    }[rule]
    return _target(case, cost, float(value), end, gamma)


AIM_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the maximum of each table is taken first, and the smallest of these; first take the smallest value of each"
    " action": {"rule": "minmax"},
    "the tables are averaged; take the smallest value of each action": {"rule": "mean"},
    "that is the largest value of all tables; first take the smallest value of each action": {"rule": "largest"},
    "that is the smallest value of all; take the largest of the actions' smallest values": {"rule": "smallest"},
    "the largest value of each action is taken, and the smallest of these: it is the other way round": {
        "rule": "maxmax"
    },
    "the minimum goes over the actions of each table; it goes over the tables, for each action": {"rule": "other axis"},
    "only the first table counts": {"rule": "first"},
    "only the last table counts: take the smallest value of each action": {"rule": "last"},
    "the row is that of state 0; take the row of the next state": {"rule": "first state"},
    "that is the mean of all values; take the smallest value of each action, and the largest of these": {
        "rule": "mean of all"
    },
    "only the first two tables count; there may be more": {"rule": "two"},
    "the maximum goes over all states; take the row of the next state": {"rule": "all"},
    "`next_state` is the last index; the shape is (tables, states, actions)": {"rule": "last axis"},
    "argmax is the *number* of an action; the target needs its value": {"rule": "index"},
    "argmin is the *number* of a table; take its value": {"rule": "indices"},
    "the smallest values of the actions are added up; take the largest of them": {"rule": "sum"},
    "the smallest values of the actions are averaged; take the largest of them": {"rule": "average"},
    "only the first action counts: does `return` stand inside a loop?": {"rule": "first action"},
    "the search for the largest value begins at 0, and here all may be below: begin at −infinity": {"rule": "from 0"},
    "the search for the smallest value begins at 0, and here all may be above: begin at infinity": {
        "rule": "least from 0"
    },
    **END_MISTAKES,
}


def target_by_hand(case: Aim, cost: float) -> str:
    """Return what the target of a case is made of, for the sentence."""
    if case.terminated:
        return f"the step ends its episode, so its reward, {case.reward - cost:g}, is all"
    smallest = case.tables[:, case.next_state].min(axis=0)
    return (
        f"the smallest values of the actions in state {case.next_state} are {in_brackets(smallest)} here, and the"
        f" largest of these is {smallest.max():g}: compare these with yours"
    )


def aims(rng: np.random.Generator) -> list[Aim]:
    """Make up tables, two, three or four, and outcomes of which one ends."""
    return [
        Aim(
            rng.integers(-9, 9, (n, N_STATES, N_ACTIONS)).astype(float) + 0.5,
            _reward(rng),
            int(rng.integers(N_STATES)),
            terminated,
            float(rng.choice(DISCOUNTS)),
        )
        for n, (_, terminated) in zip((2, 3, 4, 3, 2, 3, 4, 3, 2, 4, 3), ENDS, strict=True)
    ]
