"""Exercise 1 of lesson 5: the size of a table over windows of observations."""

import math
from typing import Annotated, Any

import numpy as np

from edugym_course.grading.agents import require_function
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import CARET, exact, number, same
from edugym_course.lessons.memory.windows import action_law, window_law

UNUSUAL = (
    "each of the L(L-1)/2 + 1 observations in the window is any of all that there are, whatever the others are: windows"
    " that never occur have rows too, and their order counts"
)

Looks = Annotated[
    int,
    Own(
        tuple(range(2, 43)),
        "In your corridor an unmarked place has one of {looks} colours, by chance and without a meaning, and the agent"
        " sees which.",
    ),
]


def exercise_1(answer: Any, seed: int, looks: Looks = 1) -> str:
    """Check the number of rows of a table over windows of observations, with so many looks of an unmarked place."""
    require_function("table_rows", answer, "the doors and the length")
    rng = np.random.default_rng(seed)
    cases = [(int(rng.integers(5, 8)), 4), (4, 3 + int(rng.integers(2))), (2, 5), (3, 2), (6, 1), (2, 6), (3, 7)]
    found = []
    for doors, length in cases:
        call, right_size = f"table_rows({doors}, {length})", (doors + looks) ** window_law(length)
        with student_code(call):
            size = answer(doors, length)
        found.append(NumberCase(call, number(call, size), float(right_size), _row_mistakes(doors, length, looks)))
    parts = [
        _part_that_is_wrong(case.found, doors + looks, window_law(length))
        for case, (doors, length) in zip(found, cases, strict=True)
        if not same(case.found, case.expected)
    ]
    compare_all(found, otherwise=parts[0] if parts else UNUSUAL)
    doors, length = 2, 10  # 3^46, more than NumPy has room for
    call = f"table_rows({doors}, {length})"
    with student_code(call):
        size = answer(doors, length)
    exact(call, size, (doors + looks) ** window_law(length))
    return "Right: corridor 7 with three doors needs 4^22 rows, about 18 million million."


def _part_that_is_wrong(size: float, base: int, window: int) -> str:
    """Return what to look at if no usual mistake fits: the base or the exponent, if the answer is a power of a kind."""
    if 1.0 <= size < 1e300:
        exponent, other = round(math.log(size, base)), round(size ** (1 / window))
        if same(size, float(base) ** exponent):
            return f"the base {base} is right. The window has {window} observations here, and you take {exponent}"
        if window > 1 and same(size, float(other) ** window):
            return f"the window of {window} is right. There are {base} different observations, and you take {other}"
    return UNUSUAL


def _row_mistakes(doors: int, length: int, looks: int) -> dict[str, float]:
    """Return what the usual mistakes give."""
    window, with_actions = window_law(length), action_law(length)
    base = doors + looks
    return {
        f"an unmarked place is an observation too, so there are N + {looks} different ones": doors**window,
        "4 is the base for three doors alone; write it with N, the number of doors": 4**window,
        "the present observation is in the window as well: L(L-1)/2 steps back, and one": base ** (window - 1),
        "a window of L is not enough without the actions: the first mark lies L(L-1)/2 steps back": base**length,
        "L(L+1)/2 counts the steps to the end of corridor L; the mark that is needed lies only L(L-1)/2 steps"
        " back": base ** (length * (length + 1) // 2),
        "the present observation is added to L(L-1)/2, not subtracted": base ** max(window - 2, 0),
        "that is the window for corridor L - 1": base ** window_law(length - 1),
        "L(L-1)/2 observations and the present one make L(L-1)/2 + 1; here is one more": base ** (window + 1),
        "7 is the window of corridor 4 alone; compute it from the length": base**7,
        "that is the window for corridor L + 1": base ** window_law(length + 1),
        "that is the number of entries, a row has one for each action; the rows are asked for": base**window * doors,
        "that is the table with the actions in the window; here it shows observations alone": base**with_actions
        * doors ** (with_actions - 1),
        "2L - 3 belongs to windows with actions; observations alone need L(L-1)/2 + 1": base**with_actions,
        "that is the window itself; how many different windows are there?": window,
        f"each observation in the window multiplies the number of rows by N + {looks}: take the power, not the"
        " product": base * window,
        "base and exponent have changed places": window**base,
        f"an unmarked place counts once too often: there are N + {looks} observations": (base + 1) ** window,
        "L^2 / 2 + 1 is not L(L-1)/2 + 1": base ** (length**2 // 2 + 1),
        "L(L-1) should be divided by 2": base ** (length * (length - 1) + 1),
        "set brackets around the whole exponent: a power is taken before a product": base**length * (length - 1) // 2
        + 1,
        "set brackets: L * L - 1 // 2 multiplies and divides before it subtracts": base
        ** (length * length - 1 // 2 + 1),
        f"set brackets around N + {looks}: a power is taken before the sum": doors + looks**window,
        CARET: base ^ window,
        "the window shows observations alone here, so the actions do not multiply the rows": base**window
        * doors ** (window - 1),
        "the tables of all corridors up to L are added up; the window of the longest one serves them all": sum(
            base ** window_law(n) for n in range(1, length + 1)
        ),
        "those are the bytes of the values; the rows are asked for": base**window * 3 * 8,
        "the windows of all lengths are added up; an episode starts with copies of its first observation, so all have"
        " the full length": sum(base**k for k in range(1, window + 1)),
    }
