"""The importance-sampling ratio of exercise 2, and the mistakes that are usually made in it."""

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, TypeAlias

from edugym_course.grading.mistakes import NumberCase, compare_all

RatioCase: TypeAlias = tuple[list[bool], float, int]
"""Which actions were greedy, ε, and the number of actions."""


def ratio(
    greedy: Sequence[bool],
    epsilon: float,
    n_actions: int,
    *,
    skipped: int = 1,
    likely: str = "1 - ε + ε/N",
    otherwise: str = "0",
    how: str = "product",
    empty: float = 1.0,
    most: float = math.inf,
    written: Mapping[str, float] = MappingProxyType({}),
) -> float:
    """Return the ratio, with no factor above `most`.

    Other arguments than the defaults are mistakes, `written` numbers in place of the arguments.
    """
    epsilon, n_actions = written.get("epsilon", epsilon), int(written.get("n_actions", n_actions))
    best = {
        "1 - ε + ε/N": 1 - epsilon + epsilon / n_actions,
        "1 - ε": 1 - epsilon,
        "1 - ε + ε/(N - 1)": 1 - epsilon + epsilon / (n_actions - 1),
        "1 - ε - ε/N": 1 - epsilon - epsilon / n_actions,
        "1 - ε/N": 1 - epsilon / n_actions,
        "1 - ε + ε N": 1 - epsilon + epsilon * n_actions,
        "ε/N": epsilon / n_actions,
    }[likely]
    of_best = min(1 / best, most) if best else most
    of_others = {
        "0": 0.0,
        "1": 1.0,
        "ε/N": epsilon / n_actions,
        "N/ε": n_actions / epsilon if epsilon else math.inf,
        "stop": 1.0,
    }[otherwise]
    actions = list(greedy[skipped:] if how != "without last" else greedy[skipped:-1])
    if otherwise == "stop" and False in actions:
        actions = actions[: actions.index(False)]
    if not actions and empty != 1.0:
        return empty
    factors = [of_best if is_greedy else of_others for is_greedy in actions]
    if how == "A_t too":
        return of_best ** len(actions) if all(greedy) else 0.0
    if how == "counted":
        return of_best ** (sum(greedy) - 1) if all(actions) or otherwise == "1" else 0.0
    if how == "zero":
        return 0.0
    if how == "once":
        return of_best if all(actions) else 0.0
    if how == "any":
        return of_best ** len(actions) if any(actions) or not actions else 0.0
    if how == "never":
        return of_best ** len(actions)
    if how == "last alone":
        return of_best ** len(actions) if greedy[-1] else 0.0
    if how == "next alone":
        return of_best ** len(actions) if all(actions[:1]) else 0.0
    if how == "one less":
        return of_best ** (len(actions) - 1) if all(actions) else 0.0
    if how == "numbers":
        return math.prod(k / best for k in range(1, len(greedy))) if best else most
    if how == "π explores":
        return math.prod((1 - epsilon if is_greedy else epsilon) / best for is_greedy in actions)
    if how == "turned":
        return math.prod(0.0 if is_greedy else of_best for is_greedy in actions)
    if how == "precedence":
        return math.prod(is_greedy / 1 - epsilon + epsilon / n_actions for is_greedy in actions)
    if how == "inverse":
        return best ** len(factors) if all(actions) else 0.0
    if how == "sum":
        return sum(factors)
    if how == "mean":
        return sum(factors) / len(factors) if factors else 0.0
    if how == "first":
        return factors[0] if factors else 1.0
    if how == "last":
        return factors[-1] if factors else 1.0
    if how == "probability":
        return math.prod(best if is_greedy else epsilon / n_actions for is_greedy in actions)
    if how == "all or nothing":
        return float(all(actions))
    return math.prod(factors)


MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the first entry of `greedy` is A_t, which is not in the product: start at greedy[1]": {"skipped": 0},
    "A_t is not in the product, so it does not matter whether it was greedy; ask the later ones only, greedy[1:]": {
        "how": "A_t too"
    },
    "the ratio has as many factors as later actions, whether they are greedy or not; with one that is not, it is 0": {
        "how": "never"
    },
    "only the last action is asked; the ratio is 0 if *any* later action is not greedy": {"how": "last alone"},
    "only the next action is asked; the ratio is 0 if *any* later action is not greedy": {"how": "next alone"},
    "one factor is missing: there are as many as later actions, len(greedy) − 1": {"how": "one less"},
    "the *number* of the action stands in the product; whether it was greedy is greedy[k]": {"how": "numbers"},
    "π is greedy: it takes the best action with probability 1 and the others with 0, not 1 − ε and ε": {
        "how": "π explores"
    },
    "two actions are left out at the start; only A_t is, so start at greedy[1]": {"skipped": 2},
    "the number of greedy actions less one is that of the later ones only if A_t was greedy too; count in greedy[1:]": {
        "how": "counted"
    },
    "the number of greedy actions less one counts A_t, and at an action that is not greedy the ratio is 0": {
        "how": "counted",
        "otherwise": "1",
    },
    "an ε of 0.1 is written in; use `epsilon`": {"written": {"epsilon": 0.1}},
    "an N of 5 is written in; use `n_actions`": {"written": {"n_actions": 5}},
    "0.92 is written in, for an ε of 0.1 and an N of 5; compute it from `epsilon` and `n_actions`": {
        "written": {"epsilon": 0.1, "n_actions": 5}
    },
    "with one action no factor is left, and an empty product is 1": {"empty": 0.0},
    "the last action is left out; the product goes to the end of the list": {"how": "without last"},
    "the last action is left out in place of the first, A_t: the later actions are greedy[1:]": {
        "how": "without last",
        "skipped": 0,
    },
    "a random action may be the best one too, so b takes it with probability 1 − ε + ε/N, not 1 − ε": {
        "likely": "1 - ε"
    },
    "a random action is one of *all* N actions, so b takes the best one with probability 1 − ε + ε/N": {
        "likely": "1 - ε + ε/(N - 1)"
    },
    "b takes the best action with probability 1 − ε + ε/N; 1 − ε/N is another number": {"likely": "1 - ε/N"},
    "the sign is wrong: b takes the best action with probability 1 − ε *+* ε/N": {"likely": "1 - ε - ε/N"},
    "b takes the best action with probability 1 − ε + ε/N; ε/N is the part of it that comes by chance": {
        "likely": "ε/N"
    },
    "ε is divided by N, not multiplied: b takes the best action with probability 1 − ε + ε/N": {
        "likely": "1 - ε + ε N"
    },
    "the greedy policy never takes another action, so its ratio there is 0/b = 0, and it is left out here": {
        "otherwise": "1"
    },
    "the greedy policy never takes another action: there π is 0, not 1": {"otherwise": "N/ε"},
    "at an action that is not greedy the ratio is 0/b = 0, not b itself": {"otherwise": "ε/N"},
    "the product stops at an action that is not greedy; there the factor is 0, and so is the whole product": {
        "otherwise": "stop"
    },
    "`any` is too weak: one later action that is not greedy is enough to make the ratio 0": {"how": "any"},
    "`any` is too weak, and False for an empty list: the ratio is 0 if one later action is not greedy, and 1 if there"
    " are none": {"how": "any", "empty": 0.0},
    "it is 0 where the actions are greedy, and not where one of them is not: True means greedy": {"how": "turned"},
    "that is one factor where all later actions are greedy; there are as many as actions": {"how": "once"},
    "it stays 0: a product starts at 1": {"how": "zero"},
    "that is b/π, upside down": {"how": "inverse"},
    "that is the probability of these actions under b; the ratio is π divided by b": {"how": "probability"},
    "`x / 1 - ε + ε/N` is (x / 1) − ε + ε/N: put what you divide by into parentheses": {"how": "precedence"},
    "the ratios of the single actions are multiplied, not added": {"how": "sum"},
    "the ratios of the single actions are multiplied; that is their mean": {"how": "mean"},
    "that is the ratio of one action alone: multiply all of them (is the `return` inside the loop?)": {"how": "last"},
    "that is the ratio of the first action alone: multiply all of them (is the `return` inside the loop?)": {
        "how": "first"
    },
    "π takes a greedy action with probability 1, but b does not: divide by the probability under b": {
        "how": "all or nothing"
    },
}


def compare_ratios(cases: Sequence[RatioCase], found: Sequence[float], most: float) -> None:
    """Refuse ratios that are not right, with the mistake that explains them all, if there is one.

    Args:
        cases: the arguments.
        found: what the answer gives for the first of them, or for all.
        most: what a greater factor counts as.

    Raises:
        WrongAnswer: one is not right.
    """
    compare_all(
        [
            NumberCase(
                f"importance_ratio({case[0]}, {case[1]:g}, {case[2]})",
                value,
                ratio(*case, most=most),
                {sentence: ratio(*case, most=most, **change) for sentence, change in MISTAKES.items()},
            )
            for case, value in zip(cases, found, strict=False)
        ]
    )
