"""JupyterLab in a headless Chromium, as a student sees it."""

import importlib.util
import json
import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import nbformat
import pytest
from nbformat.v4 import new_notebook

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
DRIVER = shutil.which("chromedriver")
needs_browser = pytest.mark.skipif(
    not (CHROMIUM and DRIVER and importlib.util.find_spec("selenium")),
    reason="needs Chromium, chromedriver and Selenium; CONTRIBUTING.md says how to install them",
)
IN_A_BROWSER = [pytest.mark.slow, needs_browser]
"""The marks of tests that need one."""
PANEL = "jupyterapp.shell.currentWidget"
SESSION = f"{PANEL}.sessionContext"
WINDOW = 1400, 1000
"""Width and height in pixels."""
PATIENCE = 120
"""The most seconds to wait for anything but a whole lesson."""
LESSON_SECONDS = 300
"""The most seconds that all cells of a lesson may take; CONTRIBUTING.md says so too."""

FAILED = """cell => cell.cell_type === 'code' && !cell.metadata.tags?.includes('raises-exception')
            && cell.outputs.some(output => output.output_type === 'error')"""
"""What is true of a cell that failed and may not; cells of students may."""
MIDDLE = """element => {
    const {left, right, top, bottom} = element.getBoundingClientRect();
    const middle = [(left + right) / 2, (top + bottom) / 2];
    return element.contains(document.elementFromPoint(...middle)) ? middle : null;
}"""
"""Where the middle of an element lies, or null where the mouse would hit something else there."""


def until(condition: Callable[[], Any], what: str, seconds: float = PATIENCE) -> Any:
    """Wait until a condition holds, and return its value."""
    end = time.monotonic() + seconds
    while not (value := condition()):
        assert time.monotonic() < end, f"waited {seconds} s for {what}"
        time.sleep(0.1)
    return value


class Lab(NamedTuple):
    """A running `edugym lab`: its address, the theme of JupyterLab, and its process."""

    address: str
    theme: str
    process: "subprocess.Popen[bytes]"


@contextmanager
def running_lab(folder: Path, theme: str = "JupyterLab Light", first: str = "") -> Iterator[Lab]:
    """Run `edugym lab` on a free port, without a token, in a folder of its own; kernels run `first` at their start."""
    startup = folder / "ipython" / "profile_default" / "startup" / "first.py"
    startup.parent.mkdir(parents=True)
    startup.write_text(first)
    settings = folder / "settings" / "@jupyterlab" / "apputils-extension" / "themes.jupyterlab-settings"
    settings.parent.mkdir(parents=True)
    settings.write_text(json.dumps({"theme": theme}))
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"http://127.0.0.1:{port}"
    own = {"JUPYTERLAB_SETTINGS_DIR": str(folder / "settings"), "JUPYTER_CONFIG_DIR": str(folder / "configuration")}
    own["IPYTHONDIR"] = str(folder / "ipython")
    options = ["--no-browser", f"--port={port}", "--IdentityProvider.token=", "--ServerApp.ip=127.0.0.1"]
    options += ["--LabApp.expose_app_in_browser=True"]  # so that a test can ask for the outputs of cells
    code = "from edugym_course.cli import main; main()"
    command = [sys.executable, "-c", code, "lab", str(folder / "lessons"), *options]
    with (folder / "log.txt").open("w") as log:
        process = subprocess.Popen(command, stdout=log, stderr=log, env=os.environ | own)
        try:
            until(lambda: process.poll() is not None or _answers(address), "JupyterLab")
            assert process.poll() is None, (folder / "log.txt").read_text()
            yield Lab(address, theme, process)
        finally:
            process.terminate()
            process.wait(PATIENCE)


def _answers(address: str) -> bool:
    try:
        with urllib.request.urlopen(f"{address}/api", timeout=1):
            return True
    except OSError:
        return False


