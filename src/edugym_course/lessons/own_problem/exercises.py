"""The exercises of lesson 10: where a policy flips, shaping, a state that knows enough, and a problem of one's own."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from itertools import product
from typing import Any

import numpy as np

from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.values import GlobalDraws
from edugym.exact.branching import branches
from edugym.exact.model import finite_model
from edugym.mdp.protocol import Random
from edugym.mdp.task import check_mdp, task_of
from edugym_course.grading.agents import require_class, require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import compare, digits, given, number, same
from edugym_course.lessons.own_problem.bicycle import Bicycle, is_like
from edugym_course.lessons.own_problem.exact import random_return, solve
from edugym_course.lessons.own_problem.figures import names_of
from edugym_course.lessons.own_problem.morning import RING, Morning

LATE = 59 / 9
"""The cost of oversleeping from which on a ring is best: -4 + 0.1 (1 - c) = 2 - c."""
CLOSE = 0.005
MOST_STATES = 20_000
"""The largest problem of a student's own."""
PLANNING_SECONDS = 300.0
"""The seconds of processor time in which such a problem must be checked and solved."""


def exercise_1(answer: Any, seed: int) -> str:
    """Check the lowest cost of oversleeping for which the clock rings at 8:20 for one who is fast asleep."""
    mistakes = {
        "that is the value with which the cell began": 10.0,
        "a ring fails with probability 0.1; then she is dozing, which is worth 1 and costs `late`": 6.0,
        "compare the ring with staying quiet, which is better there than a chime": 5.2 / 0.9,
        "when the ring fails she is dozing, and that is worth 1": 6.0 / 0.9,
        "who stays asleep has slept: staying quiet is worth 2 − late": 3.9 / 0.9,
        "staying quiet is worth 2 − late, and a failed ring 1 − late, as sleep is worth its depth": 4.0 / 0.9,
        "that is the cost of a ring alone": 4.0,
        "0.9 and 0.1 have changed places: a ring *wakes* her with probability 0.9": 51.0,
        "late is a cost, and the reward function subtracts it: it is above 0": -LATE,
        "that is ten times as much, or the decimal point is in the wrong place": 10 * LATE,
    }

    def says(late: float) -> str:
        told = f"late = {digits(late, LATE)}"
        if late < 0:
            return told
        values = solve(Morning(late=late))
        best = int(values.Q[values.model.row((7, 2))].argmax())
        return f"with {told} it is best to {names_of(values.model.mdp)[best]} at 8:20 when she is fast asleep"

    found = number("late", answer)
    near = abs(found - LATE) < 0.15
    side = "higher than it need be" if found > LATE else "too low for a ring"
    compare(
        "late",
        answer,
        LATE,
        mistakes,
        tolerance=CLOSE,
        says=says,
        otherwise=f"it is {side}" + ("; you are close, round it to two digits after the decimal point" if near else ""),
    )
    return (
        "Right: 59/9. Below it the best clock lets her sleep on when she is fast asleep at 8:20. Nothing in its code"
        " says so but a number."
    )


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
    "when `terminated`, φ(s') is 0, and not φ(s)": lambda r, a, b, end, g: r + g * b - a * (not end),
    "`terminated` is the wrong way round: φ(s') counts when it is False": lambda r, a, b, end, g: r + g * b * end - a,
    "both: when `terminated` is True it is φ(s') that is 0, and not φ(s) when it is False": lambda r, a, b, end, g: (
        r + g * b - a * end
    ),
    "that is the reward alone, without shaping": lambda r, a, b, end, g: r,
    "only φ(s') is discounted, not φ(s)": lambda r, a, b, end, g: r + g * (b * (not end) - a),
    "γ belongs before φ(s'), not before φ(s)": lambda r, a, b, end, g: r + b * (not end) - g * a,
    "the reward itself is not discounted": lambda r, a, b, end, g: g * (r + b * (not end)) - a,
    "the two states have changed places": lambda r, a, b, end, g: r + g * a * (not end) - b,
    "γ φ(s') is missing; it counts unless `terminated`": lambda r, a, b, end, g: r - a,
    "+ φ(s) stands where − φ(s) should": lambda r, a, b, end, g: r + g * b * (not end) + a,
}
"""By the sentence that tells of it, what each mistake gives for the same numbers."""


