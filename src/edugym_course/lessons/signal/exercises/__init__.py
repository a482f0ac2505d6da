"""The exercises of lesson 6: the length of a message, the information in a table, and a player that remembers."""

import math
from functools import cache, partial
from types import MappingProxyType
from typing import Annotated, Any

import numpy as np

from edugym.checks.values import is_finite_number
from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_class, require_function
from edugym_course.grading.challenge import Challenge
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import UNUSUAL_NUMBER, compare, number, same
from edugym_course.lessons.signal.exercises.listener import (
    HEARD,
    check_actions,
    check_memory,
    heard_beside,
    made_by,
)
from edugym_course.lessons.signal.methods import LEARNING_RATE, learner
from edugym_course.lessons.signal.moody import moody_toy
from edugym_course.lessons.signal.players import RoundRobin, Voter
from edugym_course.lessons.signal.words import bits, information

ENOUGH = 0.4
"""The bits that a message should carry in exercise 1."""
Enough = Annotated[
    float,
    Own(
        # Between the bits of two lengths: 5 words carry less than the first at τ = 0.1, 6 words more, and so on.
        (
            0.117,
            0.137,
            0.156,
            0.175,
            0.194,
            0.213,
            0.231,
            0.249,
            0.266,
            0.283,
            0.3,
            0.317,
            0.333,
            0.349,
            0.365,
            0.38,
            0.396,
            0.411,
            0.425,
            0.44,
            0.454,
            0.468,
            0.482,
            0.495,
            0.509,
            0.522,
            0.535,
            0.548,
            0.56,
            0.573,
            0.585,
            0.597,
            0.609,
            0.62,
            0.632,
            0.643,
            0.654,
            0.665,
            0.676,
            0.687,
            0.697,
            0.708,
        ),
        "Your message should carry {enough} bit or more, not 0.4.",
    ),
]
Base = Annotated[
    int,
    Own(
        tuple(base for base in range(3, 64) if base != 10),
        "Your information is measured in digits of a number system with {base} digits, not in bits:"
        " $\\log_{{{base}}}$ stands in the place of $\\log_2$. `math.log(x, {base})` is that logarithm.",
    ),
]
Loud = Annotated[
    float,
    Own(
        tuple(k + 0.5 for k in range(1, 42)),
        "The first word of a message is loud: in your version it counts as much as {loud} words.",
    ),
]
REPEATED = "the words repeat each other in part, so more are needed"


def exercise_1(answer: Any, seed: int, enough: Enough = ENOUGH) -> str:
    """Check the smallest number of words that carry enough bits at τ = 0.1."""
    found = number("words", answer)
    if found != int(found):
        raise WrongAnswer(f"words should be a whole number, since half a word is never said, but is {found:g}")
    one, right = information(0.1), _fewest(0.1, enough)

    def says(words: float) -> str:
        if not 1 <= words <= 100:  # more take seconds to compute
            return f"words = {words:g} is not from 1 to 100"
        carry = "1 word carries" if words == 1 else f"{words:.0f} words carry"
        return f"{carry} {information(0.1, int(words)):.3f} bit at τ = 0.1"

    compare(
        "words",
        answer,
        right,
        {
            "that is the value with which the cell began": 1,
            f"that is {enough:g} divided by the bits of one word; {REPEATED}": math.ceil(enough / one),
            f"that is {enough:g} divided by the bits of one word, rounded down; {REPEATED}": math.floor(enough / one),
            f"that is the last length that carries less than {enough:g} bit; one word more is enough": right - 1,
            "one word less is enough: does the search stop one too late?": right + 1,
            "that is the longest message of this lesson, and fewer are enough": 28,
            "that is the answer for τ = 0.05": _fewest(0.05, enough),
            "that is where *half* a bit is reached": _fewest(0.1, 0.5),
        },
        tolerance=0.0,
        says=says,
        otherwise="that is not enough yet" if found < right else "fewer words are enough",
    )
    return (
        f"Right: {right}, not {math.ceil(enough / one)}. The second word tells a part of what the first one has told"
        " already, so that information adds up more and more slowly."
    )


