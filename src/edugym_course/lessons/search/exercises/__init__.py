"""The exercises of lesson 18: an upper bound, backing up a simulation, and looking ahead exactly."""

from collections.abc import Callable, Mapping
from copy import deepcopy
from functools import partial
from math import inf, log
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Integers, Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import DISCOUNTS, telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables
from edugym_course.grading.values import given, number, require_unchanged
from edugym_course.lessons.search.exercises.looks import LOOK_MISTAKES, looked_ahead, telling_looks

Power = Annotated[
    float,
    Own(
        tuple(k / 100 for k in (*range(20, 46), *range(55, 81))),
        "In your version the power {power} takes the place of the root: c (ln N(node) / N(node, a)) ** {power}.",
    ),
]
Cost = Annotated[float, step_cost()]
Discount = Annotated[
    float, Own(tuple(k / 100 for k in (*range(40, 70), *range(71, 89))), "In your version γ is {discount}, not 0.9.")
]


class Bound(NamedTuple):
    """An action in a node, for exercise 1."""

    q: float
    n_action: int
    n_node: int
    c: float


def bounded(
    case: Bound,
    *,
    inside: str = "log over count",
    part: str = "sum",
    times: str = "c",
    n: str = "right",
    power: float = 0.5,
) -> float:
    """Return the upper bound of an action that was tried; other arguments than the defaults are mistakes."""
    q, n_action, n_node, c = case
    if times == "at Q":
        q *= c
    count = {"right": n_action, "one more": n_action + 1}[n]
    ratio = {
        "log over count": log(n_node) / count,
        "no log": n_node / count,
        "log of both": log(n_node / count) if n_node > count else 0.0,
        "log of the root": n_node / count,
        "swapped": log(count) / n_node,
        "no count": log(n_node),
        "root of the log alone": log(n_node) / count ** (1 / power),
        "root of the count alone": log(n_node) ** (1 / power) / count,
        "log of base 10": log(n_node, 10) / count,
        "log of base 2": log(n_node, 2) / count,
        "log of one more": log(n_node + 1) / count,
        "twice the log": 2 * log(n_node) / count,
        "AlphaZero": n_node / (n_action + 1) ** (1 / power),
    }[inside]
    bonus = log(ratio**power) if inside == "log of the root" else ratio if times == "no root" else ratio**power
    bonus *= {"c": c, "none": 1.0, "inside": c**power, "at Q": 1.0}.get(times, c)
    return float({"sum": q + bonus, "difference": q - bonus, "bonus": bonus, "divided": q / count + bonus}[part])


BOUND_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the logarithm is missing": {"inside": "no log"},
    "that is the logarithm of the ratio; only N(node) has one": {"inside": "log of both"},
    "the two numbers are exchanged: the *action* was tried seldom, so its N stands below the line": {
        "inside": "swapped"
    },
    "N(node, a) is missing: then all actions get the same bonus": {"inside": "no count"},
    "only the logarithm is under the root; N(node, a) belongs there, too": {"inside": "root of the log alone"},
    "only N(node, a) is under the root; the logarithm belongs there, too": {"inside": "root of the count alone"},
    "that is the bonus of AlphaZero, √N(node) / (1 + N(node, a)); here it has a logarithm": {"inside": "AlphaZero"},
    "the square root is missing": {"times": "no root"},
    "c is missing": {"times": "none"},
    "that is the logarithm of a root; it is the root of a logarithm": {"inside": "log of the root"},
    "c is multiplied with Q(node, a); it belongs to the root": {"times": "at Q"},
    "c stands under the root; it is outside": {"times": "inside"},
    "the bonus is subtracted: that is a *lower* bound": {"part": "difference"},
    "Q(node, a) is missing: then the search looks for what is seldom, not for what is good": {"part": "bonus"},
    "1 is added to N(node, a): that makes an action that was never tried look like any other": {"n": "one more"},
    "ln is the natural logarithm, not that of base 10": {"inside": "log of base 10"},
    "ln is the natural logarithm, not that of base 2": {"inside": "log of base 2"},
    "1 is added to N(node), which counts all choices already": {"inside": "log of one more"},
    "some books have a 2 before the logarithm; here c takes its place": {"inside": "twice the log"},
    "Q(node, a) is a mean already: it is divided by N(node, a) once more": {"part": "divided"},
}
TRIED = "this action was tried; only one that was never tried has an infinite bound"
UNTRIED = "an action that was never tried comes first, so its bound is infinite: float('inf')"


def _bounds(rng: np.random.Generator) -> list[Bound]:
    """Make up actions: tried often, seldom, and once."""
    numbers = ((1, 9), (4, 30), (17, 40), (2, 700), (50, 51))
    return [
        Bound(float(rng.integers(-8, 9)), tried, total + int(rng.integers(5)), float(rng.integers(3, 9)))
        for tried, total in numbers
    ]


