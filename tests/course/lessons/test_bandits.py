"""Bandits: the regret that is counted is the exact one, who pays it, and what a program may not do."""

from typing import Any

import numpy as np
import pytest

from edugym import UCB, finite_model, make_mdp, mean_interval, paired_difference, regret
from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.bandits import methods, project, worlds
from edugym_course.lessons.bandits.methods import Pulls


@pytest.mark.parametrize("drift", [0.0, 0.1])
@pytest.mark.parametrize("method", methods.METHODS)
def test_the_regret_is_that_of_the_exact_model(method: str, drift: float) -> None:
    """After each number of pulls. Runs repeat, and differ with the seed."""
    found = methods.pulls(method, 50, repetitions=3, seed=1, n_arms=4, gap=0.5, drift=drift)
    model = finite_model(make_mdp("Bandit", n_arms=4, gap=0.5, drift=drift))
    for run in range(3):
        if drift == 0:  # then the model has one state, and the best arm of its layout may be another one
            assert len({*found.best[run]}) == 1
            exact = np.cumsum(0.5 * (found.arms[run] != found.best[run]))
        else:
            exact = regret(model, found.arms[run].astype(int), found.best[run].tolist())
        assert [found.regret(t)[run] for t in range(1, 51)] == pytest.approx(exact, abs=1e-12)
    again, other = (methods.pulls(method, 50, repetitions=3, seed=s, n_arms=4, gap=0.5, drift=drift) for s in (1, 2))
    assert (again.arms == found.arms).all()
    assert (other.arms != found.arms).any()


def test_what_is_counted() -> None:
    """Two runs of ten pulls, by hand."""
    arms = np.array([[0, 1, 2, 2, 2, 2, 2, 2, 2, 2], [1, 1, 1, 1, 1, 0, 0, 0, 0, 1]])
    best = np.full((2, 10), 2)
    best[1] = 0
    found = Pulls(arms, best, 0.5)
    assert found.regret().tolist() == [1.0, 3.0]
    assert found.regret(3).tolist() == [1.0, 1.5]
    assert found.between(0, 2).tolist() == [0.5, 0.5]
    assert found.between(5, 10).tolist() == [0.0, 0.1]
    assert found.settled().tolist() == [1.0, 0.0]  # the last pull is a tenth
    assert found.by_rank().tolist() == [[8, 1, 1], [4, 6, 0]]


def test_strategies_of_the_lesson() -> None:
    """An ε of 200/t; and first all arms equally often, then the best mean."""
    falling = methods.OneOverT(200.0)
    assert [falling.value(step) for step in (0, 199, 399, 1999)] == [1.0, 1.0, 0.5, 0.1]
    strategy, rng = methods.TryFirst(np.zeros((1, 3), np.int64), 2), np.random.default_rng(0)
    Q = np.array([[0.1, 0.3, 0.2]])
    assert sorted(strategy.choose(Q, 0, rng) for _ in range(6)) == [0, 0, 1, 1, 2, 2]
    assert [strategy.choose(Q, 0, rng) for _ in range(5)] == [1] * 5


def test_bonus_at_first() -> None:
    """It is UCB at first, and then goes by the means alone."""
    strategy, rng = methods.BonusAtFirst(UCB.create((1, 3)), 4), np.random.default_rng(0)
    Q = np.array([[0.1, 0.3, 0.2]])
    assert sorted(strategy.choose(Q, 0, rng) for _ in range(3)) == [0, 1, 2]
    assert [strategy.choose(Q, 0, rng) for _ in range(50)] == [1] * 50
    assert strategy.ucb.counts.sum() == 4


def test_exact_shares() -> None:
    """Greedy stays with the first arm that pays; a share ε of random pulls costs ε Δ (n - 1)/n."""
    assert methods.stuck(10, 0.2) == pytest.approx(1 / 7)
    assert methods.stuck(3, 1.0) == 1.0
    settled = methods.pulls("greedy", methods.SHORT, repetitions=400, seed=3, n_arms=5).settled()
    interval = mean_interval(settled, confidence=0.999)
    assert interval.low < methods.stuck(5) < interval.high
    costs = methods.pulls("random", 2_000, repetitions=20, seed=3, n_arms=4, gap=0.4).regret() / 2_000
    assert costs.mean() == pytest.approx(methods.slope(1.0, 4, 0.4), rel=0.02)


def test_who_pays_less() -> None:
    """Thompson sampling less than ε-greedy; with drift a constant learning rate less than sample averages."""
    how: Any = {"repetitions": 20, "seed": 3}
    still, moving = (
        {
            method: methods.pulls(method, drift=drift, **how).regret()
            for method in (methods.SLIPS, methods.STEADY, methods.THOMPSON)
        }
        for drift in (0.0, 0.001)
    )
    assert paired_difference(still[methods.THOMPSON], still[methods.SLIPS]).high < -20
    assert paired_difference(still[methods.STEADY], still[methods.SLIPS]).low > 100
    assert paired_difference(moving[methods.STEADY], moving[methods.SLIPS]).high < -100


@pytest.mark.parametrize(
    ("seed", "truncates", "lower", "noise"), [(0, True, 0, 2.0), (1, False, 2, 2.0), (2, True, 0, 0.1)]
)
def test_worlds_of_the_project(seed: int, truncates: bool, lower: float, noise: float) -> None:
    """Rewards follow means of their own, which may be below 0; an end is a truncation where it should be."""
    world = worlds.Machines(seed, truncates)
    world.reset(seed=seed)
    rewards = np.array([[world.step(arm)[1] for _ in range(4_000)] for arm in range(4)])
    assert sorted(rewards.mean(axis=1)) == pytest.approx(np.array([-0.5, 0.5, 0.8, 1.0]) - lower, abs=0.15)
    assert rewards.std(axis=1) == pytest.approx(noise, rel=0.05)
    world.reset()
    ends = [world.step(0)[2:4] for _ in range(40)]
    assert set(ends[:-1]) == {(False, False)}
    assert ends[-1] == (not truncates, truncates)


def test_bandits_that_show_every_arm() -> None:
    """Their best arms differ, so that each arm is pulled at random alone in one of them."""
    made = [make_mdp("Bandit", n_arms=project.SURE_ARMS, layout_seed=number) for number in project.LAYOUTS]
    assert len({mdp.initial(np.random.default_rng(0)) for mdp in made}) == len(made)


@pytest.mark.slow
def test_a_program_that_only_knows_the_arm_is_refused() -> None:
    """Whoever always pulls one arm has no policy that follows from its steps."""

    def program(environment: Any, n_steps: int, seed: int) -> Any:
        rng = np.random.default_rng(seed)
        environment.reset(seed=seed)
        for _ in range(n_steps):
            *_, terminated, truncated, _ = environment.step(int(rng.integers(4)) if rng.random() < 0.1 else 0)
            if terminated or truncated:
                environment.reset()
        return lambda state: 0

    with pytest.raises(WrongAnswer, match="are not greedy"):
        project.project_0b(program, 0)
