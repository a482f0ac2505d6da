"""Preferences: nights that are played, a teacher, what following rewards measures, and what a program may not see."""

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import numpy as np
import pytest

from edugym import policy_evaluation, value_iteration, with_rewards
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.agents.preferences import preference
from edugym.mdp.protocol import Integers
from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.own_problem.morning import Morning
from edugym_course.lessons.preferences import methods, project, replay, teachers

MODEL, REFERENCE = methods.model_of(Morning()), methods.half_right(Morning())


def test_nights_are_those_of_the_model() -> None:
    """Each has eight steps from the start on; the mean return is the exact one, and returns are those of the visits."""
    visits, returns = methods.nights(MODEL, REFERENCE, 20_000, np.random.default_rng(1))
    assert (visits.sum(axis=(1, 2)) == 8).all()
    assert (visits[:, MODEL.row((0, 2))].sum(axis=1) == 1).all()
    error = returns.std() / np.sqrt(len(returns))
    assert returns.mean() == pytest.approx(policy_evaluation(MODEL, REFERENCE).start, abs=4 * error)
    assert (visits * MODEL.r).sum(axis=(1, 2)).mean() == pytest.approx(returns.mean(), abs=4 * error)


def test_a_teacher_who_is_never_wrong() -> None:
    """With enough of her comparisons the best policy for the learned reward is all but the best."""
    rewards = methods.learned_rewards(Morning(), 5_000, 0.0, 0.1, np.random.default_rng(1))
    policy = methods.tuned(with_rewards(MODEL, rewards), REFERENCE, 0.0)
    assert policy_evaluation(MODEL, policy).start > value_iteration(MODEL).start - 0.3


def test_the_measures_of_following() -> None:
    """A huge penalty gains nothing; the optimum bounds what is meant; the divergence grows; runs repeat."""
    found = methods.followed(penalties=(1e5, 1.0, 0.5, 0.0), repetitions=3, seed=4)
    assert np.abs(found.meant[0]).max() < 0.01
    assert found.meant.max() < found.best
    assert (np.diff(found.nats, axis=0) > 0).all()
    assert (np.diff(found.learned, axis=0) > 0).all()  # each policy is better by the reward that it follows more
    assert found.fall() == pytest.approx(found.meant[2] - found.meant[3])
    again = methods.followed(penalties=(1e5, 1.0, 0.5, 0.0), repetitions=3, seed=4)
    assert np.array_equal(found.second, again.second)
    assert not np.array_equal(found.learned, found.second)


def test_rounds_ask_as_often() -> None:
    """A round more asks about another policy, and not more."""
    asked = methods.compared(MODEL, REFERENCE, 5, 1.0, np.random.default_rng(0))
    assert [len(part) for part in asked.with_more(asked)] == [10, 10, 10]


def test_a_learned_reward_is_paid_at_its_state() -> None:
    """Row by row of the model."""
    rewards = np.arange(MODEL.successors.shape[0] * 3.0).reshape(-1, 3)
    task = methods.learned_reward(Morning(), rewards)
    for row in np.flatnonzero(~MODEL.terminal):
        state = MODEL.states[row]
        paid = [task.reward(state, action, (state[0] + 1, 0), np.random.default_rng()) for action in range(3)]
        assert paid == rewards[row].tolist()


def test_what_is_meant_is_hidden() -> None:
    """The environment of the project pays nothing, and nothing below it can be reached by the usual name."""
    environment = project.Silent(MDPEnv(teachers.TASK), 1)
    environment.reset(seed=0)
    while True:
        _, reward, terminated, _, info = environment.step(2)
        assert (reward, info) == (0.0, {})
        if terminated:
            break
    assert environment.unwrapped is environment


def test_nights_begin_in_turns() -> None:
    """Only those that are played count."""
    mdp: Any = teachers.AT_ONCE
    environment = project.Silent(MDPEnv(mdp), 2)
    before = environment.reset(seed=0)[0][1]
    for seed in range(6):
        environment.step(0)
        begun, again = environment.reset(seed=seed)[0][1], environment.reset()[0][1]
        assert begun == again != before
        before = again


def test_the_teacher_remembers_a_slip() -> None:
    """A program that catches her error is refused all the same."""

    def program(environment: Any, compare: Callable[[Any, Any], bool], n_comparisons: int, seed: int) -> Any:
        with suppress(WrongAnswer):
            compare([], [])
        return lambda observation: 1

    with pytest.raises(WrongAnswer, match="a night has 10 steps"):
        project.project_14(program, 0)


def compared_nights(mdp: Morning, n: int, seed: int) -> list[replay.Comparison]:
    """Comparisons of random nights by a teacher with the noise of the lesson."""
    rng = np.random.default_rng(seed)

    def night() -> tuple[list[replay.Step], float]:
        state, steps, worth = mdp.initial(rng), list[replay.Step](), 0.0
        for _ in range(mdp.length):
            action = int(rng.integers(3))
            after = mdp.transition(state, action, rng)
            worth += mdp.reward(state, action, after, rng)
            steps.append((state, action, after))
            state = after
        return steps, worth

    pairs = [(night(), night()) for _ in range(n)]
    return [(one, other, bool(rng.random() < preference(a, b, 1.0))) for (one, a), (other, b) in pairs]


@pytest.mark.parametrize("method", [replay.Replay.right, *replay.MISTAKES.values()])
@pytest.mark.parametrize("share", [0.1, 0.5])
def test_what_a_policy_has_learned(method: Callable[[replay.Replay], Integers], share: float) -> None:
    """A policy that comes from a mistake is told as that; a right one, or one that is half right, as none."""
    rng, runs = np.random.default_rng(0), []
    for seed in range(2):
        replayed = replay.Replay(Morning(), comparisons := compared_nights(Morning(), 200, seed))
        is_right = rng.random(len(MODEL.states)) < share
        runs.append((comparisons, np.where(is_right, replayed.right(), method(replayed))))
    told = {sentence for sentence, mistake in replay.MISTAKES.items() if mistake is method and share < 0.5}
    assert replay.likely_mistake(Morning(), runs) == next(iter(told), "")


def test_what_follows_from_many_answers() -> None:
    """The best policy, nearly; each mistake is worse than that, and only `opposite` is worse than random actions."""
    replayed = replay.Replay(Morning(), compared_nights(Morning(), 3_000, 0))
    right, *wrong = (
        policy_evaluation(MODEL, method(replayed)).start for method in (replay.Replay.right, *replay.MISTAKES.values())
    )
    assert right > value_iteration(MODEL).start - 0.3
    at_random = policy_evaluation(MODEL, np.full_like(REFERENCE, 1 / 3)).start
    assert all(one < right - 1 for one in wrong)
    assert [one < at_random for one in wrong] == [
        mistake is replay.Replay.opposite for mistake in replay.MISTAKES.values()
    ]
