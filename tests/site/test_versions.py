"""Several versions of the website side by side: the switch, the banner, and what leads to the newest."""

import errno
import html
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import versions
from repository import ROOT, VERSION, documented

PAGE = """<aside class="sidebar-drawer"><p class="versions">Version {version}</p></aside>
<article role="main" id="furo-main-content">
<section>{version}</section></article>"""
LINK = re.compile(r'<li><a href="([^"]+)"( aria-current="true")?>([^<]+)</a></li>')


def built(folder: Path, version: str, pages: tuple[str, ...]) -> Path:
    """A website of some pages, and one without a sidebar."""
    for page in pages:
        (folder / page).parent.mkdir(parents=True, exist_ok=True)
        (folder / page).write_text(PAGE.format(version=version), encoding="utf-8")
    (folder / "playground").mkdir(exist_ok=True)
    (folder / "playground" / "index.html").write_text("a page of its own", encoding="utf-8")
    return folder


def together(folder: Path) -> Path:
    """Four versions: in 1.10.0 one page is new, and another is gone."""
    both = ("index.html", "lessons/01.html")
    for name, more in {"1.9.0": "old.html", "dev": "new.html", "2.0.0rc1": "new.html", "1.10.0": "new.html"}.items():
        there = versions.add(built(folder / f"built-{name}", name, (*both, more)), folder / "all", name)
        assert name in there
    return folder / "all"


def test_the_switch_leads_to_the_same_page_or_to_the_first(tmp_path: Path) -> None:
    """On every page of every version, whenever that was added: all versions in order, and this one marked."""
    folder = together(tmp_path)
    names = ["2.0.0rc1", "1.10.0", "1.9.0", "dev"]
    assert versions.versions(folder) == names
    assert versions.newest(names) == "1.10.0"
    for name in names:
        for page in (folder / name).rglob("*.html"):
            written = page.read_text(encoding="utf-8")
            if page.parent.name == "playground":
                assert written == "a page of its own"
                continue
            found = LINK.findall(written)
            assert [shown.partition(" ")[0] for _, _, shown in found] == names
            for to, (link, marked, shown) in zip(names, found, strict=True):
                same = folder / to / page.relative_to(folder / name)
                target = Path(os.path.normpath(page.parent / html.unescape(link)))
                assert target == (same if same.exists() else folder / to / "index.html")
                assert (bool(marked), shown.endswith("(the newest)")) == (to == name, to == "1.10.0")
            banners = re.findall(r'<p class="banner">This is (.+?)\. <a href="([^"]+)">', written)
            expected = {"dev": "the version in development", "1.10.0": None}.get(name, f"version {name}")
            assert [said for said, _ in banners] == ([expected] if expected else [])
            assert all("/1.10.0/" in link for _, link in banners)


def test_stable_leads_to_the_newest_release(tmp_path: Path) -> None:
    """A page for each of its pages, which keeps the fragment, and the first page of all; others are gone."""
    folder = together(tmp_path)
    leading = {page.relative_to(folder / "stable") for page in (folder / "stable").rglob("*.html")}
    assert leading == {page.relative_to(folder / "1.10.0") for page in (folder / "1.10.0").rglob("*.html")}
    for page in [folder / "index.html", *(folder / "stable" / page for page in leading)]:
        written = page.read_text(encoding="utf-8")
        (target,) = set(re.findall(r'url=(.+?)"|replace\("(.+?)"|href="(.+?)"', written)[0]) - {""}
        assert written.count(target) == 3
        assert "location.hash" in written
        assert (page.parent / target).resolve().is_relative_to(folder / "1.10.0")
        assert (page.parent / target).exists()


def no_space(*paths: Path) -> None:
    """What copying does on a full disk."""
    raise OSError(errno.ENOSPC, "No space left on device")


