"""The exercises of lesson 13: how exploitable a pair is, a safe policy, and the update of minimax Q."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Any

from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import UNUSUAL, NumberCase, compare_all, mistake_that_fits
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import all_same, differing, digits, in_brackets, number, require_unchanged
from edugym_course.lessons.several_agents.exercises.gains import Pair, exploitability, games_of, halves, mixed, pairs
from edugym_course.lessons.several_agents.exercises.update import UPDATE_MISTAKES, Case, Step, cases_of, updated

Weight = Annotated[
    float,
    Own(
        tuple(k / 10 for k in range(13, 90) if k % 10),
        "Player 1 is a dear friend: in your version its gain counts {weight} times, and that of player 0 once. (The"
        " sum is still halved.)",
    ),
]


def exercise_1(answer: Any, seed: int, weight: Weight = 1.0) -> str:
    """Check the exploitability of policies in a zero-sum game of one move."""
    require_function("exploitability", answer, "payoffs, first and second")
    cases = []
    for pair in pairs(seed):
        call = f"exploitability({_rows(pair.payoffs)}, {in_brackets(pair.first)}, {in_brackets(pair.second)})"
        mine = Pair(*(part.copy() for part in pair))
        with student_code(call):
            found = answer(*mine)
        for name, given, before in zip(Pair._fields, mine, pair, strict=True):
            require_unchanged(call, name, given, before)
        wrong = exploitability(pair, weight)
        cases.append(NumberCase(call, number(call, found), wrong.pop(""), wrong, halves(pair, weight)))
    compare_all(cases)
    if weight != 1.0:
        return f"Right: both gains are exact, and that of player 1 counts {weight} times."
    return "Right: player 1 gets the opposite, so what both get now drops out, and two best answers are enough."


def _rows(table: Any) -> str:
    return f"[{', '.join(map(in_brackets, table))}]"


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
            found = answer(mine := payoffs.copy())
        require_unchanged(call, "payoffs", mine, payoffs)
        wrong = mixed(payoffs * (1.0, share))
        cases.append(NumberCase(call, number(call, found), wrong.pop(""), wrong))
    compare_all(cases)
    return "Right: player 1 gets the same from both columns, so it cannot use what it knows of your policy."


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

    return mistake_that_fits(UPDATE_MISTAKES, everywhere, otherwise=_wrong_part(cases, found, cost))


def _wrong_part(cases: Sequence[Case], found: Sequence[tuple[Reals, Reals]], cost: float) -> str:
    """Return which part of an unusual answer is wrong, as far as the right ones tell."""
    right = {
        over: all(
            all_same(_after(case, {}, cost)[0], Q)
            for case, (Q, _) in zip(cases, found, strict=True)
            if case.step.terminated == over
        )
        for over in (False, True)
    }
    if all(right.values()):
        return "Q is right in all cases, so look at V: V[state] is the value of the matrix game Q[state]"
    if right[True]:
        return "Q is right where the game ends, so look at what follows elsewhere: γ times V[next_state]"
    if right[False]:
        return "Q is right where the game goes on, so look at the end: there the target is the reward"
    return UNUSUAL


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
