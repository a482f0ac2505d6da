"""The playground in a real browser, as a reader would use it: bet, run, play, pass the link on."""

import itertools
import json
import re
import time
from collections.abc import Iterator
from typing import Any

import playground
import pytest
from races import BOULDER, RACES

from tests.course.lab.browser import IN_A_BROWSER, chromium, faults, until
from tests.site.reader import PHONE, WIDE, Reader

pytestmark = IN_A_BROWSER


def at(selector: str) -> str:
    """The place on the screen of what is selected, as an expression."""
    return f"document.querySelector('{selector}').getBoundingClientRect()"


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("size", [WIDE, PHONE], ids=["wide", "phone"])
@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_a_race_is_run_to_its_end(
    race: Any, size: tuple[int, int], theme: str, address: str, browser: Any, axe: str
) -> None:
    """A reader bets and runs; a verdict follows; the picture has been drawn on. Nothing has a fault, also in folds."""
    reader = Reader(browser, f"{address}#task={race.environment}", size, theme)
    assert reader("document.documentElement.dataset.theme") == theme
    assert reader.text("#question") == race.question
    reader.click(".bet")
    assert reader("document.querySelector('.bet').getAttribute('aria-pressed')") == "true"
    verdict = reader.race()
    assert "did best" in verdict or "equally" in verdict or "Nobody" in verdict or "All play" in verdict
    assert "bet" in verdict or "Nobody" in verdict or "All play" in verdict
    top, bottom = reader(f"(({{ top, bottom }}) => [top, bottom])({at('#verdict')})")
    assert 0 <= top < bottom < size[1] + 1  # what came of it is read without scrolling
    assert size == WIDE or 0 < reader(f"{at('#run')}.top - {at('article:last-child .bet')}.bottom") < 60  # for a finger
    until(lambda: reader("[...document.querySelectorAll('canvas')].every(c => c.dataset.cells > 0)"), "colours")
    reader.check()
    assert reader("window.shift") < 0.003  # opened and raced once: nothing moves
    reader.photograph(f"{race.environment}-{size[0]}-{theme}")
    reader("document.querySelectorAll('details').forEach(fold => { fold.open = true })")
    assert not faults(browser, axe)


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
    reader.see_drawn()
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
    until(lambda: "The link holds" in other.text("#verdict"), "whose results these are")
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


def test_other_luck_is_other_luck(address: str, browser: Any) -> None:
    """Also where a race has as many seeds as the page can run at once: none of them comes twice in a row."""
    reader = Reader(browser, f"{address}#task=Casino&several=20")
    numbers = []
    for _ in range(2):
        reader.race()
        numbers.append(reader("[...document.querySelectorAll('.numbers')].map(shown => shown.innerText)"))
        reader.click("#again")
        until(lambda: not reader("document.querySelector('.bet').disabled"), "another race")
    assert numbers[0] != numbers[1]


@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_a_person_plays(race: Any, address: str, browser: Any, axe: str) -> None:
    """With keys and by clicks, to the end of a game; blind, without the picture; R begins anew. Nothing has a fault."""
    from selenium.webdriver.common.keys import Keys

    reader = Reader(browser, f"{address}#task={race.environment}&play=true")
    until(lambda: reader("document.querySelectorAll('#actions button').length"), "the actions")
    body = browser.find_element("tag name", "body")

    def over() -> bool:
        return bool(reader("[...document.querySelectorAll('#actions button')].every(button => button.disabled)"))

    body.send_keys("1")
    assert re.search(r"Step 1\b", reader.text("#score"))
    reader.click("#actions button:last-child")
    for _ in range(1500):
        if over():
            break
        body.send_keys("212" if race.environment == "Boulder" else "2")
    assert over()
    assert "your games" in reader.text("#record")
    body.send_keys("r")
    assert re.search(r"Step 0\b", reader.text("#score"))
    reader.click("#tab-race")
    reader.click("#tab-play")
    assert "your games" in reader.text("#record")  # as it was left
    reader.click("#blind")
    assert reader("document.querySelector('#board').classList.contains('unseen')")
    assert reader.text("#seen").startswith(("The agent sees: ", "In numbers: "))
    assert all(name in reader.text("#seen") for name in race.numbers)
    body.send_keys(Keys.TAB)
    assert not faults(browser, axe)
    reader.check()


@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_a_finger_plays(race: Any, address: str, browser: Any) -> None:
    """Each action is large enough for a finger, and fits the screen with the board; quick taps are steps, not zooms."""
    reader = Reader(browser, f"{address}#task={race.environment}&play=true", PHONE)
    until(lambda: reader("document.querySelectorAll('#actions button').length"), "the actions")
    shown = "[...document.querySelectorAll('#actions button')].filter(button => !button.hidden)"
    corners = "(({ left, top, right, bottom }) => [left, top, right, bottom])"
    reader("document.querySelector('#board').scrollIntoView()")
    left, top, right, bottom = reader(f"{corners}({shown}[0].getBoundingClientRect())")
    assert right - left >= 24
    assert bottom - top >= 24
    assert bottom <= PHONE[1]
    tap = {"touchPoints": [{"x": (left + right) / 2, "y": (top + bottom) / 2}]}
    for _ in range(2):
        browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchStart", **tap})
        browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    until(lambda: re.search(r"Step 2\b", reader.text("#score")) or "It is over" in reader.text("#score"), "two steps")
    assert reader("visualViewport.scale") == 1
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


