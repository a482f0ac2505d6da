"""Whether a program from a blank file repeats itself with one seed, and another seed changes what it does."""

from collections.abc import Callable
from typing import Any

from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import NAME, Environment, run_program


def require_reproducible(
    program: Any, make: Callable[[], Environment], n_steps: int, seed: int, draws: bool = True
) -> None:
    """Refuse a program that does not repeat itself with the same seed or, if it must draw, whose seed changes nothing.

    If it must draw, it must also give its environment another seed where its own is another one.

    Raises:
        WrongAnswer: it is so, or it breaks the contract.
    """
    given = []

    def actions(number: int) -> list[Any]:
        run = run_program(program, make(), n_steps, number, seed)
        given.append(run.given_seed)
        return [step.action for step in run.steps]

    require_repeats(actions(seed), actions(seed), actions(seed + 1) if draws else None, seed)
    if draws and given[0] == given[-1]:
        raise WrongAnswer(
            f"{NAME} calls reset(seed={given[0]}) with seed {seed} and with seed {seed + 1}: give its own `seed` to the"
            " environment, reset(seed=seed)"
        )


def require_repeats(first: list[Any], again: list[Any], other: list[Any] | None, seed: int) -> None:
    """Refuse a program whose actions in two runs with one seed differ, or are those of the next seed.

    Raises:
        WrongAnswer: it is so.
    """
    if first != again:
        raise WrongAnswer(
            f"{NAME} does not repeat itself: two runs with seed {seed} take different actions. Draw every random number"
            " from rng = np.random.default_rng(seed), and make all that it learns inside the function, so that nothing"
            " is left of the run before"
        )
    if first == other:
        raise WrongAnswer(
            f"{NAME} takes the same actions with seed {seed} and with seed {seed + 1}: it should try actions at random,"
            " and draw them from rng = np.random.default_rng(seed)"
        )
