"""What counts as a mistake is one: on the cases of a check it differs from what is right, and from every other one."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np
import pytest

from edugym.agents.dqn import DQN
from edugym.exact.branching import branches
from edugym_course.lessons.continuous_actions import exercises as continuous_actions
from edugym_course.lessons.continuous_actions.exercises import episodes
from edugym_course.lessons.depth.exercises import cutting
from edugym_course.lessons.dimensionality.exercises import linear, sizes, targets
from edugym_course.lessons.loop import exercises as loop
from edugym_course.lessons.memory import exercises as memory
from edugym_course.lessons.memory.windows import window_law
from edugym_course.lessons.own_problem import exercises as own_problem
from edugym_course.lessons.signal.exercises import bits_mistakes
from edugym_course.lessons.signal.exercises.listener import HEARD, LISTENER_MISTAKES, probabilities
from edugym_course.lessons.stochasticity import exercises as stochasticity

Made = dict[str, Any]
"""By the sentence that tells of it, what a mistake gives in all cases; "" is the right answer."""
SCORED = [(2.0, 0.5, 0.5), (-1.0, 0.2, 2.0)]


def rounded(values: Any) -> Any:
    """Return numbers without what rounding adds."""
    return tuple(np.round(np.ravel(np.array(values, float)), 9).tolist())


def by_rules(rules: Mapping[str, Callable[..., Any]], cases: list[Any]) -> Made:
    """Return what functions of a case give."""
    return {why: rounded([rule(*case) for case in cases]) for why, rule in rules.items()}


def all_made(seed: int) -> dict[str, Made]:
    """Return what mistakes give in each exercise."""
    half, steps = {"learning_rate": 0.25, "discount": 0.5}, linear.steps_for(seed)
    agent = DQN.create((2, 3), hidden=2, memory_size=4, batch_size=2, discount=0.5)
    memories = [(case,) for _, case in targets.made_up_memories(agent, targets.drawn_for(agent, seed))]
    cutting_cases, cases = cutting.cases(seed), episodes.cases(seed)
    beating = {"": lambda players: stochasticity._unbeaten(players, stochasticity._beats)}
    mornings = [((3, depth, chimes), action) for depth in range(3) for chimes in range(3) for action in range(3)]
    lead = own_problem.UsedToChimes().transition
    return {
        "tables where episodes are cut (lesson 3)": {
            why: rounded([*cutting.outcomes(cutting_cases, {**half, **change})])
            for why, change in {"": {}, **cutting.MISTAKES}.items()
        },
        "weights (lesson 4)": by_rules({"": linear.right_update, **linear.UPDATES}, [(step,) for step in steps]),
        "values (lesson 4)": by_rules(
            {"": lambda step, action: float(step.x @ step.w[:, action]), **linear.VALUES},
            [(step, action) for step in steps for action in range(3)],
        ),
        "targets of DQN (lesson 4)": by_rules(
            {"": lambda case: targets._bootstrapped(case, float(case.old_next.max())), **targets.TARGETS}, memories
        ),
        "windows (lesson 5)": by_rules(
            {"": lambda window, action, seen: [*window[2:], action, seen], **memory.PUSHES}, [(np.arange(7), 7, 8)]
        ),
        "rows (lesson 5)": {"": 5 ** window_law(4), **memory._row_mistakes(4, 4)},
        "preferences (lesson 7)": {"": 2 * 11**3 * 5**3, **continuous_actions._size_mistakes(3, 5, 11)},
        "scores of the mean (lesson 7)": by_rules(continuous_actions.OF_MEAN, SCORED),
        "scores of the spread (lesson 7)": by_rules(continuous_actions.OF_LOG_SPREAD, SCORED),
        "tables of REINFORCE (lesson 7)": {
            why: tuple(rounded(table) for case in cases for table in episodes.after(case, change))
            for why, change in {"": {}, **episodes.MISTAKES}.items()
        },
        "players that no other beats (lesson 8)": {
            why: tuple(frozenset(rule(players)) for players in stochasticity.made_up_players(seed))
            for why, rule in {**beating, **stochasticity.FRONTIER_MISTAKES}.items()
        },
        "shaped rewards (lesson 10)": by_rules(
            {"": own_problem._shaped, **own_problem.SHAPING_MISTAKES},
            [(41.0, 3.0, 14.0, False, 0.5), (43.0, 5.0, 16.0, True, 0.75)],
        ),
        "where a step can lead (lesson 10)": {
            mistake: tuple(tuple(branches(partial(lead, *step, mistake=mistake))) for step in mornings)
            for mistake in ("", *own_problem.USED_MISTAKES.values())
        },
    }


@pytest.mark.parametrize("seed", [0, 1])
def test_no_two_mistakes_look_alike(seed: int) -> None:
    """In all cases of an exercise together, with any seed."""
    for exercise, made in all_made(seed).items():
        assert len(made) > 5, exercise
        assert [(one, other) for one, other in combinations(made, 2) if made[one] == made[other]] == [], exercise


def chances(change: Mapping[str, Any]) -> list[Any]:
    """Return how likely a listener of lesson 6 chooses each action, in all cases."""
    return [probabilities(case, **change).tolist() for case in HEARD]


def only_wrong() -> Iterator[tuple[str, Any, Any]]:
    """Yield mistakes of which some may look like another one, what they give, and what is right."""
    for kind, rules in sizes.MISTAKES.items():
        for why, rule in rules.items():
            yield why, rule(6, 4), sizes.ENTRIES[kind](6, 4)
    for why, change in LISTENER_MISTAKES.items():
        yield why, chances(change), chances({})
    values = np.array([1.0, 3.0, 3.0, 0.0])
    for why, shares in loop._choice_mistakes(values, 0.3).items():
        yield why, shares, loop._probabilities(values, 0.3)
    joint = np.array([[6.0, 2.0], [1.0, 7.0]]) / 16
    for why, bits in bits_mistakes(joint).items():
        yield why, bits, -1.0


def test_every_mistake_is_wrong() -> None:
    """In one case or more."""
    found = [*only_wrong()]
    assert len(found) > 50
    assert [why for why, wrong, right in found if rounded(wrong) == rounded(right)] == []


def test_every_mistake_in_notes_is_one() -> None:
    """Lesson 5: on the walks of the check each differs from the right update, and from the others."""
    cases = [case for n in (3, 4, 6) for case in memory._walk(n, np.random.default_rng(0))]
    rules = {"right": memory._right, **memory.UPDATES}

    def tried(rule: Callable[..., Any], case: Any) -> Any:
        try:
            notes, place = rule(*case)
        except IndexError:  # it writes outside of the notes
            return None
        return (*notes, place)

    made = {why: tuple(tried(rule, case) for case in cases) for why, rule in rules.items()}
    assert len({*made.values()}) == len(made)
