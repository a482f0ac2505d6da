"""Study: days that a person can follow, the exam at its edges, the noise, and which plans are possible."""

import itertools
from contextlib import nullcontext
from math import inf, nan
from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym.adapters.registration import find
from edugym.envs.study import Student, Study
from edugym.exact.value_iteration import value_iteration
from edugym.rendering.ansi import to_text
from tests.contract.described import LAYOUT_SEEDS, NO_WHOLE_NUMBER, Keywords, Parameters, refused

StudyEnv: Any = find("Study").load()


@st.composite
def plans(draw: st.DrawFn) -> Keywords:
    """Plans that a student can carry out."""
    total_days = draw(st.integers(3, 25))
    lectures_needed = draw(st.integers(1, total_days - 2))
    return {
        "total_days": total_days,
        "n_actions": draw(st.integers(2, 8)),
        "lecture_days": draw(st.integers(lectures_needed, total_days - 1)),
        "lectures_needed": lectures_needed,
        "energy_needed": draw(st.integers(0, min(3, total_days - 2 - lectures_needed))),
        "action_reward_noise_mean": draw(st.floats(0, 10)),
        "action_reward_noise_sigma": draw(st.floats(0, 10)),
        "layout_seed": draw(LAYOUT_SEEDS),
    }


def study_well(info: dict[str, Any], env: Any) -> int:
    """Study on the days of lectures and of the exam, and sleep on the others."""
    return 0 if info["lecture"] or env.state.day == env.mdp.total_days - 1 else 1


PARAMETERS = Parameters(
    valid=plans(),
    corners=(
        {},
        {"total_days": 3, "n_actions": 2, "lecture_days": 1, "lectures_needed": 1, "energy_needed": 0},
        {"total_days": 8, "lecture_days": 7, "lectures_needed": 3, "energy_needed": 3, "layout_seed": 2**63},
        {"total_days": 40, "n_actions": 20, "lecture_days": 15, "lectures_needed": 15},
        {"action_reward_noise_mean": 0, "action_reward_noise_sigma": 0},
        {"action_reward_noise_mean": 1e6, "action_reward_noise_sigma": 1e6},
    ),
    bad=(
        *refused("total_days", 2, 4, 0, -10, 10**5 + 1, 10**400, *NO_WHOLE_NUMBER),
        *refused("n_actions", 1, 0, 1001, 10**9, *NO_WHOLE_NUMBER),
        *refused("lecture_days", 0, 10, 11, *NO_WHOLE_NUMBER),
        *refused("lectures_needed", 0, 4, -1, *NO_WHOLE_NUMBER),
        *refused("lectures_needed", 3, total_days=5),
        *refused("energy_needed", -1, 4, *NO_WHOLE_NUMBER),
        *refused("energy_needed", 3, total_days=6),
        *refused("action_reward_noise_mean", -0.1, inf, nan, "0", None, True),
        *refused("action_reward_noise_sigma", -0.1, inf, nan, "0", None, True),
        *refused("layout_seed", -1, *NO_WHOLE_NUMBER),
    ),
    finite=({}, {"total_days": 5, "n_actions": 2, "energy_needed": 0}),
    informed=study_well,
)


STUDY, SLEEP, GO_OUT, OTHER = 0, 1, 2, 3


def task(lectures: list[int], **given: Any) -> Study:
    """A task without noise whose actions pay 1, 2, 4 and 8 hundredths less than nothing."""
    parameters = {"lectures_needed": 2, "energy_needed": 1, "sigma": 0.0, **given}
    rewards = np.array([-0.01, -0.02, -0.04, -0.08])
    return Study(len(lectures), np.array(lectures), action_rewards=rewards, **parameters)


def episode(mdp: Study, actions: list[int]) -> list[tuple[Any, ...]]:
    """What each day gives: knowledge, energy, day, reward, terminated, truncated."""
    env = StudyEnv()
    env.mdp = mdp
    env.reset(seed=0)
    steps = [env.step(action) for action in actions]
    return [(*observation.tolist(), *rest) for observation, *rest, _ in steps]


