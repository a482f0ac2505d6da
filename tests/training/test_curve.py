"""What a run records, that it comes again with its seed, and that it can be stopped."""

import math
import threading
from pathlib import Path
from typing import Any
from unittest.mock import MagicMock

import gymnasium
import numpy as np
import pytest

from edugym import SARSA, EpsilonGreedy, MDPEnv, QLearning, make_mdp, train
from edugym.compiled import execution
from tests.experiments.experiments import small
from tests.training.tasks import Ring, SlipperyWalk, Stairs


@pytest.mark.parametrize("n_steps", [10, 6_000])
@pytest.mark.parametrize("kind", [QLearning, SARSA])
@pytest.mark.parametrize("wrapped", [False, True], ids=["MDP", "Gymnasium"])
def test_the_curve_by_hand(wrapped: bool, kind: Any, n_steps: int) -> None:
    """Episodes of three steps that return 6 end after 3, 6, 9, ... steps."""
    task = gymnasium.Wrapper(MDPEnv(Stairs())) if wrapped else Stairs()
    run = train(task, kind.create(Stairs()), n_steps, evaluate_every=4)
    assert run.steps.tolist() == [*range(0, n_steps, 4), n_steps]
    assert run.returns.tolist() == [6.0] * len(run.steps)
    assert run.episodes[:3].tolist() == [0, 1, 1]
    assert run.episodes.cumsum().tolist() == [step // 3 for step in run.steps]
    assert math.isnan(run.training_returns[0])
    assert run.training_returns[1:].tolist() == [6.0] * (len(run.steps) - 1)
    assert run.complete
    columns = run.steps, run.returns, run.training_returns, run.episodes
    assert [column.dtype for column in columns] == [np.int64, np.float64, np.float64, np.int64]


def test_points() -> None:
    """By default a hundred, and one at the start; short runs have one for each step; without an episode it is NaN."""
    agent = QLearning.create(Stairs())
    assert train(Stairs(), agent, 1_000).steps.tolist() == list(range(0, 1_001, 10))
    assert train(Stairs(), agent, 3).steps.tolist() == [0, 1, 2, 3]
    for every in (70, 999, 1_000):
        assert train(Stairs(), agent, 3_000, evaluate_every=every).steps.tolist() == [*range(0, 3_000, every), 3_000]
    run = train(Stairs(), agent, 10, evaluate_every=2)  # episodes end in the intervals (2, 4], (4, 6], (8, 10]
    assert run.episodes.tolist() == [0, 0, 1, 1, 0, 1]
    assert np.isnan(run.training_returns).tolist() == [True, True, False, False, True, False]
    small: Any = np.int8(100)  # in which 100 + 100 is -56
    assert train(Stairs(), agent, small, evaluate_every=small).steps.tolist() == [0, 100]


def test_a_point_is_the_mean_of_its_evaluation_episodes() -> None:
    """One random agent, evaluated on many episodes and on one."""
    agent = QLearning.create(SlipperyWalk(), learning_rate=5e-324, exploration=EpsilonGreedy(1.0))
    agent.Q[:, 1] = 1.0  # it goes right, and that is not changed
    many = train(SlipperyWalk(), agent, 1, evaluation_episodes=2_000)
    right = 0.8 / 0.2  # gambler's ruin: 6 comes before 0 with probability (1 - 1/4^s) / (1 - 1/4^6) from s
    success = np.mean([(1 - right**-s) / (1 - right**-6) for s in (2, 3, 4)])
    assert many.returns == pytest.approx([2 * success - 1] * 2, abs=0.05)
    one = train(SlipperyWalk(), agent, 200)
    assert set(np.sign(one.returns)) == {-1.0, 1.0}


def test_training_returns_include_exploration() -> None:
    """Mean return of the training episodes against an evaluation that does not explore."""
    mdp = make_mdp("Boulder", height=4, max_steps=4)
    run = train(mdp, QLearning.create(mdp, initial_value=1.0), 200_000, evaluate_every=100_000, seed=1)
    assert run.returns[-1] == 1.0
    assert run.training_returns[-1] == pytest.approx(0.95**4, abs=0.01)  # ε/2 of the grips are wrong


def test_a_seed_repeats_a_run_bit_for_bit() -> None:
    """Tables and curve; another seed gives another run, also in a Gymnasium environment."""
    for task, n_steps in ((SlipperyWalk(), 6_000), (gymnasium.Wrapper(MDPEnv(SlipperyWalk())), 1_000)):
        runs = [train(task, QLearning.create(SlipperyWalk()), n_steps, seed=seed) for seed in (3, 3, 4)]
        for attribute in ("steps", "returns", "training_returns", "episodes"):
            assert np.array_equal(getattr(runs[0], attribute), getattr(runs[1], attribute), equal_nan=True)
        assert np.array_equal(runs[0].agent.Q, runs[1].agent.Q)
        assert not np.array_equal(runs[0].agent.Q, runs[2].agent.Q)
        assert (runs[0].seed, runs[2].seed) == (3, 4)


@pytest.mark.filterwarnings("ignore:no episode of Ring")
def test_a_task_without_end_or_limit_is_evaluated_all_the_same() -> None:
    """For a thousand steps, or as many as are asked for."""
    assert train(Ring(None), QLearning.create(Ring()), 10).returns.tolist() == [1_000.0] * 11
    assert train(Ring(None), QLearning.create(Ring()), 1, max_steps=2_500).returns.tolist() == [2_500.0] * 2


def test_stop_ends_a_run_before_it_begins(monkeypatch: pytest.MonkeyPatch) -> None:
    """With what has been measured, and nothing compiled."""
    new = type("New", (Stairs,), {"__slots__": ()})
    monkeypatch.setattr(execution, "compiled", None)
    stop = threading.Event()
    stop.set()
    run = train(new(), QLearning.create(Stairs()), 10**12, stop=stop)
    assert (run.steps.tolist(), run.returns.tolist(), run.complete) == ([0], [6.0], False)


def test_stop_ends_a_run_on_the_way() -> None:
    """Set by another thread, while this one is busy with machine code; nothing is warned of."""
    train(SlipperyWalk(), QLearning.create((7, 2)), 10_000)  # compiled now, so that the time is that of the run
    stop = threading.Event()
    timer = threading.Timer(0.3, stop.set)
    timer.start()
    run = train(SlipperyWalk(), QLearning.create((7, 2)), 10**12, evaluate_every=10**5, stop=stop)
    timer.join()
    assert not run.complete
    assert run.agent.Q.any()
    assert 0 < len(run.steps) < 10**6


def test_a_long_evaluation_stops_between_episodes() -> None:
    """A point that is stopped on the way is none: all of its episodes would take hours."""
    stop = threading.Event()
    threading.Timer(0.5, stop.set).start()
    wall = make_mdp("Boulder", height=100, max_steps=100_000)
    run = train(wall, QLearning.create(wall), 1_000_000, evaluation_episodes=10**6, stop=stop)
    assert (run.complete, len(run.steps)) == (False, 0)


@pytest.fixture
def bars(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """All bars that are shown: mocks, with what they have `seen`, and which say whether they are `closed`."""
    made = list[Any]()

    def bar(**how: Any) -> MagicMock:
        one = MagicMock(how=how, seen=[0], closed=False)
        one.__enter__.return_value = one
        one.__exit__.side_effect = lambda *_: setattr(one, "closed", True)
        one.update.side_effect = lambda n: one.seen.append(one.seen[-1] + n)
        made.append(one)
        return one

    monkeypatch.setattr("tqdm.auto.tqdm", bar)
    return made


def test_progress_counts_every_step(bars: list[Any]) -> None:
    """And is closed at the end."""
    train(Stairs(), QLearning.create(Stairs()), 1_234, progress=True)
    (bar,) = bars
    assert (bar.seen[-1], bar.closed) == (1_234, True)
    assert bar.how == {"total": 1_234, "unit": "steps", "unit_scale": True, "smoothing": 0.1}  # at the speed of late


def test_progress_of_an_experiment(bars: list[Any], tmp_path: Path) -> None:
    """It moves when a run is done, begins with the runs that were done before, and is not shown unless asked for."""
    small(300, checkpoints=tmp_path, repetitions=1)
    assert bars == []
    small(300, checkpoints=tmp_path, progress=True)
    (bar,) = bars
    assert (bar.how["total"], bar.how["unit"], bar.closed) == (1_800, "steps", True)
    assert bar.seen == [0, 600, 900, 1_200, 1_500, 1_800]
