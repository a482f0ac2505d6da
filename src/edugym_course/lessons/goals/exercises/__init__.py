"""The exercises of lesson 11: the greedy action for a goal, 'final', and the goals of 'future'."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from itertools import pairwise
from typing import Annotated, Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import FAR_BELOW, starts, telling_draw
from edugym_course.grading.choices import ChoiceCase, action_of, check_all_choices
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import mistake_that_fits
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given, in_brackets, require_unchanged
from edugym_course.lessons.goals.exercises.relabelling import Step, Transition, relabelled, typed, why_relabelled

N_PATTERNS, N_ACTIONS = 5, 3

Values = tuple[Reals, int, int]
"""A table Q of shape (patterns, patterns, actions), a state and a goal."""


def _best(row: Any) -> int:
    return int(np.argmax(row))


def _right(Q: Reals, s: int, g: int) -> int:
    return _best(Q[s, g])


def _taken(rule: Callable[[Reals, int, int], int], case: Values) -> int:
    return rule(*case)


def _from(start: int, Q: Reals, s: int, g: int) -> int:
    return _best(Q[s, g]) if Q[s, g].max() > -start else 0


GREEDY_MISTAKES: Mapping[str, Callable[[Reals, int, int], int]] = {
    "the indices have changed places: the state comes first, then the goal": lambda Q, s, g: _best(Q[g, s]),
    "the action with the *lowest* value is taken": lambda Q, s, g: _best(-Q[s, g]),
    "the goal is left out: the best action for *some* goal is taken": lambda Q, s, g: _best(Q[s].max(axis=0)),
    "the goal is left out: the values are averaged over all goals": lambda Q, s, g: _best(Q[s].mean(axis=0)),
    "the state is left out: the values are averaged over all states": lambda Q, s, g: _best(Q[:, g].mean(axis=0)),
    "the search goes over the values of all goals, and so the number is none of an action": lambda Q, s, g: _best(Q[s]),
    "it looks up Q[state, state], as if the goal were there already": lambda Q, s, g: _best(Q[s, s]),
    "it looks up Q[goal, goal]; the first index is the state": lambda Q, s, g: _best(Q[g, g]),
    "the goal is left out: it looks up Q[state, 0], whatever the goal is": lambda Q, s, g: _best(Q[s, 0]),
    "the values are cut to whole numbers, and two that differ look alike": lambda Q, s, g: _best(Q[s, g].astype(int)),
    "the value that is largest in *size* is taken; −8 is lower than −1": lambda Q, s, g: _best(np.abs(Q[s, g])),
    "the value closest to 0 is taken, and not the highest": lambda Q, s, g: _best(-np.abs(Q[s, g])),
    "the number is too high by 1: the first action is 0": lambda Q, s, g: _best(Q[s, g]) + 1,
    "the second highest value is taken": lambda Q, s, g: int(np.argsort(Q[s, g])[-2]),
    "each value is compared with the first alone: keep the highest one so far": lambda Q, s, g: int(
        np.flatnonzero(Q[s, g] >= Q[s, g, 0])[-1]
    ),
    "it is always the last action, whatever the values are": lambda Q, s, g: Q.shape[2] - 1,
    "action 0 is left out: begin the search there": lambda Q, s, g: _best(Q[s, g, 1:]) + 1,
    "the last action is left out: range(n) ends at n − 1": lambda Q, s, g: _best(Q[s, g, :-1]),
    "it is always action 0: is a `return` reached before all actions were looked at?": lambda Q, s, g: 0,
    **starts(
        lambda start: f"the search for the highest value starts from {start}, and all values may be lower",
        lambda start: partial(_from, start),
    ),
}
"""Which action each mistake takes."""


HIGHEST = (3.0, 0.0, -0.5, -5.0, -50.0, -500.0, -FAR_BELOW)
"""The highest values of made-up rows: a search that starts too high misses those below its start."""


def _values(rng: np.random.Generator) -> list[Values]:
    """Make up tables with other values for every state, goal and action; the best two of a row are close."""
    made = list[Values]()
    numbers = np.arange(0.0, 0.5 * N_PATTERNS * N_PATTERNS * N_ACTIONS, 0.5)
    for highest in 2 * HIGHEST:
        Q = rng.permutation(numbers).reshape(N_PATTERNS, N_PATTERNS, N_ACTIONS)
        state, goal = map(int, rng.choice(N_PATTERNS, 2, replace=False))
        Q += highest - Q[state, goal].max()
        second = int(rng.choice(np.flatnonzero(Q[state, goal] < highest)))
        Q[state, goal, second] = highest - 0.25
        made.append((Q, state, goal))
    return made


Dear = Annotated[
    float,
    Own(
        tuple((25 * k + 10) / 100 for k in range(1, 42)),
        "Switch 0 is hard to flip: in your version the value of action 0 counts less by {dear}.",
    ),
]


def _beside(dear: float, rng: np.random.Generator) -> list[Values]:
    """Make up tables in which action 0 leads by a little more than `dear`, and by a little less."""
    made = list[Values]()
    for lead in (dear + 0.1, dear - 0.1):
        Q = rng.choice(np.arange(-4.0, 4.5, 0.5), (N_PATTERNS, N_PATTERNS, N_ACTIONS))
        Q[1, 2] = 1.5 + lead, 1.5, 1.0
        made.append((Q, 1, 2))
    return made


def exercise_1(answer: Any, seed: int, dear: Dear = 0.0) -> str:
    """Check the greedy action for a goal, where the value of action 0 may count less."""
    require_function("greedy", answer, "Q, state and goal")
    rules = [partial(_taken, rule) for rule in (_right, *GREEDY_MISTAKES.values())]
    cases, found, calls = _values(telling_draw(seed, _values, rules)), [], []
    if dear:
        cases += _beside(dear, np.random.default_rng(seed))
    for Q, state, goal in cases:
        call = f"greedy(Q, {state}, {goal}), where Q[{state}, {goal}] = {in_brackets(Q[state, goal])},"
        with student_code(call):
            action = answer(Q.copy(), state, goal)
        given(f"greedy(Q, {state}, {goal})", action)
        if isinstance(action, float | np.floating) and action == Q[state, goal].max():
            raise WrongAnswer(f"{call} gives {action:g}, the highest value; its action is wanted, so the place of it")
        if not isinstance(action, int | np.integer):
            action_of(call, action, N_ACTIONS)  # which refuses it
        calls.append(call)
        found.append(int(action))
    cases = [(Q - dear * (np.arange(N_ACTIONS) == 0), state, goal) for Q, state, goal in cases]
    for (Q, state, goal), call, action in zip(cases, calls, found, strict=True):
        if (expected := _right(Q, state, goal)) != action:

            def everywhere(mistake: Callable[..., int]) -> bool:
                return all(mistake(*case) == taken for case, taken in zip(cases, found, strict=True))

            why = mistake_that_fits(GREEDY_MISTAKES, everywhere, otherwise=NO_USUAL_ACTION)
            taken = action if why in GREEDY_MISTAKES else action_of(call, action, N_ACTIONS)
            raise WrongAnswer(f"{call} should give action {expected}, but gives {taken}: {why}")
    return "Right: one table for all goals. For another goal the same state has another best action."


NO_USUAL_ACTION = "that is none of the usual mistakes, so look at one row Q[state, goal] by hand"

EPISODES = (
    [(0, 0, 4), (4, 1, 6), (6, 0, 2), (2, 0, 6), (6, 2, 7), (7, 2, 6)],  # it reaches its last pattern three times
    [(5, 1, 7), (7, 0, 3), (3, 0, 7), (7, 1, 5)],  # its last pattern is that of its start
    [(1, 2, 0)],
    [(3, 0, 7), (7, 1, 5), (5, 2, 4)],
    [(6, 2, 7), (7, 0, 3), (3, 0, 7), (7, 2, 6), (6, 1, 4), (4, 1, 6), (6, 0, 2)],  # tells all mistakes of 'future'
)
"""Episodes with three switches; the patterns are numbered as binary numbers."""
N_OF_THREE = 8
"""The number of patterns of three switches."""
SEVEN_MORE = 0b1110000000
"""The same with seven more switches: large numbers show an answer that counts on three switches, or on `is`."""


def episodes_of(seed: int) -> list[list[Step]]:
    """Return the episodes with some switches turned, so that other seeds have other numbers."""
    turned = int(np.random.default_rng(seed).integers(8))
    return [[(s ^ turned, a, then ^ turned) for s, a, then in steps] for steps in EPISODES]


Cost = Annotated[
    float,
    Own(
        tuple(k / 20 for k in range(22, 82) if k % 20),
        "Your Switches are dear ones: in your version the reward of a step that misses its goal is −{cost}, not −1.",
    ),
]


def exercise_2(answer: Any, seed: int, cost: Cost = 1.0) -> str:
    """Check the relabelling 'final', where a step that misses may cost something else than 1."""
    require_function("final", answer, "steps")
    cases = [*episodes_of(seed), [(s ^ SEVEN_MORE, a, then ^ SEVEN_MORE) for s, a, then in EPISODES[0]]]
    found = [_transitions(answer, steps) for steps in cases]
    for steps, mine in zip(cases, found, strict=True):
        right = relabelled(steps, cost=cost)
        if mine != right:
            why = why_relabelled(cases, found, cost)
            if len(mine) != len(right):
                raise WrongAnswer(f"final({steps}) should give {len(right)} transitions, but gives {len(mine)}: {why}")
            t = next(t for t in range(len(right)) if mine[t] != right[t])
            raise WrongAnswer(f"final({steps}) should give {right[t]} for step {t}, but gives {mine[t]}: {why}")
    return (
        "Right: the steps are those that were taken, and the reward function is that of the task. Only the goal is new."
    )


def _transitions(answer: Any, steps: Sequence[Step]) -> list[Transition]:
    """Return what a student's function gives, as transitions.

    Raises:
        WrongAnswer: it is something else.
    """
    call, mine = f"final({steps})", [*steps]
    with student_code(call):
        found = answer(mine)
        given(call, found)
        found = [*found] if isinstance(found, Iterable) else [found]
    require_unchanged(call, "steps", mine, steps)
    for one in found:
        if not isinstance(one, tuple | list | np.ndarray) or len(one) != 6:
            raise WrongAnswer(
                f"{call} should give a list of transitions (state, goal, action, reward, next_state, terminated), but"
                f" one of them is {one!r}"
            )
        if text := next((repr(part) for part in one if isinstance(part, str)), None):
            raise WrongAnswer(f"{call} should give transitions of numbers, but one of these holds the text {text}")
    with student_code(call):
        return [typed(one) for one in found]


FUTURE_MISTAKES: Mapping[str, Callable[[Sequence[Step], int], Sequence[int]]] = {
    "steps before t are drawn too; what was achieved before a step is not its future": lambda steps, t: [
        then for _, _, then in steps
    ],
    "the step t itself is never drawn; it achieves a pattern too": lambda steps, t: [
        then for _, _, then in steps[t + 1 :]
    ],
    "the last step is never drawn: `rng.integers(t, n)` leaves n out, not n − 1": lambda steps, t: [
        then for _, _, then in steps[t:-1]
    ],
    "the pattern *before* the step that was drawn is taken; the step achieves its next state": lambda steps, t: [
        state for state, _, _ in steps[t:]
    ],
    "that is 'final': always what the last step achieved": lambda steps, t: [steps[-1][2]],
    "it is always what step t itself achieved; draw one of the steps from t on": lambda steps, t: [steps[t][2]],
    "every *pattern* is as likely, and every *step* should be": lambda steps, t: [*{then for _, _, then in steps[t:]}],
    "that is the number of the step that was drawn; its next state is wanted": lambda steps, t: [*range(t, len(steps))],
    "the draw begins at step 0, and so ends too early: add t to what is drawn": lambda steps, t: [
        then for _, _, then in steps[: len(steps) - t]
    ],
    "that is the *action* of the step that was drawn; its next state is wanted": lambda steps, t: [
        action for _, action, _ in steps[t:]
    ],
    "only steps up to t are drawn: what was achieved until then, and not from then on": lambda steps, t: [
        then for _, _, then in steps[: t + 1]
    ],
}
"""Among which patterns, each as likely, each mistake draws the goal."""


Gap = Annotated[
    int,
    Own(
        tuple(range(1, 46)),
        "In your version `future_goal` draws only from the steps from number `t + {gap}` on, each with the same"
        " probability. Where the episode has no such step, it takes the last one.",
    ),
]


def exercise_3(answer: Any, seed: int, gap: Gap = 0) -> str:
    """Check the goals of 'future', of which only those far away may count."""
    require_function("future_goal", answer, "steps, t and rng")
    *_, short, _, long = episodes_of(seed)
    cases = [(long, 2), (long, 0), (long, 5), (long, len(long) - 1), (short, 0)]
    if gap:
        cases.append((_turning(gap + 1), 1))
    check_all_choices(
        "future_goal(steps, t, rng)",
        [_future(partial(_drawn, answer, steps, t), steps, t, min(t + gap, len(steps) - 1)) for steps, t in cases],
    )
    return (
        "Right: every step from t on is as likely. The pattern that it reached is a goal that step t was on the way to."
    )


def _drawn(answer: Any, steps: Sequence[Step], t: int, rng: np.random.Generator) -> Any:
    mine = [*steps]
    found = answer(mine, t, rng)
    require_unchanged("future_goal(steps, t, rng)", "steps", mine, steps)
    return found


def _future(choose: Callable[[np.random.Generator], Any], steps: Sequence[Step], t: int, first: int) -> ChoiceCase:
    """Return what should be drawn for step t, if the steps from `first` on count, and what the mistakes draw."""
    wrong = {why: draws(steps, first) for why, draws in FUTURE_MISTAKES.items()}
    return ChoiceCase(
        choose,
        shares_of([then for _, _, then in steps[first:]]),
        {why: shares_of(goals) for why, goals in wrong.items() if goals and max(goals) < N_OF_THREE},
        tables={},
        where=f"where t = {t} and steps = {steps}",
        noun="pattern",
    )


def _turning(n_steps: int) -> list[Step]:
    """Return an episode of so many steps between two patterns, and three more, which achieve others."""
    patterns = [k % 2 for k in range(n_steps + 1)]  # the start, and what is achieved
    patterns += [patterns[-1] ^ turned for turned in (2, 6, 4)]  # one switch each
    return [(state, (state ^ then) // 2, then) for state, then in pairwise(patterns)]


def shares_of(patterns: Sequence[int]) -> list[float]:
    """Return the probability of each of the eight patterns, if each of those given is as likely."""
    shares: list[float] = (np.bincount(patterns, minlength=N_OF_THREE) / max(len(patterns), 1)).tolist()
    return shares
