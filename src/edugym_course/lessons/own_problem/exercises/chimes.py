"""Exercise 3: a sleeper who gets used to the chime, and a state that knows enough."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from itertools import product
from typing import Annotated, Any

import numpy as np

from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.values import GlobalDraws
from edugym.exact.branching import branches
from edugym.mdp.protocol import Random
from edugym.mdp.task import check_mdp, task_of
from edugym_course.grading.agents import require_class
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import mistake_in_cases
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import digits, given, number, same
from edugym_course.lessons.own_problem.morning import CHIME, RING, Morning


class UsedToChimes(Morning):
    """A sleeper who hears only the first two chimes; the state is (time, depth, chimes)."""

    __slots__ = ()

    def initial(self, rng: Random) -> Any:
        """Fast asleep, and no chime yet."""
        return 0, 2, 0

    def transition(self, state: Any, action: int, rng: Random, mistake: str = "", wakes: float = 0.9) -> Any:
        """A chime after the second is like silence; other values of `mistake` are what students may write.

        `wakes` is the probability with which a ring wakes her.
        """
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
            depth = 0 if luck < wakes else max(depth - 1, 0)
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


Wakes = Annotated[
    float,
    Own(
        tuple(k / 100 for k in range(48, 90) if k not in (50, 70)),
        "Your sleeper sleeps well: in your version a ring wakes her with probability {wakes}, not 0.9, and else makes"
        " her sleep one step lighter, as before.",
    ),
]


def exercise_3(answer: Any, seed: int, wakes: Wakes = 0.9) -> str:
    """Check the class of a morning whose sleeper gets used to the chime, and whom a ring may wake less often."""
    require_class("UsedToIt", answer)
    with student_code("UsedToIt()"):
        mine = answer()
    with student_code("UsedToIt()"), told_as_wrong():
        task_of(mine, "UsedToIt()", MDP_ONLY)
    with student_code("initial(rng)"):
        first = mine.initial(np.random.default_rng(seed))
    if _three("initial(rng)", first) != (0, 2, 0):
        raise WrongAnswer(f"initial should return (0, 2, 0), fast asleep and no chime yet, but returns {first!r}")
    rng = np.random.default_rng(seed)
    states = [(int(rng.integers(1, 7)), depth, chimes) for depth in (2, 1, 0) for chimes in (0, 1, 2)]
    everywhere = product(range(UsedToChimes().length), range(3), range(3))
    for some in (states, everywhere):  # a mistake is named by a few of them; it may be made at one time only
        _compare_ways(mine, UsedToChimes(), [(state, action) for state in some for action in (0, 1, 2)], wakes)
    _compare_the_rest(mine, UsedToChimes())
    with student_code("UsedToIt()"), told_as_wrong():
        check_mdp(mine)
    return "Right: one number more, and the next state depends on the state and the action alone again. See it learn:"


@contextmanager
def told_as_wrong() -> Iterator[None]:
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


def _compare_ways(mine: Any, right: UsedToChimes, steps: Sequence[tuple[Any, int]], wakes: float) -> None:
    """Compare where steps can lead, and with which probabilities; a mistake is best named if it explains all steps."""
    found, expected, draws = [], [], GlobalDraws(type(mine).__name__)
    for state, action in steps:
        call = f"transition({state}, {action}, rng)"
        with told_as_wrong(), draws.refused("transition"), student_code(call):
            found.append(_ways(partial(mine.transition, state, action), call))
        expected.append(_ways(partial(right.transition, state, action, wakes=wakes), call))
    wrong = [not same_ways for same_ways in map(_same, found, expected)]
    if not any(wrong):
        return

    def explained(mistake: str) -> list[bool]:
        ways = (_ways(partial(right.transition, *step, mistake=mistake, wakes=wakes), "") for step in steps)
        return [*map(_same, found, ways)]

    first = wrong.index(True)
    state, action = steps[first]
    number_that_is_wrong = _which_number(found[first], expected[first], state, action, wakes)
    why = mistake_in_cases(USED_MISTAKES, explained, wrong, otherwise=number_that_is_wrong)
    raise WrongAnswer(
        f"transition({state}, {action}, rng) should lead to {_told(expected[first])}, but leads to"
        f" {_told(found[first])}: {why}"
    )


def _which_number(
    found: Mapping[Any, float], expected: Mapping[Any, float], state: Any, action: int, wakes: float
) -> str:
    """Return which of the three numbers of the next state is wrong."""

    def alone(ways: Mapping[Any, float], place: int) -> dict[Any, float]:
        total: dict[Any, float] = {}
        for three, p in ways.items():
            total[three[place]] = total.get(three[place], 0.0) + p
        return total

    time, depth, chimes = (not _same(alone(found, place), alone(expected, place)) for place in range(3))
    if depth and chimes and _same({(t, c, d): p for (t, d, c), p in found.items()}, expected):
        return "depth and chimes have changed places"
    if time:
        return "the time, the first number, should grow by 1"
    if depth and action == RING:
        return (
            f"her depth is wrong: a ring wakes her with probability {wakes:g}, and else makes her sleep one step"
            " lighter"
        )
    if depth and action == CHIME and state[2] < 2:
        return "her depth is wrong: a chime that she hears makes her sleep one step lighter with probability 0.7"
    if depth:
        return (
            "her depth is wrong: in silence, and with a chime that she does not hear, her sleep gets one step deeper"
            " with probability 0.5, and 2 is the deepest"
        )
    return "the third number is wrong: every chime counts, whether she hears it or not, up to 2, and nothing else does"


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
