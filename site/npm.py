"""Packages of npm, which are fetched once, and kept."""

import json
import subprocess
import tarfile
from pathlib import Path

PACKAGES = Path(__file__).parent / "build" / "npm"


def fetched(package: str) -> Path:
    """The archive of a package, by its name and version.

    Raises:
        OSError, subprocess.SubprocessError: npm does not answer.
    """
    PACKAGES.mkdir(parents=True, exist_ok=True)
    wanted = PACKAGES / f"{package.strip('@').replace('/', '-').replace('@', '-')}.tgz"
    if not wanted.exists():
        npm = ["npm", "pack", "--json", "--pack-destination", str(PACKAGES), package]
        told = subprocess.run(npm, capture_output=True, check=True, timeout=300, text=True).stdout
        made = PACKAGES / json.loads(told)[0]["filename"].replace("@", "").replace("/", "-")
        made.replace(wanted)
    return wanted


def content(archive: tarfile.TarFile, name: str) -> bytes:
    """What a file of an archive holds.

    Raises:
        OSError: it is not there.
    """
    file = archive.extractfile(name)
    if file is None:
        raise OSError(f"{name} is not in the archive")
    return file.read()
