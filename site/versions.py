"""Put the website that `make site` has built beside those of other versions, with a switch between them on every page.

    python site/versions.py FOLDER          add it to a folder as the version that pyproject.toml names
    python site/versions.py FOLDER --dev    add it as the development version, `dev`

The folder can then be served anywhere, also below another address. Each version is in a folder of its own, `stable`
leads to the newest release, and so does the address of the folder itself. The switch is written into the pages of all
versions, old ones too: it asks no server, and works without JavaScript and from files.
"""

import argparse
import html
import json
import os
import re
import shutil
import sys
from pathlib import Path

from packaging.version import InvalidVersion, Version
from repository import ROOT, VERSION

from edugym.system.files import write_whole

BUILT = ROOT / "site" / "build" / "html"
DEV = "dev"
STABLE = "stable"
_SWITCH = re.compile(r'<(p|details) class="versions">.*?</\1>', re.DOTALL)
_ARTICLE = re.compile(r'(<article role="main"[^>]*>)(?:\n<p class="banner">.*?</p>)?')
MOVED = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>EduGym</title><meta name="robots" content="noindex">
<script>location.replace({script} + location.search + location.hash)</script>
<noscript><meta http-equiv="refresh" content="0; url={target}"></noscript></head>
<body><p>This page is <a href="{target}">in the newest version</a>.</p></body></html>
"""


def versions(folder: Path) -> list[str]:
    """Return the names of the versions in a folder: releases, the newest first, then the development version."""
    there = [path.name for path in folder.iterdir() if (path / "index.html").is_file()]
    releases = sorted((name for name in there if _release(name)), key=Version, reverse=True)
    return [*releases, *([DEV] if DEV in there else [])]


def newest(names: list[str]) -> str:
    """Return the version that most readers want, of at least one: the newest release that is no trial."""
    return next((name for name in names if name != DEV and not Version(name).is_prerelease), names[0])


def add(built: Path, folder: Path, name: str) -> list[str]:
    """Copy a website into a folder as a version, in the place of one of the same name, and write the switches.

    Args:
        built: the website.
        folder: with the versions; it is made if it is not there.
        name: the version.

    Returns:
        All versions there.

    Raises:
        ValueError: there is no website to copy.
        OSError: something cannot be read or written. Every page is whole then, old or new; the next call does the rest.
    """
    if not (built / "index.html").is_file():
        raise ValueError(f"there is no website in {built}: build it with `make site` first")
    folder.mkdir(parents=True, exist_ok=True)
    new, old = folder / f".new-{name}", folder / f".old-{name}"
    if old.exists() and not (folder / name).exists():  # it was killed between the two names
        old.rename(folder / name)
    for left in (new, old):
        shutil.rmtree(left, ignore_errors=True)
    shutil.copytree(built, new)
    if (folder / name).exists():
        (folder / name).rename(old)
    new.rename(folder / name)
    shutil.rmtree(old, ignore_errors=True)
    write_switches(folder)
    return versions(folder)


def write_switches(folder: Path) -> None:
    """Write what leads from version to version: the switches of all pages, `stable`, and the first page."""
    names = versions(folder)
    best = newest(names)
    for name in names:
        for page in sorted((folder / name).rglob("*.html")):
            written = page.read_text(encoding="utf-8")
            if (switched := _switched(written, page.relative_to(folder / name), name, names, folder)) != written:
                write_whole(page, switched.encode(), synced=False)
    shutil.rmtree(folder / STABLE, ignore_errors=True)
    for page in (folder / best).rglob("*.html"):
        _lead(folder / STABLE / page.relative_to(folder / best), page)
    _lead(folder / "index.html", folder / best / "index.html")
    (folder / ".nojekyll").touch()  # or GitHub Pages leaves out what begins with an underscore


def _switched(text: str, page: Path, name: str, names: list[str], folder: Path) -> str:
    """Return a page with the switch of today, and with a banner if most readers want another version."""

    def link(to: str) -> str:
        """The same page of a version, or its first one."""
        target = folder / to / page
        target = target if target.is_file() else folder / to / "index.html"
        return html.escape(_way(target, folder / name / page))

    best = newest(names)
    called = {one: f"{one} (the newest)" if one == best else one for one in names}
    marks = {name: ' aria-current="true"'}
    rows = [f'<li><a href="{link(one)}"{marks.get(one, "")}>{called[one]}</a></li>' for one in names]
    switch = f'<details class="versions"><summary>Version {called[name]}</summary><ul>{"".join(rows)}</ul></details>'
    banner = ""
    if name != best:
        what = "the version in development" if name == DEV else f"version {name}"
        banner = f'\n<p class="banner">This is {what}. <a href="{link(best)}">Read version {best}</a>, the newest.</p>'
    text = _SWITCH.sub(lambda _: switch, text)
    return _ARTICLE.sub(lambda found: found[1] + banner, text)


def _lead(page: Path, target: Path) -> None:
    """Write a page that leads to another one, and keeps what stands behind its address."""
    way = _way(target, page)
    write_whole(page, MOVED.format(target=html.escape(way), script=json.dumps(way)).encode(), synced=False)


def _way(target: Path, page: Path) -> str:
    return os.path.relpath(target, page.parent).replace(os.sep, "/")


def _release(name: str) -> bool:
    try:
        Version(name)
    except InvalidVersion:
        return False
    return True


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="the folder of all versions")
    parser.add_argument("--dev", action="store_true", help="it is the version in development")
    options = parser.parse_args()
    try:
        names = add(BUILT, options.folder, DEV if options.dev else VERSION)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{options.folder} has the versions {', '.join(names)}; the newest is {newest(names)}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
