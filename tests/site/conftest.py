"""What several tests of the website need."""

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import kernels
import playground
import pytest
from races import RACES

from tests.course.lab.browser import chromium
from tests.site.node import KERNELS
from tests.site.serving import served

WATCH = """
    window.shift = 0
    const add = entry => { if (!entry.hadRecentInput) window.shift += entry.value }
    const watch = new PerformanceObserver(list => list.getEntries().forEach(add))
    watch.observe({ type: 'layout-shift', buffered: true })
"""


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The whole playground, with kernels that stay: they take minutes, and other processes and sessions need them."""
    folder = tmp_path_factory.mktemp("playground")
    (folder / "kernels").mkdir()
    for fingerprint in kernels.build(playground.needed(RACES), KERNELS):
        shutil.copy(KERNELS / f"{fingerprint}.wasm", folder / "kernels")
    playground.build(folder)
    return folder


@pytest.fixture(scope="module")
def address(built: Path) -> Iterator[str]:
    """The whole playground, served."""
    with served(built) as address:
        yield address


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    """A browser, which finds no other host."""
    with chromium() as driver:
        driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WATCH})
        yield driver
