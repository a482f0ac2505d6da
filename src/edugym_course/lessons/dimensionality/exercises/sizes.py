"""Exercise 1 of lesson 4: the size of a dense table."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym_course.grading.agents import require_function
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import CARET, compare, exact

UNUSUAL = "that is none of the usual mistakes, so work it out by hand for a small board"


def exercise_1(answer: Any, seed: int) -> str:
    """Check the number of entries of a dense table."""
    require_function("table_entries", answer, "rows, columns and kind")
    rng = np.random.default_rng(seed)
    sizes = (5 + int(rng.integers(3)), 4), (2, 2), (5, 2)
    for kind in ("vectorised", "grid", "rgb"):
        # the smallest board first for an image: for larger ones not all mistakes give numbers that fit into a float
        for size in sorted(sizes) if kind == "rgb" else sizes:
            call = f"table_entries({size[0]}, {size[1]}, {kind!r})"
            with student_code(call):
                found = answer(*size, kind)
            right = ENTRIES[kind](*size)
            mistakes = {why: float(wrong(*size)) for why, wrong in MISTAKES[kind].items() if wrong(*size) != right}
            compare(call, found, float(right), mistakes, otherwise=UNUSUAL)
    for rows, columns, kind in ((9, 9, "grid"), (10, 5, "rgb")):
        call = f"table_entries({rows}, {columns}, {kind!r})"
        with student_code(call):
            try:
                found = answer(rows, columns, kind)
            except OverflowError:
                found = np.inf
        exact(call, found, ENTRIES[kind](rows, columns))
    return "Right: for the image of 10 by 5 cells that is a number with 362 digits."


Size = Callable[[int, int], int]
ENTRIES: Mapping[str, Size] = MappingProxyType(
    {
        "vectorised": lambda r, c: r * c * c * 3,
        "grid": lambda r, c: 2 ** (r * c) * 3,
        "rgb": lambda r, c: 256 ** (3 * r * c) * 3,
    }
)
ALONE = "that is the number of rows; each of them holds a number for each of the three actions"
THE_LESSONS = "that is the board of the lesson, 10 by 5: use `rows` and `columns`"
BYTES = "those are bytes, 8 for each number; the numbers are asked for"
MISTAKES: Mapping[str, Mapping[str, Size]] = MappingProxyType(
    {
        "vectorised": {
            ALONE: lambda r, c: r * c * c,
            "the paddle's column is missing: the agent sees it too": lambda r, c: r * c * 3,
            "the paddle stays in its row, and so it has no row of its own in the observation": lambda r, c: (
                r * r * c * c * 3
            ),
            "the ball has a column of its own, with as many values as there are columns": lambda r, c: r * r * c * 3,
            "the numbers of values are multiplied, not added": lambda r, c: (r + 2 * c) * 3,
            "each number has its own number of values, so multiply these: there is no power here": lambda r, c: (
                3 * 3 ** (r * c)
            ),
            "that is the formula for the grid": lambda r, c: 2 ** (r * c) * 3,
            "a row has an entry for each action, so multiply by 3; no power is taken": lambda r, c: (r * c * c) ** 3,
            "positions count from 0, but there are still `rows` of them, and `columns`": lambda r, c: (
                (r - 1) * (c - 1) ** 2 * 3
            ),
            "the last row belongs to the observations that could be written down, too": lambda r, c: (
                (r - 1) * c * c * 3
            ),
            THE_LESSONS: lambda r, c: 10 * 5 * 5 * 3,
            BYTES: lambda r, c: r * c * c * 3 * 8,
        },
        "grid": {
            ALONE: lambda r, c: 2 ** (r * c),
            "base and exponent have changed places: each of the pixels has 2 values": lambda r, c: (r * c) ** 2 * 3,
            "the values of the pixels multiply: take 2 to the power of the number of pixels": lambda r, c: (
                2 * r * c * 3
            ),
            "those are the boards with one ball and one paddle; a dense table has a row for every board that could be"
            " written down": lambda r, c: r * c * c * 3,
            "that is the number of pixels times the actions": lambda r, c: r * c * 3,
            "each pixel has 2 values here, not 256": lambda r, c: 256 ** (r * c) * 3,
            "a pixel of the grid is 0 or 1, and that is all: there are 2 values, not 3": lambda r, c: 3 ** (r * c) * 3,
            "the grid has one number for each cell, not three": lambda r, c: 2 ** (r * c * 3) * 3,
            "the number of pixels is rows times columns, not their sum": lambda r, c: 2 ** (r + c) * 3,
            "multiply by 3 at the end, outside of the power": lambda r, c: 2 ** (r * c + 3),
            "multiply by the number of actions; do not take the power": lambda r, c: 2 ** (r * c * 3),
            THE_LESSONS: lambda r, c: 2**50 * 3,
            CARET: lambda r, c: 2 ^ (r * c * 3),
            f"{CARET} (and it comes after `*`)": lambda r, c: 3 * 2 ^ (r * c),
        },
        "rgb": {
            "NumPy's whole numbers overflow here; use Python's `**`": lambda r, c: 0,
            ALONE: lambda r, c: 256 ** (3 * r * c),
            "each cell has three numbers: red, green and blue": lambda r, c: 256 ** (r * c) * 3,
            "from 0 to 255 there are 256 values": lambda r, c: 255 ** (3 * r * c) * 3,
            "a number of the image has 256 values, not 2": lambda r, c: 2 ** (3 * r * c) * 3,
            "that is the grid; the image has three numbers for each cell, with 256 values": lambda r, c: (
                2 ** (r * c) * 3
            ),
            "base and exponent have changed places": lambda r, c: (3 * r * c) ** 256 * 3 if r * c < 5 else 0,
            "the values of the numbers multiply: take a power": lambda r, c: 256 * 3 * r * c * 3,
            "three colours: the exponent is 3 times the number of cells, not the number of cells to the power of 3": (
                lambda r, c: 256 ** (r * c) ** 3 * 3 if r * c < 5 else 0
            ),
            "those are the boards with one ball and one paddle; a dense table has a row for every image that could be"
            " written down": lambda r, c: r * c * c * 3,
            "each of the three colours has 256 values: 256^3 for a cell, not 256 times 3": lambda r, c: (
                (256 * 3) ** (r * c) * 3
            ),
            "the three colours are in the exponent": lambda r, c: 256 ** (r * c) * 3 * 3,
        },
    }
)
"""By kind and sentence, what each mistake gives for a number of rows and columns."""
