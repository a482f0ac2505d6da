"""The disk cache: whatever becomes of its files, the next process gets its results, quickly again after one build."""

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from edugym.compiled import disk

MAIN = """
import warnings
warnings.simplefilter("error")
import numba.core.dispatcher as dispatcher
from edugym.compiled import compiler
builds = []
original = compiler._compile
def counted(*arguments):
    made = original(*arguments)
    builds.append((sum(made.stats.cache_hits.values()), "_nrt" in arguments[-1]))
    return made
compiler._compile = counted
import edugym
task = edugym.make_mdp("Boulder", height=4)
run = edugym.train(task, edugym.QLearning.create(task), 6000, evaluate_every=6000)
print(run.agent.Q.sum().hex(), builds)
"""


def started(cache: Path) -> "subprocess.Popen[str]":
    """A process that trains."""
    environment = os.environ | {"EDUGYM_CACHE_DIR": str(cache), "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    command = [sys.executable, "-c", MAIN]
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def result(cache: Path) -> tuple[str, list[tuple[int, bool]]]:
    """What training comes to in a new process, and of each build whether it was found on the disk and is a lean one."""
    process = started(cache)
    out, err = process.communicate(timeout=120)
    assert process.returncode == 0, err
    value, _, builds = out.strip().partition(" ")
    return value, eval(builds)


FOUND, MADE = (1, True), (0, True)


def change_byte(file: Path) -> None:
    """Flip one in the middle."""
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 0xFF
    file.write_bytes(data)


FAULTS: dict[str, Callable[[Path], object]] = {
    "flipped": change_byte,
    "truncated": lambda file: file.write_bytes(file.read_bytes()[: file.stat().st_size // 2]),
    "emptied": lambda file: file.write_bytes(b""),
    "removed": lambda file: file.unlink(),
}


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the builds in it."""
    folder = tmp_path_factory.mktemp("cache")
    assert result(folder)[1] == [MADE, MADE]
    assert result(folder)[1] == [FOUND, FOUND]
    return folder


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fault", "endings"), [*((fault, (".nbi", ".nbc")) for fault in FAULTS), ("flipped", (".json",))]
)
def test_damage_costs_one_build(fault: str, endings: tuple[str, ...], cache: Path) -> None:
    """A damaged file of any kind is noticed; the folder is made again, as fast code, and is then found."""
    for k, ending in enumerate(endings):  # in one folder the index, in the other the machine code
        files = [file for file in sorted(cache.rglob("*")) if file.suffix == ending]
        assert len(files) == 2
        FAULTS[fault](files[k])
    value, builds = result(cache)
    assert sorted(builds) == [MADE] * len(endings) + [FOUND] * (2 - len(endings))
    assert result(cache) == (value, [FOUND, FOUND])


@pytest.mark.slow
def test_killed_while_it_writes(tmp_path: Path) -> None:
    """Processes that are killed at any moment leave nothing that is worse than nothing."""
    for delay in (0.9, 1.3, 1.7):
        process = started(tmp_path)
        time.sleep(delay)
        process.send_signal(signal.SIGKILL)
        process.communicate()
    value, builds = result(tmp_path)
    assert all(lean for _, lean in builds)
    assert result(tmp_path) == (value, [FOUND, FOUND])


@pytest.mark.slow
def test_full_disk(tmp_path: Path) -> None:
    """Where nothing more can be written machine code is made and used all the same, and kept once there is room."""
    program = MAIN.replace(
        "import edugym\n",
        "import resource, edugym\nresource.setrlimit(resource.RLIMIT_FSIZE, (20_000, -1))\n"
        "import signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n",
    )
    environment = os.environ | {
        "EDUGYM_CACHE_DIR": str(tmp_path),
        "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
    }
    done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    value = done.stdout.split()[0]
    assert not any(tmp_path.iterdir())
    assert result(tmp_path) == (value, [MADE, MADE])
    assert result(tmp_path) == (value, [FOUND, FOUND])


def folder(parent: Path, name: str, size: int) -> Path:
    """A folder as they are kept."""
    unfinished = disk.new_folder(parent / name)
    assert unfinished is not None
    (unfinished / "data").write_bytes(b"x" * size)
    disk.publish(unfinished, parent / name)
    return parent / name


def test_the_latest_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Above the limit, what was not used for longest goes; a look uses it; what was left behind goes as well."""
    monkeypatch.setattr(disk, "LIMIT", 2500)
    left = tmp_path / "unfinished-old"
    left.mkdir()
    fresh = tmp_path / "unfinished-new"
    fresh.mkdir()
    for path, hours in ((left, 2.0), (fresh, 0.5)):
        os.utime(path, (time.time() - 3600 * hours,) * 2)
    first, second = folder(tmp_path, "a", 1000), folder(tmp_path, "b", 1000)
    os.utime(first, (10, 10))
    os.utime(second, (20, 20))
    assert disk.is_whole(first)
    folder(tmp_path, "c", 1000)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b", "c", "unfinished-new"]
    os.utime(tmp_path / "c", (30, 30))
    folder(tmp_path, "d", 1000)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "c", "d", "unfinished-new"]


def test_a_process_that_ended_too_soon(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What it has begun stays for an hour, in which it may go on, whatever else has to go; then it goes first."""
    kept = folder(tmp_path, "a", 1000)
    begun = disk.new_folder(tmp_path / "b")
    assert begun is not None
    (begun / "data").write_bytes(b"x" * 1000)
    now = time.time()
    os.utime(begun, (now - 3000,) * 2)
    os.utime(kept, (now - 2000,) * 2)
    monkeypatch.setattr(disk, "LIMIT", 1)
    last = folder(tmp_path, "c", 10)
    assert sorted(tmp_path.iterdir()) == sorted([begun, last])
    os.utime(begun, (now - 4000,) * 2)
    monkeypatch.setattr(disk, "LIMIT", 10_000)
    assert sorted([folder(tmp_path, "d", 10), last]) == sorted(tmp_path.iterdir())


def test_every_file_counts_up_to_the_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As many bytes may be kept as the limit says, and not one more."""
    kept = folder(tmp_path, "a", 1000)
    size = sum(file.stat().st_size for file in kept.iterdir())
    monkeypatch.setattr(disk, "LIMIT", size)
    other = folder(tmp_path, "b", 10)  # the latest stays in any case, and does not count
    assert sorted(tmp_path.iterdir()) == [kept, other]
    disk.remove(other)
    monkeypatch.setattr(disk, "LIMIT", size - 1)
    last = folder(tmp_path, "c", 10)
    assert list(tmp_path.iterdir()) == [last]


@pytest.mark.parametrize("oldest", ["a", "b", "c"])
def test_the_oldest_goes_first(oldest: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever it is called, and however the disk lists it."""
    for name in "abc":
        os.utime(folder(tmp_path, name, 1000), (10 if name == oldest else 20,) * 2)
    monkeypatch.setattr(disk, "LIMIT", 2500)
    folder(tmp_path, "d", 10)
    assert {path.name for path in tmp_path.iterdir()} == set("abcd") - {oldest}


@pytest.mark.parametrize("damaged", ["data", disk.SEAL])
def test_a_damaged_folder_is_removed(damaged: str, tmp_path: Path) -> None:
    """So that another one can take its name."""
    kept = folder(tmp_path, "a", 10)
    (kept / damaged).write_bytes(b"y")
    assert not disk.is_whole(kept)
    assert not kept.exists()


def test_in_folders_that_are_not_there_yet(tmp_path: Path) -> None:
    """A first run makes them all; to remove what another process has removed already is no error."""
    kept = folder(tmp_path / "of the user" / "of the program", "a", 10)
    assert disk.is_whole(kept)
    disk.remove(kept)
    disk.remove(kept)
    assert not disk.is_whole(kept)


def test_the_faster_of_two_wins(tmp_path: Path) -> None:
    """Two processes make the same folder: the first stays, the other's is removed."""
    kept = folder(tmp_path, "a", 10)
    folder(tmp_path, "a", 20)
    assert (kept / "data").stat().st_size == 10
    assert disk.is_whole(kept)
    assert list(tmp_path.iterdir()) == [kept]


def test_a_folder_is_sealed_from_within(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file takes its name at once only on the disk where it is, and that for temporary files may be another one."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "another disk"))
    assert disk.is_whole(folder(tmp_path, "a", 10))


def test_a_folder_of_another_program_does_no_harm(tmp_path: Path) -> None:
    """As a file manager makes one for its previews."""
    kept = folder(tmp_path, "a", 10)
    (kept / "previews").mkdir()
    assert disk.is_whole(kept)


def test_folders_that_cannot_be_made(tmp_path: Path) -> None:
    """Nothing is written then."""
    (tmp_path / "file").write_text("")
    assert disk.new_folder(tmp_path / "file" / "a") is None
    assert not disk.is_whole(tmp_path / "a")
