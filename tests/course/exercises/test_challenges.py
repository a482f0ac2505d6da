"""The open challenges: each is the one of which its lesson tells."""

from importlib import import_module
from math import inf
from typing import Any

import build
import pytest

from edugym import EpsilonGreedy
from edugym_course.grading.challenge import Challenge, Sizes

Baselines = dict[str, tuple[str, dict[str, Any]]]
A_TENTH = {"learning_rate": 0.1, "discount": 1.0, "exploration": EpsilonGreedy(0.1)}
RISK = {"learning_rate": 0.02, "discount": 1.0, "exploration": EpsilonGreedy(0.1)}
GAUSSIAN = {"learning_rate": 0.02, "value_learning_rate": 0.4, "discount": 0.99}

CHALLENGES: dict[str, tuple[int, float, float, str, list[str], Baselines]] = {
    "01_exploration": (
        5_000,
        1.0,
        1 - 975 / 5_000,
        "return",
        ["975 steps on average"],
        {
            "Go-Explore": ("GoExplore", {"learning_rate": 0.5, "discount": 0.9, "explore_steps": 20}),
            "optimistic": ("QLearning", {"learning_rate": 1.0, "discount": 0.9, "exploration": EpsilonGreedy(0.0)}),
            "novelty reward": ("CountBased", {"learning_rate": 0.5, "discount": 0.9, "bonus": 1.0}),
        },
    ),
    "02_on_off_policy": (
        5_000,
        -2.0,
        -2.0,
        "training_return",
        ["No run is better than −2.", "*all* training episodes count"],
        {
            "Q-learning": ("QLearning", A_TENTH),
            "SARSA": ("SARSA", A_TENTH),
            "expected SARSA": ("ExpectedSARSA", A_TENTH),
        },
    ),
    "03_depth": (
        10_000,
        10.0,
        10.0,
        "return",
        ["in percent of 10."],
        {
            "n = 1": ("NStepSARSA", {"n": 1, **A_TENTH}),
            "n = 3": ("NStepSARSA", {"n": 3, **A_TENTH}),
            "Monte Carlo": ("NStepSARSA", {"n": inf, **A_TENTH}),
        },
    ),
    "04_dimensionality": (
        8_000,
        1.0,
        1.0,
        "return",
        ["in percent of 1, the optimum"],
        {
            "DQN": ("DQN", {"discount": 0.9, "learn_from": 200, "copy_every": 100}),
            "linear in the pixels": ("LinearQLearning", {"discount": 0.9}),
        },
    ),
    "05_memory": (
        5_000,
        100.0,
        64.0,
        "training_return",
        ["percent of 64", "**All training episodes count**"],
        {"Q-learning": ("QLearning", {"discount": 0.8}), "the lesson's notes": ("Rememberer", {})},
    ),
    "06_signal": (
        20_000,
        6595.22,
        6595.22,
        "training_return",
        ["the optimum, 6 595", "*All* training episodes count"],
        {
            "obey the first word": ("Voter", {"heard": 1}),
            "majority vote": ("Voter", {"heard": 4}),
            "in turn": ("RoundRobin", {}),
            "Q-learning": ("QLearning", {"learning_rate": 0.1, "discount": 0.5, "exploration": EpsilonGreedy(0.1)}),
        },
    ),
    "07_continuous_actions": (
        50_000,
        5.0,
        5.0,
        "return",
        ["in percent of 5."],
        {
            "the lesson's agent": ("GaussianActorCritic", {**GAUSSIAN, "spread": 0.5}),
            "the lesson's agent, first values 0": ("GaussianActorCritic", {**GAUSSIAN, "spread": 0.5}),
            "the lesson's agent, σ = 0.2": ("GaussianActorCritic", {**GAUSSIAN, "spread": 0.2}),
        },
    ),
    "08_stochasticity": (
        5_000,
        0.868,
        0.868,
        "training_return",
        ["return is 0.868.", "*all* training games count"],
        {
            "averse, β = -2": ("RiskSensitiveQLearning", {"risk": -2.0, **RISK}),
            "neutral, β = 0": ("RiskSensitiveQLearning", {"risk": 0.0, **RISK}),
            "seeking, β = 2": ("RiskSensitiveQLearning", {"risk": 2.0, **RISK}),
        },
    ),
    "09_model_based": (
        3_000,
        95.0,
        95.0,
        "return",
        ["in percent of 95."],
        {
            "R-max": ("RMax", {"discount": 0.99, "known_after": 1}),
            "Dyna-10": ("DynaQ", {"discount": 0.99, "expected_updates": False}),
            "prioritised sweeping": ("PrioritisedSweeping", {"discount": 0.99, "expected_updates": True}),
        },
    ),
}


