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
from edugym_course.grading.values import number, same
from edugym_course.lessons.offline.sweeps import N_ACTIONS, N_STATES, SWEPT_MISTAKES, made_up_sweeps, swept, where_wrong

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


WEIGHTS = "one episode alone is right, so look at the weights, at the two sums, and at what each episode begins with"
SUMS = "with one episode its weight cancels, and its return is left: look at the return, and at the two sums"


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
    """Make up episodes of several lengths; first one alone, which is worth its return, whatever it weighs."""
    return [([_episode(rng, n) for n in lengths], *_policies(rng)) for lengths in ((2,), (2, 3), (1, 2, 4), (3, 3, 2))]


NEVER = "π never takes the first action of the first episode, whose weight is 0: leave no ratio out, and replace none"


def _never(rng: np.random.Generator) -> Judging:
    """Make up two episodes; π never takes the first action of the first."""
    target, behaviour = _policies(rng)
    (state, action, _), *_ = first = _episode(rng, 3)
    target[state] = np.arange(N_ACTIONS) != action
    other = [(s, 1 - action if s == state else a, r) for s, a, r in _episode(rng, 2)]
    return [first, other], target, behaviour


def exercise_1(answer: Any, seed: int, discount: Discount = 1.0) -> str:
    """Check the weighted estimate of what a policy is worth."""
    require_function("weighted_estimate", answer, "episodes, target and behaviour")
    right = partial(weighed, discount=discount)

    def asked(case: Judging) -> tuple[str, float, float]:
        episodes, target, behaviour = case
        call = f"weighted_estimate({episodes}, {target.tolist()}, {behaviour.tolist()})"
        mine = [list(episode) for episode in episodes], target.copy(), behaviour.copy()
        with student_code(call):
            found = answer(*mine)
        if mine[0] != episodes or not (np.array_equal(mine[1], target) and np.array_equal(mine[2], behaviour)):
            raise WrongAnswer(f"{call} changes something that it is given, which others may still need")
        return call, number(call, found), right(case)

    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in WEIGHED_MISTAKES.values())]
    drawn = telling_draw(seed, _judgings, rules)
    cases = [
        NumberCase(*asked(case), {why: right(case, **change) for why, change in WEIGHED_MISTAKES.items()})
        for case in _judgings(drawn)
    ]
    compare_all(cases, WEIGHTS if same(cases[0].found, cases[0].expected) else SUMS)
    compare_all([NumberCase(*asked(_never(drawn)), {})], NEVER)
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


LATER = "an episode of one step is right, so look at what comes later, and at where it is kept"
ONE_STEP = "that is wrong from one step on: an episode of one step is worth V(s) + ρ (R − Q(s, a))"


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
    one_step = same(cases[0].found, cases[0].expected)
    compare_all(cases, LATER if one_step else ONE_STEP)
    return "Right: what is believed, corrected wherever a reward or a next step tells otherwise."


def exercise_3(answer: Any, seed: int, discount: Discount = 1.0) -> str:
    """Check one sweep of pessimistic fitted Q."""
    require_function("pessimistic_sweep", answer, "steps, Q, penalty and lowest")
    right = partial(swept, discount=discount)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **change) for change in SWEPT_MISTAKES.values())]
    cases = made_up_sweeps(telling_draw(seed, made_up_sweeps, rules))
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
    compare_tables(cases, found, calls, SWEPT_MISTAKES, right, otherwise=lambda _: where_wrong(cases, found, right))
    return "Right: every target at once, from the old table, and less for what is hardly known."
