"""Exercises 1 and 2 of lesson 13: what best answers gain, a safe policy, and the usual mistakes in both."""

import itertools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from edugym.exact.zero_sum import solve_zero_sum
from edugym.mdp.protocol import Reals


class Pair(NamedTuple):
    """A zero-sum game of one move, and a policy of each player."""

    payoffs: Reals
    first: Reals
    second: Reals


PAIRS: Sequence[tuple[Sequence[Sequence[float]], Sequence[float], Sequence[float]]] = (
    ([[0, -1, 2], [3, 0, -4], [-2, 5, 1]], [0.5, 0.25, 0.25], [0.25, 0.125, 0.625]),
    ([[2, -3], [-1, 4]], [0.25, 0.75], [0.5, 0.5]),
    ([[-3, -1, -6], [-2, -8, -4]], [0.75, 0.25], [0.2, 0.3, 0.5]),
    ([[1, 0], [0, 3], [2, -1]], [0, 1, 0], [1, 0]),
)
"""Payoffs and two policies, of games with as many rows as columns and with more of one."""


def exploitability(pair: Pair, weight: float = 1.0) -> dict[str, float]:
    """Return the right number, by "", and what each mistake gives, by its sentence; player 1 has a weight."""
    payoffs, first, second = pair
    now, best, least = first @ payoffs @ second, (payoffs @ second).max(), (first @ payoffs).min()
    most, rows, columns = (first @ payoffs).max(), first @ payoffs, payoffs @ second

    def mean(gain: float, other_gain: float) -> float:
        return float(gain + weight * other_gain) / 2

    right = mean(best - now, now - least)
    return {
        "": right,
        **_other_gains(pair, weight),
        "that is the sum of both gains, and the mean over the two players is asked": 2 * right,
        "that is what player 0 gains alone; player 1 has a best answer too": best - now,
        "that is what player 1 gains alone; player 0 has a best answer too": now - least,
        "that is half of what player 0 gains; player 1 has a best answer too": (best - now) / 2,
        "player 1 gets the opposite of the payoff, so its best answer is the column with the *lowest* payoff": mean(
            best - now, most - now
        ),
        "what player 1 gets is the opposite of the payoff: the two are not added": mean(best - now, least + now),
        "what both get now is counted twice: the payoff of player 1 is the opposite of that of player 0, so the two"
        " cancel": mean(best - now, -least - now),
        "the other's policy is left out: the largest payoff of the table is no answer to a policy": mean(
            payoffs.max() - now, now - payoffs.min()
        ),
        "these are the means over the actions of the one who answers, and a best answer takes the best of them": mean(
            columns.mean() - now, now - rows.mean()
        ),
        "that is what the pair is worth to player 0 now; how much more can each get?": now,
        "the sign is wrong: nobody loses by a best answer": -right,
    }


def halves(pair: Pair, weight: float) -> dict[str, float]:
    """Return the two parts of the right number, by name."""
    payoffs, first, second = pair
    now = first @ payoffs @ second
    gain, other_gain = (payoffs @ second).max() - now, now - (first @ payoffs).min()
    return {"half of what player 0 gains": gain / 2, "half of what player 1 gains": weight * other_gain / 2}


def _other_gains(pair: Pair, weight: float) -> dict[str, float]:
    """Return what some more mistakes give, by their sentences."""
    payoffs, first, second = pair
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    gain, other_gain = rows.max() - now, weight * (now - columns.min())
    i, j = int(first.argmax()), int(second.argmax())
    worth = solve_zero_sum(payoffs).value
    return {
        "that is the larger one of both gains, and the mean over the two players is asked": max(gain, other_gain),
        "that is the smaller one of both gains, and the mean over the two players is asked": min(gain, other_gain),
        "that is half of what player 1 gains; player 0 has a best answer too": other_gain / 2,
        "only the second gain is halved: put the sum in parentheses": gain + other_gain / 2,
        "the answer of player 0 is the worst one: the best answer is the row with the highest payoff": (
            rows.min() - now + other_gain
        )
        / 2,
        "the gains are subtracted; the mean of both is asked": (gain - other_gain) / 2,
        "the sum of both gains is divided by the number of actions; there are two players": (
            (gain + other_gain) / len(payoffs)
        ),
        "player 1 takes the column with the highest payoff, and it wants the lowest": (
            gain + weight * (now - columns.max())
        )
        / 2,
        "player 1 gets the opposite of the payoff: its best answer lacks a minus sign": (
            gain + weight * (columns.max() + now)
        )
        / 2,
        "the policies are swapped: payoffs @ second is what each row is worth, and first @ payoffs each column. (Or"
        " have all payoffs another sign?)": (columns.max() - now + weight * (now - rows.min())) / 2,
        "the best answers are those to a player who takes each action equally often; answer the policy that is given": (
            payoffs.mean(axis=1).max() - now + weight * (now - payoffs.mean(axis=0).min())
        )
        / 2,
        "argmax and argmin are the *numbers* of actions; what they pay is needed": (
            rows.argmax() - now + weight * (now - columns.argmin())
        )
        / 2,
        "argmax is the *number* of a row; what it pays is needed": (rows.argmax() - now + other_gain) / 2,
        "that compares with the value of the game; a gain is what a best answer gets beyond what the player gets now": (
            abs(now - worth)
        ),
        "that is what the policy of player 0 loses to its best opponent; the mean of both gains is asked": (
            worth - columns.min()
        ),
        "the absolute value of each difference is taken; a best answer is the best of them, with its sign": (
            abs(rows - now).max() + weight * abs(columns - now).max()
        )
        / 2,
        "absolute values are compared; a best answer is the best payoff, with its sign": (
            abs(rows).max() + weight * abs(columns).max()
        )
        / 2,
        "payoffs are multiplied by how often the player itself takes the action; whoever answers takes the best one"
        " always": ((first * rows).max() - now + weight * (now - (columns * second).min())) / 2,
        "the means over the actions of the one who answers are added; the best action counts, and half of the sum": (
            rows.mean() - now + weight * (now - columns.mean())
        ),
        "the most probable action stands for each policy; all of them count, by their probabilities": (
            payoffs[:, j].max() - payoffs[i, j] + weight * (payoffs[i, j] - payoffs[i].min())
        )
        / 2,
        "both players change at once, so that nothing is gained; each answers the policy that the other has now": 0.0,
    }


