"""Write files whole or not at all, and respect what is there: links, modes, devices and pipes."""

import contextlib
import os
import secrets
import stat
import tempfile
from collections.abc import Iterator
from pathlib import Path


def check_writable(path: str | os.PathLike[str]) -> Path:
    """Refuse a path to which no file can be written, before long work; create its folder if it does not exist.

    A file, device or pipe that exists is neither opened nor changed.

    Raises:
        OSError: no file can be written there. The error says why.
    """
    with _explained(path):
        target, is_ordinary = _target(path)
        if is_ordinary:
            target.parent.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=target.parent):
                pass
    return Path(path)


def write_whole(path: str | os.PathLike[str], contents: bytes, *, synced: bool = True) -> Path:
    """Write a file so that nobody ever finds a part of it, and so that a failure leaves the old file as it was.

    A symbolic link stays, and the file to which it points is written. A file that is replaced keeps its mode and, where
    permitted, its owner. A device or a pipe is written to, not replaced.

    Args:
        path: of the file.
        contents: what is to be in it.
        synced: whether to wait until the disk has it, some milliseconds. If not, a power failure may damage it.

    Raises:
        OSError: the file cannot be written. The error says why.
    """
    with _explained(path):
        target, is_ordinary = _target(path)
        if is_ordinary:
            target.parent.mkdir(parents=True, exist_ok=True)
            _replace(target, contents, synced)
        else:
            with open(os.open(target, os.O_WRONLY), "wb") as device:
                device.write(contents)
    return Path(path)


def _target(path: str | os.PathLike[str]) -> tuple[Path, bool]:
    """Follow symbolic links, and refuse folders and what may not be written to.

    Returns:
        The path to write to, and whether it is an ordinary file, or a new one, that can be replaced.
    """
    path = Path(path)
    target = Path(os.path.realpath(path))
    if target.is_dir():
        raise IsADirectoryError("it is a folder")
    if target.is_symlink():
        raise OSError("its symbolic links lead in a circle")
    if path.exists():
        if not os.access(path, os.W_OK):
            raise PermissionError("permission denied")
        # /dev/stdout may be a link to a name that does not exist, such as "pipe:[123]".
        is_ordinary = target.exists() and stat.S_ISREG(target.stat().st_mode)
        return (target if is_ordinary else path), is_ordinary
    for folder in target.parents:
        if folder.exists() and not folder.is_dir():
            raise NotADirectoryError(f"{folder} is not a folder")
    return target, True


def _replace(target: Path, contents: bytes, synced: bool) -> None:
    """Write a new file beside the old one, and put it into its place when it is complete and, if asked, on the disk."""
    unfinished = target.with_name(f".unfinished-{secrets.token_hex(8)}")
    old = target.stat() if target.exists() else None
    mode = 0o666 if old is None else 0o600  # nobody else may read a private file meanwhile
    try:
        with open(unfinished, "xb", opener=lambda name, flags: os.open(name, flags, mode)) as file:
            file.write(contents)
            file.flush()
            if synced:
                os.fsync(file.fileno())
        if old is not None:
            if hasattr(os, "chown"):
                with contextlib.suppress(OSError):  # only root may give files away
                    os.chown(unfinished, old.st_uid, old.st_gid)
            unfinished.chmod(stat.S_IMODE(old.st_mode))
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
