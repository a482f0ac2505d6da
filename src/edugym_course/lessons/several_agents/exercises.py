"""The exercises of lesson 13: how exploitable a pair is, a safe policy, and the update of minimax Q."""

from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.exact.zero_sum import solve_zero_sum
from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import UNUSUAL, NumberCase, compare_all, mistake_that_fits
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import all_same, differing, digits, in_brackets, number

LEARNING_RATE, DISCOUNT = 0.5, 0.9


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


Weight = Annotated[
    float,
    Own(
        tuple(k / 10 for k in range(13, 90) if k % 10),
        "Player 1 is a dear friend: in your version its gain counts {weight} times, and that of player 0 once. (The"
        " sum is still halved.)",
    ),
]


def _exploitability(pair: Pair, weight: float = 1.0) -> dict[str, float]:
    """Return the right number, by "", and what each mistake gives, by its sentence; player 1 has a weight."""
    payoffs, first, second = pair
    now, best, least = first @ payoffs @ second, (payoffs @ second).max(), (first @ payoffs).min()
    most, rows, columns = (first @ payoffs).max(), first @ payoffs, payoffs @ second

    def mean(gain: float, other_gain: float) -> float:
        return float(gain + weight * other_gain) / 2

    right = mean(best - now, now - least)
    return {
        "": right,
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


def pairs(seed: int) -> list[Pair]:
    """Return games and policies; other seeds add another number to all payoffs, and turn the tables round."""
    added, turned = (seed * 3) % 5, slice(None, None, -1 if seed % 2 else 1)
    return [
        Pair(np.array(payoffs, float)[turned] + added, np.array(first)[turned], np.array(second))
        for payoffs, first, second in PAIRS
    ]


def exercise_1(answer: Any, seed: int, weight: Weight = 1.0) -> str:
    """Check the exploitability of policies in a zero-sum game of one move."""
    require_function("exploitability", answer, "payoffs, first and second")
    cases = []
    for pair in pairs(seed):
        call = f"exploitability({_rows(pair.payoffs)}, {in_brackets(pair.first)}, {in_brackets(pair.second)})"
        with student_code(call):
            found = answer(*(part.copy() for part in pair))
        wrong = _exploitability(pair, weight)
        cases.append(NumberCase(call, number(call, found), wrong.pop(""), wrong))
    compare_all(cases)
    if weight != 1.0:
        return f"Right: both gains are exact, and that of player 1 counts {weight} times."
    return "Right: player 1 gets the opposite, so what both get now drops out, and two best answers are enough."


def _rows(table: Any) -> str:
    return f"[{', '.join(map(in_brackets, table))}]"


GAMES = ((3.0, -1.0, -2.0, 5.0), (-4.0, 2.0, 1.0, -1.0), (0.0, 6.0, 2.0, -3.0), (-1.0, -7.0, -5.0, -2.0))
"""Payoffs a, b, c, d of games [[a, b], [c, d]] in which no action is safe."""


def _mixed(payoffs: Reals) -> dict[str, float]:
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
    }


def games_of(seed: int) -> list[Reals]:
    """Return games in which no action is safe; with other seeds a number is added to all payoffs."""
    return [np.array(payoffs).reshape(2, 2) + seed % 4 for payoffs in GAMES]


Share = Annotated[
    float,
    Own(
        tuple(k / 50 for k in range(20, 96) if k != 50),
        "Column 1 pays otherwise: in your version each of its payoffs counts {share} times what the table says.",
    ),
]


def exercise_2(answer: Any, seed: int, share: Share = 1.0) -> str:
    """Check the safe policy in a game with two actions each, of which one column may pay less or more."""
    require_function("safe_probability", answer, "payoffs")
    cases = []
    for payoffs in games_of(seed):
        call = f"safe_probability({_rows(payoffs)})"
        with student_code(call):
            found = answer(payoffs.copy())
        wrong = _mixed(payoffs * (1.0, share))
        cases.append(NumberCase(call, number(call, found), wrong.pop(""), wrong))
    compare_all(cases)
    return "Right: player 1 gets the same from both columns, so it cannot use what it knows of your policy."


class Step(NamedTuple):
    """A step of a game, as player 0 sees it."""

    state: int
    action: int
    other_action: int
    reward: float
    next_state: int
    terminated: bool


