"""A reader's own code in the playground, in a real browser: change it, run it, pass it on."""

import random
from typing import Any

import pytest
from races import BOULDER, RACES

from tests.course.lab.browser import IN_A_BROWSER, faults, until
from tests.site.reader import PHONE, WIDE, Reader

pytestmark = IN_A_BROWSER

FIELD = "document.querySelector('#editor').field"


def change(reader: Reader, old: str, new: str) -> None:
    """Change a reader's program, as typing does: at first in a plain field, then in CodeMirror."""
    reader(
        """(field => {
            const from = field.text.indexOf(arguments[0]), to = from + arguments[0].length, insert = arguments[1]
            if (field.view) return field.view.dispatch({ changes: { from, to, insert } })
            field.area.setRangeText(insert, from, to)
            field.area.dispatchEvent(new Event('input'))
        })"""
        + f"({FIELD})",
        old,
        new,
    )


def ran(reader: Reader) -> str:
    """Run a reader's program to its end, and return what is said."""
    reader.click("#run-code")
    until(lambda: not reader("document.querySelector('#run-code').disabled"), "the end of the run", 300)
    return reader.text("#code-status")


@pytest.mark.parametrize("size", [WIDE, PHONE], ids=["wide", "phone"])
def test_a_reader_changes_the_code(size: tuple[int, int], address: str, browser: Any) -> None:
    """Python comes with the first change; mistakes have their line; what is endless can be stopped."""
    reader = Reader(browser, f"{address}#task=Boulder&strength=3&code=true&steps=100000", size)
    if reader("document.querySelector('#tab-code').hidden"):
        pytest.skip("npm does not answer, so there is no editor")
    until(lambda: reader(f"{FIELD}.text"), "the program")
    assert "loads Python" in reader.text("#code-status")
    change(reader, "a few lines", "some lines")
    until(lambda: "Press Run" in reader.text("#code-status"), "Python", 300)
    said = ran(reader)
    assert "your agent has 1," in said
    assert "interpreted" not in reader.text("#code-said")
    until(lambda: reader("document.querySelectorAll('#code-chart polyline[points*=\",\"]').length") == 2, "two curves")
    assert reader("document.querySelector('#ours canvas').dataset.cells") == "11"
    walker = "document.querySelector('#ours svg:last-child').innerHTML"
    seen = reader(walker)
    assert seen
    until(lambda: reader(walker) != seen, "its next step")
    reader.photograph(f"code-{size[0]}")
    change(reader, "target - self", "target - sef")
    assert ran(reader).startswith("Line 17. NameError")
    assert reader.text(".cm-gutterElement.wrong") == "17"
    until(lambda: reader.text("#code-chart .key") == "Q-learning", "a key without who has no line")
    assert reader("getComputedStyle(document.querySelector('#walks')).visibility") == "hidden"
    change(reader, "target - sef", "target - self")
    assert reader.text("#code-status") == "The code has changed. Press Run."
    change(reader, "        target =", "        notes = {}\n        target =")
    ran(reader)
    assert "it makes a dict (line 16)" in reader.text("#code-said")
    change(reader, "        notes = {}\n", "        while True: pass\n")
    reader.click("#run-code")
    reader.click("#stop-code")
    assert "Stopped" in reader.text("#code-status")
    change(reader, "        while True: pass\n", "        print(state)\n")
    ran(reader)
    assert reader.text("#printed").startswith("0\n")
    assert reader.text("#printed").endswith("not shown)")
    change(reader, "        print(state)\n", "")
    assert "your agent has 1," in ran(reader)
    reader.check()


def test_the_code_has_settings_of_its_own(address: str, browser: Any) -> None:
    """With them a change shows; the race stays as it was, and a link has those of the tab that it opens."""
    reader = Reader(browser, f"{address}#task=Boulder&steps=10000")
    if reader("document.querySelector('#tab-code').hidden"):
        pytest.skip("npm does not answer, so there is no editor")

    def settings(prefix: str) -> list[str]:
        ids = [f"{prefix}{name}" for name in ("strength", "steps", "several")]
        return [str(reader("document.getElementById(arguments[0]).value", name)) for name in ids]

    trial = [str(value) for value in BOULDER.trial]
    reader.move("speed", 7.2)
    reader.click("#run")
    until(lambda: "Pause" not in reader.text("#run"), "the end of the race")
    said = reader.text("#verdict")
    reader.click("#tab-code")
    until(lambda: settings("code-") == trial, "its own settings")
    assert "steps=20000" in reader("location.hash")
    until(lambda: "height=10" in reader.text("#code-said"), "the task")
    link = reader("location.href")
    reader.click("#tab-race")
    until(lambda: settings("") == [str(BOULDER.strength.first), "10000", str(BOULDER.seeds)], "those of the race")
    assert reader.text("#verdict") == said
    reader = Reader(browser, link)
    assert settings("code-") == trial
    reader.click("#tab-race")
    until(lambda: settings("") == [str(BOULDER.strength.first), str(BOULDER.n_steps), str(BOULDER.seeds)], "a race")
    assert reader.text("#verdict").startswith("Bet first")
    reader.check()