def test_a_climber_reads_whether_a_grip_holds(address: str, browser: Any) -> None:
    """No points come before the top, so they do not say it."""
    reader = Reader(browser, f"{address}#task=Boulder")
    reader.click("#tab-play")
    until(lambda: reader("document.querySelectorAll('#actions button').length"), "the actions")
    assert reader(f"{at('#play')}.top") >= 0
    assert reader(f"{at('#score')}.bottom") <= WIDE[1]  # picture, actions and points on one screen
    heights, said = [0], []
    for key in "1212121212":
        browser.find_element("tag name", "body").send_keys(key)
        heights.append(int(re.findall(r"position (\d+)", reader.text("#seen"))[0]))
        said.append("it holds" in reader.text("#score"))
        assert said[-1] != ("does not hold" in reader.text("#score"))
    assert said == [after > before for before, after in itertools.pairwise(heights)]
    assert set(said) == {True, False}


def test_a_door_has_its_number_as_its_key(address: str, browser: Any) -> None:
    """Doors count from 0, as in the lesson."""
    reader = Reader(browser, f"{address}#task=MemoryCorridor&play=true")
    until(lambda: reader("document.querySelectorAll('#actions button').length"), "the actions")
    browser.find_element("tag name", "body").send_keys("0")
    assert reader.text("#score").startswith("door 0:")


@pytest.mark.parametrize(
    ("ending", "place", "says"),
    [("", "#legend", "say what it would do"), ("&code=true", "#code-legend", "too small here")],
)
def test_signs_are_explained_where_they_are_drawn(
    ending: str, place: str, says: str, address: str, browser: Any
) -> None:
    """On a long road they are smaller; in the small pictures beside the code its cells have no room for them."""
    reader = Reader(browser, f"{address}#task=Roadrunner&strength=5{ending}")
    until(lambda: says in reader.text(place), "what the signs mean")


def test_a_race_begins_as_fast_as_it_can_be_watched(address: str, browser: Any) -> None:
    """It lasts 50 seconds, however many steps it has; a link holds no speed before the reader has set one."""
    reader = Reader(browser, f"{address}#task=Casino")
    assert reader.text("#speed-shown") == "2 steps a second"
    reader = Reader(browser, f"{address}#task=Boulder")
    assert reader.text("#speed-shown") == "400 steps a second"
    assert "speed" not in reader("location.hash")
    reader.click("#run")
    until(
        lambda: reader("document.querySelector('#lanes article:last-child .numbers').innerText").startswith("points 1"),
        "learning",
        15,
    )
    reader.move("speed", 0)
    assert reader.text("#speed-shown") == "1 steps a second"
    assert "speed=0" in reader("location.hash")
    assert "minutes" in reader.text("#verdict")


@pytest.fixture(scope="module")
def traced() -> Iterator[Any]:
    """A browser that notes how long each of its tasks takes."""
    with chromium(traced=True) as driver:
        yield driver


def longest_task(driver: Any) -> float:
    """Of all that pages did since it was last asked: milliseconds of the processor, so other programs do not count."""
    driver.get("about:blank")  # or the last events are not in the log yet
    messages = [json.loads(entry["message"])["message"] for entry in driver.get_log("performance")]
    events = [message["params"] for message in messages if message["method"] == "Tracing.dataCollected"]
    names = {(one["pid"], one["tid"]): one["args"]["name"] for one in events if one["name"] == "thread_name"}
    pages = [one for one in events if names.get((one["pid"], one["tid"])) == "CrRendererMain"]
    return float(max(one.get("tdur", 0) for one in pages)) / 1000


@pytest.mark.parametrize("task", [race.environment for race in RACES])
def test_the_page_is_free_while_agents_learn(task: str, address: str, traced: Any) -> None:
    """At the speed of the beginning and as fast as it goes, nothing keeps it busy for 50 milliseconds."""
    reader = Reader(traced, f"{address}#task={task}")
    reader("(until => { while (performance.now() < until); })(performance.now() + 2000)")
    assert longest_task(traced) > 50  # one that was long is seen, also where others take the processor
    reader = Reader(traced, f"{address}#task={task}")
    traced.get_log("performance")
    reader.click("#run")
    time.sleep(2)
    reader.move("speed", 9)
    until(lambda: reader.text("#run") == "Run", "the end of the race")
    assert 0 < longest_task(traced) < 50


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
    data = ["data/playground.json", f"data/Boulder-{first['strength']['first']}.json"]
    assert sum(map(size, [*scripts, *data, *kernels])) < 100_000
    page = urllib.request.urlopen(f"{address}index.html").read().decode()
    asked = re.findall(r'href[=:] ?"([\w/-]+\.js(?:on)?)"', page)  # before any script runs
    assert {*asked} >= {
        "page.js",
        "lane.js",
        "power.js",
        *data,
    }  # power.js is imported by kernel.js, and that by play.js
    assert all(map(size, asked))
