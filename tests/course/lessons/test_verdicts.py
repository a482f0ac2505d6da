"""What cells of lessons call an outcome: every option can be the measured one, and is so where it should."""

import ast
from functools import cache
from types import SimpleNamespace
from typing import Any

import build
import numpy as np
import pandas as pd
import pytest
from rules import is_code, without_marks

from edugym_course.lessons.signal import methods
from tests.course.lessons.transcripts import NOTEBOOKS

BEST, CHANCE = methods.OPTIMUM, methods.RANDOM_PLAY
RUNS = SimpleNamespace(turns=lambda run: run[0], returns_to=lambda run: run[1], higher_frontier=lambda run: 0)


def words(early: float, late: float) -> pd.Series:
    """A learning curve over two moments."""
    return pd.Series({20_000: early, 200_000: late})


VERDICTS: dict[tuple[str, str], list[tuple[dict[str, Any], Any]]] = {
    ("loop", "next_reward"): [({"earned": 48}, 0), ({"earned": 47}, 1), ({"earned": 0}, 1), ({"earned": -1}, 2)],
    ("exploration", "middle"): [
        ({"solvers": []}, "none"), ({"solvers": [1]}, "Go-Explore"), ({"solvers": [1, 2, 3]}, "all three"),
    ],
    ("exploration", "far_sighted"): [
        ({"difference": 0.11}, "more often"), ({"difference": -0.11}, "less often"), ({"difference": 0.09}, "as often"),
    ],
    ("exploration", "three_grips"): [
        ({"solvers": []}, "neither"), ({"solvers": ["optimism"]}, "optimism only"), ({"solvers": ["a", "b"]}, "both"),
    ],
    ("exploration", "two_branches"): [
        ({"runs": runs, "fork": RUNS}, answer)
        for runs, answer in [
            ([(1, True), (0, True)], "stays with one branch"),
            ([(1, True), (1, True), (1, False)], "turns to the other branch and comes back"),
            ([(1, True), (1, False)], "turns to the other branch for good"),
        ]
    ],
    ("on_off_policy", "on_ice"): [
        ({"steps": [4, 4, 5]}, "the fast run, as before"), ({"steps": [4, 5, 5]}, "the safe run"),
        ({"steps": [4, 5]}, "neither, in most runs"),
    ],
    ("on_off_policy", "edge_walkers"): [
        ({"walkers": []}, "none"), ({"walkers": ["Q-learning"]}, "Q-learning only"),
        ({"walkers": ["SARSA", "expected SARSA"]}, "SARSA and expected SARSA"),
        ({"walkers": ["Q-learning", "SARSA", "expected SARSA"]}, "all three"),
    ],
    ("on_off_policy", "rarely"): [
        ({"lead": 0.09}, "both earn the same, up to 0.1"), ({"lead": 0.11}, "SARSA earns more than Q-learning"),
        ({"lead": -0.11}, "Q-learning earns more than SARSA"),
    ],
    ("depth", "ahead"): [
        ({"early": True, "late": True}, "Monte Carlo is ahead early and late"),
        ({"early": True, "late": False}, "Monte Carlo is ahead early, n = 1 late"),
        ({"early": False, "late": True}, "n = 1 is ahead early, Monte Carlo late"),
        ({"early": False, "late": False}, "n = 1 is ahead early and late"),
    ],
    ("depth", "noisy"): [
        ({"change": 0.29}, "the same, within 0.3"), ({"change": 0.31}, "better"), ({"change": -0.31}, "worse"),
    ],
    ("depth", "cards"): [
        ({"lead": -0.04}, "no difference above 0.05"), ({"lead": 0.06}, "Monte Carlo is ahead"),
        ({"lead": -0.06}, "n = 1 is ahead"),
    ],
    ("dimensionality", "slower"): [
        ({"curves": [np.ones(2), np.ones(2)]}, 2), ({"curves": [np.ones(2), np.array([1.0, 2.0])]}, 1),
    ],
    ("dimensionality", "sees"): [
        ({"late": {k: {"it": x} for k, x in enumerate(means)}, "methods": SimpleNamespace(PIXELS="it")}, answer)
        for means, answer in [((1, 0.5, 0.5, 0.5), 0), ((1, 0.5, 0.51, 0.5), 1), ((1, 0.51, 0.51, 0.51), 3)]
    ],
    ("dimensionality", "cnns"): [
        ({"small": small, "column": column}, k)
        for k, (small, column) in enumerate([(0.81, 0.81), (0.81, 0.8), (0.8, 0.81), (0.8, 0.8)])
    ],
    ("dimensionality", "more"): [({"ratio": 2.0}, 0), ({"ratio": 2.1}, 1), ({"ratio": 10.0}, 1), ({"ratio": 11.0}, 2)],
    ("dimensionality", "hill"): [
        ({"straight": a, "tiled": b}, k) for k, (a, b) in enumerate([(1, 1), (0, 1), (1, 0), (0, 0)])
    ],
    ("memory", "helps"): [({"gain": 0.5}, 0), ({"gain": 0.6}, 1), ({"gain": -0.6}, 2)],
    ("memory", "early"): [
        ({"difference": 0.3}, "as much as k = 3, up to 0.3"), ({"difference": 0.4}, "more than k = 3"),
        ({"difference": -0.4}, "less than k = 3"),
    ],
    ("memory", "far"): [
        ({"reached": 12.9}, "below 13"), ({"reached": 17.0}, "15, give or take 2"), ({"reached": 17.1}, "above 17"),
    ],
    ("memory", "learned"): [
        ({"ends": np.full(2, end), "below": 12.0, "above": 18.0}, k) for k, end in enumerate((11.0, 15.0, 19.0))
    ],
    ("memory", "blind"): [
        ({"solved": []}, "no number is enough"), ({"solved": ["k = 6", "k = 2 with actions"]}, "none"),
        ({"solved": ["k = 2 with actions"]}, "1"), ({"solved": ["k = 3 with actions"]}, "2"),
        ({"solved": ["k = 4 with actions"]}, "3"),
    ],
    ("signal", "lake"): [
        ({"better": []}, "on neither"), ({"better": ["firm ice"]}, "on firm ice only"),
        ({"better": ["firm ice", "slippery ice"]}, "on both"),
    ],
    ("signal", "longer"): [
        ({"gain": 99.0}, "the same return, up to 100"), ({"gain": 101.0}, "a higher return"),
        ({"gain": -101.0}, "a lower return"),
    ],
    ("signal", "ambiguous"): [
        ({"mean": 0.91 * BEST}, "more than 90 % of the optimum"), ({"mean": 0.5 * BEST}, "about half of it"),
        ({"mean": CHANCE}, "no more than random actions"),
    ],
    ("signal", "synonyms"): [
        ({"curve": words(0.91, 1.0)}, "learns as fast"),
        ({"curve": words(0.89, 1.0)}, "learns more slowly, and reaches the optimum"),
        ({"curve": words(0.91, 0.98)}, "ends well below the optimum"),
    ],
    ("signal", "moods"): [
        ({"returns": {"in turn": 400.0, "obey": 0.0}}, "memory gets more"),
        ({"returns": {"in turn": 0.0, "obey": 400.0}}, "the noisy word gets more"),
        ({"returns": {"in turn": 0.0, "obey": 290.0}}, "both get about the same"),
    ],
    ("continuous_actions", "finer"): [
        ({"gap": 0.004}, "the same, up to 0.005"), ({"gap": 0.1}, "5 bins"), ({"gap": -0.1}, "4 bins"),
    ],
    ("continuous_actions", "noise"): [
        ({"ratios": [1, 0.09]}, "less than a tenth"), ({"ratios": [0, 0.7]}, "half as large"),
        ({"ratios": [0, 0.8]}, "the same"),
    ],
    ("continuous_actions", "slower"): [
        ({"difference": SimpleNamespace(low=low, high=low + 2)}, k) for k, low in enumerate((1, -3, -1))
    ],
    ("continuous_actions", "narrow"): [
        ({"loss": {"3 bins": 1.0, "continuous": 0.7}}, "3 bins"),
        ({"loss": {"3 bins": 1.0, "continuous": 1.3}}, "continuous"),
        ({"loss": {"3 bins": 1.0, "continuous": 1.1}}, "neither, up to 0.2"),
    ],
    ("continuous_actions", "rich"): [
        ({"share": 0.09}, "fewer than 10"), ({"share": 0.9}, "10 to 90"), ({"share": 0.91}, "more than 90"),
    ],
    ("stochasticity", "highest"): [
        ({"means": {"averse": averse, "neutral": 0.5, "seeking": seeking}}, answer)
        for averse, seeking, answer in [
            (0.6, 0.5, "the averse player"), (0.0, 0.519, "neutral and seeking are level, within 0.02"),
            (0.0, 0.521, "the seeking player"), (0.0, 0.479, "the neutral player"),
        ]
    ],
    ("stochasticity", "obstacle"): [
        ({"too_low": too_low, "unseen": unseen}, answer)
        for too_low, unseen, answer in [
            (0.06, 0.04, "it believes that a drive is worth less than it is"),
            (0.04, 0.0, "it sees the cell of the ball only, not the exact place"),
            (0.06, 0.06, "it sees the cell of the ball only, not the exact place"),
        ]
    ],
    ("stochasticity", "pays"): [
        ({"gain": 0.009}, "the same, within 0.01"), ({"gain": 0.02}, "more than the neutral one"),
        ({"gain": -0.02}, "less than the neutral one"),
    ],
    ("stochasticity", "lotteries"): [
        ({"difference": 0.01}, "both equally, within 0.02"), ({"difference": 0.03}, "the rare win higher"),
        ({"difference": -0.03}, "the rare loss higher"),
    ],
    ("stochasticity", "rate"): [
        ({"late": {"α = 1": 0.1}, "others": [0.0, 0.0]}, "hardly ever arrives"),
        ({"late": {"α = 1": 0.5}, "others": [0.4, 0.3]}, "is the best again"),
        ({"late": {"α = 1": 0.5}, "others": [0.3, 0.6]}, "is as good as the smaller rates"),
    ],
    ("model_based", "spread"): [
        ({"knows": ()}, "neither"), ({"knows": ("Dyna",)}, "Dyna"),
        ({"knows": ("Dyna", "prioritised sweeping")}, "both"),
    ],
    ("model_based", "saved"): [
        ({"SLOW_DYNA": "slow", "wrong": SimpleNamespace(methods=found, final=found.get)}, k)
        for k, found in enumerate({"slow": [slow], "Dyna-10": [fast]} for fast in (50, 51) for slow in (50, 51))
    ],
    ("own_problem", "mild"): [({"change": -1}, "stalls at once"), ({"change": 1}, "runs as before")],
    ("own_problem", "progress"): [
        ({"wakings": 1.6, "earlier": True}, 2), ({"wakings": 1.5, "earlier": True}, 1),
        ({"wakings": 1.0, "earlier": False}, 0),
    ],
    ("own_problem", "helps"): [
        ({"lead": 0.6}, "with the potential"), ({"lead": -0.6}, "without any shaping"), ({"lead": 0.4}, "neither"),
    ],
}  # fmt: skip
"""By lesson and prediction: what its cell has found, and what is then the answer, or the number of the answer."""


