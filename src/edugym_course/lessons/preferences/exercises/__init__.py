"""The exercises of lesson 14: the probability of a preference, a gradient step, and a policy with a penalty."""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Annotated, Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import UNUSUAL, NumberCase, compare_all
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables, table_of
from edugym_course.grading.values import UNUSUAL_NUMBER, all_same, digits, given, in_brackets, number, same, unlike
from edugym_course.lessons.preferences.exercises.policies import EXTREMES, POLICY_MISTAKES, Choice, choices, weighed

FAR = 10_000.0
"""How much two nights may differ: far more than an exponential can take."""
DIFFERENCES = ((3.0, 1.0, 2.0), (-4.0, -1.5, 0.5), (2.0, 2.0, 1.0), (0.5, 6.0, 4.0), (1.0, 0.0, 8.0), (4e3, 0.0, 1.6e3))
"""Made-up pairs of nights and the noise: positive, negative, equal, far, near, and far with as much noise."""


def _p(first: float, second: float, noise: float) -> float:
    """Return the probability of the first night."""
    return float(0.5 + 0.5 * np.tanh((first - second) / noise / 2))


PREFERENCE_MISTAKES: Mapping[str, Callable[[float, float, float], float]] = {
    "that is the probability of the *second* night: σ takes first − second": lambda g, h, t: _p(h, g, t),
    "the noise is left out: divide the difference by it": lambda g, h, t: _p(g, h, 1.0),
    "the difference is multiplied by the noise; more noise brings p closer to 1/2, so divide": lambda g, h, t: _p(
        g, h, 1 / t
    ),
    "only the second night is divided by the noise: put the difference in parentheses": lambda g, h, t: _p(
        g, h / t, 1.0
    ),
    "that is 1 or 0, as if the teacher never erred": lambda g, h, t: float(g > h),
    "that is 1, 1/2 or 0, as if the teacher never erred": lambda g, h, t: 0.5 + 0.5 * float(np.sign(g - h)),
    "that is e^x and no probability: divide it by 1 + e^x": lambda g, h, t: float(np.exp((g - h) / t)),
    "that is x itself, and σ(x) is missing": lambda g, h, t: (g - h) / t,
    "that is the logarithm of the probability": lambda g, h, t: float(np.log(_p(g, h, t))),
    "that is the share of the first return; returns may be negative, and only their difference counts": (
        lambda g, h, t: g / (g + h) if g + h else 0.0
    ),
    "that is the distribution function of a normal distribution; σ is 1 / (1 + e^(−x))": lambda g, h, t: (
        0.5 + 0.5 * math.erf((g - h) / t / math.sqrt(2))
    ),
    "σ itself is divided by the noise; divide the difference": lambda g, h, t: _p(g, h, 1.0) / t,
    "the difference is divided by the square of the noise": lambda g, h, t: _p(g, h, t * t),
    "the difference counts twice: with tanh, σ(x) is (1 + tanh(x / 2)) / 2": lambda g, h, t: _p(g, h, t / 2),
    "the difference is divided by twice the noise": lambda g, h, t: _p(g, h, 2 * t),
    "that is tanh, which goes from −1 to 1; σ goes from 0 to 1": lambda g, h, t: float(np.tanh((g - h) / t)),
}


Lead = Annotated[
    float,
    Own(
        tuple(k / 4 for k in range(1, 61)),
        "Your teacher has a weakness for what comes first: in your version the first night counts {lead} more to her.",
    ),
]


def _as_sigmoid(cases: Sequence[NumberCase]) -> str:
    """Return of which number an unusual probability is σ, and of which it should be."""
    case = next((one for one in cases if not same(one.found, one.expected)), cases[0])
    if not 0 < case.found < 1:
        return UNUSUAL_NUMBER
    found, x = (math.log(p / (1 - p)) for p in (case.found, case.expected))
    return f"that is σ({found:.4g}), and should be σ({x:.4g})"


