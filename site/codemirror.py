"""CodeMirror, the field in which a reader edits, as files beside the page: packages of npm, each of them one module.

No bundler is needed, since the modules only have to find each other by the names of files instead of packages.
"""

import json
import re
import tarfile
from pathlib import Path

import npm

VERSIONS = {
    "@codemirror/autocomplete": "6.20.4",  # which the one for Python imports
    "@codemirror/commands": "6.11.1",
    "@codemirror/lang-python": "6.2.1",
    "@codemirror/language": "6.13.1",
    "@codemirror/state": "6.7.6",
    "@codemirror/streamparser": "6.0.0",
    "@codemirror/view": "6.43.15",
    "@lezer/common": "1.5.5",
    "@lezer/highlight": "1.2.5",
    "@lezer/lr": "1.4.12",
    "@lezer/python": "1.1.19",
    "@marijn/find-cluster-break": "1.0.4",
    "crelt": "1.0.7",
    "style-mod": "4.1.4",
    "w3c-keyname": "2.2.8",
}
_IMPORT = re.compile(r"""\bfrom (['"])([@\w/.-]+)\1""")


def build(folder: Path) -> None:
    """Write the modules into a folder, with their licence.

    Raises:
        OSError, subprocess.SubprocessError: npm does not answer.
    """
    archives = {name: npm.fetched(f"{name}@{version}") for name, version in VERSIONS.items()}
    folder.mkdir(parents=True, exist_ok=True)
    for name, file in archives.items():
        with tarfile.open(file) as archive:
            place = json.loads(npm.content(archive, "package/package.json"))["exports"]["import"]
            module = npm.content(archive, f"package/{place.removeprefix('./')}").decode()
            (folder / "LICENSE").write_bytes(npm.content(archive, "package/LICENSE"))  # all are by one author
        (folder / file_of(name)).write_text(linked(module), encoding="utf-8")


def linked(module: str) -> str:
    """A module that imports the others as files in its folder."""
    return _IMPORT.sub(lambda found: f'from "./{file_of(found[2])}"' if found[2] in VERSIONS else found[0], module)


def file_of(name: str) -> str:
    """The file that holds a package."""
    return name.removeprefix("@").replace("/", "-") + ".js"
