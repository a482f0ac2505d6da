"""Exercise 2: potential-based shaping."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Annotated, Any

from edugym.mdp.protocol import Random
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import number

Numbers = tuple[float, float, float, bool, float]
"""A reward, φ(s), φ(s'), whether the episode has terminated, and γ."""


def _shaped(r: float, a: float, b: float, end: bool, g: float) -> float:
    """Return a reward with potential-based shaping."""
    return r + (0.0 if end else g * b) - a


SHAPING_MISTAKES: Mapping[str, Callable[..., float]] = {
    "the potential of the next state counts γ φ(s'), with the discount": lambda r, a, b, end, g: r + b * (not end) - a,
    "after a terminal state there is nothing: its potential is 0 when `terminated`": lambda r, a, b, end, g: (
        r + g * b - a
    ),
    "both mistakes: γ is missing before φ(s'), and the potential of a terminal state is 0": lambda r, a, b, end, g: (
        r + b - a
    ),
    "the sign is wrong: it is what the potential *gains*, γ φ(s') − φ(s)": lambda r, a, b, end, g: (
        r - g * b * (not end) + a
    ),
    "φ(s) is not subtracted: that is a bonus which can be farmed": lambda r, a, b, end, g: r + g * b * (not end),
    "that is a bonus for the next state, without discount and without the bill φ(s)": lambda r, a, b, end, g: r + b,
    "that is the shaping reward alone; add the reward": lambda r, a, b, end, g: g * b * (not end) - a,
    "at the end the bill still has to be paid: − φ(s) counts also when `terminated`": lambda r, a, b, end, g: (
        r if end else r + g * b - a
    ),
    "the reward counts when `terminated`, and F otherwise, but never both: `a + b if c else d` means `(a + b) if c else"
    " d`, so put the part with `if` in parentheses": lambda r, a, b, end, g: r if end else g * b - a,
    "φ(s) counts when `terminated`, and all the rest otherwise: `a if c else b - d` means `a if c else (b - d)`, so put"
    " the part with `if` in parentheses": lambda r, a, b, end, g: -a if end else r + g * b,
    "when `terminated`, φ(s') is 0, and not φ(s)": lambda r, a, b, end, g: r + g * b - a * (not end),
    "`terminated` is the wrong way round: φ(s') counts when it is False": lambda r, a, b, end, g: r + g * b * end - a,
    "both: when `terminated` is True it is φ(s') that is 0, and not φ(s) when it is False": lambda r, a, b, end, g: (
        r + g * b - a * end
    ),
    "the reward counts at the end too, when `terminated`": lambda r, a, b, end, g: 0.0 if end else r + g * b - a,
    "when `terminated`, only φ(s') is 0; the reward still counts": lambda r, a, b, end, g: -a if end else r + g * b - a,
    "F may be below 0: what the potential loses is taken back": lambda r, a, b, end, g: (
        r + max(g * b * (not end) - a, 0.0)
    ),
    "F may be below 0, and its absolute value is not asked for": lambda r, a, b, end, g: r + abs(g * b * (not end) - a),
    "φ(s) is subtracted and not added, and γ φ(s') is missing": lambda r, a, b, end, g: r + a,
    "only φ(s') is discounted, and not all of it": lambda r, a, b, end, g: g * (r + b * (not end) - a),
    "a potential may be below 0, and then it counts as it is": lambda r, a, b, end, g: (
        r + g * abs(b) * (not end) - abs(a)
    ),
    "F is added to the reward and not multiplied by it": lambda r, a, b, end, g: r * (g * b * (not end) - a),
    "that is the reward alone, without shaping": lambda r, a, b, end, g: r,
    "only φ(s') is discounted, not φ(s)": lambda r, a, b, end, g: r + g * (b * (not end) - a),
    "γ belongs before φ(s'), not before φ(s)": lambda r, a, b, end, g: r + b * (not end) - g * a,
    "the reward itself is not discounted": lambda r, a, b, end, g: g * (r + b * (not end)) - a,
    "the two states have changed places": lambda r, a, b, end, g: r + g * a * (not end) - b,
    "γ φ(s') is missing; it counts unless `terminated`": lambda r, a, b, end, g: r - a,
    "+ φ(s) stands where − φ(s) should": lambda r, a, b, end, g: r + g * b * (not end) + a,
}
"""By the sentence that tells of it, what each mistake gives for the same numbers."""


Weight = Annotated[
    float,
    Own(
        tuple(k / 20 for k in range(21, 81)),
        "In your version the potential counts more: $F = {weight}\\, (\\gamma\\, \\varphi(s') - \\varphi(s))$.",
    ),
]


def exercise_2(answer: Any, seed: int, weight: Weight = 1.0) -> str:
    """Check the function that adds potential-based shaping to a reward, with a weight."""
    of = "reward, potential, state, next_state, terminated and discount"
    require_function("shaped_reward", answer, of)
    rules = [partial(_by_rule, rule, weight) for rule in (_shaped, *SHAPING_MISTAKES.values())]
    compare_all(
        [
            NumberCase(
                *_shaped_by(answer, told),
                _by_rule(_shaped, weight, told),
                {why: _by_rule(mistake, weight, told) for why, mistake in SHAPING_MISTAKES.items()},
                _terms(weight, told),
            )
            for told in shaping_numbers(telling_draw(seed, shaping_numbers, rules))
        ]
    )
    return "Right: what is given on the way to a state is taken back when it is left. Here are both policies:"


def _terms(weight: float, told: Numbers) -> dict[str, float]:
    reward, before, after, terminated, discount = told
    gained = 0.0 if terminated else weight * discount * after
    return {"the reward": reward, "γ φ(s')": gained, "−φ(s)": -weight * before}


def _by_rule(rule: Callable[..., float], weight: float, told: Numbers) -> float:
    reward, before, after, terminated, discount = told
    return rule(reward, weight * before, weight * after, terminated, discount)


def shaping_numbers(rng: Random) -> list[Numbers]:
    """Make numbers up for five steps.

    The second one is the last of its episode. In the fourth both potentials are below 0, and the last one stays in its
    state.
    """
    made = list[Numbers]()
    for terminated, discount in ((False, 0.5), (True, 0.75), (False, 0.75)):
        before, after = float(rng.integers(2, 9)), 11.0 + 2.0 * float(rng.integers(4))
        made.append((40.0 + float(rng.integers(1, 6)), before, after, terminated, discount))
    stays = float(rng.integers(12, 19))
    return [*made, (30.0, -float(rng.integers(2, 9)), -12.0, False, 0.5), (20.0, stays, stays, False, 0.75)]


def _shaped_by(answer: Callable[..., Any], told: Numbers) -> tuple[str, float]:
    """Call a student's function on made-up numbers; return the call, and what came."""
    reward, before, after, terminated, discount = told
    then = "bed" if before == after else "door"
    call = (
        f"shaped_reward({reward:g}, potential, 'bed', {then!r}, {terminated}, {discount:g}) with potential('bed') ="
        f" {before:g}" + ("" if then == "bed" else f" and potential('door') = {after:g}")
    )

    def potential(state: str) -> float:
        return {"bed": before, "door": after}[state]

    with student_code(call):
        found = answer(reward, potential, "bed", then, terminated, discount)
    return call, number(call, found)