def exercise_1(answer: Any, seed: int, lead: Lead = 0.0) -> str:
    """Check the probability of a preference, also of nights that are far apart; the first may have a lead."""
    require_function("prefers", answer, "first, second and noise")
    shift = float(np.random.default_rng(seed).integers(0, 9)) / 4
    cases = []
    for first, second, noise in ((g + shift, h + shift, t) for g, h, t in DIFFERENCES):
        call = f"prefers({first:g}, {second:g}, {noise:g})"
        with student_code(call):
            found = answer(first, second, noise)
        counts = first + lead
        mistakes = {why: mistake(counts, second, noise) for why, mistake in PREFERENCE_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), _p(counts, second, noise), mistakes))
    compare_all(cases, _as_sigmoid(cases))
    for first, second, expected in ((FAR, 0.0, 1.0), (0.0, FAR, 0.0), (-1.0, -FAR - 1.0, 1.0)):
        call = f"prefers({first:g}, {second:g}, 1)"
        with student_code(call):
            found = answer(first, second, 1.0)
        given(call, found)
        if hasattr(found, "item") and not getattr(found, "ndim", 0):
            found = found.item()  # an array without axes, of NumPy or torch
        if isinstance(found, int | float | np.number) and 1e-6 < abs(found - expected) < 0.1:
            raise WrongAnswer(f"{call} should be {expected:g}, but is {found}: the difference is cut off too early")
        if not isinstance(found, int | float | np.number) or not abs(found - expected) < 1e-6:
            raise WrongAnswer(
                f"{call} should be {expected:g}, but is {found}: an exponential overflows, so write σ(x) for x below 0"
                " as e^x / (1 + e^x), and else as 1 / (1 + e^(−x))"
            )
    return "Right: only the difference counts, in units of the noise, and far apart she is sure."


Night = Sequence[tuple[int, int]]
Comparison = tuple[Reals, Night, Night, bool, float]
"""Rewards, the first night, the second, whether the first is preferred, and the learning rate."""
N_STATES, N_ACTIONS = 3, 2
LENGTH = 4


def stepped(
    comparison: Comparison,
    *,
    p_of: str = "first",
    counts: str = "visits",
    sign: float = 1.0,
    second: str = "subtracted",
    target: str = "right",
    rate: str = "right",
    slope: bool = False,
    rows: bool = False,
    kept: float = 1.0,
    sure: float = 1.0,
) -> Reals:
    """Return the table after one step; y is `sure` or 1 - `sure`. Other arguments than the defaults are mistakes."""
    rewards, one, other, prefers_first, learning_rate = comparison
    visits = [np.zeros_like(rewards) for _ in range(2)]
    for night, table in zip((one, other), visits, strict=True):
        for state, action in {"once": {*night}, "last": night[-1:], "first": night[:1]}.get(counts, night):
            table[state, action] += 1.0
    if counts == "overwritten":
        visits = [np.where(visits[1] > 0, 0.0, np.minimum(visits[0], 1.0)), np.minimum(visits[1], 1.0)]
    whole = [sum(float(rewards[pair]) for pair in night) for night in (one, other)]
    p = {
        "first": _p(whole[0], whole[1], 1.0),
        "second": _p(whole[1], whole[0], 1.0),
        "half": 0.5,
        "none": 0.0,
        "hard": float(whole[0] > whole[1]),
        "difference": whole[0] - whole[1],
        "means": _p(whole[0] / LENGTH, whole[1] / LENGTH, 1.0),
        "moving": 0.0,
        "share": whole[0] / sum(whole) if sum(whole) else 0.0,
    }[p_of]
    y = {
        "right": sure if prefers_first else 1 - sure,
        "always": sure,
        "never": 1 - sure,
        "signs": sure if prefers_first else -sure,
    }[target]
    if p_of == "moving":
        table = rewards.copy()
        for night, way in ((one, 1.0), (other, -1.0)):
            for pair in night:
                now = _p(sum(float(table[at]) for at in one), sum(float(table[at]) for at in other), 1.0)
                table[pair] += way * learning_rate * (y - now)
        return table
    error = sign * (y - p) * (p * (1 - p) if slope else 1.0)
    error *= {"right": learning_rate, "none": 1.0, "by length": learning_rate / LENGTH}[rate]
    away = {"subtracted": -1.0, "added": 1.0, "left out": 0.0, "winner": 0.0}[second]
    change = error * (visits[0] + away * visits[1])
    if second == "winner" and not prefers_first:
        change = -error * visits[1]
    if rows:
        change = change.sum(axis=1, keepdims=True)
    stepped_table: Reals = kept * rewards + change
    return stepped_table


