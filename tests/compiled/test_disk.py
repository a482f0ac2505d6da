"""The disk cache: whatever becomes of its files, the next process gets its results, quickly again after one build."""

import os
import signal
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from edugym.compiled import compiler, disk
from edugym.compiled.compiler import compiled
from edugym.compiled.disk import cache_directory
from tests.compiled.processes import printed, started
from tests.compiled.test_compiler import Adder, plain_loop

MAIN = """
import warnings
warnings.simplefilter("error")
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
FOUND, MADE = (1, True), (0, True)


def result(cache: Path) -> tuple[str, list[tuple[int, bool]]]:
    """What training comes to in a new process, and of each build whether it was found on the disk and is a lean one."""
    value, _, builds = printed(MAIN, EDUGYM_CACHE_DIR=str(cache)).strip().partition(" ")
    return value, eval(builds)


def change_byte(file: Path) -> None:
    """Flip one in the middle."""
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 0xFF
    file.write_bytes(data)


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the builds in it."""
    folder = tmp_path_factory.mktemp("cache")
    assert result(folder)[1] == [MADE, MADE]
    assert result(folder)[1] == [FOUND, FOUND]
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("endings", [(".nbi", ".nbc"), (".json",)], ids=lambda endings: endings[0])
def test_damage_costs_one_build(endings: tuple[str, ...], cache: Path) -> None:
    """A damaged file of any kind is noticed; the folder is made again, as fast code, and is then found."""
    for k, ending in enumerate(endings):  # in one folder the index, in the other the machine code
        files = [file for file in sorted(cache.rglob("*")) if file.suffix == ending]
        assert len(files) == 2
        change_byte(files[k])
    value, builds = result(cache)
    assert sorted(builds) == [MADE] * len(endings) + [FOUND] * (2 - len(endings))
    assert result(cache) == (value, [FOUND, FOUND])


@pytest.mark.slow
def test_killed_while_it_writes(tmp_path: Path) -> None:
    """Processes that are killed at any moment leave nothing that is worse than nothing."""
    for delay in (0.9, 1.3, 1.7):
        process = started(MAIN, EDUGYM_CACHE_DIR=str(tmp_path))
        time.sleep(delay)
        process.send_signal(signal.SIGKILL)
        process.communicate()
    value, builds = result(tmp_path)
    assert all(lean for _, lean in builds)
    assert result(tmp_path) == (value, [FOUND, FOUND])


@pytest.mark.slow
def test_full_disk(tmp_path: Path) -> None:
    """Where nothing more can be written machine code is made and used all the same, and kept once there is room."""
    limits = (
        "import resource, signal, edugym\nresource.setrlimit(resource.RLIMIT_FSIZE, (20_000, -1))\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
    )
    value = printed(MAIN.replace("import edugym\n", limits), EDUGYM_CACHE_DIR=str(tmp_path)).split()[0]
    assert not any(tmp_path.iterdir())
    assert result(tmp_path) == (value, [MADE, MADE])
    assert result(tmp_path) == (value, [FOUND, FOUND])


STUDENT = """
from typing import NamedTuple
from student_constants import SPEED

def helper(s): return s + SPEED

class Task(NamedTuple):
    k: int
    def f(self, s, rng): return helper(s) + 1.0 * self.k
"""
USE = """
import numpy as np
from student_loop import loop
from student import Task
from edugym.compiled.compiler import compiled

arguments = 10, Task(1), np.random.default_rng(0)
assert compiled(loop, *arguments)(*arguments) == loop(*arguments)
print(loop(*arguments))
"""
LOOP = "def loop(n, task, rng):\n    s = 0.0\n    for _ in range(n):\n        s = task.f(s, rng)\n    return s\n"


@pytest.mark.slow
def test_students_modules(tmp_path: Path) -> None:
    """Another process finds machine code on the disk, and does not use it once what it was made of has changed."""
    code, cache = tmp_path / "code", tmp_path / "cache"
    code.mkdir()

    def run(**modules: str) -> tuple[float, dict[Path, int]]:
        for name, source in modules.items():
            (code / f"{name}.py").write_text(source)
        value = float(printed(USE, path=str(code), EDUGYM_CACHE_DIR=str(cache)))
        return value, {path: path.stat().st_mtime_ns for path in cache.rglob("*") if path.is_file()}

    first = run(student=STUDENT, student_constants="SPEED = 2", student_loop=LOOP)
    value, files = first
    assert value == 30
    assert len(files) >= 2
    assert run() == first
    for modules, result in (
        ({"student_constants": "SPEED = 3"}, 40),
        ({"student": STUDENT.replace("+ 1.0 *", "+ 2.0 *")}, 50),
        ({"student_loop": LOOP.replace("s = task", "s = 1 + task")}, 60),
    ):
        before = files
        value, files = run(**modules)
        assert value == result
        assert files.keys() > before.keys()


