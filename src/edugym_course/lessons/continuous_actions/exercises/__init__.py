"""The exercises of lesson 7: the size of a table of bins, the scores of a Gaussian, and REINFORCE with a baseline."""

import math
from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Annotated, Any

import numpy as np

from edugym.agents.gaussian_actor_critic import GaussianActorCritic
from edugym.envs.trashbot.task import Trashbot
from edugym_course.grading.agents import require_class, require_function
from edugym_course.grading.challenge import Challenge
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, step_cost
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import CARET, allowance, exact, given, number
from edugym_course.lessons.continuous_actions.exercises.episodes import check_update
from edugym_course.lessons.continuous_actions.methods import gaussian, tiles_on_the_wrist

UNUSUAL = "that is none of the usual mistakes, so work it out by hand for a small case"


Held = Annotated[
    int,
    Own(
        tuple(range(4, 64)),
        "Your arm carries one of several boxes, or none: in your version there are {held} possibilities of what it"
        " holds, not two.",
    ),
]
Scale = Annotated[
    float,
    Own(
        tuple(k / 40 for k in range(18, 66) if k not in (20, 40)),
        "Your policy has another parameter: in your version $\\ln \\sigma = {scale}\\, \\rho$, and the second number is"
        " how fast $\\ln \\pi(a)$ grows with $\\rho$. The policies below learn a little faster or more slowly by it.",
    ),
]
Cost = Annotated[float, step_cost("($R_{{t+1}} - {cost}$ stands in the returns.)")]


def exercise_1(answer: Any, seed: int, held: Held = 2) -> str:
    """Check the number of preferences of a table for an arm with several joints, and so many things to hold."""
    require_function("preferences", answer, "joints, bins and cells")
    rng = np.random.default_rng(seed)
    cases = [(3, 5, 10 + int(rng.integers(5))), (2, 3, 7), (3, 4, 6), (1, 9, 12), (4, 3, 5 + int(rng.integers(3)))]
    found = []
    for joints, bins, cells in cases:
        call, right = f"preferences({joints}, {bins}, {cells})", held * cells**joints * bins**joints
        with student_code(call):
            size = answer(joints, bins, cells)
        found.append(NumberCase(call, number(call, size), float(right), _size_mistakes(joints, bins, cells, held)))
    compare_all(found, otherwise=UNUSUAL)
    joints, bins, cells = 8, 3, 2000  # more than 64 bits, and few enough actions to list them
    call = f"preferences({joints}, {bins}, {cells})"
    with student_code(call):
        size = answer(joints, bins, cells)
    exact(call, size, held * (cells * bins) ** joints)
    many = held * (30 * 5) ** 6
    return (
        f"Right: with 6 joints, 30 cells and 5 bins that is {many:.1e}, {many / 5**6:.1e} rows of 15 625 columns. A"
        " Gaussian has 6 means in each row."
    )


def _size_mistakes(m: int, n: int, c: int, h: int) -> dict[str, float]:
    """Return what the usual mistakes give."""
    times = "doubles" if h == 2 else f"multiplies by {h}"
    return {
        f"whether the box is held {times} the number of rows": c**m * n**m,
        "that is the number of rows; each row has a column for every action": h * c**m,
        "that is the number of actions alone; how many rows are there?": n**m,
        "the bins of the joints are chosen together: n for each of m joints make n^m actions, not n m": h
        * c**m
        * n
        * m,
        "every joint has bins of its own: n^m actions, not n": h * c**m * n,
        "every joint has an angle of its own: c^m cells, not c": h * c * n**m,
        "that is right for the two coordinates of the wrist in the lesson; here every joint has an angle of its own:"
        " c^m cells, not c^2": h * c**2 * n**m,
        "that is right for two joints; m joints have c^m cells and n^m actions": h * c**2 * n**2,
        "the angles are cut together: c^m cells, not c m": h * c * m * n**m,
        "both are powers: m joints have c^m cells and n^m actions": h * c * n * m,
        "both are powers: m joints have c^m cells and n^m actions; the joints are missing": h * c * n,
        "cells and bins multiply, they do not add: every row has all columns": h * c**m + n**m,
        f"the box is held by the arm, not by each joint: the factor is {h}, not {h}^m": h**m * c**m * n**m,
        "base and exponent have changed places: n^m, not m^n": h * m**c * m**n,
        "base and exponent of the bins have changed places: n^m, not m^n": h * c**m * m**n,
        "base and exponent of the cells have changed places: c^m, not m^c": h * m**c * n**m,
        "both are powers: m joints have c^m cells and n^m actions, not c m and n m": h * (c * m) * (n * m),
        f"holding the box belongs to the state alone, not to the action: one factor of {h}": h * h * c**m * n**m,
        "those are the numbers of the lesson's table: use `joints`, `bins` and `cells`": h * 30 * 30 * 5**2,
        "one joint is missing: is a range too short, or a power too low?": h * (c * n) ** (m - 1),
        "there is one joint too many in the power of the cells": h * c ** (m + 1) * n**m,
        "the joints choose one after another, so that order counts and a bin may come twice: n^m, not a binomial": h
        * c**m
        * math.comb(n, m),
        CARET: (h * c) ^ (m * n) ^ m,
        f"{CARET}, here as well": h * (c ^ m) * (n ^ m),
        f"the {h} multiplies the rows, it is not added to them": (h + c**m) * n**m,
        f"the box is a part of the state: multiply by {h}, do not square": (c**m) ** 2 * n**m,
        f"holding has {h} values; in the lesson's wrapper one of the 3 cells is never used": (h + 1) * c**m * n**m,
    }


