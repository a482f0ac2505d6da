"""Zero-sum games of one move, such as rock-paper-scissors, solved by the simplex method.

The first player chooses a row and wants a high payoff, the second a column and wants a low one. Von Neumann's theorem:
there are a policy π of the first and ρ of the second such that each guarantees the same value, whatever the other does.
They are the two halves of a linear programme, which the simplex method solves in a dozen steps.
"""

from typing import Any, NamedTuple

import numpy as np

from edugym.checks.parameters import an_array, in_short
from edugym.mdp.protocol import Integers, Reals

ROUNDING, SMALLEST_PIVOT = 1e-11, 1e-9
"""What counts as 0: a gain from one more step, and a number to divide by. The payoffs are scaled to lie from 1 to 2."""
SUM_ERROR = 1e-9
"""How far from 1 the sum of a policy may be; more is left where almost equal payoffs made a pivot tiny."""
MOST_PIVOTS = 1_000
"""A game of some actions takes a dozen steps. Dantzig's rule could go round in circles for ever."""


class Equilibrium(NamedTuple):
    """The solution of a zero-sum game of one move.

    Attributes:
        value: what the first player gets on average if both play well; the second gets its opposite.
        first: shape (n_rows,): the first player's policy.
        second: shape (n_columns,): the second player's.
    """

    value: float
    first: Reals
    second: Reals


def solve_zero_sum(payoffs: Any) -> Equilibrium:
    """Solve a zero-sum game of one move: the value, and a policy of each player that guarantees it.

        solve_zero_sum([[0, -1, 1], [1, 0, -1], [-1, 1, 0]])    # rock-paper-scissors: value 0, a third each

    Where several policies guarantee the value, one of them is found; where all payoffs are equal, the uniform one. They
    guarantee it to about 1e-13 of the largest difference between payoffs. Where payoffs are almost equal and not quite
    (by 1e-9 of the others, say), rounding may cost more digits: about one of 500 such games is wrong by more than 1e-7.

    Args:
        payoffs: shape (n_rows, n_columns): what the first player gets, finite numbers.

    Raises:
        ValueError: payoffs are something else.

    References: von Neumann (1928), Zur Theorie der Gesellschaftsspiele; Dantzig (1951), A proof of the equivalence of
    the programming problem and the game problem.
    """
    table = an_array("payoffs", payoffs, ("n_rows", "n_columns"))
    if not table.size or not np.isfinite(table).all():
        raise ValueError(f"payoffs must be finite numbers, one at least, but are {in_short(payoffs)}")
    n_rows, n_columns = table.shape
    first, second = np.zeros((1, n_rows)), np.zeros((1, n_columns))
    value = solve_state(table[np.newaxis], 0, first, second, *workspace(n_rows, n_columns))
    return Equilibrium(value, first[0], second[0])


def solve_states(
    n_states: int, Q: Reals, V: Reals, first: Reals, second: Reals, tableau: Reals, labels: Integers
) -> None:
    """Solve the game of every state, and write the values into V, shape (n_states,); the rest as in `solve_state`."""
    for state in range(n_states):
        V[state] = solve_state(Q, state, first, second, tableau, labels)


def workspace(n_rows: int, n_columns: int) -> tuple[Reals, Integers]:
    """The two arrays in which `solve_state` computes, so that it makes no new ones."""
    return np.zeros((n_rows + 1, n_columns + 1)), np.zeros(n_rows + n_columns, np.int64)


