"""The exercises of lesson 10: where a policy flips, shaping, a state that knows enough, and a problem of one's own."""

from typing import Annotated, Any

import numpy as np

from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.mdps import CheckedMDP
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel
from edugym.mdp.tabular import table_sizes
from edugym.mdp.task import check_mdp, task_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.own_numbers import Own, use_your_own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import compare, digits, given, number
from edugym_course.lessons.own_problem.bicycle import Bicycle, is_like
from edugym_course.lessons.own_problem.exact import random_return, solve
from edugym_course.lessons.own_problem.exercises.chimes import exercise_3 as exercise_3
from edugym_course.lessons.own_problem.exercises.chimes import told_as_wrong
from edugym_course.lessons.own_problem.exercises.shaping import exercise_2 as exercise_2
from edugym_course.lessons.own_problem.figures import names_of
from edugym_course.lessons.own_problem.morning import RING, Morning

Ring = Annotated[
    float, Own(tuple(k / 20 for k in range(42, 110) if k != 80), "In your house a ring costs {ring}, not 4.")
]
Price = Annotated[
    float | None,
    Own(
        tuple(k / 100 for k in range(203, 603, 10)),
        "Something in your problem has a price of {price}: in at least one step the"
        " reward must be exactly {price} or -{price}.",
    ),
]
CLOSE = 0.005
MOST_STATES = 20_000
"""The largest problem of a student's own."""
PLANNING_SECONDS = 300.0
"""The seconds of processor time in which such a problem must be checked and solved."""


def exercise_1(answer: Any, seed: int, ring: Ring = 4.0) -> str:
    """Check the lowest cost of oversleeping for which the clock rings at 8:20 for one who is fast asleep."""
    right = (ring + 1.9) / 0.9  # where -ring + 0.1 (1 - c) = 2 - c
    mistakes = {
        "that is the value with which the cell began": 10.0,
        "a ring fails with probability 0.1; then she is dozing, which is worth 1 and costs `late`": ring + 2.0,
        "compare the ring with staying quiet, which is better there than a chime": (ring + 1.2) / 0.9,
        "when the ring fails she is dozing, and that is worth 1": (ring + 2.0) / 0.9,
        "who stays asleep has slept: staying quiet is worth 2 − late": (ring - 0.1) / 0.9,
        "staying quiet is worth 2 − late, and a failed ring 1 − late, as sleep is worth its depth": ring / 0.9,
        "that is the cost of a ring alone": ring,
        "when the ring fails she is dozing, which is worth 1, and no longer fast asleep, worth 2": (ring + 1.8) / 0.9,
        "when the ring fails she dozes, which is worth 1: that speaks for the ring, and so it is subtracted": (
            ring + 2.1
        )
        / 0.9,
        f"the ring itself costs {ring:g}, and that is missing": 1.9 / 0.9,
        "when the ring fails she is late as well, and that costs `late` once more": ring + 1.9,
        "0.9 and 0.1 have changed places: a ring *wakes* her with probability 0.9": (ring + 1.1) / 0.1,
        "late is a cost, and the reward function subtracts it: it is above 0": -right,
        "that is ten times as much, or the decimal point is in the wrong place": 10 * right,
    }

    def says(late: float) -> str:
        told = f"late = {digits(late, right)}"
        if late < 0:
            return told
        values = solve(Morning(late=late, ring=ring))
        worth = values.Q[values.model.row((7, 2))]
        best = names_of(values.model.mdp)[int(worth.argmax())]
        return (
            f"with {told} it is best to {best} at 8:20 when she is fast asleep, for a ring is worth {worth[RING]:.4g}"
            f" there and silence {worth[0]:.4g}"
        )

    found = number("late", answer)
    near = abs(found - right) < 0.06
    side = "higher than it need be" if found > right else "too low for a ring"
    compare(
        "late",
        answer,
        right,
        mistakes,
        tolerance=CLOSE,
        says=says,
        otherwise=f"it is {side}"
        + (
            "; you are close, but is it rounded, and not cut off, to two digits after the decimal point?"
            if near
            else ""
        ),
    )
    return (
        f"Right: {10 * ring + 19:g}/9. Below it the best clock lets her sleep on when she is fast asleep at 8:20."
        " Nothing in its code says so but a number."
    )


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