def exercise_1(answer: Any, seed: int, power: Power = 0.5) -> str:
    """Check the upper bound of an action."""
    require_function("upper_bound", answer, "q, n_action, n_node and c")
    right = partial(bounded, power=power)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in BOUND_MISTAKES.values())]
    cases = []
    for case in _bounds(telling_draw(seed, _bounds, rules)):
        call = f"upper_bound({case.q:g}, {case.n_action}, {case.n_node}, {case.c:g})"
        with student_code(call):
            found = answer(*case)
        if isinstance(found, float) and found == inf:
            raise WrongAnswer(f"{call} should be finite, but is infinite: {TRIED}")
        mistakes = {why: right(case, **change) for why, change in BOUND_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases)
    for n_node, c in ((7, 2.0), (7, 0.0), (0, 2.0)):
        call = f"upper_bound({-3 - seed % 3}, 0, {n_node}, {c:g})"
        try:
            with student_code(call):
                found = answer(-3.0 - seed % 3, 0, n_node, c)
        except WrongAnswer as wrong:
            raise WrongAnswer(f"{call} should be infinite, but {wrong}") from None
        given(call, found)
        if found != inf:
            raise WrongAnswer(
                f"{call} should be infinite, but is {repr(found) if isinstance(found, str) else found}: {UNTRIED}"
            )
    return "Right: who was tried seldom gets the benefit of the doubt."


class Simulation(NamedTuple):
    """A simulation for exercise 2, and the tables before it."""

    values: Reals
    counts: Integers
    path: list[tuple[int, int]]
    rewards: list[float]
    G: float
    discount: float


def backed_up(
    case: Simulation,
    *,
    order: str = "last first",
    gamma: str = "right",
    start: str = "roll-out",
    reward: str = "all",
    moved: str = "at once",
    step: str = "mean",
    count: str = "before",
    which: str = "all",
    cost: float = 0.0,
) -> Reals:
    """Return values and counts after a simulation, shape (2, nodes, A); other arguments are mistakes."""
    values, counts = case.values.copy(), case.counts.astype(float)
    discount = 1.0 if gamma == "one" else case.discount
    G = {"nothing": 0.0, "discounted": discount * case.G, "whole": case.G / discount}.get(start, case.G)
    pairs, earned_on = (case.path[:-1], case.rewards[:-1]) if which == "but the last" else (case.path, case.rewards)
    entries = pairs if order in ("first first", "rewards alone") else pairs[::-1]
    rewards = earned_on if order in ("first first", "path alone") else earned_on[::-1]
    if reward == "root":
        for own in rewards:
            G = own - cost + discount * G
    for place, (entry, own) in enumerate(zip(entries, rewards, strict=True)):
        earned, target = own - cost, G
        if reward == "all":
            follows = case.G if start == "each" else G
            of_reward, of_future = {"all": (discount, discount), "reward": (discount, 1.0)}.get(gamma, (1.0, discount))
            G = of_reward * earned + of_future * follows
        elif reward == "last" and place == 0:
            G = earned + discount * G
        if moved != "late":
            target = G
        at_root = place == len(rewards) - 1
        if {"root": not at_root, "below the root": at_root, "last": place > 0}.get(which, False):
            continue
        where = entry[0] if which == "row" else entry
        more = {"before": 1, "kept": 1, "after": 0, "two more": 2}.get(count, 1)
        n = np.maximum((counts[entry[0]].sum() if count == "node" else counts[where]) + more, 1)
        error = target - values[where]
        change = {
            "mean": error / n,
            "whole": error,
            "sum": target,
            "only": target / n,
            "best": np.maximum(error, 0.0),
            "half": error / 2,
            "away": -error / n,
        }
        values[where] += change[step]
        counts[entry[0] if count == "row" else where] += 0 if count == "kept" else 1
        if moved == "highest":
            G = float(values[entry[0]].max())
        elif moved == "mean":
            G = float(values[entry])
    return np.stack([values, counts])


