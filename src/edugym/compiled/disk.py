"""Machine code on the disk: folders that are whole or not there, found by name and checked before use.

A folder is filled under another name, sealed with a checksum of every file, and renamed. So a process that is killed, a
full disk and flipped bits cost one more compilation. What has not been used for longest goes when there is too much.
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
"""How many bytes are kept in all."""
ABANDONED = 3600
"""After how many seconds a folder that was never finished is one that was left behind."""


def cache_directory() -> Path:
    """Where machine code is kept between runs: $EDUGYM_CACHE_DIR, or `edugym` in the user's cache directory."""
    chosen = os.environ.get("EDUGYM_CACHE_DIR")
    return Path(chosen) if chosen else Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "edugym"


def is_whole(folder: Path) -> bool:
    """Whether a folder is there with all that it was sealed with; what is left of another one is removed."""
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
    """A folder to be filled and then put in the place of `folder`; None where nothing can be written."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        return Path(tempfile.mkdtemp(prefix="unfinished-", dir=folder.parent))
    except OSError:
        return None


def publish(unfinished: Path, folder: Path) -> None:
    """Put a filled folder in its place, unless the disk is full or another process was faster."""
    try:
        seal(unfinished)
        unfinished.rename(folder)
    except OSError:
        remove(unfinished)
    else:
        _prune(folder.parent, keep=folder)


def seal(folder: Path) -> None:
    """Note the checksum of every file."""
    text = json.dumps(_checksums(folder))
    handle, name = tempfile.mkstemp(dir=folder)
    with os.fdopen(handle, "w") as file:
        file.write(text)
    os.replace(name, folder / SEAL)


def remove(folder: Path) -> None:
    """Remove it, as far as that is possible."""
    shutil.rmtree(folder, ignore_errors=True)


def _checksums(folder: Path) -> dict[str, str]:
    files = (path for path in folder.rglob("*") if path.is_file() and path.name != SEAL)
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def _prune(directory: Path, keep: Path) -> None:
    """Remove what was left behind, and the folders that were not used for longest until the rest is small enough."""
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