STEP_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "that goes the other way: the night that she prefers must gain": {"sign": -1.0},
    "p is that of the second night: the first return less the second goes into σ": {"p_of": "second"},
    "p is 1/2, as with a table of zeros: work it out from the returns by `rewards`": {"p_of": "half"},
    "p is left out: the error is y − p": {"p_of": "none"},
    "p is 1 or 0, as if the teacher never erred: it is σ of the difference": {"p_of": "hard"},
    "p is the difference of the returns itself, and σ is missing": {"p_of": "difference"},
    "p follows from mean rewards; a return is a sum": {"p_of": "means"},
    "p changes on the way, with every entry: work it out once, from the old rewards": {"p_of": "moving"},
    "p is a share of the returns; it is σ of their difference": {"p_of": "share"},
    "only the night that she prefers has changed; the other one loses as much": {"second": "winner"},
    "all actions of a state have changed; only the one that was taken does": {"rows": True},
    "the old rewards are left out: add the step to them": {"kept": 0.0},
    "each pair of a state and an action counts once, and a night may take it more often": {"counts": "once"},
    "a pair that comes again starts from the old table: add to what already stands there (+=)": {
        "counts": "overwritten"
    },
    "only the last step of each night has changed; all of them count": {"counts": "last"},
    "only the first step of each night has changed; all of them count": {"counts": "first"},
    "the second night is added; what helps the first takes from the second": {"second": "added"},
    "only the first night has changed: subtract the second": {"second": "left out"},
    "y is 1 in every case: it is 0 where she prefers the second": {"target": "always"},
    "y is 0 in every case: it is 1 where she prefers the first": {"target": "never"},
    "y is −1 where she prefers the second; it is 0 there": {"target": "signs"},
    "the learning rate is left out": {"rate": "none"},
    "the step is divided by the number of steps of a night; a return is a sum, not a mean": {"rate": "by length"},
    "that is the gradient of the squared error, with the slope p (1 − p); that of the log likelihood has none": {
        "slope": True
    },
}


def _comparisons(rng: np.random.Generator) -> list[Comparison]:
    """Make up comparisons; nights take some pairs more than once."""
    made = list[Comparison]()
    for prefers_first in (True, False, True, False):
        rewards = np.round(rng.normal(size=(N_STATES, N_ACTIONS)), 2)
        nights = [
            [(int(s), int(a)) for s, a in zip(rng.integers(0, N_STATES, 3), rng.integers(0, N_ACTIONS, 3), strict=True)]
            for _ in range(2)
        ]
        one, other = ([*night, night[1]] for night in nights)  # its second pair comes twice
        made.append((rewards, one, other, prefers_first, float(rng.choice([0.125, 0.25]))))
    return made


Sure = Annotated[
    float,
    Own(
        tuple(k / 100 for k in range(51, 99)),
        "Do not trust her too much: in your version y is {sure} if she preferred the first night, and else 1 − {sure}.",
    ),
]


def _error_of(cases: Sequence[Comparison], found: Sequence[Reals], rule: Callable[[Comparison], Reals]) -> str:
    """Return what an unusual step has as α (y − p), and what it should be, if it changes the right entries."""
    for case, mine in zip(cases, found, strict=True):
        steps, expected = mine - case[0], rule(case) - case[0]
        at = np.unravel_index(np.abs(expected).argmax(), expected.shape)
        share = float(steps[at] / expected[at])
        if not all_same(steps, share * expected):
            return UNUSUAL
        if not same(share, 1.0):
            rest = stepped(case, p_of="none", target="always") - case[0]  # α times the counts
            found_error, error = (float(change[at] / rest[at]) for change in (steps, expected))
            return (
                f"the right entries change, but α (y − p) is {case[4] * found_error:.4g} here, and should be"
                f" {case[4]:g} · {error:.4g}"
            )
    return UNUSUAL


