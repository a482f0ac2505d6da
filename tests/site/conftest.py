"""What several tests of the website need."""

import shutil
import subprocess

import pytest


@pytest.fixture(scope="session")
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The accessibility checker of Deque, from npm."""
    folder = tmp_path_factory.mktemp("axe")
    try:
        fetched = subprocess.run(
            ["npm", "pack", "--silent", "axe-core@4"], cwd=folder, capture_output=True, text=True, timeout=120
        )
    except (FileNotFoundError, subprocess.TimeoutExpired):
        pytest.skip("npm is not there")
    if fetched.returncode != 0:
        pytest.skip("axe-core cannot be reached")
    shutil.unpack_archive(folder / fetched.stdout.strip(), folder, "gztar")
    return (folder / "package" / "axe.min.js").read_text(encoding="utf-8")