def exercise_2(answer: Any, seed: int) -> str:
    """Check the function that adds potential-based shaping to a reward."""
    of = "reward, potential, state, next_state, terminated and discount"
    require_function("shaped_reward", answer, of)
    rules = [partial(_by_rule, rule) for rule in (_shaped, *SHAPING_MISTAKES.values())]
    compare_all(
        [
            NumberCase(
                *_shaped_by(answer, told),
                _shaped(*told),
                {why: mistake(*told) for why, mistake in SHAPING_MISTAKES.items()},
            )
            for told in shaping_numbers(telling_draw(seed, shaping_numbers, rules))
        ]
    )
    return "Right: what is given on the way to a state is taken back when it is left. Here are both policies:"


def _by_rule(rule: Callable[..., float], told: Numbers) -> float:
    return rule(*told)


def shaping_numbers(rng: Random) -> list[Numbers]:
    """Make numbers up for three steps; the second one is the last of its episode."""
    made = []
    for terminated in (False, True, False):
        before, after = float(rng.integers(2, 9)), 10.0 + float(rng.integers(2, 9))
        reward, discount = 40.0 + float(rng.integers(1, 6)), float(rng.choice([0.5, 0.75]))
        made.append((reward, before, after, terminated, discount))
    return made


def _shaped_by(answer: Callable[..., Any], told: Numbers) -> tuple[str, float]:
    """Call a student's function on made-up numbers; return the call, and what came."""
    reward, before, after, terminated, discount = told
    call = (
        f"shaped_reward({reward:g}, potential, 'bed', 'door', {terminated}, {discount:g}) with potential('bed') ="
        f" {before:g} and potential('door') = {after:g}"
    )

    def potential(state: str) -> float:
        return {"bed": before, "door": after}[state]

    with student_code(call):
        found = answer(reward, potential, "bed", "door", terminated, discount)
    return call, number(call, found)


class UsedToChimes(Morning):
    """A sleeper who hears only the first two chimes; the state is (time, depth, chimes)."""

    __slots__ = ()

    def initial(self, rng: Random) -> Any:
        """Fast asleep, and no chime yet."""
        return 0, 2, 0

    def transition(self, state: Any, action: int, rng: Random, mistake: str = "") -> Any:
        """A chime after the second is like silence; other values of `mistake` are what students may write."""
        time, depth, chimes = state
        before = chimes
        counted = {"rings": action > 0, "all": True, "none": False}.get(mistake, action == 1)
        chimes = chimes + 1 if counted else chimes
        if mistake != "uncapped":
            chimes = min(chimes, 2)
        if mistake == "resets" and action != 1:
            chimes = 0
        if mistake == "heard only":
            chimes = min(before + 1, 2) if action == 1 and before < 2 and depth > 0 else before
        heard = action == 1 and (chimes if mistake == "first" else before) < 2
        if mistake == "deaf":
            heard = action == 1
        luck = rng.random()
        if action == RING and not (mistake == "deaf to rings" and before == 2):
            depth = 0 if luck < 0.9 else max(depth - 1, 0)
        elif heard:
            depth = max(depth - 1, 0) if luck < 0.7 else depth
        elif action == 0 or mistake != "as it was":
            depth = min(depth + 1, 2) if luck < 0.5 else depth
        return (time if mistake == "no time" else time + 1), depth, chimes


USED_MISTAKES = {
    "the second chime does nothing any more: look at how many chimes came *before* this one": "first",
    "she hears every chime; after two of them a chime should be like silence (is it `chimes < 2`?)": "deaf",
    "after two chimes a ring does nothing any more: she is deaf to chimes only": "deaf to rings",
    "rings are counted as well; count chimes only": "rings",
    "every action is counted; count a chime only": "all",
    "chimes are not counted: the third number has to grow with every chime": "none",
    "the count goes on above 2, and leaves the observation space: keep it at 2": "uncapped",
    "the count is set back by another action; she does not unlearn what she is used to": "resets",
    "a chime that she does not hear leaves her sleep as it is; it should be like silence, in which it gets deeper": (
        "as it was"
    ),
    "a chime counts also when she is awake": "heard only",
    "the time stands still: the first number has to grow by 1": "no time",
}


