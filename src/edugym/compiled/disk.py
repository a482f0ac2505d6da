"""The disk cache of machine code: one folder for each build, which is whole or counts as missing.

A folder is filled under a temporary name, sealed with a checksum of every file, and renamed. So a killed process, a
full disk or a flipped bit costs no more than another compilation. When there is too much, the least recently used
folders are removed.
"""

import contextlib
import hashlib
import json
import os
import shutil
import tempfile
import time
from pathlib import Path

SEAL = "checksums.json"
LIMIT = 256 * 2**20
"""The bytes that are kept in all."""
ABANDONED = 3600
"""The seconds after which an unfinished folder counts as abandoned."""


def cache_directory() -> Path:
    """Where machine code is kept between runs: $EDUGYM_CACHE_DIR, or `edugym` in the user's cache directory."""
    chosen = os.environ.get("EDUGYM_CACHE_DIR")
    return Path(chosen) if chosen else Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "edugym"


def is_whole(folder: Path) -> bool:
    """Whether a folder exists as it was sealed; a damaged one is removed."""
    if not folder.exists():
        return False
    try:
        whole = bool(json.loads((folder / SEAL).read_text()) == _checksums(folder))
        if whole:
            with contextlib.suppress(OSError):
                os.utime(folder)  # it was used now
    except (OSError, ValueError):
        whole = False
    if not whole:
        remove(folder)
    return whole


def new_folder(folder: Path) -> Path | None:
    """A temporary folder to fill and `publish` as `folder`; None where nothing can be written."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        return Path(tempfile.mkdtemp(prefix="unfinished-", dir=folder.parent))
    except OSError:
        return None


def publish(unfinished: Path, folder: Path) -> None:
    """Seals a filled folder and renames it, unless the disk is full or another process was faster."""
    try:
        seal(unfinished)
        unfinished.rename(folder)
    except OSError:
        remove(unfinished)
    else:
        _prune(folder.parent, keep=folder)


def seal(folder: Path) -> None:
    """Writes down the checksum of every file."""
    text = json.dumps(_checksums(folder))
    handle, name = tempfile.mkstemp(dir=folder)
    with os.fdopen(handle, "w") as file:
        file.write(text)
    os.replace(name, folder / SEAL)


def remove(folder: Path) -> None:
    """Removes a folder, as far as that is possible."""
    shutil.rmtree(folder, ignore_errors=True)


def _checksums(folder: Path) -> dict[str, str]:
    files = (path for path in folder.rglob("*") if path.is_file() and path.name != SEAL)
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def _prune(directory: Path, keep: Path) -> None:
    """Removes abandoned folders, and the least recently used ones until the rest is small enough."""
    try:
        folders = sorted((path.stat().st_mtime, path) for path in directory.iterdir() if path.is_dir())
        for used, path in folders:
            if path.name.startswith("unfinished-") and used < time.time() - ABANDONED:
                remove(path)
        sizes = {
            path: sum(file.stat().st_size for file in path.rglob("*") if file.is_file())
            for _, path in folders
            if (path / SEAL).exists() and path != keep
        }
        excess = sum(sizes.values()) - LIMIT
        for path, size in sizes.items():
            if excess > 0:
                remove(path)
                excess -= size
    except OSError:  # another process is doing the same
        pass
