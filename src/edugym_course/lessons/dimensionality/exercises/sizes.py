"""Exercise 1 of lesson 4: the size of a dense table."""

import sys
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Annotated, Any

import numpy as np

from edugym_course.grading.agents import require_function
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import CARET, compare, exact

OTHERWISE: Mapping[str, str] = MappingProxyType(
    {
        "vectorised": "an observation is three numbers here, the ball's column, its row and the paddle's column: how"
        " many values has each, and how many triples do they make?",
        "grid": "every board that could be written down has a row, also one that never occurs, with no ball or with"
        " two: each pixel is 0 or 1, whatever the others are",
        "rgb": "every image that could be written down has a row, also one that never occurs: each of the three numbers"
        " of a cell is one of 256, whatever the others are",
    }
)
"""By kind, what to say of a number that is none of the usual mistakes."""


Actions = Annotated[
    int,
    Own(tuple(range(4, 64)), "Your paddle is a clever one: in your version there are {actions} actions, not three."),
]


def exercise_1(answer: Any, seed: int, actions: Actions = 3) -> str:
    """Check the number of entries of a dense table, with a number of actions."""
    require_function("table_entries", answer, "rows, columns and kind")
    rng = np.random.default_rng(seed)
    sizes = (5 + int(rng.integers(3)), 4), (2, 2), (5, 2)
    for kind in ("vectorised", "grid", "rgb"):
        # the smallest board first for an image: for larger ones not all mistakes give numbers that fit into a float
        for size in sorted(sizes) if kind == "rgb" else sizes:
            call = f"table_entries({size[0]}, {size[1]}, {kind!r})"
            with student_code(call):
                found = answer(*size, kind)
            right = ENTRIES[kind](*size, actions)
            wrong = {why: mistake(*size, actions) for why, mistake in MISTAKES[kind].items()}
            mistakes = {why: float(value) for why, value in wrong.items() if right != value < sys.float_info.max}
            compare(call, found, float(right), mistakes, otherwise=OTHERWISE[kind])
    for rows, columns, kind in ((9, 9, "grid"), (10, 5, "rgb")):
        call = f"table_entries({rows}, {columns}, {kind!r})"
        with student_code(call):
            try:
                found = answer(rows, columns, kind)
            except OverflowError:
                found = np.inf
        exact(call, found, ENTRIES[kind](rows, columns, actions))
    return "Right: for the image of 10 by 5 cells that is a number with 362 digits."


