"""Which equation explains the actions of a program: every mistake of a lesson, done on purpose, is told as this one."""

import re
from collections.abc import Sequence
from importlib import import_module
from typing import Any

import build
import numpy as np
import pytest

from edugym.agents.tables import greedy_action
from edugym.checks.contract import learns_from
from edugym_course.grading import WrongAnswer, replay
from edugym_course.grading.learners import Learner
from edugym_course.grading.programs import Program, Run, Step, learn_from, run_program, shape_of
from edugym_course.grading.rule import ONCE, SWAPPED, Rule
from edugym_course.grading.small_world import SmallWorld
from tests.course.lessons.answers import namespace_after, read_answers, read_exercises

RULES: dict[str, Rule] = {
    lesson: project.RULE
    for lesson, path in build.lesson_sources().items()
    if (path.parent / "project.py").exists()
    and hasattr(project := import_module(f"edugym_course.lessons.{path.parent.name}.project"), "RULE")
}
CHEAPEST = {"00_loop", "00b_bandits", "02_on_off_policy"}
"""The lessons whose programs are checked fastest: Q-learning, bandits, and SARSA."""
QUICK = [pytest.param(lesson, marks=[pytest.mark.slow] * (lesson not in CHEAPEST)) for lesson in RULES]
SEEDS = [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (1, 2))]
CASES = [
    pytest.param(
        lesson, sentence, marks=[pytest.mark.slow] * (lesson != "00_loop" or number % 8 > 0), id=f"{lesson}-{number}"
    )
    for lesson, rule in RULES.items()
    for number, sentence in enumerate(rule.mistakes)
]
"""The quick tests of the other lessons are their answers `project_wrong.py`."""


def program_with(learner: Learner, epsilon: float, once_an_episode: bool = False) -> Program:
    """A program that makes a mistake in its loop; with `once_an_episode` its random actions come together."""

    def program(environment: Any, n_steps: int, seed: int) -> Any:
        agent: Any = learner.make(shape_of(environment))
        names, rng = learns_from(agent), np.random.default_rng(seed)
        state, before, waiting = environment.reset(seed=seed)[0], None, None
        is_random = once_an_episode and rng.random() < epsilon

        for _ in range(n_steps):
            thought = learner.alter(Step(state, 0, 0.0, state, False, False), before).state
            action = agent.act(thought, rng)
            if learner.swaps and rng.random() < 1 - epsilon / (1 - epsilon):  # so ε is left for the best one
                action = int(rng.integers(environment.action_space.n))
            if once_an_episode:
                values = np.array(
                    [np.ones(environment.action_space.n) if is_random else replay._values(agent, thought)]
                )
                action = greedy_action(values, 0, rng)
            if waiting is not None:
                learn_from(agent, names, waiting, action)
            next_state, reward, terminated, truncated, _ = environment.step(action)
            if learner.restarts and truncated:
                next_state = environment.reset()[0]
            real = Step(state, action, reward, next_state, terminated, truncated)
            before = learner.alter(real, before)
            waiting = None
            learned = before._replace(state=before.next_state) if learner.stale else before
            if learner.skips(real):
                getattr(agent, "forget_episode", bool)()
            elif "next_action" in names and not (terminated or truncated):
                waiting = learned
            else:
                learn_from(agent, names, learned, action)
            is_new = terminated or (truncated and not learner.restarts)
            if once_an_episode and (terminated or truncated):
                is_random = rng.random() < epsilon
            state = environment.reset()[0] if is_new else next_state
        return lambda state: agent.greedy(state, rng)

    return program


def values_on_the_way(steps: Sequence[Step], learner: Learner, shape: tuple[int, int]) -> list[list[float]]:
    """Those of the state that was met, before each step."""
    on_the_way = replay.learning(steps, learner, shape)
    return [
        np.round(agent.values(step.state) if hasattr(agent, "values") else agent.Q[step.state], 9).tolist()
        for agent, step in on_the_way
    ]


@pytest.mark.parametrize(("lesson", "sentence"), CASES)
@pytest.mark.parametrize("seed", SEEDS)
def test_a_mistake_is_recognised(lesson: str, sentence: str, seed: int) -> None:
    """No two of a lesson are taken for each other."""
    with pytest.raises(WrongAnswer) as refused:
        RULES[lesson].check(program_with(RULES[lesson].mistakes[sentence], RULES[lesson].epsilon), seed)
    said = str(refused.value)
    assert f" fit a usual mistake: {sentence}{'' if sentence.endswith('?') else '.'} In small worlds with " in said
    by_number = ("it should be some ", "are not greedy, if it learns from its steps by the equation of this")
    assert all(words in said for words in by_number) or said.endswith(" by another equation than that of this lesson.")


