"""What the page needs to run a reader's own agent: Python itself, and the package, as files beside the page.

Python is Pyodide, and NumPy is emscripten-forge's, both from npm; the rest is what is installed here. Where npm does
not answer, the page is built without its editor. Nothing of this is loaded before a reader edits.
"""

import json
import re
import shutil
import subprocess
import tarfile
import zipfile
from collections.abc import Iterator
from importlib.metadata import distribution
from pathlib import Path

import codemirror
import draws
import npm

HERE = Path(__file__).parent
PYODIDE, NUMPY = "pyodide@0.27.7", "@emscripten-forge/numpy@2.0.1-py312h4e66579-0"
"""This Pyodide is the last one whose Python has a NumPy on npm."""
FILES = ("pyodide.mjs", "pyodide.asm.js", "pyodide.asm.wasm", "pyodide-lock.json", "python_stdlib.zip")
SITE = "lib/python3.12/site-packages/"
UNUSED = re.compile(
    r"/(tests|f2py|distutils|include|doc|__pycache__|testing/_private)/|/_(rational|operand_flag|struct_ufunc|umath)_tests"
    r"|/_simd|\.a$|numpy/.*\.pyi$|gymnasium/envs/(mujoco|box2d|phys2d|tabular|toy_text|classic_control/assets)"
)
"""What no agent needs."""
INSTALLED = ("gymnasium", "cloudpickle", "typing_extensions", "farama-notifications")
MULTIPROCESSING = (
    'import os\nos.environ["JOBLIB_MULTIPROCESSING"] = "0"  # or it warns of what follows\n'
    "class SemLock:\n    SEM_VALUE_MAX = 1\n    def __init__(self, *_, **__):\n"
    '        raise OSError("there are no processes here")\nsem_unlink = None\n'
)
"""A module that Pyodide lacks."""
DISTRIBUTOR = (
    'import ctypes, pathlib\nctypes.CDLL(str(pathlib.Path(__file__).with_name("backtrace.wasm")), ctypes.RTLD_GLOBAL)\n'
)
"""What gives NumPy the function `backtrace`, without which large arrays end it all."""
BACKTRACE = bytes.fromhex(
    "0061736d01000000000f0864796c696e6b2e3001040004000001070160027f7f017f020f0103656e"
    "76066d656d6f727902000003020100070d01096261636b747261636500000a0601040041000b"
)
"""That function, in WebAssembly: a shared library with `int backtrace(void **, int)`, which returns 0."""


def build(folder: Path) -> dict[str, int] | None:
    """Write the files into a folder, and those of the field in which a reader edits into `codemirror` beside it.

    Returns:
        The sizes of those that the browser fetches, in bytes; None if npm does not answer.
    """
    try:
        pyodide, numpy = npm.fetched(PYODIDE), npm.fetched(NUMPY)
        codemirror.build(folder.with_name("codemirror"))
    except (OSError, subprocess.SubprocessError):
        for one in (folder, folder.with_name("codemirror")):
            shutil.rmtree(one, ignore_errors=True)
        return None
    folder.mkdir(parents=True, exist_ok=True)
    with tarfile.open(pyodide) as archive:
        for name in FILES:
            (folder / name).write_bytes(npm.content(archive, f"package/{name}"))
    with zipfile.ZipFile(folder / "packages.zip", "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packages:
        for name, content in {**dict(numpy_files(numpy)), **dict(_installed()), **dict(_own())}.items():
            packages.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    (folder / "draws.wasm").write_bytes(draws.module())
    (folder / "draws.json").write_text(json.dumps(draws.tables()))
    return {file.name: file.stat().st_size for file in sorted(folder.iterdir())}


def numpy_files(package: Path) -> Iterator[tuple[str, bytes]]:
    """The files of NumPy by their paths, from the package of npm."""
    with tarfile.open(package) as outer:
        (name,) = [name for name in outer.getnames() if name.endswith(".tar.gz")]
        file = outer.extractfile(name)
        with tarfile.open(fileobj=file) as inner:
            for member in inner:
                path = member.name.removeprefix("./")
                if member.isfile() and path.startswith(SITE) and not UNUSED.search(path):
                    yield path.removeprefix(SITE), npm.content(inner, member.name)
    yield "numpy/_distributor_init_local.py", DISTRIBUTOR.encode()
    yield "numpy/backtrace.wasm", BACKTRACE


def _installed() -> Iterator[tuple[str, bytes]]:
    for name in INSTALLED:
        for path in distribution(name).files or ():
            file, text = Path(str(path.locate())), path.as_posix()
            if not text.startswith("..") and file.is_file() and not UNUSED.search(f"/{text}"):
                yield text, file.read_bytes()


def _own() -> Iterator[tuple[str, bytes]]:
    source = HERE.parent / "src"
    for file in sorted((source / "edugym").rglob("*")):
        if file.is_file() and "__pycache__" not in file.parts:
            yield file.relative_to(source).as_posix(), file.read_bytes()
    yield "edugym_page.py", (HERE / "edugym_page.py").read_bytes()
    yield "_multiprocessing.py", MULTIPROCESSING.encode()
