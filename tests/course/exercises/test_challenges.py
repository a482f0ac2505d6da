"""The open challenges: each is the one of which its lesson tells, and worth its points."""

import re
from collections.abc import Callable
from importlib import import_module
from typing import Any

import build
import pytest

from edugym import DynaQ, EpsilonGreedy, QLearning, TreeBackup
from edugym.experiments.configuration import described
from edugym_course.grading.challenge import Challenge, Sizes
from edugym_course.lessons.continuous_actions.exercises import own_container
from edugym_course.lessons.signal.moody import best_return
from edugym_course.lessons.stochasticity.exact import optimum
from tests.course.grading.test_challenge import systematic

CHALLENGES: dict[str, Challenge] = {
    lesson: module.CHALLENGE
    for lesson, path in build.lesson_sources().items()
    if hasattr(module := import_module(f"edugym_course.lessons.{path.parent.name}.exercises"), "CHALLENGE")
}
POSSIBLE = {"03_depth": 10.0, "07_continuous_actions": 5.0, "08_stochasticity": 0.868, "06_signal": 6595.22}
"""The best returns of tasks that do not tell it, or tell that of another layout."""


def baselines_of(challenge: Challenge) -> dict[str, Any]:
    """Its baselines, made for one of its tasks."""
    task = challenge._task(1)
    return {
        label: make(Sizes(task.observation_space, task.action_space)) for label, make in challenge.baselines.items()
    }


@pytest.mark.parametrize("lesson", CHALLENGES)
def test_a_challenge_is_that_of_its_lesson(lesson: str) -> None:
    """The text says how many steps there are, what counts, and what is possible, which is the optimum of the task."""
    challenge, source = CHALLENGES[lesson], build.lesson_sources()[lesson].read_text(encoding="utf-8")
    text = " ".join(source.partition("### The open challenge")[2].partition("# %%")[0].replace("\n# ", " ").split())
    assert f"{challenge.n_steps:,} steps".replace(",", " ") in text
    possible = 975 if lesson == "01_exploration" else challenge.best_average  # steps that a good explorer needs
    assert f"{possible:,.4g}".replace(",", " ").replace("-", "−") in text
    assert (challenge.column == "training_return") == bool(
        re.search(r"\ball(\W+)training (episodes|games) count", text, re.I)
    )
    assert challenge.optimum == POSSIBLE.get(lesson, challenge._task(1).reward_threshold) >= challenge.best_average
    assert challenge.repetitions == 10


@pytest.mark.parametrize("lesson", CHALLENGES)
def test_baselines_are_what_their_labels_say(lesson: str) -> None:
    """A number in a label is that of a setting, and no two are the same agent."""
    made = {label: described(agent, "agent") for label, agent in baselines_of(CHALLENGES[lesson]).items()}
    for label, settings in made.items():
        for number in re.findall(r"= (-?[\d.]+)", label):
            assert float(number) in [value for value in settings.values() if isinstance(value, int | float)], label
    assert len({tuple(settings.items()) for settings in made.values()}) == len(made)


def test_first_values_of_baselines() -> None:
    """The optimist's are 1; those of the lesson's Gaussian agent are not 0, but for the baseline that says so."""
    assert (baselines_of(CHALLENGES["01_exploration"])["optimistic"].Q == 1).all()
    gaussians = baselines_of(CHALLENGES["07_continuous_actions"])
    assert {label: bool(agent.value_weights.any() or agent.weights.any()) for label, agent in gaussians.items()} == {
        label: "first values 0" not in label for label in gaussians
    }


@pytest.mark.slow
def test_tasks_of_names() -> None:
    """Every name has its container, and the optimum of the moody toy and of golf is planned on the whole state."""
    widths = {own_container(seed).container_width for seed in range(20)}
    assert len(widths) == 20
    assert 0.4 <= min(widths) <= max(widths) <= 0.6
    assert best_return(0.1, 20) == pytest.approx(CHALLENGES["06_signal"].optimum, abs=0.01)
    assert optimum(0.015) == pytest.approx(CHALLENGES["08_stochasticity"].optimum, abs=5e-4)


def optimist(kind: Any, **settings: Any) -> Callable[[Any], Any]:
    """Return a maker of agents that never choose at random and learn fast."""
    return lambda task: kind.create(
        task, **{"learning_rate": 1.0, "discount": 1.0, "exploration": EpsilonGreedy(0.0), **settings}
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("lesson", "agent", "low", "high"),
    [
        ("01_exploration", systematic, 96, 104),
        ("01_exploration", QLearning.create, -1, 1),
        ("02_on_off_policy", "Q-learning", 15, 25),
        ("02_on_off_policy", "SARSA", 15, 25),
        ("02_on_off_policy", optimist(QLearning), 66, 78),
        ("02_on_off_policy", optimist(DynaQ), 75, 100),
        ("03_depth", optimist(TreeBackup, learning_rate=0.5, n=10, initial_value=5.0), 75, 100),
        ("04_dimensionality", "DQN", 10, 30),
        ("05_memory", "Q-learning", 1, 5),
        ("06_signal", "majority vote", 61, 69),
        ("07_continuous_actions", "the lesson's agent", 20, 80),
        ("08_stochasticity", optimist(QLearning, learning_rate=0.1, exploration=EpsilonGreedy(0.1)), 70, 95),
        ("09_model_based", "R-max", 10, 90),
    ],
)
def test_points(lesson: str, agent: Any, low: float, high: float) -> None:
    """Nobody gets all of them, and the methods of the lesson get what its text says."""
    challenge = CHALLENGES[lesson]
    score = challenge.score(challenge.baselines[agent] if isinstance(agent, str) else agent, "Ada Lovelace")
    assert low < score.points < high
    assert score.rows[challenge.best_label] == (challenge.optimum, challenge.best_average)