@pytest.mark.parametrize("lesson", RULES)
def test_every_mistake_learns_something_else(lesson: str) -> None:
    """From the steps of a right program: other values than the right equation, and than every other mistake."""
    rule = RULES[lesson]
    world = rule.world(3, rule.truncates, rule.noisy)
    steps = run_program(program_with(rule.right, rule.epsilon), world, 800, 3).steps
    learned = {"right": values_on_the_way(steps, rule.right, shape_of(world))}
    for sentence, mistake in rule.mistakes.items():
        values = values_on_the_way(steps, mistake, shape_of(world))
        assert [sentence, *(other for other, found in learned.items() if found == values)] == [sentence]
        learned[sentence] = values


@pytest.mark.parametrize("lesson", QUICK)
def test_a_random_action_too_often(lesson: str) -> None:
    """A comparison with ε that is the wrong way round is no other mistake."""
    rule = RULES[lesson]
    with pytest.raises(WrongAnswer, match=f"{re.escape(SWAPPED)}$"):
        rule.check(program_with(rule.right._replace(swaps=True), rule.epsilon), 0)


@pytest.mark.parametrize("lesson", [lesson for lesson in QUICK if lesson.values != ("06_signal",)])
@pytest.mark.parametrize("seed", SEEDS)
def test_random_actions_that_come_together(lesson: str, seed: int) -> None:
    """Whoever draws once an episode whether it is random is told so; in lesson 6 an episode is one step."""
    with pytest.raises(WrongAnswer, match=f"{ONCE}$"):
        RULES[lesson].check(program_with(RULES[lesson].right, RULES[lesson].epsilon, once_an_episode=True), seed)


@pytest.mark.parametrize("lesson", QUICK)
@pytest.mark.parametrize("seed", SEEDS)
def test_a_right_program_has_no_surprises(lesson: str, seed: int) -> None:
    """Whatever the seed is."""
    RULES[lesson].check(program_with(RULES[lesson].right, RULES[lesson].epsilon), seed)


@pytest.mark.slow
@pytest.mark.parametrize("lesson", RULES)
@pytest.mark.parametrize("seed", [2, 3])
def test_right_answers_are_right_whatever_the_seed_is(lesson: str, seed: int) -> None:
    """Also those that learn in a way that is only much like ours."""
    setup, answers = read_answers(lesson)
    imports, _ = read_exercises(build.lesson_sources()[lesson])
    for answer in answers:
        if answer.right and answer.exercise == 0:
            with namespace_after(imports, setup, answer.code) as namespace:
                RULES[lesson].check(namespace["my_program"], seed)


@pytest.mark.parametrize("truncates", [False, True])
def test_a_small_world(truncates: bool) -> None:
    """No state comes twice in an episode, but the terminal one is an ordinary state elsewhere."""
    world, rng = SmallWorld(0, truncates), np.random.default_rng(0)
    state, seen, ends, cut_off = world.reset(seed=0)[0], set[int](), set[int](), 0
    visited = set[int]()
    for _ in range(2000):
        assert state not in seen
        seen.add(state)
        visited.add(state)
        state, _, terminated, truncated, _ = world.step(int(rng.integers(4)))
        assert not (terminated and truncated)
        if terminated or truncated:
            ends |= {state} if terminated else set()
            cut_off += truncated
            state, seen = world.reset()[0], set()
    assert ends <= visited == {*range(12)}
    assert (cut_off > 0) == truncates


@pytest.mark.parametrize("last", [1, 2])
@pytest.mark.parametrize("earlier", [0, 3])
def test_the_last_step_may_be_learned_or_not(last: int, earlier: int) -> None:
    """After it SARSA waits for an action that nobody takes any more; what was learned before it must be followed."""
    steps = [Step(5, 3, 1.0, 6, True, False)] * 20 + [Step(0, 1, 1.0, 6, True, False)] * 20
    steps += [Step(state, 0, 0.0, state + 1, False, False) for state in (7, 8)] + [Step(0, 2, 9.0, 7, False, False)]
    run = Run(steps, lambda state: last if state == 0 else earlier)
    if earlier == 3:
        RULES["02_on_off_policy"].require_best_actions([run], (12, 4))
    else:
        with pytest.raises(WrongAnswer, match="20 of 20 observations"):
            RULES["02_on_off_policy"].require_best_actions([run], (12, 4))
