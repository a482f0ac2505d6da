"""Build the website, from what stands in the checkout. Nothing is executed: figures come from the committed notebooks.

    python site/website.py              build it, into site/build/html, and in a terminal show it at http://127.0.0.1:8000
    python site/website.py --no-serve   build it only, which is also what happens where no terminal is

Pages that stand nowhere else are in `pages`. All others are made from docs, notebooks, docstrings and the registry.
"""

import argparse
import re
import shutil
import sys
from contextlib import suppress
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import accessibility
import agent_pages
import groups
import guides
import lesson_pages
import lite
import mathematics
import playground
import projected_pages
import reference_pages
import slider_views
from races import RACES
from repository import PICTURES, ROOT, page_of, picture_of, with_links, with_sections
from sphinx.cmd.build import main as sphinx_build
from survey import form
from words import WORDS

from edugym.adapters.registration import in_course_order

HERE = ROOT / "site"
BUILT = HERE / "build"
RACE = '\n*{1}* <a href="../playground/index.html#task={0}">Bet on an agent, or play yourself</a>.\n\n```python'
TIME = re.compile(
    r"\*\*Time\.\*\* About (\d+)\s.*?(\d+)\s+more\s+for\s+the\s+exercises"
    r".*?\*\*Before you start\.\*\* (.*?)\s+All\s+symbols",
    re.DOTALL,
)
FARING = "\n## Agents\n[Which agent works with which environment](../agents/index.md), and how far it gets.\n"

LITE = """<a href="lite/lab/index.html">JupyterLab with all lessons</a> runs here in your browser: nothing is
installed, and nothing is sent anywhere. The first start loads Python and its libraries, which takes a while. Your
changes stay in this browser, so download what you want to keep.

What is tested of it, in Chromium, with every other host cut off: a small lesson that imports EduGym, checks a right
and a wrong answer, trains an agent of your own, and draws with a slider. *Not* tested are whole lessons: they need
pandas, Matplotlib and SciPy, which only a release of Pyodide has, and the tests have none. Code is interpreted there,
so training is some hundred times slower than on your machine."""
NO_LITE = """This site has [the playground](playground.md), where you can also change the code of agents, and all
lessons to read, with their results and questions. Notebooks do not run in this copy of it. A link at the top of each
lesson opens it in Colab, a service of Google for which you need an account there (we have not tried it)."""


def sources(with_lite: bool = False) -> dict[str, bytes]:
    """Return the contents of all files that Sphinx reads, by their path; JupyterLite is there `with_lite`."""
    lessons = lesson_pages.lessons()
    texts = {
        **_copied(),
        **{f"lessons/{lesson.name}": lesson.text for lesson in lessons},
        **agent_pages.pages(lessons),
        **projected_pages.pages(lessons),
        **reference_pages.pages(),
    }
    texts["guides/index"] = guides.index(texts)
    texts["lessons/index"] = "# The lessons\n\n" + "".join(map(_introduced, lessons))
    for race in RACES:
        page = f"environments/{race.environment.lower()}"
        texts[page] = texts[page].replace("\n```python", RACE.format(race.environment, race.question), 1)
    for entry in in_course_order():
        texts[f"environments/{entry.name.lower()}"] += FARING
    for name, kind in agent_pages.AGENTS.items():
        link = f"| [{name}](/{agent_pages.place(kind)}.md) |"
        texts["agents/index"] = texts["agents/index"].replace(f"\n| {name} |", f"\n{link}")
    texts["index"] = texts["index"].replace("<!-- gallery -->", _gallery())
    texts["index"] = texts["index"].replace("<!-- preloads -->", playground.preloads("playground/"))
    texts["students"] = texts["students"].replace("<!-- lite -->", LITE if with_lite else NO_LITE)
    texts["survey"] = texts["survey"].replace("<!-- form -->", form(lessons))
    for folder, pages in _children(texts, lessons).items():
        texts[f"{folder}/index"] += "\n".join(["\n```{toctree}", ":hidden:", "", *pages, "```", ""])
    figures = {path: content for lesson in lessons for path, content in lesson.figures.items()}
    figures |= projected_pages.figures(lessons)
    pictures = [path for path in (ROOT / "docs").rglob("*") if path.suffix in PICTURES]
    return {
        **{f"{page}.md": text.encode() for page, text in texts.items()},
        **{picture_of(str(path)): path.read_bytes() for path in pictures},
        **figures,
    }


def _copied() -> dict[str, str]:
    """Return the pages that are files of the checkout."""
    found = [
        *ROOT.glob("*.md"),
        *ROOT.glob("docs/*.md"),
        *ROOT.glob("docs/environments/*.md"),
        *HERE.glob("pages/*.md"),
    ]
    texts = {}
    for file in found:
        path = file.relative_to(ROOT).as_posix()
        page = page_of(path)
        if page is not None and path != "README.md":  # whose sections are on the pages
            texts[page] = with_sections(with_links(file.read_text(encoding="utf-8"), path, page), page)
    texts[str(page_of("LICENSE"))] = f"# {(ROOT / 'LICENSE').read_text(encoding='utf-8')}"
    return texts


def _introduced(lesson: lesson_pages.Lesson) -> str:
    """Return a lesson's entry in the list of lessons, with its challenge, its time, and what to know before."""
    challenge = projected_pages.CHALLENGE.findall(lesson.text)[0].replace("\n", " ")
    path, exercises, before = TIME.findall(lesson.text)[0]
    time = f"About {path} minutes for the text, and {exercises} for the exercises. {before}".replace("\n", " ")
    return f"- [{lesson.numbered}](/lessons/{lesson.name}.md)\\\n  {challenge}\\\n  <small>{time}</small>\n"


