"""The exercises of lesson 0: the return of an episode, ε-greedy, and an agent of one's own."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Annotated, Any

import numpy as np

from edugym_course.grading.agents import agent_with_table, require_class, require_function
from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES
from edugym_course.grading.choices import ChoiceCase, check_all_choices
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.one_step import Q_LEARNING
from edugym_course.grading.own_numbers import Own, step_cost
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import number
from edugym_course.lessons.loop.exact import discounted

After = Annotated[
    float,
    Own(
        tuple(range(3, 63)),
        "In your version the list of rewards is cut off before the end of the episode, and the return after the last"
        " reward is {after}, not 0.",
    ),
]
Margin = Annotated[
    float,
    Own(
        tuple(k / 20 for k in range(5, 65)),
        "In your version a value that is at most {margin} below the highest counts as the highest too.",
    ),
]
Cost = Annotated[float, step_cost("So its line in the race below lies only near that of Q-learning.")]


def exercise_1(answer: Any, seed: int, after: After = 0) -> str:
    """Check the return of a list of rewards, with what comes after the last of them."""
    require_function("discounted_return", answer, "rewards and discount")
    rng = np.random.default_rng(seed)
    cases: list[tuple[list[float], float]] = [([4.0, 2.0, 8.0], 0.25), ([3.0, 0.0, -4.0, 0.0, 2.0], 0.5)]
    for length, discount in ((4, 0.5), (6, 0.25), (3, 1.0), (5, 0.0), (1, 0.5), (14, 0.5), (500, 1.0)):
        cases.append((rng.choice([-4.0, -2.0, 1.0, 2.0, 3.0, 4.0, 8.0], length).tolist(), discount))
    compare_all(
        [
            NumberCase(
                _call(rewards, discount),
                _found(answer, rewards, discount),
                discounted(np.array([*rewards, after]), discount),
                _return_mistakes(rewards, discount),
            )
            for rewards, discount in cases
        ]
    )
    return "Right. From the last reward to the first, one multiplication a step is enough, and no power of γ is needed."


def _call(rewards: Sequence[float], discount: float) -> str:
    told = f"{rewards}" if len(rewards) < 20 else f"[{rewards[0]}, {rewards[1]}, ...] with {len(rewards)} rewards"
    return f"discounted_return({told}, {discount})"


def _found(answer: Callable[..., Any], rewards: list[float], discount: float) -> float:
    """Return what a student's function gives, a number."""
    call, passed = _call(rewards, discount), list(rewards)
    with student_code(call):
        found = answer(passed, discount)
    if passed != rewards:
        raise WrongAnswer(f"{call} changes the list of rewards that it is given: work on a copy, or only read it")
    if isinstance(found, list | np.ndarray) and len(np.shape(found)) == 1:
        raise WrongAnswer(f"{call} gives several numbers: only the return from the first step on is asked for")
    return number(call, found)


