"""Agents of Stable-Baselines3 with our learning curves."""

from typing import Any

import numpy as np
import pytest
import torch

from edugym import make_mdp
from edugym.deep import stable_baselines3_run
from edugym.deep.baselines import _policy
from edugym.deep.library import LibraryAgent
from edugym.training.run import Run
from tests.deep.test_curves import measured
from tests.messages import named

FEW: dict[str, dict[str, Any]] = {
    "DQN": {"learning_starts": 10, "buffer_size": 100},
    "PPO": {"n_steps": 8, "batch_size": 16, "n_epochs": 1},
    "A2C": {"n_steps": 4},
    "QRDQN": {"learning_starts": 10, "buffer_size": 100},
    "RecurrentPPO": {"n_steps": 8, "batch_size": 16, "n_epochs": 1, "policy_kwargs": {"lstm_hidden_size": 8}},
}


@pytest.mark.parametrize("algorithm", FEW)
def test_every_algorithm_gives_a_run(algorithm: str) -> None:
    """With points where they are due, and again with the same seed; torch has the threads that it had."""
    threads = torch.get_num_threads()
    arguments: dict[str, Any] = {"num_envs": 4, "evaluate_every": 32, "evaluation_episodes": 3, **FEW[algorithm]}
    runs = [stable_baselines3_run("Catch", algorithm, 96, seed=seed, **arguments) for seed in (3, 3)]
    assert isinstance(runs[0], Run)
    assert runs[0].steps.tolist() == [0, 32, 64, 96]
    assert runs[0].complete
    assert runs[0].episodes.sum() == 96 // 9 // 4 * 4  # an episode in each of four copies takes nine steps
    assert np.array_equal(runs[0].returns, runs[1].returns)
    assert np.array_equal(runs[0].training_returns, runs[1].training_returns, equal_nan=True)
    assert set(np.unique(runs[0].returns * 3)) <= {-3.0, -1.0, 1.0, 3.0}
    assert torch.get_num_threads() == threads


def test_the_seed_decides_which_episodes_evaluate() -> None:
    """A network that learns next to nothing plays those of a curve with this seed, and not those of another."""
    still: dict[str, Any] = {"learning_rate": 1e-12, "n_steps": 4, "evaluate_every": 8, "evaluation_episodes": 3}
    run = stable_baselines3_run("Tamagotchi", "A2C", 8, num_envs=2, seed=3, **still)
    evaluated = [measured("Tamagotchi", lambda: _policy(run.agent, False), 3, (0, 8), seed) for seed in (3, 0)]
    assert run.returns.tolist() == evaluated[0] != evaluated[1]


def test_parameters_and_own_policies() -> None:
    """Those of the environment reach training and evaluation."""
    how: dict[str, Any] = {"parameters": {"n_bins": 3}, "evaluation_episodes": 1, "policy": "MlpPolicy"}
    assert stable_baselines3_run("Trashbot", "A2C", 8, num_envs=2, **how).agent.action_space.nvec.tolist() == [3, 3]


def test_what_is_wrong_is_refused() -> None:
    """Other algorithms, no steps."""
    wrong: list[tuple[str, int, dict[str, Any], str]] = [
        ("SAC", 100, {}, named("algorithm", "'DQN'", "'PPO'", "'A2C'", "'RecurrentPPO'", "'SAC'")),
        ("PPO", 0, {}, named("n_steps", 1, 0)),
        ("PPO", 100, {"evaluate_every": 0}, named("evaluate_every", 1, 0)),
    ]
    for algorithm, n_steps, how, message in wrong:
        with pytest.raises(ValueError, match=message):
            stable_baselines3_run("Catch", algorithm, n_steps, **how)


@pytest.mark.parametrize(("n_steps", "updates"), [(7, 0), (8, 1), (15, 1), (16, 2)])
def test_a_round_that_does_not_fit_is_not_learned_from(n_steps: int, updates: int) -> None:
    """Rounds of 8 steps; the budget is kept to the step."""
    made = LibraryAgent.create(make_mdp("Catch"), "PPO", **FEW["PPO"] | {"batch_size": 8})
    run = made.train(n_steps, evaluate_every=n_steps, evaluation_episodes=1)
    assert run.steps[-1] == n_steps
    assert run.agent._n_updates == updates


def test_which_agents_fit_where() -> None:
    """Values of actions need actions that can be counted; a memory takes numbers of several kinds too."""
    for algorithm in ("DQN", "QRDQN"):
        with pytest.raises(ValueError, match=r"needs the actions 0, 1, .* but the action space is Box"):
            LibraryAgent.create(make_mdp("Trashbot"), algorithm)
    with pytest.raises(ValueError, match=named("algorithm", "'DQN'", "'SAC'")):
        LibraryAgent.create(make_mdp("Catch"), "SAC")
    run = LibraryAgent.create(make_mdp("Golf"), "RecurrentPPO", **FEW["RecurrentPPO"]).train(8, evaluation_episodes=1)
    assert run.steps[-1] == 8


@pytest.mark.slow
def test_it_learns_catch() -> None:
    """PPO, nearly every ball in 20 000 steps; with hardly any learning, few."""
    settings: dict[str, Any] = {"num_envs": 64, "n_steps": 32, "batch_size": 512}
    run = stable_baselines3_run("Catch", "PPO", 20_000, learning_rate=2e-3, **settings)
    assert run.returns.max() > 0.95
    assert stable_baselines3_run("Catch", "PPO", 4_000, learning_rate=1e-12, **settings).returns[-1] < 0.5
