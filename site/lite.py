"""The lessons in JupyterLite: JupyterLab in the browser, with its Python, so that nothing is installed.

    make site PYODIDE=folder

The folder is an unpacked release of Pyodide, with the wheels of pandas, Matplotlib and SciPy, which no package registry
has. All that the browser asks for then lies beside the page: one lock file of Pyodide names every wheel, those of the
release and ours, and what it does not have is not looked for elsewhere.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any

import editor

RELEASE = "0.27"
"""The Pyodide that this JupyterLite runs."""
TOOLS = (
    "jupyterlite-core==0.6.4",
    "jupyterlite-pyodide-kernel==0.6.1",
    "jupyterlab_widgets==3.0.15",
    "jupyter-server==2.21.1",
)
"""They are not installed beside JupyterLab, which needs newer widgets."""
ENGINE = ("pyodide.js", "pyodide.mjs", "pyodide.asm.js", "pyodide.asm.wasm", "python_stdlib.zip")
KERNEL = ("ssl", "sqlite3", "ipython", "jedi", "micropip", "traitlets", "packaging")
"""What the kernel itself asks a release for."""
LESSONS = ("numpy", "pandas", "matplotlib", "scipy", "joblib", "tqdm", "rich")
"""What lessons ask it for."""
FROM_PYPI = ("gymnasium", "farama-notifications", "cloudpickle", "typing-extensions", "comm", "ipywidgets", "typer")
"""What no release has, or only in versions that are too old."""
PROVIDED = ("ipykernel", "pyodide_kernel", "piplite")
"""What the kernel's own extension brings along."""


def check(release: Path, needed: Iterable[str] = (*KERNEL, *LESSONS)) -> dict[str, Any]:
    """The lock file of a release.

    Raises:
        ValueError: the folder does not hold a release that fits, with all that is needed.
    """
    file = release / "pyodide-lock.json"
    if not file.is_file():
        raise ValueError(f"PYODIDE must be an unpacked release of Pyodide {RELEASE}, but {release} has no {file.name}")
    lock: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    found = lock["info"]["version"]
    if not found.startswith(f"{RELEASE}."):
        raise ValueError(f"PYODIDE must be a release of Pyodide {RELEASE}, but {release} is {found}")
    files = {name: lock["packages"].get(name, {}).get("file_name", f"{name}*.whl") for name in with_all(lock, needed)}
    missing = [file for file in (*ENGINE, *files.values()) if not (release / file).is_file()]
    if missing:
        raise ValueError(f"PYODIDE must hold all files of the release, but {release} lacks {', '.join(missing)}")
    return lock


def with_all(lock: dict[str, Any], names: Iterable[str]) -> dict[str, None]:
    """These packages and all that they depend on, each once."""
    found = dict[str, None]()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found[name] = None
            waiting += [_key(other) for other in lock["packages"].get(name, {}).get("depends", ())]
    return found


def build(release: Path, folder: Path, notebooks: Iterable[Path], needed: Iterable[str] = LESSONS) -> None:
    """Write JupyterLite into a folder.

    Args:
        release: the unpacked release of Pyodide.
        folder: what it replaces.
        notebooks: the lessons that it shows.
        needed: what these ask the release for.

    Raises:
        ValueError: `release` is none that fits.
        OSError, subprocess.SubprocessError: PyPI does not answer.
    """
    wanted = [*KERNEL, *needed]
    lock = check(release, wanted)
    work = folder.with_name(f"making-{folder.name}")  # a name that began with that of the folder would be left out
    shutil.rmtree(work, ignore_errors=True)
    (work / "files").mkdir(parents=True)
    for notebook in notebooks:
        (work / "files" / notebook.name).write_text(_for_pyodide(notebook), encoding="utf-8")
    packages = {name: lock["packages"][name] for name in with_all(lock, wanted)}
    ours = [*_from_pypi(work / "wheels"), *_own(work / "wheels")]
    packages |= {_key(_name_of(wheel)): _entry(wheel) for wheel in ours}
    names = [*(name for name in packages if name not in KERNEL), *PROVIDED, *KERNEL]
    (work / "jupyter-lite.json").write_text(json.dumps(_settings(names)), encoding="utf-8")
    _run_jupyterlite(work, folder)
    engine = folder / "static" / "pyodide"
    engine.mkdir(parents=True)
    for name in (*ENGINE, *(packages[name]["file_name"] for name in with_all(lock, wanted))):
        shutil.copy(release / name, engine)
    for wheel in (*ours, *folder.glob("extensions/@jupyterlite/*/static/pypi/*.whl")):
        shutil.copy(wheel, engine)
        packages[_key(_name_of(wheel))] = _entry(wheel)
    (engine / "pyodide-lock.json").write_text(json.dumps({"info": lock["info"], "packages": packages}))
    shutil.rmtree(work)


