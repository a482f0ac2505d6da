"""Write files whole or not at all, and respect what is there: links and modes."""

import contextlib
import os
import secrets
import stat
import tempfile
from collections.abc import Iterator
from pathlib import Path


def check_writable(path: str | os.PathLike[str]) -> Path:
    """Refuse a path to which no file can be written, before long work; create its folder if it does not exist.

    A file that exists is neither opened nor changed.

    Raises:
        OSError: no file can be written there. The error says why.
    """
    with _explained(path):
        target = _target(path)
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=target.parent):
            pass
    return Path(path)


def write_whole(path: str | os.PathLike[str], contents: bytes, *, synced: bool = True) -> Path:
    """Write a file so that nobody ever finds a part of it, and so that a failure leaves the old file as it was.

    A symbolic link stays, and the file to which it points is written. A file that is replaced keeps its mode.

    Args:
        path: of the file.
        contents: what is to be in it.
        synced: whether to wait until the disk has it, some milliseconds. If not, a power failure may damage it.

    Raises:
        OSError: the file cannot be written. The error says why.
    """
    with _explained(path):
        target = _target(path)
        target.parent.mkdir(parents=True, exist_ok=True)
        _replace(target, contents, synced)
    return Path(path)


def _target(path: str | os.PathLike[str]) -> Path:
    """The file that a path names, through symbolic links; refuse folders, devices, and what may not be written to."""
    target = Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        raise OSError("it is a folder" if target.is_dir() else "it is no ordinary file")
    if target.exists() and not os.access(target, os.W_OK):
        raise PermissionError("permission denied")
    for folder in target.parents:
        if folder.exists() and not folder.is_dir():
            raise NotADirectoryError(f"{folder} is not a folder")
    return target


def _replace(target: Path, contents: bytes, synced: bool) -> None:
    """Write a new file beside the old one, and put it into its place when it is complete and, if asked, on the disk."""
    unfinished = target.with_name(f".unfinished-{secrets.token_hex(8)}")
    mode = stat.S_IMODE(target.stat().st_mode) if target.exists() else None
    try:
        with open(
            unfinished, "xb", opener=lambda name, flags: os.open(name, flags, 0o666 if mode is None else mode)
        ) as file:
            file.write(contents)
            file.flush()
            if synced:
                os.fsync(file.fileno())
        if mode is not None:
            unfinished.chmod(mode)  # `open` has left out what the umask forbids
        unfinished.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            unfinished.unlink()
        raise


@contextlib.contextmanager
def _explained(path: str | os.PathLike[str]) -> Iterator[None]:
    """Name the path in the message of an OSError."""
    try:
        yield
    except OSError as error:
        explained = type(error)(f"cannot write to {path}: {error.strerror or error}")
        explained.errno = error.errno
        raise explained from None
