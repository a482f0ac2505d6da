"""The benchmark runs, and writes down what it measured (how fast anything is, depends on the machine)."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[1]


def benchmark(*options: str) -> str:
    """What the benchmark prints."""
    command = [sys.executable, "-m", "benchmarks", "--quick", *options]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
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
    names = [comparison["name"] for comparison in results["comparisons"]]
    assert len(set(names)) == len(names) >= 12
    for comparison in results["comparisons"]:
        ours, *others = comparison["per_second"]
        assert ours.startswith("EduGym")
        assert others == list(comparison["edugym_is_times_as_fast_as"])
        for name in others:
            fast, slow = comparison["per_second"][ours], comparison["per_second"][name]
            ratio = comparison["edugym_is_times_as_fast_as"][name]
            assert ratio["median"] == pytest.approx(fast["median"] / slow["median"])  # there was one round only
            assert spread(fast)
            assert spread(slow)
            assert spread(ratio)
        assert f"{comparison['name']} ({comparison['unit']} a second)" in printed
    aims = [aim for comparison in results["comparisons"] for aim in comparison["targets"]]
    others = [">= 100 x", ">= 50 x", ">= 50 x"]  # of some agents
    assert sorted(aims) == sorted(
        [">= 1 M/s", ">= 50 M/s", *[">= 100 M/s"] * 2, *[">= 300 x"] * 3, *[">= 5 x"] * 3, *others]
    )
    assert all(spread(taken) for taken in results["import_seconds"].values())
    assert list(results["import_seconds"]) == ["edugym", "gymnasium", "numpy"]


def test_a_part_can_be_measured() -> None:
    """By a piece of its name."""
    printed = benchmark("--only", "one step of Golf")
    assert [line for line in printed.splitlines() if line.endswith("a second)")] == [
        "one step of Golf, env.unwrapped (steps a second)"
    ]