Size = Callable[[int, int, int], int]
ENTRIES: Mapping[str, Size] = MappingProxyType(
    {
        "vectorised": lambda r, c, a: r * c * c * a,
        "grid": lambda r, c, a: 2 ** (r * c) * a,
        "rgb": lambda r, c, a: 256 ** (3 * r * c) * a,
    }
)
ALONE = "that is the number of rows; each of them holds a number for each of the actions"
THE_LESSONS = "that is the board of the lesson, 10 by 5: use `rows` and `columns`"
BYTES = "those are bytes, 8 for each number; the numbers are asked for"
MISTAKES: Mapping[str, Mapping[str, Size]] = MappingProxyType(
    {
        "vectorised": {
            ALONE: lambda r, c, a: r * c * c,
            "multiply by the number of actions, do not add it": lambda r, c, a: r * c * c + a,
            "the ball's row is missing: it falls, and so it is in another one at each step": lambda r, c, a: c * c * a,
            "the paddle's column is missing: the agent sees it too": lambda r, c, a: r * c * a,
            "the paddle stays in its row, and so it has no row of its own in the observation": lambda r, c, a: (
                r * r * c * c * a
            ),
            "the ball has a column of its own, with as many values as there are columns": lambda r, c, a: r * r * c * a,
            "the numbers of values are multiplied, not added": lambda r, c, a: (r + 2 * c) * a,
            "each number has its own number of values, so multiply these: there is no power here": lambda r, c, a: (
                a * 3 ** (r * c)
            ),
            'that is the formula for the image: is the word "vectorised" spelt as here?': lambda r, c, a: (
                256 ** (3 * r * c) * a
            ),
            "the agent sees three numbers, and a table has a row for all values that these can take together": (
                lambda r, c, a: 3 * a
            ),
            "that is the formula for the grid": lambda r, c, a: 2 ** (r * c) * a,
            "a row has an entry for each action, so multiply by their number; no power is taken": lambda r, c, a: (
                (r * c * c) ** a
            ),
            "positions count from 0, but there are still `rows` of them, and `columns`": lambda r, c, a: (
                (r - 1) * (c - 1) ** 2 * a
            ),
            "the last row belongs to the observations that could be written down, too": lambda r, c, a: (
                (r - 1) * c * c * a
            ),
            THE_LESSONS: lambda r, c, a: 10 * 5 * 5 * a,
            BYTES: lambda r, c, a: r * c * c * a * 8,
        },
        "grid": {
            ALONE: lambda r, c, a: 2 ** (r * c),
            "base and exponent have changed places: each of the pixels has 2 values": lambda r, c, a: (r * c) ** 2 * a,
            "the values of the pixels multiply: take 2 to the power of the number of pixels": lambda r, c, a: (
                2 * r * c * a
            ),
            "those are the boards with one ball and one paddle; a dense table has a row for every board that could be"
            " written down (or does this branch serve every kind, as after `kind == ... or ...`?)": lambda r, c, a: (
                r * c * c * a
            ),
            "that is the number of pixels times the actions": lambda r, c, a: r * c * a,
            "that is the formula for the image; in the grid each cell has one number, 0 or 1": lambda r, c, a: (
                256 ** (3 * r * c) * a
            ),
            "each pixel has 2 values here, not 256": lambda r, c, a: 256 ** (r * c) * a,
            "a pixel of the grid is 0 or 1, and that is all: there are 2 values, not 3": lambda r, c, a: (
                3 ** (r * c) * a
            ),
            "the grid has one number for each cell, not three": lambda r, c, a: 2 ** (r * c * 3) * a,
            "the number of pixels is rows times columns, not their sum": lambda r, c, a: 2 ** (r + c) * a,
            "multiply by the number of actions at the end, outside of the power": lambda r, c, a: 2 ** (r * c + a),
            "multiply by the number of actions; do not take the power": lambda r, c, a: 2 ** (r * c * a),
            THE_LESSONS: lambda r, c, a: 2**50 * a,
            CARET: lambda r, c, a: 2 ^ (r * c * a),
            f"{CARET} (and it comes after `*`)": lambda r, c, a: a * 2 ^ (r * c),
        },
        "rgb": {
            "NumPy's whole numbers overflow here; use Python's `**`": lambda r, c, a: 0,
            ALONE: lambda r, c, a: 256 ** (3 * r * c),
            "each cell has three numbers: red, green and blue": lambda r, c, a: 256 ** (r * c) * a,
            "from 0 to 255 there are 256 values": lambda r, c, a: 255 ** (3 * r * c) * a,
            "a number of the image has 256 values, not 2": lambda r, c, a: 2 ** (3 * r * c) * a,
            "that is the grid; the image has three numbers for each cell, with 256 values": lambda r, c, a: (
                2 ** (r * c) * a
            ),
            "base and exponent have changed places": lambda r, c, a: (3 * r * c) ** 256 * a if r * c < 5 else 0,
            "the values of the numbers multiply: take a power": lambda r, c, a: 256 * 3 * r * c * a,
            "three colours: the exponent is 3 times the number of cells, not the number of cells to the power of 3": (
                lambda r, c, a: 256 ** (r * c) ** 3 * a if r * c < 5 else 0
            ),
            "those are the boards with one ball and one paddle; a dense table has a row for every image that could be"
            " written down (or does this branch serve every kind, as after `kind == ... or ...`?)": lambda r, c, a: (
                r * c * c * a
            ),
            "each of the three colours has 256 values: 256^3 for a cell, not 256 times 3": lambda r, c, a: (
                (256 * 3) ** (r * c) * a
            ),
            "the three colours belong in the exponent": lambda r, c, a: 256 ** (r * c) * 3 * a,
        },
    }
)
"""By kind and sentence, what each mistake gives for a number of rows and columns."""
