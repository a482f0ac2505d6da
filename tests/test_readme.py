"""The README, the pages of docs and docstrings: examples print what they say, and links of pages lead somewhere."""

import contextlib
import inspect
import io
import re
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import edugym

ROOT = Path(__file__).parent.parent
PAGES = [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]
EXAMPLE = re.compile(r"```python\n(.*?)```\s+```text\n(.*?)```", flags=re.DOTALL)
TEXTS = [(page.name, page.read_text(encoding="utf-8")) for page in [*PAGES, *ROOT.glob("site/pages/*.md")]]
TEXTS += [(name, inspect.getdoc(getattr(edugym, name)) or "") for name in dir(edugym)]
EXAMPLES = [(name, *found) for name, text in TEXTS for found in EXAMPLE.findall(text)]


@pytest.mark.parametrize(("page", "code", "output"), EXAMPLES, ids=lambda part: part[:15])
def test_an_example_prints_what_its_page_says(page: str, code: str, output: str) -> None:
    """Each is run as a script."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(code, page, "exec"), {"__name__": "__main__"})
    assert printed.getvalue() == output


def test_the_worked_example_of_an_agent(monkeypatch: pytest.MonkeyPatch) -> None:
    """CONTRIBUTING prints an agent and its test: the test passes, and fails where the slow rate is ignored."""
    agent, test = re.findall(r"```python\n(.*?)```", (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"), re.DOTALL)
    name = "edugym.agents.hysteretic_q_learning"
    for code, passes in ((agent, True), (agent.replace("else self.slow_rate", "else self.learning_rate"), False)):
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
        exec(compile(code, "CONTRIBUTING.md", "exec"), vars(sys.modules[name]))
        namespace: dict[str, Any] = {}
        exec(compile(test, "CONTRIBUTING.md", "exec"), namespace)
        [cases] = namespace["test_update"].pytestmark
        with contextlib.nullcontext() if passes else pytest.raises(AssertionError):
            for case in cases.args[1]:
                namespace["test_update"](*case)


def test_links_lead_somewhere() -> None:
    """Those to files of the project; a change of a page's form hides no example."""
    assert {"README.md", "your-own.md", "engineers.md", "train"} <= {page for page, *_ in EXAMPLES}
    links = [
        (page, link.partition("#")[0])
        for page in PAGES
        for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8"))
        if not link.startswith(("http", "#", "mailto:"))
    ]
    assert len(links) > 50
    assert [f"{page.name}: {link}" for page, link in links if not (page.parent / link).exists()] == []
