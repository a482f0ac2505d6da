"""The benchmark runs, and writes down what it measured (how fast anything is, depends on the machine)."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from benchmarks import solving
from benchmarks.__main__ import solving_table
from benchmarks.comparisons import comparisons
from benchmarks.solving import OURS, TASKS, THEIRS, Solved

ROOT = Path(__file__).parents[1]


def benchmark(*options: str) -> str:
    """What the benchmark prints."""
    command = [sys.executable, "-m", "benchmarks", "--quick", *options]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def spread(values: dict[str, float]) -> bool:
    """Whether these are a median and the values around it."""
    return 0 < values["low"] <= values["median"] <= values["high"]


@pytest.mark.slow
def test_everything_is_measured_and_written_down(tmp_path: Path) -> None:
    """Every comparison has a rate for each contender, a ratio for each of the others, and says which aims are met."""
    printed = benchmark("--json", str(tmp_path / "results.json"))
    results: dict[str, Any] = json.loads((tmp_path / "results.json").read_text())
    assert {"cpu", "python", "edugym", "gymnasium", "numba", "numpy"} <= set(results["machine"])
    assert len({comparison["name"] for comparison in results["comparisons"]}) == len(results["comparisons"]) >= 12
    for comparison in results["comparisons"]:
        ours, *others = comparison["per_second"]
        assert others == list(comparison["edugym_is_times_as_fast_as"])
        for name, ratio in comparison["edugym_is_times_as_fast_as"].items():
            fast, slow = comparison["per_second"][ours], comparison["per_second"][name]
            assert ratio["median"] == pytest.approx(fast["median"] / slow["median"])  # there was one round only
            assert all(map(spread, (fast, slow, ratio)))
        assert f"{comparison['name']} ({comparison['unit']} a second)" in printed
    assert {">= 1 M/s", ">= 100 x"} <= {aim for comparison in results["comparisons"] for aim in comparison["targets"]}
    assert [solved["name"] for solved in results["times_to_solve"]] == [task.name for task in TASKS]
    assert all(list(solved["seconds_by_seed"]) == [OURS, THEIRS] for solved in results["times_to_solve"])
    assert list(results["import_seconds"]) == ["edugym", "gymnasium", "numpy"]
    assert all(spread(taken) for taken in results["import_seconds"].values())


@pytest.mark.parametrize(
    "of", ["Bandit", "Casino", "Switches", "Diver", "soccer", "fitted Q iteration", "preferences", "UCT"]
)
def test_each_challenge_has_a_speed(of: str) -> None:
    """Of the lessons on what the paper leaves out, too."""
    assert [one for one in comparisons() if of in one.name]


@pytest.mark.parametrize("of", ["HindsightQLearning", "fitted Q", "preferences"])
def test_the_speed_is_that_of_work_done(of: str) -> None:
    """Each contender does roughly as many units as it is asked for, and says how many."""
    (found,) = (one for one in comparisons() if of in one.name)
    for contender in (found.ours, *found.others):
        assert contender.prepare()(5_000) == pytest.approx(5_000, rel=0.5)


def test_times_to_solve() -> None:
    """A ratio is within a seed, and of the seeds that both have solved; those that are not are counted."""
    solved = Solved(TASKS[0], {OURS: [1.0, 2.0, None, 4.0], THEIRS: [3.0, None, 5.0, 8.0]})
    assert solved.times == {OURS: (2, 1, 4), THEIRS: (5, 3, 8)}
    assert solved.ratio == (2.5, 2, 3)
    _, ours, theirs = (line.split() for line in solving_table(solved))
    assert [word for word in ours if word in "12-4"][:4] == ["2", "1", "-", "4"]
    assert "2.5" in theirs
    nothing = Solved(TASKS[0], {OURS: [None], THEIRS: [3.0]})
    assert (nothing.ratio, nothing.times) == (None, {THEIRS: (3, 3, 3)})
    assert len(list(solving_table(nothing))) == 3


@pytest.mark.slow
def test_both_have_the_same_settings() -> None:
    """And as many points of the curve, one before training and one after each round."""
    pytest.importorskip("stable_baselines3")
    for task in TASKS:
        ours, theirs = solving.our_ppo(task)(1, 0), solving.their_ppo(task)(1, 0)
        agent, algorithm = theirs.agent, solving.ours(task)
        assert ours.steps.tolist() == theirs.steps.tolist()
        assert sum(weights.numel() for weights in agent.policy.parameters()) == ours.agent.weights.numel()
        assert (agent.gamma, agent.batch_size) == (algorithm.discount, ours.steps[-1] / algorithm.minibatches)