def test_passed_exam() -> None:
    """Two lectures, two nights of sleep, and the exam; a lecture that is missed and a free day that is studied."""
    assert episode(task([1, 0, 1, 0, 1, 0, 0]), [STUDY, STUDY, OTHER, SLEEP, STUDY, SLEEP, STUDY]) == [
        (1, 0, 1, -0.01, False, False),
        (1, 0, 2, -0.01, False, False),
        (1, 0, 3, -0.08, False, False),
        (1, 1, 4, -0.02, False, False),
        (2, 1, 5, -0.01, False, False),
        (2, 2, 6, -0.02, False, False),
        (2, 2, 7, 9.99, True, False),
    ]


@pytest.mark.parametrize(
    ("knowledge", "energy", "day", "action", "reward"),
    [
        (2, 2, 4, STUDY, 9.99),
        (3, 4, 4, STUDY, 9.99),
        (1, 4, 4, STUDY, -0.01),  # too little knowledge
        (3, 1, 4, STUDY, -0.01),  # as much energy as `energy_needed`, which must be less
        (2, 2, 4, SLEEP, -0.02),  # not at the exam
        (2, 1, 4, SLEEP, -0.02),
        (2, 2, 4, OTHER, -0.08),
        (2, 2, 3, STUDY, -0.01),  # not yet the exam
    ],
)
def test_exam(knowledge: int, energy: int, day: int, action: int, reward: float) -> None:
    """The exam asks for knowledge, for energy, and for studying on its day, as things stand that morning."""
    mdp, rng = task([1, 1, 1, 0, 0]), np.random.default_rng(0)
    state = Student(knowledge, energy, day, False)
    after = mdp.transition(state, action, rng)
    assert mdp.reward(state, action, after, rng) == reward
    assert mdp.passes(state, action) == (reward > 0)
    assert mdp.terminal(after) == (day == 4)


def test_energy_has_bounds() -> None:
    """Sleep fills up to 4, going out empties down to 0."""
    actions = [GO_OUT, SLEEP, GO_OUT, GO_OUT, SLEEP, SLEEP, SLEEP, SLEEP, SLEEP, GO_OUT]
    energies = [energy for _, energy, *_ in episode(task([1, 1, 0, 0, 0, 0, 0, 0, 0, 0]), actions)]
    assert energies == [0, 1, 0, 0, 1, 2, 3, 4, 4, 3]


def test_optimum() -> None:
    """At the defaults: two nights, three more days of study than the exam alone, and the dearest rest left out."""
    env = StudyEnv()
    optimum = value_iteration(env.finite_model).start
    study, sleep, *others = env.mdp.action_rewards
    assert optimum == pytest.approx(10 + 3 * study + 2 * sleep + 5 * max(study, sleep, *others))
    assert optimum == pytest.approx(8.98, abs=0.005)  # as the docstring says
    noisier = StudyEnv(action_reward_noise_sigma=3.0).finite_model
    assert value_iteration(noisier).start == optimum  # noise that is only added changes no mean
    means = [value_iteration(StudyEnv(layout_seed=seed).finite_model).start for seed in range(10)]
    assert all(10 - 10 * 0.5 < mean < 10 for mean in means)
    assert len(set(means)) == 10


def test_noise() -> None:
    """The reward of an action is normal with its mean and standard deviation, on the exam's day as well."""
    mdp, rng, n = task([1, 1, 0, 0, 0], sigma=0.3), np.random.default_rng(5), 40_000
    for state, action, mean in [
        (Student(0, 0, 0, False), GO_OUT, -0.04),
        (Student(2, 2, 4, False), STUDY, 9.99),
        (Student(0, 2, 4, False), STUDY, -0.01),
    ]:
        after = mdp.transition(state, action, rng)
        rewards = np.array([mdp.reward(state, action, after, rng) for _ in range(n)])
        assert abs(rewards.mean() - mean) < 4.5 * 0.3 / n**0.5
        assert abs(rewards.std() / 0.3 - 1) < 4.5 / (2 * n) ** 0.5