def test_where_the_cache_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """$EDUGYM_CACHE_DIR, or `edugym` in the user's cache directory."""
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("EDUGYM_CACHE_DIR", str(tmp_path / "mine"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache_directory() == tmp_path / "mine"
    monkeypatch.delenv("EDUGYM_CACHE_DIR")
    assert cache_directory() == tmp_path / "edugym"
    monkeypatch.delenv("XDG_CACHE_HOME")
    assert cache_directory() == tmp_path / ".cache" / "edugym"


def test_a_cache_that_cannot_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a folder to keep machine code in, it is made anew and works."""
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("EDUGYM_CACHE_DIR", str(tmp_path / "file" / "cache"))
    monkeypatch.setattr(compiler, "_built", {})  # as in a new process
    fast = compiled(plain_loop, 10, Adder(0.5), np.random.default_rng(0))
    results = [run(10, Adder(0.5), np.random.default_rng(5)) for run in (plain_loop, fast)]
    assert results[0] == results[1]


def folder(parent: Path, name: str, size: int) -> Path:
    """A folder as they are kept."""
    unfinished = disk.new_folder(parent / name)
    assert unfinished is not None
    (unfinished / "data").write_bytes(b"x" * size)
    disk.publish(unfinished, parent / name)
    return parent / name


@pytest.mark.parametrize(
    ("limit", "used", "left"),
    [
        (10_000, "abc", "abcd"),
        (2_500, "abc", "bcd"),  # the oldest goes, whatever it is called
        (2_500, "cab", "abd"),
        (1, "abc", "d"),  # the latest stays in any case
    ],
)
def test_the_least_recently_used_go(
    limit: int, used: str, left: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Above the limit; a look at a folder is a use."""
    for name in "abc":
        os.utime(folder(tmp_path, name, 1000), (10 + used.index(name),) * 2)
    if limit == 10_000:
        assert disk.is_whole(tmp_path / "a")
        assert (tmp_path / "a").stat().st_mtime > time.time() - 100
    monkeypatch.setattr(disk, "LIMIT", limit)
    folder(tmp_path, "d", 10)
    assert {path.name for path in tmp_path.iterdir()} == set(left)


def test_every_file_counts_up_to_the_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As many bytes may be kept as the limit says, and not one more; the latest folder does not count."""
    kept = folder(tmp_path, "a", 1000)
    size = sum(file.stat().st_size for file in kept.iterdir())
    for limit, stays in ((size, True), (size - 1, False)):
        monkeypatch.setattr(disk, "LIMIT", limit)
        disk.remove(folder(tmp_path, "b", 10))
        assert kept.exists() == stays


def test_unfinished_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another process may go on with its own for an hour; then it was abandoned, and goes."""
    for name, seconds in (("unfinished-new", 3_000), ("unfinished-old", 4_000)):
        (tmp_path / name).mkdir()
        os.utime(tmp_path / name, (time.time() - seconds,) * 2)
    monkeypatch.setattr(disk, "LIMIT", 1)
    folder(tmp_path, "a", 10)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "unfinished-new"]


DAMAGE: dict[str, Callable[[Path], object]] = {
    "a flipped byte": lambda kept: change_byte(kept / "data"),
    "a truncated file": lambda kept: (kept / "data").write_bytes(b"x"),
    "a missing file": lambda kept: (kept / "data").unlink(),
    "another file": lambda kept: (kept / "more").write_bytes(b"x"),
    "a damaged seal": lambda kept: (kept / disk.SEAL).write_bytes(b"y"),
    "a missing seal": lambda kept: (kept / disk.SEAL).unlink(),
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_a_damaged_folder_is_removed(damage: str, tmp_path: Path) -> None:
    """So that another one can take its name. An empty folder inside, as a file manager makes it, does no harm."""
    kept = folder(tmp_path, "a", 10)
    (kept / "previews").mkdir()
    assert disk.is_whole(kept)
    DAMAGE[damage](kept)
    assert not disk.is_whole(kept)
    assert not kept.exists()


def test_folders_of_two_processes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the same folder the first stays; parents are made; to remove what is gone, or write where one cannot, is fine.

    The seal is written in the folder itself: the disk for temporary files may be another one.
    """
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "another disk"))
    kept = folder(tmp_path / "of the user" / "of the program", "a", 10)
    folder(kept.parent, "a", 20)
    assert (kept / "data").stat().st_size == 10
    assert disk.is_whole(kept)
    assert list(kept.parent.iterdir()) == [kept]
    assert disk.new_folder(kept / "data" / "b") is None
    disk.remove(kept)
    disk.remove(kept)
    assert not disk.is_whole(kept)