def challenge_of(lesson: str) -> Challenge:
    """The open challenge of a lesson."""
    challenge: Challenge = import_module(f"edugym.exercises.{lesson.partition('_')[2]}").CHALLENGE
    return challenge


def baselines_of(challenge: Challenge) -> dict[str, Any]:
    """Its baselines, made for one of its tasks."""
    task = challenge._task(1)
    return {
        label: make(Sizes(task.observation_space, task.action_space)) for label, make in challenge.baselines.items()
    }


@pytest.mark.parametrize("lesson", CHALLENGES)
def test_a_challenge_is_that_of_its_lesson(lesson: str) -> None:
    """Steps, what is possible, which returns count, and the agents to beat."""
    n_steps, optimum, best_average, column, told, baselines = CHALLENGES[lesson]
    challenge = challenge_of(lesson)
    assert (challenge.n_steps, challenge.repetitions, challenge.column) == (n_steps, 10, column)
    assert challenge.optimum == optimum
    assert challenge.best_average == pytest.approx(best_average)
    source = build.lesson_sources()[lesson].read_text(encoding="utf-8")
    text = " ".join(source.partition("### The open challenge")[2].partition("# %%")[0].replace("\n# ", " ").split())
    for words in (f"{n_steps:,} steps".replace(",", " "), *told):
        assert words in text
    made = baselines_of(challenge)
    found = {
        label: (type(agent).__name__, {name: getattr(agent, name) for name in settings})
        for (label, agent), (_, settings) in zip(made.items(), baselines.values(), strict=True)
    }
    assert found == baselines


def test_tasks_of_the_challenges() -> None:
    """Those that are given by name, and the toy with four words and few moods."""
    given = {
        lesson: (challenge.environment, dict(challenge.parameters))
        for lesson in CHALLENGES
        if isinstance((challenge := challenge_of(lesson)).environment, str)
    }
    assert given == {
        "01_exploration": ("Boulder", {"height": 60}),
        "02_on_off_policy": ("Roadrunner", {}),
        "03_depth": (
            "Study",
            {"n_actions": 8, "action_reward_noise_mean": 0.0, "action_reward_noise_sigma": 0.2},
        ),
        "08_stochasticity": ("Golf", {"stochasticity_level": 0.015, "observe_hits": True}),
        "09_model_based": ("Supermarket", {}),
    }
    toy = challenge_of("06_signal").environment
    assert (toy.moods, toy.drop) == (0.1, 20)
    assert (toy.mdp.tau, toy.mdp.max_msg_length) == (0.05, 4)


def test_first_values_of_baselines() -> None:
    """The optimist's are 1; those of the lesson's Gaussian agent are not 0, but for the baseline that says so."""
    assert (baselines_of(challenge_of("01_exploration"))["optimistic"].Q == 1).all()
    gaussians = baselines_of(challenge_of("07_continuous_actions"))
    assert {label: bool(agent.value_weights.any() or agent.weights.any()) for label, agent in gaussians.items()} == {
        label: "first values 0" not in label for label in gaussians
    }