N_STATES, N_ACTIONS, N_OTHERS = 4, 2, 3


def updated(
    Q: Reals,
    V: Reals,
    step: Step,
    *,
    future: str = "V",
    entry: str = "both",
    value: str = "minimax",
    where: str = "state",
    ends: str = "right",
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    sign: float = 1.0,
    cost: float = 0.0,
) -> None:
    """Do an update of minimax Q in place, where a step has a cost; other arguments than the defaults are mistakes."""
    s, a, o, reward, then, terminated = step
    before = Q[s].copy()
    ahead = {
        "V": lambda: V[then],
        "old": lambda: V[s],
        "max": lambda: Q[then].max(),
        "own": lambda: Q[then, :, o].max(),
        "safe": lambda: Q[then].min(axis=1).max(),
        "same": lambda: Q[then, a, o],
    }[future]()
    over = {"right": terminated, "never": False, "inverted": not terminated}[ends]
    target = sign * reward - cost + (0.0 if over else discount * ahead)
    if entry == "both":
        Q[s, a, o] += learning_rate * (target - Q[s, a, o])
    elif entry == "own":
        Q[s, a] += learning_rate * (target - Q[s, a])
    elif entry == "next":
        Q[then, a, o] += learning_rate * (target - Q[then, a, o])
    else:
        Q[s, a, o] = learning_rate * (target - Q[s, a, o])
    if where == "nowhere":
        return
    k = then if where == "next" else s
    values: dict[str, Callable[[], Any]] = {
        "minimax": lambda: solve_zero_sum(Q[k]).value,
        "max": lambda: Q[k].max(),
        "safe": lambda: Q[k].min(axis=1).max(),
        "second": lambda: Q[k].max(axis=0).min(),
        "mean": lambda: Q[k].mean(axis=1).max(),
        "target": lambda: target,
        "before": lambda: solve_zero_sum(before).value,
        "columns": lambda: solve_zero_sum(Q[k].T).value,
    }
    V[k] = values[value]()


UPDATE_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "V is not changed: after Q it is the value of the matrix game Q[state]": {"where": "nowhere"},
    "the value of the *next* state is solved anew; it is Q[state] that has changed": {"where": "next"},
    "V is the largest entry of Q[state], as if the other player wanted it too; it is the value of the game": {
        "value": "max"
    },
    "V is what the best single action guarantees, max_a min_o Q; a random choice may guarantee more": {"value": "safe"},
    "V is min_o max_a Q, as if you saw the other's action before you choose": {"value": "second"},
    "V is the best *mean* over the other's actions, as if it tossed a coin": {"value": "mean"},
    "V is set to the target of one step; it is the value of the matrix game Q[state]": {"value": "target"},
    "the game is solved before Q changes; first Q, then V": {"value": "before"},
    "rows and columns have changed places: your actions are the rows of Q[state], and you want a high payoff": {
        "value": "columns"
    },
    "the target has max Q[next_state], as if the other player wanted it too; it is V[next_state]": {"future": "max"},
    "the target takes for granted that the other repeats its action: max_a Q[next_state, a, other_action]; it is"
    " V[next_state]": {"future": "own"},
    "the target has max_a min_o Q[next_state]; a random choice may guarantee more: it is V[next_state]": {
        "future": "safe"
    },
    "the target has Q[next_state, action, other_action]; neither need do the same again": {"future": "same"},
    "the target has V[state]; the future begins in the next state": {"future": "old"},
    "the value of the next state counts after the end; a terminal state has no future, so the target is the reward": {
        "ends": "never"
    },
    "`terminated` is the wrong way round: the value of the next state counts where the game goes on": {
        "ends": "inverted"
    },
    "all entries of Q[state, action] change; the other's action has a number of its own": {"entry": "own"},
    "Q[next_state, ...] changes; the pair of actions was taken in `state`": {"entry": "next"},
    "`=` where `+=` is needed: the old value is lost": {"entry": "lost"},
    "the whole way to the target is gone, as with α = 1; it is 0.5": {"learning_rate": 1.0},
    "the discount is missing: γ is 0.9": {"discount": 1.0},
    "the value of the next state is missing in the target": {"discount": 0.0},
    "the reward counts with the wrong sign; it is your own": {"sign": -1.0},
}
"""What each mistake changes in `updated`."""