@cache
def _fewest(tau: float, enough: float) -> int:
    """Return the smallest number of words that carry so many bits."""
    words = 1
    while information(tau, words) < enough:
        words += 1
    return words


def exercise_2(answer: Any, seed: int, base: Base = 2) -> str:
    """Check the function that returns the information in a table, with logarithms of some base."""
    require_function("bits_in", answer, "a table")
    rng = np.random.default_rng(seed)
    tables = _tables(rng)
    given_back = [_call(answer, joint) for joint in tables]
    everywhere = _mistakes_that_fit(tables, given_back, base)
    for joint, found in zip(tables, given_back, strict=True):
        told, expected = _told(joint), bits(joint) / math.log2(base)
        if isinstance(found, float | np.floating) and math.isnan(found):
            raise WrongAnswer(
                f"bits_in({told}) gives nan: the logarithm of 0 times 0 is not a number, so leave pairs out that never"
                " occur"
            )
        value = number(f"bits_in({told})", found)
        rounded = any(same(value, round(expected, places)) for places in range(1, 6))
        compare(
            f"bits_in({told})",
            found,
            expected,
            {"do not round it": value}
            if rounded
            else {
                why: wrong
                for why, wrong in bits_mistakes(joint, base).items()
                if abs(wrong - expected) > 1e-6 and why in everywhere
            },
            tolerance=1e-6,
            otherwise=NEARLY if _are_near(tables, given_back, base) else UNUSUAL_NUMBER,
        )
    return "Right: these are the bits of the figures."


def _told(joint: Reals) -> str:
    """Return a table in one line."""
    return np.array2string(joint, precision=4, separator=", ").replace("\n", "")


def _call(answer: Any, joint: Reals) -> Any:
    """Return what a student's function gives for a table."""
    before = joint.copy()
    with student_code(f"bits_in({_told(joint)})"):
        found = answer(joint)
    if not np.array_equal(joint, before):
        raise WrongAnswer("bits_in changes the table that it is given: work with a copy, or with new variables")
    return found


def _mistakes_that_fit(tables: list[Reals], found: list[Any], base: int) -> set[str]:
    """Return the mistakes that give what the student's function gives, for all tables."""
    if not all(map(is_finite_number, found)):
        return set()
    wrong = [bits_mistakes(joint, base) for joint in tables]
    return {why for why in wrong[0] if np.allclose([one[why] for one in wrong], found, rtol=1e-3, atol=1e-6)}


def _are_near(tables: list[Reals], found: list[Any], base: int) -> bool:
    """Whether the student's function is a little off for all tables, as with a small number added to each entry."""
    return all(
        is_finite_number(value) and abs(value - bits(joint) / math.log2(base)) < 0.1
        for joint, value in zip(tables, found, strict=True)
    )


NEARLY = (
    "that is close, for all tables: a small number that is added so that no entry is 0 changes the sum; leave out the"
    " pairs that never occur"
)


def _tables(rng: np.random.Generator) -> list[Reals]:
    """Make tables up: with sixteenths that can be followed by hand, without and with zeros, of several sizes."""
    first = np.array([[6.0, 2.0], [1.0, 7.0]])
    shapes = ((2, 2), (2, 3), (3, 2), (4, 4))
    others = [rng.integers(1, 6, shape).astype(float) for shape in shapes]
    for table in others:
        table[0] += np.arange(table.shape[1]) + rng.integers(1, 3)  # so that needs and messages are not alike
    others[1][0, 0] = 0.0
    others[3][np.arange(4), (np.arange(4) + 1) % 4] = 0.0
    rare = np.array([[6.0, 1e-4], [2.0, 5.0]])  # a pair that hardly ever occurs counts too
    return [table / table.sum() for table in (first, *others, rare)]


