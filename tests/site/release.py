"""A stand-in for a release of Pyodide: what npm and PyPI have. Pandas, Matplotlib and SciPy are not among them."""

import hashlib
import json
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import editor
import lite
import npm

SQLITE = b"""
class Error(Exception): pass
class DatabaseError(Error): pass
class OperationalError(DatabaseError): pass
class IntegrityError(DatabaseError): pass
class NotSupportedError(DatabaseError): pass
class Connection: pass
PARSE_DECLTYPES, PARSE_COLNAMES = 1, 2
def register_adapter(*_): pass
def register_converter(*_): pass
def connect(*_, **__): raise OperationalError("there is no database here")
"""
"""IPython keeps its history in a database, and does without."""
STUBS = {"ssl": {}, "openssl": {}, "sqlite3": {"sqlite3.py": SQLITE}}
"""Parts of Python that are compiled for a release, and that npm does not have."""


def stand_in(folder: Path, needed: tuple[str, ...]) -> None:
    """Write what is needed of a release into a folder.

    Raises:
        OSError, subprocess.SubprocessError: npm or PyPI do not answer.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with tarfile.open(npm.fetched(editor.PYODIDE)) as archive:
        for name in (*lite.ENGINE, "pyodide-lock.json"):
            (folder / name).write_bytes(npm.content(archive, f"package/{name}"))
    lock = json.loads((folder / "pyodide-lock.json").read_text())
    names = list(lite.with_all(lock, needed))
    downloaded = [f"{name}=={lock['packages'][name]['version']}" for name in names if _is_on_pypi(lock, name)]
    options = ["--quiet", "--no-deps", "--python-version=3.12", "--only-binary=:all:", "--dest", str(folder)]
    subprocess.run([sys.executable, "-m", "pip", "download", *options, *downloaded], check=True)
    for name, file in _made(folder / "made", names):
        lock["packages"][name] |= {"file_name": file.name, "depends": []}
        shutil.move(file, folder / file.name)
    for name in names:  # the browser compares them; PyPI's wheels are not always those of the release
        file = folder / lock["packages"][name]["file_name"]
        lock["packages"][name]["sha256"] = hashlib.sha256(file.read_bytes()).hexdigest()
    (folder / "pyodide-lock.json").write_text(json.dumps(lock))


def _is_on_pypi(lock: dict[str, Any], name: str) -> bool:
    return str(lock["packages"][name]["file_name"]).endswith("-none-any.whl")


def _made(folder: Path, names: list[str]) -> Iterator[tuple[str, Path]]:
    for name in names:
        if name in STUBS:
            yield name, lite.make_wheel(folder, name, "1.0.0", STUBS[name])
        elif name == "numpy":
            files = dict(editor.numpy_files(npm.fetched(editor.NUMPY)))
            yield name, lite.make_wheel(folder, name, "2.0.1", files)
