"""The website is built as a whole: what its settings add to a page, and how it is shown."""

import sys
from concurrent.futures import ThreadPoolExecutor
from http.server import ThreadingHTTPServer
from pathlib import Path
from urllib.request import urlopen

import pytest

INDEX = r"""# First

A page of more than three words.

| | $\pi < 1$ |
|---|---|
| $a$ | b |

$$x$$

```{py:function} train(mdp, agent, n_steps, seed, evaluate_every, evaluation_episodes)
```

"""
BELOW = "```{{toctree}}\n:hidden:\n\n{}\n```\n"
ADDED = (
    '<td class="head"></td>',
    '<th class="head"><p><math aria-label="&#x003C0;&#x0003C;1"',
    '<div class="formula"><math',
    '<aside class="sidebar-drawer" aria-label="All pages">',
    '<aside class="toc-drawer" aria-label="On this page">',
    '<li class="group">To begin</li>',
    '<meta name="description" content="A page of more than three words.">',
    '<meta property="og:title" content="First">',
    '<p class="versions">Version ',
    '<span class="parameters">',
    "_static/site.css",
    'defer="defer" src="_static/site.js',
)
"""What the website's settings add to a page, once."""


def test_a_website_is_built_and_shown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Three pages with all that the settings add, and the playground. What was there before is gone."""
    website = pytest.importorskip("website")
    texts = {"index": INDEX + BELOW.format("lessons/index"), "lessons/index": "# Lessons\n\n" + BELOW.format("00_loop")}
    files = {f"{page}.md": text.encode() for page, text in {**texts, "lessons/00_loop": "# Loop"}.items()}
    shown = list[str]()

    class Server(ThreadingHTTPServer):
        def serve_forever(self, poll_interval: float = 0.5) -> None:
            with ThreadPoolExecutor() as reader:
                for page in ("", "playground/", "search.html", "lessons/00_loop.html"):
                    asked = reader.submit(urlopen, f"http://127.0.0.1:{self.server_port}/{page}")
                    self.handle_request()
                    shown.append(asked.result().read().decode())

    for name, value in {"sources": lambda with_lite: files, "BUILT": tmp_path, "ThreadingHTTPServer": Server}.items():
        monkeypatch.setattr(website, name, value)
    raced = tmp_path / "playground" / "index.html"
    monkeypatch.setattr(website.playground, "BUILT", raced.parent)
    monkeypatch.setattr(website.playground, "build", lambda folder, jobs: raced.write_text("races"))
    monkeypatch.setattr(sys, "argv", ["website.py", "--serve", "--port", "0", "--jobs", "1"])
    for old in ("source/old.md", "html/old.html", "html/playground/old.html", "playground/new.html"):
        (tmp_path / old).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / old).write_text("# Old")
    assert website.main() == 0
    page, races, search, lesson = shown
    for part in ADDED:
        assert page.count(part) == 1, part
    assert "<dl>" not in page
    assert lesson.count('<li class="group">To begin</li>') == 1
    assert races == "races"
    assert "<h1>Search</h1>" in search
    assert not [*tmp_path.rglob("old*")]
    assert (tmp_path / "html" / "_static" / "math.woff").stat().st_size > 10_000
    beside = tmp_path / "html" / "notebooks"
    assert {path.stem for path in beside.glob("*.ipynb")} == {path.name for path in (beside / "flipbooks").iterdir()}