def solve_state(Q: Reals, state: int, first: Reals, second: Reals, tableau: Reals, labels: Integers) -> float:
    """Solve the game with the payoffs Q(s, a, b) of one state, and write both policies into their rows.

        V(s) = max_π min_b Σ_a π(a) Q(s, a, b) = min_ρ max_a Σ_b ρ(b) Q(s, a, b)

    The payoffs are moved and scaled to lie from 1 to 2, so that the value v is positive. With y = ρ/v the second player
    maximises Σ_b y(b) = 1/v, where Σ_b y(b) Q(s, a, b) <= 1 for every a: y = 0 is a corner to start from. In the corner
    where no step leads up any more, the dual variables are π/v.

    Args:
        Q: shape (n_states, n_rows, n_columns).
        state: s.
        first: shape (n_states, n_rows): where π is written.
        second: shape (n_states, n_columns): where ρ is written.
        tableau: shape (n_rows + 1, n_columns + 1): the simplex tableau, see `workspace`.
        labels: shape (n_rows + n_columns,): which variable stands at each row, then at each column.

    Returns:
        V(s).
    """
    n_rows, n_columns = Q.shape[1], Q.shape[2]
    low = Q[state, 0, 0]
    high = Q[state, 0, 0]
    for a in range(n_rows):
        for b in range(n_columns):
            low = min(low, Q[state, a, b])
            high = max(high, Q[state, a, b])
    spread = float(high - low)
    if not spread > 0.0:
        for a in range(n_rows):
            first[state, a] = 1.0 / n_rows
        for b in range(n_columns):
            second[state, b] = 1.0 / n_columns
        return float(low)
    for a in range(n_rows):
        first[state, a] = 0.0
        labels[a] = n_columns + a
        for b in range(n_columns):
            tableau[a, b] = 1.0 + (Q[state, a, b] - low) / spread
        tableau[a, n_columns] = 1.0
    for b in range(n_columns):
        second[state, b] = 0.0
        labels[n_rows + b] = b
        tableau[n_rows, b] = -1.0
    tableau[n_rows, n_columns] = 0.0
    for _ in range(MOST_PIVOTS):
        column = entering_column(tableau, n_rows, n_columns)
        row = leaving_row(tableau, column, n_rows, n_columns) if column >= 0 else -1
        if row < 0:
            break
        exchange(tableau, labels, row, column, n_rows, n_columns)
    total = float(tableau[n_rows, n_columns])  # 1/v
    for b in range(n_columns):
        if labels[n_rows + b] >= n_columns:
            first[state, labels[n_rows + b] - n_columns] = max(0.0, tableau[n_rows, b] / total)
    for a in range(n_rows):
        if labels[a] < n_columns:
            second[state, labels[a]] = max(0.0, tableau[a, n_columns] / total)
    make_sum_one(first, state)
    make_sum_one(second, state)
    return float(low + spread * (1.0 / total - 1.0))


def make_sum_one(policy: Reals, state: int) -> None:
    """Divide the probabilities of a state by their sum, where rounding has left one that is not 1."""
    n_actions = policy.shape[1]
    total = 0.0
    for a in range(n_actions):
        total += policy[state, a]
    if abs(total - 1.0) > SUM_ERROR:
        for a in range(n_actions):
            policy[state, a] = policy[state, a] / total if total > 0.0 else 1.0 / n_actions


def entering_column(tableau: Reals, n_rows: int, n_columns: int) -> int:
    """The column whose variable raises the sum the most (Dantzig's rule); -1 if there is none."""
    chosen = -1
    for b in range(n_columns):
        if tableau[n_rows, b] < -ROUNDING and (chosen < 0 or tableau[n_rows, b] < tableau[n_rows, chosen]):
            chosen = b
    return chosen


def leaving_row(tableau: Reals, column: int, n_rows: int, n_columns: int) -> int:
    """The row whose variable falls to 0 first as that of the column rises; among equals the one of largest pivot.

    It is -1 where every pivot is so small that only rounding has made it.
    """
    chosen = -1
    smallest = 0.0
    for a in range(n_rows):
        pivot = tableau[a, column]
        if pivot > SMALLEST_PIVOT:
            ratio = max(0.0, float(tableau[a, n_columns] / pivot))  # rounding can make a 0 negative
            if chosen < 0 or ratio < smallest or (ratio == smallest and pivot > tableau[chosen, column]):
                smallest = ratio
                chosen = a
    return chosen


def exchange(tableau: Reals, labels: Integers, row: int, column: int, n_rows: int, n_columns: int) -> None:
    """Let the variables of a row and a column change places: one step from a corner to the next."""
    pivot = float(tableau[row, column])
    for a in range(n_rows + 1):
        if a != row:
            factor = float(tableau[a, column] / pivot)
            for b in range(n_columns + 1):
                if b != column:
                    tableau[a, b] -= factor * tableau[row, b]
            tableau[a, column] = -factor
    for b in range(n_columns + 1):
        if b != column:
            tableau[row, b] /= pivot
    tableau[row, column] = 1.0 / pivot
    label = labels[row]
    labels[row] = labels[n_rows + column]
    labels[n_rows + column] = label
