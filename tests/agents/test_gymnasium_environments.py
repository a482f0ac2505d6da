"""What the agents reach in other people's environments: what the literature says, each with a control that does not."""

from collections.abc import Callable
from functools import cache
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import (
    SARSA,
    DynaQ,
    EpsilonGreedy,
    ExpectedSARSA,
    Identity,
    LinearDecay,
    LinearQLearning,
    NStepSARSA,
    PrioritisedSweeping,
    QLearning,
    RMax,
    Run,
    SARSALambda,
    ScheduledEpsilonGreedy,
    SemiGradientSARSA,
    TileCoding,
    train,
)

NOTHING = 5e-324
"""A learning rate so small that nothing is learned."""

Make = Callable[[Any], Any]


def make(name: str, **parameters: Any) -> Any:
    """The newest version of an environment that this Gymnasium has."""
    newest = max(key for key in gymnasium.registry if key.startswith(f"{name}-v"))
    return gymnasium.make(newest, disable_env_checker=True, **parameters)


def trained(env: Any, create: Make, n_steps: int, episodes: int, seed: int, **how: Any) -> Run:
    """A run with two points, at the start and at the end."""
    how = {"evaluate_every": n_steps, "evaluation_episodes": episodes, "seed": seed} | how
    return train(env, create(env), n_steps, **how)


def plain(kind: Any, learning_rate: float = 0.5, **settings: Any) -> Make:
    """An agent as it is in the example of the cliff: ε = 0.1, not discounted."""
    return lambda env: kind.create(env, learning_rate=learning_rate, discount=1.0, **settings)


OPTIMAL: dict[str, tuple[Make, int]] = {  # those that learn of the best policy, and the steps that they are given
    "Q-learning": (plain(QLearning), 15_000),
    "Dyna-Q": (plain(DynaQ), 3_000),
    "prioritised sweeping": (plain(PrioritisedSweeping), 3_000),
    "R-max": (lambda env: RMax.create(env, discount=1.0, highest_return=0.0, lowest_return=-1_000.0), 3_000),
    "linear": (lambda env: plain(LinearQLearning, features=Identity.create(env, constant=0.0))(env), 15_000),
}
SAFE: dict[str, Make] = {  # those that learn of the policy that they follow, slips included
    "SARSA": plain(SARSA, 0.2),
    "expected SARSA": plain(ExpectedSARSA),
    "n-step SARSA": plain(NStepSARSA, 0.1, n=2),
    "SARSA(λ)": plain(SARSALambda, 0.2, trace_decay=0.5),
    "linear SARSA": lambda env: plain(SemiGradientSARSA, 0.2, features=Identity.create(env, constant=0.0))(env),
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if OPTIMAL[name][1] < 10_000 else pytest.mark.slow) for name in OPTIMAL]
)
def test_along_the_cliff(name: str) -> None:
    """CliffWalking: 13 steps along the edge (Sutton and Barto, example 6.6)."""
    create, n_steps = OPTIMAL[name]
    runs = [trained(make("CliffWalking"), create, n_steps, 1, seed, max_steps=200) for seed in range(2)]
    assert [run.returns[-1] for run in runs] == [-13.0] * 2


@cache
def bold() -> float:
    """What Q-learning earns while it explores, after as many steps."""
    how = {"max_steps": 200, "evaluate_every": 5_000}
    return float(trained(make("CliffWalking"), plain(QLearning), 20_000, 1, 0, **how).training_returns[-1])


@pytest.mark.slow
@pytest.mark.parametrize("name", SAFE)
def test_away_from_the_cliff(name: str) -> None:
    """A longer path, on which slips cost less: more than Q-learning earns while it explores (example 6.6)."""
    runs = [
        trained(make("CliffWalking"), SAFE[name], 20_000, 1, seed, max_steps=200, evaluate_every=5_000)
        for seed in range(3)
    ]
    assert all(-22 <= run.returns[-1] <= -15 for run in runs)
    assert min(run.training_returns[-1] for run in runs) > bold()


ON_ICE: dict[str, tuple[Make, int]] = {
    "Q-learning": (
        lambda env: QLearning.create(
            env, learning_rate=0.05, exploration=ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.05, 100_000))
        ),
        150_000,
    ),
    "R-max": (lambda env: RMax.create(env, known_after=50, highest_return=1.0, lowest_return=0.0), 30_000),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", ON_ICE)
def test_frozen_lake(name: str) -> None:
    """On slippery ice no policy crosses more than 74 % of the time (exactly, with 100 steps); random play 1 to 2 %."""
    create, n_steps = ON_ICE[name]
    run = trained(make("FrozenLake", is_slippery=True), create, n_steps, 1_000, 2)
    assert 0.65 < run.returns[-1] < 0.78
    assert run.returns[0] < 0.1


@pytest.mark.slow
def test_mountain_car_with_tiles() -> None:
    """To under 150 steps (figure 10.2 has some 130 to 150 then); without learning it never gets out of the valley."""

    def last_return(learning_rate: float, seed: int) -> float:
        env = make("MountainCar")
        how = {"features": TileCoding.create(env), "exploration": EpsilonGreedy(0.0)}
        return float(trained(env, plain(LinearQLearning, learning_rate, **how), 30_000, 10, seed).returns[-1])

    assert np.mean([last_return(0.5, seed) for seed in range(3)]) > -150
    assert last_return(NOTHING, 0) == -200
