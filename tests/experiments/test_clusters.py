"""Runs on a cluster: the same results as in threads, also when a worker dies."""

import os
import signal
import threading
from collections.abc import Iterator
from typing import Any

import joblib
import pandas as pd
import pytest

from edugym import CountBased, QLearning, Results, repeat

distributed = pytest.importorskip("distributed", reason="`pip install distributed` brings Dask")

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]  # Dask's own warnings are not ours


@pytest.fixture
def client() -> Iterator[Any]:
    """A cluster of two processes on this machine."""
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def trained(**how: Any) -> Results:
    """Two methods, six times each."""
    agents = {"Q": QLearning.create, "novelty": CountBased.create}
    return repeat("Boulder", agents, 20_000, repetitions=6, **how)


def test_dask_gives_what_threads_give(client: Any) -> None:
    """Bit for bit."""
    with joblib.parallel_config(backend="dask"):
        elsewhere = trained(jobs=None)
    pd.testing.assert_frame_equal(elsewhere.table, trained().table)


def test_a_lost_worker_loses_no_run(client: Any) -> None:
    """Others do its work again."""
    victim = next(iter(client.run(os.getpid).values()))
    threading.Timer(0.5, os.kill, (victim, signal.SIGKILL)).start()
    with joblib.parallel_config(backend="dask"):
        elsewhere = trained(jobs=None)
    pd.testing.assert_frame_equal(elsewhere.table, trained().table)
