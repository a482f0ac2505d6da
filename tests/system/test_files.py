"""Files are written whole or not at all; links and modes stay what they are."""

import os
import resource
import stat
import tempfile
from pathlib import Path

import pytest

from edugym.system.files import check_writable, write_whole


def test_a_new_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It has the mode of any new file, in a folder that is made if need be; a check makes the folder only."""
    path = tmp_path / "a" / "b" / "new"
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "not there"))  # it is this folder that counts
    assert check_writable(path) == path
    assert os.listdir(path.parent) == []
    assert write_whole(path, b"contents") == path
    assert path.read_bytes() == b"contents"
    (tmp_path / "plain").touch()
    before = path.stat()
    assert before.st_mode == (tmp_path / "plain").stat().st_mode
    check_writable(path)
    assert path.stat() == before
    assert os.listdir(path.parent) == ["new"]


def test_a_replaced_file_keeps_its_mode(tmp_path: Path) -> None:
    """And is a new file: whoever has the old one open goes on to read it."""
    path, mode = tmp_path / "file", 0o646  # a usual umask would take the last 6 from a new file
    path.write_bytes(b"old")
    path.chmod(mode)
    with path.open("rb") as reader:
        write_whole(path, b"new")
        assert reader.read() == b"old"
    assert path.read_bytes() == b"new"
    assert stat.S_IMODE(path.stat().st_mode) == mode


def test_symbolic_links_are_followed(tmp_path: Path) -> None:
    """To a file, to another link, and to a file that is not there yet."""
    (tmp_path / "folder").mkdir()
    (tmp_path / "second").symlink_to("folder/file")
    (tmp_path / "first").symlink_to(tmp_path / "second")
    for contents in (b"1", b"2"):
        check_writable(tmp_path / "first")
        write_whole(tmp_path / "first", contents)
        assert (tmp_path / "folder" / "file").read_bytes() == contents
        assert (tmp_path / "first").is_symlink()
        assert (tmp_path / "second").is_symlink()
    assert os.listdir(tmp_path / "folder") == ["file"]


@pytest.mark.parametrize("exists", [False, True])
def test_a_failure_leaves_the_old_file(tmp_path: Path, exists: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """When a file may not be as large, or Ctrl-C comes, the old file is there as before, and nothing else."""
    path = tmp_path / "results.csv"
    if exists:
        path.touch(0o600)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        with pytest.raises(OSError, match=r"results\.csv: File too large") as caught:
            write_whole(path, b"new" * 10_000)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert caught.value.errno is not None
    found: list[tuple[int, int]] = []

    def interrupted(file: int) -> None:
        found.append((stat.S_IMODE(os.fstat(file).st_mode), os.fstat(file).st_size))
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_whole(path, b"new")
    assert found[0][1] == 3
    assert found[0][0] == 0o600 or not exists  # only its owner may open a private file that is written anew
    assert os.listdir(tmp_path) == ["results.csv"] * exists
    assert not exists or path.read_bytes() == b""


def test_what_cannot_be_written_is_explained(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Before the work and after it, in the same words."""
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    for name, reason in {
        "folder": "it is a folder",
        "file/new": "file is not a folder",
        "file/new/file": "file is not a folder",
        "pipe": "it is no ordinary file",
    }.items():
        path = tmp_path / name
        for write in (check_writable, lambda path: write_whole(path, b"")):
            with pytest.raises(OSError, match=f"^cannot write to {path}: .*{reason}"):
                write(path)
    monkeypatch.setattr(os, "access", lambda path, mode: mode != os.W_OK)  # a protected file, also where root may
    for write in (check_writable, lambda path: write_whole(path, b"new")):
        with pytest.raises(PermissionError, match="file: permission denied"):
            write(tmp_path / "file")
    assert sorted(os.listdir(tmp_path)) == ["file", "folder", "pipe"]