def test_layout() -> None:
    """Lecture days are uniform among those before the exam, mean rewards in [-mean, 0]; more actions change neither."""
    n = 2_000
    tasks = [StudyEnv(layout_seed=seed, action_reward_noise_mean=0.8).mdp for seed in range(n)]
    lectures = np.array([mdp.lectures for mdp in tasks])
    assert set(lectures.sum(axis=1)) == {3}
    assert lectures[:, 9].sum() == 0
    assert np.abs(lectures[:, :9].mean(axis=0) - 1 / 3).max() < 4 * (2 / 9 / n) ** 0.5
    rewards = np.array([mdp.action_rewards for mdp in tasks])
    assert rewards.shape == (n, 5)
    assert -0.8 <= rewards.min() < -0.79 < -0.01 < rewards.max() <= 0.0
    assert np.abs(rewards.mean(axis=0) + 0.4).max() < 4.5 * 0.8 / (12 * n) ** 0.5
    few, many = StudyEnv(n_actions=4).mdp, StudyEnv(n_actions=12).mdp
    assert few.lectures.tolist() == many.lectures.tolist()
    assert few.action_rewards.tolist() == many.action_rewards[:4].tolist()


def can_pass(mdp: Study) -> bool:
    """Whether some actions pass the exam, by trying all."""
    rng = np.random.default_rng(0)
    states = {mdp.initial(rng)}
    for _ in range(mdp.total_days - 1):
        states = {mdp.transition(state, action, rng) for state in states for action in range(4)}
    return any(mdp.passes(state, action) for state in states for action in range(4))


def test_impossible_plans_are_refused() -> None:
    """Exactly the plans that nobody can carry out are refused, and the layout never matters to that."""
    counts = {True: 0, False: 0}
    for total_days, needed, energy in itertools.product(range(2, 7), range(1, 6), range(5)):
        for lecture_days in range(1, total_days):
            plan: dict[str, Any] = {"lectures_needed": needed, "energy_needed": energy}
            layouts = itertools.combinations(range(total_days - 1), lecture_days)
            tasks = (task([int(day in layout) for day in range(total_days)], **plan) for layout in layouts)
            (possible,) = {can_pass(mdp) for mdp in tasks}
            with nullcontext() if possible else pytest.raises(ValueError, match=r"total_days|lecture|energy_needed"):
                env = StudyEnv(total_days=total_days, lecture_days=lecture_days, **plan)
                assert value_iteration(env.finite_model).start > 5
            counts[possible] += 1
    assert min(counts.values()) > 20


def test_info() -> None:
    """There is a lecture on the days of the layout; the exam is passed when it is; the others have numbers."""
    env = StudyEnv()
    infos = [env.reset(seed=0)[1]]
    for day in range(10):
        action = STUDY if day == 9 or env.mdp.lectures[day] else SLEEP
        infos.append(env.step(action)[4])
    assert [info["lecture"] for info in infos] == [day in (2, 4, 5) for day in range(11)]
    assert [info["passed"] for info in infos] == [False] * 10 + [True]
    assert not env.reset()[1]["passed"]
    assert list(env.named_actions()) == ["study", "sleep", "go out", "other 1", "other 2"]


def test_window_shows_the_last_action(monkeypatch: pytest.MonkeyPatch) -> None:
    """The picture drawn inside `step` shows what that step did."""
    env = StudyEnv(render_mode="human")
    frames: list[str] = []
    monkeypatch.setattr(env, "render", lambda: frames.append(to_text(env.scene())))
    env.reset(seed=0)
    for days, (action, name) in enumerate(((STUDY, "study"), (SLEEP, "sleep"), (GO_OUT, "go out"))):
        assert len(frames) == days + 1
        env.step(action)
        assert name in frames[-1]
