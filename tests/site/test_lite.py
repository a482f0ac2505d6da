"""JupyterLite: what can be proven without the wheels of pandas, Matplotlib and SciPy, which no package registry has.

A small lesson runs in a real browser that finds no other host, on a stand-in for a release: it imports EduGym, checks
an exercise, trains an agent of the reader's own, and has a slider.
"""

import importlib.util
import json
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import lite
import pytest
import website

from tests.course.lab.browser import CHROMIUM, DRIVER, PANEL, SESSION, Page, chromium, until
from tests.site.release import stand_in
from tests.site.serving import served

NEEDED = ("numpy", "joblib", "tqdm", "rich")
CELLS = (
    """# @title Install EduGym where it is missing
raise RuntimeError("in the browser this cell is left out")""",
    """import numpy as np
import edugym
from edugym_course.grading import check
from edugym_course.lessons.loop.exercises import exercise_1
from edugym_course.notebook import sliders
print("NumPy adds large arrays:", (np.ones(100_000) + np.ones(100_000)).sum())""",
    """def discounted_return(rewards, discount):
    total = 0.0
    for reward in reversed(rewards):
        total = reward + discount * total
    return total
check(exercise_1, discounted_return)""",
    """from typing import NamedTuple
class MyAgent(NamedTuple):
    Q: np.ndarray
    def act(self, state, rng):
        if rng.random() < 0.1:
            return rng.integers(2)
        return rng.choice(np.flatnonzero(self.Q[state] == self.Q[state].max()))
    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + 0.9 * self.Q[next_state].max()
        self.Q[state, action] += 0.5 * (target - self.Q[state, action])
wall = edugym.make_mdp("Boulder", height=3)
agent = MyAgent(np.zeros((wall.observation_space.n, 2)))
print("return:", edugym.train(wall, agent, 3_000, seed=0).returns[-1])""",
    """runs = edugym.repeat("Boulder", {"mine": lambda mdp: MyAgent(np.zeros((mdp.observation_space.n, 2)))}, 300,
                     parameters={"height": 3}, repetitions=2)
print("runs:", len(runs.agents["mine"]))""",
    """def picture(height):
    wall = edugym.make_mdp("Boulder", height=height)
    return edugym.Boulder.create(height=height).scene(0)
sliders(picture, height=[3, 5, 8])""",
    """def discounted_return(rewards, discount):
    return sum(rewards)
check(exercise_1, discounted_return)""",
)
WRONG = len(CELLS) - 1
"""The last cell has a wrong answer: in JupyterLite, cells behind an error are not run."""


def test_what_is_no_release_is_refused(tmp_path: Path) -> None:
    """Each mistake is named: no lock file, another version, files that are missing."""
    with pytest.raises(ValueError, match=r"has no pyodide-lock\.json"):
        lite.check(tmp_path)
    lock = {"info": {"version": "0.29.0"}, "packages": {"numpy": {"file_name": "numpy-2.whl", "depends": ["x"]}}}
    (tmp_path / "pyodide-lock.json").write_text(json.dumps(lock))
    with pytest.raises(ValueError, match=r"0\.27, but .* is 0\.29\.0"):
        lite.check(tmp_path)
    lock["info"] = {"version": "0.27.7"}
    (tmp_path / "pyodide-lock.json").write_text(json.dumps(lock))
    for name in lite.ENGINE:
        (tmp_path / name).touch()
    with pytest.raises(ValueError, match=r"lacks numpy-2\.whl, x\*\.whl$"):
        lite.check(tmp_path, ["numpy"])
    (tmp_path / "numpy-2.whl").touch()
    lock["packages"]["numpy"]["depends"] = []  # type: ignore[index]
    (tmp_path / "pyodide-lock.json").write_text(json.dumps(lock))
    assert lite.check(tmp_path, ["numpy"]) == lock


@pytest.mark.slow
def test_the_page_says_whether_there_is_a_jupyterlab() -> None:
    """A link where one was built, and what is tested; the site is whole without it."""
    assert 'href="lite/lab/index.html"' in website.sources(with_lite=True)["students.md"].decode()
    assert "lite/lab" not in website.NO_LITE


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """The small lesson in JupyterLite."""
    if not (CHROMIUM and DRIVER and importlib.util.find_spec("selenium")):
        pytest.skip("needs Chromium, chromedriver and Selenium")
    folder = tmp_path_factory.mktemp("lite")
    cells: list[dict[str, Any]] = [
        {
            "cell_type": "code",
            "id": f"c{k}",
            "metadata": {"tags": ["raises-exception"] if k == WRONG else []},
            "source": text,
            "outputs": [],
            "execution_count": None,
        }
        for k, text in enumerate(CELLS)
    ]
    notebook = folder / "small.ipynb"
    notebook.write_text(json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": cells}))
    try:
        stand_in(folder / "release", (*lite.KERNEL, *NEEDED))
        lite.build(folder / "release", folder / "lite", [notebook], NEEDED)
    except (OSError, subprocess.SubprocessError) as error:
        pytest.skip(f"npm or PyPI cannot be reached: {error}")
    settings = folder / "lite" / "jupyter-lite.json"
    content = json.loads(settings.read_text())
    content["jupyter-config-data"]["exposeAppInBrowser"] = True
    settings.write_text(json.dumps(content))
    with served(folder / "lite") as address, chromium() as driver:
        driver.get(f"{address}lab/index.html?path=small.ipynb")
        shown = Page.of(driver)
        until(lambda: shown(f"window.jupyterapp && {PANEL}?.context?.path === 'small.ipynb'"), "the notebook")
        until(lambda: shown(f"{SESSION}.session?.kernel?.status === 'idle'"), "the kernel", 300)
        yield shown


def _said(cell: dict[str, Any]) -> str:
    """All that a cell shows."""
    return json.dumps(cell["outputs"], ensure_ascii=False)


@pytest.mark.slow
def test_a_lesson_runs_in_jupyterlite(page: Page) -> None:
    """It computes, checks a wrong and a right answer, trains, and its slider draws another picture."""
    imported, right, trained, repeated, _, wrong = page.run_all()
    assert "200000.0" in _said(imported)
    assert "discounted_return([4.0, 2.0, 8.0], 0.25)" in _said(wrong)
    assert "Right" in _said(right)
    assert "return: 1.0" in _said(trained)
    assert "runs: 2" in _said(repeated)
    (box,) = page.widgets()
    first = page.picture(box)
    assert "<svg" in first
    page.drag(page("arguments[0].querySelector('.noUi-handle')", box), "right")
    until(lambda: page.picture(box) != first, "the other picture")
    assert page.errors(box) == []
    hosts = page("performance.getEntriesByType('resource').map(entry => new URL(entry.name).host)")
    assert set(hosts) == {page("location.host")}
