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


def rounded(values: Any) -> Any:
    """Return numbers without what rounding adds."""
    return tuple(np.round(np.ravel(np.array(values, float)), 9).tolist())


def by_rules(rules: Mapping[str, Callable[..., Any]], cases: list[Any]) -> Made:
    """Return what functions of a case give."""
    return {why: rounded([rule(*case) for case in cases]) for why, rule in rules.items()}


def cut_at_exploring(seed: int) -> Made:
    """Lesson 3: whole tables after the episodes."""
    return {
        why: rounded(
            [*cutting.outcomes(cutting.cases(seed), {"learning_rate": 0.25, "discount": 0.5, **change})]
        )
        for why, change in {"": {}, **cutting.MISTAKES}.items()
    }  # fmt: skip


def linear_updates(seed: int) -> Made:
    """Lesson 4: the weights after a step."""
    return by_rules({"": linear.right_update, **linear.UPDATES}, [(step,) for step in linear.steps_for(seed)])


def linear_values(seed: int) -> Made:
    """Lesson 4: the value of each action."""
    cases = [(step, action) for step in linear.steps_for(seed) for action in range(3)]
    return by_rules({"": lambda step, action: float(step.x @ step.w[:, action]), **linear.VALUES}, cases)


def network_targets(seed: int) -> Made:
    """Lesson 4: the targets of DQN."""
    agent = DQN.create((2, 3), hidden=2, memory_size=4, batch_size=2, discount=0.5)
    cases = [(case,) for _, case in targets.made_up_memories(agent, targets.drawn_for(agent, seed))]
    right = {"": lambda case: targets._bootstrapped(case, float(case.old_next.max()))}
    return by_rules({**right, **targets.TARGETS}, cases)


def pushes(seed: int) -> Made:
    """Lesson 5: a window without repetitions."""
    right = {"": lambda window, action, seen: [*window[2:], action, seen]}
    return by_rules({**right, **memory.PUSHES}, [(np.arange(7), 7, 8)])


def rows(seed: int) -> Made:
    """Lesson 5: the size of a table; lesson 7: the number of preferences."""
    return {"": 5 ** window_law(4), **memory._row_mistakes(4, 4)}


def preferences(seed: int) -> Made:
    """Lesson 7: the number of preferences."""
    return {"": 2 * 11**3 * 5**3, **continuous_actions._size_mistakes(3, 5, 11)}


def scores(seed: int) -> Made:
    """Lesson 7: the derivatives by the mean."""
    return by_rules(continuous_actions.OF_MEAN, [(2.0, 0.5, 0.5), (-1.0, 0.2, 2.0)])


def log_scores(seed: int) -> Made:
    """Lesson 7: the derivatives by the logarithm of the spread."""
    return by_rules(continuous_actions.OF_LOG_SPREAD, [(2.0, 0.5, 0.5), (-1.0, 0.2, 2.0)])


def reinforce(seed: int) -> Made:
    """Lesson 7: both tables after an episode."""
    cases = episodes.cases(seed)
    return {
        why: tuple(rounded(table) for case in cases for table in episodes.after(case, change))
        for why, change in {"": {}, **episodes.MISTAKES}.items()
    }


def frontier(seed: int) -> Made:
    """Lesson 8: the names of the players that no other one beats."""
    right = {"": lambda players: stochasticity._unbeaten(players, stochasticity._beats)}
    rules = {**right, **stochasticity.FRONTIER_MISTAKES}
    return {
        why: tuple(frozenset(rule(players)) for players in stochasticity.made_up_players(seed))
        for why, rule in rules.items()
    }


def shaping(seed: int) -> Made:
    """Lesson 10: a step in the middle and one at the end."""
    steps = [(41.0, 3.0, 14.0, False, 0.5), (43.0, 5.0, 16.0, True, 0.75)]
    return by_rules({"": own_problem._shaped, **own_problem.SHAPING_MISTAKES}, steps)


def sleepers(seed: int) -> Made:
    """Lesson 10: where each step can lead."""
    task = own_problem.UsedToChimes()
    steps = [((3, depth, chimes), action) for depth in range(3) for chimes in range(3) for action in range(3)]
    return {
        mistake: tuple(
            tuple(branches(partial(task.transition, state, action, mistake=mistake))) for state, action in steps
        )
        for mistake in ("", *own_problem.USED_MISTAKES.values())
    }


MAKERS = [
    cut_at_exploring, linear_updates, linear_values, network_targets, pushes, rows, preferences, scores, log_scores,
    reinforce, frontier, shaping, sleepers,
]  # fmt: skip


@pytest.mark.parametrize("make", MAKERS)
@pytest.mark.parametrize("seed", [0, 1])
def test_no_two_mistakes_look_alike(make: Callable[[int], Made], seed: int) -> None:
    """In all cases together, with any seed."""
    made = make(seed)
    assert len(made) > 5
    assert [(one, other) for one, other in combinations(made, 2) if made[one] == made[other]] == []


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