class Case(NamedTuple):
    """Tables, and a step."""

    Q: Reals
    V: Reals
    step: Step


def cases_of(seed: int) -> list[Case]:
    """Make up tables and steps: ordinary ones, ends, and steps that stay in their state."""
    rng = np.random.default_rng([seed, 13])
    made = []
    for k in range(12):
        Q = rng.integers(-8, 9, (N_STATES, N_ACTIONS, N_OTHERS)) / 2.0
        V = rng.integers(-8, 9, N_STATES) / 2.0
        s, then = map(int, rng.choice(N_STATES, 2, replace=False))
        a, o = int(rng.integers(N_ACTIONS)), int(rng.integers(N_OTHERS))
        reward = float(rng.choice([-2.0, -1.0, 1.0, 3.0]))
        made.append(Case(Q, V, Step(s, a, o, reward, s if k % 6 == 5 else then, k % 3 == 1)))
    return made


Cost = Annotated[float, step_cost()]


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check an update of minimax Q, where a step may have a cost."""
    require_function("learn", answer, "Q, V, state, action, other_action, reward, next_state and terminated")
    cases, found = cases_of(seed), list[tuple[Reals, Reals]]()
    for Q, V, step in cases:
        mine = Q.copy(), V.copy()
        with student_code(f"learn(Q, V, {_told(step)})"):
            answer(*mine, *step)
        found.append(mine)
    for case, mine in zip(cases, found, strict=True):
        right = _after(case, {}, cost)
        for name, table, expected in zip("QV", mine, right, strict=True):
            if len(wrong := differing(expected, table)):
                place = tuple(map(int, wrong[0]))
                why = _why(cases, found, cost)
                raise WrongAnswer(_difference(case, name, place, expected[place], table[place], why, cost))
    return "Right: it is Q-learning with one change. The value of a state is that of its matrix game."


def _told(step: Step) -> str:
    return ", ".join(f"{name}={value:g}" if name == "reward" else f"{name}={value}" for name, value in _named(step))


def _named(step: Step) -> list[tuple[str, Any]]:
    return [*step._asdict().items()]


def _after(case: Case, mistake: Mapping[str, Any], cost: float = 0.0) -> tuple[Reals, Reals]:
    tables = case.Q.copy(), case.V.copy()
    updated(*tables, case.step, cost=cost, **mistake)
    return tables


def _why(cases: Sequence[Case], found: Sequence[tuple[Reals, Reals]], cost: float) -> str:
    """Return the mistake that explains all cases."""
    if all(all_same(case.Q, Q) and all_same(case.V, V) for case, (Q, V) in zip(cases, found, strict=True)):
        return NOTHING

    def everywhere(mistake: Mapping[str, Any]) -> bool:
        return all(
            all_same(expected, table)
            for case, mine in zip(cases, found, strict=True)
            for expected, table in zip(_after(case, mistake, cost), mine, strict=True)
        )

    return mistake_that_fits(UPDATE_MISTAKES, everywhere, otherwise=UNUSUAL)


NOTHING = "`learn` changes neither Q nor V: write into the arrays that it is given, Q[...] += ... and V[state] = ..."


def _difference(
    case: Case, name: str, place: tuple[int, ...], expected: float, found: float, why: str, cost: float
) -> str:
    """Return the sentence about the first entry that is wrong, with what is needed to work it out by hand."""
    step = case.step
    before = float((case.Q if name == "Q" else case.V)[place])
    known = f"V[{step.next_state}] = {case.V[step.next_state]:g}"
    if name == "V":
        known = f"Q[{step.state}] = {_rows(_after(case, {}, cost)[0][step.state])} by then"
    index = ", ".join(map(str, place))
    should = (
        f"go from {digits(before, found)} to {digits(expected, found)}"
        if before != expected
        else f"stay {digits(before, found)}"
    )
    return (
        f"after learn(Q, V, {_told(step)}), where {known}, {name}[{index}] should {should}, but is"
        f" {digits(found, expected)}: {why}{told_less(cost)}"
    )
