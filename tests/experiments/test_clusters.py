"""Runs on a cluster: the same results as in threads, also when a worker dies."""

import os
import signal
import threading
from typing import Any

import joblib
import pandas as pd
import pytest

from edugym import CountBased, QLearning, repeat

distributed = pytest.importorskip("distributed", reason="`pip install distributed` brings Dask")

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]  # Dask's own warnings are not ours


def trained(**how: Any) -> pd.DataFrame:
    """Two methods, six times each."""
    agents = {"Q": QLearning.create, "novelty": CountBased.create}
    return repeat("Boulder", agents, 20_000, repetitions=6, **how).table


def test_dask_gives_what_threads_give() -> None:
    """Bit for bit; where a worker is lost, others do its work again."""
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
        joblib.parallel_config(backend="dask"),
    ):
        elsewhere = [trained(jobs=None)]
        victim = next(iter(client.run(os.getpid).values()))
        threading.Timer(0.5, os.kill, (victim, signal.SIGKILL)).start()
        elsewhere.append(trained(jobs=None))
    for table in elsewhere:
        pd.testing.assert_frame_equal(table, trained())