def bits_mistakes(joint: Reals, base: int = 2) -> dict[str, float]:
    """Return what the usual mistakes give for a table, if the logarithm should have a base."""
    in_bits = _mistakes_in_bits(joint)
    needed = f"bits need the base {base}, `math.log2` or `np.log2`" if base == 2 else f"it should be {base}"
    return {
        **{why: value / math.log2(base) for why, value in in_bits.items()},
        f"the logarithm has the base e; {needed}": bits(joint) * math.log(2),
        f"the logarithm has the base 10; {needed}": bits(joint) * math.log10(2),
        NO_LOGARITHM: in_bits[NO_LOGARITHM],
    }


NO_LOGARITHM = "the logarithm is missing"


def _mistakes_in_bits(joint: Reals) -> dict[str, float]:
    """Return what the mistakes give that have nothing to do with the base of the logarithm."""
    p_x, p_y = joint.sum(axis=1), joint.sum(axis=0)
    possible = joint > 0
    right = bits(joint)
    p = joint[possible]
    outer = np.outer(p_x, p_y)[possible]
    entropy_x, entropy_y = (-float(np.sum(q[q > 0] * np.log2(q[q > 0]))) for q in (p_x, p_y))
    together = -float(np.sum(p * np.log2(p)))
    return {
        "the sign is wrong: p(x, y) stands above the line, and p(x) p(y) below": -right,
        "that is the entropy of x alone: it leaves the message out": entropy_x,
        "that is the entropy of y alone: it leaves the need out": entropy_y,
        "that is −Σ p(x, y) log p(x, y), the entropy of the pair; p(x, y) has to be divided by p(x) p(y)": together,
        "that is Σ p(x, y) log p(x, y): p(x, y) has to be divided by p(x) p(y)": -together,
        "H(X) + H(Y) is the sum of two entropies; less that of the pair, H(X, Y), it is the information": entropy_x
        + entropy_y,
        "that is what is still open about x after the message; the information is what the message has told": together
        - entropy_y,
        "that is what is still open about y when x is known; the information is what the message has told": together
        - entropy_x,
        "p(y) is missing: it divides by p(x) alone": float(
            np.sum(p * np.log2(p / (p_x[:, None] + 0 * joint)[possible]))
        ),
        "p(x) is missing: it divides by p(y) alone": float(np.sum(p * np.log2(p / (p_y + 0 * joint)[possible]))),
        "p(x) is taken to be the same for every need; it is the sum of a row": float(
            np.sum(p * np.log2(p * len(p_x) / (p_y + 0 * joint)[possible]))
        ),
        "p(x) and p(y) are taken to be the same for every need and every message; they are sums of the table": float(
            np.sum(p * np.log2(p * joint.size))
        ),
        "that is the mean of a row and of a column; p(x) and p(y) are their sums": right + math.log2(joint.size),
        "pairs that are rarer than p(x) p(y) count too, with their sign; leave out only those that never occur": _sum(
            joint, joint > np.outer(p_x, p_y)
        ),
        "that is a share of the entropy of x; the information itself is asked for": right / entropy_x,
        "only the last pair counts: is the sum overwritten in the loop?": float(_terms(joint)[possible][-1]),
        "a logarithm below 0 counts as well, with its sign": float(np.abs(_terms(joint)).sum()),
        "the weight p(x, y) before the logarithm is missing": float(np.sum(np.log2(p / outer))),
        "the weight before the logarithm should be p(x, y), not p(x) p(y)": float(np.sum(outer * np.log2(p / outer))),
        "that is the *mean* over the pairs; the weights p(x, y) are in the sum already, so add them up": right
        / joint.size,
        "that is the mean over the pairs that occur; the weights p(x, y) are in the sum already": right / len(p),
        "brackets are missing: / p(x) * p(y) divides by p(x) and *multiplies* by p(y)": float(
            np.sum(p * np.log2((joint / p_x[:, None] * p_y)[possible]))
        ),
        "the first 0 of a row ends the row: `break` leaves the loop, and `continue` goes on with the next pair": _part(
            joint, np.logical_and.accumulate(possible, axis=1)
        ),
        "the first 0 ends the sum: only that pair adds nothing, and all others count": _part(
            joint, np.logical_and.accumulate(possible.ravel()).reshape(joint.shape)
        ),
        "very small entries are left out too; leave out only those that are 0": _sum(joint, joint > 0.01),
        "small entries are left out too; leave out only those that are 0": _sum(joint, joint > 0.05),
        NO_LOGARITHM: float(np.sum(p * p / outer)),
        "that is twice the information": 2 * right,
        "only the diagonal is added up; a word that names another need counts too": float(
            sum(
                joint[k, k] * math.log2(joint[k, k] / (p_x[k] * p_y[k]))
                for k in range(min(joint.shape))
                if joint[k, k] > 0
            )
        ),
        "that is 2 bits less the rest; the needs need not be equally likely, and there may be other than four": 2
        - (together - entropy_y),
        "only the first row is added up: does the `return` stand inside the loop?": _part(joint, slice(0, 1)),
        "the last row is missing in the sum": _part(joint, slice(0, -1)),
        "the first row is missing in the sum: indices begin with 0": _part(joint, slice(1, None)),
        "the first row and the first column are missing in the sum: indices begin with 0": _part(
            joint, (slice(1, None), slice(1, None))
        ),
        "p(x | y) should be weighted by p(x, y), and not by itself": float(
            np.sum(p / (p_y + 0 * joint)[possible] * np.log2(p / outer))
        ),
        "the weight p(x, y) belongs to all three logarithms: put brackets around their sum": float(
            np.sum(p * np.log2(p) - np.log2(outer))
        ),
        "the first pair alone: does the `return` stand inside the loops?": float(
            joint[0, 0] * math.log2(joint[0, 0] / (p_x[0] * p_y[0])) if joint[0, 0] > 0 else 0.0
        ),
    }


