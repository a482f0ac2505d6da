"""Exercise 3 of lesson 1: what an explorer does that tries what is new, and what the usual mistakes do."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from edugym_course.grading.choices import ChoiceCase, action_of, check_all_choices
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.one_step import Q_LEARNING, made_up_values, numbers_of, one_step_update
from edugym_course.grading.student_code import student_code
from edugym_course.grading.updates import Tables, Transition, Update

DRAWS = 20
LAST_STATE = 4
"""The top of the lowest wall of the check."""
TRIED_ONCE = "a grip that was tried once is tried: only those count that were tried 0 times"
WORST = "once all grips were tried the best one counts, and it takes the worst"
LEAST_TRIED = "once all grips were tried the *best* one counts, and it takes the one that was tried least"
FIRST_OF_EQUALS = "ties should be broken at random, and it takes the first of equals"
LAST_OF_EQUALS = "ties should be broken at random, and it takes the last of equals"
AT_RANDOM = "it acts at random"
LAST_NEVER = (
    "the last grip is never tried: does the loop end before it (`range(n)` goes to n − 1 already), or return too early,"
    " as in an `else` inside of it?"
)
FIRST_NEVER = "grip 0 is never tried: a loop over `range(n)` begins with it"
WAS_TRIED = "it takes a grip that *was* tried: is the test of `tries` the wrong way round?"
UNTRIED = "a grip that was never tried comes first, whatever Q says of it"


def explorer_update(
    tables: Tables,
    now: Transition,
    *,
    bonus: float,
    novelty: str = "1/√n",
    counts: str = "entered",
    tries: str = "taken",
    looks_up: str = "entered",
    late: bool = False,
    least: int = 0,
    power: float = 0.5,
    **one_step: Any,
) -> None:
    """Count, and apply Q-learning on the reward plus β/n^power; other arguments than the defaults are mistakes."""
    state, action, next_state = now.state, now.action, now.next_state
    n_states, n_actions = tables["tries"].shape
    old_count = _count(tables, looks_up, now)
    if counts != "nothing":
        tables["visits"][{"entered": next_state, "left": state}[counts]] += 1
    if tries != "nothing":
        swapped = action % n_states, state % n_actions
        tables["tries"][{"taken": (state, action), "next": (next_state, action), "swapped": swapped}[tries]] += 1
    n = max(old_count, least) if late else _count(tables, looks_up, now)
    share = {
        "1/√n": 1 / np.float64(n) ** power,
        "1/n": 1 / np.float64(n),
        "1/n/2": 1 / np.float64(n) / 2,
        "√(β/n)": (bonus / np.float64(n)) ** power / bonus,
        "outside": 1 / np.float64(n) ** power / one_step["learning_rate"],
        "discounted": one_step["discount"] / np.float64(n) ** power,
        "beside the value": 0.0 if now.terminated else one_step["discount"] / np.float64(n) ** power,
        "√n": np.sqrt(n),
        "1/√(n+1)": 1 / np.sqrt(n + 1),
        "constant": 1.0,
        "first visit": float(n == 1),
        "minus": -1 / np.float64(n) ** power,
        "none": 0.0,
        "not at the end": 0.0 if now.terminated else 1 / np.float64(n) ** power,
    }
    one_step_update(tables, now, extra=bonus * share[novelty], **one_step)


def _count(tables: Tables, looks_up: str, now: Transition) -> Any:
    """Return the count that the bonus depends on."""
    if looks_up == "pair":
        return tables["tries"][now.state, now.action]
    return tables["visits"][{"entered": now.next_state, "left": now.state}[looks_up]]


NOVELTY_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "it counts the state that was left; count the one that was *entered*, next_state": {
        "counts": "left",
        "looks_up": "left",
    },
    "`visits` counts the state that was left; count the one that was *entered*, next_state": {"counts": "left"},
    "the bonus is that of the state that was left; it belongs to the one that was *entered*, next_state": {
        "looks_up": "left"
    },
    "the bonus is computed from the number of tries of the action, n(s, a), and it should come from visits, n(s')": {
        "looks_up": "pair"
    },
    "`visits` does not count": {"counts": "nothing"},
    "`tries` does not count": {"tries": "nothing"},
    "`tries` counts next_state; count the state in which the action was *taken*": {"tries": "next"},
    "state and action have changed places in `tries`": {"tries": "swapped"},
    "the bonus comes from the old count: count first, so that a first visit has n = 1": {"late": True},
    "the bonus comes from the old count, or from 1 at the first visit: count before you divide": {
        "late": True,
        "least": 1,
    },
    "the bonus is β/√(n + 1), one visit too many": {"novelty": "1/√(n+1)"},
    "the root is missing: the bonus is β/√n": {"novelty": "1/n"},
    "`** 1 / 2` is `(... ** 1) / 2`: write `** 0.5` for the root": {"novelty": "1/n/2"},
    "β stands under the root, √(β/n): only n does, β/√n": {"novelty": "√(β/n)"},
    "the bonus is added outside the brackets: it is part of the target, of which α is taken": {"novelty": "outside"},
    "the whole target is discounted; γ belongs to the value of the next state only": {"target": "all discounted"},
    "the bonus stands beside the value of the next state, so it is discounted, and lost at the end: it belongs to the"
    " reward": {"novelty": "beside the value"},
    "the bonus is discounted; γ belongs to the value of the next state only": {"novelty": "discounted"},
    "the bonus grows with the count: it is β *divided* by √n": {"novelty": "√n"},
    "the bonus does not fade with the count: it is β/√n": {"novelty": "constant"},
    "only the first visit earns a bonus; every visit earns β/√n": {"novelty": "first visit"},
    "the bonus is subtracted": {"novelty": "minus"},
    "the bonus is missing": {"novelty": "none"},
    "at the end of an episode the bonus is lost: only the *value of the next state* is 0 there": {
        "novelty": "not at the end"
    },
}

EXPLORER = Update(
    rule=explorer_update,
    tables=lambda n_states, n_actions, rng: {
        "visits": rng.integers(0, 9, n_states),
        "tries": rng.integers(0, 5, (n_states, n_actions)),
        "Q": made_up_values(n_states, n_actions, rng),
    },
    mistakes={**NOVELTY_MISTAKES, **Q_LEARNING.mistakes},
    numbers=numbers_of("learning_rate", "discount", "bonus"),
)


def epsilon_greedy(best: list[float]) -> dict[str, list[float]]:
    """Return the probabilities of some agents that still explore."""
    return {
        f"it still explores, with an ε near {epsilon}": [epsilon / len(best) + (1 - epsilon) * share for share in best]
        for epsilon in (0.1, 0.2, 0.5)
    }


def check_act(make: Callable[[], Any], n_grips: int) -> None:
    """Check what explorers do where some grips, all or none were tried."""
    others = n_grips - 1
    last = [0.0] * others + [1.0]
    first, greedy = [1.0] + [0.0] * others, [1 / others] * others + [0.0]
    second = [0.0, 1.0, *[0.0] * (others - 1)]
    but_first = [0.0] + [1 / others] * others
    of_equals = {FIRST_OF_EQUALS: second, LAST_OF_EQUALS: last}
    cases: list[tuple[list[int], list[float], list[float], dict[str, list[float]]]] = [
        (
            [*range(3, 3 + others), 0],
            [1.0] * others + [-1.0],
            last,
            {UNTRIED: greedy, LAST_NEVER: greedy, WAS_TRIED: first},
        ),
        (
            [0, *range(1, n_grips)],
            [-1.0] + [1.0] * others,
            first,
            {UNTRIED: but_first, FIRST_NEVER: but_first, WAS_TRIED: second},
        ),
        ([1, *range(5, 5 + others)], [2.0] + [1.0] * others, first, {WORST: but_first}),
        ([7, *range(2, 1 + n_grips)], [2.0] + [1.0] * others, first, {LEAST_TRIED: second, WORST: but_first}),
        (
            [1, *range(5, 5 + others)],
            [1.0] + [2.0] * others,
            but_first,
            {TRIED_ONCE: first, LEAST_TRIED: first, WORST: first, **of_equals},
        ),
        (
            [2, *range(5, 5 + others)],
            [-0.5] + [-0.25] * others,
            but_first,
            {LEAST_TRIED: first, WORST: first, **of_equals},
        ),
    ]
    made: list[ChoiceCase] = []
    for k, (tries, values, expected, mistakes) in enumerate(cases):
        state, agent = k % LAST_STATE, make()
        agent.tries[state], agent.Q[state] = tries, values
        agent.visits[state] = sum(tries)
        made.append(
            ChoiceCase(
                partial(agent.act, state),
                expected,
                {WAS_TRIED: first, **mistakes, AT_RANDOM: [1 / n_grips] * n_grips, **epsilon_greedy(expected)},
                {name: getattr(agent, name) for name in ("Q", "visits", "tries")},
                f"where state = {state}, tries[{state}] = {tries} and Q[{state}] = {values}",
            )
        )
    check_all_choices("act(state, rng)", made)
    _check_untried(make(), LAST_STATE, n_grips)


def _check_untried(agent: Any, state: int, n_grips: int) -> None:
    """Check what an explorer does where it has tried nothing, or one grip only: any of the others will do."""
    others = n_grips - 1
    values, rng = [1.0] + [-1.0] * others, np.random.default_rng(0)
    for tries in ([0] * n_grips, [4] + [0] * others):
        agent.tries[state], agent.visits[state], agent.Q[state] = tries, sum(tries), values
        call = f"act({state}, rng), where tries[{state}] = {tries} and Q[{state}] = {values},"
        for _ in range(DRAWS):
            with student_code(call):
                found = agent.act(state, rng)
            grip = action_of(call, found, n_grips)
            if tries[grip]:
                raise WrongAnswer(f"{call} should choose a grip that was never tried, but chooses {grip}: {UNTRIED}")
