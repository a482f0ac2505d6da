"""The exercises of lesson 16: a weighted estimate, a doubly robust one, and one sweep of pessimistic fitted Q."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import accumulate
from operator import mul
from typing import Annotated, Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables, table_of
from edugym_course.grading.values import number

N_STATES, N_ACTIONS = 3, 2
Discount = Annotated[
    float,
    Own(
        tuple(k / 100 for k in range(30, 91)),
        "In your version a reward that comes a step later counts {discount} times as much: there is a discount.",
    ),
]
Episode = list[tuple[int, int, float]]
"""Steps (state, action, reward)."""
Judging = tuple[list[Episode], Reals, Reals]
"""Episodes, the target policy, and the behaviour policy."""


def _ratios(episode: Episode, target: Reals, behaviour: Reals) -> list[float]:
    """π / b of each step."""
    return [float(target[s, a] / behaviour[s, a]) for s, a, _ in episode]


def _weight(ratios: Sequence[float], kind: str) -> float:
    """What an episode weighs; other kinds than the product are mistakes."""
    if kind == "upside down":
        return float(np.prod([1 / ratio for ratio in ratios]))
    return {
        "product": float(np.prod(ratios)),
        "sum": float(np.sum(ratios)),
        "mean": float(np.mean(ratios)),
        "last": ratios[-1],
        "first": ratios[0],
        "one": 1.0,
    }[kind]


def _gathered(episode: Episode, ratios: Sequence[float], kind: str, discount: float) -> float:
    """What an episode is worth; other kinds than the sum of its rewards are mistakes."""
    rewards = [discount**t * r for t, (*_, r) in enumerate(episode)]
    if kind == "per decision":
        return sum(float(np.prod(ratios[: t + 1])) * r for t, r in enumerate(rewards))
    return {"sum": sum(rewards), "mean": sum(rewards) / len(rewards), "last": rewards[-1]}[kind]


def weighed(
    case: Judging,
    *,
    weight: str = "product",
    by: str = "weights",
    gathered: str = "sum",
    carried: str = "nothing",
    discount: float = 1.0,
) -> float:
    """Return the weighted estimate; other arguments than the defaults are mistakes."""
    episodes, target, behaviour = case
    if by == "first episode":
        episodes = episodes[:1]
    ratios = [_ratios(episode, target, behaviour) for episode in episodes]
    if weight == "target alone":
        weights = [float(np.prod([target[s, a] for s, a, _ in episode])) for episode in episodes]
    else:
        weights = [_weight(one, weight) for one in ratios]
    returns = [_gathered(episode, one, gathered, discount) for episode, one in zip(episodes, ratios, strict=True)]
    if carried == "weights":
        weights = [*accumulate(weights, mul)]
    if carried == "returns":
        returns = [*accumulate(returns)]
    counted = [1.0] * len(returns) if gathered == "per decision" else weights
    total = sum(w * g for w, g in zip(counted, returns, strict=True))
    divisors = {"episodes": len(episodes), "nothing": 1.0, "steps": sum(map(len, episodes))}
    return total / divisors.get(by, sum(weights))


WEIGHED_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "it is divided by the number of episodes, as in ordinary importance sampling; divide by the sum of the weights": {
        "by": "episodes"
    },
    "the ratio is upside down: π, the policy to be judged, goes above b, which acted": {"weight": "upside down"},
    "the ratios of an episode are added; its steps happened one after the other, so multiply them": {"weight": "sum"},
    "the weight is the mean of the ratios; it is their product": {"weight": "mean"},
    "only the last step of an episode has a ratio; multiply those of all steps": {"weight": "last"},
    "only the first step of an episode has a ratio; multiply those of all steps": {"weight": "first"},
    "every episode weighs the same: that is what b is worth, and the weights are left out": {"weight": "one"},
    "the weights are products of π alone; b, which chose the episodes, is left out": {"weight": "target alone"},
    "it is not divided by the sum of the weights": {"by": "nothing"},
    "the mean reward of a step takes the place of the return; an episode is worth the sum of its rewards": {
        "gathered": "mean"
    },
    "only the last reward of an episode counts; its return is the sum of all": {"gathered": "last"},
    "each reward has the weight up to its step: that is per decision; here an episode has one weight": {
        "gathered": "per decision"
    },
    "the weight goes on from one episode to the next; each episode begins with 1": {"carried": "weights"},
    "the return goes on from one episode to the next; each episode begins with 0": {"carried": "returns"},
    "only the first episode is looked at: does a `return` stand inside the loop?": {"by": "first episode"},
    "it is divided by the number of steps; divide by the sum of the weights": {"by": "steps"},
}


def _policies(rng: np.random.Generator) -> tuple[Reals, Reals]:
    """Two policies of which no action has a probability of 0; in eighths, so that a student can follow them."""
    first = rng.integers(1, 8, (2, N_STATES)) / 8
    target, behaviour = (np.stack([one, 1 - one], axis=1) for one in first)
    return target, behaviour


def _episode(rng: np.random.Generator, length: int) -> Episode:
    return [
        (int(rng.integers(N_STATES)), int(rng.integers(N_ACTIONS)), float(rng.integers(-4, 9))) for _ in range(length)
    ]


def _judgings(rng: np.random.Generator) -> list[Judging]:
    """Make up episodes of several lengths."""
    return [([_episode(rng, n) for n in lengths], *_policies(rng)) for lengths in ((2, 3), (1, 2, 4), (3, 3, 2))]


def exercise_1(answer: Any, seed: int, discount: Discount = 1.0) -> str:
    """Check the weighted estimate of what a policy is worth."""
    require_function("weighted_estimate", answer, "episodes, target and behaviour")
    right = partial(weighed, discount=discount)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in WEIGHED_MISTAKES.values())]
    cases = []
    for case in _judgings(telling_draw(seed, _judgings, rules)):
        episodes, target, behaviour = case
        call = f"weighted_estimate({episodes}, {target.tolist()}, {behaviour.tolist()})"
        mine = [list(episode) for episode in episodes], target.copy(), behaviour.copy()
        with student_code(call):
            found = answer(*mine)
        if mine[0] != episodes or not (np.array_equal(mine[1], target) and np.array_equal(mine[2], behaviour)):
            raise WrongAnswer(f"{call} changes something that it is given, which others may still need")
        mistakes = {why: right(case, **change) for why, change in WEIGHED_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases)
    return "Right: an episode counts as much as the other policy would rather have played it."


Correcting = tuple[Episode, Reals, Reals, Reals]
"""An episode, the target policy, the behaviour policy, and the values that are believed."""


def corrected(
    case: Correcting,
    *,
    ratio: str = "right",
    value: str = "mean",
    taken_off: str = "right",
    later: str = "inside",
    order: str = "backwards",
    discount: float = 1.0,
) -> float:
    """Return the doubly robust value of an episode; other arguments than the defaults are mistakes."""
    episode, target, behaviour, Q = case
    total, product = 0.0, 1.0
    if order == "last step":
        episode = episode[-1:]
    for s, a, r in episode if order == "forwards" else episode[::-1]:
        product *= target[s, a] / behaviour[s, a]
        rho = {
            "product": product,
            "right": target[s, a] / behaviour[s, a],
            "left out": 1.0,
            "upside down": behaviour[s, a] / target[s, a],
        }[ratio]
        V = {
            "mean": target[s] @ Q[s],
            "largest": Q[s].max(),
            "of b": behaviour[s] @ Q[s],
            "plain": Q[s].mean(),
            "of the action": Q[s, a],
            "left out": 0.0,
        }[value]
        off = {"right": Q[s, a], "left out": 0.0, "V": V}[taken_off]
        total = {
            "inside": V + rho * (r + discount * total - off),
            "outside": V + rho * (r - off) + discount * total,
            "left out": V + rho * (r - off),
            "Q outside": V + rho * (r + discount * total) - off,
            "reward alone": V + rho * r + discount * total - off,
            "V inside": rho * (V + r + discount * total - off),
            "added": total + V + rho * (r + discount * total - off),
        }[later]
    return float(total)


CORRECTED_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "ρ is left out": {"ratio": "left out"},
    "ρ is upside down: π, the policy to be judged, goes above b, which acted": {"ratio": "upside down"},
    "V(s) is the largest value of the state; π does not always take that action, so take the mean by π": {
        "value": "largest"
    },
    "V(s) is the mean by b; it is π that is judged": {"value": "of b"},
    "V(s) is the value of the action that was taken; it is the mean by π over all actions": {"value": "of the action"},
    "V(s) is left out: the believed values are only taken off, and never added": {"value": "left out"},
    "Q(s, a) is left out: then the believed values are counted, and the rewards as well": {"taken_off": "left out"},
    "V(s) is taken off; it is the value of the action that was taken, Q(s, a)": {"taken_off": "V"},
    "what comes later is not weighed by ρ: it belongs into the parentheses, beside the reward": {"later": "outside"},
    "what comes later is left out": {"later": "left out"},
    "V(s) is the plain mean of the values; each action counts as often as π takes it": {"value": "plain"},
    "ρ stands before the reward and what comes later; it goes before − Q(s, a), too": {"later": "Q outside"},
    "the believed values play no part: that is importance sampling": {"value": "left out", "taken_off": "left out"},
    "ρ stands before the reward alone; it goes before the whole parentheses": {"later": "reward alone"},
    "ρ goes before V(s), too; V(s) stands in front of it": {"later": "V inside"},
    "what comes later is counted twice: the new value takes the place of the old one": {"later": "added"},
    "ρ is the product over the steps; here it is that of one step, for the value has the later ones": {
        "ratio": "product"
    },
    "only the last step is looked at: does a `return` stand inside the loop?": {"order": "last step"},
    "the steps are gone through forwards; what a step is worth needs what comes after it, so begin at the end": {
        "order": "forwards"
    },
}


def _correctings(rng: np.random.Generator) -> list[Correcting]:
    """Make up an episode of one step, and longer ones."""
    return [
        (_episode(rng, length), *_policies(rng), rng.integers(-4, 9, (N_STATES, N_ACTIONS)).astype(float))
        for length in (1, 2, 3, 4)
    ]


def exercise_2(answer: Any, seed: int, discount: Discount = 1.0) -> str:
    """Check the doubly robust value of one episode."""
    require_function("doubly_robust_value", answer, "episode, target, behaviour and Q")
    right = partial(corrected, discount=discount)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in CORRECTED_MISTAKES.values())]
    cases = []
    for case in _correctings(telling_draw(seed, _correctings, rules)):
        episode, *tables = case
        told = ", ".join(str(table.tolist()) for table in tables)
        call = f"doubly_robust_value({episode}, {told})"
        mine, copies = [*episode], [table.copy() for table in tables]
        with student_code(call):
            found = answer(mine, *copies)
        kept = [np.array_equal(one, other) for one, other in zip(copies, tables, strict=True)]
        if mine != episode or not all(kept):
            raise WrongAnswer(f"{call} changes something that it is given, which others may still need")
        mistakes = {why: right(case, **change) for why, change in CORRECTED_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases)
    return "Right: what is believed, corrected wherever a reward or a next step tells otherwise."


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
    per: str = "pair",
    discount: float = 1.0,
) -> Reals:
    """Return the values after one sweep; other arguments than the defaults are mistakes."""
    steps, before, penalty, lowest = case
    targets: dict[tuple[int, int], list[float]] = {}
    for s, a, r, after, terminated in steps:
        if terminated and end == "skipped":
            continue
        V = {
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
        fitted = {"mean": float(np.mean(seen)), "sum": sum(seen), "last": seen[-1], "best": max(seen)}[fit]
        size = {
            "root of both": np.sqrt(penalty / n),
            "root": penalty / np.sqrt(taken),
            "n": penalty / taken,
            "one": penalty,
            "times": penalty * np.sqrt(n),
        }
        Q[s, a] = fitted - sign * {**size, "none": 0.0}[over]
        if floor != "none":
            Q[s, a] = {"max": max, "min": min}[floor](lowest, Q[s, a])
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
    "the best target of each pair stays; fit the mean of all of them": {"fit": "best"},
    "pairs without a step are 0; a pessimist gives them the lowest value": {"unseen": "zero"},
    "pairs without a step keep their value; a pessimist gives them the lowest value": {"unseen": "before"},
    "pairs without a step get the penalty as a value; a pessimist gives them the lowest value": {"unseen": "penalty"},
    "some values are below the lowest one there is": {"floor": "none"},
    "of the value and the lowest one it takes the smaller; max(...) takes the larger": {"floor": "min"},
    "what comes after the end is counted: where `terminated` is True the target is the reward alone": {"end": "always"},
    "what comes after a step is left out: where the task goes on, add the largest value of the next state": {
        "end": "never"
    },
    "the reward of the last step is lost: where `terminated` is True it is the target": {"end": "worth 0"},
    "steps that end are left out; their target is the reward alone": {"end": "skipped"},
    "that is the largest value of the state itself; take that of the *next* state": {"future": "own"},
    "the next state counts with its mean value; take the largest": {"future": "mean"},
    "the next state counts with the value of the same action; take the largest": {"future": "same action"},
}


def _sweeps(rng: np.random.Generator) -> list[Sweep]:
    """Make up steps: some pairs come several times, some never, and one value would be below the lowest."""
    made = list[Sweep]()
    for penalty, n_steps in ((2.0, 6), (3.0, 8), (12.0, 7)):
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
        made.append((steps, rng.integers(-3, 6, (N_STATES, N_ACTIONS)).astype(float), penalty, -9.0))
    return made


def exercise_3(answer: Any, seed: int, discount: Discount = 1.0) -> str:
    """Check one sweep of pessimistic fitted Q."""
    require_function("pessimistic_sweep", answer, "steps, Q, penalty and lowest")
    right = partial(swept, discount=discount)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **change) for change in SWEPT_MISTAKES.values())]
    cases = _sweeps(telling_draw(seed, _sweeps, rules))
    found, calls = [], []
    for steps, before, penalty, lowest in cases:
        call = f"pessimistic_sweep({steps}, {before.tolist()}, {penalty:g}, {lowest:g})"
        mine, table = [*steps], before.copy()
        with student_code(call):
            made = answer(mine, table, penalty, lowest)
        if not np.array_equal(table, before):
            raise WrongAnswer(
                f"{call} changes the table Q that it is given: all targets need the old one, so make a new one"
            )
        if mine != steps:
            raise WrongAnswer(f"{call} changes the steps that it is given, which others may still need")
        found.append(table_of(call, made, before.shape))
        calls.append(call)
    compare_tables(cases, found, calls, SWEPT_MISTAKES, right)
    return "Right: every target at once, from the old table, and less for what is hardly known."