def _terms(joint: Reals) -> Reals:
    """Return p(x, y) log2(p(x, y) / (p(x) p(y))) for every pair, 0 where it never occurs."""
    outer = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.array(joint * np.log2(np.where(joint > 0, joint / outer, 1.0)))


def _part(joint: Reals, part: Any) -> float:
    """Return the sum over some of the rows, or of the pairs."""
    chosen = np.zeros(joint.shape, bool)
    chosen[part] = True
    return _sum(joint, chosen & (joint > 0))


def _sum(joint: Reals, chosen: Any) -> float:
    """Return the sum over the pairs that are chosen."""
    return float(_terms(joint)[chosen].sum())


def exercise_3(answer: Any, seed: int, loud: Loud = 1.0) -> str:
    """Check the class of a player that votes, but takes no action twice in a row; the first word may be loud."""
    require_class("Listener", answer)
    rng = np.random.default_rng(seed)
    made = made_by(answer)
    if made_by(answer).last is made.last:
        raise WrongAnswer("two players share one array `last`: make a new one in every call of `create`")
    heard = (*HEARD, *(heard_beside(loud) if loud != 1.0 else ()))
    cases = [heard[k] for k in rng.permutation(len(heard))]
    check_actions(made, cases, loud)
    check_memory(made, cases)
    return "Right: message and memory together. See it race:"


CHALLENGE = Challenge(
    environment=moody_toy(tau=0.05, max_msg_length=4),
    parameters=MappingProxyType({}),
    n_steps=20_000,
    baselines=MappingProxyType(
        {
            "obey the first word": Voter.create,
            "majority vote": partial(Voter.create, heard=4),
            "in turn": RoundRobin.create,
            "Q-learning": learner(5 * LEARNING_RATE),
        }
    ),
    optimum=6595.22,
    best_average=6595.22,
    column="training_return",
)
"""The open challenge: the highest return of all training episodes on a toy with moods."""