@contextmanager
def chromium(traced: bool = False) -> Iterator[Any]:
    """Start a headless Chromium, and yield Selenium's driver; `traced`, its log "performance" has every task."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = str(CHROMIUM)
    for argument in (
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        "--window-size={},{}".format(*WINDOW),
        "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",  # a lesson needs no other host
    ):
        options.add_argument(argument)
    if traced:
        options.set_capability("goog:loggingPrefs", {"performance": "ALL"})
        logged = {"enableNetwork": False, "enablePage": False, "traceCategories": "toplevel"}
        options.add_experimental_option("perfLoggingPrefs", logged)
    driver = webdriver.Chrome(options=options, service=Service(DRIVER))
    driver.set_script_timeout(LESSON_SECONDS)
    try:
        yield driver
    finally:
        driver.quit()


class Page:
    """A lesson in JupyterLab.

    Attributes:
        driver: Selenium's driver of the browser.
    """

    def __init__(self, driver: Any, lab: Lab, notebook: str) -> None:
        """Open a notebook and wait for its kernel."""
        self.driver = driver
        driver.get(f"{lab.address}/lab/tree/{notebook}?reset")  # without the tabs of the test before
        until(lambda: self(f"window.jupyterapp && {PANEL}?.context?.path === arguments[0]", notebook), "the notebook")
        until(lambda: self(f"{SESSION}.session?.kernel?.status === 'idle'"), "the kernel")

    @classmethod
    def of(cls, driver: Any) -> "Page":
        """The page that a driver shows."""
        page = cls.__new__(cls)
        page.driver = driver
        return page

    def __call__(self, expression: str, *arguments: Any) -> Any:
        """Return the value of an expression in JavaScript; a promise is waited for."""
        return self.driver.execute_script(f"return {expression}", *arguments)

    def command(self, name: str, **arguments: Any) -> None:
        """Run a command of JupyterLab to its end."""
        self("jupyterapp.commands.execute(arguments[0], arguments[1]).then(() => 0)", name, arguments)

    def run_all(self) -> list[dict[str, Any]]:
        """Run all cells, wait until the kernel is idle, and return the cells with their outputs."""
        self("void jupyterapp.commands.execute('notebook:run-all-cells')")  # Selenium waits at most 120 s
        cells = f"{PANEL}.content.model.sharedModel.toJSON().cells"
        has_run = "cell => cell.cell_type !== 'code' || cell.execution_count !== null"
        failed = f"{cells}.filter({FAILED}).map(cell => cell.source + JSON.stringify(cell.outputs))"
        until(lambda: self(f"{cells}.every({has_run})") or self(failed), "all cells", LESSON_SECONDS)
        assert self(failed) == []  # an error in a cell that may not fail keeps all later ones from running
        until(lambda: self(f"{SESSION}.session.kernel.status === 'idle'"), "the kernel")
        return list(self(cells))

    def widgets(self) -> list[Any]:
        """Return the outermost box of each widget of the lessons; a cell is only in the page when it was in sight."""
        boxes = []
        for number in range(self(f"{PANEL}.content.widgets.length")):
            outputs = self(f"{PANEL}.content.model.cells.get({number}).outputs?.toJSON() ?? []")
            if any("application/vnd.jupyter.widget-view+json" in output.get("data", {}) for output in outputs):
                self(f"{PANEL}.content.scrollToItem({number}, 'start').then(() => 0)")
                box = f"{PANEL}.content.widgets[{number}].node.querySelector('.jp-OutputArea .widget-vbox')"
                boxes.append(until(partial(self, box), "a widget"))
        return boxes

    def picture(self, box: Any) -> str:
        """Return the pictures in a box, and the lines below them, as they are in the page."""
        found = "[...arguments[0].querySelectorAll('.widget-html .widget-html-content')]"
        return str(self(f"{found}.map(shown => shown.innerHTML).join()", box))

    def text(self, box: Any) -> str:
        """Return the text in a box."""
        return str(self("arguments[0].innerText", box))

    def errors(self, box: Any) -> list[str]:
        """Return the errors and warnings that callbacks left in a box."""
        found = "[...arguments[0].querySelectorAll('[data-mime-type$=stderr], [data-mime-type$=error]')]"
        return list(self(f"{found}.map(message => message.innerText)", box))

    def reach(self, element: Any) -> None:
        """Scroll to an element, and wait until it stands still where the mouse hits it: cells above may still grow."""
        places: list[Any] = []

        def stands_still() -> bool:
            places.append(self(f"({MIDDLE})(arguments[0])", element))
            if places[-1] is None:
                self("arguments[0].scrollIntoView({block: 'center'})", element)
            return places[-1] is not None and places[-3:] == 3 * places[-1:]

        self("arguments[0].scrollIntoView({block: 'center'})", element)
        until(stands_still, "an element that the mouse can reach", 30)

    def press(self, button: Any) -> None:
        """Click on a button with the mouse, again if another cell moved under the mouse at that moment."""
        from selenium.common.exceptions import ElementClickInterceptedException

        def hit() -> bool:
            self.reach(button)
            with suppress(ElementClickInterceptedException):
                button.click()
                return True
            return False

        until(hit, "a button that the mouse can hit", 30)

    def drag(self, handle: Any, end: str) -> None:
        """Move the handle of a slider to the left or right end, and release it."""
        from selenium.webdriver import ActionChains

        self.reach(handle)
        track = "arguments[0].closest('.noUi-base').getBoundingClientRect()"
        handle_box = "arguments[0].getBoundingClientRect()"
        pixels = self(f"{track}.{end} - ({handle_box}.left + {handle_box}.right) / 2", handle)
        ActionChains(self.driver, duration=20).drag_and_drop_by_offset(handle, round(pixels), 0).perform()


@contextmanager
def open_notebook(
    folder: Path, cells: list[Any], width: int, height: int, theme: str = "JupyterLab Light"
) -> Iterator[Page]:
    """Run the cells of a new notebook to its end, on a screen of this size, and yield its page with all widgets."""
    metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    with running_lab(folder, theme) as lab, chromium() as driver:
        nbformat.write(new_notebook(cells=cells, metadata=metadata), folder / "lessons" / "all.ipynb")
        screen = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
        page = Page(driver, lab, "all.ipynb")
        if page("jupyterapp.shell.leftCollapsed === false"):
            page.command("application:toggle-left-area")
        page.run_all()
        page.widgets()
        yield page


def faults(driver: Any, axe: str, where: str = "{ exclude: ['iframe'] }") -> list[tuple[str, list[str]]]:
    """What breaks axe's rules, WCAG AA among them: by default on the open page, without those within it."""
    driver.execute_script(axe)
    found = driver.execute_async_script(f"axe.run({where}).then(arguments[0])")
    return [(fault["id"], [node["html"] for node in fault["nodes"]]) for fault in found["violations"]]


def screenshots(page: Page, folder: Path, name: str) -> None:
    """Save pictures of a whole lesson, at two widths: `name-1400-00.png`, ..."""
    folder.mkdir(parents=True, exist_ok=True)
    page.command("application:toggle-left-area") if page("jupyterapp.shell.leftCollapsed === false") else None
    view = f"{PANEL}.content.node.querySelector('.jp-WindowedPanel-outer')"
    for width in (1400, 390):  # a window itself is never narrower than 500
        screen = {"width": width, "height": 1700, "deviceScaleFactor": 1, "mobile": False}
        page.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
        page(f"{view}.scrollTo(0, 0)")
        for number in range(100):
            time.sleep(1)
            page.driver.save_screenshot(str(folder / f"{name}-{width}-{number:02}.png"))
            if page(f"{view}.scrollTop + {view}.clientHeight > {view}.scrollHeight - 5"):
                break
            page(f"{view}.scrollBy(0, {view}.clientHeight - 60)")
    page.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
