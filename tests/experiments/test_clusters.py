"""Runs on a cluster: the same results as in threads, also when a worker dies."""

import os
import signal
import threading

import joblib
import pandas as pd
import pytest

from edugym import QLearning, profile
from tests.experiments.experiments import small

distributed = pytest.importorskip("distributed", reason="`pip install distributed` brings Dask")

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]  # Dask's own warnings are not ours


def test_dask_gives_what_threads_give() -> None:
    """Bit for bit; where a worker is lost, others do its work again."""
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
        joblib.parallel_config(backend="dask"),
    ):
        elsewhere = [small(20_000, jobs=None).table]
        victim = next(iter(client.run(os.getpid).values()))
        threading.Timer(0.5, os.kill, (victim, signal.SIGKILL)).start()
        elsewhere.append(small(20_000, jobs=None).table)
    for table in elsewhere:
        pd.testing.assert_frame_equal(table, small(20_000).table)


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