def exercise_3(answer: Any, seed: int) -> str:
    """Check the class of a morning whose sleeper gets used to the chime."""
    require_class("UsedToIt", answer)
    with student_code("UsedToIt()"):
        mine = answer()
    with _told_as_wrong():
        task_of(mine, "UsedToIt()", MDP_ONLY)
    with student_code("initial(rng)"):
        first = mine.initial(np.random.default_rng(seed))
    if _three("initial(rng)", first) != (0, 2, 0):
        raise WrongAnswer(f"initial should return (0, 2, 0), fast asleep and no chime yet, but returns {first!r}")
    rng = np.random.default_rng(seed)
    states = [(int(rng.integers(1, 7)), depth, chimes) for depth in (2, 1, 0) for chimes in (0, 1, 2)]
    _compare_ways(mine, UsedToChimes(), [(state, action) for state in states for action in (0, 1, 2)])
    _compare_the_rest(mine, UsedToChimes())
    with _told_as_wrong():
        check_mdp(mine)
    return "Right: one number more, and the next state depends on the state and the action alone again. See it learn:"


@contextmanager
def _told_as_wrong() -> Iterator[None]:
    """Take what is refused as an MDP for a wrong answer, with the same sentence."""
    try:
        yield
    except ValueError as error:
        raise WrongAnswer(str(error)) from None


def _three(call: str, state: Any) -> tuple[Any, ...]:
    """Return a state of three numbers as a plain tuple.

    Raises:
        WrongAnswer: it is something else, such as a list, which cannot be a state here.
    """
    given(call, state)
    if not isinstance(state, tuple) or len(state) != 3:
        kind = "" if isinstance(state, tuple) else f", of the type {type(state).__name__}"
        raise WrongAnswer(
            f"{call} should return three numbers in a tuple, (time, depth, chimes), but returns {state!r}{kind}"
        )
    return tuple(state)


AS_IT_WAS = "that method was right as it was, for only `observation_space`, `initial` and `transition` change"


def _compare_the_rest(mine: Any, right: UsedToChimes) -> None:
    """Compare the observation space, and the methods that should not change, in all states."""
    last, rng = right.length, np.random.default_rng(0)
    with student_code("observation_space"):
        space = mine.observation_space
    if [*getattr(space, "nvec", ())] != [last + 1, 3, 3]:
        raise WrongAnswer(
            "observation_space should be MultiDiscrete([self.length + 1, 3, 3]), one number for each part of"
            f" the state, but is {space}"
        )
    for state in product(range(last + 1), range(3), range(3)):
        call = f"terminal({state})"
        with student_code(call):
            ends = bool(mine.terminal(state))
        if ends != right.terminal(state[:2]):
            raise WrongAnswer(f"{call} should be {not ends}, but is {ends}: {AS_IT_WAS}")
        call = f"observation({state}, rng)"
        with student_code(call):
            seen = mine.observation(state, rng)
        if not np.array_equal(seen, state):
            raise WrongAnswer(f"{call} should be the whole state, but is {seen!r}: {AS_IT_WAS}")
    for state, action in product(product(range(last), range(3), range(3)), range(3)):
        for _, after in branches(partial(right.transition, state, action)):
            call = f"reward({state}, {action}, {after}, rng)"
            with student_code(call):
                found = mine.reward(state, action, after, rng)
            expected, paid = right.reward(state[:2], action, after[:2], rng), number(call, found)
            if not same(paid, expected):
                raise WrongAnswer(
                    f"{call} should be {digits(expected, paid)}, but is {digits(paid, expected)}: {AS_IT_WAS}"
                )


