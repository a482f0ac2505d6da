"""Numbers of a student's own: parameters of an exercise of which each student may get another value.

An exercise declares such a parameter in its signature, after the answer and the seed. Its default is the number of the
ordinary lesson:

    def exercise_1(answer: Any, seed: int, height: Annotated[int, Own(tuple(range(60, 161)), "...")] = 100) -> str:

`edugym assign` draws the values, writes them into the text of each student's lesson, and hands them to its checks.
"""

import hashlib
import hmac
import inspect
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, TypeVar, get_args

from edugym_course.grading.errors import TooSlow, Unsolved, WrongAnswer, nobody_asks_why, only_verdicts
from edugym_course.grading.student_code import student_code

Exercise = Callable[..., str]
Found = TypeVar("Found")

SEARCH_SECONDS = 3.0
"""The seconds of processor time after which no more numbers are tried on a wrong answer."""


@dataclass(frozen=True)
class Own:
    """Declares that each student may get a value of their own.

    Attributes:
        values: the values. They must need different answers, and should be 40 or more, so that two students seldom
            share one.
        text: the sentence that tells a student of this value, with the name of the parameter in braces.
    """

    values: tuple[Any, ...]
    text: str


def step_cost(then: str = "") -> Own:
    """Declare a cost that an agent of a student's own pays at each step, by default 0, with what follows from it.

    Costs are no multiples of 0.05, so that they make no ties between the simple values of made-up tables.
    """
    sentence = "In your version each step costs {cost}: the update uses the reward minus {cost}."
    return Own(tuple(k / 100 for k in range(3, 303, 5)), " ".join(filter(None, [sentence, then])))


def told_less(cost: float) -> str:
    """Say in a sentence about a case that its reward is told less a student's own cost; nothing without one."""
    return f" (your cost of {cost:g} is subtracted from this reward already)" if cost else ""


ExperimentSeed = Annotated[
    int | None,
    Own(
        tuple(range(1000, 10_000)),
        "Your runs have a seed of their own: give `repeat` also `seed={experiment_seed}`.",
    ),
]
"""The seed of the runs that an exercise asks for; None for any, as in the ordinary lesson."""


def own_parameters(exercise: Exercise) -> dict[str, Own]:
    """Return the parameters of an exercise that are declared so, by name."""
    return {
        name: own
        for name, parameter in inspect.signature(exercise).parameters.items()
        for own in get_args(parameter.annotation)[1:]
        if isinstance(own, Own)
    }


def drawn(key: bytes, what: str, most: int) -> int:
    """Return a number from 0 to `most` - 1 that nobody can compute who does not know the key."""
    return int.from_bytes(hmac.digest(key, what.encode(), hashlib.sha256)[:8], "big") % most


def draw_numbers(exercise: Exercise, key: bytes, others: Sequence[Mapping[str, Any]] = ()) -> dict[str, Any]:
    """Return a student's numbers for an exercise, by name; none if it declares none.

    Args:
        exercise: the exercise.
        key: the student's key, which also depends on the teacher's secret.
        others: the numbers of other students. A number that more of them have than another is not drawn, so that all
            are given once before any is given twice.
    """
    numbers = {}
    for name, own in own_parameters(exercise).items():
        given = Counter(numbers_given[name] for numbers_given in others)
        fewest = min(given[value] for value in own.values)
        free = [value for value in own.values if given[value] == fewest]
        numbers[name] = free[drawn(key, f"{exercise.__name__} {name}", len(free))]
    return numbers


def ordinary_numbers(exercise: Exercise) -> dict[str, Any]:
    """Return the numbers of the ordinary lesson, by name; none where it leaves one to the student."""
    parameters = inspect.signature(exercise).parameters
    numbers = {name: parameters[name].default for name in own_parameters(exercise)}
    return {} if None in numbers.values() else numbers


def told(exercise: Exercise, numbers: Mapping[str, Any]) -> str:
    """Return the sentences that tell a student of their numbers."""
    return " ".join(own.text.format(**numbers) for own in own_parameters(exercise).values())


def passes(exercise: Exercise, answer: Any, seed: int, numbers: Mapping[str, Any]) -> bool:
    """Whether an answer is right for some numbers."""
    try:
        with only_verdicts(), student_code("your code"):
            exercise(answer, seed, **numbers)
    except WrongAnswer:
        return False
    return True


def use_your_own(what: str) -> str:
    """Say that something should have a student's own number; the sentence is not one of a mistake."""
    return f"{what}: use your own number, which stands in the text of your exercise"


_FOUND: dict[tuple[Any, str], Any] = {}


def found_once(answer: Any, call: str, ask: Callable[[], Found]) -> Found:
    """Return what a slow answer gives; it is not asked again while other numbers are tried on it.

    Args:
        answer: the student's function.
        call: the call, with its arguments.
        ask: makes the call.
    """
    if not nobody_asks_why() or (answer, call) not in _FOUND:
        _FOUND[answer, call] = ask()
    found: Found = _FOUND[answer, call]
    return found


def numbers_of_others(exercise: Exercise, answer: Any, seed: int, numbers: Mapping[str, Any]) -> dict[str, Any]:
    """Return the numbers for which a wrong answer is right; none if there are none, or none is found soon."""
    end = time.process_time() + SEARCH_SECONDS
    for other in _others(exercise, numbers):
        if passes(exercise, answer, seed, other):
            return other
        if time.process_time() > end:
            break
    return {}


def _others(exercise: Exercise, numbers: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield the numbers of the ordinary lesson, and then all that differ from a student's in one of them."""
    if ordinary := ordinary_numbers(exercise):
        yield ordinary
    for name, own in own_parameters(exercise).items():
        if name in numbers:
            yield from ({**numbers, name: value} for value in own.values if value != numbers[name])


def belongs_to_others(
    exercise: Exercise, answer: Any, seed: int, numbers: Mapping[str, Any], wrong: WrongAnswer
) -> str:
    """Return what to say besides of a wrong answer: that it is right for other numbers, or nothing."""
    if not numbers or isinstance(wrong, Unsolved | TooSlow):
        return ""
    others = numbers_of_others(exercise, answer, seed, numbers)
    if not others:
        return ""
    given = " and ".join(f"{name} = {value}" for name, value in others.items())
    yours = " and ".join(f"{name} = {value}" for name, value in numbers.items())
    return (
        f". This answer is right for {given}, and yours is {yours}: each student has other numbers, so work it out"
        " with those in your text"
    )