def test_a_link_holds_the_code(address: str, browser: Any) -> None:
    """Another reader sees it, is told where it is from, and nothing runs before Run; what is damaged is said."""
    reader = Reader(browser, f"{address}#task=Study&code=true&steps=10000&several=1")
    if reader("document.querySelector('#tab-code').hidden"):
        pytest.skip("npm does not answer, so there is no editor")
    until(lambda: reader(f"{FIELD}.text"), "the program")
    assert "source" not in reader("location.hash")
    change(reader, "self.Q[next_state]", "0.25 * self.Q[next_state]")
    reader.click("#share")
    until(lambda: reader.text("#shared"), "the link")
    link = reader("location.href")
    other = Reader(browser, link)
    until(lambda: "0.25 *" in other(f"{FIELD}.text"), "the code of the link")
    assert "comes from the link" in other.text("#code-status")
    assert not other("performance.getEntriesByType('resource').some(entry => /python|own/.test(entry.name))")
    other("location.hash = '#task=Golf'")
    until(lambda: "source=" in other("location.hash"), "the code in the link of another task")
    assert "Golf" in browser.title
    assert "your agent has" in ran(Reader(browser, link))
    damaged = Reader(browser, link.replace("source=", "source=AAAA"))
    until(lambda: "damaged" in damaged.text("#code-status"), "what is wrong")
    change(damaged, "a few lines", random.Random(0).randbytes(9_000).hex())
    damaged.click("#share")
    until(lambda: "too long" in damaged.text("#shared"), "what is wrong")
    assert "source" not in damaged("location.hash")
    damaged.check()


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("size", [WIDE, PHONE], ids=["wide", "phone"])
def test_a_reader_writes_with_keys(size: tuple[int, int], theme: str, address: str, browser: Any, axe: str) -> None:
    """The rich field comes with the first change, keeps what was typed, can be left by keyboard, and has no fault."""
    from selenium.webdriver import ActionChains, Keys

    def press(*keys: str) -> None:
        ActionChains(browser).send_keys(*keys).perform()

    reader = Reader(browser, f"{address}#task=Boulder&code=true", size, theme)
    if reader("document.querySelector('#tab-code').hidden"):
        pytest.skip("npm does not answer, so there is no editor")
    until(lambda: reader(f"{FIELD}.text"), "the program")
    loaded = "performance.getEntriesByType('resource').some(entry => /codemirror/.test(entry.name))"
    assert not reader(loaded)
    reader("(e => { e.focus(); e.setSelectionRange(0, 0) })(document.querySelector('#source'))")
    press("#", Keys.ENTER)
    until(lambda: reader("document.activeElement.className") == "cm-content", "CodeMirror")
    press("x", Keys.ENTER, Keys.TAB, "y")
    assert reader(f"{FIELD}.text").startswith("#\nx\n    yclass MyAgent")
    for _ in range(9):
        ActionChains(browser).key_down(Keys.CONTROL).send_keys("z").key_up(Keys.CONTROL).perform()
    assert reader(f"{FIELD}.text").startswith("class MyAgent")
    assert not faults(browser, axe)
    press(Keys.TAB)
    assert reader("document.activeElement.className") == "cm-content"
    press(Keys.ESCAPE, Keys.TAB)
    assert reader("document.activeElement.className") != "cm-content"
    reader.check()


@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_a_reader_runs_the_packages_agents(race: Any, address: str, browser: Any) -> None:
    """From their own files, in every task; Python is loaded by the run, and the curve is that of the kernel."""
    reader = Reader(browser, f"{address}#task={race.environment}&code=true&steps=10000&several=1")
    if reader("document.querySelector('#tab-code').hidden"):
        pytest.skip("npm does not answer, so there is no editor")
    until(lambda: reader(f"{FIELD}.text"), "the program")
    reader("(e => { e.selectedIndex = 1; e.onchange() })(document.querySelector('#template'))")
    until(lambda: "create(mdp" in reader(f"{FIELD}.text"), "the agent's file")
    said = ran(reader)
    assert "your agent has" in said
    assert "something else than Python" not in reader.text("#code-said")
    lines = "[...document.querySelectorAll('#code-chart polyline')].map(line => line.getAttribute('points'))"
    until(lambda: len(set(reader(lines))) == 1 and "," in reader(lines)[0], "one curve on the other")
    reader.check()


def test_a_packages_agent_says_which_defaults_do_not_count(address: str, browser: Any) -> None:
    """The line that makes it is far below its class."""
    reader = Reader(browser, f"{address}#task=Roadrunner&code=true")
    if reader("document.querySelector('#tab-code').hidden"):
        pytest.skip("npm does not answer, so there is no editor")
    reader("(s => { s.selectedIndex = 2; s.onchange() })(document.querySelector('#template'))")
    until(lambda: "learning_rate: LearningRate = 0.1  # the last line sets it" in reader(f"{FIELD}.text"), "SARSA")