def exercise_2(answer: Any, seed: int, scale: Scale = 1.0) -> str:
    """Check the scores of a Gaussian policy; the second one is that of ρ, where ln σ = scale ρ."""
    require_function("my_scores", answer, "a, mu and sigma")
    rng = np.random.default_rng(seed)
    cases = [(2.0, 0.5, 0.5), (-1.0, 0.2, 2.0), (0.3, 0.4, 0.25)]
    sigma = float(rng.choice([0.75, 1.5, 1.75]))  # divided by its square a number has many digits: rounding shows
    cases.append((float(rng.integers(-12, 13)) / 4, float(rng.integers(-12, 13)) / 4 + 0.125, sigma))
    found = []
    for a, mu, sigma in cases:
        call = f"my_scores({a:g}, {mu:g}, {sigma:g})"
        with student_code(call):
            pair = answer(a, mu, sigma)
        found.append(_two(call, pair))
    spread = "ln σ" if scale == 1.0 else "ρ"
    for k, (what, formulas, factor) in enumerate((("μ", OF_MEAN, 1.0), (spread, OF_LOG_SPREAD, scale))):
        right, mistakes = formulas[""], {why: rule for why, rule in formulas.items() if why}
        for case, pair in zip(cases, found, strict=True):
            expected = factor * right(*case)
            if abs(pair[k] - expected) <= allowance(expected):
                continue
            fits = [why for why, rule in mistakes.items() if _fits(rule, factor, cases, [p[k] for p in found])]
            a, mu, sigma = case
            rounded = any(round(expected, places) == pair[k] for places in range(1, 7))
            why = "do not round it" if rounded else [*fits, "derive it again from ln π(a), term by term"][0]
            raise WrongAnswer(
                f"my_scores({a:g}, {mu:g}, {sigma:g}) should give {expected:.4g} for {what}, but gives"
                f" {pair[k]:.4g}: {why}"
            )
    _check_arrays(answer, scale)
    return "Right: the mean of both scores is 0, so a baseline changes nothing on average. See your policies learn:"


def _check_arrays(answer: Any, scale: float) -> None:
    """Check the scores of three actions at once."""
    several = {
        "a": np.array([0.0, 1.0, -2.0]),
        "mu": np.array([0.5, 0.5, 0.5]),
        "sigma": np.array([1.0, 1.0, 2.0]),
    }
    mine = {name: values.copy() for name, values in several.items()}
    call = "my_scores(a, mu, sigma) with three actions at once"
    with student_code(call):
        pair = answer(*mine.values())
    _require_pair(call, pair)
    for name, values in several.items():
        if not np.array_equal(mine[name], values):
            raise WrongAnswer(
                f"my_scores changes the array `{name}` that it is given: `-=` and the like write into an array, so"
                " give what you compute a name of its own"
            )
    for part, formulas, factor in zip(pair, (OF_MEAN, OF_LOG_SPREAD), (1.0, scale), strict=True):
        expected = factor * formulas[""](*several.values())
        if np.shape(part) != (3,) or not np.allclose(np.asarray(part, float), expected):
            raise WrongAnswer(
                "my_scores with three actions at once should give three numbers for each score: use + - * / **,"
                " and no sum or mean"
            )