def _return_mistakes(rewards: Sequence[float], discount: float) -> dict[str, float]:
    """Return what the usual mistakes give."""

    def weighted(weights: Sequence[float]) -> float:
        return float(sum(weight * reward for weight, reward in zip(weights, rewards, strict=True)))

    n = len(rewards)
    powers = [discount**k for k in range(n)]
    total = float(sum(rewards))
    return {
        "that is the sum without a discount": total,
        "the first reward counts in full, γ^0 = 1; here everything is discounted once too often": discount
        * weighted(powers),
        "the discount goes the wrong way: the *last* reward counts in full; use reversed(rewards)": weighted(
            powers[::-1]
        ),
        "the discount goes the wrong way, and once too often: the first reward counts in full": discount
        * weighted(powers[::-1]),
        "all later rewards are discounted by the same γ; a reward k steps later counts γ^k times": weighted(
            [1.0, *[discount] * (n - 1)]
        ),
        "the whole sum is multiplied by γ once; a reward k steps later counts γ^k times": discount * total,
        "that is γ · k, and it should be γ^k: `**` is the power": weighted([discount * k for k in range(n)]),
        "the weight is k^γ or γ*k in the place of γ^k: `**` is the power, and γ stands before it": weighted(
            [float(k) ** discount if k else float(discount == 0) for k in range(n)]
        ),
        "the rewards are divided by γ^k; multiply": weighted([1 / p for p in powers]) if discount else total,
        "that is the mean": total / n,
        "the mean is taken; a return is a sum": weighted(powers) / n,
        "the sum is divided by that of the weights; a return is a sum, not a mean": weighted(powers) / sum(powers),
        "the last reward is left out": weighted([*powers[:-1], 0.0][:n]),
        "the first reward is left out": weighted([0.0, *powers[1:]][:n]),
        "the first reward is left out, and the second one counts in full": weighted([0.0, *powers][:n]),
        "that is the first reward alone": rewards[0],
        "that is the last reward alone: is `return` inside the loop?": rewards[-1],
        "that is the largest of the discounted rewards; add all of them up": max(
            weight * reward for weight, reward in zip(powers, rewards, strict=True)
        ),
        "that is the last reward with its discount; add all of them up": weighted([*[0.0] * (n - 1), *powers[-1:]]),
        "only the first two rewards count: is `return` inside the loop?": weighted([*powers[:2], *[0.0] * n][:n]),
        "1 − γ stands in the place of γ": weighted([(1 - discount) ** k for k in range(n)]),
        "it is multiplied by 1 − γ; the return is a sum, not a mean": (1 - discount) * weighted(powers),
        "the sign is wrong": -weighted(powers),
        "0.5, the discount of the cell under equation 3.9, stands where `discount` should": weighted(
            [0.5**k for k in range(n)]
        ),
        **{
            f"{written}, a discount of the lesson, stands where `discount` should": weighted(
                [written**k for k in range(n)]
            )
            for written in (0.9, 0.95, 0.99)
        },
        "is the old G added once more, by `+=`? Write `G = reward + discount * G`": weighted(
            [(1 + discount) ** k for k in range(n)]
        ),
        "γ is squared": weighted([discount ** (2 * k) for k in range(n)]),
        "the weight is squared in each step; multiply it by γ": weighted(
            [1.0, *(discount ** (2**k) for k in range(n - 1))]
        ),
        "the discount is added; multiply the return by it": total + n * discount,
        "the last reward counts twice: let `G` start at 0, or leave it out of the loop": weighted(powers)
        + discount**n * rewards[-1],
        "it begins at 1: the return after the end is 0": weighted(powers) + discount**n,
        "the result is rounded; return the number as it is": float(round(weighted(powers))),
        "what is behind the decimal point is cut off; return the number as it is": float(int(weighted(powers))),
        "it stays 0: is `G` changed in the loop?": 0.0,
    }


def exercise_2(answer: Any, seed: int, margin: Margin = 0) -> str:
    """Check ε-greedy with ties broken at random; values that are little below the highest tie with it."""
    require_function("choose", answer, "values, epsilon and rng")
    rng = np.random.default_rng(seed)
    cases: list[tuple[list[float], float]] = [
        ([1.0, 3.0, 2.0, 0.0], 0.3),
        ([1.0, 3.0, 2.0], 0.0),
        ([-1.0, -5.0, -3.0, -0.5], 0.0),
        ([-400.0, -300.0, -500.0], 0.0),
        ([2.0, 2.0003, 1.0], 0.0),  # near is not equal
        ([5.0, 0.0, -2.0], 0.0),
        ([2.0, 4.0, 4.0, 1.0], 0.0),
        ([0.0, 0.0, 0.0, 0.0], 0.0),
        ([-1.0, -2.0, -1.0], 0.0),
        ([1.0, 3.0, 2.0, 0.0], 1.0),
        ([1.0, 3.0, 3.0, 0.0], 0.4),
        ([0.0, 2.0, 1.0], 0.6),
        ([2.0, 4.0, 1.0, 3.0, 0.0, -1.0], 0.8),
        (rng.permutation([-2.0, 1.0, 5.0]).tolist(), 0.3),
        (rng.permutation([-2.0, 0.5, 0.5, -1.0, 0.25]).tolist(), 0.5),
    ]
    if margin:
        near, far = (
            round(3.0 - margin + 0.025, 3),
            round(3.0 - margin - 0.025, 3),
        )  # between two margins that may be had
        cases += [(rng.permutation([3.0, near, far, -9.0]).tolist(), epsilon) for epsilon in (0.0, 0.5)]
    check_all_choices(
        "choose(values, epsilon, rng)", [_choice(answer, numbers, epsilon, margin) for numbers, epsilon in cases]
    )
    return "Right: an action that ties is as good as the first one, so each of them gets its share."


def _choice(answer: Callable[..., Any], numbers: list[float], epsilon: float, margin: float) -> ChoiceCase:
    """Return what a student's function should choose, and what it does by the usual mistakes."""
    values = np.array(numbers)
    return ChoiceCase(
        partial(_chosen, answer, values, epsilon),
        _probabilities(values, epsilon, margin),
        _choice_mistakes(values, epsilon, margin),
        tables={"values": values},
        where=f"with values = {numbers} and epsilon = {epsilon}",
    )