def pairs(seed: int) -> list[Pair]:
    """Return games and policies; other seeds add another number to all payoffs, and turn the tables round."""
    added, turned = (seed * 3) % 5, slice(None, None, -1 if seed % 2 else 1)
    return [
        Pair(np.array(payoffs, float)[turned] + added, np.array(first)[turned], np.array(second))
        for payoffs, first, second in PAIRS
    ]


GAMES = ((3.0, -1.0, -2.0, 5.0), (-4.0, 2.0, 1.0, -1.0), (0.0, 6.0, 2.0, -3.0), (-1.0, -7.0, -5.0, -2.0))
"""Payoffs a, b, c, d of games [[a, b], [c, d]] in which no action is safe."""


def mixed(payoffs: Reals) -> dict[str, float]:
    """Return the right probability of row 0, by "", and what each mistake gives, by its sentence."""
    (a, b), (c, d) = payoffs.tolist()
    total = a - b - c + d
    return {
        "": (d - c) / total,
        "that is the probability of row 1, and that of row 0 is asked": (a - b) / total,
        "with it player 0 itself does not care which row it takes; it is player 1 who must not care about the column": (
            d - b
        )
        / total,
        "that is the probability of column 1 for player 1; that of row 0 for player 0 is asked": (a - c) / total,
        "that is the value of the game, and the probability of row 0 is asked": (a * d - b * c) / total,
        "a coin is right only if the payoffs are as even as in matching pennies": 0.5,
        "a sign below the line is wrong: the difference of the two columns is p (a − b) + (1 − p)(c − d)": (d - c)
        / (a - b + c - d),
        "the sign is wrong: p (a − b) = (1 − p)(d − c)": (c - d) / total,
        "that is the ratio p / (1 − p), not p": (d - c) / (a - b),
        **_other_signs_below(payoffs),
        "c and d are added above the line; it is d − c": (d + c) / total,
        "b and c are left out below the line; it is a − b − c + d": _over(d - c, a + d),
        "the fraction is upside down: a probability is at most 1": total / (d - c),
        "parentheses are missing above the line: Python divides before it subtracts": d - c / total,
        "the sign is wrong, and with it player 0 itself would not care which row it takes; it is player 1 who must not"
        " care about the column": (b - d) / total,
        "parentheses are missing: Python divides before it subtracts": d - _over(c, a) - b - c + d,
        "that is a percentage; a probability goes from 0 to 1": 100 * (d - c) / total,
        "that is the answer to the example above; do the same with letters": 0.4,
        "with it column 0 pays nothing; both columns must pay the same": _over(c, c - a),
        "payoffs are no probabilities: the share of row 0 in their sum means nothing": _over(a + b, a + b + c + d),
        "that is the row with the better mean, without chance; who knows it takes the worse column": float(
            a + b > c + d
        ),
        "that is the row whose worst payoff is the better one; a random choice guarantees more": float(
            min(a, b) > min(c, d)
        ),
    }


def _other_signs_below(payoffs: Reals) -> dict[str, float]:
    """Return what comes out with each other choice of signs below the line, by its sentence."""
    (a, b), (c, d) = payoffs.tolist()
    known = {(1, -1, -1, 1), (-1, 1, 1, -1), (1, -1, 1, -1)}  # right, or named otherwise
    wrong: dict[str, float] = {}
    for signs in sorted({*itertools.product((1, -1), repeat=4)} - known):
        first, *others = ("+" if sign > 0 else "−" for sign in signs)
        below = f"{first.strip('+')}a" + "".join(f" {sign} {name}" for sign, name in zip(others, "bcd", strict=True))
        wrong[f"below the line stands {below}; it is a − b − c + d"] = _over(d - c, float(np.dot(signs, (a, b, c, d))))
    return wrong


def _over(above: float, below: float) -> float:
    """A fraction; NaN where nothing stands below the line, for no answer is that."""
    return above / below if below else np.nan


def games_of(seed: int) -> list[Reals]:
    """Return games in which no action is safe; with other seeds a number is added to all payoffs."""
    return [np.array(payoffs).reshape(2, 2) + seed % 4 for payoffs in GAMES]