E_OF_SIGMA = "`sigma` is σ itself and not ln σ, so no power of e is needed"
OF_MEAN: Mapping[str, Any] = MappingProxyType(
    {
        "": lambda a, m, s: (a - m) / s**2,
        "divide by σ², not by σ": lambda a, m, s: (a - m) / s,
        "the derivative of (a − μ)² / (2σ²) brings 1/σ² with it; the division is missing": lambda a, m, s: a - m,
        "the sign is wrong: an action above the mean gets likelier if the mean grows": lambda a, m, s: (m - a) / s**2,
        "the 2 of the square and the 2 in 2σ² cancel": lambda a, m, s: (a - m) / (2 * s**2),
        "the 2 of the square and the 2 in 2σ² cancel; here the 2 is too many": lambda a, m, s: 2 * (a - m) / s**2,
        "that is σ² in the numerator; divide by it": lambda a, m, s: (a - m) * s**2,
        "that is ln π (but for a constant), not its derivative": lambda a, m, s: (
            -((a - m) ** 2) / (2 * s**2) - np.log(s)
        ),
        "that is the first term of ln π(a), and not its derivative": lambda a, m, s: -((a - m) ** 2) / (2 * s**2),
        E_OF_SIGMA: lambda a, m, s: (a - m) / np.exp(2 * s),
        "the derivative of a square is not a square": lambda a, m, s: (a - m) ** 2 / s**2,
        "the derivative of the square root is taken: divide by σ², once": lambda a, m, s: (a - m) / s**3,
        "that is the score of ln σ; the score of μ comes first": lambda a, m, s: (a - m) ** 2 / s**2 - 1,
        "that is the derivative of π, not of ln π": lambda a, m, s: (
            (a - m) / s**2 * np.exp(-((a - m) ** 2) / (2 * s**2)) / (s * np.sqrt(2 * np.pi))
        ),
        "set brackets: a − μ is divided as a whole": lambda a, m, s: a - m / s**2,
        "the sign of a − μ counts, so take no absolute value": lambda a, m, s: abs(a - m) / s**2,
        "σ * 2 is twice σ; its square is σ**2": lambda a, m, s: (a - m) / s * 2,
        "`//` cuts off what is behind the decimal point; divide by `/`": lambda a, m, s: (a - m) // s**2,
    }
)
"""The score of the mean, and by the sentence that tells of it, what the usual mistakes give."""
OF_LOG_SPREAD: Mapping[str, Any] = MappingProxyType(
    {
        "": lambda a, m, s: (a - m) ** 2 / s**2 - 1,
        "that is the derivative with respect to σ; for ln σ multiply it by σ": lambda a, m, s: (
            (a - m) ** 2 / s**3 - 1 / s
        ),
        "that is the derivative with respect to σ²; for ln σ multiply it by 2σ²": lambda a, m, s: (
            (a - m) ** 2 / (2 * s**4) - 1 / (2 * s**2)
        ),
        "the term − ln σ is forgotten; its derivative with respect to ln σ is −1": lambda a, m, s: (a - m) ** 2 / s**2,
        "the sign is wrong: σ should grow for actions that are far out": lambda a, m, s: 1 - (a - m) ** 2 / s**2,
        "the derivative of − ln σ is −1, not +1": lambda a, m, s: (a - m) ** 2 / s**2 + 1,
        "the derivative of − ln σ with respect to ln σ is −1, not −1/σ": lambda a, m, s: (a - m) ** 2 / s**2 - 1 / s,
        "the derivative of − ln σ with respect to ln σ is −1, not −σ": lambda a, m, s: (a - m) ** 2 / s**2 - s,
        "the derivative of − ln σ with respect to ln σ is −1, not −ln σ": lambda a, m, s: (
            (a - m) ** 2 / s**2 - np.log(s)
        ),
        "that is the derivative with respect to ln σ²; with respect to ln σ it is twice as large": lambda a, m, s: (
            ((a - m) ** 2 / s**2 - 1) / 2
        ),
        "the exponent −2 of σ and the 2 in 2σ² cancel; here the 2 is too many": lambda a, m, s: (
            2 * (a - m) ** 2 / s**2 - 1
        ),
        "the derivative with respect to σ is divided by σ; multiply it by σ": lambda a, m, s: (
            (a - m) ** 2 / s**4 - 1 / s**2
        ),
        "the derivative with respect to σ is multiplied by σ²; multiply it by σ": lambda a, m, s: (a - m) ** 2 / s - s,
        "the minus before (a − μ)² / (2σ²) and that of the exponent −2 make a plus": lambda a, m, s: (
            -((a - m) ** 2) / s**2 - 1
        ),
        "σ is divided by once too little: (a − μ)² is divided by σ²": lambda a, m, s: (a - m) ** 2 / s - 1,
        "the exponent −2 of σ gives a factor of 2, which cancels the 2 in 2σ²": lambda a, m, s: (
            (a - m) ** 2 / (2 * s**2) - 1
        ),
        "(a − μ)² is divided by σ², not by σ⁴": lambda a, m, s: (a - m) ** 2 / s**4 - 1,
        E_OF_SIGMA: lambda a, m, s: (a - m) ** 2 / np.exp(2 * s) - 1,
        "that is the second term of ln π(a), and not its derivative": lambda a, m, s: -np.log(s),
        "a − μ should be squared": lambda a, m, s: (a - m) / s**2 - 1,
        "σ² in the numerator should be σ² below": lambda a, m, s: (a - m) ** 2 * s**2 - 1,
        "that is the score of μ; the score of ln σ comes second": lambda a, m, s: (a - m) / s**2,
        "it is (a − μ)² − σ² that is divided by σ²: set brackets": lambda a, m, s: (a - m) ** 2 - 1,
        "σ * 2 is twice σ, and (a − μ) * 2 twice a − μ; squares are written **2": lambda a, m, s: (
            (a - m) ** 2 / s * 2 - 1
        ),
        "(a − μ) * 2 is twice a − μ; its square is (a − μ)**2": lambda a, m, s: (a - m) * 2 / s**2 - 1,
        "divided by σ³ it is the derivative with respect to σ; and there −1/σ belongs to it": lambda a, m, s: (
            (a - m) ** 2 / s**3 - 1
        ),
    }
)
"""The score of ln σ likewise."""