def _chosen(answer: Callable[..., Any], values: Any, epsilon: float, rng: np.random.Generator) -> Any:
    return answer(values, epsilon, rng)


def _probabilities(values: Any, epsilon: float, margin: float) -> list[float]:
    """Return the probability of each action by ε-greedy."""
    best = values >= values.max() - margin
    shares: list[float] = (epsilon / len(values) + (1 - epsilon) * best / best.sum()).tolist()
    return shares


def _choice_mistakes(values: Any, epsilon: float, margin: float) -> dict[str, list[float]]:
    """Return the probabilities that the usual mistakes give."""
    n, best = len(values), values >= values.max() - margin
    actions = np.arange(n)
    uniform, greedy = np.full(n, 1 / n), best / best.sum()
    nearly = values >= values.max() - margin - 0.001
    first, last = np.eye(n)[int(values.argmax())], np.eye(n)[n - 1 - int(values[::-1].argmax())]
    worst = (values == values.min()) / (values == values.min()).sum()
    others = ~best / (~best).sum() if (~best).any() else uniform
    largest = abs(values) == abs(values).max()
    but_last, but_first, among = actions < n - 1, actions > 0, actions < best.sum()
    mixed = {
        **{
            f"the search for the highest value starts from {low}, and all values may be lower: start from the first"
            f" one{and_ties}": (np.eye(n)[0] if values.max() < low else otherwise, uniform)
            for low in (0, -1)
            for and_ties, otherwise in (("", greedy), ("; and ties should be broken at random", first))
        },
        "ties should be broken at random, and it takes the first of equals": (first, uniform),
        "values that differ are no ties: compare with ==": (nearly / nearly.sum(), uniform),
        "ties should be broken at random, and it takes the last of equals": (last, uniform),
        "it never explores: what is `epsilon` for?": (greedy, greedy),
        "it always acts at random: it should take the highest value with probability 1 − ε": (uniform, uniform),
        "it takes the *lowest* value": (worst, uniform),
        "it takes the largest value without its sign": (largest / largest.sum(), uniform),
        "where several have the highest value it takes any action; take one of *these*": (
            uniform if best.sum() > 1 else greedy,
            uniform,
        ),
        "a random action may be the best one too; this one is drawn among the others only": (greedy, others),
        "the random action is never the last one: `rng.integers(n)` is from 0 to n − 1 already": (
            greedy,
            but_last / (n - 1),
        ),
        "the random action is never action 0: `rng.integers(n)` is from 0 to n − 1 already": (
            greedy,
            but_first / (n - 1),
        ),
        "in the place of the highest value it draws in proportion to e^value: the others come by ε alone": (
            np.exp(values - values.max()) / np.exp(values - values.max()).sum(),
            uniform,
        ),
        "its random action is always action 0": (greedy, np.eye(n)[0]),
        "`rng.integers(len(best))` says *which* of the best is taken: the action is `best[...]`": (
            among / among.sum(),
            uniform,
        ),
    }
    found = {
        sentence: ((1 - epsilon) * usual + epsilon * exploring).tolist()
        for sentence, (usual, exploring) in mixed.items()
    }
    found["ε and 1 − ε have changed places: it explores with probability 1 − ε"] = (
        epsilon * greedy + (1 - epsilon) * uniform
    ).tolist()
    found["it explores with probability ε/n: a random action is drawn with probability ε, and each has ε/n then"] = (
        (1 - epsilon / n) * greedy + epsilon / n * uniform
    ).tolist()
    found[
        "it explores too often, as if it asked twice whether to: draw rng.random() once, and let `else` do the rest"
    ] = ((1 - epsilon) ** 2 * greedy + (1 - (1 - epsilon) ** 2) * uniform).tolist()
    if epsilon != 0.1:
        found["it explores with ε = 0.1, whatever `epsilon` is"] = (0.9 * greedy + 0.1 * uniform).tolist()
    return found


def exercise_3(answer: Any, seed: int, cost: Cost = 0) -> str:
    """Check the class of an agent whose `learn` is Q-learning, on rewards less a cost."""
    require_class("MyAgent", answer)
    rng = np.random.default_rng(seed)
    for shape in ((6, 3), (5, 2), (7, 4)):
        settings = {
            "learning_rate": float(rng.choice(LEARNING_RATES)),
            "discount": float(rng.choice(DISCOUNTS)),
        }
        make = partial(agent_with_table, "MyAgent", answer, shape, settings)
        Q_LEARNING.check(make, shape, settings | {"extra": -cost}, seed)
    return "Right: that is all of Q-learning. See it race:"
