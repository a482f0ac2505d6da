"""Somebody who uses the playground in a real browser."""

import os
from pathlib import Path
from typing import Any

from tests.course.lab.browser import until

SCREENSHOTS = os.environ.get("EDUGYM_SCREENSHOTS")
WIDE, PHONE = (1400, 1000), (390, 844)


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

    def see_drawn(self) -> None:
        """Wait for twenty frames: the page draws one thing a frame, and fewer than twenty."""
        self.driver.execute_async_script(
            "const done = arguments[0], wait = left => left ? requestAnimationFrame(() => wait(left - 1)) : done();"
            "wait(20)"
        )

    def race(self) -> str:
        """Run to the end at full speed, and return the verdict."""
        self.move("speed", 9)
        self.driver.find_element("css selector", "#run").click()  # with the mouse: what it moves is no layout shift
        until(lambda: self.text("#run") == "Run", "the end of the race")
        return self.text("#verdict")

    def check(self) -> None:
        """Nothing went wrong: no error, no other host, nothing too wide, nothing that jumped."""
        assert self.driver.get_log("browser") == []
        requests = self("performance.getEntriesByType('resource').map(entry => new URL(entry.name).host)")
        assert set(requests) == {self("location.host")}
        page = "document.documentElement"  # a phone's innerWidth grows with what is too wide
        assert self(f"{page}.scrollWidth <= {page}.clientWidth")
        assert self("[...document.querySelectorAll('article')].every(card => card.scrollWidth <= card.clientWidth)")
        sliders = "[...document.querySelectorAll('input[type=range]')].filter(slider => slider.checkVisibility())"
        assert self(f"{sliders}.every(slider => slider.clientWidth >= 60)")
        assert self("window.shift") < 0.1

    def photograph(self, name: str) -> None:
        """Take a picture of the whole page, of the width that stands in its name, if a folder for pictures is given."""
        if not SCREENSHOTS:
            return
        folder = Path(SCREENSHOTS)
        folder.mkdir(parents=True, exist_ok=True)
        height = self("document.documentElement.scrollHeight")
        screen = {"width": int(name.split("-")[1]), "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
        self.see_drawn()
        self.driver.save_screenshot(str(folder / f"{name}.png"))
