"""What is learned without acting: from data that somebody else has gathered, and from what a teacher prefers."""

import numpy as np

import edugym
from benchmarks.measure import Comparison, Contender, Work

DISCOUNT = 0.9
EPISODES, COMPARISONS = 1_000, 100


def comparisons() -> list[Comparison]:
    """Fitted Q from one dataset, and rewards from one set of comparisons."""
    return [
        Comparison("fitted Q iteration on Roadrunner", "steps of data", Contender("EduGym", fitted), []),
        Comparison("rewards from preferences", "comparisons", Contender("EduGym", preferred), []),
    ]


def fitted() -> Work:
    """The same dataset of random play, fitted again and again until its values settle."""
    model = edugym.finite_model(edugym.make_mdp("Roadrunner"))
    dataset = edugym.collect(model, np.full(model.rewards.shape[:2], 1 / 3), EPISODES, seed=0)

    def work(n: int) -> int:
        times = max(n // len(dataset.states), 1)
        for _ in range(times):
            edugym.fitted_q_iteration(dataset, DISCOUNT)
        return times * len(dataset.states)

    return work


def preferred() -> Work:
    """A hundred comparisons of pieces of behaviour in 20 states with 3 actions."""
    rng = np.random.default_rng(0)
    first, second = rng.integers(0, 3, (2, COMPARISONS, 20, 3)).astype(float)
    answers = rng.random(COMPARISONS) < 0.5

    def work(n: int) -> int:
        times = max(n // COMPARISONS, 1)
        for _ in range(times):
            edugym.fit_rewards(first, second, answers)
        return times * COMPARISONS

    return work