def exercise_2(answer: Any, seed: int, sure: Sure = 1.0) -> str:
    """Check one gradient step for one comparison, which may be trusted less than wholly."""
    require_function("learn", answer, "rewards, first, second, prefers_first and learning_rate")
    rules: list[Callable[[Any], Any]] = [stepped, *(partial(stepped, **change) for change in STEP_MISTAKES.values())]
    cases = _comparisons(telling_draw(seed, _comparisons, rules))
    found, calls = [], []
    for rewards, one, other, prefers_first, learning_rate in cases:
        call = f"learn(rewards, {one}, {other}, {prefers_first}, {learning_rate})"
        table, nights = rewards.copy(), ([*one], [*other])
        with student_code(call):
            mine = answer(table, *nights, prefers_first, learning_rate)
        if mine is None and not np.array_equal(table, rewards):
            raise WrongAnswer(f"{call} gives None, and has changed `rewards`: copy the table, and return the new one")
        found.append(table_of(call, mine, rewards.shape))
        if not np.array_equal(table, rewards):
            raise WrongAnswer(f"{call} changes the table that it is given: begin with rewards = rewards.copy()")
        if unlike(nights, (one, other)):
            raise WrongAnswer(f"{call} changes one of the nights, which others may still need")
        calls.append(call)
    right = partial(stepped, sure=sure)
    compare_tables(cases, found, calls, STEP_MISTAKES, right, otherwise=lambda _: _error_of(cases, found, right))
    return "Right: the error, times the rate, times where the two nights differ. What both did alike has not changed."


Times = Annotated[
    float,
    Own(
        tuple(k / 10 for k in range(12, 72) if k % 10),
        "Your factory is a careful one: in your version the penalty counts {times} times.",
    ),
]


def _odds(
    cases: Sequence[Choice], found: Sequence[Reals], rule: Callable[[Choice], Reals], wrong: Sequence[bool]
) -> str:
    """Return what an unusual policy has in the place of e^(Q / β), by the first case that is wrong."""
    at = [*wrong].index(True)
    if not same(float(found[at].sum()), 1.0):
        return "they do not sum to 1: divide by their sum, last of all"
    if found[at][cases[at][1] == 0].any():
        return "an action that the reference never takes keeps the probability 0"
    reference, expected = cases[at][1], rule(cases[at])
    both = (found[at] > 0) & (expected > 0)
    if not (mine := np.log(found[at][both] / reference[both])).size:
        return UNUSUAL
    should = np.log(expected[both] / reference[both])
    i, j = sorted([(mine - should).argmax(), (mine - should).argmin()])
    gain, right_gain = float(mine[i] - mine[j]), float(should[i] - should[j])
    if same(gain, right_gain):
        return UNUSUAL
    first, second = np.flatnonzero(both)[[i, j]]
    return (
        f"beside the reference, action {first} gains on action {second} by e^{digits(gain, right_gain)}, and should by"
        f" e^((Q(s, {first}) − Q(s, {second})) / β) = e^{digits(right_gain, gain)}"
    )


def exercise_3(answer: Any, seed: int, times: Times = 1.0) -> str:
    """Check the policy with a penalty, also with large values and a small penalty; it may count several times."""
    require_function("with_penalty", answer, "values, reference and penalty")
    rules: list[Callable[[Any], Any]] = [weighed, *(partial(weighed, **change) for change in POLICY_MISTAKES.values())]
    cases = [*choices(telling_draw(seed, choices, rules)), *EXTREMES]
    right = partial(weighed, times=times)
    found, calls = list[Reals](), list[str]()

    def compare() -> None:
        why = partial(_odds, cases, found, right)
        compare_tables(cases[: len(found)], found, calls, POLICY_MISTAKES, right, otherwise=why)

    for values, reference, penalty in cases:
        call = f"with_penalty({in_brackets(values)}, {in_brackets(reference)}, {penalty:g})"
        mine = values.copy(), reference.copy()
        with student_code(call):
            policy = answer(*mine, penalty)
        if not (np.array_equal(mine[0], values) and np.array_equal(mine[1], reference)):
            raise WrongAnswer(f"{call} changes one of the arrays that it is given: make a new one")
        table = table_of(call, policy, values.shape, finite=penalty > EXTREMES[0][2])
        if not np.isfinite(table).all():
            compare()  # what is wrong without any overflow is told first
            raise WrongAnswer(
                f"{call} should give {in_brackets(right((values, reference, penalty)))}, but gives"
                f" {in_brackets(table)}: an exponential overflows, or all of them are 0; first subtract the largest"
                " value *among the actions that the reference takes* from all values, and leave the others out: they"
                " may be worth more, and 0 times infinity is NaN"
            )
        found.append(table)
        calls.append(call)
    compare()
    return "Right: the reference, tilted towards what is worth more. An action that it never takes is never taken."