def _compare_ways(mine: Any, right: UsedToChimes, steps: Sequence[tuple[Any, int]]) -> None:
    """Compare where steps can lead, and with which probabilities; a mistake is best named if it explains all steps."""
    found, expected, draws = [], [], GlobalDraws(type(mine).__name__)
    for state, action in steps:
        call = f"transition({state}, {action}, rng)"
        with _told_as_wrong(), draws.refused("transition"), student_code(call):
            found.append(_ways(partial(mine.transition, state, action), call))
        expected.append(_ways(partial(right.transition, state, action), call))
    wrong = [k for k, ways in enumerate(found) if not _same(ways, expected[k])]
    if not wrong:
        return

    def explained(mistake: str, places: Sequence[int]) -> bool:
        return all(_same(found[k], _ways(partial(right.transition, *steps[k], mistake=mistake), "")) for k in places)

    whys = [
        why for places in (range(len(steps)), wrong[:1]) for why, m in USED_MISTAKES.items() if explained(m, places)
    ]
    why = [*whys, "that is none of the usual mistakes: write down by hand what can happen"][0]
    (state, action), first = steps[wrong[0]], wrong[0]
    raise WrongAnswer(
        f"transition({state}, {action}, rng) should lead to {_told(expected[first])}, but leads to"
        f" {_told(found[first])}: {why}"
    )


def _ways(draw: Callable[[Any], Any], call: str) -> dict[Any, float]:
    total: dict[Any, float] = {}
    for p, state in branches(draw):
        three = _three(call, state)
        total[three] = total.get(three, 0.0) + p
    return total


def _same(found: Mapping[Any, float], expected: Mapping[Any, float]) -> bool:
    return {*found} == {*expected} and all(abs(found[s] - expected[s]) < 1e-9 for s in found)


def _told(ways: Mapping[Any, float]) -> str:
    return " or ".join(f"{state} (p = {p:.2g})" for state, p in sorted(ways.items()))


def _require_small(mdp: Any) -> None:
    try:
        finite_model(mdp, max_states=MOST_STATES)
    except ValueError as error:
        if "max_states" not in str(error):
            raise
        raise WrongAnswer(
            f"my_problem has more than {MOST_STATES} states: does a number in its state grow without end? Give it a"
            " largest value, for example by min(queue + 1, 10)"
        ) from None


def exercise_4(answer: Any, seed: int) -> str:
    """Check that a student's own problem is one: it runs, chance and decisions matter, and no one action is best."""
    given("my_problem", answer)
    if type(answer).__name__ == "Template" or is_like(type(answer), Bicycle):
        raise WrongAnswer("that is the problem with which the cell began: write one of your own, under its own name")
    if isinstance(answer, Morning) or type(answer).__name__ == "Morning" or is_like(type(answer), Morning):
        raise WrongAnswer("that is the problem of the lesson: write one of your own, under its own name")
    with student_code("my_problem"), _told_as_wrong():
        task_of(answer, "my_problem", MDP_ONLY)
    kind = type(answer)
    if not issubclass(kind, tuple):
        raise WrongAnswer(
            f"{kind.__name__} should inherit from NamedTuple, as the form does: class {kind.__name__}(NamedTuple), with"
            " its numbers as fields and without __init__"
        )
    if task_of(answer).max_steps is not None:
        raise WrongAnswer(
            "my_problem has `max_steps`, so the best action depends on how many steps are left: keep the time in the"
            " state, and end the episode by `terminal`, as Morning does"
        )
    with student_code("my_problem", limit=PLANNING_SECONDS):
        check_mdp(answer)
        _require_small(answer)
        values = solve(answer)
    model = values.model
    policy, live = values.greedy_policy(), ~model.terminal
    if len(model.states) < 4 or policy.shape[1] < 2:
        raise WrongAnswer(
            f"my_problem should have two actions and four states or more, but has {policy.shape[1]} and"
            f" {len(model.states)}"
        )
    if not (((model.probabilities > 0).sum(axis=2) > 1)[live]).any():
        raise WrongAnswer("my_problem should have chance in its dynamics: use `rng` in `transition`")
    if np.ptp(model.rewards[model.probabilities > 0]) == 0:
        raise WrongAnswer("every transition of my_problem has the same reward, so all policies are equal")
    gap = values.start - random_return(answer)
    if gap < 1e-6 * max(1.0, abs(values.start)):
        raise WrongAnswer("the best policy of my_problem earns no more than random actions: do the actions matter?")
    best_always = (policy[live] > 0).all(axis=0)
    if best_always.any():
        name = names_of(answer)[int(best_always.argmax())]
        raise WrongAnswer(
            f"in my_problem the action {name!r} is best in every state, so there is nothing to decide: give it a price"
        )
    return f"A problem: {len(model.states)} states, {policy.shape[1]} actions, optimum {values.start:.4g}."
