"""Files that are written whole or not at all."""

import os
import tempfile
from pathlib import Path


def check_writable(path: str | os.PathLike[str]) -> Path:
    """Refuse, before long work, a path where no file can be written; its folder is made if need be.

    Raises:
        OSError: no file can be written there.
    """
    path = Path(path)
    if path.is_dir():
        raise IsADirectoryError(f"cannot write to {path}: it is a folder")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path.parent):
            pass
    except OSError as error:
        raise type(error)(f"cannot write to {path}: {error.strerror or error}") from error
    return path


def write_whole(path: str | os.PathLike[str], contents: bytes) -> Path:
    """Write a file so that nobody ever finds half of it.

    Raises:
        OSError: it cannot be written.
    """
    path = check_writable(path)
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        unfinished.write_bytes(contents)
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
    return path