def _fits(rule: Any, factor: float, cases: list[Any], found: list[float]) -> bool:
    """Whether a factor times a rule gives what was found in every case."""
    return all(np.isclose(factor * rule(*case), value, rtol=1e-9) for case, value in zip(cases, found, strict=True))


def _two(call: str, pair: Any) -> tuple[float, float]:
    """Return the two numbers of an answer."""
    _require_pair(call, pair)
    return number(f"the first of {call}", pair[0]), number(f"the second of {call}", pair[1])


def _require_pair(call: str, pair: Any) -> None:
    """Refuse what is no pair of scores."""
    given(call, pair)
    if not isinstance(pair, tuple | list | np.ndarray) or len(pair) != 2:
        raise WrongAnswer(
            f"{call} should give two numbers, one for μ and one for ln σ, but gives {pair!r}: end with"
            " `return of_mu, of_log_sigma`"
        )


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the class of REINFORCE with a baseline, whose returns have the rewards less a cost."""
    require_class("MyREINFORCE", answer)
    check_update(answer, seed, cost)
    return "Right: returns minus a baseline, times the score. See it race:"


def own_container(layout_seed: int) -> Trashbot:
    """Return Trashbot with continuous actions, and a container whose width belongs to a seed."""
    return Trashbot.create(container_width=0.4 + 0.2 * float(np.random.default_rng(layout_seed).random()))


CHALLENGE = Challenge(
    environment=own_container,
    parameters=MappingProxyType({}),
    n_steps=50_000,
    baselines=MappingProxyType(
        {
            "the lesson's agent": gaussian,
            "the lesson's agent, first values 0": lambda task: GaussianActorCritic.create(
                task, features=tiles_on_the_wrist(task), learning_rate=0.02, value_learning_rate=0.4
            ),
            "the lesson's agent, σ = 0.2": partial(gaussian, spread=0.2),
        }
    ),
    optimum=5.0,
    best_average=5.0,
)
"""The open challenge: the highest average return over 50 000 steps, with real numbers and a container of one's own."""