def _children(texts: dict[str, str], lessons: list[lesson_pages.Lesson]) -> dict[str, list[str]]:
    """Return the pages below each index, in the order of the course where there is one, lessons with their numbers."""
    called = {
        f"{folder}/{lesson.name}": f"{lesson.numbered} <{lesson.name}>"
        for lesson in lessons
        for folder in ("lessons", "project")
    }
    in_order = [*(f"environments/{entry.name.lower()}" for entry in in_course_order()), *guides.ORDER, *groups.ORDER]
    order = {page: number for number, page in enumerate(in_order)}
    folders = sorted({page.partition("/")[0] for page in texts if "/" in page} - {"reference"})
    return {
        folder: [
            called.get(page, page.partition("/")[2])
            for page in sorted(texts, key=lambda page: (order.get(page, len(order)), page))
            if page.startswith(f"{folder}/") and page != f"{folder}/index"
        ]
        for folder in folders
    }


def _gallery() -> str:
    """Return the environments, moving: each leads to its race if there is one, with a small link to its page.

    The films are those of the environments' pages. They wait for the first race, see site.js.
    """
    raced = {race.environment for race in RACES}
    cards = []
    for e in in_course_order():
        page = f"environments/{e.name.lower()}"
        leads = f"playground/index.html#task={e.name}" if e.name in raced else f"{page}.html"
        film = f'<img src="_images/{e.name.lower()}.gif" alt="An episode of {e.name}" loading="lazy">'
        cards.append(
            f'<a href="{leads}">{film} **{e.name}** {WORDS[e.name].challenge}</a> '
            f"<small>*{e.challenge}* · [details of {e.name}]({page}.md)</small>"
        )
    return "\n".join([":::{container} gallery", "", "\n\n".join(cards), "", ":::"])


def write(folder: Path, with_lite: bool = False) -> None:
    """Write the sources into a folder; Sphinx reads again what has changed."""
    wanted = sources(with_lite)
    for file in [file for file in folder.rglob("*") if file.is_file()]:
        if file.relative_to(folder).as_posix() not in wanted:
            file.unlink()
    for path, content in wanted.items():
        file = folder / path
        if not file.exists() or file.read_bytes() != content:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)


def write_pages(folder: Path, jobs: int = 2, with_lite: bool = False) -> int:
    """Write all pages but the playground into `folder`/html. Return Sphinx's exit status; a warning is an error."""
    write(folder / "source", with_lite)
    source, html, doctrees = (str(folder / name) for name in ("source", "html", "doctrees"))
    shutil.rmtree(html, ignore_errors=True)  # every page has the navigation, so every page is written
    options = ["-a", "-b", "html", "-W", "--keep-going", "-q", "-j", str(jobs)]
    status = sphinx_build([*options, "-c", str(HERE), "-d", doctrees, source, html])
    if status == 0:
        accessibility.mend(folder / "html")
        (folder / "html" / "_static" / "math.woff").write_bytes(mathematics.font())
        shutil.copytree(ROOT / "notebooks", folder / "html" / "notebooks", ignore=_no_folders, dirs_exist_ok=True)
        shutil.copytree(slider_views.FOLDER, folder / "html" / "notebooks" / "flipbooks")
    return int(status)


def build(folder: Path, jobs: int = 2, pyodide: Path | None = None) -> int:
    """Write the whole website into `folder`/html, with JupyterLite if a release of Pyodide is given."""
    if pyodide:
        lite.check(pyodide)
    status = write_pages(folder, jobs, with_lite=pyodide is not None)
    if status == 0:
        playground.build(playground.BUILT, jobs=jobs)
        shutil.rmtree(folder / "html" / "playground", ignore_errors=True)
        shutil.copytree(playground.BUILT, folder / "html" / "playground")
        if pyodide:
            lite.build(pyodide, folder / "html" / "lite", sorted(lesson_pages.NOTEBOOKS.glob("*.ipynb")))
    return status


def _no_folders(folder: str, names: list[str]) -> list[str]:
    return [name for name in names if Path(folder, name).is_dir()]


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--serve",
        action=argparse.BooleanOptionalAction,
        default=sys.stdout.isatty(),
        help="show it on this machine, until Ctrl-C; by default where standard output is a terminal",
    )
    parser.add_argument("--port", type=int, default=8000, help="where to show it")
    parser.add_argument("--jobs", type=int, default=2, help="how many processes write pages")
    parser.add_argument("--pyodide", type=Path, help="an unpacked release of Pyodide: adds the lessons in JupyterLite")
    options = parser.parse_args()
    try:
        status = build(BUILT, options.jobs, options.pyodide)
    except ValueError as error:
        parser.error(str(error))
    if status == 0 and options.serve:
        try:
            serve(BUILT / "html", options.port)
        except (OSError, OverflowError) as error:
            parser.error(f"--port {options.port} cannot be used ({error}): take another one, or 0 for any that is free")
    elif status == 0:
        print(f"The website is in {BUILT / 'html'}: make site ARGS=--serve shows it.")
    return status


def serve(folder: Path, port: int) -> None:
    """Show a folder at a port of this machine, until Ctrl-C."""
    handler = partial(SimpleHTTPRequestHandler, directory=folder)
    with ThreadingHTTPServer(("127.0.0.1", port), handler) as server, suppress(KeyboardInterrupt):
        print(f"The website is at http://127.0.0.1:{server.server_port}/ (Ctrl-C ends it)", flush=True)
        server.serve_forever()


if __name__ == "__main__":
    sys.exit(main())