def _require_an_end(model: FiniteModel) -> None:
    """Refuse a problem in which some policy never comes to an end.

    Left are the states in which an action leads to such states alone, and that is found by taking away all others.
    """
    endless = ~model.terminal
    stays = np.zeros(model.successors.shape[:2], bool)
    while True:
        stays = (endless[model.successors] | (model.probabilities == 0)).all(axis=2) & endless[:, None]
        if np.array_equal(stays.any(axis=1), endless):
            break
        endless = stays.any(axis=1)
    if endless.any():
        row = int(endless.argmax())
        name = names_of(model.mdp)[int(stays[row].argmax())]
        raise WrongAnswer(
            f"an episode of my_problem may go on for ever, for example by {name!r} in state {model.states[row]}: an end"
            " should come whatever the actions are, so keep a deadline in the state, like the time of the morning"
        )


def exercise_4(answer: Any, seed: int, price: Price = None) -> str:
    """Check that a student's own problem is one: it runs, chance and decisions matter, and no one action is best.

    With a price, one of its rewards must be that.
    """
    given("my_problem", answer)
    if type(answer).__name__ == "Template" or is_like(type(answer), Bicycle):
        raise WrongAnswer("that is the problem with which the cell began: write one of your own, under its own name")
    if type(answer).__name__ == "UsedToIt":
        raise WrongAnswer("that is the sleeper of exercise 3: write a problem of your own, under its own name")
    if isinstance(answer, Morning) or type(answer).__name__ == "Morning" or is_like(type(answer), Morning):
        raise WrongAnswer("that is the problem of the lesson: write one of your own, under its own name")
    with student_code("my_problem"), told_as_wrong():
        max_steps = task_of(answer, "my_problem", MDP_ONLY).max_steps
    kind = type(answer)
    if not issubclass(kind, tuple):
        raise WrongAnswer(
            f"{kind.__name__} should inherit from NamedTuple, as the form does: class {kind.__name__}(NamedTuple), with"
            " its numbers as fields and without __init__"
        )
    if max_steps is not None:
        raise WrongAnswer(
            "my_problem has `max_steps`, so the best action depends on how many steps are left: keep the time in the"
            " state, and end the episode by `terminal`, as Morning does"
        )
    with student_code("my_problem", limit=PLANNING_SECONDS):
        try:
            check_mdp(answer)
            _require_small(answer)
            values = solve(answer)
            for state in values.model.states:  # random steps come to few of them
                CheckedMDP(answer).observation(state, np.random.default_rng(seed))
        except ValueError as error:
            if "element" not in str(error):
                raise
            raise WrongAnswer(
                f"{error}: is it made of whole numbers, is the space large enough, and is `terminal` True in time?"
            ) from None
    model = values.model
    policy, live = values.greedy_policy(), ~model.terminal
    with student_code("my_problem"), told_as_wrong():
        table_sizes(answer.observation_space)
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
    _require_an_end(model)
    best_always = (policy[live] > 0).all(axis=0)
    if best_always.any():
        name = names_of(answer)[int(best_always.argmax())]
        raise WrongAnswer(
            f"in my_problem the action {name!r} is best in every state, so there is nothing to decide: give it a price,"
            " or lower that of another one"
        )
    possible = model.rewards[model.probabilities > 0]
    if price is not None and not np.isclose(abs(possible), price, rtol=0, atol=1e-9).any():
        raise WrongAnswer(use_your_own(f"no reward is {price:g} or -{price:g}"))
    return f"A problem: {len(model.states)} states, {policy.shape[1]} actions, optimum {values.start:.4g}."
