"""Runs on a cluster: the same results as in threads, also when a worker dies."""

import importlib
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import joblib
import pandas as pd
import pytest

from edugym import QLearning, profile
from tests.experiments.experiments import small

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]  # those of Dask and Ray are not ours
BACKENDS = pytest.mark.parametrize("backend", ["dask", "ray"])


@contextmanager
def cluster(backend: str) -> Iterator[None]:
    """Two workers on this machine, which joblib uses."""
    if backend == "dask":
        distributed = pytest.importorskip("distributed", reason="`pip install distributed` brings Dask")
        with (
            distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as workers,
            distributed.Client(workers),
            joblib.parallel_config(backend="dask"),
        ):
            yield
    else:
        ray = pytest.importorskip("ray", reason="`pip install ray` brings it")
        ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
        try:
            importlib.import_module("ray.util.joblib").register_ray()
            with joblib.parallel_config(backend="ray", n_jobs=-1):
                yield
        finally:
            ray.shutdown()


@BACKENDS
def test_a_cluster_gives_what_threads_give(backend: str, tmp_path: Path) -> None:
    """Bit for bit; where a worker is lost in the middle of a run, others do its work again."""
    here, killed = os.getpid(), tmp_path / "killed"

    def deadly(wall: Any) -> QLearning:
        if os.getpid() != here and not killed.exists():
            killed.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return QLearning.create(wall)

    with cluster(backend):
        elsewhere = [small(20_000, jobs=None).table, small(20_000, jobs=None, agents={"Q": deadly}).table]
    assert killed.exists()
    for table, expected in zip(elsewhere, (small(20_000), small(20_000, agents={"Q": deadly})), strict=True):
        pd.testing.assert_frame_equal(table, expected.table, check_exact=True)


@BACKENDS
def test_a_profile_is_the_same_too(backend: str) -> None:
    """On a cluster as in threads."""
    with cluster(backend):
        elsewhere = profile({"Q": QLearning.create}, challenges=["Boulder", "Golf"], repetitions=3, jobs=None).runs
    here = profile({"Q": QLearning.create}, challenges=["Boulder", "Golf"], repetitions=3).runs
    pd.testing.assert_frame_equal(elsewhere, here, check_exact=True)