def test_a_version_takes_the_place_of_one_of_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Adding it again changes nothing else, nor does a call that fails; without a website the way out is said."""
    folder = together(tmp_path)
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    versions.add(tmp_path / "built-1.9.0", folder, "1.9.0")
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before
    monkeypatch.setattr(versions, "BUILT", tmp_path / "nothing")
    monkeypatch.setattr(sys, "argv", ["versions.py", str(folder)])
    assert versions.main() == 1
    assert "make site" in capsys.readouterr().err
    (folder / "dev").rename(folder / ".old-dev")  # as a build leaves it that was killed at the worst moment
    with monkeypatch.context() as patch:
        patch.setattr(shutil, "copytree", no_space)
        with pytest.raises(OSError, match="No space"):
            versions.add(tmp_path / "built-dev", folder, "dev")
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before
    versions.add(built(tmp_path / "less", "dev", ("index.html",)), folder, "dev")
    assert not (folder / "dev" / "new.html").exists()
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}.keys() < before.keys()


def test_the_folder_of_one_version_in_development_has_no_banner(tmp_path: Path) -> None:
    """Before the first release it is the one that readers want."""
    versions.add(built(tmp_path / "built", "0.1", ("index.html",)), tmp_path / "all", "dev")
    assert "banner" not in (tmp_path / "all" / "dev" / "index.html").read_text(encoding="utf-8")
    assert "dev/index.html" in (tmp_path / "all" / "index.html").read_text(encoding="utf-8")


def test_the_workflow_keeps_all_versions(tmp_path: Path) -> None:
    """Its own commands, on a repository here: the first makes the branch, and each later one adds to what is there."""
    yaml = pytest.importorskip("yaml")
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / "website.yml").read_text(encoding="utf-8"))
    steps = {step.get("id"): step.get("run") for step in workflow["jobs"]["publish"]["steps"]}
    origin = tmp_path / "origin"
    ours = {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull}

    def run(command: str, folder: Path, **variables: str) -> str:
        done = subprocess.run(
            ["bash", "-e", "-c", command],
            cwd=folder,
            env={**os.environ, **ours, **variables},
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stderr
        return done.stdout

    somebody = "-c user.name=a -c user.email=a@example.org"
    run(f"git init --quiet {origin} && touch {origin}/file && git -C {origin} add .", tmp_path)
    run(f"git -C {origin} {somebody} commit --quiet -m first", tmp_path)
    for kind, name, version in (("tag", "v1.0", "1.0"), ("branch", "main", "1.0"), ("tag", "v1.1", "1.1")):
        checkout = tmp_path / name
        run(f"git clone --quiet {origin} {checkout}", tmp_path)
        built(checkout / "site" / "build" / "html", version, ("index.html",))
        for file in ("versions.py", "repository.py"):
            shutil.copy(ROOT / "site" / file, checkout / "site")
        project = f'[project]\nversion = "{version}"\nurls = {{ Repository = "https://example.org" }}\n'
        (checkout / "pyproject.toml").write_text(project, encoding="utf-8")
        (checkout / ".venv").symlink_to(sys.prefix)
        for step in ("there", "all"):
            run(steps[step], checkout, GITHUB_REF_TYPE=kind, GITHUB_REF_NAME=name)
    run(f"git clone --quiet --branch website {origin} {tmp_path / 'shown'}", tmp_path)
    assert versions.versions(tmp_path / "shown") == ["1.1", "1.0", "dev"]
    assert "(the newest)" in (tmp_path / "shown" / "1.1" / "index.html").read_text(encoding="utf-8")
    assert run("git rev-list --count HEAD", tmp_path / "shown").strip() == "3"


def test_the_site_says_of_which_version_it_is() -> None:
    """What is unreleased counts if there is anything; a new release has nothing yet."""
    released = f"# Changelog\n\n## [Unreleased]\n\n## [{VERSION}] - 2026-01-01\n\nThe first.\n"
    assert documented(released) == VERSION
    later = released.replace("[Unreleased]\n", "[Unreleased]\n\n- More.\n")
    assert documented(later) == f"{VERSION}, and what came after it"