def _settings(names: list[str]) -> dict[str, Any]:
    """The settings of JupyterLite: every package is loaded with Python itself, so that nothing is looked for."""
    kernel = {
        "pyodideUrl": "./static/pyodide/pyodide.js",
        "disablePyPIFallback": True,
        "loadPyodideOptions": {"packages": names, "lockFileURL": "./static/pyodide/pyodide-lock.json"},
    }
    plugins = {"@jupyterlite/pyodide-kernel-extension:kernel": kernel}
    return {
        "jupyter-lite-schema-version": 0,
        "jupyter-config-data": {"appName": "EduGym", "litePluginSettings": plugins},
    }


def _run_jupyterlite(work: Path, folder: Path) -> None:
    tools = editor.HERE / "build" / "jupyterlite"
    stamp = tools / "installed.txt"
    if not stamp.exists() or stamp.read_text() != "\n".join(TOOLS):
        shutil.rmtree(tools, ignore_errors=True)
        subprocess.run([sys.executable, "-m", "venv", tools], check=True)
        subprocess.run([tools / "bin" / "pip", "install", "--quiet", *TOOLS], check=True)
        stamp.write_text("\n".join(TOOLS))
    shutil.rmtree(folder, ignore_errors=True)
    places = [f"--lite-dir={work}", f"--output-dir={folder}", f"--contents={work / 'files'}"]
    options = ["--apps=lab", "--apps=notebooks", "--no-sourcemaps", "--no-unused-shared-packages"]
    command = [str(tools / "bin" / "jupyter"), "lite", "build", *places, *options]
    path = os.pathsep.join([str(tools / "bin"), os.environ["PATH"]])
    done = subprocess.run(command, cwd=work, env={**os.environ, "PATH": path}, capture_output=True, text=True)
    if done.returncode:
        raise OSError(f"JupyterLite could not be built: {done.stderr[-2000:]}")


def _for_pyodide(notebook: Path) -> str:
    """The notebook, for the kernel of Pyodide, without outputs and without the cell that installs EduGym."""
    content = json.loads(notebook.read_text(encoding="utf-8"))
    content["metadata"]["kernelspec"] = {"name": "python", "display_name": "Python (Pyodide)", "language": "python"}
    content["cells"] = [cell for cell in content["cells"] if "# @title Install EduGym" not in "".join(cell["source"])]
    return json.dumps(content)


# Wheels


def _key(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _name_of(wheel: Path) -> str:
    return wheel.name.split("-")[0]


def _entry(wheel: Path) -> dict[str, Any]:
    """What a lock file says of a wheel."""
    name, number = wheel.name.split("-")[:2]
    return {
        "name": _key(name),
        "version": number,
        "file_name": wheel.name,
        "install_dir": "site",
        "sha256": hashlib.sha256(wheel.read_bytes()).hexdigest(),
        "package_type": "package",
        "imports": [name],
        "depends": [],
        "unvendored_tests": False,
    }


def _from_pypi(folder: Path) -> Iterator[Path]:
    wanted = [f"{name}=={version(name)}" for name in FROM_PYPI]
    command = [
        sys.executable,
        "-m",
        "pip",
        "download",
        "--quiet",
        "--no-deps",
        "--only-binary=:all:",
        f"--dest={folder}",
    ]
    subprocess.run([*command, *wanted], check=True)
    yield from folder.glob("*.whl")


def make_wheel(folder: Path, name: str, number: str, files: Mapping[str, bytes]) -> Path:
    """Write a wheel of these files, by their paths, and return where it is."""
    folder.mkdir(parents=True, exist_ok=True)
    made = folder / f"{name}-{number}-py3-none-any.whl"
    info = f"{name}-{number}.dist-info"
    metadata = f"Metadata-Version: 2.1\nName: {name}\nVersion: {number}\n"
    kind = "Wheel-Version: 1.0\nGenerator: site/lite.py\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    whole = {**files, f"{info}/METADATA": metadata.encode(), f"{info}/WHEEL": kind.encode(), f"{info}/RECORD": b""}
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path, content in whole.items():
            archive.writestr(path, content)
    return made


def _own(folder: Path) -> Iterator[Path]:
    """EduGym with its course, as it is published, and the module that its libraries look for and Pyodide lacks."""
    made = folder / "own"
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", f"--wheel-dir={made}"]
    subprocess.run([*command, str(editor.HERE.parent)], check=True)
    yield from made.glob("edugym-*.whl")
    yield make_wheel(folder, "edugym_stubs", "1.0.0", {"_multiprocessing.py": editor.MULTIPROCESSING.encode()})
