"""The playground in a real browser, as a reader would use it: bet, run, change, play, pass the link on."""

import importlib.util
import json
import os
import random
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import playground
import pytest
from races import BOULDER, RACES

from tests.course.lab.browser import CHROMIUM, DRIVER, chromium, until
from tests.site.serving import served

SCREENSHOTS = os.environ.get("EDUGYM_SCREENSHOTS")
WIDE, PHONE = (1400, 1000), (390, 844)
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        not (CHROMIUM and DRIVER and importlib.util.find_spec("selenium")),
        reason="needs Chromium, chromedriver and Selenium; CONTRIBUTING.md says how to install them",
    ),
]

WATCH = """
    window.shift = 0
    const add = entry => { if (!entry.hadRecentInput) window.shift += entry.value }
    const watch = new PerformanceObserver(list => list.getEntries().forEach(add))
    watch.observe({ type: 'layout-shift', buffered: true })
"""


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The whole playground, with the kernels that `make site` has left."""
    folder = tmp_path_factory.mktemp("playground")
    if (playground.BUILT / "kernels").exists():
        shutil.copytree(playground.BUILT / "kernels", folder / "kernels")
    playground.build(folder)
    with served(folder) as address:
        yield address


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    """A browser, which finds no other host."""
    with chromium() as driver:
        driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WATCH})
        yield driver


class Reader:
    """Somebody who uses the page."""

    def __init__(self, driver: Any, address: str, size: tuple[int, int] = WIDE, theme: str = "light") -> None:
        """Open a page."""
        self.driver = driver
        width, height = size
        screen = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": size == PHONE}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
        feature = {"name": "prefers-color-scheme", "value": theme}
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})
        driver.get("about:blank")  # so that a hash alone opens the page anew
        driver.get(address)
        until(lambda: self("document.documentElement.dataset.ready"), "the page")

    def __call__(self, expression: str, *arguments: Any) -> Any:
        """The value of an expression in JavaScript."""
        return self.driver.execute_script(f"return {expression}", *arguments)

    def click(self, selector: str) -> None:
        """Click on the first element that is selected."""
        self("document.querySelector(arguments[0]).click()", selector)

    def move(self, slider: str, value: float) -> None:
        """Move a slider."""
        moved = "(e => { e.value = arguments[1]; e.dispatchEvent(new Event('input')) })"
        self(f"{moved}(document.getElementById(arguments[0]))", slider, value)

    def text(self, selector: str) -> str:
        """What is written there."""
        return str(self("document.querySelector(arguments[0]).innerText", selector))

    def race(self) -> str:
        """Run to the end at full speed, and return the verdict."""
        self.move("speed", 9)
        self.click("#run")
        until(lambda: self.text("#run") == "Run", "the end of the race")
        return self.text("#verdict")

    def check(self) -> None:
        """Nothing went wrong: no error, no other host, nothing too wide, nothing that jumped."""
        assert self.driver.get_log("browser") == []
        requests = self("performance.getEntriesByType('resource').map(entry => new URL(entry.name).host)")
        assert set(requests) == {self("location.host")}
        assert self("document.documentElement.scrollWidth <= innerWidth")
        assert self("window.shift") < 0.1


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("size", [WIDE, PHONE], ids=["wide", "phone"])
@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_a_race_is_run_to_its_end(race: Any, size: tuple[int, int], theme: str, address: str, browser: Any) -> None:
    """A reader bets and runs; a verdict follows; the picture has been drawn on."""
    reader = Reader(browser, f"{address}#task={race.environment}", size, theme)
    assert reader("document.documentElement.dataset.theme") == theme
    assert reader.text("#question") == race.question
    reader.click(".bet")
    assert reader("document.querySelector('.bet').getAttribute('aria-pressed')") == "true"
    verdict = reader.race()
    assert "did best" in verdict or "equally" in verdict or "Nobody" in verdict or "All play" in verdict
    assert "bet" in verdict or "Nobody" in verdict or "All play" in verdict
    until(lambda: reader("[...document.querySelectorAll('canvas')].every(c => c.dataset.cells > 0)"), "colours")
    reader.check()
    if SCREENSHOTS:
        _photograph(reader, f"{race.environment}-{size[0]}-{theme}")


def _photograph(reader: Reader, name: str) -> None:
    folder = Path(str(SCREENSHOTS))
    folder.mkdir(parents=True, exist_ok=True)
    height = reader("document.documentElement.scrollHeight")
    screen = {"width": int(name.split("-")[1]), "height": height, "deviceScaleFactor": 1, "mobile": False}
    reader.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
    frame = "requestAnimationFrame"  # a resized page draws its pictures again in some of the next ones
    reader.driver.execute_async_script(f"{frame}(() => {frame}(() => setTimeout(arguments[0], 300)))")
    reader.driver.save_screenshot(str(folder / f"{name}.png"))


def test_a_link_holds_what_was_seen(address: str, browser: Any) -> None:
    """Task, strength, agents and settings; the results on request, and never the bet: another reader has her own."""
    reader = Reader(browser, f"{address}#task=Golf")
    reader.move("strength", 4)
    until(lambda: reader.text("#strength-shown") == "0.03", "the other strength")
    reader("(s => { s.selectedIndex = 4; s.onchange() })(document.querySelectorAll('#lanes select')[2])")
    until(lambda: "agents=0.1.4" in reader("location.hash"), "the other agent")
    reader.move("discount", 0.9)
    reader.click(".bet")
    reader.race()
    settings = reader("location.href")
    assert "at=" not in settings
    numbers = reader("[...document.querySelectorAll('.numbers')].map(e => e.innerText)")
    curves = reader("document.querySelector('#chart').innerHTML")
    reader("(navigator.clipboard.writeText = text => { window.copied = text })")
    reader.click("#with-results")
    reader.click("#share")
    until(lambda: reader("window.copied"), "the link")
    until(lambda: "Copied" in reader.text("#shared"), "what was done")
    reader.click("#with-results")
    assert reader.text("#shared") == ""
    other = Reader(browser, reader("window.copied"))
    until(lambda: other("[...document.querySelectorAll('.numbers')].map(e => e.innerText)") == numbers, "the numbers")
    until(lambda: other("document.querySelector('#chart').innerHTML") == curves, "the curves")
    until(lambda: "sender" in other.text("#verdict"), "whose results these are")
    unbet = "[...document.querySelectorAll('.bet')].every(bet => bet.disabled && bet.ariaPressed === 'false')"
    assert other(unbet)
    other.click("#again")
    until(lambda: "at=" not in other("location.hash"), "a race of her own")
    assert not other("document.querySelector('.bet').disabled")
    other.check()
    fresh = Reader(browser, settings)
    assert fresh.text("#strength-shown") == "0.03"
    until(lambda: "before training" in fresh.text(".numbers"), "what an agent earns before training")


def test_the_first_link_of_the_page_moves_only_the_focus(address: str, browser: Any) -> None:
    """It must not change the address, which holds the settings."""
    from selenium.webdriver import ActionChains, Keys

    reader = Reader(browser, f"{address}#task=Roadrunner&discount=0.9")
    before = reader("location.hash")
    ActionChains(browser).send_keys(Keys.TAB, Keys.ENTER).perform()
    assert reader("document.activeElement.id") == "question"
    assert reader("location.hash") == before


@pytest.mark.parametrize(
    "ending",
    ["#task=Nowhere", "#agents=7.8.9&steps=12.5&bet=9&at=-1.2&several=3&strength=3", "#epsilon=two&%&=&show=x"],
)
def test_a_broken_link_opens_what_can_be_opened(ending: str, address: str, browser: Any) -> None:
    """What it says that cannot be is left out."""
    reader = Reader(browser, f"{address}{ending}")
    assert reader.text("#question") == BOULDER.question
    assert "in the last tenth" in reader.race()
    reader.check()


def test_several_seeds_have_a_band(address: str, browser: Any) -> None:
    """Mean and interval are drawn, and the verdict speaks of no luck."""
    reader = Reader(browser, f"{address}#task=Boulder&several=5")
    assert "luck" not in reader.race()
    assert reader("document.querySelectorAll('#chart polygon').length") == 3
    assert "5 seeds" in reader.text("#caption")
    assert "5 seeds" in reader.text("#legend")


@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_a_person_plays(race: Any, address: str, browser: Any) -> None:
    """With keys and by clicks, to the end of a game; blind, the picture is hidden; and R begins anew."""
    from selenium.webdriver.common.keys import Keys

    reader = Reader(browser, f"{address}#task={race.environment}&play=true")
    until(lambda: reader("document.querySelectorAll('#actions button').length"), "the actions")
    body = browser.find_element("tag name", "body")

    def over() -> bool:
        return bool(reader("[...document.querySelectorAll('#actions button')].every(button => button.disabled)"))

    body.send_keys("1")
    assert "Step 1," in reader.text("#score")
    reader.click("#actions button:last-child")
    for _ in range(1500):
        if over():
            break
        body.send_keys("212" if race.environment == "Boulder" else "2")
    assert over()
    assert "your games" in reader.text("#record")
    body.send_keys("r")
    assert "Step 0," in reader.text("#score")
    reader.click("#blind")
    assert reader("document.querySelector('#board').classList.contains('unseen')")
    assert reader.text("#seen").startswith(("The agent sees: ", "In numbers: "))
    assert all(name in reader.text("#seen") for name in race.numbers)
    body.send_keys(Keys.TAB)
    reader.check()


def test_arrow_keys_play_once_the_tab_is_open(address: str, browser: Any) -> None:
    """They do not turn to the next tab; and what cannot be sent from there is not offered."""
    from selenium.webdriver import ActionChains, Keys

    reader = Reader(browser, f"{address}#task=Roadrunner")
    browser.find_element("id", "tab-play").click()
    until(lambda: reader("document.activeElement.id") == "play", "the game")
    ActionChains(browser).send_keys(Keys.ARROW_RIGHT).perform()
    assert reader.text("#score").startswith("faster")
    ActionChains(browser).send_keys("1").perform()
    assert reader.text("#score").startswith("slower")
    assert reader("document.querySelector('#with-results').offsetParent === null")
    reader.check()


def test_a_door_has_its_number_as_its_key(address: str, browser: Any) -> None:
    """Doors count from 0, as in the lesson."""
    reader = Reader(browser, f"{address}#task=MemoryCorridor&play=true")
    until(lambda: reader("document.querySelectorAll('#actions button').length"), "the actions")
    browser.find_element("tag name", "body").send_keys("0")
    assert reader.text("#score").startswith("door 0:")


def test_a_packages_agent_says_which_defaults_do_not_count(address: str, browser: Any) -> None:
    """The line that makes it is far below its class."""
    reader = Reader(browser, f"{address}#task=Roadrunner&code=true")
    if reader("document.querySelector('#tab-code').hidden"):
        pytest.skip("npm does not answer, so there is no editor")
    reader("(s => { s.selectedIndex = 2; s.onchange() })(document.querySelector('#template'))")
    until(lambda: "learning_rate: LearningRate = 0.1  # the last line sets it" in reader(f"{FIELD}.text"), "SARSA")


@pytest.mark.parametrize(("strength", "says"), [(2, "say what it would do"), (5, "too small here")])
def test_signs_are_explained_where_they_are_drawn(strength: int, says: str, address: str, browser: Any) -> None:
    """On a long road the cells have no room for them."""
    reader = Reader(browser, f"{address}#task=Roadrunner&strength={strength}")
    assert says in reader.text("#legend")


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
    if SCREENSHOTS:
        _photograph(reader, f"code-{size[0]}")
    change(reader, "target - self", "target - sef")
    assert ran(reader).startswith("Line 17. NameError")
    assert reader.text(".cm-gutterElement.wrong") == "17"
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
    browser.execute_script(axe)
    found = browser.execute_async_script("axe.run().then(arguments[0])")
    assert not [(fault["id"], [node["html"] for node in fault["nodes"]]) for fault in found["violations"]]
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


def test_the_first_race_is_small(address: str) -> None:
    """All that the first race needs, compressed as a server does, is below 100 kB."""
    import gzip
    import urllib.request

    def size(path: str) -> int:
        with urllib.request.urlopen(address + path) as answer:
            return len(gzip.compress(answer.read()))

    menu = json.loads(urllib.request.urlopen(f"{address}data/playground.json").read())
    first = next(race for race in menu["races"] if race["name"] == BOULDER.environment)
    kernels = [f"kernels/{agent['kernel']}.wasm" for agent in first["agents"][:3]]
    scripts = [file.name for file in playground.PAGE.iterdir()]
    needed = [*scripts, "data/playground.json", f"data/Boulder-{first['strength']['first']}.json", *kernels]
    assert sum(map(size, needed)) < 100_000