BACK_UP_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the rewards are gone through from the first to the last; the *last* one comes first, for what follows it is known"
    " by then": {"order": "first first"},
    "the discount is left out": {"gamma": "one"},
    "every node gets the same return: on the way up each reward is added to what followed it": {"reward": "last"},
    "every node gets the return of the roll-out as it is; on the way up the rewards are added": {"reward": "none"},
    "behind each reward follows the return of the roll-out; what follows is the G of the step after": {"start": "each"},
    "γ stands before the return of the roll-out once too often": {"start": "discounted"},
    "γ is missing before the return of the roll-out": {"start": "whole"},
    "the return of the roll-out is left out; G begins with it": {"start": "nothing"},
    "a value becomes the latest return; it is the *mean* of all": {"step": "whole"},
    "a value becomes the highest return; it is the *mean* of all": {"step": "best"},
    "a value becomes the sum of the returns; it is their mean": {"step": "sum"},
    "− Q(node, A) is left out: the return takes the place of the error": {"step": "only"},
    "the error is divided by the number before this simulation: first count, then divide": {"count": "after"},
    "the error is divided by one too many: this simulation counts once": {"count": "two more"},
    "the simulation is not counted: N(node, A) goes up by 1": {"count": "kept"},
    "only the root learns; every node on the path does": {"which": "root"},
    "only the last node on the path learns: does a `return` stand inside the loop?": {"which": "last"},
    "the last step of the path is left out: does the loop begin at len(path) - 1?": {"which": "but the last"},
    "the root does not learn; every node on the path does": {"which": "below the root"},
    "only `path` is gone through from its end; `rewards` goes with it": {"order": "path alone"},
    "only `rewards` is gone through from its end; `path` goes with it": {"order": "rewards alone"},
    "the value moves before G has this step's reward: first G, then the value": {"moved": "late"},
    "the reward is discounted, too; γ only stands before what follows": {"gamma": "all"},
    "every node gets the return from the root on; each learns from what followed after *it*": {"reward": "root"},
    "the error is divided by all choices in the node; N(node, A) counts this action alone": {"count": "node"},
    "all actions of a node are counted; only the one that was taken is": {"count": "row"},
    "γ stands before the reward; it stands before what follows": {"gamma": "reward"},
    "a value becomes the mean of the old value and the return; the old value stands for all returns before": {
        "step": "half"
    },
    "the value moves away from the return: is it G − Q(node, A), with this sign?": {"step": "away"},
    "all actions of a node change; only the one that was taken does": {"which": "row"},
    "the highest value of a node is passed on; it is the return of this simulation": {"moved": "highest"},
    "the new value of a node is passed on; it is the return of this simulation": {"moved": "mean"},
}


def _simulations(rng: np.random.Generator) -> list[Simulation]:
    """Make up simulations: of one step, of several, and some through nodes that are new."""
    made = []
    for length in (1, 2, 3, 3):
        counts = rng.integers(1, 6, (4, 2))
        counts[-1] = 0
        values = np.where(counts > 0, rng.integers(-6, 7, (4, 2)), 0).astype(float)
        nodes = [0, *rng.permutation(np.arange(1, 4))[: length - 1].tolist()]
        path = [(int(node), int(rng.integers(2))) for node in nodes]
        rewards = rng.integers(-5, 10, length).astype(float).tolist()
        made.append(Simulation(values, counts, path, rewards, float(rng.integers(2, 9)), float(rng.choice(DISCOUNTS))))
    return made


def exercise_2(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check what a simulation changes in the tree."""
    require_function("back_up", answer, "values, counts, path, rewards, G and discount")
    right = partial(backed_up, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in BACK_UP_MISTAKES.values())]
    cases = _simulations(telling_draw(seed, _simulations, rules))
    found, calls = [], []
    for case in cases:
        values, counts, *others = case
        call = f"back_up({values.tolist()}, {counts.tolist()}, {', '.join(map(str, others))})"
        mine = values.copy(), counts.copy()
        with student_code(call):
            answer(*mine, path := [*case.path], rewards := [*case.rewards], *case[4:])
        require_unchanged(call, "path", path, case.path)
        require_unchanged(call, "rewards", rewards, case.rewards)
        found.append(np.stack(mine).astype(float))
        calls.append(f"{call}{told_less(cost)}")
    if all(np.array_equal(mine, np.stack(case[:2])) for case, mine in zip(cases, found, strict=True)):
        raise WrongAnswer(
            f"{calls[0]} changes nothing: change entries in place, as in values[node, action] += ..., and return"
            " nothing"
        )
    compare_tables(cases, found, calls, BACK_UP_MISTAKES, right)
    return "Right: one pass backwards, and every node on the path has learned."


def exercise_3(answer: Any, seed: int, discount: Discount = 0.9) -> str:
    """Check looking ahead exactly."""
    require_function("look_ahead", answer, "model, state and depth")
    right = partial(looked_ahead, discount=discount)
    cases = list[NumberCase]()
    for case in deepcopy(telling_looks(seed, discount)):  # an answer may write into the model
        if case.depth == 0:  # the last one, at which an answer that stops too early may call itself for ever
            compare_all(cases)
        call = f"look_ahead({case.model}, {case.state}, {case.depth})"
        with student_code(call):
            found = answer(*case)
        mistakes = {why: right(case, **change) for why, change in LOOK_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases)
    return "Right: exact, and with b actions and k outcomes recursion takes work that grows as (bk)^d."
