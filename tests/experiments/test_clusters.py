"""Runs on a cluster: the same results as in threads, also when a worker dies."""

import os
import signal
from pathlib import Path
from typing import Any

import joblib
import pandas as pd
import pytest

from edugym import QLearning, profile
from tests.experiments.experiments import small

distributed = pytest.importorskip("distributed", reason="`pip install distributed` brings Dask")

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]  # Dask's own warnings are not ours


def test_dask_gives_what_threads_give(tmp_path: Path) -> None:
    """Bit for bit; where a worker is lost in the middle of a run, others do its work again."""
    here, killed = os.getpid(), tmp_path / "killed"

    def deadly(wall: Any) -> QLearning:
        if os.getpid() != here and not killed.exists():
            killed.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return QLearning.create(wall)

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster),
        joblib.parallel_config(backend="dask"),
    ):
        elsewhere = [small(20_000, jobs=None).table, small(20_000, jobs=None, agents={"Q": deadly}).table]
    assert killed.exists()
    for table, expected in zip(elsewhere, (small(20_000), small(20_000, agents={"Q": deadly})), strict=True):
        pd.testing.assert_frame_equal(table, expected.table, check_exact=True)


def test_a_profile_is_the_same_too() -> None:
    """On Dask as in threads."""
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster),
        joblib.parallel_config(backend="dask"),
    ):
        elsewhere = profile({"Q": QLearning.create}, challenges=["Boulder", "Golf"], repetitions=3, jobs=None).runs
    here = profile({"Q": QLearning.create}, challenges=["Boulder", "Golf"], repetitions=3).runs
    pd.testing.assert_frame_equal(elsewhere, here, check_exact=True)