@cache
def cells(lesson: str) -> list[list[ast.stmt]]:
    """Return the statements of each cell with code."""
    codes = [cell.source for cell in build.read_lesson(NOTEBOOKS[lesson]).cells if is_code(cell)]
    return [body for code in codes if (body := ast.parse(without_marks(code)).body)]


def names_in(part: ast.stmt, context: type) -> set[str]:
    """Return the names that a statement assigns (`ast.Store`) or uses (`ast.Load`)."""
    return {node.id for node in ast.walk(part) if isinstance(node, ast.Name) and isinstance(node.ctx, context)}


def deciding(body: list[ast.stmt], found: set[str]) -> list[ast.stmt]:
    """Return the last statement of a cell, and those before it that it needs where some names are given."""
    needed, kept = names_in(body[-1], ast.Load), [body[-1]]
    for part in reversed(body[:-1]):
        assigned = names_in(part, ast.Store)
        if assigned & needed and not assigned & found:
            needed |= names_in(part, ast.Load)
            kept.insert(0, part)
    return kept


@pytest.mark.parametrize(("lesson", "name"), VERDICTS)
def test_what_an_outcome_is_called(lesson: str, name: str) -> None:
    """The last lines of the cell decide on numbers at both sides of each border."""
    bodies = {ast.unparse(body[-1]).partition("(")[0]: body for body in cells(lesson)}
    (asked,) = (
        part.value for body in cells(lesson) for part in body
        if isinstance(part, ast.Assign) and ast.unparse(part).startswith(f"{name} = predict(")
    )  # fmt: skip
    listed = next(node for node in ast.walk(asked) if isinstance(node, ast.List))
    options = ast.literal_eval(listed)
    for found, answer in VERDICTS[lesson, name]:
        said: list[Any] = []
        prediction = SimpleNamespace(options=options, measured=lambda value, *_, said=said: said.append(value))
        code = compile(ast.Module(deciding(bodies[f"{name}.measured"], {*found}), []), lesson, "exec")
        exec(code, {name: prediction, "methods": methods, "np": np, **found})
        assert said == [options[answer] if isinstance(answer, int) else answer]
        assert said[0] in options
